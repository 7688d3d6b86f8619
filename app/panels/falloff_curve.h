// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tissue/region.h"

#include <QWidget>

#include <optional>

namespace esm {

/// A small picture of a region's weight along its radius: from the centre at the left over the surface (a
/// thin line) to beyond it. Shows nothing without a region.
class FalloffCurve : public QWidget {
  Q_OBJECT
public:
  explicit FalloffCurve(QWidget* parent = nullptr);
  void show(const Region& region);
  void clear();
  using QWidget::show;
  QSize sizeHint() const override { return {120, 44}; }

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  struct Curve {
    FalloffProfile profile;
    double falloff;
    bool insideOut;
    bool operator==(const Curve&) const = default;
  };
  std::optional<Curve> m_curve;
};

} // namespace esm
