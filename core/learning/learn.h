// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/learning/fit.h"

#include <optional>

namespace esm::learning {

struct LearnSettings {
  std::vector<std::string> what = {"classes"}; ///< ids of parameterBlocks(), learned together
  SpringQuestions questions = usualQuestions();
  FitSettings fit;
};

struct LearnResult {
  LearnedLayer layer;
  std::vector<std::string> names; ///< of the last stage's parameters
  std::vector<std::string> notes; ///< what the recordings cannot tell, cases set aside
  FitReport first; ///< one factor for all springs; without rounds if that was not a stage of its own
  FitReport last;
  double trainingBefore = 1.0, trainingAfter = 1.0;
  double validationBefore = 0.0, validationAfter = 0.0;
  bool hasHelped = false;
};

/// Learns a layer for a tissue from recordings of its net. In stages, each kept only if it helps: one factor for all
/// springs, then what was asked for, beginning there. A layer that the tissue has already is replaced.
/// Errors: those of applyTissue(), Experiment::create(), of the blocks and of fit(); InvalidValue for an unknown block.
Result<LearnResult> learn(const TissueModel& tissue, const SpringNet& net,
                          const std::vector<Recording>& training, const std::vector<Recording>& validation,
                          const LearnSettings& settings);

/// The gradient of the mean square error against differences extrapolated after Richardson, for each block of
/// parameters along one direction of all of them.
struct GradientCheck {
  std::string block;
  double exact = 0.0, measured = 0.0;
  double relativeError() const noexcept;
};
/// At the start of learning, with the first recordings that have a balance there. Errors: as learn().
Result<std::vector<GradientCheck>> checkGradient(const TissueModel& tissue, const SpringNet& net,
                                                 const std::vector<Recording>& training,
                                                 const LearnSettings& settings);

} // namespace esm::learning
