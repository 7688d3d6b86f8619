// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/viewport/overlay.h"
#include "app/viewport/region_wire.h"
#include "app/viewport/scene_model.h"
#include "tests/app/viewport/sample_nets.h"

#include <gtest/gtest.h>

#include <QLocale>

using namespace esm;

namespace {

SceneModel modelOf(const std::shared_ptr<SpringNet>& net, std::uint64_t generation = 7)
{
  SceneModel model;
  model.setViewport(800, 600);
  model.setNet(net, generation);
  return model;
}

} // namespace

// An organ stands 100 m from the origin: as floats its nodes still differ by less than 10 nm.
TEST(SceneModel, PositionsForTheGpuAreRelativeToTheNetsCentre)
{
  const Eigen::Vector3d centre(100.0, -50.0, 20.0);
  const auto net = samples::sphere(2, 0.05, centre);
  const SceneModel model = modelOf(net);
  const auto vertices = model.nodeVertices();
  ASSERT_EQ(vertices.size(), static_cast<std::size_t>(net->nodeCount()));
  for (std::size_t i = 0; i < vertices.size(); ++i)
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(model.origin()(c) + static_cast<double>(vertices[i].position[c]),
                  net->restPosition(c, static_cast<Eigen::Index>(i)), 1e-8);
}

// The normals of a sphere are its radii. The octahedron's triangles are not all alike, so area weights leave
// an error of the order of the mesh size squared.
TEST(SceneModel, NormalsAreSmoothAndPointOutward)
{
  const auto net = samples::sphere(4, 0.05);
  const auto vertices = modelOf(net).nodeVertices();
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Eigen::Vector3d radial = net->restPosition.col(static_cast<Eigen::Index>(i)).normalized();
    const Eigen::Vector3d normal(vertices[i].normal[0], vertices[i].normal[1], vertices[i].normal[2]);
    EXPECT_GT(normal.dot(radial), 0.998);
  }
}

TEST(SceneModel, NormalsFollowTheDeformation)
{
  const auto net = samples::sphere(3, 0.05);
  SceneModel model = modelOf(net);
  SimSnapshot flat = samples::restSnapshot(*net, 7, 1);
  flat.position.row(2) *= 1e-6; // pressed to a disc: every normal is +-z
  ASSERT_TRUE(model.setSnapshot(flat));
  EXPECT_NEAR(std::abs(model.nodeVertices()[4].normal[2]), 1.0f, 1e-6f);
}

TEST(SceneModel, StiffnessColoursRunOverTheLogarithm)
{
  const auto net = samples::sphere(0, 0.05);
  net->stiffness << 10, 10, 10, 10, 100, 100, 1000, 1000, 1000, 1000, 1000, 1000;
  const SceneModel model = modelOf(net);
  EXPECT_EQ(model.valueRange(), (ValueRange{10.0, 1000.0, true}));
  const auto shares = model.springShares();
  EXPECT_NEAR(shares[0], 0.0f, 1e-6f);
  EXPECT_NEAR(shares[4], 0.5f, 1e-6f);
  EXPECT_NEAR(shares[11], 1.0f, 1e-6f);
}

// One node of an octahedron has four springs; its surface colour is their mean.
TEST(SceneModel, NodesTakeTheMeanOfTheirSprings)
{
  const auto net = samples::sphere(0, 0.05);
  SceneModel model = modelOf(net);
  model.setColouring(Colouring::Force);
  SimSnapshot snapshot = samples::restSnapshot(*net, 7, 1);
  for (Index s = 0; s < net->springCount(); ++s)
    if (net->ends(0, s) == 4 || net->ends(1, s) == 4) snapshot.tension(s) = -0.5; // compressed
  ASSERT_TRUE(model.setSnapshot(snapshot));
  EXPECT_EQ(model.valueRange(), (ValueRange{0.0, 0.5, false}));
  const auto vertices = model.nodeVertices();
  EXPECT_NEAR(vertices[4].value, 1.0f, 1e-6f) << "all four pressed";
  EXPECT_NEAR(vertices[0].value, 0.25f, 1e-6f) << "one of four";
  EXPECT_NEAR(vertices[5].value, 0.0f, 1e-6f) << "none";
}

TEST(SceneModel, StrainIsLengthChangePerRestLength)
{
  const auto net = samples::sphere(1, 0.05);
  SceneModel model = modelOf(net);
  model.setColouring(Colouring::Strain);
  SimSnapshot snapshot = samples::restSnapshot(*net, 7, 1);
  snapshot.position *= 1.1;
  ASSERT_TRUE(model.setSnapshot(snapshot));
  const Eigen::ArrayXd values = model.springValues();
  EXPECT_NEAR(values.minCoeff(), 0.1, 1e-12);
  EXPECT_NEAR(values.maxCoeff(), 0.1, 1e-12);
}

TEST(SceneModel, WithoutAValueThereIsTheMark)
{
  const auto net = samples::sphere(0, 0.05);
  net->stiffness(0) = 0.0; // a logarithm has no place for it
  EXPECT_EQ(modelOf(net).springShares()[0], kNoValue);
}

// Nothing is drawn again when nothing has changed.
TEST(SceneModel, OnlyNewPicturesCount)
{
  const auto net = samples::sphere(1, 0.05);
  SceneModel model = modelOf(net);
  SimSnapshot snapshot = samples::restSnapshot(*net, 7, 1);
  EXPECT_FALSE(model.setSnapshot(snapshot)) << "the rest state is already shown";
  snapshot.sequence = 2;
  snapshot.time = 0.1;
  snapshot.position.col(0) *= 1.2;
  EXPECT_TRUE(model.setSnapshot(snapshot));
  EXPECT_FALSE(model.setSnapshot(snapshot)) << "same sequence";
  snapshot.sequence = 3;
  EXPECT_FALSE(model.setSnapshot(snapshot)) << "paused: a new message, the same state";
  snapshot.sequence = 4;
  snapshot.generation = 6;
  snapshot.position.col(0) *= 1.2;
  EXPECT_FALSE(model.setSnapshot(snapshot)) << "of an older net";
}

// A hand that lets go has none; nodes that the net does not have are not asked for.
TEST(SceneModel, HeldNodesAreThoseInTheHand)
{
  const auto net = samples::sphere(1, 0.05);
  SceneModel model = modelOf(net);
  SimSnapshot snapshot = samples::restSnapshot(*net, 7, 2);
  snapshot.grabbedNode = 3;
  snapshot.heldNodes = {3, 5, net->nodeCount(), kNoIndex};
  EXPECT_TRUE(model.setSnapshot(snapshot));
  EXPECT_EQ(model.heldNodes(), (std::vector<Index>{3, 5}));
  snapshot.sequence = 3;
  snapshot.grabbedNode = kNoIndex;
  EXPECT_TRUE(model.setSnapshot(snapshot));
  EXPECT_TRUE(model.heldNodes().empty());
}

// Time goes on over a net that rests: nothing to draw, but for a legend that draws in after a pull.
TEST(SceneModel, ANetAtRestIsNotDrawnAgain)
{
  const auto net = samples::sphere(1, 0.05);
  SceneModel model = modelOf(net);
  model.setColouring(Colouring::Force);
  SimSnapshot snapshot = samples::restSnapshot(*net, 7, 1);
  const auto later = [&](double seconds) {
    ++snapshot.sequence;
    snapshot.time += seconds;
    return model.setSnapshot(snapshot);
  };
  snapshot.revision = 1;
  snapshot.tension(0) = 9.0;
  EXPECT_TRUE(later(0.1));
  EXPECT_EQ(model.valueRange().high, 10.0);
  snapshot.revision = 2;
  snapshot.tension(0) = 0.5;
  EXPECT_TRUE(later(0.1));
  model.dirty = {false, false, false, false};
  EXPECT_FALSE(later(0.1));
  EXPECT_FALSE(model.dirty.frame);
  EXPECT_TRUE(later(30.0)) << "half lives of three seconds";
  EXPECT_TRUE(model.dirty.frame);
  EXPECT_EQ(model.valueRange().high, 0.5);
  EXPECT_FALSE(later(30.0));
}

TEST(SceneModel, ViewSettingsRoundTrip)
{
  SceneModel model = modelOf(samples::sphere(1, 0.05));
  ViewSettings settings;
  settings.target = {0.1, 0.2, 0.3};
  settings.distance = 0.7;
  settings.azimuth = -1.2;
  settings.elevation = 0.9;
  settings.colouring = "force";
  settings.showSprings = false;
  settings.showStruts = true;
  model.setViewSettings(settings);
  const ViewSettings back = model.viewSettings();
  EXPECT_EQ(back.target, settings.target);
  EXPECT_EQ(back.distance, settings.distance);
  EXPECT_EQ(back.azimuth, settings.azimuth);
  EXPECT_EQ(back.elevation, settings.elevation);
  EXPECT_EQ(back.colouring, "force");
  EXPECT_TRUE(back.showSurface);
  EXPECT_FALSE(back.showSprings);
  EXPECT_TRUE(back.showStruts);
}

// distance = 0 in a project means "fit": the camera fits, the project still says 0.
TEST(SceneModel, FittingByItselfIsNotAChangeOfTheProject)
{
  SceneModel model = modelOf(samples::sphere(1, 0.05, {1.0, 2.0, 3.0}));
  model.setViewSettings(ViewSettings{});
  EXPECT_EQ(model.viewSettings().distance, 0.0);
  EXPECT_LT((model.camera.target() - Eigen::Vector3d(1.0, 2.0, 3.0)).norm(), 1e-12);
  const double wide = model.camera.distance();
  model.setViewport(200, 600);
  EXPECT_GT(model.camera.distance(), wide) << "refits to a narrower picture";
  model.cameraMoved();
  EXPECT_GT(model.viewSettings().distance, 0.0);
}

TEST(SceneModel, AHiddenNodeIsPickedOnceTheSurfaceIsOff)
{
  const auto net = samples::sphere(2, 0.05);
  SceneModel model = modelOf(net);
  model.camera.setDirection(0.0, 0.0);
  SimSnapshot snapshot = samples::restSnapshot(*net, 7, 1);
  snapshot.time = 0.1;
  snapshot.position.col(0) = Eigen::Vector3d(0.0, 0.01, 0.017); // drawn inside the ball, beside other nodes
  model.setSnapshot(snapshot);
  const Eigen::Vector2d inside = model.camera.project(snapshot.position.col(0)).pixel;
  EXPECT_NE(model.nodeAt(inside), 0);
  model.setShown(false, true, false);
  model.setViewport(2400, 1800); // so that no other node is within the pick radius
  EXPECT_EQ(model.nodeAt(model.camera.project(snapshot.position.col(0)).pixel), 0);
}

TEST(SceneModel, AnEmptySceneAnswersToo)
{
  SceneModel model;
  model.setNet(nullptr, 1);
  EXPECT_TRUE(model.nodeVertices().empty());
  EXPECT_TRUE(model.springShares().empty());
  EXPECT_EQ(model.nodeAt({10, 10}), kNoIndex);
  EXPECT_FALSE(model.setSnapshot(SimSnapshot{}));
}

// Weights of the chosen region at the springs' midpoints at rest, whatever the net does; grey without a
// region.
TEST(SceneModel, TheWeightOfTheChosenRegionColoursTheSprings)
{
  SceneModel model;
  const auto net = samples::sphere(2, 0.05);
  model.setNet(net, 1);
  model.setColouring(Colouring::RegionWeight);
  for (const float share : model.springShares()) EXPECT_EQ(share, kNoValue);
  Region region;
  region.ellipsoid.centre = {0.05, 0, 0};
  region.ellipsoid.semiAxes.setConstant(0.04);
  model.dirty = {false, false, false, false};
  model.setRegions({region}, 0);
  EXPECT_TRUE(model.dirty.frame) << "in the same frame";
  EXPECT_EQ(model.valueRange(), (ValueRange{0.0, 1.0, false}));
  const auto expect = [&] {
    const Eigen::ArrayXd weights = model.springValues();
    double most = 0.0;
    for (Index s = 0; s < net->springCount(); ++s) {
      const Eigen::Vector3d middle =
        0.5 * (net->restPosition.col(net->ends(0, s)) + net->restPosition.col(net->ends(1, s)));
      EXPECT_NEAR(weights(s), falloffWeight(region.ellipsoid.radius(middle), region.falloff), 1e-12) << s;
      most = std::max(most, weights(s));
    }
    EXPECT_GT(most, 0.9);
  };
  expect();
  SimSnapshot snapshot = samples::restSnapshot(*net, 1, 2);
  snapshot.time = 0.1;
  snapshot.position.row(0).array() += 0.02;
  model.setSnapshot(snapshot);
  expect();
  region.falloff = 0.9;
  model.setRegions({region}, 0);
  expect();
}

TEST(SceneModel, OnlyVisibleUnlockedRegionsHaveAGizmo)
{
  SceneModel model;
  Region region;
  model.setRegions({region}, -1);
  EXPECT_EQ(model.gizmoRegion(), nullptr);
  model.setRegions({region}, 0);
  EXPECT_NE(model.gizmoRegion(), nullptr);
  region.locked = true;
  model.setRegions({region}, 0);
  EXPECT_EQ(model.gizmoRegion(), nullptr);
  EXPECT_NE(model.chosenRegion(), nullptr);
  region.locked = false;
  region.visible = false;
  model.setRegions({region}, 0);
  EXPECT_EQ(model.gizmoRegion(), nullptr);
}

TEST(SceneModel, SelectedNodesAreRisingAndOfThisNet)
{
  SceneModel model;
  const auto net = samples::sphere(1, 0.05);
  model.setNet(net, 1);
  EXPECT_TRUE(model.setSelection({5, 2, 5, -1, 100000}));
  EXPECT_EQ(model.selection(), (std::vector<Index>{2, 5}));
  EXPECT_FALSE(model.setSelection({2, 5}));
  model.setNet(net, 2);
  EXPECT_TRUE(model.selection().empty());
}

// All wire points satisfy the ellipsoid's equation, to float rounding.
TEST(RegionWire, LiesOnTheEllipsoid)
{
  Ellipsoid ellipsoid;
  ellipsoid.centre = {0.1, 0.2, 0.3};
  ellipsoid.semiAxes = {0.01, 0.02, 0.03};
  ellipsoid.rotation = Eigen::AngleAxisd(0.8, Eigen::Vector3d(1, 2, 3).normalized());
  const Eigen::Vector3d origin(0.1, 0.2, 0.25);
  std::vector<float> lines;
  appendRegionWire(ellipsoid, origin, lines);
  ASSERT_GT(lines.size(), 600u);
  ASSERT_EQ(lines.size() % 6, 0u);
  for (std::size_t i = 0; i < lines.size(); i += 3)
    EXPECT_NEAR(ellipsoid.radius(origin + Eigen::Vector3d(lines[i], lines[i + 1], lines[i + 2])), 1.0, 1e-5);
  ellipsoid.centre.x() = NAN;
  std::vector<float> none;
  appendRegionWire(ellipsoid, origin, none);
  EXPECT_TRUE(none.empty());
}

// Spines stand outside, from the surface to an eighth of the radius beyond it; dashes lie on the surface.
TEST(RegionWire, SpinesStandOutward)
{
  Ellipsoid ellipsoid;
  ellipsoid.semiAxes = {0.01, 0.02, 0.03};
  std::vector<float> spines, shell;
  appendRegionSpines(ellipsoid, Eigen::Vector3d::Zero(), spines);
  appendRegionShell(ellipsoid, Eigen::Vector3d::Zero(), shell);
  ASSERT_EQ(spines.size() % 6, 0u);
  for (std::size_t i = 0; i < spines.size(); i += 6) {
    EXPECT_NEAR(ellipsoid.radius({spines[i], spines[i + 1], spines[i + 2]}), 1.0, 1e-5);
    EXPECT_NEAR(ellipsoid.radius({spines[i + 3], spines[i + 4], spines[i + 5]}), 1.12, 1e-5);
  }
  for (std::size_t i = 0; i < shell.size(); i += 3)
    EXPECT_NEAR(ellipsoid.radius({shell[i], shell[i + 1], shell[i + 2]}), 1.0, 1e-5);
}

// As a physician reads it, in the user's locale; 'e' notation only for absurd sizes.
TEST(LegendNumber, IsShortAndLocal)
{
  QLocale::setDefault(QLocale::c());
  EXPECT_EQ(legendNumber(0.0), "0");
  EXPECT_EQ(legendNumber(0.05), "0.05");
  EXPECT_EQ(legendNumber(0.1 * 3), "0.3");
  EXPECT_EQ(legendNumber(2000.0), "2000");
  QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
  EXPECT_EQ(legendNumber(0.5), "0,5");
  EXPECT_EQ(legendNumber(2000.0), "2.000");
  QLocale::setDefault(QLocale::c());
}

// A click means what is nearer to it: the node at an end, the spring around its middle.
TEST(SceneModel, ClicksNearASpringsMiddleMeanTheSpring)
{
  const auto net = samples::sphere(0, 0.05);
  const SceneModel model = modelOf(net);
  int meant = 0;
  for (Index s = 0; s < net->springCount(); ++s) {
    const Eigen::Vector2d middle = model.camera.project(model.middleOf(s)).pixel;
    const Eigen::Vector2d end = model.camera.project(net->restPosition.col(net->ends(0, s))).pixel;
    meant += model.springAt(middle) == s ? 1 : 0;
    EXPECT_EQ(model.springAt(end), kNoIndex) << "at its end";
  }
  EXPECT_GE(meant, 5) << "of the twelve edges of an octahedron those in front";
}

// What is not drawn is not meant: hidden struts are out of the way of a click.
TEST(SceneModel, ClicksMeanAStrutOnlyWhileStrutsAreShown)
{
  const auto net = samples::sphere(0, 0.05);
  net->triangles.resize(3, 0); // nothing hides it
  std::fill(net->kind.begin(), net->kind.end(), SpringKind::Strut);
  SceneModel model = modelOf(net);
  const Eigen::Vector2d middle = model.camera.project(model.middleOf(0)).pixel;
  EXPECT_EQ(model.springAt(middle), kNoIndex);
  model.setShown(true, true, true);
  EXPECT_NE(model.springAt(middle), kNoIndex);
}
