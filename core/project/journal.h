// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/fuzzy/rule_draft.h"
#include "core/project/project.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace esm {

/// Where windows keep what is not saved; empty if there is no state folder.
std::filesystem::path recoveryFolder();

/// A document at one moment, as its journal sees it. Refers to the document; only for the call.
struct JournalState {
  const Project* project = nullptr; ///< not owned
  /// Nets of one number differ at most in what is held fast, and in what the tissue gives them.
  std::uint64_t netNumber = 0;
  bool netDerived = false; ///< applyTissue() would leave the net's parameters as they are
  int model = 0; ///< number of the organ: saving another one than the file holds must be asked about
  std::function<std::shared_ptr<const SpringNet>()> net; ///< project->net to be shared; asked rarely
  int steps = 0;                                         ///< since the last save
  /// Of the undo stack: how many steps are done, out of how many; the names of the last one and the next.
  int undoIndex = 0, undoCount = 0;
  std::string undoText, redoText;
  RuleDraft draft;
  bool isSaved() const noexcept { return steps == 0 && draft.isEmpty(); }
};

struct FoundJournal;
struct RecoveredWork;

/// Keeps what a save does not hold yet, so that a crash loses at most the command under way
/// (docs/FILE_FORMAT.md, "The journal"). A folder comes into being with the first step after a save, and goes
/// with the next. One thread, the window's; nothing here waits for a disk.
class Journal {
public:
  /// @param failed called once for each folder that cannot be written; on a thread of its own.
  Journal(std::filesystem::path parent, std::function<void(const Error&)> failed);
  ~Journal(); ///< the folder stays: who leaves it behind on purpose calls leave() first

  /// The document is now as its file has it (or as it begins, with no path). Forgets what was kept.
  void start(const JournalState& saved, const std::filesystem::path& path);
  void record(const JournalState& now); ///< after every step
  void leave();                         ///< nothing is to be recovered any more
  /// Goes on with what another process left; `now` is what readJournal() gave.
  Status adopt(FoundJournal&& found, const RecoveredWork& work, const JournalState& now);
  void setPicture(std::string png);

  bool isKept() const noexcept; ///< there is a folder now
  /// Whether all has been handed to the kernel, after waiting at most so long.
  bool waitWritten(std::chrono::milliseconds limit);

private:
  struct Impl;
  std::unique_ptr<Impl> m_impl;
};

} // namespace esm
