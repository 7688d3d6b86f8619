// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/viewport/scene_model.h"

#include <QObject>
#include <QPointF>

#include <optional>

class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace esm {

/// Mouse and keys of the preview: turns events of the view widget into camera moves, pulls and selections.
///
///     middle button            turn          Shift + middle, or right button   move sideways
///     wheel                    zoom to the cursor
///     left button              the tool: Camera turns; Pull takes the front-most node and drags it in the
///                              plane through it that is parallel to the screen; Select names it.
///                              Pull and Select beside the net turn the camera.
///     F fit · 1 front · 3 right · 7 top · 5 parallel projection · arrows turn · + - zoom · Esc lets go
///
/// Watches the widget by an event filter. Without a screen it works all the same. GUI thread.
class ViewInput : public QObject {
  Q_OBJECT
public:
  /// @param view whose events are used; @param model is changed (camera). Neither owned, both outlive this.
  ViewInput(QWidget* view, SceneModel* model);

  void setTool(Tool tool);
  Tool tool() const noexcept { return m_tool; }
  void netReplaced(); ///< lets go and forgets nodes: indices mean others now
  void letGo();       ///< ends a pull, if one is on

  // === For the overlay
  Index hoveredNode() const noexcept { return m_hovered; }
  Index selectedNode() const noexcept { return m_selected; }
  Index pulledNode() const noexcept { return m_pulled; }
  const Eigen::Vector3d& pullTarget() const noexcept { return m_target; } ///< [m], while pulledNode() is one
  bool keyboardFocus() const noexcept { return m_keyboardFocus; }

signals:
  void pullStarted(int node, double x, double y, double z);
  void pullMoved(double x, double y, double z);
  void pullEnded();
  void nodeSelected(int node);
  void cameraMoved();
  void repaintNeeded();

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  enum class Drag { None, Orbit, Pan, Pull };

  bool press(const QMouseEvent& event);
  bool move(const QMouseEvent& event);
  bool release(const QMouseEvent& event);
  bool wheel(const QWheelEvent& event);
  bool key(const QKeyEvent& event);
  bool wantsKey(const QKeyEvent& event) const;
  void startPull(Index node, const QPointF& at);
  void hover(const QPointF& at);
  void setHovered(Index node);
  void updateCursor();
  void movedCamera();

  QWidget* m_view;
  SceneModel* m_model;
  Tool m_tool = Tool::Camera;
  Drag m_drag = Drag::None;
  Qt::MouseButton m_button = Qt::NoButton; ///< that began the drag and will end it
  QPointF m_last;
  Index m_hovered = kNoIndex, m_selected = kNoIndex, m_pulled = kNoIndex;
  Eigen::Vector3d m_target = Eigen::Vector3d::Zero();
  Eigen::Vector3d m_plane = Eigen::Vector3d::Zero();      ///< a point of the plane of the pull [m]
  Eigen::Vector2d m_grabOffset = Eigen::Vector2d::Zero(); ///< from the mouse to the node [pixels]
  bool m_keyboardFocus = false;
};

} // namespace esm
