// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// Whatever a user does while a hand is inside tissue, force begins softly and stays within its bounds.
#include "core/net/net_builder.h"
#include "core/runtime/sim_runner.h"
#include "haptics/servo_loop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <optional>
#include <random>
#include <sstream>
#include <utility>

namespace esm {

namespace {

constexpr double kTick = 0.001;        ///< [s]
constexpr double kFrame = 1.0 / 60.0;  ///< [s]
constexpr double kRadius = 0.03;       ///< of the organ [m]
constexpr double kStiffest = 3000.0;   ///< that a device of this kind may feel [N/m], see DeviceProfile
constexpr double kFadeOut = 0.055;     ///< 50 ms by the safety rules, and some ticks of rounding [s]
constexpr double kWait = 0.05;         ///< 50 ticks below 0.2 N [s]
constexpr double kHold = 1.0;          ///< of a late model at most [s]
constexpr double kSmall = 0.2;         ///< [N]
constexpr double kSlew = 1000.0;       ///< [N/s]
constexpr double kExtraDamping = 4.0;  ///< 20 % of the device's 20 N s/m while force fades in
constexpr double kGuardDamping = 20.0; ///< the device's most, of the energy guard [N s/m]
constexpr double kRounding = 1e-9;     ///< [N], of sums of hundreds of ticks

/// Where the hand is, whatever is done to it: pressing an organ at the origin from above, in and out.
struct ScriptedHand {
  double depth = 0.012, rate = 0.5, phase = 0.0; ///< [m], [1/s]
  Eigen::Vector3d at(double t) const
  {
    const double way = 0.5 * (1.0 - std::cos(2.0 * std::numbers::pi * (rate * t + phase))); // 0 ... 1
    return {0.002 * std::sin(1.7 * t), 0.001 * std::cos(2.3 * t), kRadius + 0.007 - (0.004 + depth) * way};
  }
};

/// A device that is exactly where the script has the hand.
class ScriptedDevice final : public HapticDevice {
public:
  ScriptedDevice(const ScriptedHand& hand, const double& now, const std::uint32_t& epoch, double armTime)
    : m_hand(hand), m_now(now), m_epoch(epoch)
  {
    m_profile.armTime = armTime;
  }
  const DeviceProfile& profile() const noexcept override { return m_profile; }
  DeviceLink read(double, DeviceSample& sample) noexcept override
  {
    if (link == DeviceLink::Ready) {
      sample.position = m_hand.at(m_now);
      sample.epoch = m_epoch;
    }
    return link;
  }
  bool write(const Eigen::Vector3d& newForce) noexcept override
  {
    force = newForce;
    return link != DeviceLink::Lost;
  }
  DeviceLink link = DeviceLink::Ready;
  Eigen::Vector3d force = Eigen::Vector3d::Zero();

private:
  const ScriptedHand& m_hand;
  const double& m_now;
  const std::uint32_t& m_epoch;
  DeviceProfile m_profile;
};

/// A closed organ: an octahedron whose edges are halved once, on a sphere; 18 nodes, held by anchors.
SpringNet organ(double stiffness)
{
  const auto index = [](int x, int y, int z) {
    return static_cast<Index>((x + 1) * 9 + (y + 1) * 3 + z + 1);
  };
  std::vector<Index> nodeOf(27, kNoIndex);
  std::vector<Eigen::Vector3d> places;
  std::vector<std::array<Index, 3>> triangles;
  const auto node = [&](const Eigen::Vector3i& p) {
    Index& known = nodeOf[static_cast<std::size_t>(index(p.x(), p.y(), p.z()))];
    if (known == kNoIndex) {
      known = static_cast<Index>(places.size());
      places.push_back(kRadius * p.cast<double>().normalized());
    }
    return known;
  };
  for (int sx : {-1, 1})
    for (int sy : {-1, 1})
      for (int sz : {-1, 1}) {
        const Eigen::Vector3i x(sx, 0, 0), y(0, sy, 0), z(0, 0, sz);
        const Eigen::Vector3i xy = x + y, yz = y + z, zx = z + x;
        std::array<std::array<Eigen::Vector3i, 3>, 4> parts{
          {{x, xy, zx}, {xy, y, yz}, {zx, yz, z}, {xy, yz, zx}}};
        for (auto& part : parts) {
          if (sx * sy * sz < 0) std::swap(part[1], part[2]); // all of them outwards
          triangles.push_back({node(part[0]), node(part[1]), node(part[2])});
        }
      }
  std::vector<std::pair<Index, Index>> edges;
  for (const auto& t : triangles)
    for (int k = 0; k < 3; ++k)
      if (t[static_cast<std::size_t>(k)] < t[static_cast<std::size_t>((k + 1) % 3)])
        edges.emplace_back(t[static_cast<std::size_t>(k)], t[static_cast<std::size_t>((k + 1) % 3)]);
  SpringNet net;
  const auto nodes = static_cast<Index>(places.size());
  resizeNet(net, nodes, static_cast<Index>(edges.size()));
  net.triangles.resize(3, static_cast<Index>(triangles.size()));
  for (Index i = 0; i < nodes; ++i) net.restPosition.col(i) = places[static_cast<std::size_t>(i)];
  for (Index t = 0; t < net.triangles.cols(); ++t)
    for (int k = 0; k < 3; ++k)
      net.triangles(k, t) = triangles[static_cast<std::size_t>(t)][static_cast<std::size_t>(k)];
  for (Index s = 0; s < net.springCount(); ++s) {
    const auto [a, b] = edges[static_cast<std::size_t>(s)];
    net.ends.col(s) << a, b;
    net.restLength[s] = (net.restPosition.col(b) - net.restPosition.col(a)).norm();
  }
  net.stiffness.setConstant(stiffness);
  net.viscosity.setConstant(0.5);
  net.mass.setConstant(0.002);
  net.anchors.point = net.restPosition;
  net.anchors.stiffness.setConstant(nodes, 0.5 * stiffness);
  net.anchors.viscosity.setConstant(nodes, 0.3);
  for (Index i = 0; i < nodes; ++i) net.anchors.node.push_back(i);
  return net;
}

/// What the force may be, known from what was done and when alone: nothing of how the servo computes it.
class Bound {
public:
  /// Tissue appears, or the user arms: the old force is gone after the fade-out, and the new one begins from
  /// nothing after the wait at the earliest.
  void begins(double now, const Eigen::Vector3d& hand, double force)
  {
    m_begin = {now, hand, force};
    m_silence.reset();
    m_leap.reset();
  }
  /// No answer any more: what is felt now may go on until it has been held for its time.
  void fallsSilent(double now, const Eigen::Vector3d& hand)
  {
    m_silence = Event{now + kHold + kTick, hand, 10.0};
  }
  /// A contact comes to where the hand is already: what it has at once is small, the rest fades in.
  /// @param gone after which the old force is [s].
  void leaps(double now, const Eigen::Vector3d& hand, double force, double gone)
  {
    m_leap = Event{now, hand, force, gone};
  }

  double most(double now, const Eigen::Vector3d& hand, double limit, double armTime, double speed)
  {
    if (m_silence && now >= m_silence->time) m_begin = *std::exchange(m_silence, {});
    const double damping = kExtraDamping * speed;
    double most = limit;
    const double age = now - m_begin.time;
    if (age <= kFadeOut)
      most = std::min(most, m_begin.force + kStiffest * (hand - m_begin.hand).norm() + damping +
                              kGuardDamping * speed);
    else
      most = std::min(most, (age - kWait + kTick) / armTime * limit + damping); // the last of the 50 begins
    if (m_leap) {
      const double since = now - m_leap->time, way = (hand - m_leap->hand).norm();
      most = std::min(most, (since < m_leap->gone ? m_leap->force : 0.0) + kSmall + kStiffest * way +
                              (since + kTick) / armTime * limit + damping);
    }
    return most;
  }

private:
  struct Event {
    double time;
    Eigen::Vector3d hand;
    double force;
    double gone = 0.0;
  };
  Event m_begin{-10.0, Eigen::Vector3d::Zero(), 0.0};
  std::optional<Event> m_silence, m_leap;
};

enum class Deed {
  Arm,
  Disarm,
  Stop,
  Play,
  Pause,
  Step,
  Reset,
  Load,
  Undo,
  Edit,
  Unplug,
  Silence,
  Heavy,
  Place,
  Tool,
  Gain,
  Limit,
  Rest
};
constexpr int kDeeds = static_cast<int>(Deed::Rest) + 1;

struct Tally {
  std::int64_t ticks = 0, felt = 0, begun = 0, trips = 0;
  double largest = 0.0, fastest = 0.0, generated = 0.0;
};

/// A user, a hand, a device and an organ, for one sequence of deeds.
class Session {
public:
  Session(std::uint64_t seed, Tally& tally) : m_random(seed), m_tally(tally)
  {
    m_hand.depth = 0.002 + 0.014 * unit();
    m_hand.rate = 0.5 + 1.5 * unit();
    m_hand.phase = unit();
    m_armTime = seed % 10 == 0 ? 2.0 : 0.1 + 0.3 * unit();
    m_story << "seed " << seed << ", armTime " << m_armTime << ":";
    plug();
    m_runner.apply(command::SetQuality{});
    m_runner.apply(command::Touch{true, 0.003, 5.0});
    m_runner.apply(command::FollowDevice{true});
    if (coin()) { // else the project is empty at first
      load(100.0);
      if (coin()) play();
    }
    if (coin()) order(ForceOrder::Arm, true);
  }
  std::string story() const { return m_story.str(); }
  bool bad() const { return m_bad; }

  void run(int deeds)
  {
    for (int i = 0; i < deeds && !m_bad; ++i) {
      act(coin() ? whatIsMissing() : static_cast<Deed>(m_random() % kDeeds));
      const bool shortly = m_random() % 3 != 0;
      const int rest = 1 + static_cast<int>(m_random() % (shortly ? 60 : 400));
      for (int t = 0; t < rest && !m_bad; ++t) tick();
    }
  }

private:
  /// For force to flow, as far as a user knows.
  Deed whatIsMissing()
  {
    if (!m_loop) return Deed::Unplug; // in again
    if (!m_loaded) return Deed::Load;
    if (!m_plays) return Deed::Play;
    const DeviceState state = m_loop->core().status().state;
    return state == DeviceState::Idle || state == DeviceState::Fault ? Deed::Arm : Deed::Rest;
  }
  double unit() { return std::uniform_real_distribution<double>(0.0, 1.0)(m_random); }
  bool coin() { return m_random() % 2 == 0; }
  void begins() { m_bound.begins(m_now, m_hand.at(m_now), force()); }
  double force() const { return m_device != nullptr ? m_device->force.norm() : 0.0; }

  void plug()
  {
    auto device = std::make_unique<ScriptedDevice>(m_hand, m_now, m_epoch, m_armTime);
    m_device = device.get();
    m_loop =
      std::make_unique<ServoLoop>(std::move(device), std::make_unique<VirtualClock>(), m_tool, m_contact);
    m_loop->core().setForceLimit(m_limit);
    m_loop->core().setForceScale(m_gain);
    m_last.setZero();
    begins();
  }
  void order(ForceOrder what, bool appears = false)
  {
    if (!m_loop) return;
    m_loop->core().orders().give(what);
    if (appears) begins();
  }
  void load(double stiffness)
  {
    m_stiffness = stiffness;
    m_runner.apply(command::Load{++m_generation, organ(stiffness), {}, {}});
    m_loaded = true;
    m_held = false;
    begins();
  }
  void play()
  {
    if (m_loaded && !m_plays) begins();
    m_plays = m_loaded;
    m_runner.apply(command::Play{});
  }

  void act(Deed deed)
  {
    m_story << ' ' << m_now << " s deed " << static_cast<int>(deed) << ';';
    switch (deed) {
    case Deed::Arm: {
      const DeviceState state = m_loop ? m_loop->core().status().state : DeviceState::Absent;
      const bool isOn = state == DeviceState::Arming || state == DeviceState::Active;
      order(ForceOrder::Arm, !isOn);
      break;
    }
    case Deed::Disarm:
      order(ForceOrder::Disarm);
      break;
    case Deed::Stop:
      order(ForceOrder::Stop);
      break;
    case Deed::Play:
      play();
      break;
    case Deed::Pause:
      m_runner.apply(command::Pause{});
      m_plays = false;
      begins();
      break;
    case Deed::Step:
      m_runner.apply(command::StepOnce{});
      m_plays = false;
      begins();
      break;
    case Deed::Reset:
      m_runner.apply(command::Reset{});
      m_held = false;
      if (m_loaded) begins();
      break;
    case Deed::Load:
      load(30.0 + 300.0 * unit());
      m_plays = false;
      break;
    case Deed::Undo: { // across nets: the window loads the former one and plays on
      if (!m_loaded) break;
      const bool played = m_plays;
      load(m_before);
      m_plays = false;
      if (played) play();
      break;
    }
    case Deed::Edit:
      if (!m_loaded) break;
      m_before = m_stiffness;
      m_stiffness = std::clamp(m_stiffness * std::pow(4.0, 2.0 * unit() - 1.0), 20.0, 2000.0);
      m_runner.apply(command::SetParameters{organ(m_stiffness)});
      break;
    case Deed::Unplug:
      if (m_loop) {
        m_device->link = DeviceLink::Lost;
        for (int i = 0; i < 3 && !m_bad; ++i) tick();
        m_device = nullptr;
        m_loop.reset();
        m_runner.apply(command::FollowDevice{false});
      } else {
        m_runner.apply(command::FollowDevice{true});
        plug();
      }
      break;
    case Deed::Silence: // a simulation that hangs, and what comes after
      m_nextFrame = m_now + kHold + 0.06;
      m_bound.fallsSilent(m_now, m_hand.at(m_now));
      if (coin()) break; // whatever is done next breaks in on it
      for (const double end = m_nextFrame; m_now < end && !m_bad;) tick();
      break;
    case Deed::Heavy: // frames that take up to half a second each, or do no longer
      m_heavy = !m_heavy;
      break;
    case Deed::Place:
      ++m_epoch;
      m_hand.phase += 0.5 * unit();
      m_bound.leaps(m_now, m_hand.at(m_now), force(), 5.5 / kSlew); // 5 N at the slew rate
      break;
    case Deed::Tool: {
      if (!m_loaded) break;
      const bool isFelt = m_contact.latest().active;
      if (m_held) {
        m_runner.apply(command::Release{});
      } else if (coin()) {
        m_runner.apply(command::Grab{static_cast<Index>(m_random() % 18), m_hand.at(m_now), 5.0});
      } else {
        m_runner.apply(command::Touch{false, 0.0, 5.0});
        m_runner.apply(command::Touch{true, 0.003, 5.0});
        m_held = true; // for the next line
      }
      m_held = !m_held;
      if (isFelt || !m_held)
        begins();
      else
        m_bound.leaps(m_now, m_hand.at(m_now), force(), kFadeOut);
      break;
    }
    case Deed::Gain:
      m_gain = 0.2 + 3.0 * unit();
      if (m_loop) m_loop->core().setForceScale(m_gain);
      break;
    case Deed::Limit:
      m_limit = 0.5 + 6.0 * unit();
      m_atLimit = force();
      m_limitSince = m_now;
      if (m_loop) m_loop->core().setForceLimit(m_limit);
      break;
    case Deed::Rest:
      break;
    }
  }

  void tick()
  {
    const Eigen::Vector3d before = m_hand.at(m_now);
    m_now += kTick;
    if (m_now >= m_nextFrame) {
      m_nextFrame = m_now + (m_heavy ? 0.5 * unit() : kFrame);
      m_runner.runFrame();
    }
    if (!m_loop) return;
    m_loop->runTicks(1);
    const Eigen::Vector3d hand = m_hand.at(m_now);
    look(hand, (hand - before).norm() / kTick);
  }

  /// Each tick: finite, within limit, slew and fade; the guard's account below its trip or the force off.
  void look(const Eigen::Vector3d& hand, double speed)
  {
    const Eigen::Vector3d now = m_device->force;
    const double limit = std::min(5.0, m_limit), size = now.norm();
    // A limit below the force is reached at the slew rate, on the straight way to another direction: 10 N at
    // most.
    const double lowered = m_now - m_limitSince < 0.0105 ? std::max(limit, m_atLimit) : limit;
    const double most = m_bound.most(m_now, hand, limit, m_armTime, std::max(speed, m_speed));
    m_speed = std::max(speed, 0.999 * m_speed); // the velocity is filtered
    const ServoStatus& status = m_loop->core().status();
    check(now.allFinite(), "a force that is no number");
    check(size <= lowered + kRounding, "above the limit");
    check((now - m_last).norm() <= kSlew * kTick + kRounding, "faster than the slew rate");
    check(size <= std::max(most, lowered > limit ? lowered : 0.0) + kRounding, "more than the fade allows");
    check(status.generated <= 0.02 || status.state == DeviceState::Fault, "energy from nowhere");
    if (m_bad) m_story << " FORCE " << size << " of " << most << " at " << m_now << " s";
    ++m_tally.ticks;
    m_tally.felt += size > 0.1 ? 1 : 0;
    m_tally.begun += size > 0.0 && m_last.isZero(0.0) ? 1 : 0;
    m_tally.trips += status.reason == ServoReason::EnergyTooHigh ? 1 : 0;
    m_tally.largest = std::max(m_tally.largest, size);
    m_tally.fastest = std::max(m_tally.fastest, (now - m_last).norm());
    m_tally.generated = std::max(m_tally.generated, status.generated);
    m_last = now;
  }
  void check(bool good, const char* what)
  {
    if (good || m_bad) return;
    m_bad = true;
    m_story << "  " << what;
  }

  std::mt19937_64 m_random;
  Tally& m_tally;
  std::ostringstream m_story;
  ScriptedHand m_hand;
  double m_now = 0.0, m_nextFrame = 0.0, m_armTime = 2.0, m_limit = 5.0, m_gain = 1.0, m_speed = 0.0;
  double m_stiffness = 100.0, m_before = 150.0;
  double m_atLimit = 0.0, m_limitSince = -1.0; ///< force when the limit was changed [N], when [s]
  std::uint32_t m_epoch = 0;
  std::uint64_t m_generation = 0;
  bool m_loaded = false, m_plays = false, m_held = false, m_heavy = false, m_bad = false;
  Eigen::Vector3d m_last = Eigen::Vector3d::Zero();
  Bound m_bound;
  TripleBuffer<ToolState> m_tool;
  TripleBuffer<ContactModel> m_contact;
  SimRunner m_runner{1.0 / kFrame, m_tool, m_contact};
  ScriptedDevice* m_device = nullptr; ///< in m_loop
  std::unique_ptr<ServoLoop> m_loop;
};

} // namespace

// The deeds a user has, in any order, at any time, with a hand that presses in and out of an organ all the
// while. What may be felt follows from what was done alone; see Bound.
TEST(SoftBeginnings, TenThousandRandomSequencesNeverSurpriseTheHand)
{
  constexpr std::uint64_t kSequences = 10000;
  Tally tally;
  int bad = 0;
  for (std::uint64_t seed = 0; seed < kSequences && bad < 5; ++seed) {
    Session session(seed, tally);
    session.run(8);
    if (!session.bad()) continue;
    ++bad;
    ADD_FAILURE() << session.story();
  }
  // It was felt, and often begun: a servo that gives no force at all would be no proof.
  EXPECT_GT(tally.felt, tally.ticks / 100);
  EXPECT_GT(tally.begun, static_cast<std::int64_t>(kSequences) / 2);
  EXPECT_GT(tally.largest, 4.0);
  RecordProperty("ticks", std::to_string(tally.ticks));
  RecordProperty("felt", std::to_string(tally.felt));
  RecordProperty("begun", std::to_string(tally.begun));
  RecordProperty("largest_newton", std::to_string(tally.largest));
  RecordProperty("fastest_newton_per_tick", std::to_string(tally.fastest));
  RecordProperty("generated_joule", std::to_string(tally.generated));
}

} // namespace esm
