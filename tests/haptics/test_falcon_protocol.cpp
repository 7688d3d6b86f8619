// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/device/falcon_driver.h"
#include "haptics/device/sha256.h"
#include "haptics/emulator/falcon_model.h"
#include "haptics/protocol/falcon_packet.h"
#include "haptics/protocol/falcon_upload.h"
#include "haptics/protocol/ftdi.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace esm::falcon {
namespace {

TEST(FalconPacket, NibblesComeLowestFirst)
{
  Command command;
  command.motor[0] = -1447; // 0xFA59
  command.leds = kRed | kGreen;
  command.homing = true;
  const Packet packet = encode(command);
  EXPECT_EQ(packet[0], '<');
  EXPECT_EQ(std::string(packet.begin() + 1, packet.begin() + 5), "JFKP");
  EXPECT_EQ(packet[13], 0x41 + (0x8 | 0x2 | 0x1));
  EXPECT_EQ(packet[14], 'A');
  EXPECT_EQ(packet[15], '>');
}

TEST(FalconPacket, EveryValueComesBackOnEveryAxis)
{
  StreamParser parser;
  for (int value = -32768; value <= 32767; ++value) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Reply reply;
      reply.encoder[axis] = static_cast<std::int16_t>(value);
      reply.homed = static_cast<std::uint8_t>(value & 7);
      reply.buttons = static_cast<std::uint8_t>(value >> 3 & 15);
      const Packet packet = encode(reply);
      bool complete = false;
      for (const std::uint8_t byte : packet) complete = parser.push(byte);
      ASSERT_TRUE(complete);
      const Reply back = parser.reply();
      ASSERT_EQ(back.encoder, reply.encoder);
      ASSERT_EQ(back.homed, reply.homed);
      ASSERT_EQ(back.buttons, reply.buttons);
      Command command;
      command.motor[axis] = static_cast<std::int16_t>(value);
      Command got;
      ASSERT_TRUE(decode(encode(command), got));
      ASSERT_EQ(got.motor, command.motor);
    }
  }
  EXPECT_EQ(parser.dropped(), 0u);
}

// Any byte of a packet changed to any other value, a byte lost, a byte too many: at most the packet it stands
// in and the next are lost.
TEST(FalconPacket, OneBadByteCostsNoMoreThanThePacketAfterIt)
{
  Reply reply;
  reply.encoder = {1, -2, 300};
  const Packet good = encode(reply);
  for (std::size_t place = 0; place < kPacketSize; ++place) {
    for (int value = 0; value < 258; ++value) {
      std::vector<std::uint8_t> stream(good.begin(), good.end());
      if (value == 256)
        stream.erase(stream.begin() + static_cast<std::ptrdiff_t>(place));
      else if (value == 257)
        stream.insert(stream.begin() + static_cast<std::ptrdiff_t>(place), '<');
      else
        stream[place] = static_cast<std::uint8_t>(value);
      for (int i = 0; i < 2; ++i) stream.insert(stream.end(), good.begin(), good.end());
      StreamParser parser;
      bool last = false;
      for (const std::uint8_t byte : stream) last = parser.push(byte);
      ASSERT_TRUE(last) << "byte " << place << " is " << value;
      ASSERT_EQ(parser.reply().encoder, reply.encoder);
    }
  }
}

// What the parser passes is always a packet that encoding gives back byte for byte: no ghost states.
TEST(FalconPacket, AMillionRandomBytesGiveNoGhost)
{
  std::mt19937 random(11);
  StreamParser parser;
  int packets = 0;
  for (int i = 0; i < 1000000; ++i) {
    // Mostly bytes that may stand in a packet, or chance would never make one.
    const auto pick = random();
    const auto byte = static_cast<std::uint8_t>(pick % 20 == 0   ? '<'
                                                : pick % 20 == 1 ? '>'
                                                                 : 0x40 + (pick >> 8) % 18);
    if (!parser.push(byte)) continue;
    ++packets;
    const Packet again = encode(parser.reply());
    for (std::size_t k = 0; k < kPacketSize; ++k) {
      if (k != 14) {
        ASSERT_EQ(again[k], parser.packet()[k]);
      }
    }
    EXPECT_LE(parser.reply().homed, 7);
    EXPECT_LE(parser.reply().buttons, 15);
  }
  EXPECT_GT(packets, 0);
}

double angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180.0 / 3.141592653589793;
}

// A wrapped word would turn the force round; here even 1e300 N keeps its direction.
TEST(FalconMotors, SaturationKeepsTheDirection)
{
  const Delta3 mechanism;
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> side(-0.03, 0.03), height(0.09, 0.15), power(0.3, 300.0);
  for (int i = 0; i < 20000; ++i) {
    const Eigen::Vector3d x(side(random), side(random), height(random));
    Eigen::Vector3d angles;
    ASSERT_TRUE(mechanism.inverse(x, angles));
    const Eigen::Vector3d direction =
      Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
    const Eigen::Vector3d force = direction * std::pow(10.0, power(random)); // 2 N to 1e300 N
    const auto words = falconMotors(mechanism, x, angles, force);
    for (const std::int16_t word : words) ASSERT_LE(std::abs(word), kFullScale);
    Eigen::Matrix3d j;
    ASSERT_TRUE(mechanism.jacobian(x, angles, j));
    const Eigen::Vector3d torque = j.transpose().inverse() * direction;
    ASSERT_LT(angleBetween(Eigen::Vector3d(words[0], words[1], words[2]), torque), 0.5);
  }
}

TEST(FalconMotors, WhatIsNotANumberGivesZero)
{
  const Delta3 mechanism;
  Eigen::Vector3d angles;
  ASSERT_TRUE(mechanism.inverse(Delta3::centre(), angles));
  const std::array<std::int16_t, 3> zero{};
  for (const double bad :
       {std::nan(""), std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()})
    EXPECT_EQ(falconMotors(mechanism, Delta3::centre(), angles, {0.0, bad, 1.0}), zero);
  EXPECT_EQ(motorWords({std::nan(""), 1.0, 1.0}), zero);
}

// 4095 units at the centre: 16.9 N along the axis, and in the worst direction across it close to the 8 N that
// the device is rated at.
TEST(FalconMotors, FullScaleIsTheKnownForce)
{
  const Delta3 mechanism;
  Eigen::Vector3d angles, torques;
  ASSERT_TRUE(mechanism.inverse(Delta3::centre(), angles));
  ASSERT_TRUE(mechanism.torques(Delta3::centre(), angles, {0.0, 0.0, 1.0}, torques));
  const double full = kFullScale / kUnitsPerTorque;
  EXPECT_NEAR(full / torques.cwiseAbs().maxCoeff(), 16.9, 0.1);
  double least = 1e9;
  for (int i = 0; i < 360; ++i) {
    const double a = i * 3.141592653589793 / 180.0;
    ASSERT_TRUE(mechanism.torques(Delta3::centre(), angles, {std::cos(a), std::sin(a), 0.0}, torques));
    least = std::min(least, full / torques.cwiseAbs().maxCoeff());
  }
  EXPECT_GT(least, 7.4);
  EXPECT_LT(least, 8.0);
}

/// Plays an upload to the emulated boot loader, in 1 ms steps.
UploadFsm::Step playUpload(FalconModel& model, UploadFsm& fsm, double seconds)
{
  std::array<std::uint8_t, 64> bytes{};
  for (double now = 0.0; now < seconds; now += 0.001) {
    model.advance(now);
    for (int got; (got = model.in(bytes)) > 2;)
      fsm.received({bytes.data() + 2, static_cast<std::size_t>(got) - 2});
    const UploadFsm::Action action = fsm.next(now);
    if (action.step == UploadFsm::Step::Control) model.control(action.setup, {});
    if (action.step == UploadFsm::Step::Send) model.out(action.bytes);
    if (action.step == UploadFsm::Step::Done || action.step == UploadFsm::Step::Failed) return action.step;
  }
  return UploadFsm::Step::Wait;
}

std::vector<std::uint8_t> someImage(std::size_t size)
{
  std::vector<std::uint8_t> image(size);
  std::mt19937 random(1);
  for (std::uint8_t& byte : image) byte = static_cast<std::uint8_t>(random());
  return image;
}

TEST(FalconUpload, BringsTheWholeImage)
{
  FalconModel::Settings settings;
  settings.imageSize = 7324;
  FalconModel model(settings);
  const auto image = someImage(settings.imageSize);
  UploadFsm fsm(image);
  EXPECT_EQ(playUpload(model, fsm, 5.0), UploadFsm::Step::Done);
  EXPECT_EQ(fsm.attempts(), 1);
  model.control(ftdi::k1500000Baud, {});
  EXPECT_TRUE(model.running());
}

TEST(FalconUpload, AWrongEchoMeansAllAgain)
{
  FalconModel::Settings settings;
  settings.wrongEchoes = 3;
  FalconModel model(settings);
  const auto image = someImage(settings.imageSize);
  UploadFsm fsm(image);
  EXPECT_EQ(playUpload(model, fsm, 20.0), UploadFsm::Step::Done);
  EXPECT_EQ(fsm.attempts(), 4);
}

TEST(FalconUpload, GivesUpOnADeviceThatNeverAnswers)
{
  FalconModel::Settings settings;
  settings.dead = true;
  FalconModel model(settings);
  const auto image = someImage(100);
  UploadFsm fsm(image);
  EXPECT_EQ(playUpload(model, fsm, 1000.0), UploadFsm::Step::Failed);
}

// FIPS 180-4, and a length that needs a second block of padding.
TEST(Sha256, KnowsThePublishedValues)
{
  EXPECT_EQ(sha256Hex({}), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  const std::vector<std::uint8_t> abc{'a', 'b', 'c'};
  EXPECT_EQ(sha256Hex(abc), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  const std::string two = "abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq";
  EXPECT_EQ(sha256Hex({reinterpret_cast<const std::uint8_t*>(two.data()), two.size()}),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
}

} // namespace
} // namespace esm::falcon
