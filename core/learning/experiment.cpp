// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/learning/experiment.h"

#include "core/forces/load_schedule.h"

#include <cmath>

namespace esm::learning {
namespace {

/// Sensitivities of more parameters are not kept as a start: a gigabyte for a large net.
constexpr Index kFewParameters = 300;

auto placesIn(const NodeArray& x)
{
  return [&x](Index node) { return toVector(x[at(node)]); };
}

bool isOnFree(const Marker& marker, const SpringNet& net, const std::vector<std::uint8_t>& isHeld)
{
  for (std::size_t k = 0; k < 3 && marker.node[k] != kNoIndex; ++k)
    if (marker.share[k] != 0.0 && net.fixed[at(marker.node[k])] == 0 && isHeld[at(marker.node[k])] == 0)
      return true;
  return false;
}

std::vector<std::uint8_t> prescribedNodes(const Loads& loads, const SpringNet& net)
{
  std::vector<std::uint8_t> isHeld(at(net.nodeCount()), 0);
  for (const PrescribedMotion& motion : loads.motions)
    for (const Index node : motion.nodes) isHeld[at(node)] = 1;
  return isHeld;
}

Status checkMarkers(const Recording& recording, const SpringNet& net)
{
  for (std::size_t m = 0; m < recording.markers.size(); ++m) {
    const Marker& marker = recording.markers[m];
    double sum = 0.0;
    for (std::size_t k = 0; k < 3 && marker.node[k] != kNoIndex; ++k) {
      if (marker.node[k] < 0 || marker.node[k] >= net.nodeCount())
        return invalidValue("marker " + std::to_string(m) + " lies on a node that the net does not have");
      sum += marker.share[k];
    }
    if (!(std::abs(sum - 1.0) < 1e-6))
      return invalidValue("the shares of marker " + std::to_string(m) + " do not sum to 1");
    if (!recording.weight.empty() && !(recording.weight[m] > 0.0 && std::isfinite(recording.weight[m])))
      return invalidValue("the weight of marker " + std::to_string(m) + " must be above 0");
  }
  return {};
}

} // namespace

Status checkRecording(const Recording& recording, const SpringNet& net)
{
  const auto named = [&](const Error& error) {
    return Error{error.code, recording.name + ": " + error.detail};
  };
  if (static_cast<Eigen::Index>(recording.markers.size()) != recording.position.cols() ||
      (!recording.weight.empty() && recording.weight.size() != recording.markers.size()))
    return named(invalidValue("has not one place, and one weight or none, for each marker"));
  if (const Status status = checkLoads(recording.loads, net.nodeCount()); !status)
    return named(status.error());
  if (const Status status = checkMarkers(recording, net); !status) return named(status.error());
  const std::vector<std::uint8_t> isHeld = prescribedNodes(recording.loads, net);
  double moved = 0.0;
  for (std::size_t m = 0; m < recording.markers.size(); ++m) {
    const Eigen::Vector3d way =
      recording.position.col(static_cast<Eigen::Index>(m)) - recording.markers[m].at(restOf(net));
    if (way.allFinite() && isOnFree(recording.markers[m], net, isHeld)) moved = std::max(moved, way.norm());
  }
  if (!(moved > 0.0))
    return named(invalidValue("no marker on a free node was seen to move, so that it teaches nothing"));
  return {};
}

Result<Experiment> Experiment::create(const SpringNet& net, Recording recording)
{
  if (const Status status = checkRecording(recording, net); !status) return status.error();
  if (const Status status = Statics::check(net, recording.loads); !status)
    return Error{status.error().code, recording.name + ": " + status.error().detail};
  return Experiment(net, std::move(recording));
}

Experiment::Experiment(const SpringNet& net, Recording recording)
  : m_recording(std::move(recording)), m_statics(net, m_recording.loads, m_recording.time)
{
  const std::vector<std::uint8_t> isHeld = prescribedNodes(m_recording.loads, net);
  double square = 0.0;
  for (std::size_t m = 0; m < m_recording.markers.size(); ++m) {
    const Marker& marker = m_recording.markers[m];
    const Eigen::Vector3d rest = marker.at(restOf(net));
    const Eigen::Vector3d moved = m_recording.position.col(static_cast<Eigen::Index>(m)) - rest;
    if (!moved.allFinite() || !isOnFree(marker, net, isHeld)) continue;
    const double weight = m_recording.weight.empty() ? 1.0 : m_recording.weight[m];
    m_markers.push_back({marker, rest, moved, weight});
    square += (weight * moved).squaredNorm();
    m_largestSeen = std::max(m_largestSeen, moved.norm());
  }
  for (Seen& seen : m_markers) seen.scale /= std::sqrt(square);
  m_residual.resize(3 * static_cast<Eigen::Index>(m_markers.size()));
}

void Experiment::findResidual()
{
  for (std::size_t m = 0; m < m_markers.size(); ++m) {
    const Seen& seen = m_markers[m];
    const Eigen::Vector3d moved = seen.marker.at(placesIn(m_statics.place())) - seen.rest;
    m_residual.segment<3>(3 * static_cast<Eigen::Index>(m)) = seen.scale * (moved - seen.moved);
  }
}

Experiment::Trial Experiment::respond(const SpringNet& net, std::span<const double> step)
{
  ++m_forwards;
  m_statics.setParameters(net);
  StaticsLimits limits;
  limits.farthest = kFarthest * m_largestSeen;
  limits.steps = m_accepted.empty() ? kFirstSteps : kTrialSteps;
  if (m_accepted.empty()) {
    m_statics.goToRest();
  } else if (step.size() == m_changes.size() && !step.empty()) {
    NodeArray start = m_accepted;
    for (std::size_t j = 0; j < step.size(); ++j)
      advanceNodes(start.size(), step[j], start.data(), m_changes[j].data(), start.data());
    m_statics.setPlace(start);
  } else {
    m_statics.setPlace(m_accepted);
  }
  Trial trial;
  trial.outcome = m_statics.solve(limits).outcome;
  if (!trial.isBalanced()) return trial;
  findResidual();
  trial.error = m_residual.norm();
  return trial;
}

void Experiment::accept()
{
  m_accepted = m_statics.place();
  m_changes.clear();
}

void Experiment::restart()
{
  m_accepted.clear();
  m_changes.clear();
}

void Experiment::findSlopes(const SpringNet& net, const ParameterSet& set)
{
  StaticSlopes slopes(m_statics, net);
  m_slopes.resize(m_residual.size(), set.count());
  const bool isKept = set.count() <= kFewParameters;
  m_changes.assign(isKept ? at(set.count()) : 0, {});
  std::vector<NumberChange> changes;
  NodeArray change;
  for (Index j = 0; j < set.count(); ++j) {
    set.changesOf(j, net, changes);
    slopes.changeOfPlace(changes, change);
    for (std::size_t m = 0; m < m_markers.size(); ++m)
      m_slopes.block<3, 1>(3 * static_cast<Eigen::Index>(m), j) =
        m_markers[m].scale * m_markers[m].marker.at(placesIn(change));
    if (isKept) m_changes[at(j)] = change;
  }
}

void Experiment::addGradient(const SpringNet& net, NetGradient& gradient)
{
  NodeArray byPlace(m_statics.place().size(), Lanes{0, 0, 0, 0});
  for (std::size_t m = 0; m < m_markers.size(); ++m) {
    const Seen& seen = m_markers[m];
    const Eigen::Vector3d pull = seen.scale * m_residual.segment<3>(3 * static_cast<Eigen::Index>(m));
    for (std::size_t k = 0; k < 3 && seen.marker.node[k] != kNoIndex; ++k)
      byPlace[at(seen.marker.node[k])] += toLanes(seen.marker.share[k] * pull);
  }
  StaticSlopes(m_statics, net).addGradient(byPlace, gradient);
}

} // namespace esm::learning
