// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/project/journal.h"
#include "core/project/journal_file.h"

#include <optional>

namespace esm {

/// What a process left behind that ended without saving. Holds the folder's lock: nobody else offers it.
struct FoundJournal {
  std::filesystem::path folder;
  JournalLock lock;
  std::string name;      ///< of the project
  std::string path;      ///< of its file; empty: never saved
  std::int64_t time = 0; ///< of the last line [s since 1970]
  int steps = 0;         ///< after the last save
  bool hasDraft = false; ///< a rule was being written
  bool postponed = false;
  std::optional<Error> fault; ///< it cannot be read; nothing of the above then
};

/// Everything under `parent` that no living process holds, newest first. Clears away what holds nothing.
std::vector<FoundJournal> findJournals(const std::filesystem::path& parent);

/// The document after one of the steps.
struct RecoveredState {
  Project project;                      ///< without its net
  std::shared_ptr<const SpringNet> net; ///< states share what they have in common
  bool netDerived = false;              ///< its parameters are what the tissue gives, and are not in `net`
  std::string copy;                     ///< nets of one copy differ at most in what is held
  std::string text;                     ///< of the step that leads here; empty for the first one
  int model = 0;                        ///< number of the organ
  bool netStays = false; ///< that step has left the net, what is held, loads and solver as they were
};

/// What can be undone and redone of recovered work.
struct RecoveredHistory {
  std::vector<RecoveredState> states; ///< empty: the journal does not tell
  int first = 0;                      ///< JournalState::undoIndex of the first of them
  int present = 0;                    ///< the one that holds
  std::optional<int> saved;           ///< the one that the file has, or that the work began from
};

/// The document as it was.
struct RecoveredWork {
  Project project;
  std::string path;         ///< of its file; empty: never saved
  bool fileChanged = false; ///< since, or it is gone: it must not be written over
  bool netDerived = false;
  std::string copy;  ///< the file in the folder that has the net
  int model = 0;     ///< number of the organ
  int fileModel = 0; ///< of that in the saved file
  int steps = 0;
  RuleDraft draft;
  bool isCutShort = false;  ///< later lines are damaged
  std::uint64_t length = 0; ///< of the lines that were read [byte]
  RecoveredHistory history;
};

/// Errors: BadFormat, NewerVersion, FileUnreadable; the detail names the folder.
Result<RecoveredWork> readJournal(const FoundJournal& found);

void discardJournal(FoundJournal& found);
void postponeJournal(const FoundJournal& found); ///< not to be asked about by itself again
/// Out of the way of later starts, kept as it is. @return where it is now.
std::filesystem::path setJournalAside(FoundJournal& found);

} // namespace esm
