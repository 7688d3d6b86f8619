// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/fuzzy_evaluation.h"

namespace esm {

FuzzyEvaluation::FuzzyEvaluation(FuzzyDocument* document, QObject* parent)
  : QObject(parent), m_document(document)
{
  m_announce.setSingleShot(true);
  m_announce.setInterval(0);
  connect(&m_announce, &QTimer::timeout, this, &FuzzyEvaluation::changed);
  connect(document, &FuzzyDocument::ruleBaseChanged, this, [this] {
    m_engine.reset();
    m_stale = true;
    m_announce.start();
  });
  connect(document, &FuzzyDocument::inputsChanged, this, [this] {
    m_stale = true;
    m_announce.start();
  });
}

const fuzzy::Inference& FuzzyEvaluation::inference() const
{
  if (!m_stale) return m_inference;
  m_stale = false;
  ++m_computations;
  m_inference = {};
  const fuzzy::RuleBase& rules = m_document->ruleBase();
  m_degrees.assign(rules.rules.size(), 0.0);
  // While a document is being loaded its rules may be new and its inputs still old.
  if (m_document->inputs().size() != rules.inputs.size()) return m_inference;
  if (!m_engine) {
    Result<fuzzy::Engine> engine = fuzzy::Engine::create(rules);
    if (!engine) return m_inference;
    m_engine.emplace(std::move(engine).value());
  }
  m_inference = m_engine->evaluate(m_document->inputs());
  for (const fuzzy::RuleFiring& firing : m_inference.firings)
    m_degrees[static_cast<std::size_t>(firing.rule)] = firing.degree;
  return m_inference;
}

double FuzzyEvaluation::degree(int rule) const
{
  inference();
  const auto index = static_cast<std::size_t>(rule);
  return rule >= 0 && index < m_degrees.size() ? m_degrees[index] : 0.0;
}

} // namespace esm
