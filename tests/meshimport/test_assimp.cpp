// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "tests/meshimport/import_bytes.h"

#include <gmock/gmock.h>

namespace {

using namespace esm;
using namespace esm::test;
using ::testing::HasSubstr;

/// A glTF with one triangle of float32 corners in `uri`, placed by the given nodes.
std::string gltf(const std::string& uri, const std::string& nodes, const std::string& mode = "4")
{
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[)" + nodes +
         R"(],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":)" + mode +
         R"(}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],)"
         R"("bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":")" +
         uri + R"("}]})";
}

std::string corners()
{
  std::string bytes;
  for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) bytes += bytesOf(x);
  return bytes;
}

TEST(Assimp, nodeTransformsArePutOnTheMeshOncePerNode)
{
  const TempFolder folder;
  folder.write("corners.bin", corners());
  const auto file = folder.write(
    "x.gltf",
    gltf("corners.bin", R"({"mesh":0,"children":[1],"translation":[0,0,5]},{"mesh":0,"scale":[2,2,2]})"));
  const auto imported = importMesh(file);
  ASSERT_TRUE(imported) << imported.error().detail;
  EXPECT_EQ(summary(imported), "5/6/2"); // both triangles share the corner (0, 0, 5)
  EXPECT_EQ(imported->report.boxMin, Eigen::Vector3d(0, 0, 5));
  EXPECT_EQ(imported->report.boxMax, Eigen::Vector3d(2, 2, 5));
  EXPECT_EQ(imported->format, "gltf (assimp)");
}

TEST(Assimp, linesAreRead)
{
  const TempFolder folder;
  folder.write("corners.bin", corners());
  const auto file = folder.write("x.gltf", gltf("corners.bin", R"({"mesh":0})", "3")); // a line strip
  EXPECT_EQ(summary(importMesh(file)), "3/2/0");
}

TEST(Assimp, companionsOutsideTheFolderStayClosed)
{
  const TempFolder folder;
  folder.write("secret.bin", corners());
  const auto file = folder.write("inner/x.gltf", gltf("../secret.bin", R"({"mesh":0})"));
  const auto imported = importMesh(file);
  ASSERT_FALSE(imported);
  EXPECT_THAT(imported.error().detail, HasSubstr("x.gltf: "));
  std::filesystem::create_symlink(folder.path() / "secret.bin", folder.path() / "inner" / "link.bin");
  EXPECT_FALSE(importMesh(folder.write("inner/y.gltf", gltf("link.bin", R"({"mesh":0})"))));
}

TEST(Assimp, brokenFilesAreRefusedInOneLine)
{
  for (const auto& [name, bytes] :
       {std::pair<const char*, std::string>{"x.gltf", gltf("absent.bin", R"({"mesh":0})").substr(0, 200)},
        {"x.glb", std::string("glTF\2\0\0\0\xFF\xFF\0\0", 12)},
        {"x.dae", "<?xml version=\"1.0\"?><COLLADA"},
        {"x.3ds", "no 3DS at all"}}) {
    const auto imported = importBytes(name, bytes);
    ASSERT_FALSE(imported) << name;
    EXPECT_THAT(imported.error().detail, HasSubstr(name));
    EXPECT_EQ(imported.error().detail.find('\n'), std::string::npos);
  }
}

} // namespace
