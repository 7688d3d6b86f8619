// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/viewport/region_gizmo.h"
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
///                              plane through it that is parallel to the screen; Region drags a handle of
///                              the chosen region's gizmo. Pull and Region beside them turn the camera.
///                              Select names the front-most node, or the spring whose middle is nearer; a
///                              drag selects the visible nodes in its box, with Shift these too, with Ctrl
///                              without these.
///     Esc                      lets go; takes back the drag of a region; else selects no node
///     F fit · 1 front · 3 right · 7 top · 5 parallel projection · arrows turn · + - zoom
///
/// Watches the widget by an event filter. Without a screen it works all the same. GUI thread.
class ViewInput : public QObject {
  Q_OBJECT
public:
  /// @param view whose events are used; @param model is changed (camera). Neither owned, both outlive this.
  ViewInput(QWidget* view, SceneModel* model);

  void setTool(Tool tool);
  Tool tool() const noexcept { return m_tool; }
  void netReplaced();     ///< lets go and forgets nodes: indices mean others now
  void letGo();           ///< ends a pull, if one is on
  void regionsReplaced(); ///< ends the drag of a region that is not the gizmo's any more

  // === For the overlay
  Index hoveredNode() const noexcept { return m_hovered; }
  Index selectedNode() const noexcept { return m_selected; }
  Index selectedSpring() const noexcept { return m_selectedSpring; }
  Index pulledNode() const noexcept { return m_pulled; }
  const Eigen::Vector3d& pullTarget() const noexcept { return m_target; } ///< [m], while pulledNode() is one
  GizmoHandle hoveredHandle() const noexcept { return m_handle; }         ///< under the mouse or dragged
  const GizmoDrag* gizmoDrag() const noexcept { return m_gizmo ? &*m_gizmo : nullptr; }
  std::optional<Eigen::AlignedBox2d> selectionBox() const; ///< while it is drawn [logical pixels]
  bool keyboardFocus() const noexcept { return m_keyboardFocus; }

signals:
  void pullStarted(int node, double x, double y, double z);
  void pullMoved(double x, double y, double z);
  void pullEnded();
  void nodeSelected(int node);
  void springSelected(int spring);
  void selectionChanged();
  void regionDragStarted();
  void
  regionDragged(const esm::GizmoShape& shape); ///< the last one of a drag that Esc takes back is its first
  void cameraMoved();
  void repaintNeeded();

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  enum class Drag { None, Orbit, Pan, Pull, Box, Region };

  bool press(const QMouseEvent& event);
  bool move(const QMouseEvent& event);
  bool release(const QMouseEvent& event);
  bool wheel(const QWheelEvent& event);
  bool key(const QKeyEvent& event);
  bool wantsKey(const QKeyEvent& event) const;
  void pressWithTool(const QMouseEvent& event);
  void startPull(Index node, const QPointF& at);
  bool startRegionDrag(const QPointF& at);
  void endDrag();
  void cancel();
  void finishBox(Qt::KeyboardModifiers modifiers);
  void select(std::vector<Index> nodes);
  GizmoHandle handleAt(const QPointF& at) const;
  void setHoveredHandle(const GizmoHandle& handle);
  void hover(const QPointF& at);
  void setHovered(Index node);
  void updateCursor();
  void movedCamera();

  QWidget* m_view;
  SceneModel* m_model;
  Tool m_tool = Tool::Camera;
  Drag m_drag = Drag::None;
  Qt::MouseButton m_button = Qt::NoButton; ///< that began the drag and will end it
  QPointF m_last, m_pressed;               ///< of the mouse: now, and where the drag began
  Index m_hovered = kNoIndex, m_selected = kNoIndex, m_selectedSpring = kNoIndex, m_pulled = kNoIndex;
  Eigen::Vector3d m_target = Eigen::Vector3d::Zero();
  Eigen::Vector3d m_plane = Eigen::Vector3d::Zero();      ///< a point of the plane of the pull [m]
  Eigen::Vector2d m_grabOffset = Eigen::Vector2d::Zero(); ///< from the mouse to the node [pixels]
  GizmoHandle m_handle;
  std::optional<GizmoDrag> m_gizmo;
  int m_gizmoRegion = -1; ///< that m_gizmo changes
  bool m_keyboardFocus = false;
};

} // namespace esm
