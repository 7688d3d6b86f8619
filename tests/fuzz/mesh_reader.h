// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "meshimport/mesh_importer.h"
#include "meshimport/stated_frame.h"

#include <cstddef>
#include <cstdint>

namespace esm::fuzz {

/// Whatever the bytes are: a refusal says why, and what is read uses vertices that exist.
inline int feed(const MeshReader& reader, const std::uint8_t* data, std::size_t size)
{
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  reader.recognises(bytes, "");
  statedInText(bytes, reader.name);
  FileStory story;
  const Result<Mesh> mesh = reader.read(bytes, "fuzz", story, nullptr);
  if (!mesh) {
    if (mesh.error().detail.rfind("fuzz: ", 0) != 0) __builtin_trap();
    return 0;
  }
  const auto inRange = [&](const auto& indices) {
    return indices.size() == 0 || (indices.minCoeff() >= 0 && indices.maxCoeff() < mesh->vertexCount());
  };
  if (!inRange(mesh->triangles) || !inRange(mesh->segments) || !inRange(mesh->tetrahedra)) __builtin_trap();
  return 0;
}

} // namespace esm::fuzz
