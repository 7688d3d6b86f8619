// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/lanes.h"
#include "core/base/types.h"

#include <Eigen/Core>

#include <new>
#include <vector>

namespace esm {

/// Memory on cache line borders: std::allocator forgets the alignment of a vector type.
template <class T>
struct CacheLineAllocator {
  using value_type = T;
  CacheLineAllocator() = default;
  template <class U>
  CacheLineAllocator(const CacheLineAllocator<U>&) noexcept
  {}
  T* allocate(std::size_t count)
  {
    return static_cast<T*>(::operator new (count * sizeof(T), std::align_val_t{64}));
  }
  void deallocate(T* memory, std::size_t) noexcept { ::operator delete (memory, std::align_val_t{64}); }
  template <class U>
  bool operator==(const CacheLineAllocator<U>&) const noexcept
  {
    return true;
  }
};

/// One node's position, velocity or force: x, y, z and a fourth lane that stays 0. A quarter of the memory is
/// the price for one aligned load per node, which halves the time of the force pass.
using NodeArray = std::vector<Lanes, CacheLineAllocator<Lanes>>;

ESM_INLINE Lanes toLanes(const Eigen::Vector3d& value) noexcept
{
  return Lanes{value.x(), value.y(), value.z(), 0.0};
}

inline Eigen::Vector3d toVector(const Lanes& value) noexcept
{
  return {value[0], value[1], value[2]};
}

/// x y z of the lanes added; always in this order.
inline double sumLanes(const Lanes& value) noexcept
{
  return ((value[0] + value[1]) + value[2]) + value[3];
}

inline double dot(const Lanes& a, const Lanes& b) noexcept
{
  const Lanes product = a * b;
  return sumLanes(product);
}

/// @pre `to` has from.cols() entries.
inline void copyNodes(const Eigen::Matrix3Xd& from, NodeArray& to) noexcept
{
  for (Eigen::Index i = 0; i < from.cols(); ++i)
    to[static_cast<std::size_t>(i)] = Lanes{from(0, i), from(1, i), from(2, i), 0.0};
}

inline void copyNodes(const NodeArray& from, Eigen::Matrix3Xd& to) noexcept
{
  for (Eigen::Index i = 0; i < to.cols(); ++i) {
    const Lanes& value = from[static_cast<std::size_t>(i)];
    to(0, i) = value[0];
    to(1, i) = value[1];
    to(2, i) = value[2];
  }
}

} // namespace esm
