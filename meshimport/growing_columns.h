// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/large_pages.h"

#include <Eigen/Core>

#include <algorithm>
#include <utility>

namespace esm {

/// An Eigen matrix of fixed height that gets one column after the other and is then given away without a
/// copy.
template <class Matrix>
class GrowingColumns {
public:
  using Scalar = typename Matrix::Scalar;

  Eigen::Index count() const noexcept { return m_count; }
  Eigen::Index capacity() const noexcept { return m_columns.cols(); }
  const Scalar* data() const noexcept { return m_columns.data(); }

  /// Room for `count` columns; costs memory only as far as they come.
  void reserve(Eigen::Index count)
  {
    if (count <= capacity()) return;
    m_columns.conservativeResize(Eigen::NoChange, count);
    useLargePages(m_columns);
  }
  /// The place of a new column, to be written by the caller.
  Scalar* add()
  {
    if (m_count == capacity()) reserve(std::max<Eigen::Index>(64, 2 * m_count));
    return m_columns.data() + Matrix::RowsAtCompileTime * m_count++;
  }
  /// All columns; none are left here.
  Matrix take()
  {
    m_columns.conservativeResize(Eigen::NoChange, std::exchange(m_count, 0));
    return std::exchange(m_columns, Matrix());
  }

private:
  Matrix m_columns; ///< the first `m_count` are in use
  Eigen::Index m_count = 0;
};

} // namespace esm
