// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/tissue/explain.h"

#include <string>
#include <vector>

namespace esm {

/// An explanation in words and in files. `model` is the one that the explanation was made of.

/// "Spring 812 has 34.2 N/m: 80 % region Wall (rule 3: IF hardness IS hard THEN stiffness IS high, fires
/// 0.70), 20 % base tissue; area 2.10 mm², length 3.20 mm." UTF-8, one line. Percents are rounded, the
/// rule is the strongest of the largest share.
std::string sentenceOf(const TissueExplanation& why, const TissueModel& model, Language language);

std::string thingName(const TissueExplanation& why, const TissueModel& model, Language language);
std::string tissueName(int region, const TissueModel& model, Language language); ///< "region Wall"
std::string shareText(double share);                                             ///< "80 %", ">99 %"
std::string shownNumber(const ExplainedValue& value, Language language);         ///< of what holds
std::string shownNumber(const ExplainedGeometry& fact, Language language);
/// "0.62 (rather hard 0.72, firm 0.28)", or the word.
std::string inputText(const fuzzy::InputValue& value, const fuzzy::Variable& variable, Language language);
/// "hardness of region Wall: 0.62 → 0.48", or that it cannot do it and what it can at best.
std::string changeText(const InputChange& change, const TissueModel& model, Language language);

/// What was asked of changesFor(), and its answer.
struct ChangeList {
  std::string of; ///< id of the number
  double factor = 1.0;
  std::vector<InputChange> changes;
};

/// The whole chain as one line of JSON (docs/explain.schema.json). Numbers read back to the same bits; what
/// is not finite is null. Names and rules in `language`, ids do not depend on it.
/// @param changes may be null
std::string explanationJson(const TissueExplanation& why, const TissueModel& model, const ChangeList* changes,
                            Language language);

/// The same as a table after RFC 4180 (comma, CRLF, UTF-8), one fact a row. Columns:
///
///     part      thing, value, geometry, parameter, layer, output, rule, input, change
///     region    1, 2, ... of the project's regions, 0 the base tissue, empty above the layers
///     name      id of what it is; of rules their number, from 1
///     value     the number; of a layer its share, of a rule its degree, of an input its number or word
///     other     a value's number by the tissue, a rule's "without", a change's `to`
///     unit, text
std::string explanationCsv(const TissueExplanation& why, const TissueModel& model, const ChangeList* changes,
                           Language language);

} // namespace esm
