// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fuzzyeditor/fuzzy_document.h"
#include "tests/fuzzyeditor/qt_printers.h"

#include <QUndoStack>

namespace esm::test {

/// A FuzzyDocument as the application makes it, reduced to three commands and a stack.
class FakeFuzzyDocument : public FuzzyDocument {
  Q_OBJECT
public:
  FakeFuzzyDocument();

  const fuzzy::RuleBase& ruleBase() const override { return m_rules; }
  const std::vector<fuzzy::InputValue>& inputs() const override { return m_inputs; }
  QString inputTargetName() const override { return target; }
  Language ruleLanguage() const override { return m_language; }
  const fuzzy::RuleBase& savedRuleBase() const override { return m_saved; }
  void setRuleBase(fuzzy::RuleBase ruleBase, const QString& undoText, int gesture = 0) override;
  void setInput(int input, fuzzy::InputValue value, int gesture) override;
  void setInputs(std::vector<fuzzy::InputValue> values, const QString& undoText, int gesture = 0) override;

  void setLanguage(Language language);
  void load(fuzzy::RuleBase ruleBase); ///< without undo, inputs at their defaults
  void save();

  QUndoStack undo;
  QString target = QStringLiteral("Uterus");

private:
  friend class RuleBaseCommand;
  friend class InputCommand;
  friend class InputsCommand;
  fuzzy::RuleBase m_rules, m_saved;
  std::vector<fuzzy::InputValue> m_inputs;
  Language m_language = Language::English;
};

/// Hardness (soft, medium, hard, umlaut in its German name) and elasticity; stiffness, logarithmic in Pa, and
/// viscosity in s. Rules: 1 and 2 on, 3 off with a note; nothing speaks about viscosity but rule 3.
fuzzy::RuleBase sampleRules();

} // namespace esm::test
