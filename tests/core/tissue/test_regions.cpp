// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/tissue/region_edit.h"

#include "tests/core/tissue/field_of.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace esm {
namespace {

using test::fieldOf;

using Vector = Eigen::Vector3d;

Region tilted()
{
  Region region;
  region.name = "spot";
  region.ellipsoid.centre = {0.01, -0.02, 0.005};
  region.ellipsoid.semiAxes = {0.03, 0.015, 0.01};
  region.ellipsoid.rotation = Eigen::Quaterniond(0.8, 0.3, -0.4, 0.2).normalized();
  region.inputs = defaultTissue().inputs;
  region.inputs[0] = 0.9;
  return region;
}

Vector randomPoint(std::mt19937& random, double reach)
{
  const auto component = [&] { return reach * (2.0 * 0x1p-32 * static_cast<double>(random()) - 1.0); };
  const double x = component(), y = component();
  return {x, y, component()};
}

constexpr FalloffProfile kProfiles[] = {FalloffProfile::Smooth, FalloffProfile::Linear,
                                        FalloffProfile::Smoother};

// From 1 in the core to 0 outside, never rising, and never faster than the profile's slope says; somewhere
// nearly as fast (within 1 %), so that the slope is no idle bound.
TEST(FalloffProfile, FallsFromOneToZeroNoFasterThanItsSlope)
{
  for (const FalloffProfile profile : kProfiles) {
    double steepest = 0.0;
    for (const double falloff : {0.1, 0.3, 1.0}) {
      EXPECT_EQ(profileWeight(profile, 1.0 - falloff, falloff), 1.0);
      EXPECT_EQ(profileWeight(profile, 1.0, falloff), 0.0);
      EXPECT_NEAR(profileWeight(profile, 1.0 - 0.5 * falloff, falloff), 0.5, 1e-12);
      for (int i = 0; i < 1100; ++i) {
        const double fall =
          profileWeight(profile, 0.001 * i, falloff) - profileWeight(profile, 0.001 * (i + 1), falloff);
        EXPECT_GE(fall, 0.0);
        steepest = std::max(steepest, fall * falloff / 0.001);
      }
    }
    EXPECT_LE(steepest, steepestSlope(profile) * (1.0 + 1e-9));
    EXPECT_GE(steepest, steepestSlope(profile) * 0.99);
    EXPECT_EQ(profileWeight(profile, 0.999, 0.0), 1.0) << "a hard border";
    EXPECT_EQ(profileWeight(profile, std::nan(""), 0.3), 0.0);
  }
}

// No seam: along any line through space the logarithm of each parameter changes per metre by no more than
// slope / falloff / smallest semi-axis times the difference of both tissues. 1e-9: rounding of logarithms.
TEST(Regions, LogParametersHaveNoSeam)
{
  for (const FalloffProfile profile : kProfiles)
    for (const bool insideOut : {false, true}) {
      TissueModel model = defaultTissue();
      model.regions = {tilted()};
      Region& region = model.regions[0];
      region.profile = profile;
      region.insideOut = insideOut;
      region.mirror = MirrorPlane{{0.0, 0.0, 0.01}, {0.2, 0.1, 1.0}};
      for (auto& input : region.inputs) input = 0.85;
      const TissueField field = fieldOf(model);
      const double steepest = steepestSlope(profile) / region.falloff / region.ellipsoid.semiAxes.minCoeff();
      const TissueParameters own = field.regions()[0].own;
      std::mt19937 random(3);
      for (int line = 0; line < 20; ++line) {
        const Vector from = randomPoint(random, 0.05), to = randomPoint(random, 0.05);
        constexpr int kSteps = 500;
        TissueParameters last = field.at(from);
        for (int i = 1; i <= kSteps; ++i) {
          const TissueParameters next = field.at(from + (to - from) * (double(i) / kSteps));
          const double share = steepest * (to - from).norm() / kSteps;
          for (const TissueOutput& output : kTissueOutputs) {
            const double whole = std::abs(std::log(own.*output.value / field.base().*output.value));
            ASSERT_LE(std::abs(std::log(next.*output.value / last.*output.value)), share * whole + 1e-9)
              << output.id;
          }
          last = next;
        }
      }
    }
}

TEST(Regions, InsideOutIsAllSpaceButTheEllipsoid)
{
  Region region = tilted();
  const RegionShape inside(region);
  region.insideOut = true;
  const RegionShape outside(region);
  std::mt19937 random(4);
  for (int i = 0; i < 200; ++i) {
    const Vector p = randomPoint(random, 0.05);
    EXPECT_EQ(outside.weight(p), 1.0 - inside.weight(p));
  }
  EXPECT_EQ(outside.weight({1e9, 0, 0}), 1.0);
  EXPECT_EQ(outside.weight({std::nan(""), 0, 0}), 0.0) << "no place, no tissue";
}

// The shape made ready gives what the definition gives. 1e-12: another order of the same products.
TEST(Regions, AShapeMadeReadyHasTheEllipsoidsWeights)
{
  const Region region = tilted();
  const RegionShape shape(region);
  std::mt19937 random(5);
  int within = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vector p = region.ellipsoid.centre + randomPoint(random, 0.03);
    const double expected = falloffWeight(region.ellipsoid.radius(p), region.falloff);
    EXPECT_NEAR(shape.weight(p), expected, 1e-12);
    within += expected > 0.0 && expected < 1.0 ? 1 : 0;
  }
  EXPECT_GT(within, 50) << "the falloff was met";
}

// A region with a twin is the same seen in the mirror. 1e-9 relative: rounding of the reflection, times the
// slope.
TEST(Regions, AMirroredCopyMakesAMirroredField)
{
  TissueModel model = defaultTissue();
  model.regions = {tilted()};
  const MirrorPlane plane{{0.02, 0.01, 0.0}, {2.0, -1.0, 0.5}};
  model.regions[0].mirror = plane;
  const TissueField field = fieldOf(model);
  model.regions[0].mirror.reset();
  const TissueField single = fieldOf(model);
  std::mt19937 random(6);
  int inTwin = 0;
  for (int i = 0; i < 10000; ++i) {
    const Vector p = randomPoint(random, 0.06);
    const double here = field.at(p).youngsModulus, there = field.at(plane.reflect(p)).youngsModulus;
    EXPECT_NEAR(here / there, 1.0, 1e-9);
    inTwin += here != single.at(p).youngsModulus ? 1 : 0;
    const double larger = std::max(single.at(p).youngsModulus, single.at(plane.reflect(p)).youngsModulus);
    EXPECT_NEAR(here / larger, 1.0, 1e-9) << "harder than the base: the larger weight is the larger modulus";
  }
  EXPECT_GT(inTwin, 20);
}

TEST(Regions, AMirroredEllipsoidHoldsTheMirroredPoints)
{
  const Ellipsoid ellipsoid = tilted().ellipsoid;
  const MirrorPlane plane{{0.02, 0.01, 0.0}, {2.0, -1.0, 0.5}};
  const Ellipsoid twin = mirrored(ellipsoid, plane);
  EXPECT_NEAR(twin.rotation.norm(), 1.0, 1e-14);
  std::mt19937 random(7);
  for (int i = 0; i < 100; ++i) {
    const Vector p = randomPoint(random, 0.06);
    EXPECT_NEAR(twin.radius(plane.reflect(p)), ellipsoid.radius(p), 1e-12);
  }
}

/// Points on the surface of an ellipsoid, both ends of every diameter, so that their mean is the centre.
Eigen::Matrix3Xd surfaceOf(const Ellipsoid& ellipsoid)
{
  constexpr int kRings = 24, kPerRing = 24;
  Eigen::Matrix3Xd points(3, kRings * kPerRing);
  for (int ring = 0; ring < kRings; ++ring)
    for (int i = 0; i < kPerRing; ++i) { // rings of equal height have equal area on a sphere (Archimedes)
      const double z = (2.0 * ring + 1.0) / kRings - 1.0, angle = 2.0 * 3.14159265358979323846 * i / kPerRing;
      const double r = std::sqrt(1.0 - z * z);
      points.col(ring * kPerRing + i) = Vector(r * std::cos(angle), r * std::sin(angle), z);
    }
  return (ellipsoid.rotation.toRotationMatrix() * ellipsoid.semiAxes.asDiagonal() * points).colwise() +
         ellipsoid.centre;
}

// The rings end short of the poles, by 1/24 of the sphere's height: 1e-3 of a semi-axis. As much is left by
// weights that are found to 1e-3.
TEST(FitEllipsoid, RecoversAKnownEllipsoid)
{
  const Ellipsoid known = tilted().ellipsoid;
  const auto fitted = fitEllipsoid(surfaceOf(known), 1e-4);
  ASSERT_TRUE(fitted);
  EXPECT_LT((fitted->centre - known.centre).norm(), 1e-3 * known.semiAxes.minCoeff());
  EXPECT_LT((fitted->semiAxes - known.semiAxes).cwiseQuotient(known.semiAxes).cwiseAbs().maxCoeff(), 3e-3);
  const Eigen::Matrix3d turn =
    known.rotation.toRotationMatrix().transpose() * fitted->rotation.toRotationMatrix();
  EXPECT_LT((turn.cwiseAbs() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff(), 1e-3)
    << "the same axes, in the order of their length";
}

// The first two axes point to where their largest component is above zero: the next fit of a patch like it,
// or the same after it was reordered, does not turn the handles round.
TEST(FitEllipsoid, ItsAxesPointTheSameWayEachTime)
{
  std::mt19937 random(3);
  std::normal_distribution<double> spread;
  for (int cloud = 0; cloud < 50; ++cloud) {
    Eigen::Matrix3d shape;
    for (double& entry : shape.reshaped()) entry = spread(random);
    Eigen::Matrix3Xd places(3, 40);
    for (double& entry : places.reshaped()) entry = spread(random);
    const Result<Ellipsoid> fit = fitEllipsoid(0.01 * shape * places, 1e-6, 0.3);
    ASSERT_TRUE(fit);
    const Eigen::Matrix3d axes = fit->rotation.toRotationMatrix();
    for (int i = 0; i < 2; ++i) {
      Eigen::Index largest = 0;
      axes.col(i).cwiseAbs().maxCoeff(&largest);
      EXPECT_GT(axes(largest, i), 0.0) << "cloud " << cloud << ", axis " << i;
    }
  }
}

TEST(FitEllipsoid, HoldsEveryPlaceInItsCore)
{
  std::mt19937 random(8);
  for (const int count : {1, 2, 3, 4, 50})
    for (const double falloff : {0.0, 0.3, 0.9}) {
      Eigen::Matrix3Xd places(3, count);
      for (int i = 0; i < count; ++i) places.col(i) = randomPoint(random, 0.02);
      const auto fitted = fitEllipsoid(places, 1e-3, falloff);
      ASSERT_TRUE(fitted) << fitted.error().detail;
      Region region;
      region.ellipsoid = *fitted;
      region.falloff = falloff;
      EXPECT_GE(fitted->semiAxes.minCoeff(), 1e-3);
      EXPECT_GT(fitted->rotation.toRotationMatrix().determinant(), 0.99);
      for (int i = 0; i < count; ++i)
        EXPECT_EQ(RegionShape(region).weight(places.col(i)), 1.0) << count << " places, falloff " << falloff;
    }
}

// The smallest ellipsoid around a cube is its circumsphere, wherever the selection is dense. The weights are
// found to 1e-3 of the volume's exponent, which leaves the third part of it in each of three semi-axes.
TEST(FitEllipsoid, IsTheSmallestWhateverLiesInside)
{
  std::mt19937 random(9);
  Eigen::Matrix3Xd places(3, 308);
  for (int i = 0; i < 8; ++i) places.col(i) = 0.01 * Vector(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  for (int i = 8; i < 308; ++i) places.col(i) = Vector(0.006, 0.006, 0.006) + randomPoint(random, 0.004);
  const auto fitted = fitEllipsoid(places, 1e-4);
  ASSERT_TRUE(fitted);
  EXPECT_LT(fitted->centre.norm(), 2e-3 * 0.01);
  EXPECT_LT((fitted->semiAxes.array() / (0.01 * std::sqrt(3.0)) - 1.0).abs().maxCoeff(), 2e-3);
}

// A patch of an organ's wall: a cap of a sphere. No ellipsoid around it need be much wider than the cap.
TEST(FitEllipsoid, KeepsToACurvedPatch)
{
  const double width = 0.006, radius = 0.01;
  std::vector<Vector> cap;
  for (double x = -width; x <= width; x += 5e-4)
    for (double y = -width; y <= width; y += 5e-4)
      if (x * x + y * y <= width * width) cap.emplace_back(x, y, std::sqrt(radius * radius - x * x - y * y));
  Eigen::Matrix3Xd places(3, static_cast<Eigen::Index>(cap.size()));
  for (std::size_t i = 0; i < cap.size(); ++i) places.col(static_cast<Eigen::Index>(i)) = cap[i];
  const auto fitted = fitEllipsoid(places, 1e-4);
  ASSERT_TRUE(fitted);
  EXPECT_LT(fitted->semiAxes.maxCoeff(), 1.1 * width);
}

TEST(FitEllipsoid, RefusesWhatHasNoEllipsoid)
{
  Eigen::Matrix3Xd place = Eigen::Matrix3Xd::Zero(3, 1);
  EXPECT_FALSE(fitEllipsoid(Eigen::Matrix3Xd(3, 0), 1e-3));
  EXPECT_FALSE(fitEllipsoid(place, 0.0));
  EXPECT_FALSE(fitEllipsoid(place, 1e-3, 1.0));
  place(0, 0) = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(fitEllipsoid(place, 1e-3));
}

TissueModel threeRegions()
{
  TissueModel model = defaultTissue();
  for (const char* name : {"a", "b", "c"}) {
    model.regions.push_back(tilted());
    model.regions.back().name = name;
    model.regions.back().inputs[0] = 0.1 * (1 + name[0] - 'a');
  }
  return model;
}

std::string order(const TissueModel& model)
{
  std::string names;
  for (const Region& region : model.regions) names += region.name;
  return names;
}

TEST(RegionEdit, OrderIsMeaning)
{
  TissueModel model = threeRegions();
  const Vector inside = model.regions[0].ellipsoid.centre;
  const double top = fieldOf(model).at(inside).youngsModulus;
  ASSERT_TRUE(moveRegion(model, 2, 0));
  EXPECT_EQ(order(model), "cab");
  EXPECT_LT(fieldOf(model).at(inside).youngsModulus, top) << "b is on top now, and softer";
  ASSERT_TRUE(moveRegion(model, 0, 2));
  EXPECT_EQ(order(model), "abc");
  EXPECT_EQ(fieldOf(model).at(inside).youngsModulus, top);
  ASSERT_TRUE(insertRegion(model, 1, tilted()));
  ASSERT_TRUE(removeRegion(model, 0));
  EXPECT_EQ(order(model), "spotbc");
}

TEST(RegionEdit, ALockedRegionStaysAsItIs)
{
  TissueModel model = threeRegions();
  ASSERT_TRUE(lockRegion(model, 1, true));
  EXPECT_FALSE(removeRegion(model, 1));
  EXPECT_FALSE(moveRegion(model, 1, 0));
  EXPECT_FALSE(detachTwin(model, 1));
  const Status refused = replaceRegion(model, 1, tilted());
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().detail.find("region 2 'b' is locked"), std::string::npos)
    << refused.error().detail;
  EXPECT_EQ(order(model), "abc");

  ASSERT_TRUE(moveRegion(model, 0, 2)) << "others may pass it";
  EXPECT_EQ(order(model), "bca");
  ASSERT_TRUE(lockRegion(model, 0, false));
  ASSERT_TRUE(replaceRegion(model, 0, tilted()));
  EXPECT_EQ(order(model), "spotca");
}

// What lock and eye say does not reach the tissue.
TEST(RegionEdit, LockAndVisibilityMeanNothingToTissue)
{
  TissueModel model = threeRegions();
  const Vector inside = model.regions[0].ellipsoid.centre;
  const double modulus = fieldOf(model).at(inside).youngsModulus;
  model.regions[2].locked = true;
  model.regions[2].visible = false;
  EXPECT_EQ(fieldOf(model).at(inside).youngsModulus, modulus);
}

TEST(RegionEdit, PlacesThatDoNotExistAreRefused)
{
  TissueModel model = threeRegions();
  EXPECT_FALSE(insertRegion(model, 4, tilted()));
  EXPECT_FALSE(replaceRegion(model, 3, tilted()));
  EXPECT_FALSE(removeRegion(model, 3));
  EXPECT_FALSE(moveRegion(model, 0, 3));
  EXPECT_FALSE(moveRegion(model, 3, 0));
  EXPECT_FALSE(lockRegion(model, 3, true));
  EXPECT_EQ(order(model), "abc");
}

// Apart from where the two overlap, the twin as a region of its own makes the same tissue.
TEST(RegionEdit, ADetachedTwinIsARegionOfItsOwn)
{
  TissueModel model = defaultTissue();
  model.regions = {tilted()};
  EXPECT_FALSE(detachTwin(model, 0)) << "there is none";
  model.regions[0].mirror = MirrorPlane{{0.1, 0, 0}, {1, 0, 0}};
  const TissueField before = fieldOf(model);
  model.regions[0].insideOut = true;
  EXPECT_FALSE(detachTwin(model, 0)) << "outside of both is no union";
  model.regions[0].insideOut = false;
  ASSERT_TRUE(detachTwin(model, 0));
  ASSERT_EQ(model.regions.size(), 2U);
  EXPECT_FALSE(model.regions[0].mirror || model.regions[1].mirror);
  const TissueField after = fieldOf(model);
  std::mt19937 random(9);
  for (int i = 0; i < 1000; ++i) {
    const Vector p = Vector(0.1, 0, 0) + randomPoint(random, 0.14);
    EXPECT_EQ(after.at(p).youngsModulus, before.at(p).youngsModulus);
  }
}

} // namespace
} // namespace esm
