// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

namespace esm::bench {

/// A mesh file of the import bench: a bumpy torus of given triangle count, written in one of the formats.
struct MeshFile {
  const char* name;
  /// @return whether it was written
  bool (*write)(const std::filesystem::path& path, int triangles);
};
const std::vector<MeshFile>& meshFiles();

} // namespace esm::bench
