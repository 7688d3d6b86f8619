// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"
#include "app/panels/gesture_spin_box.h"
#include "app/viewport/region_gizmo.h"

#include <QWidget>

#include <array>

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace esm {

class FalloffCurve;

/// The numbers of the chosen region: name, shape, falloff with a picture of the weight, inside-out, mirror.
/// Lengths in mm, angles in degrees. A locked region can be read but not changed. Holds no data of its own.
class RegionFields : public QWidget {
  Q_OBJECT
public:
  explicit RegionFields(Document* document, QWidget* parent = nullptr);

  void refresh();
  void refreshCount(); ///< of the springs that the region reaches
  /// A drag of the gizmo. @param gesture see GestureSpinBox.
  void setShape(const GizmoShape& shape, int gesture);

protected:
  void changeEvent(QEvent* event) override;

private:
  enum Field {
    CentreX,
    CentreY,
    CentreZ,
    AxisX,
    AxisY,
    AxisZ,
    TurnX,
    TurnY,
    TurnZ,
    Falloff,
    MirrorAt,
    kFieldCount
  };

  void buildNumbers();
  void buildChoices();
  void buildLayout();
  void retranslateUi();
  const Region* region() const;
  void editNumber(int field, double value, int gesture);
  void editMirror(int choice);
  void rename();
  void refreshMirror(const Region& region);
  template <class Change>
  void edit(const QString& what, Change&& change, int gesture = 0);

  Document* m_document;
  QLineEdit* m_name = nullptr;
  std::array<GestureSpinBox*, kFieldCount> m_numbers{};
  QComboBox *m_profile = nullptr, *m_mirror = nullptr;
  QCheckBox* m_insideOut = nullptr;
  QPushButton* m_detach = nullptr;
  FalloffCurve* m_curve = nullptr;
  QLabel *m_nameLabel = nullptr, *m_centreLabel = nullptr, *m_axesLabel = nullptr, *m_turnLabel = nullptr,
         *m_falloffLabel = nullptr, *m_weightLabel = nullptr, *m_mirrorLabel = nullptr, *m_count = nullptr;
  bool m_refreshing = false;
};

/// Rotation as turns about x, then y, then z of the scene [degrees], and back.
Eigen::Vector3d turnsOf(const Eigen::Quaterniond& rotation);
Eigen::Quaterniond rotationOf(const Eigen::Vector3d& turns);

} // namespace esm
