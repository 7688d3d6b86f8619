// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/tissue_commands.h"

#include "app/document/command_ids.h"

#include <algorithm>

namespace esm {

namespace {

bool fits(const fuzzy::InputValue& value, const fuzzy::Variable& variable)
{
  const auto* word = std::get_if<fuzzy::Word>(&value);
  return word == nullptr || std::any_of(variable.terms.begin(), variable.terms.end(),
                                        [&](const fuzzy::Term& term) { return term.id == word->term; });
}

std::vector<fuzzy::InputValue> carriedOver(const std::vector<fuzzy::InputValue>& values,
                                           const fuzzy::RuleBase& from, const fuzzy::RuleBase& to)
{
  std::vector<fuzzy::InputValue> result;
  for (const fuzzy::Variable& variable : to.inputs) {
    result.emplace_back(variable.defaultValue);
    for (std::size_t i = 0; i < from.inputs.size() && i < values.size(); ++i)
      if (from.inputs[i].id == variable.id && fits(values[i], variable)) result.back() = values[i];
  }
  return result;
}

} // namespace

SetRuleBaseCommand::SetRuleBaseCommand(Document& document, fuzzy::RuleBase ruleBase, const QString& text,
                                       int gesture)
  : TissueCommand(document, text), m_old(document.project().tissue), m_new(m_old), m_gesture(gesture)
{
  m_new.inputs = carriedOver(m_old.inputs, m_old.rules, ruleBase);
  for (Region& region : m_new.regions) region.inputs = carriedOver(region.inputs, m_old.rules, ruleBase);
  m_new.rules = std::move(ruleBase);
}

int SetRuleBaseCommand::id() const
{
  return kSetRuleBaseCommand;
}

bool SetRuleBaseCommand::mergeWith(const QUndoCommand* next)
{
  const auto* other = static_cast<const SetRuleBaseCommand*>(next);
  if (m_gesture == 0 || other->m_gesture != m_gesture) return false;
  m_new = other->m_new;
  setObsolete(m_new.rules == m_old.rules && isUndoneByTissue());
  return true;
}

void SetRuleBaseCommand::announce(bool)
{
  emit document().ruleBaseChanged();
  emit document().inputsChanged();
}

SetInputCommand::SetInputCommand(Document& document, int target, int input, fuzzy::InputValue value,
                                 int gesture)
  : TissueCommand(document, translatedCommand(QT_TRANSLATE_NOOP("esm::Commands", "change input"))),
    m_target(target),
    m_input(input),
    m_gesture(gesture),
    m_old(document.inputs()[static_cast<std::size_t>(input)]),
    m_new(std::move(value))
{}

fuzzy::InputValue& SetInputCommand::slot(TissueModel& tissue) const
{
  auto& inputs = m_target < 0 ? tissue.inputs : tissue.regions[static_cast<std::size_t>(m_target)].inputs;
  return inputs[static_cast<std::size_t>(m_input)];
}

int SetInputCommand::id() const
{
  return kSetInputCommand;
}

bool SetInputCommand::mergeWith(const QUndoCommand* next)
{
  const auto* other = static_cast<const SetInputCommand*>(next);
  if (m_gesture == 0 || other->m_gesture != m_gesture || other->m_target != m_target ||
      other->m_input != m_input)
    return false;
  m_new = other->m_new;
  return true;
}

void SetInputCommand::announce(bool)
{
  emit document().inputsChanged();
}

SetInputsCommand::SetInputsCommand(Document& document, int target, std::vector<fuzzy::InputValue> newValues,
                                   const QString& text, int gesture)
  : TissueCommand(document, text),
    m_target(target),
    m_gesture(gesture),
    m_old(document.inputs()),
    m_new(std::move(newValues))
{}

int SetInputsCommand::id() const
{
  return kSetInputsCommand;
}

bool SetInputsCommand::mergeWith(const QUndoCommand* next)
{
  const auto* other = static_cast<const SetInputsCommand*>(next);
  if (m_gesture == 0 || other->m_gesture != m_gesture || other->m_target != m_target) return false;
  m_new = other->m_new;
  setObsolete(m_new == m_old && isUndoneByTissue());
  return true;
}

std::vector<fuzzy::InputValue>& SetInputsCommand::values(TissueModel& tissue) const
{
  return m_target < 0 ? tissue.inputs : tissue.regions[static_cast<std::size_t>(m_target)].inputs;
}

void SetInputsCommand::announce(bool)
{
  emit document().inputsChanged();
}

SetTissueSettingsCommand::SetTissueSettingsCommand(Document& document, const TissueSettings& settings,
                                                   int gesture)
  : TissueCommand(document, translatedCommand(QT_TRANSLATE_NOOP("esm::Commands", "change tissue"))),
    m_old(settingsOf(document.project().tissue)),
    m_new(settings),
    m_gesture(gesture)
{}

void SetTissueSettingsCommand::put(TissueModel& tissue, const TissueSettings& settings)
{
  tissue.thickness = settings.thickness;
  tissue.density = settings.density;
  tissue.law = settings.law;
  tissue.lawParameter = settings.lawParameter;
}

int SetTissueSettingsCommand::id() const
{
  return kSetTissueSettingsCommand;
}

bool SetTissueSettingsCommand::mergeWith(const QUndoCommand* next)
{
  const auto* other = static_cast<const SetTissueSettingsCommand*>(next);
  if (m_gesture == 0 || other->m_gesture != m_gesture) return false;
  m_new = other->m_new;
  return true;
}

void SetTissueSettingsCommand::announce(bool)
{
  emit document().tissueSettingsChanged();
}

} // namespace esm
