// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/forces/spring_matrix.h"

#include "core/forces/spring_ends.h"

namespace esm {
namespace {

ESM_CPU_CLONES void addBlocks(const SpringBatch& batch, const Lanes* row, const Lanes* z, Lanes* y) noexcept
{
  const std::size_t groups = batch.paddedCount() / 4, recordRows = batch.recordRows();
  for (std::size_t i = 0; i < groups; ++i, row += kTangentRows) {
    const detail::FourEnds ends(&batch.record[i * recordRows]);
    Lanes d0, d1, d2, d3, dx, dy, dz, f0, f1, f2, f3;
    ends.difference(z, d0, d1, d2, d3);
    transpose(d0, d1, d2, d3, dx, dy, dz);
    const Lanes along = (dx * row[0] + dy * row[1] + dz * row[2]) * row[3], across = -row[4];
    detail::transposeBack(dx * across - row[0] * along, dy * across - row[1] * along,
                          dz * across - row[2] * along, f0, f1, f2, f3);
    ends.pull(y, f0, f1, f2, f3);
  }
}

ESM_CPU_CLONES void addBlocksOf(const SpringBatch& batch, const Lanes* row, Lanes* straight,
                                Lanes* mixed) noexcept
{
  const std::size_t groups = batch.paddedCount() / 4, recordRows = batch.recordRows();
  for (std::size_t i = 0; i < groups; ++i, row += kTangentRows) {
    const detail::FourEnds ends(&batch.record[i * recordRows]);
    const Lanes x = row[0] * row[3], y = row[1] * row[3], z = row[2] * row[3];
    Lanes f0, f1, f2, f3;
    detail::transposeBack(x * row[0] + row[4], y * row[1] + row[4], z * row[2] + row[4], f0, f1, f2, f3);
    ends.addToBoth(straight, f0, f1, f2, f3);
    detail::transposeBack(x * row[1], x * row[2], y * row[2], f0, f1, f2, f3);
    ends.addToBoth(mixed, f0, f1, f2, f3);
  }
}

} // namespace

void SpringMatrix::prepare(const ForceModel& forces)
{
  m_first.clear();
  std::size_t rows = 0;
  for (const SpringBatch& batch : forces.batches()) {
    m_first.push_back(rows);
    rows += batch.paddedCount() / 4 * kRows;
  }
  m_rows.assign(rows, Lanes{0, 0, 0, 0});
}

void SpringMatrix::assignTangents(const ForceModel& forces, const Lanes* x, const Lanes* v,
                                  const TangentShares& shares, WorkerPool* workers) noexcept
{
  forces.forEachBatch(workers, [&](std::size_t b) noexcept {
    const SpringBatch& batch = forces.batches()[b];
    springLawKernel(batch.law).tangents(batch, x, v, shares, m_rows.data() + m_first[b]);
  });
}

void SpringMatrix::addDiagonal(const ForceModel& forces, Lanes* straight, Lanes* mixed,
                               WorkerPool* workers) const noexcept
{
  forces.forEachBatch(workers, [&](std::size_t b) noexcept {
    addBlocksOf(forces.batches()[b], m_rows.data() + m_first[b], straight, mixed);
  });
}

void SpringMatrix::addProduct(const ForceModel& forces, const Lanes* z, Lanes* y,
                              WorkerPool* workers) const noexcept
{
  forces.forEachBatch(workers, [&](std::size_t b) noexcept {
    addBlocks(forces.batches()[b], m_rows.data() + m_first[b], z, y);
  });
}

} // namespace esm
