// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"
#include "app/panels/gesture_spin_box.h"

#include <QWidget>

#include <array>

class QLabel;
class QLineEdit;
class QListWidget;
class QToolButton;

namespace esm {

/// Dock Regions: the base tissue and the ordered ellipsoids over it, with the chosen one's numbers. The
/// chosen row is the target of the dock Fuzzy Input and the highlighted wireframe of the preview. Lengths in
/// mm, angles in degrees. Holds no data of its own.
class RegionsPanel : public QWidget {
  Q_OBJECT
public:
  explicit RegionsPanel(Document* document, QWidget* parent = nullptr);

  /// Where a new region begins [m]: the selected node, or none.
  void setPlaceOfNew(std::optional<Eigen::Vector3d> place) { m_placeOfNew = place; }
  void addRegion();

protected:
  void changeEvent(QEvent* event) override;

private:
  void buildList();
  void buildFields();
  void retranslateUi();
  void refreshList();
  void refreshFields();
  void refreshCount();
  int current() const { return m_document->inputTarget(); }
  const Region* currentRegion() const;
  void editNumber(int field, double value, int gesture);
  Region newRegion() const;

  enum Field { CentreX, CentreY, CentreZ, AxisX, AxisY, AxisZ, TurnX, TurnY, TurnZ, Falloff, kFieldCount };

  Document* m_document;
  QListWidget* m_list = nullptr;
  QToolButton *m_add = nullptr, *m_copy = nullptr, *m_remove = nullptr, *m_up = nullptr, *m_down = nullptr;
  QWidget* m_fields = nullptr;
  QLineEdit* m_name = nullptr;
  QLabel *m_nameLabel = nullptr, *m_centreLabel = nullptr, *m_axesLabel = nullptr, *m_turnLabel = nullptr,
         *m_falloffLabel = nullptr, *m_count = nullptr;
  std::array<GestureSpinBox*, kFieldCount> m_numbers{};
  std::optional<Eigen::Vector3d> m_placeOfNew;
  bool m_refreshing = false;
};

/// Rotation as turns about x, then y, then z of the scene [degrees], and back.
Eigen::Vector3d turnsOf(const Eigen::Quaterniond& rotation);
Eigen::Quaterniond rotationOf(const Eigen::Vector3d& turns);

} // namespace esm
