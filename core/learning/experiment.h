// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/learning/parameters.h"
#include "core/learning/recording.h"

#include <optional>

namespace esm::learning {

/// One recording and the net that is to answer as it does. With u = place - place at rest of each marker, weight w,
///
///     r = w (u - u seen) / |w u seen|,      error = |r|
///
/// so that small and large loads count alike. Markers that were not seen, or on held nodes alone, are left out.
/// @note One thread at a time; experiments beside each other. Keeps where it was in balance last as the next start.
class Experiment {
public:
  /// Errors: those of Statics::check() and checkRecording().
  static Result<Experiment> create(const SpringNet& net, Recording recording);

  struct Trial {
    StaticsOutcome outcome = StaticsOutcome::Loose;
    double error = 1.0; ///< |r|; 1, that of a net that does not move, where there is no balance
    bool isBalanced() const noexcept { return outcome == StaticsOutcome::Balanced; }
  };
  /// The net's answer with other numbers. Begins at the last accepted balance, and `step` further by the
  /// sensitivities of findSlopes(), if they are known: P numbers, or empty.
  Trial respond(const SpringNet& net, std::span<const double> step = {});
  void accept();  ///< what respond() found last is where the next one begins
  void restart(); ///< the next one begins at rest

  /// After a Balanced respond(), with the same net: dr/dtheta, 3 x markers rows and P columns. P solutions.
  void findSlopes(const SpringNet& net, const ParameterSet& set);
  const Eigen::MatrixXd& slopes() const noexcept { return m_slopes; }
  /// d(error^2 / 2)/d(number), added: one solution. After a Balanced respond().
  void addGradient(const SpringNet& net, NetGradient& gradient);

  const Eigen::VectorXd& residual() const noexcept { return m_residual; } ///< 3 per marker that counts
  Index markerCount() const noexcept { return static_cast<Index>(m_markers.size()); }
  const std::string& name() const noexcept { return m_recording.name; }
  double largestSeen() const noexcept { return m_largestSeen; } ///< way of a marker [m]
  const StaticsCost& cost() const noexcept { return m_statics.cost(); }
  std::int64_t forwards() const noexcept { return m_forwards; } ///< answers looked for so far

  static constexpr double kFarthest = 4.0; ///< ways of the marker that was seen to move most
  static constexpr int kTrialSteps = 14;   ///< of Newton's method from a balance nearby
  static constexpr int kFirstSteps = 80;   ///< from rest

private:
  Experiment(const SpringNet& net, Recording recording);
  void findResidual();

  Recording m_recording;
  Statics m_statics;
  struct Seen {
    Marker marker;
    Eigen::Vector3d rest, moved; ///< [m]
    double scale;                ///< w / |w u seen| [1/m]
  };
  std::vector<Seen> m_markers;
  double m_largestSeen = 0.0;
  NodeArray m_accepted;             ///< empty: at rest
  std::vector<NodeArray> m_changes; ///< dx/dtheta at m_accepted
  Eigen::VectorXd m_residual;
  Eigen::MatrixXd m_slopes;
  std::int64_t m_forwards = 0;
};

} // namespace esm::learning
