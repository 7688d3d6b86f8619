// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "tests/core/tissue/test_nets.h"

#include <cmath>
#include <random>

namespace esm::test {

/// A closed organ as modelling tools leave it: an ellipsoid with bumps, its vertices pushed along the surface by up to
/// two fifths of an edge, and one triangle in 600, three at least, with an edge drawn together to a hundredth of its
/// length.
inline Mesh irregularOrgan(const Eigen::Vector3d& semiAxes, int halvings, unsigned seed)
{
  Mesh mesh = ellipsoidMesh(semiAxes, halvings);
  std::mt19937 random(seed);
  const auto uniform = [&](double from, double to) {
    return from + (to - from) * static_cast<double>(random()) / 4294967296.0; // the same on every platform
  };
  const auto anywhere = [&](double most) {
    return Eigen::Vector3d(uniform(-most, most), uniform(-most, most), uniform(-most, most));
  };
  const auto at = [&](int corner, Eigen::Index triangle) {
    return mesh.position.col(mesh.triangles(corner, triangle));
  };
  const double edge = (at(1, 0) - at(0, 0)).norm();
  Eigen::Matrix<double, 3, 8> waves;
  Eigen::Matrix<double, 8, 1> phases;
  for (int i = 0; i < 8; ++i) {
    waves.col(i) = anywhere(80.0); // [1/m]
    phases[i] = uniform(0.0, 6.28);
  }
  for (Eigen::Index i = 0; i < mesh.position.cols(); ++i) {
    const Eigen::Vector3d place = mesh.position.col(i), out = place.normalized(), push = anywhere(0.4 * edge);
    const double bump = 0.03 * (waves.transpose() * place + phases).array().sin().sum();
    mesh.position.col(i) = (1.0 + bump) * place + push - push.dot(out) * out;
  }
  const Eigen::Index slivers = std::max<Eigen::Index>(3, mesh.triangles.cols() / 600);
  for (Eigen::Index k = 0; k < slivers; ++k) {
    const Eigen::Index t = static_cast<Eigen::Index>(random() % static_cast<unsigned>(mesh.triangles.cols()));
    const Eigen::Vector3d from = at(0, t);
    mesh.position.col(mesh.triangles(1, t)) = from + 0.01 * (at(1, t) - from);
  }
  return mesh;
}

} // namespace esm::test
