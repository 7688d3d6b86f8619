// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/project/project.h"

#include <string>
#include <vector>

namespace esm::cli {

/// One argument of `esm apply`, in the order of the command line.
struct Edit {
  enum class Kind { Set, Region, Falloff, Rule, FixBox, Poke, Gravity, ClearLoads } kind;
  std::string text;            ///< as typed
  std::vector<double> numbers; ///< of lists, already read
};

/// Carries the edits out. Whose values a --set gives:
///   - before the first --region: the base tissue's,
///   - after a --region: that region's, which starts with the base tissue's inputs.
/// A region with nothing of its own would change nothing; so if no --set at all follows a --region, the
/// values before it are meant for the regions, and the base tissue stays.
/// Errors: InvalidValue, naming the argument; the project is then half edited and to be thrown away.
Status applyEdits(const std::vector<Edit>& edits, Project& project);

} // namespace esm::cli
