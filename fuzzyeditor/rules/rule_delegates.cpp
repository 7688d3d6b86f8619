// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/rules/rule_delegates.h"

#include "fuzzyeditor/number_spin_box.h"
#include "fuzzyeditor/panel_colors.h"
#include "fuzzyeditor/rules/rule_table_model.h"

#include <QApplication>
#include <QLineEdit>
#include <QPainter>
#include <QTextLayout>

#include <algorithm>

namespace esm {
namespace {

/// Selection and hover as the style draws them, without the text.
QStyleOptionViewItem paintBackground(QPainter* painter, QStyleOptionViewItem option)
{
  option.text.clear();
  const QStyle* style = option.widget ? option.widget->style() : QApplication::style();
  style->drawControl(QStyle::CE_ItemViewItem, &option, painter, option.widget);
  return option;
}

} // namespace

void DegreeDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                           const QModelIndex& index) const
{
  QStyleOptionViewItem item = option;
  initStyleOption(&item, index);
  const QString text = item.text;
  paintBackground(painter, item);

  const double degree = std::clamp(index.data(m_role).toDouble(), 0.0, 1.0);
  const QRectF frame = QRectF(option.rect).adjusted(4.5, 2.5, -4.5, -2.5);
  const bool enabled = option.state & QStyle::State_Enabled;
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setPen(QPen(panel_colors::faint(option.palette), 1));
  painter->setBrush(option.palette.base());
  painter->drawRoundedRect(frame, 2, 2);
  if (degree > 0) {
    QRectF bar = frame.adjusted(0.5, 0.5, -0.5, -0.5);
    bar.setWidth(bar.width() * degree);
    painter->setPen(Qt::NoPen);
    painter->setBrush(panel_colors::bar(option.palette));
    painter->drawRoundedRect(bar, 2, 2);
  }
  painter->setPen(enabled ? item.palette.color(QPalette::Text)
                          : item.palette.color(QPalette::Disabled, QPalette::Text));
  painter->drawText(option.rect, Qt::AlignCenter, text);
  painter->restore();
}

QSize DegreeDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const
{
  const QSize size = QStyledItemDelegate::sizeHint(option, index);
  return {std::max(size.width(), 90), size.height() + 4};
}

void RuleTextDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                             const QModelIndex& index) const
{
  const QVariant mistake = index.data(RuleTableModel::MistakeRangeRole);
  if (!mistake.isValid()) {
    QStyledItemDelegate::paint(painter, option, index);
    return;
  }
  QStyleOptionViewItem item = option;
  initStyleOption(&item, index);
  const QString text = item.text;
  paintBackground(painter, item);

  const QPoint range = mistake.toPoint();
  QTextLayout layout(text, item.font);
  QTextLayout::FormatRange wave;
  wave.start = range.x();
  wave.length = std::max(range.y(), 1);
  wave.format.setUnderlineStyle(QTextCharFormat::WaveUnderline);
  wave.format.setUnderlineColor(panel_colors::mistake(option.palette));
  layout.setFormats({wave});
  layout.beginLayout();
  QTextLine line = layout.createLine();
  if (line.isValid()) line.setNumColumns(static_cast<int>(text.size()));
  layout.endLayout();
  const bool selected = option.state & QStyle::State_Selected;
  painter->save();
  painter->setClipRect(option.rect);
  painter->setPen(selected ? option.palette.color(QPalette::HighlightedText)
                           : panel_colors::mistake(option.palette));
  const double y = option.rect.top() + (option.rect.height() - layout.boundingRect().height()) / 2;
  layout.draw(painter, QPointF(option.rect.left() + 4, y));
  painter->restore();
}

QWidget* RuleTextDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                                        const QModelIndex& index) const
{
  QWidget* editor = QStyledItemDelegate::createEditor(parent, option, index);
  editor->setAccessibleName(index.model()->headerData(index.column(), Qt::Horizontal).toString());
  return editor;
}

QWidget* WeightDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&,
                                      const QModelIndex& index) const
{
  auto* spin = new NumberSpinBox(parent);
  spin->setRange(0.0, 1.0);
  spin->setSingleStep(0.1);
  spin->setFrame(false);
  spin->setNamesForAccess(index.model()->headerData(index.column(), Qt::Horizontal).toString());
  return spin;
}

void WeightDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const
{
  qobject_cast<NumberSpinBox*>(editor)->setValue(index.data(Qt::EditRole).toDouble());
}

void WeightDelegate::setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const
{
  auto* spin = qobject_cast<NumberSpinBox*>(editor);
  spin->interpretText();
  model->setData(index, spin->value());
}

} // namespace esm
