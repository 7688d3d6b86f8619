// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/control_surface.h"

#include "core/fuzzy/axis.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace esm::fuzzy {

namespace {

/// Places even on the variable's axis, from end to end.
std::vector<double> evenPlaces(const Variable& variable, int count)
{
  const Axis axis = axisOf(variable);
  std::vector<double> places;
  places.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
    places.push_back(fromAxis(variable, axis.low + (axis.high - axis.low) * i / (count - 1)));
  return places;
}

/// The rule base reduced to what speaks about one output.
RuleBase onlyOutput(const RuleBase& ruleBase, const Variable& output)
{
  RuleBase reduced{ruleBase.inputs, {output}, {}};
  for (const Rule& rule : ruleBase.rules) {
    if (!rule.enabled) continue;
    Rule kept = rule;
    std::erase_if(kept.consequents, [&](const Proposition& said) { return said.variable != output.id; });
    if (!kept.consequents.empty()) reduced.rules.push_back(std::move(kept));
  }
  return reduced;
}

Status checkQuestion(const RuleBase& ruleBase, const SurfaceQuestion& question)
{
  const auto within = [](int index, std::size_t count) {
    return index >= 0 && static_cast<std::size_t>(index) < count;
  };
  if (!within(question.output, ruleBase.outputs.size()) || !within(question.x, ruleBase.inputs.size()) ||
      !within(question.y, ruleBase.inputs.size()) || question.x == question.y)
    return Error{ErrorCode::InvalidValue, "a control surface needs an output and two different inputs"};
  if (question.columns < 2 || question.rows < 2)
    return Error{ErrorCode::InvalidValue, "a control surface needs two columns and two rows at least"};
  return {};
}

} // namespace

SurfaceSweep::SurfaceSweep(Engine engine, const SurfaceQuestion& question, std::vector<InputValue> inputs)
  : m_engine(std::move(engine)), m_question(question), m_inputs(std::move(inputs))
{
  const RuleBase& rules = m_engine.ruleBase();
  for (std::size_t i = m_inputs.size(); i < rules.inputs.size(); ++i)
    m_inputs.emplace_back(rules.inputs[i].defaultValue);
  m_surface.x = evenPlaces(rules.inputs[static_cast<std::size_t>(question.x)], question.columns);
  m_surface.y = evenPlaces(rules.inputs[static_cast<std::size_t>(question.y)], question.rows);
  const std::size_t count = m_surface.x.size() * m_surface.y.size();
  m_surface.value.assign(count, rules.outputs[0].defaultValue);
  m_surface.fired.assign(count, 0);
}

Result<SurfaceSweep> SurfaceSweep::create(const RuleBase& ruleBase, const SurfaceQuestion& question,
                                          std::vector<InputValue> inputs)
{
  if (Status status = checkQuestion(ruleBase, question); !status) return status.error();
  auto engine =
    Engine::create(onlyOutput(ruleBase, ruleBase.outputs[static_cast<std::size_t>(question.output)]));
  if (!engine) return engine.error();
  return SurfaceSweep(std::move(engine).value(), question, std::move(inputs));
}

bool SurfaceSweep::nextRow()
{
  if (m_row >= m_surface.rows()) return false;
  m_inputs[static_cast<std::size_t>(m_question.y)] = m_surface.y[m_row];
  for (std::size_t column = 0; column < m_surface.columns(); ++column) {
    m_inputs[static_cast<std::size_t>(m_question.x)] = m_surface.x[column];
    const OutputValue answer = m_engine.evaluate(m_inputs).outputs[0];
    const std::size_t place = m_row * m_surface.columns() + column;
    m_surface.value[place] = answer.value;
    m_surface.fired[place] = answer.fromRules ? 1 : 0;
  }
  ++m_row;
  return m_row < m_surface.rows();
}

Result<ControlSurface> controlSurface(const RuleBase& ruleBase, const SurfaceQuestion& question,
                                      std::vector<InputValue> inputs)
{
  auto sweep = SurfaceSweep::create(ruleBase, question, std::move(inputs));
  if (!sweep) return sweep.error();
  while (sweep->nextRow()) {
  }
  return sweep->surface();
}

} // namespace esm::fuzzy
