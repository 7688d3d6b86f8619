// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/import/defect_list.h"

#include "app/theme.h"

#include <QEvent>
#include <QHeaderView>
#include <QLocale>

namespace esm {

DefectList::DefectList(QWidget* parent) : QTreeWidget(parent)
{
  setObjectName(QStringLiteral("importDefects"));
  setHeaderHidden(true);
  setColumnCount(1);
  setUniformRowHeights(true);
  setAccessibleName(tr("Defects of the mesh"));
  connect(this, &QTreeWidget::currentItemChanged, this, &DefectList::tellChosen);
}

void DefectList::setDefects(std::vector<DefectGroup> groups)
{
  m_groups = std::move(groups);
  fill();
}

void DefectList::changeEvent(QEvent* event)
{
  QTreeWidget::changeEvent(event);
  if (event->type() != QEvent::LanguageChange) return;
  setAccessibleName(tr("Defects of the mesh"));
  fill();
}

void DefectList::fill()
{
  clear();
  if (m_groups.empty()) {
    auto* none = new QTreeWidgetItem(this, {tr("No defect found")});
    none->setFlags(Qt::ItemIsEnabled);
    return;
  }
  for (const DefectGroup& group : m_groups) {
    const QString count = QString::number(group.count);
    auto* head = new QTreeWidgetItem(
      this, {textOf(group.kind).arg(group.isComplete ? count : tr("at least %1").arg(count))});
    if (group.kind != DefectKind::Hole && group.kind != DefectKind::LoosePart) // which may be meant
      head->setForeground(0, signalColours(palette()).warning);
    for (std::size_t i = 0; i < group.defects.size(); ++i)
      new QTreeWidgetItem(head, {textOf(group.kind, i + 1, group.defects[i])});
    if (group.count > group.defects.size())
      new QTreeWidgetItem(head, {tr("... and %1 more").arg(group.count - group.defects.size())});
    if (!group.isComplete) {
      const QString why = tr("The search ended early: there may be more");
      new QTreeWidgetItem(head, {why});
      head->setToolTip(0, why + QStringLiteral(". ") +
                            tr("“esm inspect --defects --intersections” looks at all triangles"));
    }
    head->setExpanded(m_groups.size() <= 3);
  }
}

void DefectList::tellChosen()
{
  const QTreeWidgetItem* item = currentItem();
  Eigen::Matrix3Xd places(3, 0);
  const auto add = [&](const Eigen::Matrix3Xd& more) {
    places.conservativeResize(Eigen::NoChange, places.cols() + more.cols());
    places.rightCols(more.cols()) = more;
  };
  if (item != nullptr && !m_groups.empty()) {
    const bool isHead = item->parent() == nullptr;
    const auto group = static_cast<std::size_t>(
      indexOfTopLevelItem(const_cast<QTreeWidgetItem*>(isHead ? item : item->parent())));
    const std::vector<DefectGroup::Defect>& defects = m_groups[group].defects;
    if (isHead) {
      for (const DefectGroup::Defect& defect : defects) add(defect.places);
    } else if (const auto i = static_cast<std::size_t>(indexFromItem(item).row()); i < defects.size()) {
      add(defects[i].places);
    }
  }
  emit chosen(places);
}

QString DefectList::textOf(DefectKind kind) const
{
  switch (kind) {
  case DefectKind::Hole:
    return tr("Open borders: %1");
  case DefectKind::NonManifoldEdge:
    return tr("Edges of more than two triangles: %1");
  case DefectKind::NonManifoldVertex:
    return tr("Vertices where surfaces touch: %1");
  case DefectKind::TJunction:
    return tr("Vertices on the edge of another triangle: %1");
  case DefectKind::DegenerateFace:
    return tr("Degenerate triangles: %1");
  case DefectKind::DuplicateFace:
    return tr("Duplicate triangles: %1");
  case DefectKind::TurnedFace:
    return tr("Triangles turned inside out: %1");
  case DefectKind::UnorientableEdge:
    return tr("Edges over which sides cannot agree: %1");
  case DefectKind::SelfIntersection:
    return tr("Triangles that run through others: %1");
  case DefectKind::IsolatedVertex:
    return tr("Vertices that nothing uses: %1");
  case DefectKind::LoosePart:
    return tr("Separate parts beside the largest: %1");
  }
  return {};
}

QString DefectList::textOf(DefectKind kind, std::size_t number, const DefectGroup::Defect& defect) const
{
  switch (kind) {
  case DefectKind::Hole:
    return tr("Border of %n edge(s), %1 mm long", nullptr, defect.elements)
      .arg(QLocale().toString(defect.length * 1000.0, 'g', 3));
  case DefectKind::LoosePart:
    return tr("Part of %n element(s)", nullptr, defect.elements);
  default:
    break;
  }
  const Eigen::Vector3d middle = defect.places.rowwise().mean() * 1000.0;
  const auto text = [](double length) { return QLocale().toString(length, 'f', 1); };
  return tr("No. %1 at %2, %3, %4 mm").arg(number).arg(text(middle.x()), text(middle.y()), text(middle.z()));
}

} // namespace esm
