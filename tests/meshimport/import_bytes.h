// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "meshimport/mesh_importer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace esm::test {

inline const std::filesystem::path kSamples = std::filesystem::path(ESM_SOURCE_DIR) / "resources" / "samples";
inline const std::filesystem::path kMeshData = std::filesystem::path(ESM_TEST_DATA) / "meshes";

/// A file that a reader must refuse, and what it must say.
struct Refused {
  const char* name;
  std::string bytes;
  ErrorCode code;
  const char* message;
};
inline void PrintTo(const Refused& file, std::ostream* out)
{
  *out << file.name;
}

inline std::string replaced(std::string text, const std::string& from, const std::string& to)
{
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

/// A folder of this process that is gone at the end of the test.
class TempFolder {
public:
  TempFolder()
  {
    static int number = 0;
    m_path = std::filesystem::path(::testing::TempDir()) /
             ("esm_meshes_" + std::to_string(::getpid()) + "_" + std::to_string(number++));
    std::filesystem::create_directories(m_path);
  }
  ~TempFolder() { std::filesystem::remove_all(m_path); }
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;

  std::filesystem::path write(const std::string& name, std::string_view bytes) const
  {
    const std::filesystem::path file = m_path / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return file;
  }
  const std::filesystem::path& path() const { return m_path; }

private:
  std::filesystem::path m_path;
};

/// Imports bytes as if they lay in a file of that name.
inline Result<ImportedMesh> importBytes(const std::string& name, std::string_view bytes,
                                        const ImportOptions& options = {})
{
  const TempFolder folder;
  return importMesh(folder.write(name, bytes), options);
}

/// "nodes/springs/triangles" or the error, so that one comparison tells all.
inline std::string summary(const Result<ImportedMesh>& imported)
{
  if (!imported) return "error: " + imported.error().detail;
  const MeshReport& report = imported->report;
  return std::to_string(report.nodes) + "/" + std::to_string(report.springs) + "/" +
         std::to_string(report.triangles);
}

/// Why bytes in a file of that name are refused.
inline std::string refusalOf(const std::string& name, std::string_view bytes)
{
  const auto imported = importBytes(name, bytes);
  return imported ? "read" : imported.error().detail;
}

/// What the mesh holds or the error, so that one comparison tells all.
inline std::string contents(const Result<ImportedMesh>& imported)
{
  if (!imported) return "error: " + imported.error().detail;
  const Mesh& mesh = imported->mesh;
  return std::to_string(mesh.vertexCount()) + " vertices, " + std::to_string(mesh.segmentCount()) +
         " segments, " + std::to_string(mesh.triangleCount()) + " triangles, " +
         std::to_string(mesh.tetrahedronCount()) + " tetrahedra";
}

inline std::string allNotes(const Result<ImportedMesh>& imported)
{
  std::string all;
  if (imported)
    for (const std::string& note : imported->notes) all += note;
  return all;
}

/// A value as bytes of the given order.
template <class T>
std::string bytesOf(T value, std::endian order = std::endian::little)
{
  std::string bytes(reinterpret_cast<const char*>(&value), sizeof value);
  if (order != std::endian::native) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

/// A binary STL; `count` is what the header says, the facets are what there is.
inline std::string binaryStl(const std::vector<std::array<float, 9>>& facets, std::uint32_t count,
                             std::string header = "made by a test")
{
  header.resize(80, '\0');
  std::string bytes = header + bytesOf(count);
  for (const auto& facet : facets) {
    for (int k = 0; k < 3; ++k) bytes += bytesOf(0.0f);
    for (const float x : facet) bytes += bytesOf(x);
    bytes += bytesOf(std::uint16_t{0});
  }
  return bytes;
}

inline const std::vector<std::array<float, 9>> kTwoFacets{{0, 0, 0, 1, 0, 0, 0, 1, 0},
                                                          {1, 0, 0, 1, 1, 0, 0, 1, 0}};

} // namespace esm::test
