// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzzyeditor/fake_fuzzy_document.h"

#include <limits>

namespace esm::test {

class RuleBaseCommand : public QUndoCommand {
public:
  RuleBaseCommand(FakeFuzzyDocument* document, fuzzy::RuleBase rules, const QString& text, int gesture)
    : QUndoCommand(text),
      m_document(document),
      m_gesture(gesture),
      m_new(std::move(rules)),
      m_old(document->m_rules)
  {}
  int id() const override { return 2; }
  void redo() override { set(m_new); }
  void undo() override { set(m_old); }
  bool mergeWith(const QUndoCommand* next) override
  {
    const auto* other = static_cast<const RuleBaseCommand*>(next);
    if (m_gesture == 0 || other->m_gesture != m_gesture) return false;
    m_new = other->m_new;
    setObsolete(m_new == m_old);
    return true;
  }

private:
  void set(const fuzzy::RuleBase& rules)
  {
    m_document->m_rules = rules;
    emit m_document->ruleBaseChanged();
  }
  FakeFuzzyDocument* m_document;
  int m_gesture;
  fuzzy::RuleBase m_new, m_old;
};

class InputCommand : public QUndoCommand {
public:
  InputCommand(FakeFuzzyDocument* document, int input, fuzzy::InputValue value, int gesture)
    : m_document(document),
      m_input(static_cast<std::size_t>(input)),
      m_gesture(gesture),
      m_new(std::move(value)),
      m_old(document->m_inputs[m_input])
  {}
  int id() const override { return 1; }
  void redo() override { set(m_new); }
  void undo() override { set(m_old); }
  bool mergeWith(const QUndoCommand* next) override
  {
    const auto* other = static_cast<const InputCommand*>(next);
    if (m_gesture == 0 || other->m_gesture != m_gesture || other->m_input != m_input) return false;
    m_new = other->m_new;
    return true;
  }

private:
  void set(const fuzzy::InputValue& value)
  {
    m_document->m_inputs[m_input] = value;
    emit m_document->inputsChanged();
  }
  FakeFuzzyDocument* m_document;
  std::size_t m_input;
  int m_gesture;
  fuzzy::InputValue m_new, m_old;
};

class InputsCommand : public QUndoCommand {
public:
  InputsCommand(FakeFuzzyDocument* document, std::vector<fuzzy::InputValue> values, const QString& text,
                int gesture)
    : QUndoCommand(text),
      m_document(document),
      m_gesture(gesture),
      m_new(std::move(values)),
      m_old(document->m_inputs)
  {}
  int id() const override { return 3; }
  void redo() override { set(m_new); }
  void undo() override { set(m_old); }
  bool mergeWith(const QUndoCommand* next) override
  {
    const auto* other = static_cast<const InputsCommand*>(next);
    if (m_gesture == 0 || other->m_gesture != m_gesture) return false;
    m_new = other->m_new;
    setObsolete(m_new == m_old);
    return true;
  }

private:
  void set(const std::vector<fuzzy::InputValue>& values)
  {
    m_document->m_inputs = values;
    emit m_document->inputsChanged();
  }
  FakeFuzzyDocument* m_document;
  int m_gesture;
  std::vector<fuzzy::InputValue> m_new, m_old;
};

FakeFuzzyDocument::FakeFuzzyDocument()
{
  load(sampleRules());
}

void FakeFuzzyDocument::load(fuzzy::RuleBase ruleBase)
{
  ESM_ASSERT(fuzzy::checkRuleBase(ruleBase));
  m_rules = m_saved = std::move(ruleBase);
  m_inputs.clear();
  for (const fuzzy::Variable& input : m_rules.inputs) m_inputs.emplace_back(input.defaultValue);
  emit ruleBaseChanged();
  emit ruleBaseSaved();
  emit inputsChanged();
}

void FakeFuzzyDocument::save()
{
  m_saved = m_rules;
  undo.setClean();
  emit ruleBaseSaved();
}

void FakeFuzzyDocument::setRuleBase(fuzzy::RuleBase ruleBase, const QString& undoText, int gesture)
{
  ESM_ASSERT(fuzzy::checkRuleBase(ruleBase)); // the contract of FuzzyDocument
  if (ruleBase == m_rules) return;
  undo.push(new RuleBaseCommand(this, std::move(ruleBase), undoText, gesture));
}

void FakeFuzzyDocument::setInput(int input, fuzzy::InputValue value, int gesture)
{
  undo.push(new InputCommand(this, input, std::move(value), gesture));
}

void FakeFuzzyDocument::setInputs(std::vector<fuzzy::InputValue> values, const QString& undoText, int gesture)
{
  ESM_ASSERT(values.size() == m_rules.inputs.size());
  if (values != m_inputs) undo.push(new InputsCommand(this, std::move(values), undoText, gesture));
}

void FakeFuzzyDocument::setLanguage(Language language)
{
  m_language = language;
  emit ruleLanguageChanged();
}

fuzzy::RuleBase sampleRules()
{
  using namespace fuzzy;
  constexpr double inf = std::numeric_limits<double>::infinity();
  RuleBase base;
  base.inputs = {{"hardness",
                  {"hardness", "Härte"},
                  "",
                  0,
                  1,
                  0.5,
                  false,
                  {{"soft", {"soft", "weich"}, Shape::Triangle, {-inf, 0, 0.5}},
                   {"medium", {"medium", "mittel"}, Shape::Triangle, {0, 0.5, 1}},
                   {"hard", {"hard", "hart"}, Shape::Triangle, {0.5, 1, inf}}}},
                 {"elasticity",
                  {"elasticity", "Elastizität"},
                  "",
                  0,
                  1,
                  0.2,
                  false,
                  {{"low", {"low", "gering"}, Shape::Gaussian, {0, 0.25}},
                   {"high", {"high", "groß"}, Shape::Trapezoid, {0.3, 0.7, 1, inf}}}}};
  base.outputs = {{"youngs_modulus",
                   {"stiffness", "Steifigkeit"},
                   "Pa",
                   1e3,
                   1e6,
                   1e4,
                   true,
                   {{"low", {"low", "gering"}, Shape::Triangle, {-inf, 3, 4.5}},
                    {"medium", {"medium", "mittel"}, Shape::Triangle, {3, 4.5, 6}},
                    {"high", {"high", "groß"}, Shape::Triangle, {4.5, 6, inf}}}},
                  {"viscosity",
                   {"viscosity", "Zähigkeit"},
                   "s",
                   0,
                   0.1,
                   0.004,
                   false,
                   {{"low", {"low", "gering"}, Shape::Triangle, {-inf, 0, 0.05}},
                    {"high", {"high", "groß"}, Shape::Triangle, {0.05, 0.1, inf}}}}};
  const auto rule = [&](const char* text, bool enabled, const char* note) {
    Rule parsed = std::get<Rule>(parseRule(text, base));
    parsed.enabled = enabled;
    parsed.note = note;
    base.rules.push_back(parsed);
  };
  rule("IF hardness IS very hard THEN stiffness IS high", true, "palpation");
  rule("IF hardness IS medium AND elasticity IS low THEN stiffness IS medium WITH 0.8", true, "");
  rule("IF elasticity IS high THEN viscosity IS low", false, "not measured yet");
  return base;
}

} // namespace esm::test
