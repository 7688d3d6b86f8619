// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/region_list.h"

#include "app/icons.h"

#include <QDropEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QStyledItemDelegate>

namespace esm {

namespace {

constexpr int kVisibleRole = Qt::UserRole, kLockedRole = Qt::UserRole + 1;
constexpr int kIcon = 18; ///< [pixels]

QRect eyeRect(const QRect& row)
{
  return {row.right() - 2 * kIcon - 4, row.center().y() - kIcon / 2, kIcon, kIcon};
}

QRect lockRect(const QRect& row)
{
  return eyeRect(row).translated(kIcon + 4, 0);
}

/// Leaves room for the eye and the lock at the right.
class RegionRow : public QStyledItemDelegate {
public:
  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override
  {
    if (!index.data(kVisibleRole).isValid()) return QStyledItemDelegate::paint(painter, option, index);
    QStyleOptionViewItem text = option;
    text.rect.setRight(eyeRect(option.rect).left() - 2);
    QStyleOptionViewItem whole = option; // the ground of the selection reaches to the end
    whole.text.clear();
    if (const QWidget* widget = option.widget)
      widget->style()->drawPrimitive(QStyle::PE_PanelItemViewItem, &whole, painter, widget);
    QStyledItemDelegate::paint(painter, text, index);
    const bool visible = index.data(kVisibleRole).toBool(), locked = index.data(kLockedRole).toBool();
    const QIcon::Mode mode = option.state & QStyle::State_Selected ? QIcon::Selected : QIcon::Normal;
    const auto draw = [&](Symbol symbol, const QRect& place, bool strong) {
      painter->setOpacity(strong ? 1.0 : 0.45);
      icon(symbol).paint(painter, place, Qt::AlignCenter, mode);
    };
    painter->save();
    draw(visible ? Symbol::Eye : Symbol::EyeShut, eyeRect(option.rect), visible);
    draw(locked ? Symbol::Lock : Symbol::LockOpen, lockRect(option.rect), locked);
    painter->restore();
  }

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override
  {
    return QStyledItemDelegate::sizeHint(option, index).expandedTo({0, kIcon + 2});
  }
};

} // namespace

RegionList::RegionList(QWidget* parent) : QListWidget(parent)
{
  setItemDelegate(new RegionRow(this));
  setDragDropMode(QAbstractItemView::InternalMove);
  setDragDropOverwriteMode(false);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setTextElideMode(Qt::ElideRight);
  connect(this, &QListWidget::currentRowChanged, this, [this](int row) {
    if (!m_showing && row >= 0) emit chosen(row - 1);
  });
  connect(this, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
    if (!m_showing && row(item) > 0) emit enabledAsked(row(item) - 1, item->checkState() == Qt::Checked);
  });
}

void RegionList::show(const std::vector<Region>& regions, const QString& base, int chosen)
{
  m_showing = true;
  // Rows are kept where possible: this may run inside a signal of the row itself.
  const int rows = static_cast<int>(regions.size()) + 1;
  while (count() > rows) delete takeItem(count() - 1);
  while (count() < rows) addItem(QString());
  item(0)->setText(base);
  item(0)->setFlags(Qt::ItemIsSelectable | Qt::ItemIsEnabled);
  for (int row = 1; row < rows; ++row) fillRow(item(row), regions[static_cast<std::size_t>(row - 1)]);
  setCurrentRow(chosen + 1);
  viewport()->update(); // eyes and locks are not among the roles that a view looks at
  m_showing = false;
}

void RegionList::fillRow(QListWidgetItem* item, const Region& region)
{
  item->setFlags(Qt::ItemIsSelectable | Qt::ItemIsEnabled | Qt::ItemIsUserCheckable | Qt::ItemIsDragEnabled);
  item->setText(QString::fromStdString(region.name));
  item->setCheckState(region.enabled ? Qt::Checked : Qt::Unchecked);
  item->setData(kVisibleRole, region.visible);
  item->setData(kLockedRole, region.locked);
}

void RegionList::mousePressEvent(QMouseEvent* event)
{
  const QListWidgetItem* pressed = itemAt(event->pos());
  if (pressed == nullptr || row(pressed) == 0 || event->button() != Qt::LeftButton)
    return QListWidget::mousePressEvent(event);
  const QRect place = visualItemRect(pressed);
  if (eyeRect(place).contains(event->pos()))
    emit visibleAsked(row(pressed) - 1, !pressed->data(kVisibleRole).toBool());
  else if (lockRect(place).contains(event->pos()))
    emit lockAsked(row(pressed) - 1, !pressed->data(kLockedRole).toBool());
  else
    QListWidget::mousePressEvent(event);
}

void RegionList::dropEvent(QDropEvent* event)
{
  const int from = currentRow() - 1, last = count() - 2;
  const QModelIndex under = indexAt(event->position().toPoint());
  // Between rows: the place before the upper edge or after the lower one of the row under the mouse.
  int gap = under.isValid() ? under.row() : count();
  if (under.isValid() && event->position().y() > visualRect(under).center().y()) ++gap;
  int to = gap - 1; // the base tissue is row 0
  if (to > from) --to;
  event->setDropAction(Qt::IgnoreAction); // the row itself moves when the document says so
  event->accept();
  setState(QAbstractItemView::NoState);
  viewport()->update();
  to = qBound(0, to, last);
  if (from >= 0 && to != from) emit moveAsked(from, to);
}

} // namespace esm
