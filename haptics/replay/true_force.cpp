// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/replay/true_force.h"

#include "core/contact/tool_grip.h"
#include "core/contact/tool_tip.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace esm {

namespace {

/// A held node or a ball on the surface, whichever the scene has.
class Tool {
public:
  Tool(const ReplayScene& scene, const Eigen::Vector3d& start)
  {
    if (scene.node)
      m_grip.emplace(scene.net, scene.net.restPosition, *scene.node, scene.gripRadius, start,
                     scene.toolLimit);
    else
      m_tip.emplace(scene.net, scene.tipRadius, scene.toolLimit);
  }
  void pull(Simulation& simulation, const Eigen::Vector3d& hand, const Eigen::Vector3d& velocity)
  {
    const NetState& state = simulation.state();
    if (m_grip) {
      m_grip->moveTo(hand, velocity);
      simulation.setTools(m_grip->springs(state));
      return;
    }
    m_tip->moveTo(hand, velocity);
    m_tip->update(state);
    if (m_tip->pulls())
      simulation.setTools(m_tip->springs(state));
    else
      simulation.setTools({});
  }
  Eigen::Vector3d forceOnHand(const NetState& state)
  {
    if (m_tip) m_tip->update(state);
    return m_grip ? m_grip->forceOnHand(state) : m_tip->forceOnHand(state);
  }

private:
  std::optional<ToolGrip> m_grip;
  std::optional<ToolTip> m_tip;
};

} // namespace

Result<Eigen::Matrix3Xd> trueForce(const ReplayScene& scene, const std::vector<ReplayTick>& ticks,
                                   int stepsPerTick)
{
  Eigen::Matrix3Xd force = Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(ticks.size()));
  if (ticks.empty()) return force;
  Result<Simulation> simulation = Simulation::create(scene.net, scene.loads, scene.solver);
  if (!simulation) return simulation.error();
  Tool tool(scene, ticks.front().grip);
  for (std::size_t i = 1; i < ticks.size(); ++i) {
    const double step = (ticks[i].time - ticks[i - 1].time) / stepsPerTick;
    const Eigen::Vector3d way = (ticks[i].grip - ticks[i - 1].grip) / stepsPerTick;
    for (int k = 1; k <= stepsPerTick; ++k) {
      tool.pull(*simulation, ticks[i - 1].grip + k * way, way / step);
      const StepReport report = simulation->advance(step);
      if (!report.good()) return Error{ErrorCode::Numerics, simulation->why()};
      force.col(static_cast<Eigen::Index>(i)) = tool.forceOnHand(simulation->state());
    }
  }
  return force;
}

ForceError forceError(const std::vector<ReplayTick>& ticks, const Eigen::Matrix3Xd& truth, double scale)
{
  ForceError error;
  double squares = 0.0;
  int count = 0;
  bool hasFadedIn = false;
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    hasFadedIn = hasFadedIn || ticks[i].state == DeviceState::Active;
    if (!hasFadedIn) continue;
    const Eigen::Vector3d wanted = scale * truth.col(static_cast<Eigen::Index>(i));
    const double off = (ticks[i].force - wanted).norm();
    error.peak = std::max(error.peak, wanted.norm());
    error.most = std::max(error.most, off);
    squares += off * off;
    ++count;
  }
  if (error.peak > 0.0 && count > 0) {
    error.most /= error.peak;
    error.rms = std::sqrt(squares / count) / error.peak;
  }
  return error;
}

} // namespace esm
