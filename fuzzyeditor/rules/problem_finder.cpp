// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/rules/problem_finder.h"

#include <exception>

namespace esm {

ProblemFinder::ProblemFinder(FuzzyDocument* document, QObject* parent) : QObject(parent), m_document(document)
{
  m_threads.setMaxThreadCount(1);
  m_pause.setSingleShot(true);
  m_pause.setInterval(250);
  connect(&m_pause, &QTimer::timeout, this, &ProblemFinder::look);
  connect(document, &FuzzyDocument::ruleBaseChanged, this, &ProblemFinder::followDocument);
}

ProblemFinder::~ProblemFinder()
{
  m_threads.waitForDone(); // it reports to this object
}

void ProblemFinder::setOn(bool on)
{
  if (on == m_on) return;
  m_on = on;
  if (!on)
    m_pause.stop();
  else if (!m_current && !m_looking)
    m_pause.start();
}

void ProblemFinder::followDocument()
{
  m_current = false;
  m_outdated = m_looking;
  if (m_on && !m_looking) m_pause.start(); // anew with every edit: typing and dragging go on undisturbed
}

void ProblemFinder::look()
{
  m_looking = true;
  m_outdated = false;
  m_threads.start([this, rules = m_document->ruleBase()] {
    std::vector<fuzzy::RuleFinding> findings;
    try {
      findings = fuzzy::findOddities(rules);
    } catch (const std::exception&) { // out of memory: no list is better than no program
    }
    QMetaObject::invokeMethod(
      this, [this, findings = std::move(findings)] { take(findings); }, Qt::QueuedConnection);
  });
}

void ProblemFinder::take(std::vector<fuzzy::RuleFinding> findings)
{
  m_looking = false;
  if (m_outdated) {
    if (m_on) m_pause.start();
    return;
  }
  m_findings = std::move(findings);
  m_current = true;
  emit found();
}

} // namespace esm
