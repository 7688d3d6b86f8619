// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

namespace esm {

/// The usual endings, without a point, of the files that can be imported, for file dialogs: of those with a
/// reader of our own or of Inventor, and of those that the assimp library reads. Content decides all the
/// same.
std::span<const std::string_view> ownEndings() noexcept;
std::span<const std::string_view> foreignEndings() noexcept;

} // namespace esm
