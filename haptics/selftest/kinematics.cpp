// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/device/falcon_driver.h"
#include "haptics/kinematics/delta3.h"
#include "haptics/protocol/falcon_packet.h"
#include "haptics/selftest/bench.h"
#include "haptics/selftest/selftest.h"

#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace esm {

namespace {

/// A pose of the workspace whose condition is below 8; angles and their Jacobian with it.
struct Pose {
  Eigen::Vector3d position, angles;
  Eigen::Matrix3d jacobian;
};

template <class Random>
Pose randomPose(const Delta3& mechanism, Random& random)
{
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (Pose pose;;) {
    pose.position =
      Delta3::centre() + Eigen::Vector3d(0.045 * unit(random), 0.045 * unit(random), 0.06 * unit(random));
    if (!mechanism.inverse(pose.position, pose.angles) ||
        !mechanism.jacobian(pose.position, pose.angles, pose.jacobian))
      continue;
    const Eigen::Vector3d values = pose.jacobian.jacobiSvd().singularValues();
    if (values[0] < 8.0 * values[2]) return pose;
  }
}

void addPoses(std::vector<SelftestRow>& rows)
{
  const Delta3 mechanism;
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  double error = 0.0, turn = 0.0, units = 0.0;
  int iterations = 0;
  for (int i = 0; i < 20000; ++i) {
    const Pose pose = randomPose(mechanism, random);
    // A servo's next position: within 3.5 mm of the last.
    Eigen::Vector3d found = pose.position + 0.002 * Eigen::Vector3d(unit(random), unit(random), unit(random));
    int steps = 0;
    if (!mechanism.forward(pose.angles, found, &steps)) error = kInfinity;
    error = std::max(error, (found - pose.position).norm());
    iterations = std::max(iterations, steps);

    const double size = std::pow(10.0, 1.0 + 150.0 * std::max(0.0, unit(random)));
    const Eigen::Vector3d force = size * Eigen::Vector3d(unit(random), unit(random), unit(random));
    const auto words = falconMotors(mechanism, pose.position, pose.angles, force);
    const Eigen::Vector3d torque(words[0], words[1], words[2]);
    units = std::max(units, torque.cwiseAbs().maxCoeff());
    const Eigen::Vector3d felt = pose.jacobian.transpose() * torque;
    if (torque.norm() < 1000.0) continue; // rounding to words turns small forces
    const double cosine = felt.normalized().dot(force.normalized());
    turn = std::max(turn, std::acos(std::clamp(cosine, -1.0, 1.0)) * 180.0 / 3.14159265358979);
  }
  for (const double odd : {kInfinity, -kInfinity, std::numeric_limits<double>::quiet_NaN()}) {
    const Pose pose = randomPose(mechanism, random);
    for (const auto word : falconMotors(mechanism, pose.position, pose.angles, {odd, 1.0, 0.0}))
      units = std::max(units, std::abs(static_cast<double>(word)));
  }
  rows.push_back({"A1", "pose from angles of a pose, 20,000 of the workspace", 1e9 * error, 0.0, 1.0, "nm"});
  rows.push_back({"A1", "Newton steps at most", static_cast<double>(iterations), 1.0, 5.0, "1"});
  rows.push_back({"A3", "turn of a saturated force", turn, 0.0, 0.5, "deg"});
  rows.push_back({"A3", "largest motor word for any force, infinite and NaN too", units, 0.0, 4095.0, "1"});
}

void addPackets(std::vector<SelftestRow>& rows)
{
  int wrong = 0;
  for (int value = -32768; value <= 32767; ++value)
    for (std::size_t motor = 0; motor < 3; ++motor) {
      falcon::Command sent, got;
      sent.motor[motor] = static_cast<std::int16_t>(value);
      if (!falcon::decode(falcon::encode(sent), got) || got.motor != sent.motor) ++wrong;
    }
  // One byte of a stream is spoiled, each place and each value: all packets but that one arrive, and the next
  // one is found at once.
  int worst = 0;
  falcon::Reply reply;
  reply.encoder = {1234, -5678, 91};
  reply.homed = falcon::kHomedAll;
  const falcon::Packet packet = falcon::encode(reply);
  for (std::size_t place = 0; place < falcon::kPacketSize; ++place)
    for (int value = 0; value < 256; ++value) {
      falcon::StreamParser parser;
      int lost = 0;
      for (int i = 0; i < 3; ++i) {
        bool arrived = false;
        for (std::size_t b = 0; b < falcon::kPacketSize; ++b) {
          const bool spoiled = i == 1 && b == place;
          arrived = parser.push(spoiled ? static_cast<std::uint8_t>(value) : packet[b]) || arrived;
        }
        if (!arrived) ++lost;
      }
      worst = std::max(worst, lost);
    }
  rows.push_back(
    {"A2", "words of 65,536 x 3 that do not come back", static_cast<double>(wrong), 0.0, 0.0, "1"});
  rows.push_back(
    {"A2", "packets lost by one spoiled byte, at most", static_cast<double>(worst), 0.0, 1.0, "1"});
}

} // namespace

std::vector<SelftestRow> selftestKinematics()
{
  std::vector<SelftestRow> rows;
  addPoses(rows);
  addPackets(rows);
  std::stable_sort(rows.begin(), rows.end(),
                   [](const SelftestRow& a, const SelftestRow& b) { return a.id < b.id; });
  return rows;
}

} // namespace esm
