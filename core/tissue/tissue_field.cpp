// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/tissue/tissue_model.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

/// Stands for zero in logarithms: far below any tissue, and exp gives it back as zero.
constexpr double kZeroLog = -900.0;
/// Of rule bases that do not speak of them.
constexpr double kUsualRuptureStrain = 0.5, kUsualVolumeRatio = 10.0;

bool isPositive(double x)
{
  return std::isfinite(x) && x > 0.0;
}

double safeLog(double x)
{
  return x > 0.0 ? std::log(x) : kZeroLog;
}

int placeOf(const fuzzy::RuleBase& rules, const char* id)
{
  for (std::size_t k = 0; k < rules.outputs.size(); ++k)
    if (rules.outputs[k].id == id) return static_cast<int>(k);
  return -1;
}

Status checkInputs(const TissueModel& model, const std::vector<fuzzy::InputValue>& inputs,
                   const std::string& where)
{
  const auto& variables = model.rules.inputs;
  if (inputs.size() != variables.size())
    return invalidValue(where + " has " + std::to_string(inputs.size()) + " inputs, the rule base asks for " +
                        std::to_string(variables.size()));
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const std::string input = where + ": input '" + variables[i].id + "'";
    if (const double* value = std::get_if<double>(&inputs[i])) {
      if (!std::isfinite(*value)) return invalidValue(input + " is not a finite number");
      continue;
    }
    const std::string& word = std::get<fuzzy::Word>(inputs[i]).term;
    const auto& terms = variables[i].terms;
    if (std::none_of(terms.begin(), terms.end(), [&](const fuzzy::Term& term) { return term.id == word; }))
      return invalidValue(input + ": term '" + word + "' is unknown");
  }
  return {};
}

Status checkRegion(const TissueModel& model, const Region& region, const std::string& where)
{
  const Ellipsoid& e = region.ellipsoid;
  if (!e.centre.allFinite()) return invalidValue(where + ": the centre is not finite");
  if (!isPositive(e.semiAxes[0]) || !isPositive(e.semiAxes[1]) || !isPositive(e.semiAxes[2]))
    return invalidValue(where + ": every semi-axis must be above 0 m");
  if (!(std::abs(e.rotation.norm() - 1.0) < 1e-6))
    return invalidValue(where + ": the rotation is not a unit quaternion");
  if (!(region.falloff >= 0.0 && region.falloff <= 1.0))
    return invalidValue(where + ": the falloff must lie in 0 to 1");
  if (region.mirror && !(region.mirror->point.allFinite() && region.mirror->normal.allFinite() &&
                         isPositive(region.mirror->normal.squaredNorm())))
    return invalidValue(where + ": the mirror needs a finite point and a normal above 0");
  return checkInputs(model, region.inputs, where);
}

Status checkModel(const TissueModel& model)
{
  for (const TissueOutput& known : kTissueOutputs) {
    const fuzzy::Variable* output = model.rules.findOutput(known.id);
    if (!output && known.required)
      return invalidValue(std::string("the rule base has no output '") + known.id + "'");
    if (output && output->minimum < 0.0)
      return invalidValue(std::string("the range of output '") + known.id + "' must not go below 0");
    if (output && known.value == &TissueParameters::density && !(output->minimum > 0.0))
      return invalidValue("the range of output 'density' must lie above 0 kg/m^3");
  }
  if (!isPositive(model.thickness)) return invalidValue("the wall's thickness must be above 0 m");
  if (!isPositive(model.density)) return invalidValue("the density must be above 0 kg/m^3");
  if (model.law == SpringLaw::Table) return invalidValue("tissue offers no force table, choose another law");
  if (!std::isfinite(model.lawParameter) || model.lawParameter < 0.0)
    return invalidValue("the parameter of the force law must be finite and not below 0");
  return checkInputs(model, model.inputs, "the base tissue");
}

} // namespace

bool comesFromRules(const fuzzy::RuleBase& rules, double TissueParameters::*value) noexcept
{
  return std::any_of(kTissueOutputs.begin(), kTissueOutputs.end(), [&](const TissueOutput& output) {
    return output.value == value && rules.findOutput(output.id);
  });
}

Result<TissueField> TissueField::create(const TissueModel& model)
{
  auto engine = fuzzy::Engine::create(model.rules);
  if (!engine) return engine.error();
  if (Status status = checkModel(model); !status) return status.error();

  TissueField field;
  field.m_model = model;
  field.m_engine = std::move(engine).value();
  field.m_constant.density = model.density;
  field.m_constant.stiffening = model.lawParameter;
  field.m_constant.ruptureStrain = kUsualRuptureStrain;
  field.m_constant.volumeRatio = kUsualVolumeRatio;
  for (std::size_t i = 0; i < kTissueOutputs.size(); ++i)
    field.m_output[i] = placeOf(model.rules, kTissueOutputs[i].id);
  field.m_baseInference = field.m_engine->evaluate(model.inputs);
  field.m_baseLogs = field.logsOf(field.m_baseInference);
  field.m_base = field.fromLogs(field.m_baseLogs, kAllParameters);
  for (std::size_t i = 0; i < model.regions.size(); ++i) {
    const Region& region = model.regions[i];
    const std::string where = "region " + std::to_string(i + 1) + " '" + region.name + "'";
    if (Status status = checkRegion(model, region, where); !status) return status.error();
    if (!region.enabled) continue;
    field.m_regionInferences.push_back(field.m_engine->evaluate(region.inputs));
    const LogParameters logs = field.logsOf(field.m_regionInferences.back());
    field.m_regions.push_back(
      {RegionShape(region), logs, field.fromLogs(logs, kAllParameters), static_cast<int>(i)});
  }
  return field;
}

LogParameters TissueField::logsOf(const fuzzy::Inference& inference) const
{
  LogParameters logs = LogParameters::Zero();
  for (std::size_t i = 0; i < m_output.size(); ++i)
    if (m_output[i] >= 0)
      logs[static_cast<int>(i)] = safeLog(inference.outputs[static_cast<std::size_t>(m_output[i])].value);
  return logs;
}

TissueParameters TissueField::fromLogs(const LogParameters& logs, unsigned wanted) const noexcept
{
  TissueParameters parameters = m_constant;
  for (std::size_t i = 0; i < m_output.size(); ++i) {
    const double log = logs[static_cast<int>(i)];
    if (m_output[i] >= 0 && (wanted >> i & 1U))
      parameters.*kTissueOutputs[i].value = log <= kZeroLog ? 0.0 : std::exp(log);
  }
  return parameters;
}

TissueParameters TissueField::plain(const TissueBlend& blend, unsigned wanted) const noexcept
{
  if (blend.pure == TissueBlend::kMixed) return fromLogs(blend.logs, wanted);
  return blend.pure < 0 ? m_base : m_regions[static_cast<std::size_t>(blend.pure)].own;
}

TissueParameters TissueField::at(const Eigen::Vector3d& point) const noexcept
{
  TissueBlend blend = baseBlend();
  for (std::size_t i = 0; i < m_regions.size(); ++i)
    blend.cover(static_cast<int>(i), m_regions[i].shape.weight(point), m_regions[i].logs);
  return plain(blend);
}

std::vector<TissueLayer> TissueField::layersAt(const Eigen::Vector3d& point) const
{
  std::vector<TissueLayer> layers = {{-1, 1.0, 1.0, m_baseLogs, m_baseInference}};
  for (std::size_t i = 0; i < m_regions.size(); ++i) {
    const double weight = m_regions[i].shape.weight(point);
    if (weight == 0.0) continue;
    if (weight == 1.0) layers.clear(); // all below is hidden
    for (TissueLayer& layer : layers) layer.share *= 1.0 - weight;
    layers.push_back({m_regions[i].index, weight, weight, m_regions[i].logs, m_regionInferences[i]});
  }
  return layers;
}

TissueLayer TissueField::layerOf(int region) const
{
  if (region < 0) return {-1, 1.0, 1.0, m_baseLogs, m_baseInference};
  fuzzy::Inference inference = m_engine->evaluate(m_model.regions[static_cast<std::size_t>(region)].inputs);
  const LogParameters logs = logsOf(inference);
  return {region, 1.0, 1.0, logs, std::move(inference)};
}

TissueParameters TissueField::blended(const std::vector<TissueLayer>& layers) const noexcept
{
  TissueBlend blend = {layers.front().logs, TissueBlend::kMixed};
  for (std::size_t i = 1; i < layers.size(); ++i)
    blend.cover(TissueBlend::kMixed, layers[i].weight, layers[i].logs);
  return plain(blend);
}

bool TissueField::allOutputsFromRules() const noexcept
{
  const auto complete = [this](const fuzzy::Inference& inference) {
    return std::all_of(m_output.begin(), m_output.end(), [&](int k) {
      return k < 0 || inference.outputs[static_cast<std::size_t>(k)].fromRules;
    });
  };
  return complete(m_baseInference) &&
         std::all_of(m_regionInferences.begin(), m_regionInferences.end(), complete);
}

} // namespace esm
