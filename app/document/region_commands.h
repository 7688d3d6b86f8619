// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document_command.h"

namespace esm {

/// Puts a region in at a place of the order.
class AddRegionCommand : public TissueCommand {
public:
  AddRegionCommand(Document& document, int index, Region region);
  void apply(TissueModel& tissue) const override;

protected:
  void revert(TissueModel& tissue) const override;
  void announce(bool undone) override;

private:
  int m_index;
  Region m_region;
};

class RemoveRegionCommand : public TissueCommand {
public:
  RemoveRegionCommand(Document& document, int index);
  void apply(TissueModel& tissue) const override;

protected:
  void revert(TissueModel& tissue) const override;
  void announce(bool undone) override;

private:
  int m_index;
  Region m_region;
};

/// Another place in the order: a later region covers an earlier one.
class MoveRegionCommand : public TissueCommand {
public:
  MoveRegionCommand(Document& document, int from, int to);
  void apply(TissueModel& tissue) const override;

protected:
  void revert(TissueModel& tissue) const override;
  void announce(bool undone) override;

private:
  int m_from, m_to;
};

/// Name, place, shape, falloff or on/off of a region. Values of one gesture merge.
class SetRegionCommand : public TissueCommand {
public:
  SetRegionCommand(Document& document, int index, Region region, const QString& text, int gesture);
  void apply(TissueModel& tissue) const override;
  int id() const override;
  bool mergeWith(const QUndoCommand* next) override;

protected:
  void revert(TissueModel& tissue) const override;
  void announce(bool undone) override;

private:
  int m_index, m_gesture;
  Region m_old, m_new;
};

} // namespace esm
