// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include <string>
#include <vector>

class QGridLayout;
class QLabel;
class QVBoxLayout;

namespace esm {

class BadgeLabel;
class FuzzyEvaluation;
class InputRow;
class PresetBar;

/// The dock "Fuzzy Input": whose tissue it is, presets, one row per input, and what the rules make of them in
/// the units that physicians read, with what a finger can check: how far it goes in under 1 N.
class InputsPanel : public QWidget {
  Q_OBJECT
public:
  /// @param evaluation not owned, outlives this; one for all fuzzy panels of a document.
  explicit InputsPanel(FuzzyEvaluation* evaluation, QWidget* parent = nullptr);

signals:
  void inputFocused(int input); ///< for a plot that follows

protected:
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;

private:
  struct OutputRow {
    QLabel* name;
    QLabel* value;
    BadgeLabel* defaultMark;
  };
  void followRuleBase();
  void rebuildRows();
  void showInputs();
  void showOutputs();
  void showDeflection();
  void retranslate();

  FuzzyEvaluation* m_evaluation;
  QLabel* m_target;
  PresetBar* m_presets;
  QLabel* m_outputsTitle;
  QVBoxLayout* m_inputsLayout;
  QGridLayout* m_outputsLayout;
  std::vector<InputRow*> m_inputs;
  std::vector<OutputRow> m_outputs;
  QLabel *m_deflectionName, *m_deflection; ///< below the outputs
  std::vector<std::string> m_shape;        ///< what the rows were built from: ids, ranges and units
};

} // namespace esm
