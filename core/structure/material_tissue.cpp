// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/text_number.h"
#include "core/structure/material.h"
#include "core/tissue/explain.h"

#include <cmath>
#include <limits>

namespace esm {

namespace {

/// A parameter of the base tissue that is to have a certain value.
struct Wish {
  double TissueParameters::*value;
  double wanted;
  const char *id, *what, *unit;
};

/// How far the parameters other than the wished one are from what they were, in logarithms.
double sideEffect(const TissueParameters& now, const TissueParameters& before, double TissueParameters::*wish)
{
  double sum = 0.0;
  for (const TissueOutput& output : kTissueOutputs)
    if (output.value != wish && before.*output.value > 0.0 && now.*output.value > 0.0)
      sum += std::abs(std::log(now.*output.value / before.*output.value));
  return sum;
}

/// Sets that input of the base tissue which fulfils the wish and changes least besides.
Status fulfil(const Wish& wish, TissueModel& tissue)
{
  const Result<TissueField> field = TissueField::create(tissue);
  if (!field) return field.error();
  const double factor = wish.wanted / (field->base().*wish.value);
  if (factor == 1.0) return {};
  const TissueExplanation why = explainTissue(*field, -1);
  const ExplainedValue* value = why.find(wish.id);
  TissueModel best;
  double least = std::numeric_limits<double>::infinity(), nearest = field->base().*wish.value;
  for (const InputChange& change : changesFor(*field, why, *value, factor)) {
    TissueModel tried = tissue;
    tried.inputs[static_cast<std::size_t>(change.input)] = change.to;
    const Result<TissueField> now = TissueField::create(tried);
    if (!now) return now.error();
    const double reached = now->base().*wish.value;
    if (std::abs(std::log(reached / wish.wanted)) < std::abs(std::log(nearest / wish.wanted)))
      nearest = reached;
    const double effect = sideEffect(now->base(), field->base(), wish.value);
    if (!change.reached || effect >= least) continue;
    least = effect;
    best = std::move(tried);
  }
  if (std::isinf(least))
    return Error{ErrorCode::InvalidValue, "no single input of the rules makes the " + std::string(wish.what) +
                                            " " + formatDouble(wish.wanted) + " " + wish.unit +
                                            "; the nearest that one reaches is " + formatDouble(nearest, 4) +
                                            " " + wish.unit};
  tissue = std::move(best);
  return {};
}

} // namespace

Result<TissueModel> tissueOf(const MaterialOptions& options, TissueModel tissue)
{
  for (const double number : {options.thickness, options.density, options.youngsModulus})
    if (!(std::isfinite(number) && number >= 0.0))
      return Error{ErrorCode::InvalidValue,
                   "thickness, density and Young's modulus of the material must not be below 0"};
  if (options.thickness > 0.0) tissue.thickness = options.thickness;
  if (options.density > 0.0 && !comesFromRules(tissue.rules, &TissueParameters::density)) {
    tissue.density = options.density;
  } else if (options.density > 0.0) {
    const Wish density{&TissueParameters::density, options.density, "density", "density", "kg/m^3"};
    if (Status status = fulfil(density, tissue); !status) return status.error();
  }
  if (options.youngsModulus > 0.0) {
    const Wish modulus{&TissueParameters::youngsModulus, options.youngsModulus, "youngs_modulus",
                       "Young's modulus", "Pa"};
    if (Status status = fulfil(modulus, tissue); !status) return status.error();
  }
  return tissue;
}

} // namespace esm
