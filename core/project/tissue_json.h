// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/project/json_view.h"
#include "core/tissue/tissue_model.h"

namespace esm::json {

/// The blocks "rule_base", "inputs" and "regions" of a project. Rules stay as they are in memory, over ids:
/// the text that people read and write is made from them (core/fuzzy/rule_text.h), so there is one truth.
Json ruleBaseOf(const fuzzy::RuleBase& rules);
/// Shapes and words only; checkRuleBase() has still to look at the result.
fuzzy::RuleBase readRuleBase(const View& object);

/// One entry per rule base input, keyed by its id: a number, or a word with hedges.
Json inputsOf(const std::vector<fuzzy::InputValue>& inputs, const fuzzy::RuleBase& rules);
std::vector<fuzzy::InputValue> readInputs(const View& object, const fuzzy::RuleBase& rules);

Json regionsOf(const TissueModel& tissue);
std::vector<Region> readRegions(const View& list, const fuzzy::RuleBase& rules);

/// The optional key "learned" of the block "tissue".
Json learnedOf(const LearnedLayer& layer);
LearnedLayer readLearned(const View& object);

/// {"centre", "semi_axes", "rotation"}, of a region among other keys or alone.
Json ellipsoidOf(const Ellipsoid& ellipsoid);
Ellipsoid readEllipsoid(const View& object);

} // namespace esm::json
