// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/device/pid_driver.h"
#include "haptics/emulator/pid_model.h"
#include "haptics/emulator/pid_model_descriptor.h"
#include "haptics/emulator/wooden_model.h"
#include "tests/haptics/driver_bench.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>

namespace esm {
namespace {

using pid::usage;

TEST(HidDescriptor, FindsWhatAConstantForceNeeds)
{
  auto descriptor = std::make_unique<hid::ReportDescriptor>();
  ASSERT_EQ(descriptor->parse(kPidModelDescriptor), hid::Flaw::None);
  pid::Layout layout;
  ASSERT_EQ(layout.find(*descriptor), nullptr);
  EXPECT_EQ(layout.constant.magnitude.reportId, 5);
  EXPECT_EQ(layout.constant.magnitude.bit, 16); // id, block
  EXPECT_EQ(layout.constant.magnitude.logicalMin, -10000);
  EXPECT_EQ(layout.constantBytes, 4u);
  EXPECT_EQ(layout.effect.startDelay.decimalExponent, -3);
  EXPECT_EQ(layout.axes[0].bit, 8);
  EXPECT_EQ(layout.axes[1].bit, 24);
  EXPECT_EQ(layout.axes[1].logicalMax, 1023);
  EXPECT_EQ(layout.buttons[7].bit, 8 + 32 + 7);
  EXPECT_FALSE(layout.buttons[8].present());
  EXPECT_TRUE(layout.control.has(usage(0x9a)));
}

TEST(HidDescriptor, RefusesEveryTruncationOrFindsLess)
{
  auto descriptor = std::make_unique<hid::ReportDescriptor>();
  for (std::size_t size = 0; size < kPidModelDescriptor.size(); ++size) {
    const hid::Flaw flaw = descriptor->parse(std::span(kPidModelDescriptor).first(size));
    if (size >= 6) {
      EXPECT_NE(flaw, hid::Flaw::None) << size;
    } // a collection is open
    EXPECT_TRUE(descriptor->fields().empty());
  }
}

TEST(HidValues, ComeBackWhereverTheyLie)
{
  std::mt19937 random(2);
  for (int i = 0; i < 20000; ++i) {
    hid::Slot slot;
    slot.bitSize = static_cast<std::uint8_t>(1 + random() % 32);
    slot.bit = static_cast<std::uint16_t>(random() % 40);
    const bool isSigned = slot.bitSize > 1 && random() % 2;
    const std::int64_t half = std::int64_t{1} << (slot.bitSize - 1);
    slot.logicalMin = isSigned ? static_cast<std::int32_t>(-half) : 0;
    slot.logicalMax =
      static_cast<std::int32_t>(std::min<std::int64_t>(isSigned ? half - 1 : 2 * half - 1, 0x7fffffff));
    std::array<std::uint8_t, 9> report{};
    report.fill(static_cast<std::uint8_t>(random()));
    const std::uint64_t span =
      static_cast<std::uint64_t>(std::int64_t{slot.logicalMax} - slot.logicalMin) + 1;
    const auto value =
      static_cast<std::int32_t>(slot.logicalMin + static_cast<std::int64_t>(random() % span));
    hid::putValue(report, slot, value);
    ASSERT_EQ(hid::getValue(report, slot), value) << int{slot.bitSize};
    hid::putValue(report, slot, std::int64_t{slot.logicalMax} + 5); // clamped, not wrapped
    ASSERT_EQ(hid::getValue(report, slot), slot.logicalMax);
  }
}

using PidBench = DriverBench<PidModel>;

std::shared_ptr<PidModel> stick(PidModel::Settings settings = {}, std::unique_ptr<Hand> hand = nullptr)
{
  settings.mechanics.coulomb = 0.0;
  return std::make_shared<PidModel>(settings, std::move(hand));
}

TEST(PidDevice, SetsUpTwoEffectsAndClosesThem)
{
  PidModel::Settings settings;
  settings.busyAnswers = 20; // fewer than it asks for
  const auto model = stick(settings);
  {
    PidBench bench("pid", model, {});
    bench.tick(5);
    EXPECT_EQ(bench.phase(), DevicePhase::Running);
    EXPECT_EQ(model->effects(), 2);
    EXPECT_EQ(model->runningEffects(), 2);
    EXPECT_TRUE(model->enabled());
    bench.tick(500); // two seconds: started again each 100 ms, or they would have ended
    EXPECT_EQ(model->runningEffects(), 2);
    EXPECT_EQ(bench.status().reason, ServoReason::Plain);
  }
  EXPECT_EQ(model->effects(), 0);
  EXPECT_FALSE(model->enabled());
  EXPECT_GE(model->zerosInRow(), 3);
}

TEST(PidDevice, GivesUpOnAFullOrSilentDevice)
{
  PidModel::Settings full, busy;
  full.full = true;
  busy.busyAnswers = 1000000;
  for (const auto& settings : {full, busy}) {
    PidBench bench("pid", stick(settings), {});
    bench.tick(5);
    EXPECT_EQ(bench.phase(), DevicePhase::Fault);
    EXPECT_STRNE(bench.loop.device().report().reason, "");
  }
}

// Right, up, and a diagonal beyond full scale: the grip feels the direction that was computed. Sense by the
// directions that the device was told; 1 % for its word of 1/256 turn.
TEST(PidDevice, PushesWhereItShould)
{
  for (const bool byControl : {false, true}) {
    PidModel::Settings settings;
    settings.noOutEndpoint = byControl;
    const auto model = stick(settings);
    FakeUsbTransport usb(model);
    auto driver = openDriver("pid", {}, usb);
    ASSERT_TRUE(driver);
    DrivenDevice device(std::move(*driver), DrivenDevice::Drive::Inline);
    DeviceSample sample;
    double now = 0.0;
    const auto push = [&](const Eigen::Vector3d& force) {
      for (int i = 0; i < 20; ++i) {
        now += 0.004;
        device.read(now, sample);
        device.write(force);
      }
      return model->force();
    };
    push(Eigen::Vector3d::Zero());
    EXPECT_LT((push({1.0, 0.0, 0.0}) - Eigen::Vector3d(1.0, 0.0, 0.0)).norm(), 0.03);
    EXPECT_LT((push({0.0, 0.5, 0.0}) - Eigen::Vector3d(0.0, 0.5, 0.0)).norm(), 0.03);
    const Eigen::Vector3d strong = push({30.0, -10.0, 0.0});
    EXPECT_NEAR(strong.y() / strong.x(), -1.0 / 3.0, 0.02);
    EXPECT_LE(std::abs(strong.x()), 2.05);
    EXPECT_TRUE(push(Eigen::Vector3d::Zero()).isZero(0.0));
  }
}

// The profile's origin is where the scene's zero lies in the device, and its polarity turns the force of one
// axis about.
TEST(PidDevice, TakesOriginAndPolarityFromItsProfile)
{
  const auto model = stick();
  FakeUsbTransport usb(model);
  auto wakeup = std::make_unique<Wakeup>();
  auto handle = *usb.open(usb.list().front(), 0, *wakeup);
  DriverProfile profile =
    *parseProfile(builtInProfile("pid"), R"({"origin_m": [0.01, -0.02, 0.03], "polarity": [1, 1]})", "pid");
  DrivenDevice device(
    std::make_unique<PidDriver>(std::move(profile), std::move(wakeup), std::move(handle), 0),
    DrivenDevice::Drive::Inline);
  DeviceSample sample;
  for (int i = 1; i <= 40; ++i) {
    device.read(0.004 * i, sample);
    device.write({0.0, 0.0, 0.0});
  }
  EXPECT_LT((sample.position + Eigen::Vector3d(0.01, -0.02, 0.03)).norm(), 1e-3);
  for (int i = 41; i <= 60; ++i) {
    device.read(0.004 * i, sample);
    device.write({1.0, 0.5, 0.0});
  }
  EXPECT_LT((model->force() - Eigen::Vector3d(-1.0, 0.5, 0.0)).norm(), 0.05);
}

// 250 reports a second and axis, whatever the servo's rate; nothing at all for a force that does not change.
TEST(PidDevice, KeepsToItsRate)
{
  const auto model = stick();
  FakeUsbTransport usb(model);
  auto driver = openDriver("pid", {}, usb);
  ASSERT_TRUE(driver);
  DrivenDevice device(std::move(*driver), DrivenDevice::Drive::Inline);
  DeviceSample sample;
  double now = 0.0;
  const auto run = [&](double amplitude) {
    const auto before = model->reports();
    for (int i = 0; i < 1000; ++i) {
      now += 0.001;
      device.read(now, sample);
      device.write({amplitude * std::sin(0.05 * i), 0.0, 0.0});
    }
    return model->reports() - before;
  };
  run(0.0);
  EXPECT_EQ(run(0.0), 0u);
  const auto reports = run(1.0);
  EXPECT_LE(reports, 251u);
  EXPECT_GE(reports, 200u);
}

// The host dies without a word: the device lets go by itself when the effect has run out.
TEST(PidDevice, LetsGoWhenTheHostIsSilent)
{
  const auto model = stick();
  FakeUsbTransport usb(model);
  auto driver = openDriver("pid", {}, usb);
  ASSERT_TRUE(driver);
  for (int i = 1; i <= 50; ++i) (*driver)->step(0.004 * i, {1.0, 0.0, 0.0}, true);
  ASSERT_GT(model->force().norm(), 0.5);
  for (int i = 0; i < 120; ++i) model->advance(0.2 + 0.002 * i);
  EXPECT_TRUE(model->force().isZero(0.0));
}

TEST(WoodenDevice, NeedsConsentAndAHomeAndThenPushes)
{
  const auto model = std::make_shared<WoodenModel>();
  FakeUsbTransport usb(model);
  ASSERT_FALSE(openDriver("wooden", {}, usb)); // its USB numbers are nobody's
  DeviceOptions options;
  options.optIn = true;
  {
    auto driver = openDriver("wooden", options, usb);
    ASSERT_TRUE(driver);
    DrivenDevice device(std::move(*driver), DrivenDevice::Drive::Inline);
    DeviceSample sample;
    double now = 0.0;
    const Eigen::Vector3d force(0.4, -0.3, 0.2);
    const auto run = [&](int ticks) {
      DeviceLink link = DeviceLink::NoReply;
      for (int i = 0; i < ticks; ++i) {
        now += 0.001;
        link = device.read(now, sample);
        device.write(force);
      }
      return link;
    };
    EXPECT_EQ(run(20), DeviceLink::NeedsHome);
    EXPECT_TRUE(model->force().isZero(0.0));
    device.requestHome();
    EXPECT_EQ(run(5), DeviceLink::Ready);
    EXPECT_LT((model->force() - force).norm(), 0.02); // words of 1 mA
    EXPECT_LT((sample.position - model->grip().position()).norm(), 1e-3);
    for (int i = 0; i < 600; ++i) model->advance(now + 0.001 * i);
    EXPECT_TRUE(model->force().isZero(0.0)); // its own watchdog
  }
  EXPECT_GE(model->zerosInRow(), 3);
}

TEST(DriverProfile, BuiltInOnesAreValidAndOwnOnesAreLaidOver)
{
  for (const char* kind : {"falcon", "pid", "wooden"})
    EXPECT_TRUE(parseProfile(builtInProfile(kind), "", kind)) << kind;
  const auto own = parseProfile(builtInProfile("falcon"), R"({"limits": {"force_N": 4.5}})", "own");
  ASSERT_TRUE(own);
  EXPECT_EQ(own->device.maxForce, 4.5);
  EXPECT_EQ(own->device.maxStiffness, 3000.0);
}

TEST(DriverProfile, SaysWhichKeyIsWrong)
{
  const std::pair<const char*, const char*> bad[] = {
    {R"({"limits": {"force_N": 1e9}})", "force_N"},
    {R"({"limits": {"force_N": "5"}})", "force_N"},
    {R"({"limit": {}})", "limit"},
    {R"({"usb": ["0403cb48"]})", "0403cb48"},
    {R"({"origin_m": [0, 0]})", "origin_m"},
    {R"({"polarity": [1, 0]})", "polarity"},
    {R"({"mechanism": {"period_s": 0}})", "period_s"},
    {R"({"quirks": {"endless_effects": 1}})", "endless_effects"},
    {R"({"workspace_m": {"min": [1,1,1]}})", "workspace_m"},
    {R"([1])", "JSON object"},
    {R"({"limits": 3})", "limits"},
  };
  for (const auto& [text, word] : bad) {
    const auto profile = parseProfile(builtInProfile("falcon"), text, "my.json");
    ASSERT_FALSE(profile) << text;
    EXPECT_NE(profile.error().detail.find(word), std::string::npos) << profile.error().detail;
    EXPECT_NE(profile.error().detail.find("my.json"), std::string::npos);
  }
}

} // namespace
} // namespace esm
