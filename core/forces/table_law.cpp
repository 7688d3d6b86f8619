// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/forces/spring_pass.h"

#include <algorithm>

namespace esm {
namespace {

/// Of more lines it is faster to look for each spring's own.
constexpr std::size_t kFewLines = 16;

const TableLines& tableOf(const SpringBatch& batch, std::size_t i) noexcept
{
  return batch.table != nullptr ? *batch.table
                                : (*batch.tables)[static_cast<std::size_t>(batch.parameter[i])];
}

/// The line that holds `strain`.
ESM_INLINE std::size_t lineAt(const TableLines& table, double strain) noexcept
{
  const auto next = std::upper_bound(table.strain.begin() + 1, table.strain.end(), strain);
  return static_cast<std::size_t>(next - table.strain.begin()) - 1;
}

ESM_INLINE double valueAt(const TableLines& table, double strain) noexcept
{
  const std::size_t line = lineAt(table, strain);
  return table.force[line] + table.slope[line] * (strain - table.strain[line]);
}

/// The same for four springs of one table: all lines are gone through, each lane keeps the last one that
/// begins below it.
ESM_INLINE void valuesAt(const TableLines& table, const Lanes& strain, Lanes& values) noexcept
{
  const Lanes zero = {0, 0, 0, 0};
  Lanes from = zero + table.strain[0], force = zero + table.force[0], slope = zero + table.slope[0];
  for (std::size_t line = 1; line < table.count(); ++line) {
    const Lanes begin = zero + table.strain[line];
    const LaneBits isBeyond = strain >= begin;
    from = isBeyond ? begin : from;
    force = isBeyond ? zero + table.force[line] : force;
    slope = isBeyond ? zero + table.slope[line] : slope;
  }
  values = force + slope * (strain - from);
}

/// Integral of the table from its first strain to `strain`.
double integralTo(const TableLines& table, double strain) noexcept
{
  const std::size_t line = lineAt(table, strain);
  const double into = strain - table.strain[line];
  return table.integral[line] + into * (table.force[line] + 0.5 * table.slope[line] * into);
}

/// f = k L g(e/L)
struct Table {
  static constexpr SpringLaw kLaw = SpringLaw::Table;
  template <class Group>
  ESM_INLINE static void tension(const Group& group, const Lanes& e, Lanes& f) noexcept
  {
    Lanes factor, perLength, values;
    group.lawRow(0, factor);
    group.lawRow(1, perLength);
    const Lanes strain = e * perLength;
    const TableLines* const table = group.batch.table;
    if (table != nullptr && table->count() <= kFewLines)
      valuesAt(*table, strain, values);
    else
      for (std::size_t lane = 0; lane < 4; ++lane)
        values[lane] = valueAt(tableOf(group.batch, group.first + lane), strain[lane]);
    f = factor * values;
  }
  template <class Group>
  ESM_INLINE static void tangent(const Group& group, const Lanes& e, Lanes& f, Lanes& slope) noexcept
  {
    Lanes factor, perLength, values;
    group.lawRow(0, factor);
    group.lawRow(1, perLength);
    const Lanes strain = e * perLength;
    for (std::size_t lane = 0; lane < 4; ++lane) {
      const TableLines& table = tableOf(group.batch, group.first + lane);
      values[lane] = valueAt(table, strain[lane]);
      slope[lane] = table.slope[lineAt(table, strain[lane])];
    }
    f = factor * values;
    slope *= factor * perLength;
  }
  template <class Group>
  ESM_INLINE static void energy(const Group& group, const Lanes& e, Lanes& result) noexcept
  {
    Lanes factor, perLength;
    group.lawRow(0, factor);
    group.lawRow(1, perLength);
    const Lanes strain = e * perLength;
    for (std::size_t lane = 0; lane < 4; ++lane) {
      const TableLines& table = tableOf(group.batch, group.first + lane);
      result[lane] = integralTo(table, strain[lane]) - integralTo(table, 0.0);
    }
    result *= factor / perLength;
  }
};

ESM_CPU_CLONES double tablePass(const SpringBatch& batch, const Lanes* x, const Lanes* v, Lanes* force,
                                Lanes* damper, const Lateness& late) noexcept
{
  return detail::springPass<Table>(batch, x, v, force, {damper, late});
}

ESM_CPU_CLONES double tableEnergy(const SpringBatch& batch, const Lanes* x) noexcept
{
  return detail::energyPass<Table>(batch, x);
}

ESM_CPU_CLONES double tableTensions(const SpringBatch& batch, const Lanes* x, const Lanes* v,
                                    double* tension) noexcept
{
  return detail::tensionPass<Table>(batch, x, v, tension);
}

ESM_CPU_CLONES void tableTangents(const SpringBatch& batch, const Lanes* x, const Lanes* v,
                                  const TangentShares& shares, Lanes* rows) noexcept
{
  detail::tangentPass<Table>(batch, x, v, shares, rows);
}

class TableLaw final : public SpringLawKernel {
public:
  double addForces(const SpringBatch& batch, const Lanes* x, const Lanes* v, Lanes* force, Lanes* damper,
                   const Lateness& late) const noexcept override
  {
    return tablePass(batch, x, v, force, damper, late);
  }

  double energy(const SpringBatch& batch, const Lanes* x) const noexcept override
  {
    return tableEnergy(batch, x);
  }

  double tensions(const SpringBatch& batch, const Lanes* x, const Lanes* v,
                  double* tension) const noexcept override
  {
    return tableTensions(batch, x, v, tension);
  }

  void tangents(const SpringBatch& batch, const Lanes* x, const Lanes* v, const TangentShares& shares,
                Lanes* rows) const noexcept override
  {
    tableTangents(batch, x, v, shares, rows);
  }

  SpringResponse respond(const SpringBatch& batch, std::size_t i, double e) const noexcept override
  {
    const TableLines& table = tableOf(batch, i);
    const double k = batch.stiffness[i], rest = batch.restLength[i], strain = e / rest;
    return {k * rest * valueAt(table, strain), k * table.slope[lineAt(table, strain)]};
  }

  double parameterSlope(double, double, double, double) const noexcept override { return 0.0; }
};

} // namespace

const SpringLawKernel& tableLaw() noexcept
{
  static const TableLaw law;
  return law;
}

} // namespace esm
