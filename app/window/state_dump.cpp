// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/state_dump.h"

#include "fuzzyeditor/plot_access.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QApplication>
#include <QClipboard>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPlainTextEdit>
#include <QSaveFile>
#include <QTabWidget>

#include <algorithm>
#include <optional>

namespace esm {

namespace {

const char* stabilityName(Stability stability)
{
  switch (stability) {
  case Stability::Good:
    return "good";
  case Stability::Implicit:
    return "implicit";
  case Stability::Rough:
    return "rough";
  case Stability::Slow:
    return "slow";
  case Stability::Stopped:
    return "stopped";
  case Stability::Idle:
    break;
  }
  return "idle";
}

QJsonArray vectorJson(const Eigen::Vector3d& v)
{
  return {v.x(), v.y(), v.z()};
}

QJsonObject documentJson(Document* document)
{
  const Project& project = document->project();
  QJsonObject json;
  json["modified"] = document->isModified();
  json["path"] = document->path();
  json["nodes"] = project.net.nodeCount();
  json["springs"] = project.net.springCount();
  json["meanStiffness"] = project.net.springCount() > 0 ? project.net.stiffness.mean() : 0.0;
  json["undoCount"] = document->undoStack()->count();
  json["undoIndex"] = document->undoStack()->index();
  json["springsDerived"] = document->lastApply().springsChanged;
  json["undoText"] = document->undoStack()->undoText();
  json["ruleCount"] = static_cast<int>(project.tissue.rules.rules.size());
  json["target"] = document->inputTarget();
  QJsonObject inputs;
  for (std::size_t i = 0; i < document->inputs().size(); ++i) {
    const fuzzy::Variable& variable = project.tissue.rules.inputs[i];
    inputs[QString::fromStdString(variable.id)] =
      QString::fromStdString(formatInput(document->inputs()[i], variable, Language::English));
  }
  json["inputs"] = inputs;
  QJsonArray rules, regions;
  for (const fuzzy::Rule& rule : project.tissue.rules.rules)
    rules.append(QString::fromStdString(formatRule(rule, project.tissue.rules, Language::English)));
  for (const Region& region : project.tissue.regions) {
    QJsonObject entry{{"name", QString::fromStdString(region.name)}, {"enabled", region.enabled}};
    entry["centre"] = vectorJson(region.ellipsoid.centre);
    entry["semiAxes"] = vectorJson(region.ellipsoid.semiAxes);
    entry["falloff"] = region.falloff;
    entry["insideOut"] = region.insideOut;
    entry["locked"] = region.locked;
    regions.append(entry);
  }
  json["rules"] = rules;
  json["regions"] = regions;
  return json;
}

void addRun(QJsonObject& json, SimulationController* run)
{
  const SimSnapshot& snapshot = run->snapshot();
  json["playing"] = snapshot.playing;
  json["time"] = snapshot.time;
  json["realTimeFactor"] = snapshot.realTimeFactor;
  json["lag"] = snapshot.lag;
  json["toolForce"] = vectorJson(snapshot.toolForce);
  json["forceNorm"] = snapshot.toolForce.norm();
  json["grabbedNode"] = snapshot.grabbedNode;
  json["stability"] = stabilityName(snapshot.stability);
  json["rung"] = static_cast<int>(snapshot.quality.rung);
  json["tolerance"] = snapshot.quality.tolerance;
  json["toldError"] = snapshot.toldError;
  json["nodesAwake"] = static_cast<double>(snapshot.report.nodesAwake);
  json["solver"] = QString::fromStdString(snapshot.solver);
  json["message"] = QString::fromStdString(snapshot.message);
  const HapticStatus device = run->hapticStatus();
  json["device"] = QJsonObject{{"name", QString::fromStdString(device.device)},
                               {"attached", QString::fromStdString(run->deviceName())},
                               {"state", static_cast<int>(device.state)},
                               {"phase", static_cast<int>(run->deviceReport().phase)},
                               {"reason", QString::fromStdString(device.reason)},
                               {"limit", device.forceLimit},
                               {"ticks", static_cast<double>(device.ticks)},
                               {"position", vectorJson(device.position)},
                               {"rate", device.rate},
                               {"force", device.force.norm()}};
}

/// The pixel of the screen nearest the middle of the view for which `placeAt` finds a place to click.
template <class PlaceAt>
QJsonArray nearMiddle(SceneView* view, PlaceAt placeAt)
{
  const QPointF middle(0.5 * view->width(), 0.5 * view->height());
  for (int ring = 0; ring < 40; ++ring)
    for (const QPointF& way : {QPointF(0, -8), QPointF(8, 0), QPointF(0, 8), QPointF(-8, 0)})
      if (const std::optional<QPointF> found = placeAt(middle + ring * way)) {
        const QPoint place = view->mapToGlobal(found->toPoint());
        return {place.x(), place.y()};
      }
  return {};
}

/// Where the pull tool meets a node.
QJsonArray pullPoint(SceneView* view, const SimSnapshot& snapshot)
{
  return nearMiddle(view, [&](const QPointF& pixel) -> std::optional<QPointF> {
    const Index node = view->nodeAt(pixel);
    if (node == kNoIndex || node >= snapshot.position.cols()) return std::nullopt;
    return view->project(snapshot.position.col(node));
  });
}

/// Where the tool Select meets a spring.
QJsonArray springPoint(SceneView* view, const SpringNet& net, const SimSnapshot& snapshot)
{
  return nearMiddle(view, [&](const QPointF& pixel) -> std::optional<QPointF> {
    const Index spring = view->springAt(pixel);
    if (spring == kNoIndex || spring >= net.springCount() || snapshot.position.cols() != net.nodeCount())
      return std::nullopt;
    const QPointF middle = view->project(
      0.5 * (snapshot.position.col(net.ends(0, spring)) + snapshot.position.col(net.ends(1, spring))));
    if (view->springAt(middle.toPoint()) != spring) return std::nullopt;
    return middle;
  });
}

/// Handles of the gizmo by name, as pixels of the screen.
QJsonObject gizmoJson(const SceneView* view)
{
  QJsonObject places;
  const QMap<QString, QPointF> handles = view->gizmoHandles();
  for (auto handle = handles.begin(); handle != handles.end(); ++handle) {
    const QPoint pixel = view->mapToGlobal(handle.value().toPoint());
    places[handle.key()] = QJsonArray{pixel.x(), pixel.y()};
  }
  return places;
}

QJsonArray placeOf(const QWidget* widget, const QRect& part)
{
  const QPoint corner = widget->mapToGlobal(part.topLeft());
  return {corner.x(), corner.y(), part.width(), part.height()};
}

/// The first rows of a table or list as they are read.
QJsonArray rowsOf(const QAbstractItemModel* model)
{
  constexpr int kMostRows = 60;
  QJsonArray rows;
  for (int row = 0; row < std::min(model->rowCount(), kMostRows); ++row) {
    QJsonArray cells;
    for (int column = 0; column < model->columnCount(); ++column)
      cells.append(model->index(row, column).data().toString());
    rows.append(cells);
  }
  return rows;
}

void addVisibleWidgets(QJsonObject& json)
{
  QJsonObject places, texts, items, views;
  QJsonArray enabled;
  for (QWidget* widget : QApplication::allWidgets()) {
    const QString name = widget->objectName();
    if (name.isEmpty() || name.startsWith(QLatin1String("qt_")) || widget->visibleRegion().isEmpty())
      continue;
    places[name] = placeOf(widget, widget->rect());
    if (qobject_cast<QAbstractButton*>(widget) && widget->isEnabled()) enabled.append(name);
    if (const auto* view = qobject_cast<SceneView*>(widget)) {
      const ViewSettings camera = view->viewSettings();
      views[name] = QJsonObject{{"target", vectorJson(camera.target)},
                                {"distance", camera.distance},
                                {"marks", static_cast<int>(view->marks().cols())},
                                {"instrument", view->instrument().visible},
                                {"tip", vectorJson(view->instrument().tip)},
                                {"touches", view->instrument().touches}};
    }
    if (const auto* tabs = qobject_cast<QTabWidget*>(widget))
      for (int i = 0; i < tabs->count(); ++i)
        places[name + QString::number(i)] = placeOf(tabs->tabBar(), tabs->tabBar()->tabRect(i));
    if (const auto* label = qobject_cast<QLabel*>(widget)) texts[name] = label->text();
    if (const auto* line = qobject_cast<QLineEdit*>(widget)) texts[name] = line->text();
    if (const auto* text = qobject_cast<QPlainTextEdit*>(widget)) texts[name] = text->toPlainText();
    if (const auto* view = qobject_cast<QAbstractItemView*>(widget); view && view->model())
      items[name] = rowsOf(view->model());
  }
  json["widgets"] = places;
  json["texts"] = texts;
  json["items"] = items;
  json["enabled"] = enabled;
  json["views"] = views;
}

/// Movable points of the plots that can be seen: [name, x, y on the screen, value].
QJsonObject plotPoints()
{
  QJsonObject plots;
  for (QWidget* widget : QApplication::allWidgets()) {
    const auto* plot = dynamic_cast<const PointedPlot*>(widget);
    if (!plot || widget->visibleRegion().isEmpty()) continue;
    QJsonArray points;
    for (int i = 0; i < plot->pointCount(); ++i) {
      const PlotPoint point = plot->point(i);
      const QPoint place = widget->mapToGlobal(point.place.center());
      points.append(QJsonArray{point.name, place.x(), place.y(), point.value});
    }
    plots[widget->objectName()] = points;
  }
  return plots;
}

} // namespace

StateDump::StateDump(MainWindow* window, const QString& file)
  : QObject(window), m_window(window), m_file(file)
{
  connect(&m_timer, &QTimer::timeout, this, &StateDump::write);
  m_timer.start(500);
}

void StateDump::write()
{
  QJsonObject json = documentJson(m_window->document());
  addRun(json, m_window->controller());
  json["selectedNode"] = m_window->selectedNode();
  json["selectedNodes"] = static_cast<int>(m_window->sceneView()->selection().size());
  json["gizmo"] = gizmoJson(m_window->sceneView());
  json["legend"] = m_window->sceneView()->legendTitle();
  json["selectedSpring"] = m_window->selectedSpring();
  if (const auto* sentence = m_window->findChild<QLabel*>("whySentence")) json["why"] = sentence->text();
  json["clipboard"] = QApplication::clipboard()->text();
  json["title"] = m_window->windowTitle();
  json["language"] = QLocale().name().left(2);
  json["pullPoint"] = pullPoint(m_window->sceneView(), m_window->controller()->snapshot());
  json["springPoint"] = springPoint(m_window->sceneView(), m_window->document()->project().net,
                                    m_window->controller()->snapshot());
  json["openGl"] = m_window->sceneView()->hasOpenGl();
  const QWidget* modal = QApplication::activeModalWidget();
  json["dialog"] =
    modal != nullptr
      ? (modal->objectName().isEmpty() ? QString(modal->metaObject()->className()) : modal->objectName())
      : QString();
  addVisibleWidgets(json);
  json["points"] = plotPoints();
  QSaveFile file(m_file);
  if (!file.open(QIODevice::WriteOnly)) return;
  file.write(QJsonDocument(json).toJson());
  file.commit();
}

} // namespace esm
