// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/viewport/scene_view.h"

#include "app/viewport/gizmo_painter.h"
#include "app/viewport/gl_probe.h"
#include "app/viewport/gl_view.h"
#include "app/viewport/overlay.h"
#include "app/viewport/scene_model.h"
#include "app/viewport/view_input.h"

#include <QEvent>
#include <QFontMetricsF>
#include <QLabel>
#include <QVBoxLayout>
#include <QVariantAnimation>

#include <algorithm>
#include <cmath>
#include <utility>

namespace esm {

/// The model always exists, so that view settings survive a session without OpenGL; canvas and input only
/// where the picture can be shown.
struct SceneView::Impl {
  SceneModel model;
  ViewInput* input = nullptr;    ///< child of the view, or null
  GlView* canvas = nullptr;      ///< child of the view, or null
  QLabel* placeholder = nullptr; ///< child of the view, or null
  QString failure;               ///< what the driver said when a usable context could not draw after all
  Tool tool = Tool::Camera;
  QVariantAnimation* flight = nullptr; ///< of the camera; child of the view

  void repaintIf(bool changed) const
  {
    if (changed && canvas) canvas->update();
  }
};

/// The legend covers an edge of the picture: what is shown keeps clear of it.
void SceneView::makeRoomForLegend()
{
  m_impl->repaintIf(m_impl->model.setCovered(legendRoom(m_impl->model, QFontMetricsF(font()))));
}

bool SceneView::openGlUsable(QString* why)
{
  const GlProbe& probe = glProbe();
  if (why) *why = probe.why();
  return probe.usable;
}

SceneView::SceneView(QWidget* parent) : QWidget(parent), m_impl(std::make_unique<Impl>())
{
  setObjectName("view3d");
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(160, 120);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  if (!openGlUsable(nullptr)) {
    showPlaceholder();
    return;
  }
  m_impl->input = new ViewInput(this, &m_impl->model);
  m_impl->canvas = new GlView(&m_impl->model, m_impl->input, this);
  layout->addWidget(m_impl->canvas);
  connect(m_impl->input, &ViewInput::repaintNeeded, this, [this] { m_impl->repaintIf(true); });
  connect(m_impl->input, &ViewInput::cameraMoved, this, &SceneView::viewChanged);
  connect(m_impl->input, &ViewInput::pullStarted, this, &SceneView::pullStarted);
  connect(m_impl->input, &ViewInput::pullMoved, this, &SceneView::pullMoved);
  connect(m_impl->input, &ViewInput::pullEnded, this, &SceneView::pullEnded);
  connect(m_impl->input, &ViewInput::nodeSelected, this, &SceneView::nodeSelected);
  connect(m_impl->input, &ViewInput::springSelected, this, &SceneView::springSelected);
  connect(m_impl->input, &ViewInput::selectionChanged, this, &SceneView::selectionChanged);
  connect(m_impl->input, &ViewInput::regionDragStarted, this, &SceneView::regionDragStarted);
  connect(m_impl->input, &ViewInput::regionDragged, this, &SceneView::regionDragged);
  connect(m_impl->canvas, &GlView::failed, this, [this](const QString& why) {
    m_impl->failure = why;
    removeEventFilter(m_impl->input);
    std::exchange(m_impl->canvas, nullptr)->deleteLater();
    std::exchange(m_impl->input, nullptr)->deleteLater();
    showPlaceholder();
  });
  retranslate();
}

SceneView::~SceneView()
{
  // Both look at the model, which goes before QWidget would delete its children.
  delete m_impl->canvas;
  delete m_impl->input;
}

void SceneView::showPlaceholder()
{
  auto* label = new QLabel(this);
  label->setObjectName("view3dPlaceholder");
  label->setAlignment(Qt::AlignCenter);
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  label->setMargin(24);
  layout()->addWidget(label);
  m_impl->placeholder = label;
  retranslate();
}

void SceneView::retranslate()
{
  setAccessibleName(tr("3D preview"));
  if (!m_impl->placeholder) {
    setAccessibleDescription(
      tr("Keys: F fits, 1, 3 and 7 look from the front, the right and the top, arrows turn, + and - zoom."));
    return;
  }
  const QString text = tr("3D preview needs OpenGL 3.3; everything else works.");
  const QString why = m_impl->failure.isEmpty() ? glProbe().why() : m_impl->failure;
  m_impl->placeholder->setText(text + "\n\n" + tr("Here %1.").arg(why));
  setAccessibleDescription(m_impl->placeholder->text());
}

bool SceneView::hasOpenGl() const
{
  return m_impl->canvas != nullptr;
}

void SceneView::setNet(std::shared_ptr<const SpringNet> net, std::uint64_t generation)
{
  if (m_impl->input) m_impl->input->netReplaced();
  const bool hadSelection = !m_impl->model.selection().empty();
  m_impl->repaintIf(m_impl->model.setNet(std::move(net), generation));
  makeRoomForLegend();
  if (hadSelection) emit selectionChanged();
}

void SceneView::setSnapshot(const SimSnapshot& snapshot)
{
  m_impl->repaintIf(m_impl->model.setSnapshot(snapshot));
}

void SceneView::setParameters(std::shared_ptr<const SpringNet> net)
{
  m_impl->repaintIf(m_impl->model.setParameters(std::move(net)));
}

void SceneView::setParameters(const ParameterPatch& patch)
{
  m_impl->repaintIf(m_impl->model.setParameters(patch));
}

void SceneView::setRegions(const std::vector<Region>& regions, int selected)
{
  m_impl->repaintIf(m_impl->model.setRegions(regions, selected));
  makeRoomForLegend();
  if (m_impl->input) m_impl->input->regionsReplaced();
}

void SceneView::setColouring(Colouring colouring)
{
  m_impl->repaintIf(m_impl->model.setColouring(colouring));
  makeRoomForLegend();
}

void SceneView::setShown(bool surface, bool springs, bool struts)
{
  m_impl->repaintIf(m_impl->model.setShown(surface, springs, struts));
}

void SceneView::setToolForce(const Eigen::Vector3d& force)
{
  if (m_impl->canvas) m_impl->canvas->setToolForce(force);
}

void SceneView::setGripRadius(double metres)
{
  m_impl->repaintIf(m_impl->model.setGripRadius(metres));
}

void SceneView::showNothingHeld()
{
  setToolForce(Eigen::Vector3d::Zero());
  m_impl->repaintIf(m_impl->model.letGo());
}

void SceneView::setInstrument(const Instrument& instrument)
{
  m_impl->repaintIf(m_impl->model.setInstrument(instrument));
}

const Instrument& SceneView::instrument() const
{
  return m_impl->model.instrument();
}

void SceneView::setMarks(const Eigen::Matrix3Xd& places)
{
  m_impl->repaintIf(m_impl->model.setMarks(places));
}

const Eigen::Matrix3Xd& SceneView::marks() const
{
  return m_impl->model.marks();
}

void SceneView::letGo()
{
  if (m_impl->input) m_impl->input->letGo();
}

void SceneView::setTool(Tool tool)
{
  m_impl->tool = tool;
  if (m_impl->input) m_impl->input->setTool(tool);
}

Tool SceneView::tool() const
{
  return m_impl->tool;
}

void SceneView::fit()
{
  m_impl->model.fit();
  m_impl->repaintIf(true);
}

void SceneView::flyTo(const Eigen::Matrix3Xd& places, double nearest)
{
  const Camera start = m_impl->model.camera;
  Camera goal = start;
  goal.fit(places);
  const double distance = std::max(goal.distance(), 0.5 * nearest / std::tan(0.5 * Camera::kFieldOfView));
  const Eigen::Vector3d target = goal.target();
  delete std::exchange(m_impl->flight, new QVariantAnimation(this));
  m_impl->flight->setDuration(300); // [ms]
  m_impl->flight->setEasingCurve(QEasingCurve::InOutQuad);
  m_impl->flight->setStartValue(0.0);
  m_impl->flight->setEndValue(1.0);
  connect(m_impl->flight, &QVariantAnimation::valueChanged, this, [=, this](const QVariant& share) {
    const double t = share.toDouble();
    m_impl->model.camera.setPose(start.target() + t * (target - start.target()),
                                 start.distance() * std::pow(distance / start.distance(), t), start.azimuth(),
                                 start.elevation());
    m_impl->model.cameraMoved();
    m_impl->repaintIf(true);
  });
  m_impl->flight->start();
}

ViewSettings SceneView::viewSettings() const
{
  return m_impl->model.viewSettings();
}

void SceneView::setViewSettings(const ViewSettings& settings)
{
  m_impl->model.setViewSettings(settings);
  makeRoomForLegend();
  m_impl->repaintIf(true);
}

QImage SceneView::picture()
{
  return m_impl->canvas ? m_impl->canvas->grabFramebuffer() : grab().toImage();
}

QPointF SceneView::project(const Eigen::Vector3d& point) const
{
  const Eigen::Vector2d pixel = m_impl->model.camera.project(point).pixel;
  return {pixel.x(), pixel.y()};
}

Index SceneView::springAt(const QPointF& pixel) const
{
  return m_impl->model.springAt({pixel.x(), pixel.y()});
}

Index SceneView::nodeAt(const QPointF& pixel) const
{
  return m_impl->model.nodeAt({pixel.x(), pixel.y()});
}

QMap<QString, QPointF> SceneView::gizmoHandles() const
{
  const Region* region = m_impl->model.gizmoRegion();
  if (region == nullptr || m_impl->tool != Tool::Region) return {};
  return gizmoPlaces(layoutGizmo(m_impl->model.camera, {region->ellipsoid, region->falloff}));
}

QString SceneView::legendTitle() const
{
  return m_impl->model.net() != nullptr ? legendText(m_impl->model).title : QString();
}

const std::vector<Index>& SceneView::selection() const
{
  return m_impl->model.selection();
}

void SceneView::resizeEvent(QResizeEvent* event)
{
  QWidget::resizeEvent(event);
  m_impl->model.setViewport(width(), height());
  makeRoomForLegend();
}

void SceneView::changeEvent(QEvent* event)
{
  QWidget::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) retranslate();
  m_impl->repaintIf(event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange ||
                    event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange);
  makeRoomForLegend(); // in another language or font
}

} // namespace esm
