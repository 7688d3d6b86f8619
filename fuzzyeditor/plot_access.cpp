// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/plot_access.h"

#include <QAccessible>
#include <QAccessibleWidget>
#include <QWidget>

#include <vector>

namespace esm {

namespace {

class PlotAccess;

class PointAccess : public QAccessibleInterface, public QAccessibleValueInterface {
public:
  PointAccess(PlotAccess* plot, int index) : m_plot(plot), m_index(index) {}

  bool isValid() const override;
  QObject* object() const override { return nullptr; }
  QAccessibleInterface* childAt(int, int) const override { return nullptr; }
  QAccessibleInterface* parent() const override;
  QAccessibleInterface* child(int) const override { return nullptr; }
  int childCount() const override { return 0; }
  int indexOfChild(const QAccessibleInterface*) const override { return -1; }
  QString text(QAccessible::Text kind) const override;
  void setText(QAccessible::Text, const QString&) override {}
  QRect rect() const override;
  QAccessible::Role role() const override { return QAccessible::Slider; }
  QAccessible::State state() const override;
  void* interface_cast(QAccessible::InterfaceType type) override
  {
    return type == QAccessible::ValueInterface ? static_cast<QAccessibleValueInterface*>(this) : nullptr;
  }

  QVariant currentValue() const override { return point().value; }
  void setCurrentValue(const QVariant& value) override;
  QVariant maximumValue() const override { return point().greatest; }
  QVariant minimumValue() const override { return point().least; }
  QVariant minimumStepSize() const override { return point().step; }

private:
  PlotPoint point() const;
  PlotAccess* m_plot;
  int m_index;
};

/// The plot itself, with one child for each point; children are made when they are asked for.
class PlotAccess : public QAccessibleWidget {
public:
  PlotAccess(QWidget* widget, PointedPlot* plot)
    : QAccessibleWidget(widget, QAccessible::Chart), m_points(plot)
  {}
  ~PlotAccess() override
  {
    for (const QAccessible::Id id : m_children) QAccessible::deleteAccessibleInterface(id);
  }

  PointedPlot* points() const { return m_points; }
  int childCount() const override { return isValid() ? m_points->pointCount() : 0; }
  QAccessibleInterface* child(int index) const override
  {
    if (index < 0 || index >= childCount()) return nullptr;
    while (m_children.size() <= static_cast<std::size_t>(index))
      m_children.push_back(QAccessible::registerAccessibleInterface(
        new PointAccess(const_cast<PlotAccess*>(this), static_cast<int>(m_children.size()))));
    return QAccessible::accessibleInterface(m_children[static_cast<std::size_t>(index)]);
  }
  int indexOfChild(const QAccessibleInterface* wanted) const override
  {
    for (int i = 0; i < childCount(); ++i)
      if (child(i) == wanted) return i;
    return -1;
  }
  QAccessibleInterface* childAt(int x, int y) const override
  {
    for (int i = 0; i < childCount(); ++i)
      if (child(i)->rect().contains(x, y)) return child(i);
    return nullptr;
  }
  QAccessibleInterface* focusChild() const override
  {
    for (int i = 0; i < childCount(); ++i)
      if (m_points->point(i).focused) return child(i);
    return nullptr;
  }

private:
  PointedPlot* m_points;
  mutable std::vector<QAccessible::Id> m_children;
};

bool PointAccess::isValid() const
{
  return m_plot->isValid() && m_index < m_plot->childCount();
}

PlotPoint PointAccess::point() const
{
  return isValid() ? m_plot->points()->point(m_index) : PlotPoint{};
}

QAccessibleInterface* PointAccess::parent() const
{
  return m_plot;
}

QString PointAccess::text(QAccessible::Text kind) const
{
  if (kind == QAccessible::Name) return point().name;
  return kind == QAccessible::Value ? point().valueText : QString();
}

QRect PointAccess::rect() const
{
  if (!isValid()) return {};
  const QRect place = point().place;
  return {m_plot->rect().topLeft() + place.topLeft(), place.size()};
}

QAccessible::State PointAccess::state() const
{
  QAccessible::State state;
  if (!isValid()) {
    state.invalid = true;
    return state;
  }
  const QAccessible::State plot = m_plot->state();
  state.invisible = plot.invisible;
  state.offscreen = plot.offscreen;
  state.disabled = plot.disabled;
  state.focusable = true;
  state.focused = point().focused;
  return state;
}

void PointAccess::setCurrentValue(const QVariant& value)
{
  bool isNumber = false;
  const double number = value.toDouble(&isNumber);
  if (isValid() && isNumber) m_plot->points()->setPoint(m_index, number);
}

QAccessibleInterface* makeAccess(const QString&, QObject* object)
{
  auto* plot = dynamic_cast<PointedPlot*>(object);
  return plot && object->isWidgetType() ? new PlotAccess(static_cast<QWidget*>(object), plot) : nullptr;
}

} // namespace

void installPlotAccess()
{
  static const bool installed = [] {
    QAccessible::installFactory(makeAccess);
    return true;
  }();
  Q_UNUSED(installed);
}

void announcePlotPoint(QWidget* plot, int index, bool focus)
{
  if (!QAccessible::isActive()) return;
  QAccessibleInterface* access = QAccessible::queryAccessibleInterface(plot);
  QAccessibleInterface* point = access ? access->child(index) : nullptr;
  if (!point) return;
  if (focus) {
    QAccessibleEvent event(point, QAccessible::Focus);
    QAccessible::updateAccessibility(&event);
  } else {
    QAccessibleValueChangeEvent event(point, point->valueInterface()->currentValue());
    QAccessible::updateAccessibility(&event);
  }
}

} // namespace esm
