// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/net/net_builder.h"
#include "tests/core/net/meshes.h"
#include "tests/support/patch_between.h"

#include <gmock/gmock.h>

#include <functional>

namespace {

using namespace esm;
using namespace esm::test;
using ::testing::HasSubstr;

/// A cube with one of everything that can be wrong.
SpringNet goodNet()
{
  SpringNet net = *buildNet(cube());
  net.massDamping = Eigen::ArrayXd::Constant(8, 0.1);
  net.initialVelocity.setZero(3, 8);
  net.tables = {ForceTable{{-1, 0, 1}, {-2, 0, 3}}};
  net.law[4] = SpringLaw::Table;
  net.law[5] = SpringLaw::Cubic;
  net.anchors.node = {2};
  net.anchors.point.setZero(3, 1);
  net.anchors.stiffness = net.anchors.viscosity = Eigen::ArrayXd::Zero(1);
  for (std::size_t s = 0; s < net.springId.size(); ++s)
    net.springId[s] = SpringId{100 + static_cast<Index>(s)};
  return net;
}

struct Fault {
  const char* name;
  std::function<void(SpringNet&)> make;
  const char* message; ///< part of the detail
};

void PrintTo(const Fault& fault, std::ostream* out)
{
  *out << fault.name;
}

class CheckNet : public ::testing::TestWithParam<Fault> {};

TEST_P(CheckNet, namesTheCulprit)
{
  SpringNet net = goodNet();
  ASSERT_TRUE(checkNet(net));
  GetParam().make(net);
  const Status status = checkNet(net);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::InvalidValue);
  EXPECT_THAT(status.error().detail, HasSubstr(GetParam().message));
}

const Fault kFaults[] = {
  {"shortMass", [](SpringNet& n) { n.mass.conservativeResize(7); },
   "array mass holds 7 entries, it must hold 8"},
  {"shortVelocity", [](SpringNet& n) { n.initialVelocity.setZero(3, 2); }, "array initialVelocity"},
  {"shortKind", [](SpringNet& n) { n.kind.pop_back(); }, "array kind holds 17"},
  {"shortAnchors", [](SpringNet& n) { n.anchors.stiffness.resize(0); }, "anchors.stiffness"},
  {"nanPosition", [](SpringNet& n) { n.restPosition(1, 3) = kNaN; }, "node 3 (id 3): rest position is nan m"},
  {"infiniteVelocity", [](SpringNet& n) { n.initialVelocity(0, 1) = kInfinity; },
   "node 1 (id 1): initial velocity"},
  {"zeroMass", [](SpringNet& n) { n.mass[2] = 0; }, "node 2 (id 2): mass is 0 kg, it must be > 0"},
  {"nanMass", [](SpringNet& n) { n.mass[2] = kNaN; }, "mass is nan kg"},
  {"negativeDamping", [](SpringNet& n) { n.massDamping[7] = -1; }, "node 7 (id 7): mass damping is -1 1/s"},
  {"sameNodeId", [](SpringNet& n) { n.nodeId[5] = NodeId{2}; },
   "node 5 (id 2): the id is already taken by node 2"},
  {"sameSpringId", [](SpringNet& n) { n.springId[0] = SpringId{103}; },
   "spring 3 (id 103): the id is already taken by spring 0"},
  {"endOutOfRange", [](SpringNet& n) { n.ends(1, 12) = 8; }, "spring 12 (id 112): its ends are nodes"},
  {"negativeEnd", [](SpringNet& n) { n.ends(0, 12) = -1; }, "spring 12 (id 112): its ends are nodes -1"},
  {"sameEnds", [](SpringNet& n) { n.ends.col(12).setConstant(4); },
   "spring 12 (id 112): both ends are node 4"},
  {"negativeStiffness", [](SpringNet& n) { n.stiffness[12] = -3; },
   "spring 12 (id 112): stiffness is -3 N/m, it must be >= 0"},
  {"nanViscosity", [](SpringNet& n) { n.viscosity[1] = kNaN; }, "spring 1 (id 101): viscosity is nan N s/m"},
  {"negativeLength", [](SpringNet& n) { n.restLength[0] = -1; }, "spring 0 (id 100): rest length is -1 m"},
  {"zeroLengthWithLaw", [](SpringNet& n) { n.restLength[5] = 0; },
   "spring 5 (id 105): rest length is 0 m, it must be > 0"},
  {"nanParameter", [](SpringNet& n) { n.lawParameter[0] = kNaN; }, "spring 0 (id 100): law parameter is nan"},
  {"noSuchTable", [](SpringNet& n) { n.lawParameter[4] = 1; }, "spring 4 (id 104): law parameter is 1"},
  {"halfTable", [](SpringNet& n) { n.lawParameter[4] = 0.5; }, "spring 4 (id 104): law parameter is 0.5"},
  {"noSuchLaw", [](SpringNet& n) { n.law[6] = static_cast<SpringLaw>(9); },
   "spring 6 (id 106): law number is 9"},
  {"tableOfOne",
   [](SpringNet& n) {
     n.tables[0] = {{0}, {0}};
   },
   "force table 0: it must hold at least two points"},
  {"tableUneven", [](SpringNet& n) { n.tables[0].force.pop_back(); },
   "force table 0: it holds 3 strains but 2 forces"},
  {"tableFalls", [](SpringNet& n) { n.tables[0].strain[2] = 0; }, "force table 0, point 2: strain is 0"},
  {"tableNan", [](SpringNet& n) { n.tables[0].force[1] = kNaN; }, "force table 0, point 1: force is nan"},
  {"anchorNode", [](SpringNet& n) { n.anchors.node[0] = 8; }, "anchor 0: it holds node 8"},
  {"anchorPoint", [](SpringNet& n) { n.anchors.point(2, 0) = kNaN; }, "anchor 0: point is nan"},
  {"anchorStiffness", [](SpringNet& n) { n.anchors.stiffness[0] = -1; }, "anchor 0: stiffness is -1 N/m"},
  {"anchorViscosity", [](SpringNet& n) { n.anchors.viscosity[0] = kInfinity; }, "anchor 0: viscosity is inf"},
  {"triangleNode", [](SpringNet& n) { n.triangles(0, 3) = 77; }, "triangle 3: it uses node 77"},
};

INSTANTIATE_TEST_SUITE_P(Faults, CheckNet, ::testing::ValuesIn(kFaults),
                         [](const auto& fault) { return std::string(fault.param.name); });

TEST(CheckNetGood, aLinearSpringMayHaveNoLengthAndIdsMayComeInAnyOrder)
{
  SpringNet net = goodNet();
  net.restLength[0] = 0;
  std::reverse(net.springId.begin(), net.springId.end());
  EXPECT_TRUE(checkNet(net));
}

TEST(CheckNetGood, anEmptyNetFitsTogether)
{
  SpringNet net;
  resizeNet(net, 0, 0);
  EXPECT_TRUE(checkNet(net));
}

// The same words, whether a fault comes with a whole net or with a patch.
TEST(CheckPatch, SaysWhatCheckNetSays)
{
  int count = 0;
  for (const Fault& fault : kFaults) {
    const SpringNet good = goodNet();
    SpringNet bad = good;
    fault.make(bad);
    const ParameterPatch patch = patchBetween(good, bad);
    if (patch.isEmpty()) continue; // of topology or shape
    ++count;
    const Status status = checkPatch(patch, good);
    ASSERT_FALSE(status) << fault.name;
    EXPECT_EQ(status.error().detail, checkNet(bad).error().detail);
    EXPECT_EQ(status.error().code, ErrorCode::InvalidValue);
  }
  EXPECT_GE(count, 10);
}

TEST(CheckPatch, RefusesWhoIsNotThereAndListsThatDoNotRise)
{
  const SpringNet net = goodNet();
  const auto detail = [&](const ParameterPatch& patch) {
    const Status status = checkPatch(patch, net);
    return status ? std::string() : status.error().detail;
  };
  ParameterPatch patch;
  patch.springs = {{3, SpringLaw::Linear, 1.0, 0.0, 0.0}, {18, SpringLaw::Linear, 1.0, 0.0, 0.0}};
  EXPECT_THAT(detail(patch), HasSubstr("spring 18, the net has 18"));
  patch.springs[1].spring = 3;
  EXPECT_THAT(detail(patch), HasSubstr("spring 3 after 3"));
  patch.springs.pop_back();
  EXPECT_EQ(detail(patch), "");
  patch.nodes = {{-1, 1.0, 0.0}};
  EXPECT_THAT(detail(patch), HasSubstr("node -1, the net has 8"));
  patch.nodes.clear();
  patch.anchors = {{1, 1.0, 0.0}};
  EXPECT_THAT(detail(patch), HasSubstr("anchor 1, the net has 1"));
  patch.anchors.clear();
  patch.bulkModuli = {1.0};
  EXPECT_THAT(detail(patch), HasSubstr("1 bulk moduli, the net has 0"));
}

// Two patches in a row are one: the later word counts, and nobody is lost.
TEST(ParameterPatchList, AppendsInOrder)
{
  ParameterPatch first, second;
  for (const Index s : {1, 4, 7}) first.springs.push_back({s, SpringLaw::Linear, 1.0 * s, 0.0, 0.0});
  for (const Index s : {0, 4, 9}) second.springs.push_back({s, SpringLaw::Linear, 10.0 * s, 0.0, 0.0});
  first.nodes = {{2, 3.0, 0.0}};
  second.anchors = {{0, 5.0, 0.1}};
  SpringNet one = goodNet(), other = one;
  first.applyTo(one);
  second.applyTo(one);
  first.append(second);
  EXPECT_EQ(first.springs.size(), 5u);
  ASSERT_TRUE(checkPatch(first, other));
  first.applyTo(other);
  EXPECT_TRUE((one.stiffness == other.stiffness).all());
  EXPECT_EQ(other.stiffness[4], 40.0);
  EXPECT_EQ(other.mass[2], 3.0);
  EXPECT_EQ(other.anchors.stiffness[0], 5.0);
}

} // namespace
