// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace esm {

/// One text of a 3MF model whose objects lie in several files of the archive, as its production extension has
/// it and slicers write it. The library reads the first file alone, and takes other objects for those of the
/// same number. Empty where the model is one file.
/// @param part the text of another file by its path ("/3D/Objects/object_1.model"); empty if there is none
/// @param lost paths that are named but not there
std::string joinedModel(std::string_view root, const std::function<std::string(std::string_view path)>& part,
                        std::vector<std::string>& lost);

} // namespace esm
