// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace esm {

/// Content that surely is no mesh we read, in words for a message.
struct ForeignKind {
  std::string_view what;   ///< "a PNG picture", "a NIfTI image", ...
  std::string_view wayOut; ///< how one comes to a mesh from there
};

/// By the first bytes; empty for what may be a mesh.
std::optional<ForeignKind> foreignKind(std::string_view bytes);

/// What to say about content that no reader recognises: what it is, and the way to a mesh.
/// @param ending of the file's name, in lower case; says more where the bytes are nothing known
std::string describeForeign(std::string_view bytes, std::string_view ending);

} // namespace esm
