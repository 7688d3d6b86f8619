// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/why_selection.h"

namespace esm {

WhySelection::WhySelection(Document* document, QObject* parent) : WhySource(parent), m_document(document)
{
  connect(document, &Document::projectReset, this, [this] {
    m_thing = {};
    netChanged();
  });
  connect(document, &Document::netChanged, this, &WhySelection::netChanged);
  for (const auto signal :
       {&Document::parametersChanged, &Document::regionsChanged, &Document::tissueSettingsChanged})
    connect(document, signal, this, &WhySource::changed);
  for (const auto signal :
       {&FuzzyDocument::inputsChanged, &FuzzyDocument::ruleBaseChanged, &FuzzyDocument::ruleLanguageChanged})
    connect(document, signal, this, &WhySource::changed);
}

void WhySelection::select(ExplainedThing thing)
{
  if (thing == m_thing) return;
  m_thing = thing;
  emit changed();
}

void WhySelection::selectNode(Index node)
{
  select(node == kNoIndex ? ExplainedThing{} : ExplainedThing{ExplainedThing::Kind::Node, node});
}

void WhySelection::selectSpring(Index spring)
{
  select(spring == kNoIndex ? ExplainedThing{} : ExplainedThing{ExplainedThing::Kind::Spring, spring});
}

TissueExplanation WhySelection::explanation() const
{
  const TissueField& tissue = *field();
  if (m_thing.kind == ExplainedThing::Kind::Tissue) return explainTissue(tissue, m_document->inputTarget());
  const Project& project = m_document->project();
  if (!m_explainer) m_explainer.emplace(project.net);
  return m_explainer->explain(tissue, project.net, m_thing, project.parametersFromTissue);
}

void WhySelection::apply(const InputChange& change)
{
  m_document->setInputTarget(change.region);
  m_document->setInput(change.input, change.to, 0);
}

void WhySelection::netChanged()
{
  m_explainer.reset();
  const SpringNet& net = m_document->project().net;
  const bool isGone = (m_thing.kind == ExplainedThing::Kind::Node && m_thing.index >= net.nodeCount()) ||
                      (m_thing.kind == ExplainedThing::Kind::Spring && m_thing.index >= net.springCount());
  if (isGone) m_thing = {};
  emit changed();
}

} // namespace esm
