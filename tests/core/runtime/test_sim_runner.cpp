// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/runtime/sim_runner.h"

#include "core/runtime/coalesce.h"
#include "tests/core/contact/hanging_chain.h"
#include "tests/support/patch_between.h"

#include <gtest/gtest.h>

#include <limits>

namespace esm {

namespace {

command::PatchParameters patchCommand(const std::vector<ParameterPatch>& patches)
{
  command::PatchParameters command;
  for (const ParameterPatch& patch : patches)
    command.patches.push_back(std::make_shared<const ParameterPatch>(patch));
  return command;
}

ParameterPatch springPatch(Index spring, double stiffness)
{
  ParameterPatch patch;
  patch.springs.push_back({spring, SpringLaw::Linear, stiffness, 0.2, 0.0});
  return patch;
}

class SimRunnerTest : public testing::Test {
protected:
  void SetUp() override { runner.apply(command::Load{1, chain(6), gravity(), {}}); }

  static Loads gravity()
  {
    Loads loads;
    loads.gravity = {0.0, 0.0, -9.81};
    return loads;
  }
  void frames(int count)
  {
    for (int i = 0; i < count; ++i) runner.runFrame();
  }
  const SimSnapshot& picture()
  {
    runner.draw(drawn);
    return drawn;
  }
  void moveDevice(const Eigen::Vector3d& position)
  {
    tool.back() = {++toolSequence, 0.0, position, Eigen::Vector3d::Zero()};
    tool.publish();
  }

  TripleBuffer<ToolState> tool;
  TripleBuffer<ContactModel> contact;
  SimRunner runner{60.0, tool, contact};
  SimSnapshot drawn;
  std::uint64_t toolSequence = 0;
};

} // namespace

TEST_F(SimRunnerTest, ALoadedNetWaitsAtTheStart)
{
  EXPECT_FALSE(runner.wantsFrame());
  EXPECT_EQ(picture().generation, 1u);
  EXPECT_EQ(picture().time, 0.0);
  EXPECT_EQ(picture().position, chain(6).restPosition);
  EXPECT_EQ(picture().stability, Stability::Good);
  EXPECT_FALSE(picture().solver.empty());
}

TEST_F(SimRunnerTest, PlayingMovesItFrameByFrame)
{
  runner.apply(command::Play{});
  frames(30);
  EXPECT_NEAR(picture().time, 0.5, 1e-9);
  EXPECT_LT(picture().position(2, 5), -1e-3); // the free end sags
  EXPECT_GT(picture().tension.maxCoeff(), 0.0);
}

TEST_F(SimRunnerTest, OneStepIsOneFrame)
{
  runner.apply(command::StepOnce{});
  EXPECT_TRUE(runner.wantsFrame());
  frames(3);
  EXPECT_NEAR(picture().time, 1.0 / 60.0, 1e-12);
  EXPECT_FALSE(picture().playing);
}

TEST_F(SimRunnerTest, ResetGoesBackAndPlaysOn)
{
  runner.apply(command::Play{});
  frames(10);
  runner.apply(command::Reset{});
  EXPECT_EQ(picture().time, 0.0);
  EXPECT_EQ(picture().position, chain(6).restPosition);
  EXPECT_TRUE(picture().playing);
}

TEST_F(SimRunnerTest, ANetThatCannotBeLeavesTheFormerOneRunning)
{
  runner.apply(command::Play{});
  frames(5);
  SpringNet bad = chain(4);
  bad.stiffness[1] = -3.0;
  runner.apply(command::Load{2, bad, {}, {}});
  EXPECT_TRUE(runner.wantsFrame());
  EXPECT_EQ(picture().generation, 1u);
  EXPECT_EQ(picture().position.cols(), 6);
  EXPECT_NE(picture().message.find("stiffness"), std::string::npos) << picture().message;
  frames(5);
  EXPECT_NEAR(picture().time, 10.0 / 60.0, 1e-9);
}

TEST_F(SimRunnerTest, OtherParametersKeepTheMotion)
{
  runner.apply(command::Play{});
  frames(20);
  const Eigen::Matrix3Xd before = picture().position;
  runner.apply(command::SetParameters{chain(6, 300.0)});
  EXPECT_EQ(picture().position, before);
  EXPECT_NEAR(picture().time, 20.0 / 60.0, 1e-9);
  runner.apply(command::SetParameters{chain(5)}); // another topology is not taken
  EXPECT_NE(picture().message.find("not taken"), std::string::npos);
  frames(1);
  EXPECT_EQ(picture().position.cols(), 6);
}

// By patches the same picture, the same energies and the same way on as by the whole net.
TEST_F(SimRunnerTest, APatchIsWhatTheWholeNetIs)
{
  SpringNet then = chain(6);
  then.stiffness[2] = 300.0;
  then.mass[4] = 0.02;
  SimSnapshot end[2];
  for (const bool byPatch : {false, true}) {
    runner.apply(command::Load{2, chain(6), gravity(), {}});
    runner.apply(command::Play{});
    frames(10);
    if (byPatch)
      runner.apply(patchCommand({test::patchBetween(chain(6), then)}));
    else
      runner.apply(command::SetParameters{then});
    SimSnapshot& now = end[byPatch];
    runner.draw(now);
    const double energy = now.energies.total();
    frames(10);
    runner.draw(now);
    now.energies.kinetic = energy; // for the comparison below
  }
  EXPECT_EQ(end[0].position, end[1].position);
  EXPECT_TRUE((end[0].tension == end[1].tension).all());
  EXPECT_NEAR(end[0].energies.kinetic, end[1].energies.kinetic, 1e-12 * std::abs(end[0].energies.kinetic));
}

// In the queue patches that follow each other become one command; none is lost, the last word counts, and one that
// is refused takes no other along.
TEST_F(SimRunnerTest, PatchesInARowAreTakenTogether)
{
  std::vector<SimCommand> batch;
  batch.push_back(patchCommand({springPatch(0, 200.0)}));
  batch.push_back(patchCommand({springPatch(1, 300.0)}));
  batch.push_back(command::Play{});
  batch.push_back(patchCommand({springPatch(2, 400.0)}));
  batch.push_back(patchCommand({springPatch(3, -1.0)}));
  batch.push_back(patchCommand({springPatch(2, 500.0)}));
  batch.push_back(patchCommand({springPatch(4, 600.0)}));
  coalesce(batch);
  ASSERT_EQ(batch.size(), 3u);
  EXPECT_EQ(std::get<command::PatchParameters>(batch[0]).patches.size(), 2u);
  EXPECT_EQ(std::get<command::PatchParameters>(batch[2]).patches.size(), 4u);
  for (SimCommand& command : batch) runner.apply(std::move(command));
  EXPECT_NE(picture().message.find("stiffness is -1 N/m"), std::string::npos) << picture().message;

  SimRunner other(60.0, tool, contact); // what they make of the chain
  SpringNet then = chain(6);
  then.stiffness << 200.0, 300.0, 500.0, 100.0, 600.0;
  other.apply(command::Load{1, then, gravity(), {}});
  other.apply(command::Play{});
  frames(5);
  for (int i = 0; i < 5; ++i) other.runFrame();
  SimSnapshot should;
  other.draw(should);
  EXPECT_EQ(picture().position, should.position);
}

// Time goes on over a net that sleeps, and nothing is copied.
TEST_F(SimRunnerTest, ANetAtRestKeepsItsPicture)
{
  runner.apply(command::Load{2, chain(6), {}, {}}); // slack: rests at once
  runner.apply(command::Play{});
  frames(1);
  const std::uint64_t before = picture().revision;
  EXPECT_GT(before, 0u);
  drawn.position(2, 5) = 7.0; // a mark on the copy
  frames(5);
  EXPECT_EQ(picture().revision, before);
  EXPECT_EQ(drawn.position(2, 5), 7.0);
  EXPECT_EQ(drawn.tension.size(), 5);
  EXPECT_NEAR(drawn.time, 0.1, 1e-12);

  runner.apply(patchCommand({springPatch(4, 300.0)})); // its springs may bear something else now
  const std::uint64_t changed = picture().revision;
  EXPECT_GT(changed, before);
  EXPECT_EQ(drawn.position, chain(6).restPosition);
  runner.apply(command::Grab{5, {0.05, 0.0, 0.01}, 10.0});
  frames(1);
  EXPECT_GT(picture().revision, changed);
  EXPECT_GT(drawn.position(2, 5), 1e-4);
}

// A net that is too large for the frame: it is broken off where it is and goes on from there.
TEST_F(SimRunnerTest, AFrameCanBeBrokenOff)
{
  runner.apply(command::Load{2, chain(60, 1e7), gravity(), {"verlet", 1e-3, 1e-6, 1}});
  runner.apply(command::Play{});
  EXPECT_EQ(runner.runFrame([] { return true; }), 0.0);
  const auto soon = [] { return [asked = 0]() mutable { return ++asked > 2; }; };
  double sum = runner.runFrame(soon());
  EXPECT_GT(sum, 0.0);
  EXPECT_LT(sum, 1.0 / 60.0);
  EXPECT_NEAR(picture().time, sum, 1e-15);
  for (int i = 0; i < 3; ++i) sum += runner.runFrame(soon());
  EXPECT_NEAR(picture().time, sum, 1e-12);
  EXPECT_EQ(picture().stability, Stability::Good);
  EXPECT_TRUE(picture().report.good());
}

// Explicit steps of a hundred times what is stable: it stops, keeps numbers, says why, and can be reset.
TEST_F(SimRunnerTest, FailedNumericsStopOnTheLastGoodState)
{
  runner.apply(command::Load{2, chain(6, 1e6), gravity(), {"verlet", 1e-3, 0.01, 1}});
  runner.apply(command::Play{});
  for (int i = 0; i < 2000 && runner.wantsFrame(); ++i) frames(1);
  EXPECT_FALSE(runner.wantsFrame());
  EXPECT_EQ(picture().stability, Stability::Stopped);
  EXPECT_FALSE(picture().playing);
  EXPECT_TRUE(picture().position.allFinite());
  EXPECT_TRUE(picture().tension.allFinite());
  EXPECT_FALSE(picture().message.empty());
  runner.apply(command::Reset{});
  EXPECT_EQ(picture().stability, Stability::Good);
}

TEST_F(SimRunnerTest, AGrabbedNodeGoesToItsTargetAndTheForceKeepsItsLimit)
{
  runner.apply(command::Play{});
  const Eigen::Vector3d target(0.05, 0.01, 0.0);
  runner.apply(command::Grab{5, target, 5.0});
  frames(120);
  EXPECT_EQ(picture().grabbedNode, 5);
  EXPECT_EQ(picture().heldNodes, (std::vector<Index>{5, 4})); // 1 cm apart, in the skirt of 8 mm
  EXPECT_EQ(picture().toolPosition, target);
  // The hand's springs are more than ten times as stiff as the chain, so most of the way is gone.
  EXPECT_LT((picture().position.col(5) - target).norm(), 0.005);
  runner.apply(command::MoveGrab{{10.0, 0.0, 0.0}});
  for (int i = 0; i < 600; ++i) { // swings for a while
    frames(1);
    ASSERT_LE(picture().toolForce.norm(), 5.0 + 1e-9);
  }
  // The chain holds 5 N with an extension of 0.05 m per spring, but the last one, as node 4 takes its share: 62.5
  // of 262.5 N/m. The hand may pull with 2 % less, and the chain sags a little.
  EXPECT_NEAR(picture().toolForce.x(), -5.0, 0.05);
  EXPECT_NEAR(picture().position(0, 5), 5 * 0.06 - 0.05 * 62.5 / 262.5, 0.02 * 5 * 0.05 + 0.001);
  runner.apply(command::Release{});
  frames(1);
  EXPECT_EQ(picture().grabbedNode, kNoIndex);
  EXPECT_TRUE(picture().heldNodes.empty());
  EXPECT_TRUE(picture().toolForce.isZero(0.0));
}

// A hand that moves evenly is the same hand at any rate of frames. One that leaped from frame to frame would be ahead
// by half of one on average, which is a tenth of the way after 5 of 60 a second.
TEST(SimRunnerHand, AnEvenMotionIsTheSameAtAnyFrameRate)
{
  Eigen::Matrix3Xd coarse;
  for (const int part : {1, 8}) {
    TripleBuffer<ToolState> tool;
    TripleBuffer<ContactModel> contact;
    SimRunner runner(60.0 * part, tool, contact);
    runner.apply(command::SetQuality{QualityPlan::clockOnly()});
    SolverSettings settings;
    settings.tolerance = 1e-4;
    const SpringNet net = chain(8);
    runner.apply(command::Load{1, net, {}, settings});
    runner.apply(command::Play{});
    const Eigen::Vector3d start = net.restPosition.col(4);
    runner.apply(command::Grab{4, start, 5.0});
    SimSnapshot picture;
    for (int frame = 1; frame <= 5 * part; ++frame) {
      runner.apply(command::MoveGrab{start + Eigen::Vector3d(0.0, 0.002 * frame / part, 0.0)});
      runner.runFrame();
    }
    runner.draw(picture);
    if (part == 1) coarse = picture.position;
    const double moved = (picture.position - net.restPosition).norm();
    EXPECT_GT(moved, 0.004);
    EXPECT_LT((picture.position - coarse).norm(), 2e-3 * moved)
      << "both within 1e-4 of the motion, and of its past";
  }
}

TEST_F(SimRunnerTest, NodesOfAnotherNetCannotBeGrabbed)
{
  for (const Index node : {-1, 6, 100000}) {
    runner.apply(command::Grab{node, Eigen::Vector3d::Zero(), 5.0});
    EXPECT_EQ(picture().grabbedNode, kNoIndex);
  }
}

TEST_F(SimRunnerTest, TheHandOnTheDeviceLeadsAndFeels)
{
  runner.apply(command::Play{});
  runner.apply(command::Grab{5, chain(6).restPosition.col(5), 5.0});
  frames(1);
  EXPECT_FALSE(contact.latest().active); // the mouse leads: nothing to feel on the device
  runner.apply(command::FollowDevice{true});
  moveDevice({0.05, 0.01, 0.0});
  frames(60);
  EXPECT_EQ(picture().toolPosition, Eigen::Vector3d(0.05, 0.01, 0.0));
  const ContactModel felt = contact.latest();
  EXPECT_TRUE(felt.active);
  EXPECT_EQ(felt.position, picture().toolPosition);
  EXPECT_TRUE(felt.force.isApprox(picture().toolForce, 1e-12)); // the hand rests
  EXPECT_LT(felt.force.y(), 0.0);                               // back to the net
}

// A simulation that stands still, for whatever reason, is no wall to press against.
TEST_F(SimRunnerTest, NothingIsFeltWhenTheMotionEnds)
{
  const std::vector<SimCommand> ends = {
    command::Pause{},   command::StepOnce{},          command::Reset{},
    command::Release{}, command::FollowDevice{false}, command::Load{3, chain(4), {}, {}}};
  for (const SimCommand& end : ends) {
    runner.apply(command::Load{2, chain(6), gravity(), {}});
    runner.apply(command::Play{});
    runner.apply(command::Grab{5, chain(6).restPosition.col(5), 5.0});
    runner.apply(command::FollowDevice{true});
    moveDevice({0.05, 0.01, 0.0});
    frames(2);
    ASSERT_TRUE(contact.latest().active);
    const std::uint64_t sequence = contact.latest().sequence, scene = contact.latest().scene;
    ASSERT_NE(scene, 0u);
    runner.apply(SimCommand(end));
    EXPECT_FALSE(contact.latest().active) << "command " << end.index();
    const bool sameTissue =
      std::holds_alternative<command::Release>(end) || std::holds_alternative<command::FollowDevice>(end);
    EXPECT_EQ(contact.latest().scene, sameTissue ? scene : 0u) << "command " << end.index();
    EXPECT_GT(contact.latest().sequence, sequence);
    if (runner.wantsFrame()) frames(1);
    EXPECT_FALSE(contact.latest().active) << "command " << end.index();
  }
}

// An edit goes on as the same scene, and the hold is as stiff as one of a net that was so from the start: the
// chain is at rest, the hand where its node is.
TEST_F(SimRunnerTest, AnEditUnderTheHandGoesOnWithTheNewStiffness)
{
  const SpringNet soft = chain(6), hard = chain(6, 400.0);
  const auto felt = [&](const SpringNet& first, const SpringNet& then, bool byPatch) {
    runner.apply(command::Load{2, first, {}, {}});
    runner.apply(command::Play{});
    runner.apply(command::Grab{5, soft.restPosition.col(5), 5.0});
    runner.apply(command::FollowDevice{true});
    moveDevice(soft.restPosition.col(5));
    frames(2);
    const ContactModel before = contact.latest();
    if (byPatch)
      runner.apply(patchCommand({test::patchBetween(first, then)}));
    else
      runner.apply(command::SetParameters{then});
    EXPECT_TRUE(contact.latest().active);
    frames(1);
    EXPECT_TRUE(contact.latest().active);
    EXPECT_EQ(contact.latest().scene, before.scene);
    EXPECT_NE(contact.latest().edition, before.edition);
    return contact.latest().stiffness(0, 0);
  };
  const double edited = felt(soft, hard, false), patched = felt(soft, hard, true);
  const double fromTheStart = felt(hard, hard, false), unedited = felt(soft, soft, false);
  EXPECT_EQ(patched, edited);
  EXPECT_NEAR(edited, fromTheStart, 1e-6 * fromTheStart);
  EXPECT_GT(edited, 2.0 * unedited);
}

// While it moves it has word for the servo in each frame, be it that nothing is held: silence is a fault.
TEST_F(SimRunnerTest, AMovingNetIsNeverSilent)
{
  EXPECT_EQ(contact.latest().sequence, 0u);
  runner.apply(command::Play{});
  std::uint64_t last = 0;
  for (int i = 0; i < 5; ++i) {
    frames(1);
    EXPECT_GT(contact.latest().sequence, last);
    EXPECT_FALSE(contact.latest().active);
    EXPECT_NE(contact.latest().scene, 0u);
    last = contact.latest().sequence;
  }
}

// Each time that tissue moves on it is another scene, and never one that there was before.
TEST_F(SimRunnerTest, WhatPlaysOnIsAnotherScene)
{
  std::uint64_t last = 0;
  const std::vector<SimCommand> pauses = {command::Pause{}, command::StepOnce{}, command::Reset{},
                                          command::Touch{true, 0.003, 5.0}, command::Touch{false, 0.0, 5.0}};
  for (const SimCommand& pause : pauses) {
    runner.apply(command::Play{});
    frames(1);
    EXPECT_GT(contact.latest().scene, last) << "before command " << pause.index();
    last = contact.latest().scene;
    runner.apply(SimCommand(pause));
  }
}

TEST_F(SimRunnerTest, EqualCommandsGiveEqualBits)
{
  const auto play = [] {
    TripleBuffer<ToolState> hand;
    TripleBuffer<ContactModel> felt;
    SimRunner other(60.0, hand, felt);
    other.apply(command::Load{1, chain(6), gravity(), {}});
    other.apply(command::Play{});
    other.apply(command::Grab{3, {0.02, 0.02, 0.0}, 5.0});
    for (int i = 0; i < 30; ++i) other.runFrame();
    SimSnapshot end;
    other.draw(end);
    return end.position;
  };
  EXPECT_EQ(play(), play());
}

TEST(SimRunner, WithoutANetCommandsDoNothing)
{
  TripleBuffer<ToolState> tool;
  TripleBuffer<ContactModel> contact;
  SimRunner runner(60.0, tool, contact);
  runner.apply(command::Play{});
  runner.apply(command::StepOnce{});
  runner.apply(command::Reset{});
  runner.apply(command::Grab{0, Eigen::Vector3d::Zero(), 1.0});
  runner.apply(command::Release{});
  runner.apply(command::SetParameters{chain(3)});
  runner.apply(patchCommand({springPatch(0, 1.0)}));
  runner.apply(command::SetFrameRate{std::numeric_limits<double>::quiet_NaN()});
  EXPECT_FALSE(runner.wantsFrame());
  EXPECT_EQ(runner.framePeriod(), 1.0 / 60.0);
  SimSnapshot picture;
  runner.draw(picture);
  EXPECT_EQ(picture.stability, Stability::Idle);
}

} // namespace esm
