// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/model_commands.h"

#include "app/document/command_ids.h"

#include <utility>

namespace esm {

SetModelCommand::SetModelCommand(Document& document, ModelPart model, const QString& text)
  : DocumentCommand(document, text), m_new(std::move(model))
{
  const Project& now = document.project();
  m_new.netNumber = newNetNumber();
  m_old = {
    now.name,       now.tissue,           now.source,   document.net(), now.loads, now.parametersFromTissue,
    netIsDerived(), document.netNumber(), modelNumber()};
}

void SetModelCommand::put(const ModelPart& part)
{
  Project& target = project();
  if (document().inputTarget() >= static_cast<int>(part.tissue.regions.size()))
    setTarget(-1); // while everything is still as it was
  const TissueModel former = std::exchange(target.tissue, part.tissue);
  target.name = part.name;
  target.source = part.source;
  target.loads = part.loads;
  target.parametersFromTissue = part.parametersFromTissue;
  putNet(part.net, part.derived);
  setNetNumber(part.netNumber);
  setModelNumber(part.model);
  announceTissue(former);
  emit document().netChanged();
  emit document().modelReplaced();
  emit document().titleChanged();
}

RenameCommand::RenameCommand(Document& document, std::string name)
  : DocumentCommand(document, translatedCommand(QT_TRANSLATE_NOOP("esm::Commands", "rename"))),
    m_old(document.project().name),
    m_new(std::move(name))
{}

void RenameCommand::put(const std::string& name)
{
  project().name = name;
  emit document().titleChanged();
}

SetFixedCommand::SetFixedCommand(Document& document, const std::vector<Index>& nodes, bool fixed)
  : DocumentCommand(document, fixed ? translatedCommand(QT_TRANSLATE_NOOP("esm::Commands", "hold nodes"))
                                    : translatedCommand(QT_TRANSLATE_NOOP("esm::Commands", "free nodes"))),
    m_old(document.project().net.fixed),
    m_new(m_old)
{
  for (const Index node : nodes) m_new[static_cast<std::size_t>(node)] = fixed ? 1 : 0;
}

void SetFixedCommand::put(const std::vector<std::uint8_t>& flags)
{
  const bool derived = netIsDerived();
  project().net.fixed = flags;
  netReplaced(derived);
  emit document().netChanged();
}

SetGravityCommand::SetGravityCommand(Document& document, const Eigen::Vector3d& gravity, int gesture)
  : DocumentCommand(document, translatedCommand(QT_TRANSLATE_NOOP("esm::Commands", "change gravity"))),
    m_old(document.project().loads.gravity),
    m_new(gravity),
    m_gesture(gesture)
{}

void SetGravityCommand::put(const Eigen::Vector3d& gravity)
{
  project().loads.gravity = gravity;
  emit document().netChanged();
}

int SetGravityCommand::id() const
{
  return kSetGravityCommand;
}

bool SetGravityCommand::mergeWith(const QUndoCommand* next)
{
  const auto* other = static_cast<const SetGravityCommand*>(next);
  if (m_gesture == 0 || other->m_gesture != m_gesture) return false;
  m_new = other->m_new;
  return true;
}

SetSolverCommand::SetSolverCommand(Document& document, std::string name)
  : DocumentCommand(document, translatedCommand(QT_TRANSLATE_NOOP("esm::Commands", "choose solver"))),
    m_old(document.project().simulation.solver.solver),
    m_new(std::move(name))
{}

void SetSolverCommand::put(const std::string& name)
{
  project().simulation.solver.solver = name;
  emit document().netChanged();
}

SetParametersFromTissueCommand::SetParametersFromTissueCommand(Document& document, bool on,
                                                               std::shared_ptr<const SpringNet> net)
  : DocumentCommand(
      document, on ? translatedCommand(QT_TRANSLATE_NOOP("esm::Commands", "take parameters from tissue"))
                   : translatedCommand(QT_TRANSLATE_NOOP("esm::Commands", "keep parameters as they are"))),
    m_on(on),
    m_oldDerived(netIsDerived()),
    m_oldNumber(document.netNumber()),
    m_newNumber(on ? m_oldNumber : newNetNumber()), // its numbers hold from now on, whatever the tissue says
    m_old(document.net()),
    m_new(std::move(net))
{}

void SetParametersFromTissueCommand::put(bool on, const std::shared_ptr<const SpringNet>& net, bool derived,
                                         std::uint64_t number)
{
  project().parametersFromTissue = on;
  putNet(net, derived);
  setNetNumber(number);
  emit document().parametersChanged();
  emit document().tissueSettingsChanged();
}

} // namespace esm
