// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include <Eigen/Core>

namespace esm {

/// A force as an arrow on a dial, seen from the front (x to the right, z up); the part that points away from
/// or towards the viewer (y) is the bar beside it. The rim's value follows the force in steps of 1, 2, 5 and
/// is written beside it.
class ForceDial : public QWidget {
  Q_OBJECT
public:
  explicit ForceDial(QWidget* parent = nullptr);
  void setForce(const Eigen::Vector3d& force);
  QSize sizeHint() const override { return {140, 120}; }
  QSize minimumSizeHint() const override { return {118, 90}; }

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  Eigen::Vector3d m_force = Eigen::Vector3d::Zero(); ///< [N]
  double m_rim = 1.0;                                ///< [N]
};

} // namespace esm
