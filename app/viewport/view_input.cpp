// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/viewport/view_input.h"

#include <QFocusEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace esm {

namespace {

constexpr double kKeyStep = 30.0;      ///< an arrow key turns like a drag of that many pixels
constexpr double kKeyZoom = 1.15;      ///< factor of one press of + or -
constexpr double kWheelZoom = 0.00125; ///< exponent per unit of wheel angle (an eighth of a degree)
constexpr double kClick = 4.0;         ///< a press that moves less is a click [pixels]

Eigen::Vector2d pixel(const QPointF& at)
{
  return {at.x(), at.y()};
}

} // namespace

ViewInput::ViewInput(QWidget* view, SceneModel* model) : QObject(view), m_view(view), m_model(model)
{
  m_view->installEventFilter(this);
  m_view->setMouseTracking(true);
  updateCursor();
}

void ViewInput::setTool(Tool tool)
{
  if (tool == m_tool) return;
  letGo();
  endDrag();
  m_tool = tool;
  setHovered(kNoIndex);
  setHoveredHandle({});
  updateCursor();
  emit repaintNeeded();
}

void ViewInput::netReplaced()
{
  letGo();
  endDrag();
  m_hovered = m_selected = m_selectedSpring = kNoIndex;
}

void ViewInput::regionsReplaced()
{
  const bool same = m_model->selectedRegion() == m_gizmoRegion && m_model->gizmoRegion() != nullptr;
  if (m_drag == Drag::Region && !same) endDrag();
}

void ViewInput::letGo()
{
  if (m_pulled == kNoIndex) return;
  m_pulled = kNoIndex;
  m_drag = Drag::None;
  m_button = Qt::NoButton;
  updateCursor();
  emit pullEnded();
  emit repaintNeeded();
}

void ViewInput::endDrag()
{
  m_gizmo.reset();
  m_drag = Drag::None;
  m_button = Qt::NoButton;
  updateCursor();
  emit repaintNeeded();
}

/// What Esc does.
void ViewInput::cancel()
{
  if (m_drag == Drag::Region) {
    const GizmoShape before = m_gizmo->start();
    endDrag();
    emit regionDragged(before);
  } else if (m_drag == Drag::Box) {
    endDrag();
  } else if (m_pulled != kNoIndex) {
    letGo();
  } else {
    select({});
  }
}

bool ViewInput::eventFilter(QObject* watched, QEvent* event)
{
  if (watched != m_view) return false;
  switch (event->type()) {
  case QEvent::MouseButtonPress:
    return press(*static_cast<QMouseEvent*>(event));
  case QEvent::MouseMove:
    return move(*static_cast<QMouseEvent*>(event));
  case QEvent::MouseButtonRelease:
    return release(*static_cast<QMouseEvent*>(event));
  case QEvent::Wheel:
    return wheel(*static_cast<QWheelEvent*>(event));
  case QEvent::KeyPress:
    return key(*static_cast<QKeyEvent*>(event));
  case QEvent::ShortcutOverride: // our keys come to us and not to a shortcut of the window
    if (static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
      cancel(); // and the window may stop the device with the same key
      return false;
    }
    if (!wantsKey(*static_cast<QKeyEvent*>(event))) return false;
    event->accept();
    return true;
  case QEvent::Leave:
    setHovered(kNoIndex);
    if (m_drag != Drag::Region) setHoveredHandle({});
    return false;
  case QEvent::Hide:
  case QEvent::WindowBlocked: // by a dialog, which gets the release of the button in our place
  case QEvent::UngrabMouse:
    letGo();
    endDrag();
    return false;
  case QEvent::FocusIn: {
    const auto reason = static_cast<QFocusEvent*>(event)->reason();
    m_keyboardFocus =
      reason == Qt::TabFocusReason || reason == Qt::BacktabFocusReason || reason == Qt::ShortcutFocusReason;
    emit repaintNeeded();
    return false;
  }
  case QEvent::FocusOut:
    if (m_keyboardFocus) emit repaintNeeded();
    m_keyboardFocus = false;
    return false;
  default:
    return false;
  }
}

bool ViewInput::press(const QMouseEvent& event)
{
  if (m_drag != Drag::None) return true; // a second button during a drag changes nothing
  m_button = event.button();
  m_last = m_pressed = event.position();
  switch (event.button()) {
  case Qt::MiddleButton:
    m_drag = event.modifiers() & Qt::ShiftModifier ? Drag::Pan : Drag::Orbit;
    break;
  case Qt::RightButton:
    m_drag = Drag::Pan;
    break;
  case Qt::LeftButton:
    pressWithTool(event);
    break;
  default:
    m_drag = Drag::None;
    return false;
  }
  updateCursor();
  return true;
}

void ViewInput::pressWithTool(const QMouseEvent& event)
{
  m_drag = event.modifiers() & Qt::ShiftModifier ? Drag::Pan : Drag::Orbit;
  if (m_tool == Tool::Pull) {
    if (const Index node = m_model->nodeAt(pixel(m_last)); node != kNoIndex) startPull(node, m_last);
  } else if (m_tool == Tool::Region) {
    startRegionDrag(m_last);
  } else if (m_tool == Tool::Select) {
    m_drag = Drag::Box;
    if (event.modifiers() & (Qt::ShiftModifier | Qt::ControlModifier)) return;
    const Index spring = m_model->springAt(pixel(m_last));
    const Index node = spring == kNoIndex ? m_model->nodeAt(pixel(m_last)) : kNoIndex;
    if (spring == kNoIndex && node == kNoIndex) return;
    m_selected = node;
    m_selectedSpring = spring;
    if (spring == kNoIndex)
      emit nodeSelected(node);
    else
      emit springSelected(spring);
    emit repaintNeeded();
  }
}

bool ViewInput::startRegionDrag(const QPointF& at)
{
  const GizmoHandle handle = handleAt(at);
  if (!handle) return false;
  const Region& region = *m_model->gizmoRegion();
  m_drag = Drag::Region;
  m_gizmoRegion = m_model->selectedRegion();
  m_gizmo.emplace(m_model->camera, handle, GizmoShape{region.ellipsoid, region.falloff}, pixel(at));
  setHoveredHandle(handle);
  emit regionDragStarted();
  emit repaintNeeded();
  return true;
}

GizmoHandle ViewInput::handleAt(const QPointF& at) const
{
  const Region* region = m_model->gizmoRegion();
  if (region == nullptr || m_tool != Tool::Region) return {};
  return esm::handleAt(layoutGizmo(m_model->camera, {region->ellipsoid, region->falloff}), pixel(at));
}

std::optional<Eigen::AlignedBox2d> ViewInput::selectionBox() const
{
  const Eigen::Vector2d from = pixel(m_pressed), to = pixel(m_last);
  if (m_drag != Drag::Box || (to - from).norm() < kClick) return std::nullopt;
  return Eigen::AlignedBox2d(from.cwiseMin(to), from.cwiseMax(to));
}

/// A click is a box with one node in it, or none.
void ViewInput::finishBox(Qt::KeyboardModifiers modifiers)
{
  std::vector<Index> nodes;
  if (const auto box = selectionBox())
    nodes = m_model->nodesIn(*box);
  else if (const Index node = m_model->nodeAt(pixel(m_last));
           node != kNoIndex && m_model->springAt(pixel(m_last)) == kNoIndex)
    nodes = {node};
  const std::vector<Index>& before = m_model->selection();
  if (modifiers & Qt::ControlModifier) {
    std::vector<Index> rest;
    std::set_difference(before.begin(), before.end(), nodes.begin(), nodes.end(), std::back_inserter(rest));
    nodes = std::move(rest);
  } else if (modifiers & Qt::ShiftModifier) {
    nodes.insert(nodes.end(), before.begin(), before.end());
  }
  select(std::move(nodes));
}

void ViewInput::select(std::vector<Index> nodes)
{
  if (!m_model->setSelection(std::move(nodes))) return;
  emit selectionChanged();
  emit repaintNeeded();
}

void ViewInput::startPull(Index node, const QPointF& at)
{
  m_drag = Drag::Pull;
  m_pulled = node;
  m_target = m_plane = m_model->position().col(node);
  m_grabOffset = m_model->camera.project(m_plane).pixel - pixel(at); // no jump when the drag begins
  setHovered(kNoIndex);
  emit pullStarted(node, m_target.x(), m_target.y(), m_target.z());
  emit repaintNeeded();
}

bool ViewInput::move(const QMouseEvent& event)
{
  if (m_drag != Drag::None && !(event.buttons() & m_button)) { // the release went elsewhere
    letGo();
    endDrag();
  }
  const QPointF delta = event.position() - m_last;
  m_last = event.position();
  switch (m_drag) {
  case Drag::None:
    hover(m_last);
    return false;
  case Drag::Orbit:
    m_model->camera.orbit(delta.x(), delta.y());
    break;
  case Drag::Pan:
    m_model->camera.pan(delta.x(), delta.y());
    break;
  case Drag::Pull:
    m_target = m_model->camera.onPlane(pixel(m_last) + m_grabOffset, m_plane);
    emit pullMoved(m_target.x(), m_target.y(), m_target.z());
    emit repaintNeeded();
    return true;
  case Drag::Box:
    emit repaintNeeded();
    return true;
  case Drag::Region:
    emit regionDragged(m_gizmo->to(pixel(m_last), event.modifiers() & Qt::ShiftModifier));
    emit repaintNeeded();
    return true;
  }
  movedCamera();
  return true;
}

bool ViewInput::release(const QMouseEvent& event)
{
  if (event.button() != m_button) return true;
  letGo();
  if (m_drag == Drag::Box) finishBox(event.modifiers());
  endDrag();
  return true;
}

bool ViewInput::wheel(const QWheelEvent& event)
{
  if (m_drag != Drag::None && m_drag != Drag::Orbit && m_drag != Drag::Pan)
    return true; // what is dragged must stay under the mouse
  m_model->camera.zoomAt(pixel(event.position()), std::exp(-kWheelZoom * event.angleDelta().y()));
  movedCamera();
  return true;
}

bool ViewInput::wantsKey(const QKeyEvent& event) const
{
  if (event.modifiers() & ~(Qt::KeypadModifier | Qt::ShiftModifier)) return false;
  switch (event.key()) {
  case Qt::Key_F:
  case Qt::Key_1:
  case Qt::Key_3:
  case Qt::Key_5:
  case Qt::Key_7:
  case Qt::Key_Left:
  case Qt::Key_Right:
  case Qt::Key_Up:
  case Qt::Key_Down:
  case Qt::Key_Plus:
  case Qt::Key_Minus:
    return true;
  default:
    return false;
  }
}

bool ViewInput::key(const QKeyEvent& event)
{
  if (!wantsKey(event)) return false;
  if (m_drag == Drag::Pull || m_drag == Drag::Region) return true;
  Camera& camera = m_model->camera;
  const Eigen::Vector2d middle = camera.middle();
  switch (event.key()) {
  case Qt::Key_F:
    m_model->fit();
    break;
  case Qt::Key_1:
    camera.setDirection(0.0, 0.0);
    break;
  case Qt::Key_3:
    camera.setDirection(std::numbers::pi / 2.0, 0.0);
    break;
  case Qt::Key_7:
    camera.setDirection(0.0, std::numbers::pi / 2.0);
    break;
  case Qt::Key_5:
    camera.setOrthographic(!camera.orthographic());
    break;
  case Qt::Key_Left:
    camera.orbit(-kKeyStep, 0.0);
    break;
  case Qt::Key_Right:
    camera.orbit(kKeyStep, 0.0);
    break;
  case Qt::Key_Up:
    camera.orbit(0.0, -kKeyStep);
    break;
  case Qt::Key_Down:
    camera.orbit(0.0, kKeyStep);
    break;
  case Qt::Key_Plus:
    camera.zoomAt(middle, 1.0 / kKeyZoom);
    break;
  case Qt::Key_Minus:
    camera.zoomAt(middle, kKeyZoom);
    break;
  default:
    break;
  }
  if (event.key() == Qt::Key_F) {
    emit cameraMoved();
    emit repaintNeeded();
  } else {
    movedCamera();
  }
  return true;
}

void ViewInput::hover(const QPointF& at)
{
  const bool takesNodes = m_tool == Tool::Pull || m_tool == Tool::Select;
  setHovered(takesNodes ? m_model->nodeAt(pixel(at)) : kNoIndex);
  setHoveredHandle(handleAt(at));
}

void ViewInput::setHoveredHandle(const GizmoHandle& handle)
{
  if (handle == m_handle) return;
  m_handle = handle;
  updateCursor();
  emit repaintNeeded();
}

void ViewInput::setHovered(Index node)
{
  if (node == m_hovered) return;
  m_hovered = node;
  updateCursor();
  emit repaintNeeded();
}

void ViewInput::updateCursor()
{
  if (m_drag != Drag::None && m_drag != Drag::Box)
    m_view->setCursor(Qt::ClosedHandCursor);
  else if (m_tool == Tool::Select)
    m_view->setCursor(m_hovered != kNoIndex ? Qt::PointingHandCursor : Qt::CrossCursor);
  else if (m_tool == Tool::Pull || m_tool == Tool::Region)
    m_view->setCursor(m_hovered != kNoIndex || m_handle ? Qt::OpenHandCursor : Qt::ArrowCursor);
  else
    m_view->setCursor(Qt::ArrowCursor);
}

void ViewInput::movedCamera()
{
  m_model->cameraMoved();
  emit cameraMoved();
  emit repaintNeeded();
}

} // namespace esm
