// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/learning/parameters.h"

#include <algorithm>
#include <cmath>

namespace esm::learning {
namespace {

constexpr std::size_t placeOf(NetQuantity quantity) noexcept
{
  return static_cast<std::size_t>(quantity);
}

constexpr bool isAdded(NetQuantity quantity) noexcept
{
  return quantity == NetQuantity::LawParameter;
}

/// d(number)/d(sum w theta)
double slopeOf(NetQuantity quantity, const SpringNet& net, Index index) noexcept
{
  return isAdded(quantity) ? 1.0 : numbersOf(net, quantity)[index];
}

} // namespace

ParameterSet::ParameterSet(const SpringNet& net, std::vector<Parameter> parameters)
  : m_parameters(std::move(parameters))
{
  for (const Parameter& parameter : m_parameters)
    for (const Parameter::Share& share : parameter.shares) m_isTouched[placeOf(share.quantity)] = true;
  for (std::size_t q = 0; q < kNetQuantityCount; ++q)
    if (m_isTouched[q]) m_before[q] = numbersOf(net, static_cast<NetQuantity>(q));
}

std::vector<double> ParameterSet::centres() const
{
  std::vector<double> centres;
  for (const Parameter& parameter : m_parameters) centres.push_back(parameter.centre);
  return centres;
}

void ParameterSet::apply(std::span<const double> theta, SpringNet& net) const
{
  std::array<Eigen::ArrayXd, kNetQuantityCount> sums;
  for (std::size_t q = 0; q < kNetQuantityCount; ++q)
    if (m_isTouched[q]) sums[q] = Eigen::ArrayXd::Zero(m_before[q].size());
  for (std::size_t j = 0; j < m_parameters.size(); ++j)
    for (const Parameter::Share& share : m_parameters[j].shares)
      sums[placeOf(share.quantity)][share.index] += share.weight * theta[j];
  for (std::size_t q = 0; q < kNetQuantityCount; ++q) {
    if (!m_isTouched[q]) continue;
    Eigen::ArrayXd& numbers = numbersOf(net, static_cast<NetQuantity>(q));
    if (isAdded(static_cast<NetQuantity>(q)))
      numbers = m_before[q] + sums[q];
    else
      numbers = m_before[q] * sums[q].exp();
  }
}

void ParameterSet::pullBack(const SpringNet& net, const NetGradient& from, std::span<double> to) const
{
  for (std::size_t j = 0; j < m_parameters.size(); ++j)
    for (const Parameter::Share& share : m_parameters[j].shares)
      to[j] += share.weight * slopeOf(share.quantity, net, share.index) * from[share.quantity][share.index];
}

void ParameterSet::changesOf(Index parameter, const SpringNet& net, std::vector<NumberChange>& changes) const
{
  changes.clear();
  for (const Parameter::Share& share : m_parameters[at(parameter)].shares)
    changes.push_back(
      {share.quantity, share.index, share.weight * slopeOf(share.quantity, net, share.index)});
}

LearnedLayer layerOf(const ParameterSet& set, const SpringQuestions& questions, std::span<const double> theta,
                     std::span<const double> deviations, std::span<const std::uint8_t> isSeen)
{
  LearnedLayer layer;
  for (std::size_t j = 0; j < set.parameters().size(); ++j) {
    const Parameter& parameter = set.parameters()[j];
    if (parameter.spring != SpringId{-1}) {
      layer.springs.push_back({parameter.spring, theta[j]});
      continue;
    }
    LearnedFactor factor = parameter.factor;
    factor.value = theta[j];
    factor.deviation = deviations.empty() ? 0.0 : deviations[j];
    factor.isSeen = isSeen.empty() || isSeen[j] != 0;
    layer.factors.push_back(factor);
  }
  std::sort(layer.springs.begin(), layer.springs.end(),
            [](const auto& a, const auto& b) { return a.spring < b.spring; });
  const bool asks = std::any_of(layer.factors.begin(), layer.factors.end(),
                                [](const LearnedFactor& f) { return f.of != SpringClass{}; });
  if (asks) layer.questions = questions;
  return layer;
}

} // namespace esm::learning
