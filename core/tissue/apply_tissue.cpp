// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/tissue/tissue_derivation.h"

namespace esm {

Result<ApplyReport> applyTissue(const TissueModel& model, SpringNet& net)
{
  const auto derivation = TissueDerivation::create(model, net);
  if (!derivation) return derivation.error();
  return derivation->account(net);
}

} // namespace esm
