// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/project/net_format.h"

#include "core/project/project_io.h"
#include "tests/core/project/random_project.h"

#include <gmock/gmock.h>

namespace esm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* kEveryField = R"({
  "format": "esm-net-1", "name": "tube", "duration": 2.5, "frame_rate": 100, "gravity": [0, 0, -9.81],
  "nodes": {"position": [0, 0, 0, 1, 0, 0, 0, 2, 0], "mass": [1, 2.5, 3], "fixed": [0],
            "velocity": [0, 0, 0, 1, 2, 3, 4, 5, 6], "mass_damping": 0.25},
  "springs": {"i": [0, 1], "j": [1, 2], "stiffness": [100, 200], "viscosity": 0.5, "rest_length": [1, 2],
              "law": ["cubic", "exponential"], "law_parameter": [7, 8]},
  "anchors": {"node": [2], "point": [0, 2, 1], "stiffness": 10, "viscosity": [0.125]},
  "forces": [{"nodes": [1, 2], "time": [0, 0.5], "force": [[0, 0, 0], [1, 2, 3]]}],
  "motions": [{"nodes": [1], "time": [0, 1], "displacement": [[0, 0, 0], [0, 0, 0.5]], "release": 1.5},
              {"nodes": [2], "time": [0], "displacement": [[1, 0, 0]]}],
  "triangles": [[0, 1, 2]]
})";

// Every field of the format arrives where it belongs.
TEST(PlainNet, EveryFieldIsRead)
{
  const Result<Project> parsed = parseNetFormat(kEveryField, "net.json");
  ASSERT_TRUE(parsed) << parsed.error().detail;
  const SpringNet& net = parsed->net;
  EXPECT_EQ(parsed->name, "tube");
  EXPECT_FALSE(parsed->parametersFromTissue);
  EXPECT_EQ(parsed->simulation.duration, 2.5);
  EXPECT_EQ(parsed->simulation.frameRate, 100.0);
  EXPECT_EQ(parsed->loads.gravity, Eigen::Vector3d(0, 0, -9.81));
  EXPECT_EQ(net.restPosition.col(2), Eigen::Vector3d(0, 2, 0));
  EXPECT_EQ(net.initialVelocity.col(1), Eigen::Vector3d(1, 2, 3));
  EXPECT_THAT(net.mass, ElementsAre(1.0, 2.5, 3.0));
  EXPECT_THAT(net.massDamping, ElementsAre(0.25, 0.25, 0.25));
  EXPECT_THAT(net.fixed, ElementsAre(1, 0, 0));
  EXPECT_EQ(net.ends.col(1), Eigen::Vector2i(1, 2));
  EXPECT_THAT(net.stiffness, ElementsAre(100.0, 200.0));
  EXPECT_THAT(net.viscosity, ElementsAre(0.5, 0.5));
  EXPECT_THAT(net.restLength, ElementsAre(1.0, 2.0));
  EXPECT_THAT(net.law, ElementsAre(SpringLaw::Cubic, SpringLaw::Exponential));
  EXPECT_THAT(net.lawParameter, ElementsAre(7.0, 8.0));
  EXPECT_THAT(net.anchors.node, ElementsAre(2));
  EXPECT_EQ(net.anchors.point.col(0), Eigen::Vector3d(0, 2, 1));
  EXPECT_EQ(net.anchors.stiffness[0], 10.0);
  EXPECT_EQ(net.anchors.viscosity[0], 0.125);
  ASSERT_EQ(parsed->loads.forces.size(), 1u);
  EXPECT_THAT(parsed->loads.forces[0].nodes, ElementsAre(1, 2));
  EXPECT_THAT(parsed->loads.forces[0].force.time, ElementsAre(0.0, 0.5));
  EXPECT_EQ(parsed->loads.forces[0].force.value.col(1), Eigen::Vector3d(1, 2, 3));
  ASSERT_EQ(parsed->loads.motions.size(), 2u);
  EXPECT_EQ(parsed->loads.motions[0].release, 1.5);
  EXPECT_EQ(parsed->loads.motions[0].displacement.value.col(1), Eigen::Vector3d(0, 0, 0.5));
  EXPECT_FALSE(parsed->loads.motions[1].release);
  EXPECT_EQ(net.triangles.col(0), Eigen::Vector3i(0, 1, 2));
}

TEST(PlainNet, LeastFileIsANetAtRest)
{
  const Result<Project> parsed =
    parseProject(R"({"format": "esm-net-1", "nodes": {"position": [0,0,0, 1,0,0], "mass": 1},
                     "springs": {"i": [0], "j": [1], "stiffness": 1, "viscosity": 0, "rest_length": 1}})",
                 "net.json");
  ASSERT_TRUE(parsed) << parsed.error().detail;
  EXPECT_EQ(parsed->net.law[0], SpringLaw::Linear);
  EXPECT_EQ(parsed->net.massDamping.size(), 0);
  EXPECT_EQ(parsed->net.initialVelocity.cols(), 0);
  EXPECT_EQ(parsed->loads.gravity, Eigen::Vector3d::Zero());
  EXPECT_EQ(parsed->simulation.frameRate, 60.0);
}

// Written and read again it is the same net, bit for bit, and the same text.
TEST(PlainNet, RoundTripKeepsEverythingItCanHold)
{
  for (unsigned seed = 1; seed <= 20; ++seed) {
    Project project = test::randomProject(seed);
    std::vector<std::string> lost;
    const std::string first = toNetFormat(project, &lost);
    const Result<Project> back = parseNetFormat(first, "net.json");
    ASSERT_TRUE(back) << back.error().detail;
    EXPECT_EQ(toNetFormat(*back, &lost), first);
    EXPECT_THAT(lost, testing::IsEmpty()) << "all that could be lost was lost the first time";
    EXPECT_EQ(back->net.restPosition, project.net.restPosition);
    EXPECT_EQ(back->net.ends, project.net.ends);
    EXPECT_TRUE((back->net.viscosity == project.net.viscosity).all());
  }
}

TEST(PlainNet, WhatItCannotHoldIsSaid)
{
  Project project = test::smallProject();
  std::vector<std::string> lost;
  project.parametersFromTissue = false;
  (void)toNetFormat(project, &lost);
  EXPECT_THAT(lost, testing::IsEmpty());
  project.parametersFromTissue = true;
  project.net.tensionOnly[0] = 1;
  project.net.tables = {{{0, 1}, {0, 1}}};
  project.net.law[1] = SpringLaw::Table;
  project.net.lawParameter[1] = 0;
  project.net.nodeId[0] = NodeId{77};
  (void)toNetFormat(project, &lost);
  EXPECT_THAT(
    lost, ElementsAre(HasSubstr("rules"), HasSubstr("tension-only"), HasSubstr("tables"), HasSubstr("ids")));
}

struct Fault {
  const char *from, *to, *message;
};

// One faulty place each: the message names the file, the way to the place, and what is wanted.
TEST(PlainNet, FaultsAreNamed)
{
  const Fault faults[] = {
    {"\"i\": [0, 1]", "\"i\": [0, 3]", "net.json: /springs/i/1 is 3, it must be an integer from 0 to 2"},
    {"\"i\": [0, 1]", "\"i\": [0]",
     "net.json: /springs/j is a list of 2, it must be a list of 1 nodes, as i is"},
    {"\"j\": [1, 2]", "\"j\": [1, 1]",
     "net.json: /springs/j/1 is 1, it must be another node than the spring's i"},
    {"[1, 2.5, 3]", "[1, 0, 3]", "net.json: /nodes/mass/1 is 0, it must be > 0"},
    {"[1, 2.5, 3]", "[1, 3]", "net.json: /nodes/mass is a list of 2, it must be a number or a list of 3"},
    {"[0, 0, 0, 1, 0, 0, 0, 2, 0]", "[0, 0]",
     "net.json: /nodes/position is a list of 2, it must be a list of x, y, z triples"},
    {"\"cubic\"", "\"quadratic\"",
     "net.json: /springs/law/0 is \"quadratic\", it must be one of linear, cubic, exponential"},
    {", \"law_parameter\": [7, 8]", "", "net.json: /springs lacks \"law_parameter\", which its laws need"},
    {"\"rest_length\": [1, 2]", "\"rest_length\": [1, 0]", "net.json: /springs/rest_length is 0 at spring 1"},
    {"\"viscosity\": 0.5", "\"viscocity\": 0.5", "net.json: /springs has the unknown key \"viscocity\""},
    {"\"time\": [0, 0.5]", "\"time\": [0.5, 0]",
     "net.json: /forces/0/time/1 is 0, it must be not before the time ahead of it"},
    {"[1, 2, 3]]}]", "[1, 2]]}]",
     "net.json: /forces/0/force/1 is a list of 2, it must be a list of three numbers"},
    {"\"triangles\": [[0, 1, 2]]", "\"triangles\": [[0, 1]]",
     "net.json: /triangles/0 is a list of 2, it must be a list of three nodes"},
    {"\"frame_rate\": 100", "\"frame_rate\": 0", "net.json: /frame_rate is 0, it must be > 0"},
    {"esm-net-1", "esm-net-9", "net.json: /format is \"esm-net-9\", it must be one of esm-net-1"},
  };
  for (const Fault& fault : faults) {
    std::string text = kEveryField;
    const std::size_t place = text.find(fault.from);
    ASSERT_NE(place, std::string::npos) << fault.from;
    text.replace(place, std::string(fault.from).size(), fault.to);
    const Result<Project> parsed = parseNetFormat(text, "net.json");
    ASSERT_FALSE(parsed) << fault.to;
    EXPECT_THAT(parsed.error().detail, testing::StartsWith(fault.message));
  }
}

} // namespace
} // namespace esm
