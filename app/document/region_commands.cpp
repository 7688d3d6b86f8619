// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/region_commands.h"

#include "app/document/command_ids.h"

namespace esm {

EditRegionsCommand::EditRegionsCommand(Document& document, std::vector<Region> regions, int chosenBefore,
                                       int chosen, const QString& text, int gesture)
  : TissueCommand(document, text),
    m_before(document.project().tissue.regions),
    m_after(std::move(regions)),
    m_chosenBefore(chosenBefore),
    m_chosenAfter(chosen),
    m_gesture(gesture)
{}

void EditRegionsCommand::apply(TissueModel& tissue) const
{
  tissue.regions = m_after;
}

void EditRegionsCommand::revert(TissueModel& tissue) const
{
  tissue.regions = m_before;
}

int EditRegionsCommand::id() const
{
  return kEditRegionsCommand;
}

bool EditRegionsCommand::mergeWith(const QUndoCommand* next)
{
  const auto* other = static_cast<const EditRegionsCommand*>(next);
  if (m_gesture == 0 || other->m_gesture != m_gesture) return false;
  m_after = other->m_after;
  m_chosenAfter = other->m_chosenAfter;
  if (m_after == m_before) becomeVoid();
  return true;
}

/// Where an edit leaves every region in its place, the chosen one may be another one by now, and stays.
void EditRegionsCommand::announce(bool undone)
{
  const bool samePlaces = m_chosenBefore == m_chosenAfter && m_before.size() == m_after.size();
  emit document().regionsChanged();
  if (!samePlaces)
    setTarget(undone ? m_chosenBefore : m_chosenAfter);
  else
    emit document().inputsChanged(); // its name or inputs may be others
}

} // namespace esm
