// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/recovered_steps.h"

#include <algorithm>
#include <utility>

namespace esm {

RecoveredStepCommand::RecoveredStepCommand(Document& document, std::shared_ptr<const RecoveredStates> all,
                                           std::size_t to)
  : DocumentCommand(document, QString::fromStdString(all->states[to].text)), m_all(std::move(all)), m_to(to)
{}

void RecoveredStepCommand::put(std::size_t from, std::size_t to)
{
  if (m_all->isQuiet) return;
  const RecoveredState &before = m_all->states[from], &after = m_all->states[to];
  const bool sameRun = m_all->states[std::max(from, to)].netStays; // the simulation goes on
  const int regions = static_cast<int>(after.project.tissue.regions.size());
  if (document().inputTarget() >= regions) setTarget(-1); // while everything is still as it was
  Project& target = project();
  const TissueModel former = std::exchange(target.tissue, after.project.tissue);
  target.name = after.project.name;
  target.source = after.project.source;
  target.loads = after.project.loads;
  target.simulation = after.project.simulation;
  target.parametersFromTissue = after.project.parametersFromTissue;
  if (!sameRun || !netIsDerived() || !after.netDerived) putNet(after.net, false);
  if (after.netDerived) derive();
  setNetNumber(m_all->netNumbers.at(after.copy));
  setModelNumber(after.model);
  announceTissue(former);
  if (sameRun)
    emit document().parametersChanged();
  else
    emit document().netChanged();
  if (before.copy != after.copy) emit document().modelReplaced();
  emit document().titleChanged();
}

} // namespace esm
