// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document_command.h"

namespace esm {

/// Every edit of the list of regions: the list before and after it. What may be done to a list, and what a
/// lock forbids, is said in core/tissue/region_edit.h; the document asks there first. Edits of one gesture
/// merge; a gesture that ends where it began leaves no step.
class EditRegionsCommand : public TissueCommand {
public:
  /// @param chosen the region that the edit is about, as place after it (-1: none).
  /// @param chosenBefore as place before it.
  EditRegionsCommand(Document& document, std::vector<Region> regions, int chosenBefore, int chosen,
                     const QString& text, int gesture);
  void apply(TissueModel& tissue) const override;
  int id() const override;
  bool mergeWith(const QUndoCommand* next) override;

protected:
  void revert(TissueModel& tissue) const override;
  void announce(bool undone) override;

private:
  std::vector<Region> m_before, m_after;
  int m_chosenBefore, m_chosenAfter, m_gesture;
};

} // namespace esm
