// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/region_commands.h"

#include "app/document/command_ids.h"

#include <QCoreApplication>

namespace esm {

namespace {

QString translated(const char* text)
{
  return QCoreApplication::translate("esm::Commands", text);
}

void insertAt(TissueModel& tissue, int index, const Region& region)
{
  tissue.regions.insert(tissue.regions.begin() + index, region);
}

void eraseAt(TissueModel& tissue, int index)
{
  tissue.regions.erase(tissue.regions.begin() + index);
}

void move(TissueModel& tissue, int from, int to)
{
  Region region = std::move(tissue.regions[static_cast<std::size_t>(from)]);
  eraseAt(tissue, from);
  insertAt(tissue, to, region);
}

} // namespace

AddRegionCommand::AddRegionCommand(Document& document, int index, Region region)
  : TissueCommand(document, translated(QT_TRANSLATE_NOOP("esm::Commands", "add region"))),
    m_index(index),
    m_region(std::move(region))
{}

void AddRegionCommand::apply(TissueModel& tissue) const
{
  insertAt(tissue, m_index, m_region);
}
void AddRegionCommand::revert(TissueModel& tissue) const
{
  eraseAt(tissue, m_index);
}

void AddRegionCommand::announce(bool undone)
{
  emit document().regionsChanged();
  setTarget(undone ? m_index - 1 : m_index);
}

RemoveRegionCommand::RemoveRegionCommand(Document& document, int index)
  : TissueCommand(document, translated(QT_TRANSLATE_NOOP("esm::Commands", "remove region"))),
    m_index(index),
    m_region(document.project().tissue.regions[static_cast<std::size_t>(index)])
{}

void RemoveRegionCommand::apply(TissueModel& tissue) const
{
  eraseAt(tissue, m_index);
}
void RemoveRegionCommand::revert(TissueModel& tissue) const
{
  insertAt(tissue, m_index, m_region);
}

void RemoveRegionCommand::announce(bool undone)
{
  emit document().regionsChanged();
  setTarget(undone ? m_index : m_index - 1);
}

MoveRegionCommand::MoveRegionCommand(Document& document, int from, int to)
  : TissueCommand(document, translated(QT_TRANSLATE_NOOP("esm::Commands", "reorder regions"))),
    m_from(from),
    m_to(to)
{}

void MoveRegionCommand::apply(TissueModel& tissue) const
{
  move(tissue, m_from, m_to);
}
void MoveRegionCommand::revert(TissueModel& tissue) const
{
  move(tissue, m_to, m_from);
}

void MoveRegionCommand::announce(bool undone)
{
  emit document().regionsChanged();
  setTarget(undone ? m_from : m_to);
}

SetRegionCommand::SetRegionCommand(Document& document, int index, Region region, const QString& text,
                                   int gesture)
  : TissueCommand(document, text),
    m_index(index),
    m_gesture(gesture),
    m_old(document.project().tissue.regions[static_cast<std::size_t>(index)]),
    m_new(std::move(region))
{}

void SetRegionCommand::apply(TissueModel& tissue) const
{
  tissue.regions[static_cast<std::size_t>(m_index)] = m_new;
}

void SetRegionCommand::revert(TissueModel& tissue) const
{
  tissue.regions[static_cast<std::size_t>(m_index)] = m_old;
}

int SetRegionCommand::id() const
{
  return kSetRegionCommand;
}

bool SetRegionCommand::mergeWith(const QUndoCommand* next)
{
  const auto* other = static_cast<const SetRegionCommand*>(next);
  if (m_gesture == 0 || other->m_gesture != m_gesture || other->m_index != m_index) return false;
  m_new = other->m_new;
  return true;
}

void SetRegionCommand::announce(bool)
{
  emit document().regionsChanged();
  if (document().inputTarget() == m_index) emit document().inputsChanged(); // its name may be new
}

} // namespace esm
