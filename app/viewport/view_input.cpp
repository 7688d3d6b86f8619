// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/viewport/view_input.h"

#include <QFocusEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <cmath>
#include <numbers>

namespace esm {

namespace {

constexpr double kKeyStep = 30.0;      ///< an arrow key turns like a drag of that many pixels
constexpr double kKeyZoom = 1.15;      ///< factor of one press of + or -
constexpr double kWheelZoom = 0.00125; ///< exponent per unit of wheel angle (an eighth of a degree)

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
  m_tool = tool;
  setHovered(kNoIndex);
  updateCursor();
  emit repaintNeeded();
}

void ViewInput::netReplaced()
{
  letGo();
  m_hovered = m_selected = kNoIndex;
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
      letGo(); // and the window may stop the device with the same key
      return false;
    }
    if (!wantsKey(*static_cast<QKeyEvent*>(event))) return false;
    event->accept();
    return true;
  case QEvent::Leave:
    setHovered(kNoIndex);
    return false;
  case QEvent::Hide:
    letGo();
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
  m_last = event.position();
  switch (event.button()) {
  case Qt::MiddleButton:
    m_drag = event.modifiers() & Qt::ShiftModifier ? Drag::Pan : Drag::Orbit;
    break;
  case Qt::RightButton:
    m_drag = Drag::Pan;
    break;
  case Qt::LeftButton: {
    m_drag = event.modifiers() & Qt::ShiftModifier ? Drag::Pan : Drag::Orbit;
    if (m_tool == Tool::Camera) break;
    const Index node = m_model->nodeAt(pixel(m_last));
    if (m_tool == Tool::Pull && node != kNoIndex) startPull(node, m_last);
    if (m_tool == Tool::Select && node != kNoIndex) {
      m_drag = Drag::None;
      m_selected = node;
      emit nodeSelected(node);
      emit repaintNeeded();
    }
    break;
  }
  default:
    m_drag = Drag::None;
    return false;
  }
  updateCursor();
  return true;
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
  }
  movedCamera();
  return true;
}

bool ViewInput::release(const QMouseEvent& event)
{
  if (event.button() != m_button) return true;
  letGo();
  m_drag = Drag::None;
  m_button = Qt::NoButton;
  updateCursor();
  return true;
}

bool ViewInput::wheel(const QWheelEvent& event)
{
  if (m_drag == Drag::Pull) return true; // the plane of the pull must stay under the mouse
  m_model->camera.zoomAt(pixel(event.position()), std::exp(-kWheelZoom * event.angleDelta().y()));
  movedCamera();
  return true;
}

bool ViewInput::wantsKey(const QKeyEvent& event) const
{
  if (event.modifiers() & ~(Qt::KeypadModifier | Qt::ShiftModifier)) return false;
  switch (event.key()) {
  case Qt::Key_Escape:
    return m_pulled != kNoIndex;
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
  if (event.key() == Qt::Key_Escape) {
    letGo();
    return true;
  }
  if (m_drag == Drag::Pull) return true;
  Camera& camera = m_model->camera;
  const Eigen::Vector2d middle(camera.width() / 2.0, camera.height() / 2.0);
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
  setHovered(m_tool == Tool::Camera ? kNoIndex : m_model->nodeAt(pixel(at)));
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
  if (m_drag != Drag::None)
    m_view->setCursor(Qt::ClosedHandCursor);
  else if (m_tool == Tool::Select)
    m_view->setCursor(m_hovered != kNoIndex ? Qt::PointingHandCursor : Qt::CrossCursor);
  else if (m_tool == Tool::Pull)
    m_view->setCursor(m_hovered != kNoIndex ? Qt::OpenHandCursor : Qt::ArrowCursor);
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
