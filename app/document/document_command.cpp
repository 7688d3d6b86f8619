// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/document_command.h"

namespace esm {

void DocumentCommand::netReplaced(bool derived)
{
  m_document->m_sharedNet.reset();
  m_document->m_derived = derived;
}

void TissueCommand::redo()
{
  Document& target = document();
  m_before = netIsDerived() || !project().parametersFromTissue ? nullptr : target.net();
  apply(project().tissue);
  keepTargetInRange();
  if (target.m_prepared)
    target.putNet(std::move(target.m_prepared));
  else
    target.deriveParameters();
  target.m_prepared.reset();
  announce(false);
  if (project().parametersFromTissue) emit target.parametersChanged();
}

void TissueCommand::undo()
{
  Document& target = document();
  revert(project().tissue);
  keepTargetInRange();
  if (m_before) {
    target.putNet(m_before);
    target.m_derived = false;
  } else {
    target.deriveParameters();
  }
  announce(true);
  if (project().parametersFromTissue) emit target.parametersChanged();
}

} // namespace esm
