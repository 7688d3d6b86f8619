// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/viewport/gl_view.h"

#include "app/viewport/gl_probe.h"
#include "app/viewport/overlay.h"

#include <QOpenGLContext>
#include <QPainter>

namespace esm {

GlView::GlView(SceneModel* model, const ViewInput* input, QWidget* parent)
  : QOpenGLWidget(parent), m_model(model), m_input(input)
{
  setObjectName("view3dCanvas");
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFocusPolicy(Qt::NoFocus);
  setFormat(glFormat(glProbe().samples));
}

GlView::~GlView()
{
  if (context()) disconnect(context(), nullptr, this, nullptr); // it outlives this part of the object
  releaseGl();
}

void GlView::setToolForce(const Eigen::Vector3d& force)
{
  if (force == m_toolForce) return;
  m_toolForce = force;
  update();
}

void GlView::initializeGL()
{
  // Moving the view to another window replaces the context; what belongs to the old one goes with it.
  connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &GlView::releaseGl, Qt::UniqueConnection);
  QString why;
  m_ready = m_renderer.create(&why);
  m_model->dirty = {};
  if (!m_ready)
    QMetaObject::invokeMethod(
      this, [this, why] { emit failed(why); }, Qt::QueuedConnection);
}

void GlView::releaseGl()
{
  if (!context()) return;
  makeCurrent();
  m_renderer.release();
  m_ready = false;
  doneCurrent();
}

void GlView::paintGL()
{
  if (!m_ready) return;
  const Look style = look();
  m_renderer.draw(*m_model, style);
  OverlayState state;
  state.tool = m_input->tool();
  state.hovered = m_input->hoveredNode();
  state.selected = m_input->selectedNode();
  state.selectedSpring = m_input->selectedSpring();
  state.pulled = m_input->pulledNode();
  state.pullTarget = m_input->pullTarget();
  state.toolForce = m_toolForce;
  state.handle = m_input->hoveredHandle();
  state.drag = m_input->gizmoDrag();
  state.selectionBox = m_input->selectionBox();
  state.keyboardFocus = m_input->keyboardFocus();
  QPainter painter(this);
  Overlay(painter, palette(), *m_model, state).draw();
}

Look GlView::look() const
{
  const QColor window = palette().color(QPalette::Window);
  Look look;
  look.dark = window.lightness() < 128;
  look.top = look.dark ? window.lighter(150) : QColor(0xfb, 0xfc, 0xfd);
  look.bottom = look.dark ? window.darker(125) : window.darker(112);
  look.tissue = QColor(0xd9, 0x8f, 0x83);
  look.wire = look.dark ? QColor(0x8a, 0x4f, 0x48) : QColor(0x7c, 0x40, 0x3a);
  look.region = look.dark ? QColor(0x9c, 0xc7, 0xff) : QColor(0x2b, 0x5f, 0xa8);
  look.selectedRegion = QColor(0xf2, 0x6b, 0x21);
  look.selectedNode = palette().color(QPalette::Highlight);
  look.pixelRatio = devicePixelRatioF();
  return look;
}

} // namespace esm
