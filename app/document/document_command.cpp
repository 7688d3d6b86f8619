// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/document_command.h"

#include <QCoreApplication>

namespace esm {

QString translatedCommand(const char* text)
{
  return QCoreApplication::translate("esm::Commands", text);
}

void DocumentCommand::netReplaced(bool derived)
{
  m_document->netWritten(derived);
}

void DocumentCommand::derive()
{
  Document& target = document();
  if (!target.isPrepared())
    if (auto prepared = target.prepare(project().tissue); !prepared) {
      emit target.problem(prepared.error());
      return;
    }
  target.derivePrepared();
}

void DocumentCommand::announceTissue(const TissueModel& former)
{
  Document& target = document();
  const TissueModel& now = target.project().tissue;
  const bool otherRules = former.rules != now.rules, otherRegions = former.regions != now.regions;
  const bool otherNumbers = settingsOf(former) != settingsOf(now);
  if (otherRules) emit target.ruleBaseChanged();
  if (otherRegions) emit target.regionsChanged();
  if (otherRules || otherRegions || otherNumbers || former.inputs != now.inputs) emit target.inputsChanged();
  if (otherNumbers) emit target.tissueSettingsChanged();
}

void TissueCommand::redo()
{
  Document& target = document();
  m_before = netIsDerived() || !project().parametersFromTissue ? nullptr : target.net();
  apply(project().tissue);
  derive();
  keepTargetInRange();
  announce(false);
  if (project().parametersFromTissue) emit target.parametersChanged();
}

void TissueCommand::undo()
{
  Document& target = document();
  revert(project().tissue);
  if (m_before)
    putNet(m_before, false);
  else
    derive();
  keepTargetInRange();
  announce(true);
  if (project().parametersFromTissue) emit target.parametersChanged();
}

void TissueCommand::becomeVoid()
{
  setObsolete(true);
  if (!m_before) return;
  putNet(m_before, false); // the numbers of the file, which the first edit of the gesture replaced
  emit document().parametersChanged();
}

} // namespace esm
