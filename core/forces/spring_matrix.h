// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/forces/force_model.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace esm {

/// The springs' part of a symmetric matrix A over nodes, one block B per active spring from a to b,
///
///     (A z)_a = - B (z_b - z_a),   (A z)_b = B (z_b - z_a),   B = axial u u^T + lateral (1 - u u^T),
///
/// packed four springs at a time, for many products: one costs less than a force pass. The same bits on every
/// processor.
class SpringMatrix {
public:
  struct Block {
    Eigen::Vector3d direction; ///< u [1]
    double axial, lateral;     ///< in whatever unit the matrix has
  };

  /// Sizes the arrays, unless the springs are those of before. May allocate.
  void prepare(const ForceModel& forces);
  /// @pre prepare() for these forces, as for what follows.
  /// @param blockOf   blockOf(i): Block of the i-th active spring.
  template <class BlockOf>
  void assign(const ForceModel& forces, const BlockOf& blockOf)
  {
    std::size_t spring = 0;
    Lanes* row = m_rows.data(); // what only fills up stays 0
    for (const SpringBatch& batch : forces.batches())
      for (std::size_t i = 0; i < batch.paddedCount(); i += 4, row += kRows)
        for (int lane = 0; lane < 4 && i + static_cast<std::size_t>(lane) < batch.count; ++lane) {
          const Block block = blockOf(spring++);
          for (int k = 0; k < 3; ++k) row[k][lane] = block.direction[k];
          row[3][lane] = block.axial - block.lateral;
          row[4][lane] = block.lateral;
        }
  }
  /// The convex part of the springs' tangents at x, v; see SpringLawKernel::tangents().
  /// @param workers  null: this thread alone; the bits are the same.
  void assignTangents(const ForceModel& forces, const Lanes* x, const Lanes* v, const TangentShares& shares,
                      WorkerPool* workers = nullptr) noexcept;
  /// Adds the blocks that A has on its diagonal, an entry per node: xx, yy, zz and xy, xz, yz.
  void addDiagonal(const ForceModel& forces, Lanes* straight, Lanes* mixed,
                   WorkerPool* workers = nullptr) const noexcept;
  /// y += A z, over all nodes.
  void addProduct(const ForceModel& forces, const Lanes* z, Lanes* y,
                  WorkerPool* workers = nullptr) const noexcept;

private:
  static constexpr std::size_t kRows = kTangentRows;

  NodeArray m_rows;                 ///< of each four springs, batch by batch
  std::vector<std::size_t> m_first; ///< row of each batch
};

} // namespace esm
