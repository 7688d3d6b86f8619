// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/learning/static_slopes.h"

#include <cmath>

namespace esm::learning {
namespace {

double slopeBy(NetQuantity quantity, const SpringSlopes& slopes) noexcept
{
  switch (quantity) {
  case NetQuantity::Stiffness:
    return slopes.byStiffness;
  case NetQuantity::LawParameter:
    return slopes.byParameter;
  case NetQuantity::RestLength:
    return slopes.byRestLength;
  case NetQuantity::AnchorStiffness:
    break;
  }
  return 0.0;
}

} // namespace

const char* nameOf(NetQuantity quantity) noexcept
{
  constexpr const char* kNames[kNetQuantityCount] = {"stiffness", "law_parameter", "rest_length",
                                                     "anchor_stiffness"};
  return kNames[static_cast<std::size_t>(quantity)];
}

Eigen::ArrayXd& numbersOf(SpringNet& net, NetQuantity quantity) noexcept
{
  switch (quantity) {
  case NetQuantity::LawParameter:
    return net.lawParameter;
  case NetQuantity::RestLength:
    return net.restLength;
  case NetQuantity::AnchorStiffness:
    return net.anchors.stiffness;
  case NetQuantity::Stiffness:
    break;
  }
  return net.stiffness;
}

const Eigen::ArrayXd& numbersOf(const SpringNet& net, NetQuantity quantity) noexcept
{
  return numbersOf(const_cast<SpringNet&>(net), quantity);
}

NetGradient::NetGradient(const SpringNet& net)
{
  for (std::size_t q = 0; q < kNetQuantityCount; ++q)
    of[q] = Eigen::ArrayXd::Zero(numbersOf(net, static_cast<NetQuantity>(q)).size());
}

StaticSlopes::StaticSlopes(Statics& statics, const SpringNet& net)
  : m_statics(statics),
    m_net(net),
    m_direction(at(net.springCount()), Lanes{0, 0, 0, 0}),
    m_springs(at(net.springCount())),
    m_anchors(at(net.anchors.count()), Lanes{0, 0, 0, 0})
{
  const NodeArray& x = statics.place();
  for (const SpringBatch& batch : statics.system().forces().batches())
    for (std::size_t i = 0; i < batch.count; ++i) {
      const Lanes d = x[at(batch.b[i])] - x[at(batch.a[i])];
      const double length = std::sqrt(dot(d, d));
      if (!(length >= kMinSpringLength)) continue;
      const auto s = at(batch.spring[i]);
      m_direction[s] = d / length;
      m_springs[s] = springSlopes(net, batch, i, length - batch.restLength[i]);
    }
  for (const Anchor& anchor : statics.system().forces().anchors())
    m_anchors[at(anchor.place)] = anchor.point - x[at(anchor.node)];
}

void StaticSlopes::addGradient(NodeArray& byPlace, NetGradient& gradient)
{
  m_statics.solveTangent(byPlace);
  for (Index s = 0; s < m_net.springCount(); ++s) {
    const double along =
      dot(m_direction[at(s)], byPlace[at(m_net.ends(0, s))] - byPlace[at(m_net.ends(1, s))]);
    const SpringSlopes& slopes = m_springs[at(s)];
    gradient[NetQuantity::Stiffness][s] += along * slopes.byStiffness;
    gradient[NetQuantity::LawParameter][s] += along * slopes.byParameter;
    gradient[NetQuantity::RestLength][s] += along * slopes.byRestLength;
  }
  for (Index i = 0; i < m_net.anchors.count(); ++i)
    gradient[NetQuantity::AnchorStiffness][i] +=
      dot(m_anchors[at(i)], byPlace[at(m_net.anchors.node[at(i)])]);
}

void StaticSlopes::changeOfPlace(std::span<const NumberChange> changes, NodeArray& change)
{
  change.assign(m_statics.place().size(), Lanes{0, 0, 0, 0});
  for (const NumberChange& one : changes) {
    const auto i = at(one.index);
    if (one.quantity == NetQuantity::AnchorStiffness) {
      change[at(m_net.anchors.node[i])] += m_anchors[i] * one.amount;
      continue;
    }
    const Lanes pull = m_direction[i] * (slopeBy(one.quantity, m_springs[i]) * one.amount);
    change[at(m_net.ends(0, one.index))] += pull;
    change[at(m_net.ends(1, one.index))] -= pull;
  }
  m_statics.solveTangent(change); // what pulls at held nodes, the supports take
}

} // namespace esm::learning
