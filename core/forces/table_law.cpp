// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/forces/spring_pass.h"

#include <algorithm>

namespace esm {
namespace {

const ForceTable& tableOf(const SpringBatch& batch, std::size_t i) noexcept
{
  return batch.tables[static_cast<std::size_t>(batch.parameter[i])];
}

/// The piece of the table that holds `strain`; the first and last piece go on without end.
std::size_t pieceAt(const ForceTable& table, double strain) noexcept
{
  const auto last = table.strain.end() - 1;
  const auto next = std::upper_bound(table.strain.begin() + 1, last, strain);
  return static_cast<std::size_t>(next - table.strain.begin()) - 1;
}

double slopeOf(const ForceTable& table, std::size_t piece) noexcept
{
  return (table.force[piece + 1] - table.force[piece]) / (table.strain[piece + 1] - table.strain[piece]);
}

double valueAt(const ForceTable& table, double strain) noexcept
{
  const std::size_t piece = pieceAt(table, strain);
  return table.force[piece] + slopeOf(table, piece) * (strain - table.strain[piece]);
}

/// Integral of the table from its first strain to `strain`.
double integralTo(const ForceTable& table, double strain) noexcept
{
  const std::size_t piece = pieceAt(table, strain);
  double sum = 0.0;
  for (std::size_t j = 0; j < piece; ++j)
    sum += 0.5 * (table.force[j] + table.force[j + 1]) * (table.strain[j + 1] - table.strain[j]);
  const double into = strain - table.strain[piece];
  return sum + into * (table.force[piece] + 0.5 * slopeOf(table, piece) * into);
}

/// f = k L g(e/L), one spring after the other: a look-up does not profit from lanes.
struct Table {
  static constexpr SpringLaw kLaw = SpringLaw::Table;
  template <class Group>
  ESM_INLINE static void tension(const Group& group, const Lanes& e, Lanes& f) noexcept
  {
    const SpringBatch& batch = group.batch;
    const std::size_t i = group.first;
    for (std::size_t lane = 0; lane < 4; ++lane) {
      const double length = batch.restLength[i + lane];
      f[lane] = batch.stiffness[i + lane] * length * valueAt(tableOf(batch, i + lane), e[lane] / length);
    }
  }
  template <class Group>
  ESM_INLINE static void energy(const Group& group, const Lanes& e, Lanes& result) noexcept
  {
    const SpringBatch& batch = group.batch;
    const std::size_t i = group.first;
    for (std::size_t lane = 0; lane < 4; ++lane) {
      const ForceTable& table = tableOf(batch, i + lane);
      const double length = batch.restLength[i + lane];
      result[lane] = batch.stiffness[i + lane] * length * length *
                     (integralTo(table, e[lane] / length) - integralTo(table, 0.0));
    }
  }
};

class TableLaw final : public SpringLawKernel {
public:
  double addForces(const SpringBatch& batch, const Lanes* x, const Lanes* v, Lanes* force,
                   Lanes* damper) const noexcept override
  {
    return detail::springPass<Table>(batch, x, v, force, damper);
  }

  double energy(const SpringBatch& batch, const Lanes* x) const noexcept override
  {
    return detail::energyPass<Table>(batch, x);
  }

  double tensions(const SpringBatch& batch, const Lanes* x, const Lanes* v,
                  double* tension) const noexcept override
  {
    return detail::tensionPass<Table>(batch, x, v, tension);
  }

  SpringResponse respond(const SpringBatch& batch, std::size_t i, double e) const noexcept override
  {
    const ForceTable& table = tableOf(batch, i);
    const double k = batch.stiffness[i], rest = batch.restLength[i], strain = e / rest;
    return {k * rest * valueAt(table, strain), k * slopeOf(table, pieceAt(table, strain))};
  }
};

} // namespace

const SpringLawKernel& tableLaw() noexcept
{
  static const TableLaw law;
  return law;
}

} // namespace esm
