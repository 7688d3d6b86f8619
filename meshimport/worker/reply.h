// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/geometry/mesh.h"
#include "core/geometry/scene_frame.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace esm {

/// What the worker process found in a file: a mesh, or why there is none.
struct WorkerReply {
  std::optional<Error> refusal; ///< then the rest is empty
  std::string format;
  std::vector<std::string> notes;
  StatedFrame stated;
  Mesh mesh;
};

/// The answer of the worker to its parent, one flat buffer through a pipe. Numbers are in the machine's own
/// byte order: both ends are installed together, the version catches where they are not.
///
///     head | text | positions 3 x V | triangles 3 x F | segments 2 x S | tetrahedra 4 x T | diagonals 2 x D
///
/// The text is the detail of the refusal if there is one, else the format and the notes, a line each.
struct ReplyHead {
  std::uint32_t magic = kMagic;
  std::uint32_t version = kVersion;
  std::int64_t refusal = kNone; ///< or the ErrorCode
  std::uint64_t textBytes = 0;
  double metres = 0.0;             ///< of a unit, as the file states; 0 = nothing is stated
  std::int32_t up = -1, axes = -1; ///< UpAxis and PatientAxes that the file states, or -1
  std::uint64_t vertices = 0, triangles = 0, segments = 0, tetrahedra = 0, diagonals = 0;

  static constexpr std::uint32_t kMagic = 0x574D5345; ///< "ESMW"
  static constexpr std::uint32_t kVersion = 3;
  static constexpr std::int64_t kNone = -1;
};

std::string encodeReply(const WorkerReply& reply);

/// How long the whole reply must be, once its head is there. Empty if the head is none of ours: wrong magic
/// or version, more items than an Index counts, a mesh beside an error.
std::optional<std::uint64_t> replySize(std::string_view begin);

/// Trusts nothing: length, counts, text, each index, and that nothing uses a place that is not finite.
/// Nothing is allocated that has not arrived. Errors: BadFormat with what is wrong.
Result<WorkerReply> decodeReply(std::string_view bytes);

} // namespace esm
