// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/forces/spring_pass.h"

namespace esm {
namespace {

/// f = k e (1 + a (e/L)^2)
struct Cubic {
  static constexpr SpringLaw kLaw = SpringLaw::Cubic;
  template <class Group>
  ESM_INLINE static void tension(const Group& group, const Lanes& e, Lanes& f) noexcept
  {
    Lanes k, a;
    group.lawRow(0, k);
    group.lawRow(1, a);
    f = k * e * (1.0 + a * (e * e));
  }
  template <class Group>
  ESM_INLINE static void tangent(const Group& group, const Lanes& e, Lanes& f, Lanes& slope) noexcept
  {
    Lanes k, a;
    group.lawRow(0, k);
    group.lawRow(1, a);
    const Lanes stiffening = a * (e * e);
    f = k * e * (1.0 + stiffening);
    slope = k * (1.0 + 3.0 * stiffening);
  }
  template <class Group>
  ESM_INLINE static void energy(const Group& group, const Lanes& e, Lanes& result) noexcept
  {
    Lanes k, a;
    group.lawRow(0, k);
    group.lawRow(1, a);
    result = 0.5 * k * e * e * (1.0 + 0.5 * a * (e * e));
  }
};

ESM_CPU_CLONES double cubicPass(const SpringBatch& batch, const Lanes* x, const Lanes* v, Lanes* force,
                                Lanes* damper, const Lateness& late) noexcept
{
  return detail::springPass<Cubic>(batch, x, v, force, {damper, late});
}

ESM_CPU_CLONES double cubicEnergy(const SpringBatch& batch, const Lanes* x) noexcept
{
  return detail::energyPass<Cubic>(batch, x);
}

ESM_CPU_CLONES double cubicTensions(const SpringBatch& batch, const Lanes* x, const Lanes* v,
                                    double* tension) noexcept
{
  return detail::tensionPass<Cubic>(batch, x, v, tension);
}

ESM_CPU_CLONES void cubicTangents(const SpringBatch& batch, const Lanes* x, const Lanes* v,
                                  const TangentShares& shares, Lanes* rows) noexcept
{
  detail::tangentPass<Cubic>(batch, x, v, shares, rows);
}

class CubicLaw final : public SpringLawKernel {
public:
  double addForces(const SpringBatch& batch, const Lanes* x, const Lanes* v, Lanes* force, Lanes* damper,
                   const Lateness& late) const noexcept override
  {
    return cubicPass(batch, x, v, force, damper, late);
  }

  double energy(const SpringBatch& batch, const Lanes* x) const noexcept override
  {
    return cubicEnergy(batch, x);
  }

  double tensions(const SpringBatch& batch, const Lanes* x, const Lanes* v,
                  double* tension) const noexcept override
  {
    return cubicTensions(batch, x, v, tension);
  }

  void tangents(const SpringBatch& batch, const Lanes* x, const Lanes* v, const TangentShares& shares,
                Lanes* rows) const noexcept override
  {
    cubicTangents(batch, x, v, shares, rows);
  }

  SpringResponse respond(const SpringBatch& batch, std::size_t i, double e) const noexcept override
  {
    const double k = batch.stiffness[i];
    const double strain = e / batch.restLength[i];
    const double stiffening = batch.parameter[i] * (strain * strain);
    return {k * e * (1.0 + stiffening), k * (1.0 + 3.0 * stiffening)};
  }

  double parameterSlope(double stiffness, double restLength, double, double e) const noexcept override
  {
    const double strain = e / restLength;
    return stiffness * e * (strain * strain);
  }
};

} // namespace

const SpringLawKernel& cubicLaw() noexcept
{
  static const CubicLaw law;
  return law;
}

} // namespace esm
