// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/tissue/tissue_model.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr const char* kOutputIds[] = {"youngs_modulus", "viscosity", "anchoring"};
/// Stands for zero in logarithms: far below any tissue, and 10^x gives it back as zero.
constexpr double kZeroLog = -400.0;

Error invalid(std::string detail)
{
  return {ErrorCode::InvalidValue, std::move(detail)};
}

bool isPositive(double x)
{
  return std::isfinite(x) && x > 0.0;
}

double safeLog(double x)
{
  return x > 0.0 ? std::log10(x) : kZeroLog;
}

TissueParameters fromLog(const Eigen::Array3d& logs)
{
  const auto plain = [](double x) { return x <= kZeroLog ? 0.0 : std::pow(10.0, x); };
  return {plain(logs[0]), plain(logs[1]), plain(logs[2])};
}

/// The tissue outputs of an inference as logarithms, in the order of TissueParameters.
Eigen::Array3d logParameters(const fuzzy::RuleBase& rules, const fuzzy::Inference& inference)
{
  Eigen::Array3d logs;
  for (int i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < rules.outputs.size(); ++k)
      if (rules.outputs[k].id == kOutputIds[i]) logs[i] = safeLog(inference.outputs[k].value);
  return logs;
}

Status checkInputs(const TissueModel& model, const std::vector<fuzzy::InputValue>& inputs,
                   const std::string& where)
{
  const auto& variables = model.rules.inputs;
  if (inputs.size() != variables.size())
    return invalid(where + " has " + std::to_string(inputs.size()) + " inputs, the rule base asks for " +
                   std::to_string(variables.size()));
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const std::string input = where + ": input '" + variables[i].id + "'";
    if (const double* value = std::get_if<double>(&inputs[i])) {
      if (!std::isfinite(*value)) return invalid(input + " is not a finite number");
      continue;
    }
    const std::string& word = std::get<fuzzy::Word>(inputs[i]).term;
    const auto& terms = variables[i].terms;
    if (std::none_of(terms.begin(), terms.end(), [&](const fuzzy::Term& term) { return term.id == word; }))
      return invalid(input + ": term '" + word + "' is unknown");
  }
  return {};
}

Status checkRegion(const TissueModel& model, const Region& region, const std::string& where)
{
  const Ellipsoid& e = region.ellipsoid;
  if (!e.centre.allFinite()) return invalid(where + ": the centre is not finite");
  if (!isPositive(e.semiAxes[0]) || !isPositive(e.semiAxes[1]) || !isPositive(e.semiAxes[2]))
    return invalid(where + ": every semi-axis must be above 0 m");
  if (!(std::abs(e.rotation.norm() - 1.0) < 1e-6))
    return invalid(where + ": the rotation is not a unit quaternion");
  if (!(region.falloff >= 0.0 && region.falloff <= 1.0))
    return invalid(where + ": the falloff must lie in 0 to 1");
  return checkInputs(model, region.inputs, where);
}

Status checkModel(const TissueModel& model)
{
  for (const char* id : kOutputIds) {
    const fuzzy::Variable* output = model.rules.findOutput(id);
    if (!output) return invalid(std::string("the rule base has no output '") + id + "'");
    if (output->minimum < 0.0)
      return invalid(std::string("the range of output '") + id + "' must not go below 0");
  }
  if (!isPositive(model.thickness)) return invalid("the wall's thickness must be above 0 m");
  if (!isPositive(model.density)) return invalid("the density must be above 0 kg/m^3");
  if (model.law == SpringLaw::Table) return invalid("tissue offers no force table, choose another law");
  if (!std::isfinite(model.lawParameter) || model.lawParameter < 0.0)
    return invalid("the parameter of the force law must be finite and not below 0");
  return checkInputs(model, model.inputs, "the base tissue");
}

/// In [0, 1] for every point, 0 where there is none (NaN).
double weightAt(const Ellipsoid& ellipsoid, double falloff, const Eigen::Vector3d& point)
{
  const double weight = falloffWeight(ellipsoid.radius(point), falloff);
  return weight > 0.0 ? weight : 0.0;
}

} // namespace

Result<TissueField> TissueField::create(const TissueModel& model)
{
  auto engine = fuzzy::Engine::create(model.rules);
  if (!engine) return engine.error();
  if (Status status = checkModel(model); !status) return status.error();

  TissueField field;
  field.m_model = model;
  field.m_baseInference = engine->evaluate(model.inputs);
  field.m_baseLog = logParameters(model.rules, field.m_baseInference);
  field.m_base = fromLog(field.m_baseLog);
  for (std::size_t i = 0; i < model.regions.size(); ++i) {
    const Region& region = model.regions[i];
    const std::string where = "region " + std::to_string(i + 1) + " '" + region.name + "'";
    if (Status status = checkRegion(model, region, where); !status) return status.error();
    if (!region.enabled) continue;
    field.m_regionInferences.push_back(engine->evaluate(region.inputs));
    field.m_regions.push_back({region.ellipsoid, region.falloff,
                               logParameters(model.rules, field.m_regionInferences.back()),
                               static_cast<int>(i)});
  }
  return field;
}

TissueParameters TissueField::at(const Eigen::Vector3d& point) const noexcept
{
  Eigen::Array3d logs = m_baseLog;
  bool touched = false;
  for (const CompiledRegion& region : m_regions) {
    const double weight = weightAt(region.ellipsoid, region.falloff, point);
    if (weight == 0.0) continue;
    touched = true;
    logs += weight * (region.logParameters - logs);
  }
  return touched ? fromLog(logs) : m_base;
}

Explanation TissueField::explain(const Eigen::Vector3d& point) const
{
  Explanation explanation;
  explanation.parameters = at(point);
  // A later region leaves 1 - weight to all that lies below it.
  std::vector<double> shares = {1.0};
  for (const CompiledRegion& region : m_regions) {
    const double weight = weightAt(region.ellipsoid, region.falloff, point);
    for (double& share : shares) share *= 1.0 - weight;
    shares.push_back(weight);
  }
  for (std::size_t i = 0; i < shares.size(); ++i) {
    if (!(shares[i] > 0.0)) continue;
    explanation.shares.push_back({i == 0 ? -1 : m_regions[i - 1].index, shares[i]});
    explanation.inferences.push_back(i == 0 ? m_baseInference : m_regionInferences[i - 1]);
  }
  return explanation;
}

bool TissueField::allOutputsFromRules() const noexcept
{
  const auto complete = [this](const fuzzy::Inference& inference) {
    for (std::size_t k = 0; k < m_model.rules.outputs.size(); ++k) {
      const std::string& id = m_model.rules.outputs[k].id;
      const bool ours = std::find(std::begin(kOutputIds), std::end(kOutputIds), id) != std::end(kOutputIds);
      if (ours && !inference.outputs[k].fromRules) return false;
    }
    return true;
  };
  return complete(m_baseInference) &&
         std::all_of(m_regionInferences.begin(), m_regionInferences.end(), complete);
}

} // namespace esm
