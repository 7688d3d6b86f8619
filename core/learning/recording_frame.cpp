// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/learning/recording_frame.h"

#include "core/base/text_number.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace esm::learning {
namespace {

constexpr Eigen::Index kFewest = 4;  ///< pairs that tell a frame
constexpr double kMuchSmaller = 0.1; ///< of a sum of squares
constexpr double kExchanged = 0.35;  ///< of a distance
constexpr std::size_t kNeighbours = 6;

Eigen::Matrix3Xd centred(const Eigen::Matrix3Xd& places)
{
  return places.colwise() - places.rowwise().mean();
}

std::string times(double scale)
{
  return formatDouble(scale, 3);
}

Status checkUnit(double scale)
{
  if (scale > 300.0 && scale < 3000.0)
    return invalidValue("the places span " + times(scale) +
                        " times as much as the net: they are in mm; give --length-unit mm");
  if (scale > 30.0 && scale <= 300.0)
    return invalidValue("the places span " + times(scale) +
                        " times as much as the net: they are in cm; give --length-unit cm");
  if (scale >= 3000.0 || (scale < 0.02 && scale > 0.0))
    return invalidValue("the places span " + times(scale) +
                        " times as much as the net: they are in another unit of length");
  return {};
}

/// Axis i of the file is sign[i] times axis from[i] of the net.
struct Axes {
  int from[3] = {0, 1, 2};
  double sign[3] = {1.0, 1.0, 1.0};

  Eigen::Matrix3d matrix() const
  {
    Eigen::Matrix3d q = Eigen::Matrix3d::Zero();
    for (int i = 0; i < 3; ++i) q(i, from[i]) = sign[i];
    return q;
  }
  bool isSame() const { return matrix().isIdentity(0.0); }
  std::string text() const
  {
    constexpr const char* kNames[] = {"x", "y", "z"};
    std::string all;
    for (int i = 0; i < 3; ++i)
      if (from[i] != i || sign[i] < 0.0)
        all += (all.empty() ? "" : ", ") + std::string("its ") + kNames[i] + " is " +
               (sign[i] < 0.0 ? "-" : "") + kNames[from[i]];
    return all;
  }
};

/// The frame of the file by which seen places fit much better than as they are.
std::optional<Axes> otherAxes(const Eigen::Matrix3Xd& seen, const Eigen::Matrix3Xd& rest)
{
  const double asIs = (seen - rest).squaredNorm();
  std::optional<Axes> best;
  double least = kMuchSmaller * asIs;
  int order[3] = {0, 1, 2};
  do {
    for (int signs = 0; signs < 8; ++signs) {
      Axes axes;
      for (int i = 0; i < 3; ++i) {
        axes.from[i] = order[i];
        axes.sign[i] = (signs >> i & 1) != 0 ? -1.0 : 1.0;
      }
      if (axes.isSame()) continue;
      const double square = (seen - axes.matrix() * rest).squaredNorm();
      if (square >= least) continue;
      least = square;
      best = axes;
    }
  } while (std::next_permutation(order, order + 3));
  return best;
}

/// Where each place should have gone by what its neighbours did: middle ways, axis by axis.
Eigen::Matrix3Xd foretold(const Eigen::Matrix3Xd& seen, const Eigen::Matrix3Xd& rest)
{
  const Eigen::Index count = rest.cols();
  Eigen::Matrix3Xd places = rest;
  std::vector<std::pair<double, Eigen::Index>> others;
  std::vector<double> ways;
  for (Eigen::Index m = 0; m < count; ++m) {
    others.clear();
    for (Eigen::Index n = 0; n < count; ++n)
      if (n != m) others.emplace_back((rest.col(n) - rest.col(m)).squaredNorm(), n);
    const auto near = others.begin() + static_cast<std::ptrdiff_t>(std::min(kNeighbours, others.size()));
    std::partial_sort(others.begin(), near, others.end());
    for (int axis = 0; axis < 3; ++axis) {
      ways.clear();
      for (auto other = others.begin(); other != near; ++other)
        ways.push_back(seen(axis, other->second) - rest(axis, other->second));
      const auto middle = ways.begin() + static_cast<std::ptrdiff_t>(ways.size() / 2);
      std::nth_element(ways.begin(), middle, ways.end());
      places(axis, m) += *middle;
    }
  }
  return places;
}

/// Two places that fit much better if they exchange names: nothing in tissue changes places with its neighbour.
Status checkNames(const std::vector<std::string>& names, const Eigen::Matrix3Xd& seen,
                  const Eigen::Matrix3Xd& rest)
{
  const Eigen::Matrix3Xd expected = foretold(seen, rest);
  for (Eigen::Index m = 0; m < rest.cols(); ++m) {
    const double off = (seen.col(m) - expected.col(m)).norm();
    for (Eigen::Index n = m + 1; n < rest.cols(); ++n) {
      const double both = off + (seen.col(n) - expected.col(n)).norm();
      const double exchanged =
        (seen.col(m) - expected.col(n)).norm() + (seen.col(n) - expected.col(m)).norm();
      if (exchanged < kExchanged * both && (rest.col(m) - rest.col(n)).norm() > 0.5 * both / 2.0)
        return invalidValue(names[static_cast<std::size_t>(m)] + " and " +
                            names[static_cast<std::size_t>(n)] +
                            " seem to have exchanged their ids: each lies where the other one should be");
    }
  }
  return {};
}

} // namespace

Status checkFrame(const std::vector<std::string>& names, const Eigen::Matrix3Xd& seen,
                  const Eigen::Matrix3Xd& rest)
{
  if (rest.cols() < kFewest) return {};
  const Eigen::Matrix3Xd around = centred(seen), restAround = centred(rest);
  const double extent = restAround.norm();
  if (!(extent > 0.0)) return {};
  if (const Status status = checkUnit(around.norm() / extent); !status) return status.error();
  if (const auto axes = otherAxes(around, restAround))
    return invalidValue("the axes of the file are not those of the net: " + axes->text() +
                        "; turn or mirror the places and the forces before");
  const double way = (seen.rowwise().mean() - rest.rowwise().mean()).norm();
  const double size = extent / std::sqrt(static_cast<double>(rest.cols()));
  if (way > 3.0 * size)
    return invalidValue("the places lie " + formatDouble(way, 3) +
                        " m off the net, which is more than its size: the file has "
                        "another origin");
  return checkNames(names, seen, rest);
}

} // namespace esm::learning
