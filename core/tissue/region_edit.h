// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/tissue/tissue_model.h"

#include <cstddef>

namespace esm {

/// Edits of the list of regions as a person makes them. Order is meaning: a later region covers an earlier
/// one. A locked region is neither changed, removed nor moved by itself; others may be moved past it and may
/// cover it, and only lockRegion() takes the lock away. Showing and hiding is no change.
///
/// Errors of all: InvalidValue with the region's number and name (locked, no such place); the model is then
/// as before.

/// Whether the region is there and not locked: for edits that are not below, such as those of its inputs.
Status mayEditRegion(const TissueModel& model, std::size_t place);
/// @param place in [0, size]: what comes to stand there.
Status insertRegion(TissueModel& model, std::size_t place, Region region);
/// The lock of `region` does not count: it takes that of the region it replaces.
Status replaceRegion(TissueModel& model, std::size_t place, Region region);
Status removeRegion(TissueModel& model, std::size_t place);
/// @param to the place that it has afterwards.
Status moveRegion(TissueModel& model, std::size_t from, std::size_t to);
Status lockRegion(TissueModel& model, std::size_t place, bool locked);
Status showRegion(TissueModel& model, std::size_t place, bool visible);
/// Makes a mirrored twin a region of its own, right above: both can then be changed each by itself. Where the
/// two overlap within their falloffs, their tissue is now laid over each other twice. Not for inside-out
/// ones.
Status detachTwin(TissueModel& model, std::size_t place);

} // namespace esm
