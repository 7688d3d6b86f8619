// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/import/defect_places.h"

#include <QTreeWidget>

namespace esm {

/// What is wrong with a mesh, kind by kind and place by place. Choosing an entry asks to be shown its place;
/// choosing a kind, all of its places.
class DefectList : public QTreeWidget {
  Q_OBJECT
public:
  explicit DefectList(QWidget* parent = nullptr);

  void setDefects(std::vector<DefectGroup> groups);
  const std::vector<DefectGroup>& defects() const noexcept { return m_groups; }

signals:
  void chosen(const Eigen::Matrix3Xd& places); ///< 3 x K [m]; of no entry 3 x 0

protected:
  void changeEvent(QEvent* event) override;

private:
  void fill();
  void tellChosen();
  QString textOf(DefectKind kind) const;
  QString textOf(DefectKind kind, std::size_t number, const DefectGroup::Defect& defect) const;

  std::vector<DefectGroup> m_groups;
};

} // namespace esm
