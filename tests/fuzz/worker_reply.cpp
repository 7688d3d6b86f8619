// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
// What the parent takes from the import worker, which may have been broken by the file it read.
#include "meshimport/worker/reply.h"

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const auto reply = esm::decodeReply(bytes);
  if (!reply && reply.error().detail.empty()) __builtin_trap(); // a refusal must say why
  if (!reply || reply->refusal) return 0;
  const esm::Mesh& mesh = reply->mesh;
  const auto inRange = [&](const auto& indices) {
    return indices.size() == 0 || (indices.minCoeff() >= 0 && indices.maxCoeff() < mesh.vertexCount());
  };
  if (!inRange(mesh.triangles) || !inRange(mesh.segments) || !inRange(mesh.tetrahedra) ||
      !inRange(mesh.diagonals))
    __builtin_trap();
  if (esm::encodeReply(*reply).size() > size) __builtin_trap(); // nothing may come of nothing
  return 0;
}
