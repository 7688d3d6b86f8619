// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document_command.h"
#include "core/project/journal_reader.h"

#include <map>

namespace esm {

/// The states between which recovered steps lead, shared by their commands.
struct RecoveredStates {
  std::vector<RecoveredState> states;
  std::map<std::string, std::uint64_t> netNumbers; ///< of each copy, see Document::netNumber()
  bool isQuiet = true; ///< while the stack is filled: the document is in its present state already
};

/// A step that another process has done and a journal has kept: leads from one state to the next.
class RecoveredStepCommand : public DocumentCommand {
public:
  /// @param to place of the state that it leads to, at least 1
  RecoveredStepCommand(Document& document, std::shared_ptr<const RecoveredStates> all, std::size_t to);
  void redo() override { put(m_to - 1, m_to); }
  void undo() override { put(m_to, m_to - 1); }

private:
  void put(std::size_t from, std::size_t to);

  std::shared_ptr<const RecoveredStates> m_all;
  std::size_t m_to;
};

} // namespace esm
