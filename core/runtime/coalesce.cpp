// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/runtime/coalesce.h"

#include <iterator>
#include <utility>

namespace esm {

void coalesce(std::vector<SimCommand>& batch)
{
  std::size_t kept = 0;
  for (std::size_t i = 0; i < batch.size(); ++i) {
    auto* now = std::get_if<command::PatchParameters>(&batch[i]);
    auto* last = kept > 0 ? std::get_if<command::PatchParameters>(&batch[kept - 1]) : nullptr;
    if (now != nullptr && last != nullptr) {
      std::move(now->patches.begin(), now->patches.end(), std::back_inserter(last->patches));
      continue;
    }
    if (kept != i) batch[kept] = std::move(batch[i]);
    ++kept;
  }
  batch.erase(batch.begin() + static_cast<std::ptrdiff_t>(kept), batch.end());
}

} // namespace esm
