// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/viewport/scene_renderer.h"
#include "app/viewport/view_input.h"

#include <QOpenGLFramebufferObject>
#include <QOpenGLWidget>
#include <QTimer>

#include <memory>

namespace esm {

/// The picture itself: renderer and overlay on a QOpenGLWidget. The scene is kept, so that what only the overlay
/// shows (rim under the mouse, arrow, hand) costs no drawing of the net. Where the springs of a large net take long
/// to draw, its surface is shown without them until the picture rests: status and hand must not wait. Takes no
/// events (its parent's ViewInput does). Create it only where SceneView::openGlUsable() holds: elsewhere Qt ends
/// the process.
class GlView : public QOpenGLWidget {
  Q_OBJECT
public:
  /// model and input are not owned and outlive this.
  GlView(SceneModel* model, const ViewInput* input, QWidget* parent);
  ~GlView() override;

  void setToolForce(const Eigen::Vector3d& force);           ///< [N]
  int scenesDrawn() const noexcept { return m_scenesDrawn; } ///< for tests: repaints that drew the net

signals:
  void failed(const QString& why); ///< the context came but cannot draw; the view must be replaced

protected:
  bool event(QEvent* event) override;
  void initializeGL() override;
  void paintGL() override;

private:
  /// What the kept scene was drawn with, besides the model's data.
  struct SceneKey {
    Look look;
    Eigen::Matrix4d view = Eigen::Matrix4d::Zero(), projection = Eigen::Matrix4d::Zero();
    QSize size;
    Colouring colouring = Colouring::None;
    bool surface = false, springs = false, struts = false;
    bool operator==(const SceneKey&) const = default;
  };

  void releaseGl();
  Look look() const;
  SceneKey sceneKey() const;
  void paintScene();
  void drawScene(const Look& look);
  bool prepareToKeep(const QSize& pixels);
  bool showKept();
  void paintOverlay();

  SceneModel* m_model;
  const ViewInput* m_input;
  SceneRenderer m_renderer;
  bool m_ready = false;
  bool m_canKeep = true;                             ///< until the driver has refused
  std::unique_ptr<QOpenGLFramebufferObject> m_scene; ///< as drawn last, without the overlay
  SceneKey m_key;                                    ///< of it
  bool m_hasSprings = true, m_springsAreSlow = false, m_isTimed = false;
  bool m_rests = false; ///< for long enough that springs may be drawn, however long they take
  QTimer m_rest;
  int m_scenesDrawn = 0;
  Eigen::Vector3d m_toolForce = Eigen::Vector3d::Zero();
};

} // namespace esm
