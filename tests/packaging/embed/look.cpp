// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
// Says what is in mesh files.   look FILE...
#include "meshimport/mesh_importer.h"

#include <iostream>

int main(int count, char** words)
{
  for (int i = 1; i < count; ++i) {
    const auto read = esm::importMesh(words[i]);
    if (!read) return std::cerr << read.error().detail << '\n', 1;
    std::cout << read->mesh.triangles.cols() << " triangles in " << words[i] << '\n';
  }
}
