// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/learning/static_slopes.h"
#include "core/tissue/tissue_model.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace esm::learning {

/// One number theta that is learned. It moves many numbers of a net at once, each by its own weight w:
///
///     number = number before x exp(sum w theta)      stiffness, rest length, anchors: they stay positive
///     number = number before + sum w theta           parameters of laws
///
/// the sums over all parameters that name the number.
struct Parameter {
  std::string name;       ///< for reports
  LearnedFactor factor;   ///< what it becomes in the learned layer; its value is not used
  SpringId spring{-1};    ///< of a parameter for one spring; then `factor` is not used
  double deviation = 1.1; ///< standard deviation of the prior about its centre [1]; 1.1 is a factor of 3
  double centre = 0.0;    ///< of the prior, and where learning begins [1]
  struct Share {
    NetQuantity quantity = NetQuantity::Stiffness;
    Index index = kNoIndex;
    double weight = 1.0;
  };
  std::vector<Share> shares;

  /// Whether it is a factor of springs everywhere, for all or a class of them: what makes a net stiffer as a whole.
  bool isCommonStiffness() const noexcept
  {
    return spring == SpringId{-1} && factor.region.empty() && factor.quantity == LearnedQuantity::Stiffness;
  }
};

/// The parameters of a fit over one net.
class ParameterSet {
public:
  /// @param net  the numbers before. @param parameters  shares in range.
  ParameterSet(const SpringNet& net, std::vector<Parameter> parameters);

  Index count() const noexcept { return static_cast<Index>(m_parameters.size()); }
  const std::vector<Parameter>& parameters() const noexcept { return m_parameters; }
  std::vector<double> centres() const;

  /// Writes the numbers at theta into a copy of the net.
  void apply(std::span<const double> theta, SpringNet& net) const;
  /// dL/dtheta from dL/d(number), added. @param net  after apply().
  void pullBack(const SpringNet& net, const NetGradient& from, std::span<double> to) const;
  /// What theta_j changes in the net's numbers, per 1. @param net  after apply().
  void changesOf(Index parameter, const SpringNet& net, std::vector<NumberChange>& changes) const;

private:
  std::vector<Parameter> m_parameters;
  std::array<Eigen::ArrayXd, kNetQuantityCount> m_before;
  std::array<bool, kNetQuantityCount> m_isTouched{};
};

/// What parameter blocks are made from.
struct BlockSource {
  const SpringNet& net;
  const TissueModel& tissue; ///< its regions
  SpringQuestions questions = usualQuestions();
};

/// A kind of parameters. Adding one is one function and one line in the table.
struct ParameterBlock {
  const char* id;
  const char* description;
  Result<std::vector<Parameter>> (*make)(const BlockSource& source);
};
/// global, classes, regions, springs, law, anchors.
std::span<const ParameterBlock> parameterBlocks() noexcept;
const ParameterBlock* findBlock(std::string_view id) noexcept; ///< null if there is none

/// The layer that says the same as the parameters at theta. @param deviations, isSeen  of each, or empty.
LearnedLayer layerOf(const ParameterSet& set, const SpringQuestions& questions, std::span<const double> theta,
                     std::span<const double> deviations = {}, std::span<const std::uint8_t> isSeen = {});

} // namespace esm::learning
