// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/viewport/gl_view.h"

#include "app/viewport/gl_probe.h"
#include "app/viewport/overlay.h"

#include <QElapsedTimer>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <QPainter>

#include <utility>

namespace esm {

namespace {

constexpr Index kManySprings = 30'000; ///< only then is it worth measuring, which waits for the graphics
constexpr qint64 kSlowScene = 60;      ///< that status and hand can wait for [ms]
constexpr int kRest = 500;             ///< without another picture, until all springs are drawn again [ms]

} // namespace

GlView::GlView(SceneModel* model, const ViewInput* input, QWidget* parent)
  : QOpenGLWidget(parent), m_model(model), m_input(input)
{
  setObjectName("view3dCanvas");
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFocusPolicy(Qt::NoFocus);
  setFormat(glFormat(glProbe().samples));
  m_rest.setSingleShot(true);
  m_rest.setInterval(kRest);
  connect(&m_rest, &QTimer::timeout, this, [this] {
    if (m_input->pulledNode() != kNoIndex) return m_rest.start(); // the next picture may come at any moment
    m_rests = true;
    update();
  });
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

/// The samples that a format asks for are gone from it once a context was made, and another window needs another one.
bool GlView::event(QEvent* event)
{
  if (context() == nullptr) setFormat(glFormat(glProbe().samples));
  return QOpenGLWidget::event(event);
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
  m_scene.reset();
  m_renderer.release();
  m_ready = false;
  doneCurrent();
}

void GlView::paintGL()
{
  if (!m_ready) return;
  paintScene();
  paintOverlay();
}

GlView::SceneKey GlView::sceneKey() const
{
  return {look(),
          m_model->camera.view(),
          m_model->camera.projection(),
          size() * devicePixelRatioF(),
          m_model->colouring(),
          m_model->surfaceShown(),
          m_model->springsShown(),
          m_model->strutsShown()};
}

void GlView::paintScene()
{
  const SceneKey key = sceneKey();
  const SceneModel::Dirty& dirty = m_model->dirty;
  if (dirty.topology) m_springsAreSlow = m_isTimed = false;
  const bool isKept = prepareToKeep(key.size) && key == m_key &&
                      !(dirty.topology || dirty.frame || dirty.regions || dirty.selection);
  const bool sharpens = std::exchange(m_rests, false) && !(m_hasSprings && m_isTimed);
  if (!isKept || sharpens) {
    m_key = key;
    Look look = key.look;
    look.springsToo = m_hasSprings = !m_springsAreSlow || isKept;
    if (m_scene) m_scene->bind();
    drawScene(look);
    if (!(m_hasSprings && m_isTimed)) m_rest.start();
  }
  if (!m_scene || showKept()) return;
  m_scene.reset();
  m_canKeep = m_springsAreSlow = false;
  drawScene(key.look);
}

/// Of a large net it is timed how long all of it takes; not the first time, when much has to be made.
void GlView::drawScene(const Look& look)
{
  const bool isFirst = m_model->dirty.topology;
  QElapsedTimer clock;
  clock.start();
  m_renderer.draw(*m_model, look);
  ++m_scenesDrawn;
  const bool isLarge = m_canKeep && m_model->net() != nullptr && m_model->net()->springCount() > kManySprings;
  if (isLarge && (isFirst || !look.springsToo)) return;
  m_isTimed = true;
  if (!isLarge) return;
  context()->functions()->glFinish();
  m_springsAreSlow = clock.elapsed() > kSlowScene;
}

/// A framebuffer like the widget's own, so that the driver copies it as it is. Once it is there the widget's format
/// says nothing of its samples.
bool GlView::prepareToKeep(const QSize& pixels)
{
  if (!m_canKeep) return false;
  if (m_scene && m_scene->size() == pixels) return true;
  QOpenGLFramebufferObjectFormat format;
  format.setAttachment(QOpenGLFramebufferObject::CombinedDepthStencil);
  format.setSamples(glProbe().samples);
  format.setInternalTextureFormat(textureFormat() != 0 ? textureFormat() : GL_RGBA8);
  m_scene = std::make_unique<QOpenGLFramebufferObject>(pixels, format);
  if (!m_scene->isValid()) {
    m_scene.reset();
    m_canKeep = false;
  }
  context()->functions()->glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
  return false; // nothing is in it yet
}

bool GlView::showKept()
{
  QOpenGLExtraFunctions* gl = context()->extraFunctions();
  while (gl->glGetError() != GL_NO_ERROR) {
  } // what others have left behind
  const QSize size = m_scene->size();
  gl->glDisable(GL_SCISSOR_TEST);
  gl->glBindFramebuffer(GL_READ_FRAMEBUFFER, m_scene->handle());
  gl->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, defaultFramebufferObject());
  gl->glBlitFramebuffer(0, 0, size.width(), size.height(), 0, 0, size.width(), size.height(),
                        GL_COLOR_BUFFER_BIT, GL_NEAREST);
  gl->glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
  return gl->glGetError() == GL_NO_ERROR;
}

void GlView::paintOverlay()
{
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
