// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/work_control.h"
#include "core/base/worker_pool.h"
#include "core/learning/experiment.h"

#include <functional>
#include <string>
#include <vector>

namespace esm::learning {

/// One accepted step of a fit. Errors are roots of the mean square over the cases [1].
struct FitRound {
  int round = 0;              ///< 0: before the first step
  double training = 0.0;      ///< error
  double validation = 0.0;    ///< error; 0 without such cases
  int rejected = 0;           ///< trial steps before it
  double largestChange = 0.0; ///< of a theta
};

struct FitSettings {
  int mostRounds = 40;
  double leastGain = 1e-4;        ///< relative, of the cost; two rounds with less end the fit
  int patience = 4;               ///< rounds that may not help the validation cases before the fit ends
  bool robust = true;             ///< markers far off the others count less, see fit()
  WorkerPool* workers = nullptr;  ///< share the cases; the result has the same bits. Not owned
  WorkControl* control = nullptr; ///< cancelled: the fit ends with the best so far. Not owned
  std::function<void(const FitRound&)> onRound = {};
};

struct FitCase {
  std::string name;
  bool validates = false;
  bool isUsed = true;               ///< false: no balance at the start, so that it was set aside
  double before = 1.0, after = 1.0; ///< errors; 1 where there is no balance
};

/// Parameters that the recordings cannot tell apart: along this direction of them the nets' answers hardly change.
struct Ambiguity {
  std::vector<Index> parameters; ///< that take part, the first most; one alone: it is not seen
  double change = 0.0;           ///< of the answers, relative, for one prior deviation along the direction
};

struct FitReport {
  std::vector<double> theta;
  std::vector<double> deviations;   ///< posterior, of each theta [1]
  std::vector<std::uint8_t> isSeen; ///< posterior deviation below 0.9 of the prior's
  std::vector<FitRound> rounds;
  std::vector<FitCase> cases;         ///< training, then validation
  std::vector<Ambiguity> ambiguities; ///< before the start
  double trainingBefore = 1.0, trainingAfter = 1.0;
  double validationBefore = 0.0, validationAfter = 0.0;
  std::int64_t forwards = 0; ///< answers of one case
  StaticsCost cost;
  bool hasHelped =
    false;         ///< the error that decides is lower than before: of validation cases, if there are some
  std::string end; ///< why the fit ended
};

/// Least squares by Levenberg and Marquardt with full sensitivities,
///
///     cost = sum over cases |r|^2 + s^2 sum ((theta - centre) / deviation)^2,
///     (A + l diag A) step = - gradient,   A = J^T J + s^2 / deviation^2
///
/// s^2 is the mean square error of a case over the independent numbers that it tells (30 at most: errors of a model go
/// together over the markers). So the prior counts as much as the recordings leave open, and fades as the fit gets exact.
/// A trial step in which a case snaps, or which does not lower the cost, is taken back and tried shorter.
///
/// Cases that have no balance at the start are tried with stiffer springs (x 2, 4, 8), then set aside and reported.
/// Validation cases are judged after every step and never learned from; the best theta for them is the result.
/// Where markers lie further off than 3 deviations of what the middle one of them errs (Huber), the fit goes on with
/// their residuals counted linearly; the validation cases decide whether that is kept.
///
/// Sums run over the cases in their order: the same bits on any number of threads.
/// @note One thread, besides the workers. Errors: EmptyResult (no case, none with a balance), InvalidValue (more than
/// kMostParameters).
Result<FitReport> fit(const SpringNet& net, const ParameterSet& set, std::span<Experiment> training,
                      std::span<Experiment> validation, const FitSettings& settings);
inline constexpr Index kMostParameters = 3000;

/// Directions of the parameters along which answers change by less than a hundredth for one prior deviation.
/// @param normal sum over the cases of J^T J.
std::vector<Ambiguity> ambiguitiesOf(const Eigen::MatrixXd& normal, const ParameterSet& set,
                                     std::size_t cases);
/// "these recordings cannot tell A from B ..."
std::string textOf(const Ambiguity& ambiguity, const ParameterSet& set);

} // namespace esm::learning
