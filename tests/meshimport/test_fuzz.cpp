// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/file_io.h"
#include "core/geometry/weld.h"
#include "core/net/net_builder.h"
#include "meshimport/stated_frame.h"
#include "tests/meshimport/import_bytes.h"

#include <random>

namespace {

using namespace esm;
using namespace esm::test;

/// Small files that use every feature of their readers.
struct Seed {
  const char* name;
  const char* reader;
  std::string bytes;
};

std::vector<Seed> seeds()
{
  const std::string ply =
    "element vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 2\n"
    "property list uchar int vertex_indices\nelement edge 1\nproperty int vertex1\n"
    "property int vertex2\nelement other 1\nproperty list uchar double d\nend_header\n";
  std::string plyBody;
  for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 1.f, 1.f, 0.f, 0.f, 1.f, 0.f})
    plyBody += bytesOf(x, std::endian::big);
  for (const int i : {0, 1, 2, 3})
    plyBody += i == 0 ? "\4" + bytesOf(i, std::endian::big) : bytesOf(i, std::endian::big);
  for (const int i : {2, 1, 0})
    plyBody += i == 2 ? "\3" + bytesOf(i, std::endian::big) : bytesOf(i, std::endian::big);
  plyBody +=
    bytesOf(0, std::endian::big) + bytesOf(2, std::endian::big) + "\1" + bytesOf(2.5, std::endian::big);
  return {
    {"obj", "OBJ",
     "# x\no a\nv 0 0 0\nv 1.5e0 0 -0\nv 0 1 0\nv 1 1 .5\nf 1/1 2//2 4/3/3 -2\nf 1 2 \\\n 3\nl 1 2 3 4\n"},
    {"stl", "STL", binaryStl(kTwoFacets, 2)},
    {"asciiStl", "STL",
     "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1e0 1 "
     "0\nendloop\nendfacet\nendsolid x\n"},
    {"asciiPly", "PLY",
     "ply\nformat ascii 1.0\n" + ply + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n3 2 1 0\n0 2\n1 7.5\n"},
    {"binaryPly", "PLY", "ply\nformat binary_big_endian 1.0\n" + ply + plyBody},
    {"off", "OFF", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n3 2 1 0\n"},
  };
}

/// One or two small accidents: bytes changed, lost, doubled, moved, the end cut off, numbers made absurd.
std::string mutated(std::string bytes, std::mt19937& random)
{
  const auto below = [&random](std::size_t n) {
    return static_cast<std::size_t>(random() % std::max<std::size_t>(n, 1));
  };
  const char* const words[] = {"nan", "-1", "1e999", "99999999999", "4294967295", "2147483648", " ",    "\n",
                               "\\",  "0",  "#",     "-",           "inf",        "f",          "l 1 2"};
  for (std::size_t accidents = 1 + below(2); accidents > 0; --accidents) {
    const std::size_t at = below(bytes.size());
    switch (below(7)) {
    case 0:
      bytes.resize(at);
      break;
    case 1:
      if (!bytes.empty()) bytes[at] = static_cast<char>(random());
      break;
    case 2:
      bytes.erase(at, 1 + below(8));
      break;
    case 3:
      bytes.insert(at, bytes.substr(below(bytes.size()), below(40)));
      break;
    case 4:
      bytes.insert(at, words[below(std::size(words))]);
      break;
    case 5:
      if (!bytes.empty()) bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
      break;
    default:
      bytes.replace(at, std::min<std::size_t>(1 + below(4), bytes.size() - at),
                    words[below(std::size(words))]);
      break;
    }
  }
  return bytes;
}

bool indicesInRange(const Mesh& mesh)
{
  const auto inRange = [&](const auto& indices) {
    return indices.size() == 0 || (indices.minCoeff() >= 0 && indices.maxCoeff() < mesh.vertexCount());
  };
  return inRange(mesh.triangles) && inRange(mesh.segments);
}

const MeshReader& readerNamed(std::string_view name)
{
  return *std::find_if(readerTable().begin(), readerTable().end(),
                       [name](const MeshReader& reader) { return reader.name == name; });
}

TEST(Fuzz, noAccidentToAFileCrashesAReaderOrYieldsABadIndex)
{
  std::mt19937 random(20260101);
  for (const Seed& seed : seeds()) {
    SCOPED_TRACE(seed.name);
    const MeshReader& reader = readerNamed(seed.reader);
    EXPECT_TRUE(reader.recognises(seed.bytes, ""));
    int read = 0, refused = 0;
    for (int i = 0; i < 3000; ++i) {
      const std::string bytes = i == 0 ? seed.bytes : mutated(seed.bytes, random);
      FileStory story;
      reader.recognises(bytes, "");
      statedInText(bytes, reader.name);
      Result<Mesh> mesh = reader.read(bytes, "fuzz", story, nullptr); // even if it is not recognised
      ++(mesh ? read : refused);
      if (!mesh) {
        EXPECT_NE(mesh.error().code, ErrorCode::Internal);
        EXPECT_EQ(mesh.error().detail.rfind("fuzz: ", 0), 0u);
        continue;
      }
      ASSERT_TRUE(indicesInRange(*mesh)) << bytes;
      weldVertices(*mesh);
      const Result<SpringNet> net = buildNet(*mesh);
      EXPECT_TRUE(!net || checkNet(*net));
    }
    EXPECT_GT(read, 75) << "the accidents are too hard to test what is behind the parser";
    EXPECT_GT(refused, 300);
  }
}

TEST(Fuzz, anySampleCutAnywhereIsReadOrRefused)
{
  std::mt19937 random(7);
  for (const char* name : {"fallopian_tube.obj", "uterus.stl"}) {
    const std::string bytes =
      *readFile(std::filesystem::path(ESM_SOURCE_DIR) / "resources" / "samples" / name);
    for (int i = 0; i < 40; ++i) {
      const Result<ImportedMesh> imported = importBytes(name, bytes.substr(0, random() % bytes.size()));
      EXPECT_TRUE(!imported || indicesInRange(imported->mesh));
      if (imported && std::string_view(name) == "uterus.stl") { // its count and size tell every cut
        EXPECT_NE(::testing::PrintToString(imported->notes).find("may be cut short"), std::string::npos);
      }
    }
  }
}

} // namespace
