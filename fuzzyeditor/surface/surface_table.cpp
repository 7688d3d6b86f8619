// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/surface/surface_table.h"

#include "fuzzyeditor/fuzzy_evaluation.h"
#include "fuzzyeditor/rules/rule_display.h"
#include "fuzzyeditor/surface/surface_source.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace esm {

SurfaceTableModel::SurfaceTableModel(SurfaceSource* source, QObject* parent)
  : QAbstractTableModel(parent), m_source(source)
{}

void SurfaceTableModel::reload()
{
  const fuzzy::ControlSurface* surface = m_source->surface();
  beginResetModel();
  m_rows = surface ? static_cast<int>(surface->value.size()) : 0;
  endResetModel();
}

int SurfaceTableModel::rowCount(const QModelIndex& parent) const
{
  return parent.isValid() ? 0 : m_rows;
}

double SurfaceTableModel::value(int row, int column) const
{
  const fuzzy::ControlSurface* surface = m_source->surface();
  const auto place = static_cast<std::size_t>(row);
  if (!surface || row < 0 || place >= surface->value.size()) return std::nan("");
  const auto shown = [](double plain, const fuzzy::Variable& v) {
    return plain / RuleDisplay::displayUnit(v.unit).factor;
  };
  if (column == 0) return shown(surface->x[place % surface->columns()], *m_source->inputX());
  if (column == 1) return shown(surface->y[place / surface->columns()], *m_source->inputY());
  return surface->fired[place] ? shown(surface->value[place], *m_source->output()) : std::nan("");
}

QString SurfaceTableModel::title(int column) const
{
  const fuzzy::Variable* v = column == 0   ? m_source->inputX()
                             : column == 1 ? m_source->inputY()
                                           : m_source->output();
  if (!v) return {};
  const QString name = RuleDisplay::title(*v, m_source->evaluation()->document()->ruleLanguage());
  const DisplayUnit unit = RuleDisplay::displayUnit(v->unit);
  return unit.symbol.isEmpty() ? name : QStringLiteral("%1 [%2]").arg(name, unit.symbol);
}

QVariant SurfaceTableModel::data(const QModelIndex& index, int role) const
{
  if (role == Qt::TextAlignmentRole) return QVariant(Qt::AlignRight | Qt::AlignVCenter);
  if (role != Qt::DisplayRole || !index.isValid()) return {};
  return RuleDisplay::number(value(index.row(), index.column()), QLocale());
}

QVariant SurfaceTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
  if (role != Qt::DisplayRole) return {};
  return orientation == Qt::Horizontal ? QVariant(title(section)) : QVariant(section + 1);
}

QString SurfaceTableModel::csv(const QList<int>& rows) const
{
  const auto quoted = [](QString text) { return '"' + text.replace('"', "\"\"") + '"'; };
  QString text = QStringLiteral("%1,%2,%3\n").arg(quoted(title(0)), quoted(title(1)), quoted(title(2)));
  const auto append = [&](int row) {
    for (int column = 0; column < 3; ++column) {
      const double number = value(row, column);
      if (!std::isnan(number)) text += QLocale::c().toString(number, 'g', 12);
      text += column < 2 ? ',' : '\n';
    }
  };
  if (rows.isEmpty())
    for (int row = 0; row < m_rows; ++row) append(row);
  else
    for (const int row : rows) append(row);
  return text;
}

SurfaceTable::SurfaceTable(SurfaceSource* source, QWidget* parent)
  : QWidget(parent),
    m_model(new SurfaceTableModel(source, this)),
    m_view(new QTableView),
    m_copy(new QPushButton)
{
  m_view->setObjectName("surfaceTable");
  m_copy->setObjectName("surfaceCopy");
  m_view->setModel(m_model);
  m_view->setSelectionBehavior(QAbstractItemView::SelectRows);
  m_view->setTabKeyNavigation(false);
  m_view->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  m_view->verticalHeader()->hide();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(2, 2, 2, 2);
  layout->addWidget(m_view, 1);
  layout->addWidget(m_copy, 0, Qt::AlignRight);
  connect(m_copy, &QPushButton::clicked, this, [this] { copy(false); });
  const auto reload = [this] {
    if (isVisible()) m_model->reload();
  };
  connect(source, &SurfaceSource::changed, this, reload);
  connect(source->evaluation()->document(), &FuzzyDocument::ruleLanguageChanged, this, reload);
  retranslate();
}

void SurfaceTable::copy(bool chosenOnly)
{
  QList<int> rows;
  if (chosenOnly)
    for (const QModelIndex& index : m_view->selectionModel()->selectedRows()) rows << index.row();
  std::sort(rows.begin(), rows.end());
  QGuiApplication::clipboard()->setText(m_model->csv(rows));
}

void SurfaceTable::showEvent(QShowEvent* event)
{
  QWidget::showEvent(event);
  m_model->reload();
}

void SurfaceTable::keyPressEvent(QKeyEvent* event)
{
  if (event->matches(QKeySequence::Copy))
    copy(true);
  else
    QWidget::keyPressEvent(event);
}

void SurfaceTable::retranslate()
{
  m_view->setAccessibleName(tr("Results over both inputs"));
  m_copy->setText(tr("Copy as CSV"));
  m_copy->setAccessibleName(tr("Copy the table as CSV"));
  if (isVisible()) m_model->reload();
}

void SurfaceTable::changeEvent(QEvent* event)
{
  QWidget::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) retranslate();
}

} // namespace esm
