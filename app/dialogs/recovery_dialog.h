// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/journal_reader.h"

#include <QDialog>

class QLabel;
class QListWidget;

namespace esm {

/// What can be recovered, with picture, time and number of steps, and what shall become of it.
class RecoveryDialog : public QDialog {
  Q_OBJECT
public:
  enum Answer { Later, Recover, Discard };

  explicit RecoveryDialog(const std::vector<FoundJournal>& found, QWidget* parent = nullptr);

  Answer answer() const noexcept { return m_answer; }
  int chosen() const; ///< place in what was found

private:
  void addRow(const FoundJournal& journal);
  void end(Answer answer);

  QListWidget* m_list;
  Answer m_answer = Later;
};

QString journalName(const FoundJournal& journal);
/// "3 steps after the last save", "3 steps, never saved".
QString stepsText(int steps, bool neverSaved, bool hasDraft);

} // namespace esm
