// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// The part of ForceModel that takes other numbers for a few springs, nodes and anchors.
#include "core/forces/force_model.h"

#include <algorithm>

namespace esm {

std::int64_t ForceModel::setParameters(const ParameterPatch& patch, const SpringNet& net,
                                       const Eigen::Vector3d& gravity)
{
  std::int64_t looked = 0;
  if (!patch.springs.empty() && findPlaces(net)) looked += net.springCount();
  if (!setSprings(patch, looked)) {
    *this = ForceModel(net, gravity);
    return looked + net.springCount();
  }
  if (patch.anchorSet || !setNodes(patch, net)) {
    const NodeRanges ranges = nodeRanges();
    compileNodes(net, gravity, ranges);
    m_knowsAnchors = false;
  }
  if (!patch.bulkModuli.empty()) m_pressure = Pressure(net);
  return looked;
}

/// @return whether it was not known yet
bool ForceModel::findPlaces(const SpringNet& net)
{
  if (!m_placeOf.empty()) return false;
  m_placeOf.resize(static_cast<std::size_t>(net.springCount()));
  for (std::size_t b = 0; b < m_batches.size(); ++b)
    for (std::size_t i = 0; i < m_batches[b].count; ++i)
      m_placeOf[static_cast<std::size_t>(m_batches[b].spring[i])] = {static_cast<std::uint32_t>(b),
                                                                     static_cast<std::uint32_t>(i)};
  return true;
}

bool ForceModel::isInItsKind(const ParameterPatch::Spring& spring, Place place) const noexcept
{
  const bool isIdle = spring.stiffness == 0.0 && spring.viscosity == 0.0;
  if (place.batch == Place::kIdle || isIdle) return isIdle && place.batch == Place::kIdle;
  const SpringBatch& batch = m_batches[place.batch];
  return effectiveLaw(spring.law, spring.lawParameter) == batch.law &&
         batch.damped == (spring.viscosity > 0.0) &&
         (batch.law != SpringLaw::Table || batch.parameter[place.spring] == spring.lawParameter);
}

/// @return false if one has to go to another batch; some may have got their numbers then.
bool ForceModel::setSprings(const ParameterPatch& patch, std::int64_t& looked)
{
  std::vector<std::uint32_t> batches;
  for (const ParameterPatch::Spring& spring : patch.springs) {
    const Place place = m_placeOf[static_cast<std::size_t>(spring.spring)];
    ++looked;
    if (!isInItsKind(spring, place)) return false;
    if (place.batch == Place::kIdle) continue;
    m_batches[place.batch].set(place.spring, spring.stiffness, spring.viscosity, spring.lawParameter);
    batches.push_back(place.batch);
  }
  std::sort(batches.begin(), batches.end());
  batches.erase(std::unique(batches.begin(), batches.end()), batches.end());
  for (const std::uint32_t batch : batches) looked += static_cast<std::int64_t>(m_batches[batch].changed());
  return true;
}

/// Where the net's anchors are, and which a node has.
void ForceModel::findAnchors(const SpringNet& net)
{
  if (m_knowsAnchors) return;
  m_knowsAnchors = true;
  m_anchorAt.assign(static_cast<std::size_t>(net.anchors.count()), kNoIndex);
  for (std::size_t k = 0; k < m_anchors.size(); ++k)
    m_anchorAt[static_cast<std::size_t>(m_anchors[k].place)] = static_cast<Index>(k);
  m_anchorsOfNode.build(nodeCount(), [this](const auto& add) {
    for (std::size_t k = 0; k < m_anchors.size(); ++k) add(m_anchors[k].node, static_cast<Index>(k));
  });
}

/// @return false if an anchor or mass damping comes or goes; some may have got their numbers then.
bool ForceModel::setNodes(const ParameterPatch& patch, const SpringNet& net)
{
  if (patch.nodes.empty() && patch.anchors.empty()) return true;
  const bool hadDrag = !m_massDrag.empty();
  if (hadDrag != (net.massDamping.size() > 0 && net.massDamping.maxCoeff() > 0.0)) return false;
  if (hadDrag || !patch.anchors.empty()) findAnchors(net);
  std::vector<Index> bedded;
  for (const ParameterPatch::Node& node : patch.nodes) {
    m_nodeForces.setMass(node.node, node.mass);
    if (!hadDrag) continue;
    m_massDrag[static_cast<std::size_t>(node.node)] = net.massDamping[node.node] * node.mass;
    bedded.push_back(node.node);
  }
  for (const ParameterPatch::Anchor& given : patch.anchors) {
    const Index place = m_anchorAt[static_cast<std::size_t>(given.anchor)];
    if ((given.stiffness > 0.0 || given.viscosity > 0.0) != (place != kNoIndex)) return false;
    if (place == kNoIndex) continue;
    Anchor& anchor = m_anchors[static_cast<std::size_t>(place)];
    anchor.stiffness = given.stiffness;
    anchor.viscosity = given.viscosity;
    bedded.push_back(anchor.node);
  }
  for (const Index node : bedded) {
    const auto i = static_cast<std::size_t>(node);
    m_nodeForces.setBed(node, hadDrag ? m_massDrag[i] : 0.0, m_anchors, m_anchorsOfNode[i]);
  }
  return true;
}

} // namespace esm
