// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/state_folder.h"

#include <cstdlib>

namespace esm {

std::filesystem::path stateFolder(const std::string& part)
{
  std::filesystem::path state;
  const auto take = [&](const char* variable, const char* below) {
    const char* value = std::getenv(variable);
    if (!state.empty() || value == nullptr || *value != '/') return; // relative ones are to be ignored
    state = std::filesystem::path(value) / below;
  };
  take("XDG_STATE_HOME", "");
  take("HOME", ".local/state");
  return state.empty() ? state : state / "esm-modeler" / part;
}

} // namespace esm
