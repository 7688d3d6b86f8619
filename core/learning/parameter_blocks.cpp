// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/learning/parameters.h"

#include <algorithm>
#include <map>

namespace esm::learning {
namespace {

using Parameters = Result<std::vector<Parameter>>;

constexpr double kOneSpring = 0.3;    ///< deviation of the logarithm of one spring from its class
constexpr double kLawDeviation = 8.0; ///< of b, of which soft tissues have 0 to 20

Parameter parameterOf(std::string name, LearnedQuantity quantity)
{
  Parameter parameter;
  parameter.name = std::move(name);
  parameter.factor.quantity = quantity;
  return parameter;
}

Parameter allSprings()
{
  return parameterOf("all springs", LearnedQuantity::Stiffness);
}

Parameters makeGlobal(const BlockSource& source)
{
  Parameter all = allSprings();
  for (Index s = 0; s < source.net.springCount(); ++s) all.shares.push_back({NetQuantity::Stiffness, s, 1.0});
  return std::vector<Parameter>{std::move(all)};
}

/// One parameter for each class that has springs, by rising answers.
std::vector<Parameter> byClass(const BlockSource& source, LearnedQuantity learned, NetQuantity quantity)
{
  const std::vector<SpringClass> classes = answersOf(source.questions, source.net);
  std::map<SpringClass, Parameter> found;
  for (Index s = 0; s < source.net.springCount(); ++s) {
    Parameter& parameter = found[classes[at(s)]];
    parameter.factor.quantity = learned;
    parameter.factor.of = classes[at(s)];
    parameter.shares.push_back({quantity, s, 1.0});
  }
  std::vector<Parameter> parameters;
  for (auto& [answers, parameter] : found) {
    parameter.name = classText(answers, source.questions, Language::English);
    parameters.push_back(std::move(parameter));
  }
  return parameters;
}

Parameters makeClasses(const BlockSource& source)
{
  return byClass(source, LearnedQuantity::Stiffness, NetQuantity::Stiffness);
}

/// One factor for all springs, and one for each region, which fades as the region does.
Parameters makeRegions(const BlockSource& source)
{
  Parameters parameters = makeGlobal(source);
  const SpringNet& net = source.net;
  for (const Region& region : source.tissue.regions) {
    if (!region.enabled) continue;
    const auto alike = std::count_if(source.tissue.regions.begin(), source.tissue.regions.end(),
                                     [&](const Region& r) { return r.enabled && r.name == region.name; });
    if (region.name.empty() || alike > 1)
      return invalidValue("regions that are learned need names of their own, but " +
                          (region.name.empty()
                             ? "one has none"
                             : std::to_string(alike) + " are called \"" + region.name + "\"") +
                          "; rename them");
    Parameter parameter = parameterOf("region " + region.name, LearnedQuantity::Stiffness);
    parameter.factor.region = region.name;
    const RegionShape shape(region);
    for (Index s = 0; s < net.springCount(); ++s)
      if (const double weight = shape.weight(net.middleOf(s)); weight > 0.0)
        parameter.shares.push_back({NetQuantity::Stiffness, s, weight});
    if (!parameter.shares.empty()) parameters->push_back(std::move(parameter));
  }
  if (parameters->size() == 1)
    return invalidValue(
      "the project has no region that is on and holds springs, so that no region can be learned; add "
      "one where the tissue may differ");
  return parameters;
}

Parameters makeSprings(const BlockSource& source)
{
  std::vector<Parameter> parameters;
  for (Index s = 0; s < source.net.springCount(); ++s) {
    Parameter parameter = parameterOf(
      "spring " + std::to_string(static_cast<Index>(source.net.springId[at(s)])), LearnedQuantity::Stiffness);
    parameter.spring = source.net.springId[at(s)];
    parameter.deviation = kOneSpring;
    parameter.shares.push_back({NetQuantity::Stiffness, s, 1.0});
    parameters.push_back(std::move(parameter));
  }
  return parameters;
}

Parameters makeLaw(const BlockSource& source)
{
  if (std::any_of(source.net.law.begin(), source.net.law.end(),
                  [](SpringLaw law) { return law != SpringLaw::Exponential; }))
    return invalidValue(
      "the parameter of the force law is learned of the exponential law alone; give the tissue that law");
  std::vector<Parameter> parameters =
    byClass(source, LearnedQuantity::LawParameter, NetQuantity::LawParameter);
  for (Parameter& parameter : parameters) {
    parameter.name += ", b";
    parameter.deviation = kLawDeviation;
  }
  return parameters;
}

Parameters makeAnchors(const BlockSource& source)
{
  Parameter all = parameterOf("the bed", LearnedQuantity::Anchor);
  const AnchorSet& anchors = source.net.anchors;
  for (Index i = 0; i < anchors.count(); ++i)
    if (!anchors.isBand(i)) all.shares.push_back({NetQuantity::AnchorStiffness, i, 1.0});
  if (all.shares.empty())
    return invalidValue(
      "the net has no bed (anchors of its tissue), so that its stiffness cannot be learned");
  return std::vector<Parameter>{std::move(all)};
}

constexpr ParameterBlock kBlocks[] = {
  {"global", "one factor for all springs", makeGlobal},
  {"classes", "a factor for each class of springs, told apart by questions to geometry", makeClasses},
  {"regions", "a factor for all springs and one for each region", makeRegions},
  {"springs", "a factor for each spring, held near 1", makeSprings},
  {"law", "an addition to b of the exponential law for each class", makeLaw},
  {"anchors", "one factor for the bed", makeAnchors},
};

} // namespace

std::span<const ParameterBlock> parameterBlocks() noexcept
{
  return kBlocks;
}

const ParameterBlock* findBlock(std::string_view id) noexcept
{
  const auto found = std::find_if(std::begin(kBlocks), std::end(kBlocks),
                                  [&](const ParameterBlock& block) { return id == block.id; });
  return found != std::end(kBlocks) ? found : nullptr;
}

} // namespace esm::learning
