// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tissue/region.h"

#include <QListWidget>

#include <vector>

namespace esm {

/// The base tissue and the regions over it, one row each: a tick (takes part), the name, an eye and a lock to
/// click at. Rows of regions are dragged to another place of the order; the base tissue stays the first. The
/// list itself changes nothing: it says what was asked for, and shows what it is given.
class RegionList : public QListWidget {
  Q_OBJECT
public:
  explicit RegionList(QWidget* parent = nullptr);

  /// @param chosen region, or -1 for the base tissue.
  void show(const std::vector<Region>& regions, const QString& base, int chosen);
  using QListWidget::show;

  /// Of a row of this list. Public for tests, which cannot make the system drag.
  void dropEvent(QDropEvent* event) override;

signals:
  void chosen(int region); ///< -1: the base tissue
  void enabledAsked(int region, bool on);
  void visibleAsked(int region, bool on);
  void lockAsked(int region, bool on);
  void moveAsked(int from, int to);

protected:
  void mousePressEvent(QMouseEvent* event) override;

private:
  void fillRow(QListWidgetItem* item, const Region& region);
  bool m_showing = false;
};

} // namespace esm
