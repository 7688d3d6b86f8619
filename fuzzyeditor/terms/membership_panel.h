// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QBoxLayout;
class QCheckBox;
class QComboBox;
class QToolButton;

namespace esm {

class FuzzyEvaluation;
class MistakeBar;
class TermEdits;
class TermFields;
class TermPlot;

/// The editor of the terms: the choice of the variable, whether neighbours follow, the plot to drag in, the
/// chosen term in fields. Fields stand below the plot, beside it where the panel is wide.
class MembershipPanel : public QWidget {
  Q_OBJECT
public:
  /// @param evaluation not owned, outlives this.
  explicit MembershipPanel(FuzzyEvaluation* evaluation, QWidget* parent = nullptr);

  void showInput(int input);                      ///< connect to InputsPanel::inputFocused
  void showVariable(bool isOutput, int variable); ///< connect to RulesPanel::variableRequested
  TermPlot* plot() const { return m_plot; }
  TermEdits* edits() const { return m_edits; }

protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

private:
  void retranslate();
  void fillChoice();
  void refresh();
  void askForSpread();

  FuzzyEvaluation* m_evaluation;
  TermEdits* m_edits;
  QComboBox* m_choice;
  QCheckBox* m_lock;
  QToolButton* m_spread;
  TermPlot* m_plot;
  TermFields* m_fields;
  MistakeBar* m_message;
  QBoxLayout* m_body;
};

} // namespace esm
