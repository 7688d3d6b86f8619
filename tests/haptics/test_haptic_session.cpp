// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/haptic_session.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <thread>

namespace esm {

namespace {

/// The real thread on the real clock: nothing here depends on how fast it comes, only that it does.
class HapticSessionTest : public testing::Test {
protected:
  /// Sends a push of 1 N at 200 Hz until `condition` or 10 s.
  bool pushUntil(const std::function<bool(const HapticStatus&)>& condition)
  {
    for (int i = 0; i < 2000; ++i) {
      ContactModel model;
      model.sequence = ++sequence;
      model.active = pushes;
      model.force = {1.0, 0.0, 0.0};
      contact.back() = model;
      contact.publish();
      if (condition(session->status())) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return false;
  }
  /// Force begins only where it would be small: armed first, pushed after.
  bool armThenPush()
  {
    pushes = false;
    session->placeHand(Eigen::Vector3d::Zero());
    session->arm();
    if (!pushUntil([](const HapticStatus& s) { return s.state == DeviceState::Active; })) return false;
    pushes = true;
    return true;
  }
  void open()
  {
    auto opened = HapticSession::open("simulated", tool, contact);
    ASSERT_TRUE(opened) << opened.error().detail;
    session = std::move(*opened);
  }

  TripleBuffer<ToolState> tool;
  TripleBuffer<ContactModel> contact;
  std::uint64_t sequence = 0;
  bool pushes = false;
  std::unique_ptr<HapticSession> session;
};

} // namespace

TEST_F(HapticSessionTest, TheSimulatedDeviceIsAlwaysThere)
{
  const std::vector<std::string> names = HapticSession::deviceNames();
  EXPECT_NE(std::find(names.begin(), names.end(), "simulated"), names.end());
}

TEST_F(HapticSessionTest, AnUnknownDeviceIsAnErrorThatNamesTheKnownOnes)
{
  const auto opened = HapticSession::open("theremin", tool, contact);
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().code, ErrorCode::NoDevice);
  EXPECT_NE(opened.error().detail.find("theremin"), std::string::npos);
  EXPECT_NE(opened.error().detail.find("simulated"), std::string::npos);
}

TEST_F(HapticSessionTest, ArmPushStopAndArmAgain)
{
  open();
  ASSERT_TRUE(pushUntil([](const HapticStatus& s) { return s.ticks > 50; }));
  EXPECT_EQ(session->status().state, DeviceState::Idle);
  EXPECT_TRUE(session->status().force.isZero(0.0));

  ASSERT_TRUE(armThenPush());
  EXPECT_TRUE(
    pushUntil([](const HapticStatus& s) { return s.state == DeviceState::Active && s.force.x() > 0.9; }));
  session->emergencyStop();
  EXPECT_TRUE(pushUntil([](const HapticStatus& s) { return s.state == DeviceState::Fault; }));
  EXPECT_TRUE(pushUntil([](const HapticStatus& s) { return s.force.isZero(0.0); }));
  EXPECT_FALSE(session->status().reason.empty());
  EXPECT_FALSE(session->status().priority.empty());
  ASSERT_TRUE(armThenPush());
  EXPECT_TRUE(pushUntil([](const HapticStatus& s) { return s.force.x() > 0.9; }));
  session->disarm();
  EXPECT_TRUE(pushUntil([](const HapticStatus& s) { return s.state == DeviceState::Idle; }));
}

TEST_F(HapticSessionTest, TheMouseMovesTheHandAndTheTraceTellsIt)
{
  open();
  session->placeHand({0.1, 0.0, 0.0});
  ASSERT_TRUE(pushUntil([](const HapticStatus& s) { return s.position.x() > 0.09; }));
  session->moveHand({0.2, 0.0, 0.0});
  ASSERT_TRUE(pushUntil([](const HapticStatus& s) { return s.position.x() > 0.19; }));
  EXPECT_GT(tool.latest().position.x(), 0.15);

  std::vector<TraceSample> trace;
  session->takeTrace(trace);
  ASSERT_GT(trace.size(), 10u);
  for (std::size_t i = 1; i < trace.size(); ++i) ASSERT_GT(trace[i].time, trace[i - 1].time);
  EXPECT_GT(trace.back().position.x(), 0.15);
}

TEST_F(HapticSessionTest, ClosingWhileForceFlowsEndsTheThread)
{
  open();
  ASSERT_TRUE(armThenPush());
  ASSERT_TRUE(pushUntil([](const HapticStatus& s) { return s.force.x() > 0.5; }));
  session.reset();
  const std::uint64_t last = tool.latest().sequence;
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_EQ(tool.latest().sequence, last);
}

// Another device in an armed hand's place: the old one is let go of, the new one waits for its own arming.
TEST_F(HapticSessionTest, ADeviceThatTakesAnArmedOnesPlaceGivesNoForce)
{
  open();
  ASSERT_TRUE(armThenPush());
  ASSERT_TRUE(pushUntil([](const HapticStatus& s) { return s.force.norm() > 0.5; }));
  session.reset();
  open();
  for (int i = 0; i < 40; ++i) {
    int count = 0;
    ASSERT_TRUE(pushUntil([&](const HapticStatus&) { return ++count == 2; }));
    ASSERT_TRUE(session->status().force.isZero(0.0));
  }
  EXPECT_NE(session->status().state, DeviceState::Active);
}

} // namespace esm
