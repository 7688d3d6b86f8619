// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/viewport/scene_renderer.h"
#include "app/viewport/view_input.h"

#include <QOpenGLWidget>

namespace esm {

/// The picture itself: renderer and overlay on a QOpenGLWidget. Takes no events (its parent's ViewInput
/// does). Create it only where SceneView::openGlUsable() holds: elsewhere Qt ends the process.
class GlView : public QOpenGLWidget {
  Q_OBJECT
public:
  /// model and input are not owned and outlive this.
  GlView(SceneModel* model, const ViewInput* input, QWidget* parent);
  ~GlView() override;

  void setToolForce(const Eigen::Vector3d& force); ///< [N]

signals:
  void failed(const QString& why); ///< the context came but cannot draw; the view must be replaced

protected:
  void initializeGL() override;
  void paintGL() override;

private:
  void releaseGl();
  Look look() const;

  SceneModel* m_model;
  const ViewInput* m_input;
  SceneRenderer m_renderer;
  bool m_ready = false;
  Eigen::Vector3d m_toolForce = Eigen::Vector3d::Zero();
};

} // namespace esm
