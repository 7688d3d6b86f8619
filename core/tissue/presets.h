// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/tissue/tissue_model.h"

#include <vector>

namespace esm {

/// One property of a tissue as it was measured, or is believed to be.
struct Measurement {
  double typical = 0.0, low = 0.0,
         high = 0.0;       ///< SI units; for damping zeta [1]; low = high: no spread given
  fuzzy::Names method;     ///< tissue measures softer pressed than pulled: say how
  const char* source = ""; ///< author and year, or an archive number; an estimate's basis
  bool isEstimate = false; ///< true: no measurement of this tissue was found or checked; to be shown as such
};

/// A tissue to start from: what is measured of it, and the words that lead the default rules there.
struct TissuePreset {
  const char* id;
  fuzzy::Names name;
  Measurement youngsModulus, density, damping, ruptureStrain;
  fuzzy::Names remark; ///< what the numbers do not say
  struct Finding {
    const char *input, *words; ///< words in English, as parseInput() reads them
  };
  std::vector<Finding> findings; ///< shiftability is the organ's bed, not tissue, and stays with the user
};

/// Twelve tissues of the pelvis and abdomen, from soft to hard. Sources: docs/TISSUE.md.
const std::vector<TissuePreset>& tissuePresets();
const TissuePreset* findPreset(std::string_view id) noexcept; ///< null if absent

/// `inputs` with a preset's words in their places.
/// Errors: InvalidValue if the rule base lacks an input or word that the preset speaks of (an older
/// project's, or one with a vocabulary of its own): half a preset would be none.
Result<std::vector<fuzzy::InputValue>> withPreset(const TissuePreset& preset, const fuzzy::RuleBase& rules,
                                                  std::vector<fuzzy::InputValue> inputs);

} // namespace esm
