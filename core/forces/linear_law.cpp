// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/forces/spring_pass.h"

namespace esm {
namespace {

/// f = k e
struct Linear {
  static constexpr SpringLaw kLaw = SpringLaw::Linear;
  template <class Group>
  ESM_INLINE static void tension(const Group& group, const Lanes& e, Lanes& f) noexcept
  {
    Lanes k;
    group.lawRow(0, k);
    f = k * e;
  }
  template <class Group>
  ESM_INLINE static void tangent(const Group& group, const Lanes& e, Lanes& f, Lanes& slope) noexcept
  {
    group.lawRow(0, slope);
    f = slope * e;
  }
  template <class Group>
  ESM_INLINE static void energy(const Group& group, const Lanes& e, Lanes& result) noexcept
  {
    Lanes k;
    group.lawRow(0, k);
    result = 0.5 * k * e * e;
  }
};

ESM_CPU_CLONES double linearPass(const SpringBatch& batch, const Lanes* x, const Lanes* v, Lanes* force,
                                 Lanes* damper, const Lateness& late) noexcept
{
  return detail::springPass<Linear>(batch, x, v, force, {damper, late});
}

ESM_CPU_CLONES double linearEnergy(const SpringBatch& batch, const Lanes* x) noexcept
{
  return detail::energyPass<Linear>(batch, x);
}

ESM_CPU_CLONES double linearTensions(const SpringBatch& batch, const Lanes* x, const Lanes* v,
                                     double* tension) noexcept
{
  return detail::tensionPass<Linear>(batch, x, v, tension);
}

ESM_CPU_CLONES void linearTangents(const SpringBatch& batch, const Lanes* x, const Lanes* v,
                                   const TangentShares& shares, Lanes* rows) noexcept
{
  detail::tangentPass<Linear>(batch, x, v, shares, rows);
}

class LinearLaw final : public SpringLawKernel {
public:
  double addForces(const SpringBatch& batch, const Lanes* x, const Lanes* v, Lanes* force, Lanes* damper,
                   const Lateness& late) const noexcept override
  {
    return linearPass(batch, x, v, force, damper, late);
  }

  double energy(const SpringBatch& batch, const Lanes* x) const noexcept override
  {
    return linearEnergy(batch, x);
  }

  double tensions(const SpringBatch& batch, const Lanes* x, const Lanes* v,
                  double* tension) const noexcept override
  {
    return linearTensions(batch, x, v, tension);
  }

  void tangents(const SpringBatch& batch, const Lanes* x, const Lanes* v, const TangentShares& shares,
                Lanes* rows) const noexcept override
  {
    linearTangents(batch, x, v, shares, rows);
  }

  SpringResponse respond(const SpringBatch& batch, std::size_t i, double e) const noexcept override
  {
    const double k = batch.stiffness[i];
    return {k * e, k};
  }

  double parameterSlope(double, double, double, double) const noexcept override { return 0.0; }
};

} // namespace

const SpringLawKernel& linearLaw() noexcept
{
  static const LinearLaw law;
  return law;
}

} // namespace esm
