// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
// All memory that one thread needs for evaluations, asked for at once.
#include "core/fuzzy/fis/compiled.h"
#include "core/fuzzy/fis/evaluator.h"

#include <algorithm>

namespace esm::fis {

Workspace::Workspace(std::unique_ptr<Scratch> scratch) : m_scratch(std::move(scratch)) {}
Workspace::Workspace(Workspace&&) noexcept = default;
Workspace& Workspace::operator=(Workspace&&) noexcept = default;
Workspace::~Workspace() = default;

std::span<const OutputResult> Workspace::outputs() const noexcept
{
  return m_scratch->outputs;
}
std::span<const double> Workspace::firings() const noexcept
{
  return m_scratch->firings;
}
std::span<const double> Workspace::degrees() const noexcept
{
  return m_scratch->degrees;
}
void Workspace::restart() noexcept
{
  std::fill(m_scratch->previous.begin(), m_scratch->previous.end(), kNoValue);
}

Workspace Evaluator::makeWorkspace() const
{
  const Compiled& c = *m_compiled;
  auto s = std::make_unique<Scratch>();
  std::size_t mostActivated = 0, mostMarks = 0, mostSamples = 0, activated = 0;
  for (const FlatOutput& output : c.outputs) {
    mostActivated = std::max(mostActivated, at(output.activated.count));
    activated += at(output.activated.count);
    if (output.resolution > 0) mostSamples = std::max(mostSamples, at(output.resolution));
    if (isArea(output.defuzzifier) && output.resolution == 0)
      mostMarks = std::max(mostMarks, at(output.markBound));
  }
  const std::size_t inputs = c.system.inputs.size(), outputs = c.outputs.size(), rules = c.rules.size();
  s->variables.assign(inputs + outputs, kNoValue);
  s->inputs.assign(inputs, {});
  s->slots.assign(at(c.slotCount), 0.0);
  s->slotAdjoint.assign(at(c.slotCount), 0.0);
  s->prefix.assign(std::max({at(c.mostChildren), activated, mostActivated}) + 1, 0.0);
  s->degrees.assign(rules, 0.0);
  s->firings.assign(rules, 0.0);
  s->ruleAdjoint.assign(rules, 0.0);
  s->queue.reserve(rules);
  s->dead.assign(rules / 64 + 1, 0);
  s->lacks.assign(c.inputFacts.size(), 0);
  s->order.reserve(rules);
  s->blockSum.assign(c.blocks.size(), 0.0);
  s->activated.assign(activated, {});
  s->activatedAdjoint.assign(activated, 0.0);
  s->activatedCount.assign(outputs, 0);
  s->seen.assign(c.outputFacts.size(), 0);
  s->outputs.assign(outputs, {});
  s->outputAdjoint.assign(outputs, 0.0);
  s->previous.assign(outputs, kNoValue);
  s->samples.assign(mostSamples, 0.0);
  s->sets.reserve(mostActivated);
  s->setOfTerm.assign(c.terms.size(), -1);
  s->marks.reserve(mostMarks);
  s->segments.reserve(mostMarks);
  s->starts.assign(mostActivated, 0.0);
  s->ends.assign(mostActivated, 0.0);
  s->heights.assign(mostActivated, 0.0);
  s->byDegree.assign(mostActivated, 0.0);
  s->variableSlopes.assign(1 + inputs + outputs, 0.0);
  const std::size_t derivatives = mostActivated + c.numbers.size() + s->variableSlopes.size();
  for (auto* list : {&s->partial, &s->partialCoarse, &s->partialScale}) list->assign(derivatives, 0.0);
  return Workspace(std::move(s));
}

} // namespace esm::fis
