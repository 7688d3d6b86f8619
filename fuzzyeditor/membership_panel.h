// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QComboBox;

namespace esm {

class FuzzyEvaluation;
class MembershipPlot;

/// A MembershipPlot with the choice of the variable above it.
class MembershipPanel : public QWidget {
  Q_OBJECT
public:
  /// @param evaluation not owned, outlives this.
  explicit MembershipPanel(FuzzyEvaluation* evaluation, QWidget* parent = nullptr);

  void showInput(int input); ///< connect to InputsPanel::inputFocused
  MembershipPlot* plot() const { return m_plot; }

protected:
  void changeEvent(QEvent* event) override;

private:
  void fillChoice();

  FuzzyEvaluation* m_evaluation;
  QComboBox* m_choice;
  MembershipPlot* m_plot;
};

} // namespace esm
