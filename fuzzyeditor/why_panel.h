// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/fuzzy/inference.h"

#include <QWidget>

#include <optional>

class QLabel;
class QTreeWidget;

namespace esm {

class FuzzyEvaluation;

/// "Why is it stiff?": one sentence per output with the rule that speaks loudest, then all rules that fired,
/// the strongest first. Shows the current inputs' inference, or that of a place (a node picked in the
/// preview).
class WhyPanel : public QWidget {
  Q_OBJECT
public:
  /// @param evaluation not owned, outlives this.
  explicit WhyPanel(FuzzyEvaluation* evaluation, QWidget* parent = nullptr);

  /// @param place what the inference is of, translated ("Node 812, region Wall"); shown as heading.
  /// @pre it was made by the document's present rules; it is dropped when those change.
  void showInference(const QString& place, fuzzy::Inference inference);
  void showCurrentInputs();

signals:
  void ruleActivated(int rule); ///< double click or Return, connect to RulesPanel::showRule

protected:
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;

private:
  void refresh();
  void fillRules(const fuzzy::Inference& inference);
  QString sentence(const fuzzy::Inference& inference, int output) const;

  FuzzyEvaluation* m_evaluation;
  QLabel* m_place;
  QLabel* m_sentences;
  QTreeWidget* m_rules;
  QLabel* m_silent;
  QString m_placeName;
  std::optional<fuzzy::Inference> m_ofPlace;
};

} // namespace esm
