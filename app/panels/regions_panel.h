// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"
#include "app/panels/region_fields.h"

#include <QWidget>

#include <optional>
#include <utility>

class QScrollArea;
class QToolButton;

namespace esm {

class RegionList;

/// Dock Regions: the base tissue and the ordered ellipsoids over it, with the chosen one's numbers. The
/// chosen row is the target of the dock Fuzzy Input and has the gizmo of the preview. Holds no data of its
/// own but where a new region begins.
class RegionsPanel : public QWidget {
  Q_OBJECT
public:
  explicit RegionsPanel(Document* document, QWidget* parent = nullptr);

  /// Where a new region begins [m]: the node picked last, or none.
  void setPlaceOfNew(std::optional<Eigen::Vector3d> place) { m_placeOfNew = std::move(place); }
  void setSelection(const std::vector<Index>& nodes); ///< that a new region can be laid around
  void addRegion();
  void addFromSelection();

  // === The gizmo of the preview
  void beginDrag() { m_dragGesture = GestureSpinBox::newGesture(); }
  void drag(const GizmoShape& shape) { m_fields->setShape(shape, m_dragGesture); }

protected:
  void changeEvent(QEvent* event) override;

private:
  QToolButton* button(const char* name);
  void buildList();
  void buildButtons();
  void retranslateUi();
  void refresh();
  int current() const { return m_document->inputTarget(); }
  const Region* currentRegion() const;
  Region newRegion() const;
  void duplicate();

  Document* m_document;
  RegionList* m_list = nullptr;
  RegionFields* m_fields = nullptr;
  QScrollArea* m_scroll = nullptr;
  QToolButton *m_add = nullptr, *m_fromSelection = nullptr, *m_copy = nullptr, *m_remove = nullptr,
              *m_up = nullptr, *m_down = nullptr, *m_visible = nullptr, *m_locked = nullptr;
  std::optional<Eigen::Vector3d> m_placeOfNew;
  std::vector<Index> m_selection;
  int m_dragGesture = 0;
};

} // namespace esm
