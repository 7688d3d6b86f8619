// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/viewport/gl_probe.h"
#include "app/viewport/gl_view.h"
#include "app/viewport/scene_view.h"
#include "core/base/colour_map.h"
#include "tests/app/viewport/sample_nets.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QOpenGLWidget>
#include <QPalette>
#include <QSignalSpy>
#include <QtTest>

#include <cmath>

using namespace esm;

namespace {

/// A view on the screen, seen from the front.
class View {
public:
  View()
  {
    scene.resize(640, 480);
    scene.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&scene));
    ViewSettings front;
    front.azimuth = front.elevation = 0.0;
    scene.setViewSettings(front);
  }
  QColor at(const QImage& picture, const Eigen::Vector3d& point) const
  {
    const QPointF pixel = picture.devicePixelRatio() * scene.project(point);
    return picture.pixelColor(static_cast<int>(pixel.x()), static_cast<int>(pixel.y()));
  }
  SceneView scene;
};

/// The colour at a logical pixel, whatever the screen's scale.
QColor colourAt(const QImage& picture, int x, int y)
{
  return picture.pixelColor((QPointF(x, y) * picture.devicePixelRatio()).toPoint());
}

int difference(const QColor& a, const QColor& b)
{
  return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue());
}

/// Whether `seen` is `base` under some light: its hue, if that has one.
bool sameHue(const QColor& seen, const Rgb& base)
{
  const QColor wanted = QColor::fromRgbF(base[0], base[1], base[2]);
  const int apart = std::abs(seen.hsvHue() - wanted.hsvHue());
  return std::min(apart, 360 - apart) < 25;
}

QPalette darkPalette()
{
  QPalette palette(QColor(0x35, 0x35, 0x35), QColor(0x2d, 0x2f, 0x33));
  palette.setColor(QPalette::WindowText, Qt::white);
  palette.setColor(QPalette::Base, QColor(0x1e, 0x20, 0x23));
  return palette;
}

/// An organ for the eye: a pear with a bent neck, softer and harder parts, a few struts, a fixed rim.
std::shared_ptr<SpringNet> organ()
{
  const auto net = samples::ball(4, [](const Eigen::Vector3d& u) {
    const double waist = 0.55 + 0.35 * std::tanh(2.2 * u.z()) + 0.1 * u.z();
    const double bump = 1.0 + 0.06 * std::sin(5.0 * u.x() + 1.0) * std::cos(4.0 * u.y());
    const double z = 0.042 * u.z();
    return Eigen::Vector3d(0.030 * waist * bump * u.x() + 4.0 * z * z, 0.022 * waist * bump * u.y(), z);
  });
  const Eigen::Vector3d lump(0.024, -0.012, 0.022);
  for (Index s = 0; s < net->springCount(); ++s) {
    const Eigen::Vector3d middle =
      0.5 * (net->restPosition.col(net->ends(0, s)) + net->restPosition.col(net->ends(1, s)));
    net->stiffness(s) = 40.0 + 900.0 * std::exp(-(middle - lump).squaredNorm() / (2.0 * 0.009 * 0.009)) +
                        25.0 * (1.0 + middle.z() / 0.042);
  }
  for (Index i = 0; i < net->nodeCount(); ++i)
    if (net->restPosition(2, i) < -0.0385) net->fixed[static_cast<std::size_t>(i)] = 1;
  samples::addStruts(*net, {{0, 1}, {2, 3}, {0, 3}, {1, 2}});
  return net;
}

Region lumpRegion()
{
  Region region;
  region.ellipsoid.centre = {0.024, -0.012, 0.022};
  region.ellipsoid.semiAxes = {0.016, 0.013, 0.015};
  region.ellipsoid.rotation = Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitY());
  return region;
}

void save(const QImage& picture, const char* name)
{
  EXPECT_TRUE(picture.save(QStringLiteral(ESM_PICTURE_DIR "/%1.png").arg(QLatin1String(name))));
}

} // namespace

// A display without OpenGL 3.3 must fail here, not skip: the other tests would prove nothing.
TEST(SceneViewGl, ThisDisplayCanDraw)
{
  QString why;
  ASSERT_TRUE(SceneView::openGlUsable(&why)) << why.toStdString();
  EXPECT_TRUE(SceneView().hasOpenGl());
}

TEST(SceneViewGl, ASphereIsDrawnInTheMiddleOfWhatTheLegendLeaves)
{
  View view;
  view.scene.setNet(samples::sphere(3, 0.05), 1);
  for (const bool legend : {true, false}) {
    view.scene.setColouring(legend ? Colouring::Stiffness : Colouring::None);
    const QImage picture = view.scene.picture();
    ASSERT_EQ(picture.size(), QSize(640, 480) * picture.devicePixelRatio());
    const QPointF middle = view.scene.project(Eigen::Vector3d::Zero());
    EXPECT_NEAR(middle.y(), 240.0, 1e-9);
    if (legend) {
      EXPECT_LT(middle.x(), 290.0);
      EXPECT_GT(middle.x(), 0.3 * 640.0);
    } else {
      EXPECT_NEAR(middle.x(), 320.0, 1e-9);
    }
    const int x = static_cast<int>(middle.x());
    const QColor background = colourAt(picture, 20, 240);
    EXPECT_GT(difference(colourAt(picture, x, 240), background), 60);
    EXPECT_GT(difference(colourAt(picture, x, 120), background), 60) << "up to 0.8 of the half height";
    EXPECT_LT(difference(colourAt(picture, x, 20), background), 60) << "but not above it";
  }
}

// An organ as long as the picture is wide: none of it is under the legend, whose place another colouring
// gives back; what the user has framed himself keeps its distance.
TEST(SceneViewGl, AFittedOrganEndsBeforeTheLegend)
{
  View view;
  const auto net = samples::ball(
    3, [](const Eigen::Vector3d& u) { return Eigen::Vector3d(0.1 * u.x(), 0.01 * u.y(), 0.01 * u.z()); });
  ViewSettings front;
  front.colouring = "stiffness";
  view.scene.setViewSettings(front);
  view.scene.setNet(net, 1);
  const auto rightEnd = [&] {
    double right = 0.0;
    for (Index node = 0; node < net->nodeCount(); ++node)
      right = std::max(right, view.scene.project(net->restPosition.col(node)).x());
    return right;
  };
  const double beside = rightEnd();
  EXPECT_LT(beside, 540.0);
  view.scene.setColouring(Colouring::None);
  EXPECT_GT(rightEnd(), beside + 40.0);
  ViewSettings framed = view.scene.viewSettings();
  framed.distance = 0.3;
  view.scene.setViewSettings(framed);
  view.scene.setColouring(Colouring::Force);
  EXPECT_EQ(view.scene.viewSettings().distance, 0.3);
}

// Soft left, hard right: the left half has the map's dark violet, the right half its yellow.
TEST(SceneViewGl, TheEndsOfTheColourMapAppearWhereTheStiffnessIs)
{
  View view;
  const auto net = samples::sphere(3, 0.05);
  for (Index s = 0; s < net->springCount(); ++s)
    net->stiffness(s) = net->restPosition(0, net->ends(0, s)) < 0.0 ? 10.0 : 1000.0;
  view.scene.setShown(true, false, false);
  view.scene.setNet(net, 1);
  const QImage picture = view.scene.picture();
  const QColor left = view.at(picture, {-0.03, -0.04, 0.0}), right = view.at(picture, {0.03, -0.04, 0.0});
  EXPECT_TRUE(sameHue(left, viridis(0.0))) << left.name().toStdString();
  EXPECT_TRUE(sameHue(right, viridis(1.0))) << right.name().toStdString();

  auto swapped = std::make_shared<SpringNet>(*net);
  swapped->stiffness = 10000.0 / net->stiffness;
  view.scene.setParameters(swapped);
  EXPECT_TRUE(sameHue(view.at(view.scene.picture(), {-0.03, -0.04, 0.0}), viridis(1.0)));

  ParameterPatch harder; // the right half, soft since, is now the hardest
  for (Index s = 0; s < net->springCount(); ++s)
    if (net->stiffness(s) == 1000.0) harder.springs.push_back({s, SpringLaw::Linear, 1e5, 0.0, 0.0});
  view.scene.setParameters(harder);
  EXPECT_TRUE(sameHue(view.at(view.scene.picture(), {-0.03, -0.04, 0.0}), viridis(0.0)));
  EXPECT_TRUE(sameHue(view.at(view.scene.picture(), {0.03, -0.04, 0.0}), viridis(1.0)));
}

// The only springs are two that cross in one point of space: where project() says, there is ink.
TEST(SceneViewGl, ProjectSaysWhereThingsAreDrawn)
{
  View view;
  const auto net = samples::sphere(0, 0.05);
  net->triangles.resize(3, 0);
  net->ends.col(0) << 0, 1; // x axis; all others fall together with the z axis
  for (Index s = 1; s < net->springCount(); ++s) net->ends.col(s) << 4, 5;
  view.scene.setNet(net, 1);
  ViewSettings settings = view.scene.viewSettings();
  settings.azimuth = 0.9;
  settings.elevation = 0.3;
  view.scene.setViewSettings(settings);
  const QImage with = view.scene.picture();
  view.scene.setShown(true, false, false);
  const QImage without = view.scene.picture();
  for (const Eigen::Vector3d& point : {Eigen::Vector3d(0.04, 0, 0), Eigen::Vector3d(-0.03, 0, 0),
                                       Eigen::Vector3d(0, 0, 0.045), Eigen::Vector3d(0, 0, -0.02)}) {
    EXPECT_GT(difference(view.at(with, point), view.at(without, point)), 60) << point.transpose();
    const Eigen::Vector3d beside = point + Eigen::Vector3d(0.004, 0.0, 0.004); // several pixels off
    EXPECT_LT(difference(view.at(with, beside), view.at(without, beside)), 10) << point.transpose();
  }
}

// Along x a strut of the support layer, along y a line, along z an edge: each has ink where its switch is on.
TEST(SceneViewGl, StrutsAreOffAtFirstAndHaveASwitchOfTheirOwn)
{
  View view;
  const auto net = samples::sphere(0, 0.05);
  net->triangles.resize(3, 0);
  net->ends.col(0) << 0, 1;
  net->ends.col(1) << 2, 3;
  for (Index s = 2; s < net->springCount(); ++s) net->ends.col(s) << 4, 5;
  net->kind[0] = SpringKind::Strut;
  net->kind[1] = SpringKind::Line;
  view.scene.setNet(net, 1);
  ViewSettings settings = view.scene.viewSettings();
  EXPECT_FALSE(settings.showStruts);
  settings.azimuth = 0.9;
  settings.elevation = 0.3;
  view.scene.setViewSettings(settings);
  const QImage atFirst = view.scene.picture();
  view.scene.setShown(true, false, false);
  const QImage bare = view.scene.picture();
  view.scene.setShown(true, false, true);
  EXPECT_TRUE(view.scene.viewSettings().showStruts);
  const QImage struts = view.scene.picture();
  view.scene.setShown(true, true, true);
  const QImage all = view.scene.picture();
  const auto inked = [&](const QImage& picture, const Eigen::Vector3d& point) {
    return difference(view.at(picture, point), view.at(bare, point)) > 60;
  };
  const Eigen::Vector3d strut(0.04, 0, 0), line(0, 0.03, 0), edge(0, 0, 0.045);
  EXPECT_FALSE(inked(atFirst, strut));
  EXPECT_TRUE(inked(atFirst, line) && inked(atFirst, edge));
  EXPECT_TRUE(inked(struts, strut));
  EXPECT_FALSE(inked(struts, line) || inked(struts, edge));
  EXPECT_TRUE(inked(all, strut) && inked(all, line) && inked(all, edge));
}

TEST(SceneViewGl, RegionsAreDrawnAndTheSelectedOneStandsOut)
{
  View view;
  view.scene.setColouring(Colouring::None);
  view.scene.setNet(samples::sphere(2, 0.02), 1);
  Region region;
  region.ellipsoid.semiAxes = Eigen::Vector3d::Constant(0.024);
  const auto orange = [&](int selected) {
    view.scene.setRegions({region}, selected);
    const QImage picture = view.scene.picture();
    int count = 0;
    for (int y = 0; y < picture.height() - 60; ++y) // above the hint and the axes
      for (int x = 160; x < picture.width(); ++x)
        if (difference(picture.pixelColor(x, y), QColor(0xf2, 0x6b, 0x21)) < 40) ++count;
    return count;
  };
  EXPECT_EQ(orange(-1), 0);
  EXPECT_GT(orange(0), 300);
}

// The gizmo on the organ with a weight heat map, for the eye, on light and dark: handles in the colours of
// the axes, the inner shell, the paler twin, spines of what is inside out, the padlock of what is locked.
TEST(SceneViewGl, TheGizmoIsDrawnOnLightAndDark)
{
  const QPalette before = QApplication::palette();
  for (const bool dark : {false, true}) {
    if (dark) QApplication::setPalette(darkPalette());
    View view;
    view.scene.resize(900, 640);
    ViewSettings settings = view.scene.viewSettings();
    settings.azimuth = 0.5, settings.elevation = 0.35;
    view.scene.setViewSettings(settings);
    view.scene.setNet(organ(), 1);
    view.scene.setColouring(Colouring::RegionWeight);
    view.scene.setTool(Tool::Region);
    Region region = lumpRegion();
    region.name = "lump";
    const auto pictureOf = [&](const char* name) {
      view.scene.setRegions({region}, 0);
      const QImage picture = view.scene.picture();
      save(picture, (std::string("gizmo_") + name + (dark ? "_dark" : "_light")).c_str());
      return picture;
    };
    const QImage free = pictureOf("free");
    const auto handles = view.scene.gizmoHandles();
    for (auto handle = handles.begin(); handle != handles.end(); ++handle) {
      if (handle.key().startsWith("turn")) continue; // thinner than a pixel is sure to meet
      const QPoint at = handle.value().toPoint();
      EXPECT_GT(colourAt(free, at.x(), at.y()).hsvSaturation(), 90) << handle.key().toStdString();
    }
    region.mirror = MirrorPlane{{0, 0, 0}, {1, 0, 0}};
    region.insideOut = true;
    EXPECT_NE(pictureOf("inside_out"), free);
    region.mirror.reset();
    region.insideOut = false;
    region.locked = true;
    EXPECT_NE(pictureOf("locked"), free);
  }
  QApplication::setPalette(before);
}

TEST(SceneViewGl, ASnapshotMovesThePicture)
{
  View view;
  const auto net = samples::sphere(2, 0.03);
  view.scene.setNet(net, 3);
  const QImage before = view.scene.picture();
  SimSnapshot snapshot = samples::restSnapshot(*net, 3, 1);
  snapshot.time = 0.5;
  snapshot.position.row(0).array() += 0.02;
  snapshot.generation = 2;
  view.scene.setSnapshot(snapshot);
  EXPECT_EQ(view.scene.picture(), before) << "a snapshot of an older net is ignored";
  snapshot.generation = 3;
  view.scene.setSnapshot(snapshot);
  EXPECT_NE(view.scene.picture(), before);
}

// Nothing is redrawn when nothing has changed.
TEST(SceneViewGl, AnIdleSceneIsNotPainted)
{
  View view;
  const auto net = samples::sphere(2, 0.03);
  view.scene.setNet(net, 3);
  QTest::qWait(50);
  QSignalSpy painted(view.scene.findChild<QOpenGLWidget*>(), &QOpenGLWidget::aboutToCompose);
  for (std::uint64_t sequence = 1; sequence < 20; ++sequence) {
    view.scene.setSnapshot(samples::restSnapshot(*net, 3, sequence));
    view.scene.setToolForce(Eigen::Vector3d::Zero());
    view.scene.setColouring(Colouring::Stiffness);
    QTest::qWait(2);
  }
  EXPECT_EQ(painted.count(), 0);
}

namespace {

int orangePixels(const QImage& picture)
{
  int count = 0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x)
      count += difference(picture.pixelColor(x, y), QColor(0xf2, 0x6b, 0x21)) < 60 ? 1 : 0;
  return count;
}

} // namespace

// Before it pulls the tool shows on the tissue how far its hold will reach, and follows the radius; in both themes,
// and without drawing the net anew.
TEST(SceneView, ThePullToolShowsWhatItWillHold)
{
  for (const bool dark : {false, true}) {
    View view;
    if (dark) view.scene.setPalette(darkPalette());
    view.scene.setNet(samples::sphere(4, 0.05), 1);
    view.scene.setColouring(Colouring::None);
    view.scene.setTool(Tool::Pull);
    view.scene.setGripRadius(0.008);
    EXPECT_EQ(orangePixels(view.scene.picture()), 0);
    const auto* canvas = view.scene.findChild<GlView*>("view3dCanvas");
    ASSERT_NE(canvas, nullptr);
    const int before = canvas->scenesDrawn();
    QTest::mouseMove(&view.scene, QPoint(300, 240));
    QTest::mouseMove(&view.scene, view.scene.project({0.0, -0.05, 0.0}).toPoint());
    const QImage small = view.scene.picture();
    view.scene.setGripRadius(0.02);
    const QImage large = view.scene.picture();
    EXPECT_EQ(canvas->scenesDrawn(), before) << "only the overlay is another";
    EXPECT_GT(orangePixels(small), 100);
    EXPECT_GT(orangePixels(large), 2 * orangePixels(small) - 60); // about as its radius
    // The ring is where the radius is, on the surface: 20 mm beside the node.
    const Eigen::Vector3d rim(0.05 * std::sin(0.4027), -0.05 * std::cos(0.4027), 0.0);
    const QPoint at = view.scene.project(rim).toPoint();
    EXPECT_GT(orangePixels(large.copy(at.x() - 4, at.y() - 4, 9, 9)), 3);
    EXPECT_EQ(orangePixels(small.copy(at.x() - 4, at.y() - 4, 9, 9)), 0);
    view.scene.setTool(Tool::Camera);
    EXPECT_EQ(orangePixels(view.scene.picture()), 0);
  }
}

// What is kept is not shown when anything of the scene is another: camera, motion, colours, what is shown, theme.
TEST(SceneView, AKeptSceneIsDrawnAnewWhenItChanges)
{
  View view;
  const auto net = samples::sphere(3, 0.05);
  view.scene.setNet(net, 1);
  const auto* canvas = view.scene.findChild<GlView*>("view3dCanvas");
  const auto isNew = [&] {
    const int before = canvas->scenesDrawn();
    view.scene.picture();
    return canvas->scenesDrawn() > before;
  };
  EXPECT_TRUE(isNew());
  EXPECT_FALSE(isNew());
  view.scene.setToolForce({0.0, 0.0, 1.0});
  EXPECT_FALSE(isNew());
  ViewSettings turned;
  turned.azimuth = 1.0;
  view.scene.setViewSettings(turned);
  EXPECT_TRUE(isNew());
  SimSnapshot snapshot = samples::restSnapshot(*net, 1, 2);
  snapshot.position *= 1.01;
  view.scene.setSnapshot(snapshot);
  EXPECT_TRUE(isNew());
  view.scene.setShown(true, false, false);
  EXPECT_TRUE(isNew());
  view.scene.setPalette(darkPalette());
  EXPECT_TRUE(isNew());
  view.scene.setColouring(Colouring::Strain);
  EXPECT_TRUE(isNew());
  view.scene.resize(500, 400);
  EXPECT_TRUE(isNew());
  EXPECT_FALSE(isNew());
}

// Where the graphics takes several samples of each pixel, a pixel that the outline cuts is between both sides; with one
// sample hardly any is.
TEST(SceneViewGl, SamplesMakeOutlinesSmooth)
{
  View view;
  view.scene.setNet(samples::sphere(4, 0.05), 1);
  view.scene.setShown(true, false, false);
  const QImage picture = view.scene.picture();
  int between = 0;
  constexpr int kRows = 100;
  for (int y = 200; y < 200 + kRows; ++y) {
    int edge = 1;
    const auto jumpAt = [&](int x) {
      return difference(colourAt(picture, x, y), colourAt(picture, x - 1, y));
    };
    for (int x = 1; x < 320; ++x)
      if (jumpAt(x) > jumpAt(edge)) edge = x;
    if (std::max(jumpAt(edge - 1), jumpAt(edge + 1)) > 20) ++between;
  }
  if (glProbe().samples > 0)
    EXPECT_GT(between, kRows / 4);
  else
    EXPECT_LT(between, kRows / 10); // where its shade alone changes
}

// A new top-level parent replaces the OpenGL context; buffers and textures must come back.
TEST(SceneViewGl, SurvivesAMoveToAnotherWindow)
{
  auto* scene = new SceneView;
  scene->resize(640, 480);
  scene->show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(scene));
  scene->setNet(samples::sphere(3, 0.05), 1);
  const QImage before = scene->picture();
  QWidget window;
  window.resize(640, 480);
  scene->setParent(&window);
  window.show();
  scene->setGeometry(0, 0, 640, 480);
  scene->show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  EXPECT_EQ(scene->picture(), before);
}

TEST(SceneViewGl, EmptyNetsAndHugeOnesInTurn)
{
  View view;
  view.scene.setNet(nullptr, 1);
  EXPECT_FALSE(view.scene.picture().isNull());
  view.scene.setNet(samples::sphere(4, 500.0, {1e5, 0, 0}), 2);
  const QImage huge = view.scene.picture();
  EXPECT_GT(difference(colourAt(huge, 320, 240), colourAt(huge, 40, 240)), 60);
  view.scene.setNet(samples::sphere(0, 1e-6), 3);
  view.scene.fit();
  EXPECT_FALSE(view.scene.picture().isNull());
  view.scene.setNet(nullptr, 4);
  view.scene.setRegions({}, -1);
  EXPECT_FALSE(view.scene.picture().isNull());
}

// For people: kept in the build folder.
TEST(SceneViewGl, PicturesOfAnOrgan)
{
  const auto net = organ();
  for (const bool dark : {false, true}) {
    SceneView scene;
    scene.resize(1000, 720);
    if (dark) scene.setPalette(darkPalette());
    scene.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&scene));
    scene.setNet(net, 1);
    Region other = lumpRegion();
    other.ellipsoid.centre = {0.0, 0.0, -0.02};
    scene.setRegions({lumpRegion(), other}, 0);
    scene.setTool(Tool::Pull);
    SimSnapshot snapshot = samples::restSnapshot(*net, 1, 1);
    const Eigen::Vector3d pulled = net->restPosition.col(3);
    for (Index i = 0; i < net->nodeCount(); ++i) {
      const double distance = (net->restPosition.col(i) - pulled).norm();
      snapshot.position.col(i) +=
        Eigen::Vector3d(0.004, -0.012, 0.004) * std::exp(-std::pow(distance / 0.008, 2));
    }
    snapshot.tension = 0.02 * Eigen::ArrayXd::Random(net->springCount());
    snapshot.grabbedNode = 3;
    for (Index i = 0; i < net->nodeCount(); ++i)
      if ((net->restPosition.col(i) - pulled).norm() < 0.008) snapshot.heldNodes.push_back(i);
    snapshot.time = 0.1;
    scene.setSnapshot(snapshot);
    scene.setToolForce({-0.55, 0.1, -0.2});
    save(scene.picture(), dark ? "organ_stiffness_dark" : "organ_stiffness_light");
    scene.setColouring(Colouring::Strain);
    scene.setShown(true, false, false);
    save(scene.picture(), dark ? "organ_strain_dark" : "organ_strain_light");
    scene.setColouring(Colouring::None);
    scene.setShown(true, true, false);
    save(scene.picture(), dark ? "organ_plain_dark" : "organ_plain_light");
    scene.setColouring(Colouring::Force);
    scene.setShown(false, true, false);
    save(scene.picture(), dark ? "organ_force_dark" : "organ_force_light");
  }
}
