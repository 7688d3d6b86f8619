// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/four_at_a_time.h"

#include "core/base/lanes.h"
#include "core/geometry/distance.h"
#include "core/geometry/triangle_shape.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace esm {

namespace {

/// Places to[0], to[stride], ... less places from[0], from[stride], ... Each is read with the number behind
/// it.
ESM_INLINE void fourDifferences(const double* position, const Index* from, const Index* to,
                                std::ptrdiff_t stride, Lanes& x, Lanes& y, Lanes& z) noexcept
{
  Lanes between[4];
  for (std::ptrdiff_t k = 0; k < 4; ++k) {
    Lanes begin, end;
    loadLanes(position + 3 * std::ptrdiff_t{from[stride * k]}, begin);
    loadLanes(position + 3 * std::ptrdiff_t{to[stride * k]}, end);
    between[k] = end - begin;
  }
  transpose(between[0], between[1], between[2], between[3], x, y, z);
}

/// Behind the last place there is no number.
bool isBefore(const Index* vertices, std::ptrdiff_t count, Index last) noexcept
{
  Index greatest = 0;
  for (std::ptrdiff_t i = 0; i < count; ++i) greatest = std::max(greatest, vertices[i]);
  return greatest < last;
}

/// The largest of three magnitudes.
ESM_INLINE void largestOf(const Lanes& x, const Lanes& y, const Lanes& z, Lanes& largest) noexcept
{
  const Lanes ax = x < 0.0 ? -x : x, ay = y < 0.0 ? -y : y, az = z < 0.0 ? -z : z;
  largest = ax > ay ? ax : ay;
  largest = largest > az ? largest : az;
}

ESM_INLINE bool isAny(const LaneBits& bits) noexcept
{
  return (bits[0] | bits[1] | bits[2] | bits[3]) != 0;
}

ESM_CPU_CLONES bool measureFours(const double* position, const Index* end, std::ptrdiff_t count,
                                 double* length) noexcept
{
  LaneBits unusual = {0, 0, 0, 0};
  for (std::ptrdiff_t e = 0; e < count; e += 4) {
    Lanes x, y, z;
    fourDifferences(position, end + 2 * e, end + 2 * e + 1, 2, x, y, z);
    Lanes square = x * x + y * y + z * z; // summed as Eigen does
    unusual |= ~((square > kLeastUsualSquare) & (square < kMostUsualSquare));
    squareRoot(square);
    __builtin_memcpy(length + e, &square, sizeof square);
  }
  return !isAny(unusual);
}

/// @return how many are degenerate; -1 where numbers are not finite, and nothing is known
ESM_CPU_CLONES std::int64_t countFours(const double* position, const Index* corner,
                                       std::ptrdiff_t count) noexcept
{
  LaneBits degenerate = {0, 0, 0, 0}, unknown = {0, 0, 0, 0};
  for (std::ptrdiff_t t = 0; t < count; t += 4) {
    const Index* const c = corner + 3 * t;
    Lanes ux, uy, uz, vx, vy, vz, u, v, area;
    fourDifferences(position, c, c + 1, 3, ux, uy, uz);
    fourDifferences(position, c, c + 2, 3, vx, vy, vz);
    largestOf(ux, uy, uz, u);
    largestOf(vx, vy, vz, v);
    largestOf(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx, area);
    const Lanes rounding = kDegenerateShare * (u * v);
    degenerate -= area <= rounding;
    unknown |= (area + rounding) * 0.0 != 0.0; // where NaN comes of it
  }
  return isAny(unknown) ? -1 : degenerate[0] + degenerate[1] + degenerate[2] + degenerate[3];
}

} // namespace

bool measureUsual(const Eigen::Matrix3Xd& position, const SegmentMatrix& ends, Index first, Index last,
                  Eigen::ArrayXd& length) noexcept
{
  const Index* const end = ends.data() + 2 * std::ptrdiff_t{first};
  const Index fours = isBefore(end, 2 * std::ptrdiff_t{last - first}, static_cast<Index>(position.cols()) - 1)
                        ? (last - first) / 4 * 4
                        : 0;
  bool isUsual = measureFours(position.data(), end, fours, length.data() + first);
  for (Index e = first + fours; e < last; ++e) {
    const double square = (position.col(ends(1, e)) - position.col(ends(0, e))).squaredNorm();
    isUsual &= isUsualSquare(square);
    length[e] = std::sqrt(square);
  }
  return isUsual;
}

Index countDegenerate(const Mesh& mesh, Index first, Index last) noexcept
{
  const Index* const corner = mesh.triangles.data() + 3 * std::ptrdiff_t{first};
  const Index fours =
    isBefore(corner, 3 * std::ptrdiff_t{last - first}, mesh.vertexCount() - 1) ? (last - first) / 4 * 4 : 0;
  const std::int64_t inFours = countFours(mesh.position.data(), corner, fours);
  Index count = inFours < 0 ? 0 : static_cast<Index>(inFours);
  for (Index t = inFours < 0 ? first : first + fours; t < last; ++t) count += isDegenerate(mesh, t);
  return count;
}

} // namespace esm
