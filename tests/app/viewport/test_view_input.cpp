// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/viewport/scene_view.h"
#include "tests/app/viewport/sample_nets.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QDialog>
#include <QShortcut>
#include <QSignalSpy>
#include <QWheelEvent>
#include <QtTest>

#include <numbers>

using namespace esm;
using Eigen::Vector3d;

namespace {

/// A sphere of 5 cm on the screen, seen from the front, with every signal counted.
struct Scene : testing::Test {
  Scene()
  {
    view.resize(640, 480);
    view.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&view));
    ViewSettings front;
    front.azimuth = front.elevation = 0.0;
    view.setViewSettings(front);
    net = samples::sphere(2, 0.05);
    view.setNet(net, 1);
    view.setSnapshot(samples::restSnapshot(*net, 1, 1));
  }
  QPoint pixelOf(Index node) const { return view.project(net->restPosition.col(node)).toPoint(); }
  void drag(Qt::MouseButton button, const QPoint& from, const QPoint& to, Qt::KeyboardModifiers keys = {})
  {
    QTest::mousePress(&view, button, keys, from);
    moveTo(to, button);
    QTest::mouseRelease(&view, button, keys, to);
  }
  void moveTo(const QPoint& to, Qt::MouseButton button) // QTest::mouseMove() holds no button
  {
    QMouseEvent event(QEvent::MouseMove, QPointF(to), view.mapToGlobal(QPointF(to)), Qt::NoButton, button,
                      {});
    QApplication::sendEvent(&view, &event);
  }
  SceneView view;
  std::shared_ptr<SpringNet> net;
  QSignalSpy started{&view, &SceneView::pullStarted}, moved{&view, &SceneView::pullMoved},
    ended{&view, &SceneView::pullEnded}, selected{&view, &SceneView::nodeSelected},
    camera{&view, &SceneView::viewChanged};
};

constexpr Index kFront = 3; ///< the pole -y, that looks at us

Vector3d pointOf(const QList<QVariant>& arguments, int first)
{
  return {arguments[first].toDouble(), arguments[first + 1].toDouble(), arguments[first + 2].toDouble()};
}

} // namespace

// Press on a vertex, drag 50 pixels to the right: the target leaves by 50 pixels in the vertex's own plane.
TEST_F(Scene, PullTakesTheNodeUnderTheMouseAndMovesItsTargetInThePlaneOfTheScreen)
{
  view.setTool(Tool::Pull);
  const QPoint at = pixelOf(kFront);
  QTest::mousePress(&view, Qt::LeftButton, {}, at + QPoint(3, 2));
  ASSERT_EQ(started.count(), 1);
  EXPECT_EQ(started[0][0].toInt(), kFront);
  const Vector3d node = net->restPosition.col(kFront);
  EXPECT_LT((pointOf(started[0], 1) - node).norm(), 1e-12) << "no jump to the mouse";
  moveTo(at + QPoint(53, 2), Qt::LeftButton);
  ASSERT_EQ(moved.count(), 1);
  const Vector3d target = pointOf(moved[0], 0);
  EXPECT_NEAR(target.y(), node.y(), 1e-12) << "parallel to the screen, seen from the front";
  EXPECT_NEAR(target.z(), node.z(), 1e-12);
  EXPECT_GT(target.x(), node.x());
  EXPECT_NEAR(view.project(target).x() - view.project(node).x(), 50.0, 1e-6);
  EXPECT_EQ(ended.count(), 0);
  QTest::mouseRelease(&view, Qt::LeftButton, {}, at + QPoint(53, 2));
  EXPECT_EQ(ended.count(), 1);
  EXPECT_EQ(camera.count(), 0);
}

TEST_F(Scene, EscLetsGo)
{
  view.setTool(Tool::Pull);
  QTest::mousePress(&view, Qt::LeftButton, {}, pixelOf(kFront));
  QTest::keyClick(&view, Qt::Key_Escape);
  EXPECT_EQ(ended.count(), 1);
  moveTo(pixelOf(kFront) + QPoint(30, 0), Qt::LeftButton);
  QTest::mouseRelease(&view, Qt::LeftButton, {}, pixelOf(kFront));
  EXPECT_EQ(moved.count(), 0);
  EXPECT_EQ(ended.count(), 1) << "only once";
}

// Esc is also the window's stop: letting go must not swallow it.
TEST_F(Scene, EscStillReachesTheWindow)
{
  QWidget window;
  window.resize(640, 480);
  view.setParent(&window);
  QShortcut stop(Qt::Key_Escape, &window);
  QSignalSpy stopped(&stop, &QShortcut::activated);
  window.show();
  view.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  window.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
  view.setFocus();
  view.setTool(Tool::Pull);
  QTest::mousePress(&view, Qt::LeftButton, {}, pixelOf(kFront));
  ASSERT_EQ(started.count(), 1);
  QTest::keyClick(&view, Qt::Key_Escape);
  EXPECT_EQ(ended.count(), 1);
  EXPECT_EQ(stopped.count(), 1);
  view.setParent(nullptr);
}

// A dialog takes the release of the button: nothing may follow the pointer for that.
TEST_F(Scene, ADialogThatOpensLetsGo)
{
  view.setTool(Tool::Pull);
  QTest::mousePress(&view, Qt::LeftButton, {}, pixelOf(kFront));
  ASSERT_EQ(started.count(), 1);
  QDialog dialog;
  dialog.setModal(true);
  dialog.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&dialog));
  EXPECT_EQ(ended.count(), 1);
  dialog.close();
  moveTo(pixelOf(kFront) + QPoint(30, 0), Qt::NoButton);
  EXPECT_EQ(moved.count(), 0);
}

TEST_F(Scene, AMoveWithoutTheButtonLetsGo)
{
  view.setTool(Tool::Pull);
  QTest::mousePress(&view, Qt::LeftButton, {}, pixelOf(kFront));
  moveTo(pixelOf(kFront) + QPoint(30, 0), Qt::LeftButton);
  ASSERT_EQ(moved.count(), 1);
  moveTo(pixelOf(kFront) + QPoint(60, 0), Qt::NoButton);
  EXPECT_EQ(moved.count(), 1);
  EXPECT_EQ(ended.count(), 1);
  view.setTool(Tool::Camera); // nor does the camera turn by itself
  QTest::mousePress(&view, Qt::LeftButton, {}, QPoint(50, 50));
  moveTo(QPoint(90, 50), Qt::NoButton);
  EXPECT_EQ(camera.count(), 0);
}

TEST_F(Scene, AnotherNetOrAnotherToolLetsGoToo)
{
  view.setTool(Tool::Pull);
  QTest::mousePress(&view, Qt::LeftButton, {}, pixelOf(kFront));
  view.setNet(net, 2);
  EXPECT_EQ(ended.count(), 1);
  QTest::mouseRelease(&view, Qt::LeftButton, {}, pixelOf(kFront));
  QTest::mousePress(&view, Qt::LeftButton, {}, pixelOf(kFront));
  view.setTool(Tool::Camera);
  EXPECT_EQ(ended.count(), 2);
}

// The pull follows the deformed net: the node is where the last snapshot has put it.
TEST_F(Scene, PullFindsNodesWhereTheyAreNow)
{
  SimSnapshot snapshot = samples::restSnapshot(*net, 1, 2);
  snapshot.time = 0.1;
  snapshot.position.row(2).array() += 0.02;
  view.setSnapshot(snapshot);
  view.setTool(Tool::Pull);
  QTest::mousePress(&view, Qt::LeftButton, {}, view.project(snapshot.position.col(kFront)).toPoint());
  ASSERT_EQ(started.count(), 1);
  EXPECT_EQ(started[0][0].toInt(), kFront);
  EXPECT_NEAR(started[0][3].toDouble(), 0.02, 1e-12);
}

// The pole +y is behind the pole -y, on the same pixel.
TEST_F(Scene, SelectNamesTheFrontMostNode)
{
  view.setTool(Tool::Select);
  QTest::mouseClick(&view, Qt::LeftButton, {}, view.project(net->restPosition.col(2)).toPoint());
  ASSERT_EQ(selected.count(), 1);
  EXPECT_EQ(selected[0][0].toInt(), kFront);
  QTest::mouseClick(&view, Qt::LeftButton, {}, {5, 5});
  EXPECT_EQ(selected.count(), 1) << "nothing there";
}

TEST_F(Scene, MiddleButtonTurnsAndSavesWhereWeLookFrom)
{
  drag(Qt::MiddleButton, {320, 240}, {400, 200});
  EXPECT_GE(camera.count(), 1);
  const ViewSettings settings = view.viewSettings();
  EXPECT_LT(settings.azimuth, 0.0) << "the organ follows the mouse to the right, the eye goes left";
  EXPECT_LT(settings.elevation, 0.0) << "and up, the eye goes below";
  EXPECT_GT(settings.distance, 0.0) << "now it is the user's own view";
  EXPECT_NEAR(settings.target.norm(), 0.0, 1e-12);
}

TEST_F(Scene, TheCameraToolTurnsWithTheLeftButton)
{
  drag(Qt::LeftButton, pixelOf(kFront), pixelOf(kFront) + QPoint(40, 0));
  EXPECT_NE(view.viewSettings().azimuth, 0.0);
  EXPECT_EQ(started.count(), 0);
}

TEST_F(Scene, RightButtonAndShiftMiddleMoveSideways)
{
  drag(Qt::RightButton, {320, 240}, {350, 240});
  const double moved1 = view.viewSettings().target.x();
  EXPECT_LT(moved1, 0.0);
  EXPECT_EQ(view.viewSettings().azimuth, 0.0);
  drag(Qt::MiddleButton, {320, 240}, {350, 240}, Qt::ShiftModifier);
  EXPECT_NEAR(view.viewSettings().target.x(), 2.0 * moved1, 1e-12);
}

TEST_F(Scene, WheelZoomsToTheCursor)
{
  const QPointF cursor = pixelOf(4);
  const double before = (view.project({0.02, 0, 0}) - view.project({0, 0, 0})).x();
  QWheelEvent event(cursor, view.mapToGlobal(cursor), {}, {0, 240}, Qt::NoButton, {}, Qt::NoScrollPhase,
                    false);
  QApplication::sendEvent(&view, &event);
  EXPECT_GT((view.project({0.02, 0, 0}) - view.project({0, 0, 0})).x(), 1.2 * before);
  const QPointF pole = view.project(net->restPosition.col(4));
  EXPECT_LT(std::hypot(pole.x() - cursor.x(), pole.y() - cursor.y()), 1.0) << "the pole stayed under it";
}

TEST_F(Scene, KeysLookAlongTheAxesAndFit)
{
  const double quarter = std::numbers::pi / 2.0;
  QTest::keyClick(&view, Qt::Key_3);
  EXPECT_NEAR(view.viewSettings().azimuth, quarter, 1e-12);
  QTest::keyClick(&view, Qt::Key_7);
  EXPECT_NEAR(view.viewSettings().elevation, quarter, 1e-12);
  QTest::keyClick(&view, Qt::Key_1);
  EXPECT_EQ(view.viewSettings().azimuth, 0.0);
  EXPECT_EQ(view.viewSettings().elevation, 0.0);
  QTest::keyClick(&view, Qt::Key_Left);
  EXPECT_NE(view.viewSettings().azimuth, 0.0);
  const double fitted = view.project(Vector3d::Zero()).x();
  drag(Qt::RightButton, {320, 240}, {500, 240});
  EXPECT_NE(view.project(Vector3d::Zero()).x(), fitted);
  QTest::keyClick(&view, Qt::Key_F);
  EXPECT_NEAR(view.project(Vector3d::Zero()).x(), fitted, 1e-9);
  EXPECT_EQ(view.viewSettings().distance, 0.0) << "fits itself again";
}

TEST_F(Scene, HasANameForTestsAndForScreenReaders)
{
  EXPECT_EQ(view.objectName(), "view3d");
  EXPECT_FALSE(view.accessibleName().isEmpty());
  EXPECT_EQ(view.focusPolicy(), Qt::StrongFocus);
}

namespace {

/// A region in the middle of the scene that follows its gizmo, as the window makes it.
struct RegionScene : Scene {
  RegionScene()
  {
    region.ellipsoid.semiAxes = {0.03, 0.025, 0.02};
    view.setRegions({region}, 0);
    view.setTool(Tool::Region);
    QObject::connect(&view, &SceneView::regionDragged, &view, [this](const GizmoShape& shape) {
      region.ellipsoid = shape.ellipsoid;
      region.falloff = shape.falloff;
      view.setRegions({region}, 0);
      ++drags;
    });
  }
  QPoint handle(const char* name) const
  {
    const auto places = view.gizmoHandles();
    EXPECT_TRUE(places.contains(QLatin1String(name))) << name;
    return places.value(QLatin1String(name)).toPoint();
  }
  Region region;
  int drags = 0;
  QSignalSpy begun{&view, &SceneView::regionDragStarted};
};

} // namespace

TEST_F(RegionScene, AHandleIsDraggedAndStaysUnderTheMouse)
{
  const QPoint end = handle("stretch x+");
  QTest::mousePress(&view, Qt::LeftButton, {}, end);
  EXPECT_EQ(begun.count(), 1);
  for (int i = 1; i <= 5; ++i) moveTo(end + QPoint(10 * i, 0), Qt::LeftButton);
  QTest::mouseRelease(&view, Qt::LeftButton, {}, end + QPoint(50, 0));
  EXPECT_EQ(drags, 5);
  EXPECT_LE((handle("stretch x+") - end - QPoint(50, 0)).manhattanLength(), 2);
  EXPECT_EQ(region.ellipsoid.semiAxes.y(), 0.025);
  EXPECT_EQ(region.ellipsoid.centre, Vector3d::Zero());
  EXPECT_EQ(camera.count(), 0);
}

TEST_F(RegionScene, ShiftScalesAllSemiAxes)
{
  const QPoint end = handle("stretch z-");
  QTest::mousePress(&view, Qt::LeftButton, {}, end);
  QMouseEvent event(QEvent::MouseMove, QPointF(end + QPoint(0, 40)), view.mapToGlobal(QPointF(end)),
                    Qt::NoButton, Qt::LeftButton, Qt::ShiftModifier);
  QApplication::sendEvent(&view, &event);
  EXPECT_GT(region.ellipsoid.semiAxes.z(), 0.022);
  EXPECT_NEAR(region.ellipsoid.semiAxes.x() / region.ellipsoid.semiAxes.z(), 1.5, 1e-12);
  QTest::mouseRelease(&view, Qt::LeftButton, {}, end);
}

TEST_F(RegionScene, EscTakesTheDragBack)
{
  const Ellipsoid before = region.ellipsoid;
  const QPoint middle = handle("move");
  QTest::mousePress(&view, Qt::LeftButton, {}, middle);
  moveTo(middle + QPoint(60, 40), Qt::LeftButton);
  EXPECT_NE(region.ellipsoid.centre, before.centre);
  QTest::keyClick(&view, Qt::Key_Escape);
  EXPECT_EQ(region.ellipsoid, before);
  const int count = drags;
  moveTo(middle + QPoint(90, 40), Qt::LeftButton);
  QTest::mouseRelease(&view, Qt::LeftButton, {}, middle);
  EXPECT_EQ(drags, count);
}

TEST_F(RegionScene, LockedAndHiddenRegionsHaveNoHandles)
{
  const QPoint middle = handle("move");
  for (const bool locked : {true, false}) {
    region.locked = locked;
    region.visible = locked;
    view.setRegions({region}, 0);
    EXPECT_TRUE(view.gizmoHandles().isEmpty());
    drag(Qt::LeftButton, middle, middle + QPoint(30, 0));
  }
  EXPECT_EQ(begun.count(), 0);
  EXPECT_EQ(camera.count(), 2) << "beside handles the view turns";
}

// Another region is chosen, or this one is locked, while the mouse still drags: the drag is over.
TEST_F(RegionScene, ADragEndsWithItsRegion)
{
  const QPoint middle = handle("move");
  QTest::mousePress(&view, Qt::LeftButton, {}, middle);
  view.setRegions({region, region}, 1);
  moveTo(middle + QPoint(30, 0), Qt::LeftButton);
  EXPECT_EQ(drags, 0);
  QTest::mouseRelease(&view, Qt::LeftButton, {}, middle);
}

TEST_F(Scene, ABoxSelectsTheVisibleNodesInIt)
{
  QSignalSpy changed(&view, &SceneView::selectionChanged);
  view.setTool(Tool::Select);
  drag(Qt::LeftButton, {5, 5}, {320, 475});
  const std::vector<Index> left = view.selection();
  EXPECT_GT(left.size(), 10u);
  for (const Index node : left) {
    EXPECT_LT(net->restPosition(0, node), 0.002);
    EXPECT_LE(net->restPosition(1, node), 1e-12) << "the back is not seen";
  }
  EXPECT_EQ(camera.count(), 0);
  drag(Qt::LeftButton, {320, 5}, {635, 475}, Qt::ShiftModifier);
  EXPECT_GT(view.selection().size(), left.size() + 5);
  drag(Qt::LeftButton, {5, 5}, {635, 475}, Qt::ControlModifier);
  EXPECT_TRUE(view.selection().empty());
  EXPECT_EQ(changed.count(), 3);
}

TEST_F(Scene, AClickSelectsOneNodeAndEscNone)
{
  view.setTool(Tool::Select);
  QTest::mouseClick(&view, Qt::LeftButton, {}, pixelOf(kFront));
  EXPECT_EQ(view.selection(), std::vector<Index>{kFront});
  EXPECT_EQ(selected.count(), 1);
  Index second = kFront + 1; // another one that is seen
  while (second + 1 < net->nodeCount() && view.nodeAt(pixelOf(second)) != second) ++second;
  QTest::mouseClick(&view, Qt::LeftButton, Qt::ShiftModifier, pixelOf(second));
  EXPECT_EQ(view.selection(), (std::vector<Index>{kFront, second}));
  EXPECT_EQ(selected.count(), 1) << "the node of the panel Why stays";
  QTest::keyClick(&view, Qt::Key_Escape);
  EXPECT_TRUE(view.selection().empty());
}
