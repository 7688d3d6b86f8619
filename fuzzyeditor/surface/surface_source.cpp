// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/surface/surface_source.h"

#include "fuzzyeditor/fuzzy_evaluation.h"

#include <QElapsedTimer>

namespace esm {

namespace {

constexpr qint64 kBudget = 10; ///< [ms] of computing in one turn of the event loop
constexpr int kCoarse = 11;    ///< places along each side of the coarse grid

/// Rows until all are there or the time is over.
bool sweepFor(fuzzy::SurfaceSweep& sweep)
{
  QElapsedTimer time;
  time.start();
  while (sweep.nextRow())
    if (time.elapsed() >= kBudget) return false;
  return true;
}

const fuzzy::Variable* at(const std::vector<fuzzy::Variable>& list, int index)
{
  return index >= 0 && static_cast<std::size_t>(index) < list.size() ? &list[static_cast<std::size_t>(index)]
                                                                     : nullptr;
}

} // namespace

SurfaceSource::SurfaceSource(FuzzyEvaluation* evaluation, QObject* parent)
  : QObject(parent), m_evaluation(evaluation)
{
  m_idle.setSingleShot(true);
  m_idle.setInterval(0);
  connect(&m_idle, &QTimer::timeout, this, &SurfaceSource::refine);
  connect(evaluation->document(), &FuzzyDocument::ruleBaseChanged, this, [this] { m_stale = true; });
  connect(evaluation, &FuzzyEvaluation::changed, this, &SurfaceSource::changed);
}

void SurfaceSource::setQuestion(int output, int x, int y)
{
  const fuzzy::SurfaceQuestion question{output, x, y};
  if (question == m_question) return;
  m_question = question;
  m_stale = true;
  emit changed();
}

const fuzzy::Variable* SurfaceSource::output() const
{
  return at(m_evaluation->document()->ruleBase().outputs, m_question.output);
}
const fuzzy::Variable* SurfaceSource::inputX() const
{
  return at(m_evaluation->document()->ruleBase().inputs, m_question.x);
}
const fuzzy::Variable* SurfaceSource::inputY() const
{
  return at(m_evaluation->document()->ruleBase().inputs, m_question.y);
}

/// The inputs that the surface leaves alone, with the two others blanked out.
std::vector<fuzzy::InputValue> SurfaceSource::otherInputs() const
{
  std::vector<fuzzy::InputValue> inputs = m_evaluation->document()->inputs();
  inputs.resize(m_evaluation->document()->ruleBase().inputs.size());
  for (const int index : {m_question.x, m_question.y})
    if (index >= 0 && static_cast<std::size_t>(index) < inputs.size())
      inputs[static_cast<std::size_t>(index)] = 0.0;
  return inputs;
}

const fuzzy::ControlSurface* SurfaceSource::surface() const
{
  if (!output() || !inputX() || !inputY() || m_question.x == m_question.y) return nullptr;
  if (m_stale || otherInputs() != m_others) compute();
  return m_surface ? &*m_surface : nullptr;
}

void SurfaceSource::compute() const
{
  m_stale = false;
  m_others = otherInputs();
  m_surface.reset();
  m_sweep.reset();
  m_idle.stop();
  ++m_computations;
  const fuzzy::RuleBase& rules = m_evaluation->document()->ruleBase();
  auto sweep = fuzzy::SurfaceSweep::create(rules, m_question, m_others);
  if (!sweep) return;
  if (sweepFor(*sweep)) {
    m_surface = sweep->surface();
    return;
  }
  fuzzy::SurfaceQuestion coarse = m_question;
  coarse.columns = coarse.rows = kCoarse;
  if (auto rough = fuzzy::controlSurface(rules, coarse, m_others)) m_surface = std::move(rough).value();
  m_sweep.emplace(std::move(sweep).value());
  m_idle.start();
}

void SurfaceSource::refine()
{
  if (!m_sweep || m_stale) return;
  if (!sweepFor(*m_sweep)) {
    m_idle.start();
    return;
  }
  m_surface = m_sweep->surface();
  m_sweep.reset();
  emit changed();
}

} // namespace esm
