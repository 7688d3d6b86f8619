// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <string_view>

/// The JSON tree behind our files: parsing with limits and writing in our own layout. Internal to
/// core/project: no header that others include names nlohmann.
namespace esm::json {

/// Keys keep the order in which we write them, so equal documents give equal bytes.
using Json = nlohmann::ordered_json;

/// Far beyond any document of ours, far below what would hurt the reader: the CBOR parser recurses once per
/// level, and the ordered object looks its keys up one by one.
inline constexpr std::size_t kMaxDepth = 32;
inline constexpr std::size_t kMaxKeys = 1000;

/// Errors: BadFormat; one line with origin and place, whatever the bytes.
Result<Json> parseJson(std::string_view bytes, const std::string& origin);
Result<Json> parseCbor(std::string_view bytes, const std::string& origin);

/// Layout for line diffs: what fits on a line stays on one, an object has one key per line, long lists have
/// a fixed number of items per line, so that one changed number changes one line. Numbers in their shortest
/// exact form, -0 as -0.0. A number that is not finite becomes null, which no reader of ours takes.
std::string write(const Json& tree);
std::string writeLine(const Json& tree); ///< the same on one line, without its end
std::string writeCbor(const Json& tree);

/// Where the tree holds a NaN or an infinity: "/net/springs/stiffness/17"; none if it can be written.
std::optional<std::string> findNonFinite(const Json& tree);

/// Called in `catch (...)` of a reader: what a library or the allocator threw, as an Error about `origin`.
/// OutOfMemory, or BadFormat for the rest.
Error thrownWhileReading(const std::string& origin);

/// Text as JSON can hold it: bytes that are no UTF-8 become U+FFFD.
std::string validUtf8(const std::string& text);

} // namespace esm::json
