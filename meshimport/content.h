// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace esm {

/// Whether the first kilobytes could be ASCII or UTF-8 text: no NUL, hardly a control character.
bool looksLikeText(std::string_view bytes);

/// Without the NULs or the end-of-text byte (Ctrl-Z) that some programs put behind a text; other content as
/// it is.
std::string_view withoutPadding(std::string_view bytes);

/// Nothing but blanks, line ends, NULs and a byte-order mark.
bool isBlankContent(std::string_view bytes);

/// The usual ending (without a point) of a mesh format that assimp knows and that the first bytes
/// betray, such as "glb" or "fbx"; empty if they betray nothing.
std::string_view betrayedEnding(std::string_view bytes);

} // namespace esm
