// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/file_io.h"
#include "core/base/text_number.h"
#include "tests/meshimport/import_bytes.h"

#include <gmock/gmock.h>

#include <clocale>

namespace {

using namespace esm;
using namespace esm::test;
using ::testing::HasSubstr;

const std::string kObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
const std::string kPng("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\x01\0\0\0\x01\x08\x02\0\0\0", 29);

TEST(ImportMesh, contentDecidesNotTheName)
{
  for (const char* name : {"x.obj", "x.stl", "x.ply", "x.OBJ", "x", "x.dat", "x.fbx"}) {
    EXPECT_EQ(summary(importBytes(name, kObj)), "3/3/1") << name;
    EXPECT_EQ(summary(importBytes(name, binaryStl(kTwoFacets, 2))), "4/5/2") << name;
  }
  const auto imported = importBytes("x.stl", kObj);
  ASSERT_FALSE(imported->notes.empty());
  EXPECT_THAT(imported->notes[0], HasSubstr("named .stl, but its content is OBJ"));
  EXPECT_TRUE(importBytes("x.obj", kObj)->notes.empty());
}

TEST(ImportMesh, whatIsNoMeshIsNamedForWhatItIs)
{
  const auto refusal = [](const char* name, std::string_view bytes) {
    const auto imported = importBytes(name, bytes);
    return imported ? "read" : imported.error().detail;
  };
  for (const char* name : {"x.obj", "x.stl", "x.ply", "x.off", "x.fbx", "x.glb"})
    EXPECT_THAT(refusal(name, kPng), HasSubstr(std::string(name) + ": this is a PNG picture")) << name;
  EXPECT_THAT(refusal("x.obj", "PK\x03\x04 something"), HasSubstr("a ZIP archive"));
  EXPECT_THAT(refusal("x.obj", std::string("\xFF\xFE"
                                           "v\0 \0",
                                           6)),
              HasSubstr("UTF-16 text"));
  EXPECT_THAT(refusal("x.obj", std::string("\x01\x02\x03\0\x04\x05", 6)),
              HasSubstr("binary data of an unknown kind"));
  EXPECT_THAT(refusal("x.txt", "Dear Sir or Madam"), HasSubstr("text of an unknown kind"));
  EXPECT_THAT(refusal("x.ply", "{\"a\": 1}"), HasSubstr("JSON text"));
  EXPECT_THAT(refusal("x.ply", "plx\nformat ascii 1.0\n"), HasSubstr("x.ply: "));
}

TEST(ImportMesh, absentFilesFoldersAndDevicesAreUnreadable)
{
  const TempFolder folder;
  EXPECT_EQ(importMesh(folder.path() / "absent.obj").error().code, ErrorCode::FileUnreadable);
  EXPECT_EQ(importMesh(folder.path()).error().code, ErrorCode::FileUnreadable);
  EXPECT_EQ(importMesh("/dev/zero").error().code, ErrorCode::FileUnreadable); // it would never end
}

TEST(ImportMesh, messagesStayOnOneLineEvenIfTheNameDoesNot)
{
  const auto imported = importBytes("two\nlines.obj", kPng);
  ASSERT_FALSE(imported);
  EXPECT_EQ(imported.error().detail.find('\n'), std::string::npos);
}

TEST(ImportMesh, theBadExamplesAreEachRefusedInOneLine)
{
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kMeshData / "bad")) {
    const Result<ImportedMesh> imported = importMesh(entry.path());
    ASSERT_FALSE(imported) << entry.path();
    EXPECT_THAT(imported.error().detail, HasSubstr(entry.path().filename().string()));
    EXPECT_EQ(imported.error().detail.find('\n'), std::string::npos);
    ++count;
  }
  EXPECT_GE(count, 7);
}

/// The sample organ written once more in each format, by this test's own hand.
TEST(ImportMesh, oneOrganInThreeFormatsIsOneMesh)
{
  const Result<ImportedMesh> obj = importMesh(kSamples / "fallopian_tube.obj");
  ASSERT_TRUE(obj);
  Mesh mesh = obj->mesh;
  mesh.position = mesh.position.cast<float>().cast<double>().eval(); // STL holds floats

  std::string objText, plyText, plyBinary;
  std::vector<std::array<float, 9>> facets;
  const std::string counts = "element vertex " + std::to_string(mesh.vertexCount()) +
                             "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                             std::to_string(mesh.triangleCount()) +
                             "\nproperty list uchar int vertex_indices\nend_header\n";
  plyText = "ply\nformat ascii 1.0\n" + counts;
  plyBinary = "ply\nformat binary_big_endian 1.0\n" + counts;
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    std::string row;
    for (int k = 0; k < 3; ++k) {
      row += " " + formatDouble(mesh.position(k, v));
      plyBinary += bytesOf(mesh.position(k, v), std::endian::big);
    }
    objText += "v" + row + "\n";
    plyText += row + "\n";
  }
  for (Index t = 0; t < mesh.triangleCount(); ++t) {
    std::string obj1, ply0;
    std::array<float, 9> facet;
    plyBinary += '\3';
    for (int k = 0; k < 3; ++k) {
      const Index v = mesh.triangles(k, t);
      obj1 += " " + std::to_string(v + 1);
      ply0 += " " + std::to_string(v);
      plyBinary += bytesOf(v, std::endian::big);
      for (int c = 0; c < 3; ++c)
        facet[static_cast<std::size_t>(3 * k + c)] = static_cast<float>(mesh.position(c, v));
    }
    objText += "f" + obj1 + "\n";
    plyText += "3" + ply0 + "\n";
    facets.push_back(facet);
  }
  const auto reference = importBytes("a.obj", objText);
  ASSERT_TRUE(reference);
  for (const auto& [name, bytes] : {std::pair{"a.ply", plyText}, std::pair{"b.ply", plyBinary}}) {
    const auto other = importBytes(name, bytes);
    ASSERT_TRUE(other) << other.error().detail;
    EXPECT_EQ(other->mesh.position, reference->mesh.position); // order of the file, to the last bit
    EXPECT_EQ(other->mesh.triangles, reference->mesh.triangles);
  }
  const auto stl = importBytes("c.stl", binaryStl(facets, static_cast<std::uint32_t>(facets.size())));
  ASSERT_TRUE(stl);
  EXPECT_EQ(stl->report.nodes, reference->report.nodes);
  EXPECT_EQ(stl->report.springs, reference->report.springs);
  EXPECT_EQ(stl->report.boxMax, reference->report.boxMax);
  // The springs come in another order, so the sum differs by rounding.
  EXPECT_NEAR(sumRestLength(stl->mesh, stl->edges), sumRestLength(reference->mesh, reference->edges), 1e-9);
}

TEST(ImportMesh, aDecimalCommaInTheLocaleChangesNothing)
{
  const auto before = importMesh(kSamples / "gallbladder.obj");
  const std::string old = std::setlocale(LC_ALL, nullptr);
  if (!std::setlocale(LC_ALL, "de_DE.UTF-8") && !std::setlocale(LC_ALL, "de_DE"))
    GTEST_SKIP() << "no German locale on this machine";
  const auto after = importMesh(kSamples / "gallbladder.obj");
  const auto ascii =
    importBytes("x.ply", "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
                         "property float z\nelement edge 1\nproperty int vertex1\nproperty int vertex2\n"
                         "end_header\n0.5 0 0\n1.5 0 0\n0 1\n");
  std::setlocale(LC_ALL, old.c_str());
  ASSERT_TRUE(after);
  EXPECT_EQ(after->mesh.position, before->mesh.position);
  EXPECT_EQ(ascii->report.boxMin.x(), 0.5);
}

TEST(Units, haveNamesAndLengths)
{
  for (const auto& [name, metres] : {std::pair{"mm", 1e-3}, {"cm", 1e-2}, {"m", 1.0}, {"inch", 0.0254}}) {
    const std::optional<LengthUnit> unit = lengthUnitFromName(name);
    ASSERT_TRUE(unit);
    EXPECT_EQ(metresPer(*unit), metres);
    EXPECT_EQ(lengthUnitName(*unit), name);
  }
  EXPECT_FALSE(lengthUnitFromName("MM"));
  EXPECT_FALSE(lengthUnitFromName(""));
}

TEST(ToScene, turnsYUpIntoZUpWithoutMirroring)
{
  Mesh mesh;
  mesh.position = Eigen::Matrix3d::Identity() * 1000.0; // the three axes, in mm
  toScene(mesh, LengthUnit::Millimetre, UpAxis::Y);
  EXPECT_EQ(mesh.position.col(0), Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(mesh.position.col(1), Eigen::Vector3d(0, 0, 1)); // up
  EXPECT_EQ(mesh.position.col(2), Eigen::Vector3d(0, -1, 0));
  EXPECT_FALSE(std::signbit(mesh.position(1, 0))); // no -0 in files
  Mesh upright;
  upright.position = Eigen::Matrix3d::Identity();
  toScene(upright, LengthUnit::Inch, UpAxis::Z);
  EXPECT_EQ(upright.position, Eigen::Matrix3d::Identity() * 0.0254);
}

TEST(ToScene, turnsXUpAsColladaMeansIt)
{
  Mesh mesh;
  mesh.position = Eigen::Matrix3d::Identity(); // x up, y to the left, z towards who looks
  toScene(mesh, FileFrame{1.0, UpAxis::X, PatientAxes::None});
  EXPECT_EQ(mesh.position.col(0), Eigen::Vector3d(0, 0, 1));
  EXPECT_EQ(mesh.position.col(1), Eigen::Vector3d(-1, 0, 0));
  EXPECT_EQ(mesh.position.col(2), Eigen::Vector3d(0, -1, 0));
  const Eigen::Vector3d low(0, 0, 0), high(1, 2, 4);
  EXPECT_EQ(extentInScene(low, high, {0.5, UpAxis::X, PatientAxes::None}), Eigen::Vector3d(1, 2, 0.5));
  EXPECT_EQ(extentInScene(low, high, {1.0, UpAxis::Y, PatientAxes::None}), Eigen::Vector3d(1, 4, 2));
}

TEST(FileFrame, whatIsStatedHoldsAndTheChoiceForTheRest)
{
  const ChosenFrame chosen{LengthUnit::Inch, UpAxis::Y, PatientAxes::None};
  EXPECT_EQ(frameOf({}, chosen), (FileFrame{0.0254, UpAxis::Y, PatientAxes::None}));
  EXPECT_EQ(frameOf({1e-3, {}, {}}, chosen), (FileFrame{1e-3, UpAxis::Y, PatientAxes::None}));
  EXPECT_EQ(frameOf({{}, UpAxis::Z, {}}, chosen), (FileFrame{0.0254, UpAxis::Z, PatientAxes::None}));
  // A patient lies with z up, unless the file says otherwise.
  EXPECT_EQ(frameOf({{}, {}, PatientAxes::Lps}, chosen), (FileFrame{0.0254, UpAxis::Z, PatientAxes::Lps}));
  EXPECT_EQ(frameOf({1.0, UpAxis::Y, {}}, {LengthUnit::Metre, UpAxis::Z, PatientAxes::Lps}),
            (FileFrame{1.0, UpAxis::Y, PatientAxes::Lps}));
  EXPECT_EQ(inWords({1e-3, UpAxis::Z, PatientAxes::Lps}), "millimetres, z up and a patient's axes (LPS)");
  EXPECT_EQ(inWords({0.125, {}, {}}), "units of 0.125 m");
}

TEST(FileFrame, organsHaveAMillimetreToTwoMetres)
{
  for (const double size : {1e-3, 0.08, 2.0}) EXPECT_TRUE(isUsualSize(size)) << size;
  for (const double size : {0.0, 9e-4, 2.1, 80.0, std::nan("")}) EXPECT_FALSE(isUsualSize(size)) << size;
}

} // namespace
