// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "bench/import_files.h"

#include "core/base/text_number.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <random>

namespace esm::bench {

namespace {

struct Shape {
  std::vector<std::array<float, 3>> vertices; ///< [mm]
  std::vector<std::array<int, 3>> triangles;
};

/// A closed torus of two triangles per grid cell, twice as many cells around as across, with bumps.
Shape bumpyTorus(int triangles)
{
  const int across = static_cast<int>(std::sqrt(triangles / 4.0)), around = triangles / (2 * across);
  Shape shape;
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      const double u = 2 * M_PI * i / around, v = 2 * M_PI * j / across;
      const double r = 20 + 1.5 * std::sin(7 * u) * std::cos(5 * v);
      shape.vertices.push_back({static_cast<float>((50 + r * std::cos(v)) * std::cos(u)),
                                static_cast<float>((50 + r * std::cos(v)) * std::sin(u)),
                                static_cast<float>(r * std::sin(v))});
      const int i1 = (i + 1) % around, j1 = (j + 1) % across;
      const int a = i * across + j, b = i1 * across + j, c = i1 * across + j1, d = i * across + j1;
      shape.triangles.push_back({a, b, c});
      shape.triangles.push_back({a, c, d});
    }
  }
  return shape;
}

Shape shuffledTorus(int triangles)
{
  Shape shape = bumpyTorus(triangles);
  std::mt19937 random(1999);
  for (std::size_t i = shape.triangles.size(); i > 1; --i)
    std::swap(shape.triangles[i - 1], shape.triangles[random() % i]);
  return shape;
}

template <class T>
void append(std::string& bytes, const T& value)
{
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

void appendWord(std::string& text, float value)
{
  text += ' ';
  text += formatDouble(double{value}, 9);
}

bool save(const std::filesystem::path& path, const std::string& bytes)
{
  std::ofstream file(path, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return file.good();
}

std::array<float, 3> normalOf(const Shape& shape, const std::array<int, 3>& triangle)
{
  const auto at = [&](int k) {
    return shape.vertices[static_cast<std::size_t>(triangle[static_cast<std::size_t>(k)])];
  };
  const auto a = at(0), b = at(1), c = at(2);
  std::array<double, 3> u{}, v{};
  for (std::size_t k = 0; k < 3; ++k) u[k] = double{b[k]} - double{a[k]}, v[k] = double{c[k]} - double{a[k]};
  const std::array<double, 3> n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                                u[0] * v[1] - u[1] * v[0]};
  const double length = std::hypot(n[0], n[1], n[2]);
  return {static_cast<float>(n[0] / length), static_cast<float>(n[1] / length),
          static_cast<float>(n[2] / length)};
}

bool writeStl(const std::filesystem::path& path, const Shape& shape)
{
  std::string bytes(80, ' ');
  append(bytes, static_cast<std::uint32_t>(shape.triangles.size()));
  for (const auto& triangle : shape.triangles) {
    append(bytes, normalOf(shape, triangle));
    for (const int vertex : triangle) append(bytes, shape.vertices[static_cast<std::size_t>(vertex)]);
    append(bytes, std::uint16_t{0});
  }
  return save(path, bytes);
}

bool writeAsciiStl(const std::filesystem::path& path, int triangles)
{
  const Shape shape = bumpyTorus(triangles);
  std::string text = "solid torus\n";
  for (const auto& triangle : shape.triangles) {
    text += " facet normal";
    for (const float x : normalOf(shape, triangle)) appendWord(text, x);
    text += "\n  outer loop\n";
    for (const int vertex : triangle) {
      text += "   vertex";
      for (const float x : shape.vertices[static_cast<std::size_t>(vertex)]) appendWord(text, x);
      text += '\n';
    }
    text += "  endloop\n endfacet\n";
  }
  return save(path, text + "endsolid torus\n");
}

bool writeObj(const std::filesystem::path& path, int triangles)
{
  const Shape shape = bumpyTorus(triangles);
  std::string text = "o torus\n";
  for (const auto& vertex : shape.vertices) {
    text += 'v';
    for (const float x : vertex) appendWord(text, x);
    text += '\n';
  }
  for (const auto& triangle : shape.triangles) {
    text += 'f';
    for (const int vertex : triangle) text += ' ' + std::to_string(vertex + 1);
    text += '\n';
  }
  return save(path, text);
}

bool writePly(const std::filesystem::path& path, int triangles)
{
  const Shape shape = bumpyTorus(triangles);
  std::string bytes =
    "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(shape.vertices.size()) +
    "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
    std::to_string(shape.triangles.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const auto& vertex : shape.vertices) append(bytes, vertex);
  for (const auto& triangle : shape.triangles) {
    append(bytes, std::uint8_t{3});
    append(bytes, triangle);
  }
  return save(path, bytes);
}

} // namespace

const std::vector<MeshFile>& meshFiles()
{
  static const std::vector<MeshFile> files{
    {"ordered.stl", [](const auto& path, int n) { return writeStl(path, bumpyTorus(n)); }},
    {"shuffled.stl", [](const auto& path, int n) { return writeStl(path, shuffledTorus(n)); }},
    {"torus.obj", writeObj},
    {"binary.ply", writePly},
    {"ascii.stl", writeAsciiStl}};
  return files;
}

} // namespace esm::bench
