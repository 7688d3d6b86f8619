// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/learning/fit.h"

#include "core/base/text_number.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace esm::learning {
namespace {

constexpr double kVisible = 0.01;  ///< change of the answers, relative
constexpr double kTakesPart = 0.3; ///< component of a direction, over the largest
constexpr std::size_t kMostNamed = 4;

} // namespace

std::vector<Ambiguity> ambiguitiesOf(const Eigen::MatrixXd& normal, const ParameterSet& set,
                                     std::size_t cases)
{
  const Eigen::Index count = normal.rows();
  Eigen::VectorXd deviation(count);
  for (Eigen::Index j = 0; j < count; ++j)
    deviation[j] = set.parameters()[static_cast<std::size_t>(j)].deviation;
  const Eigen::MatrixXd scaled = deviation.asDiagonal() * normal * deviation.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(
    scaled); // squares of J's singular values, rising
  std::vector<Ambiguity> found;
  for (Eigen::Index i = 0; i < count; ++i) {
    const double change = std::sqrt(std::max(solver.eigenvalues()[i], 0.0) / static_cast<double>(cases));
    if (change >= kVisible) break;
    const Eigen::VectorXd direction = solver.eigenvectors().col(i).cwiseAbs();
    Ambiguity ambiguity;
    ambiguity.change = change;
    for (Eigen::Index j = 0; j < count; ++j)
      if (direction[j] >= kTakesPart * direction.maxCoeff())
        ambiguity.parameters.push_back(static_cast<Index>(j));
    std::stable_sort(ambiguity.parameters.begin(), ambiguity.parameters.end(),
                     [&](Index a, Index b) { return direction[a] > direction[b]; });
    found.push_back(std::move(ambiguity));
  }
  return found;
}

std::string textOf(const Ambiguity& ambiguity, const ParameterSet& set)
{
  const auto name = [&](std::size_t i) {
    return '"' + set.parameters()[at(ambiguity.parameters[i])].name + '"';
  };
  const std::string change = formatDouble(100.0 * ambiguity.change, 2) + " %";
  if (ambiguity.parameters.size() == 1)
    return "these recordings do not see " + name(0) + ": a usual change of it moves the markers by " +
           change + "; add a load that strains it";
  std::string text = "these recordings cannot tell " + name(0) + " from " + name(1);
  for (std::size_t i = 2; i < std::min(ambiguity.parameters.size(), kMostNamed); ++i) text += ", " + name(i);
  return text + ": changed against each other they move the markers by " + change +
         "; add a load of another kind or at another place";
}

} // namespace esm::learning
