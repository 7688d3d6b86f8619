// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/learning/recording_csv.h"

#include "core/learning/statics.h"

#include "tests/core/learning/blocks.h"
#include "tests/support/dice.h"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>

namespace {

using namespace esm;
using namespace esm::test;
using namespace esm::learning;
using testing::HasSubstr;

class RecordingCsv : public testing::Test {
protected:
  RecordingCsv() : net(block({8, 4, 4}))
  {
    for (NodeId& id : net.nodeId) id = NodeId{static_cast<Index>(id) + 100};
    recording.name = "r.csv";
    recording.loads.forces = {sharedForce(nodesNear(net, {0.05, 0.015, 0.03}, 0.012), {0.1, 0.05, -0.2})};
    Statics statics(net, recording.loads);
    EXPECT_EQ(statics.solve().outcome, StaticsOutcome::Balanced);
    recording.position.resize(3, net.nodeCount());
    copyNodes(statics.place(), recording.position);
    for (Index i = 0; i < net.nodeCount(); ++i) recording.markers.push_back(Marker::ofNode(i));
  }

  /// What is said of the recording with its places changed by `change`.
  std::string saidOf(const std::function<Eigen::Vector3d(Eigen::Vector3d)>& change) const
  {
    Recording other = recording;
    for (Eigen::Index m = 0; m < other.position.cols(); ++m)
      other.position.col(m) = change(recording.position.col(m));
    const auto read = readRecordingCsv(recordingCsv(other, net), "r.csv", net);
    return read ? "" : read.error().detail;
  }

  SpringNet net;
  Recording recording;
};

TEST_F(RecordingCsv, WhatIsWrittenIsReadBackToTheBit)
{
  recording.loads.gravity = {0.0, 0.1, -9.81};
  PrescribedMotion move;
  move.nodes = {40};
  move.displacement.time = {0.0};
  move.displacement.value = Eigen::Vector3d(1e-3, 0.0, 2e-3);
  recording.loads.motions = {move};
  recording.weight.assign(recording.markers.size(), 1024.0);
  const auto read = readRecordingCsv(recordingCsv(recording, net), "r.csv", net);
  ASSERT_TRUE(read) << read.error().detail;
  EXPECT_EQ(recordingCsv(*read, net), recordingCsv(recording, net));
  EXPECT_TRUE(read->position == recording.position);
  EXPECT_EQ(read->weight, recording.weight);
  EXPECT_EQ(read->loads.gravity, recording.loads.gravity);
}

TEST_F(RecordingCsv, MarkersOffTheNodesAreTiedToTheSurface)
{
  const auto read = readRecordingCsv("what;x;y;z;vx;vy;vz\n"
                                     "marker;0,012;0,013;0,031;0,013;0,013;0,031\n"
                                     "force;0,03;0,02;0,03;0;0;-0,2\n",
                                     "r.csv", net);
  ASSERT_TRUE(read) << read.error().detail;
  const Marker& marker = read->markers[0];
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < 3; ++k) place += marker.share[k] * net.restPosition.col(marker.node[k]);
  EXPECT_LE((place - Eigen::Vector3d(0.012, 0.013, 0.03)).norm(), 1e-15); // straight down to the top
  EXPECT_LE((read->position.col(0) - place - Eigen::Vector3d(1e-3, 0, 0)).norm(), 1e-15);
  EXPECT_EQ(read->loads.forces[0].nodes[0], 3 + 8 * (2 + 4 * 3));
}

TEST_F(RecordingCsv, PlacesInMillimetresAreNamed)
{
  EXPECT_EQ(saidOf([](const Eigen::Vector3d& p) { return p; }), "");
  EXPECT_THAT(saidOf([](const Eigen::Vector3d& p) { return Eigen::Vector3d(1e3 * p); }),
              HasSubstr("--length-unit mm"));
  EXPECT_THAT(saidOf([](const Eigen::Vector3d& p) { return Eigen::Vector3d(1e2 * p); }),
              HasSubstr("--length-unit cm"));
  Recording other = recording;
  other.position *= 1e3;
  for (NodalForce& force : other.loads.forces) force.force.value *= 1e3;
  const auto read = readRecordingCsv(recordingCsv(other, net), "r.csv", net, {1e-3, 1e-3});
  ASSERT_TRUE(read) << read.error().detail;
  EXPECT_TRUE(read->position.isApprox(recording.position, 1e-14));
  EXPECT_TRUE(read->loads.forces[0].force.value.isApprox(recording.loads.forces[0].force.value, 1e-14));
}

TEST_F(RecordingCsv, MirroredAndExchangedAxesAreNamed)
{
  EXPECT_THAT(saidOf([](const Eigen::Vector3d& p) { return Eigen::Vector3d(-p.x(), -p.y(), p.z()); }),
              HasSubstr("its x is -x, its y is -y"));
  EXPECT_THAT(saidOf([](const Eigen::Vector3d& p) { return Eigen::Vector3d(p.x(), p.z(), -p.y()); }),
              HasSubstr("its y is z, its z is -y"));
  EXPECT_THAT(saidOf([](const Eigen::Vector3d& p) { return Eigen::Vector3d(p.x() + 1.0, p.y(), p.z()); }),
              HasSubstr("origin"));
}

TEST_F(RecordingCsv, ExchangedIdsAreNamed)
{
  for (const auto& [a, b] : {std::pair{60, 61}, std::pair{60, 125}}) {
    Recording other = recording;
    other.position.col(a).swap(other.position.col(b));
    const auto read = readRecordingCsv(recordingCsv(other, net), "r.csv", net);
    ASSERT_FALSE(read);
    EXPECT_THAT(read.error().detail,
                HasSubstr("node " + std::to_string(a + 100) + " and node " + std::to_string(b + 100)));
  }
}

TEST_F(RecordingCsv, ForcesInMillinewtonsAreNamed)
{
  EXPECT_TRUE(checkForceUnit(recording, net));
  for (const double factor : {1e3, 1e-3}) {
    Recording other = recording;
    for (NodalForce& force : other.loads.forces) force.force.value *= factor;
    const Status status = checkForceUnit(other, net);
    ASSERT_FALSE(status);
    EXPECT_THAT(status.error().detail, HasSubstr(factor > 1.0 ? "--force-unit mN" : "--force-unit kN"));
  }
}

TEST_F(RecordingCsv, FaultsAreNamedWithTheirLine)
{
  const auto said = [&](const std::string& text) {
    const auto read = readRecordingCsv(text, "r.csv", net);
    return read ? std::string() : read.error().detail;
  };
  EXPECT_THAT(said("what,vx,vy,vz\n"), HasSubstr("r.csv:1"));
  EXPECT_THAT(said("what,node,vx,vy,vz\nmarker,7,0,0,0\n"), HasSubstr("r.csv:2"));
  EXPECT_THAT(said("what,node,vx,vy,vz\nmarker,107,0,0,0\nmarker,107,0,0,0\n"), HasSubstr("line 2"));
  EXPECT_THAT(said("what,node,vx,vy,vz\npush,107,0,0,0\n"), HasSubstr("\"push\""));
  EXPECT_THAT(said("what,node,vx,vy,vz\nforce,107,0,,0\n"), HasSubstr("r.csv:2"));
  EXPECT_THAT(said("what,node,vx,vy,vz\nforce,107,0,0,1\n"), HasSubstr("no marker"));
  EXPECT_THAT(said("what,node,colour,vx,vy,vz\n"), HasSubstr("no such column"));
  EXPECT_THAT(said("what,node,x,y,z,vx,vy,vz\nmarker,107,0.5,0,0,0,0,0\n"), HasSubstr("r.csv:2"));
  EXPECT_THAT(said("what,x,y,z,vx,vy,vz\nmarker,12,13,31,12,13,31\n"), HasSubstr("--length-unit"));
}

} // namespace
