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

std::string amf(const std::string& volumes)
{
  const auto vertex = [](const char* x, const char* y, const char* z) {
    return std::string("<vertex><coordinates><x>") + x + "</x><y>" + y + "</y><z>" + z +
           "</z></coordinates></vertex>";
  };
  return "<?xml version=\"1.0\"?><amf unit=\"millimeter\"><object id=\"1\"><mesh><vertices>" +
         vertex("0", "0", "0") + vertex("10", "0", "0") + vertex("0", "10", "0") + vertex("0", "0", "10") +
         "</vertices>" + volumes + "</mesh></object></amf>";
}
std::string amfTriangle(int a, int b, int c)
{
  return "<triangle><v1>" + std::to_string(a) + "</v1><v2>" + std::to_string(b) + "</v2><v3>" +
         std::to_string(c) + "</v3></triangle>";
}

/// Bodies of two materials share one list of vertices: each volume holds its triangles, and all arrive.
TEST(Assimp, everyVolumeOfAnAmfIsRead)
{
  const std::string wall = amfTriangle(0, 1, 2), rest = amfTriangle(0, 1, 3) + amfTriangle(0, 2, 3);
  const std::string one = "<volume>" + wall + rest + "</volume>";
  EXPECT_EQ(summary(importBytes("x.amf", amf(one))), "4/6/3");
  EXPECT_EQ(
    summary(importBytes("x.amf", amf("<volume>" + wall + "</volume>\n<volume>" + rest + "</volume>"))),
    "4/6/3");
  // materials that the file does not hold, names and colours; volumes without a triangle
  EXPECT_EQ(
    summary(importBytes(
      "x.amf", amf("<volume/><volume materialid=\"7\"><metadata type=\"name\">wall</metadata><color><r>0</r>"
                   "<g>1</g><b>0</b></color>" +
                   wall +
                   "</volume><volume/><!-- <volume> --><volume materialid=\"8\" type=\"object\"><color>"
                   "<r>1</r><g>0</g><b>0</b></color>" +
                   rest + "</volume><volume/>"))),
    "4/6/3");
  EXPECT_EQ(summary(importBytes("x.amf", amf("<volume>" + wall +
                                             "</volume><metadata type=\"name\">a</metadata><volume>" + rest +
                                             "</volume>"))),
            "4/6/3");
  EXPECT_EQ(summary(importBytes("x.amf", amf("<volume></volume><volume>" + wall + rest + "</volume>"))),
            "4/6/3");
}

} // namespace
