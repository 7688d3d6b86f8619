// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "tests/meshimport/import_bytes.h"

#include <string>

namespace esm::test {

/// A glTF binary of a wavy sheet with 2 n^2 triangles and (n + 1)^2 vertices.
inline std::string glbSheet(std::uint32_t n)
{
  std::string points, corners;
  for (std::uint32_t row = 0; row <= n; ++row)
    for (std::uint32_t column = 0; column <= n; ++column)
      for (const float x : {static_cast<float>(column), static_cast<float>(row), static_cast<float>(row % 7)})
        points += bytesOf(x);
  for (std::uint32_t row = 0; row < n; ++row)
    for (std::uint32_t column = 0; column < n; ++column) {
      const std::uint32_t a = row * (n + 1) + column, b = a + 1, c = a + n + 1, d = c + 1;
      for (const std::uint32_t corner : {a, b, d, a, d, c}) corners += bytesOf(corner);
    }
  const std::string side = std::to_string(n);
  std::string json =
    R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{"primitives":)"
    R"([{"attributes":{"POSITION":0},"indices":1}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":)" +
    std::to_string((n + 1) * (n + 1)) + R"(,"type":"VEC3","min":[0,0,0],"max":[)" + side + "," + side +
    R"(,6]},{"bufferView":1,"componentType":5125,"count":)" + std::to_string(6 * n * n) +
    R"(,"type":"SCALAR"}],"bufferViews":[{"buffer":0,"byteLength":)" + std::to_string(points.size()) +
    R"(},{"buffer":0,"byteOffset":)" + std::to_string(points.size()) + R"(,"byteLength":)" +
    std::to_string(corners.size()) + R"(}],"buffers":[{"byteLength":)" +
    std::to_string(points.size() + corners.size()) + "}]}";
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const auto chunk = [](const std::string& kind, const std::string& bytes) {
    return bytesOf(static_cast<std::uint32_t>(bytes.size())) + kind + bytes;
  };
  const std::string chunks = chunk("JSON", json) + chunk(std::string("BIN\0", 4), points + corners);
  return "glTF" + bytesOf(std::uint32_t{2}) + bytesOf(static_cast<std::uint32_t>(12 + chunks.size())) +
         chunks;
}

/// A COLLADA scene of that many nodes, each inside the one before: more than the library's stack holds.
inline std::string deepCollada(int depth)
{
  std::string nodes;
  for (int i = 0; i < depth; ++i) nodes += "<node id=\"n" + std::to_string(i) + "\">";
  for (int i = 0; i < depth; ++i) nodes += "</node>";
  return R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">)"
         R"(<library_visual_scenes><visual_scene id="s">)" +
         nodes +
         R"(</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

} // namespace esm::test
