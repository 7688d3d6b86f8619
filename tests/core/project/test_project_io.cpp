// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/project/project_io.h"

#include "core/base/file_io.h"
#include "tests/core/project/random_project.h"

#include <gmock/gmock.h>

#include <cmath>

namespace esm {
namespace {

using testing::HasSubstr;

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
  const std::size_t place = text.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  return place == std::string::npos ? text : text.replace(place, from.size(), to);
}

std::string messageOf(const std::string& bytes)
{
  const Result<Project> project = parseProject(bytes, "sample.esm");
  return project ? "no error" : project.error().detail;
}

std::vector<std::string> linesOf(const std::string& text)
{
  std::vector<std::string> lines(1);
  for (const char c : text)
    if (c == '\n')
      lines.emplace_back();
    else
      lines.back() += c;
  return lines;
}

class RandomProjects : public testing::TestWithParam<unsigned> {};
INSTANTIATE_TEST_SUITE_P(Seeds, RandomProjects, testing::Range(1u, 31u));

// Save, load, save: equal bytes in either encoding and across both, whatever the numbers.
TEST_P(RandomProjects, SaveLoadSaveGivesEqualBytes)
{
  const Project project = test::randomProject(GetParam());
  ASSERT_TRUE(checkProject(project)) << checkProject(project).error().detail;
  const std::string json = toJson(project), cbor = toCbor(project);
  const Result<Project> fromJson = parseProject(json, "p.esm"), fromCbor = parseProject(cbor, "p.esmb");
  ASSERT_TRUE(fromJson) << fromJson.error().detail;
  ASSERT_TRUE(fromCbor) << fromCbor.error().detail;
  EXPECT_EQ(toJson(*fromJson), json);
  EXPECT_EQ(toCbor(*fromJson), cbor);
  EXPECT_EQ(toJson(*fromCbor), json);
  EXPECT_EQ(toCbor(*fromCbor), cbor);
}

// Bytes could be equal and both wrong: the numbers themselves, bit for bit.
TEST_P(RandomProjects, NumbersComeBackBitForBit)
{
  const Project before = test::randomProject(GetParam());
  const Result<Project> after = parseProject(toJson(before), "p.esm");
  ASSERT_TRUE(after) << after.error().detail;
  const auto expectSameBits = [](const auto& a, const auto& b) {
    ASSERT_EQ(a.size(), b.size());
    for (Eigen::Index i = 0; i < a.size(); ++i) {
      EXPECT_EQ(a.data()[i], b.data()[i]);
      EXPECT_EQ(std::signbit(a.data()[i]), std::signbit(b.data()[i]));
    }
  };
  expectSameBits(before.net.restPosition, after->net.restPosition);
  expectSameBits(before.net.initialVelocity, after->net.initialVelocity);
  expectSameBits(before.net.mass, after->net.mass);
  expectSameBits(before.net.massDamping, after->net.massDamping);
  expectSameBits(before.net.stiffness, after->net.stiffness);
  expectSameBits(before.net.viscosity, after->net.viscosity);
  expectSameBits(before.net.lawParameter, after->net.lawParameter);
  expectSameBits(before.net.anchors.point, after->net.anchors.point);
  EXPECT_EQ(before.net.ends, after->net.ends);
  EXPECT_EQ(before.net.triangles, after->net.triangles);
  EXPECT_EQ(before.net.fixed, after->net.fixed);
  EXPECT_EQ(before.net.law, after->net.law);
  EXPECT_EQ(before.net.tensionOnly, after->net.tensionOnly);
  EXPECT_EQ(before.net.kind, after->net.kind);
  EXPECT_EQ(before.net.nodeId, after->net.nodeId);
  EXPECT_EQ(before.net.springId, after->net.springId);
  EXPECT_EQ(before.net.tables, after->net.tables);
  EXPECT_EQ(before.tissue.rules, after->tissue.rules);
  EXPECT_EQ(before.tissue.inputs, after->tissue.inputs);
  EXPECT_EQ(before.parametersFromTissue, after->parametersFromTissue);
  ASSERT_EQ(before.tissue.regions.size(), after->tissue.regions.size());
  for (std::size_t i = 0; i < before.tissue.regions.size(); ++i) {
    const Region &a = before.tissue.regions[i], &b = after->tissue.regions[i];
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.inputs, b.inputs);
    EXPECT_EQ(a.ellipsoid.rotation.coeffs(), b.ellipsoid.rotation.coeffs());
    EXPECT_EQ(a.falloff, b.falloff);
    EXPECT_EQ(a.enabled, b.enabled);
    EXPECT_EQ(a.profile, b.profile);
    EXPECT_EQ(a.insideOut, b.insideOut);
    EXPECT_EQ(a.mirror, b.mirror);
    EXPECT_EQ(a.locked, b.locked);
    EXPECT_EQ(a.visible, b.visible);
  }
  ASSERT_EQ(before.loads.motions.size(), after->loads.motions.size());
  for (std::size_t i = 0; i < before.loads.motions.size(); ++i) {
    EXPECT_EQ(before.loads.motions[i].nodes, after->loads.motions[i].nodes);
    EXPECT_EQ(before.loads.motions[i].displacement.time, after->loads.motions[i].displacement.time);
    EXPECT_EQ(before.loads.motions[i].release, after->loads.motions[i].release);
  }
  EXPECT_EQ(before.simulation.solver.threads, after->simulation.solver.threads);
  EXPECT_EQ(before.view.showSurface, after->view.showSurface);
  EXPECT_EQ(before.source, after->source);
}

// Regions of former versions had seven keys. One without the newer gifts is still written so, for the older
// program to read, and read back with what it does not say at its default.
TEST(ProjectFile, APlainRegionHasTheKeysOfFormerVersions)
{
  Project project = test::smallProject();
  project.tissue = defaultTissue();
  project.tissue.regions.resize(1);
  Region& region = project.tissue.regions[0];
  region.inputs = project.tissue.inputs;
  const std::string plain = toJson(project);
  for (const char* key : {"\"profile\"", "\"inside_out\"", "\"mirror\"", "\"locked\"", "\"visible\""})
    EXPECT_THAT(plain, Not(HasSubstr(key)));
  const auto read = parseProject(plain, "plain.esm");
  ASSERT_TRUE(read) << read.error().detail;
  EXPECT_EQ(RegionShape(read->tissue.regions[0]), RegionShape(region));
  EXPECT_TRUE(read->tissue.regions[0].visible);

  region.mirror = MirrorPlane{{0, 0, 0}, {0, 0, 2}};
  std::string broken = toJson(project);
  const std::string normal = "\"normal\": [0, 0, 2]";
  ASSERT_THAT(broken, HasSubstr(normal));
  broken.replace(broken.find(normal), normal.size(), "\"normal\": [0, 0, 0]");
  const auto refused = parseProject(broken, "broken.esm");
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().detail, HasSubstr("/regions/0/mirror/normal"));
}

// A file under version control should show what was changed, and only that.
TEST(ProjectFile, OneChangedNumberChangesOneLine)
{
  Project project = test::randomProject(3);
  const auto before = linesOf(toJson(project));
  project.net.restPosition(1, 1) = 0.123456;
  const auto after = linesOf(toJson(project));
  ASSERT_EQ(before.size(), after.size());
  int changed = 0;
  for (std::size_t i = 0; i < before.size(); ++i) changed += before[i] != after[i];
  EXPECT_EQ(changed, 1);
}

TEST(ProjectFile, EqualArraysAreOneNumber)
{
  Project project = test::smallProject();
  project.net.stiffness.setConstant(12.5);
  EXPECT_THAT(toJson(project), HasSubstr("\"stiffness\": 12.5,"));
}

TEST(ProjectFile, FaultsAreNamedWithTheirPlace)
{
  Project project = test::smallProject();
  project.net.stiffness.setLinSpaced(1.0, 8.0);
  const std::string json = toJson(project);
  EXPECT_EQ(messageOf(replaced(json, "\"stiffness\": [1, 2, 3, ", "\"stiffness\": [1, 2, -3, ")),
            "sample.esm: /net/springs/stiffness/2 is -3, it must be >= 0");
  EXPECT_EQ(messageOf(replaced(json, "\"stiffness\": [1, 2, 3, ", "\"stiffness\": [1, 2, \"x\", ")),
            "sample.esm: /net/springs/stiffness/2 is \"x\", it must be a number");
  EXPECT_EQ(messageOf(replaced(json, "\"stiffness\": [1, ", "\"stiffness\": [")),
            "sample.esm: /net/springs/stiffness is a list of 7, it must be a number or a list of 8");
  EXPECT_EQ(messageOf(replaced(json, "\"triangles\": [0, ", "\"triangles\": [5, ")),
            "sample.esm: /geometry/triangles/0 is 5, it must be an integer from 0 to 4");
  EXPECT_EQ(messageOf(replaced(json, "\"view\": ", "\"veiw\": ")),
            "sample.esm: the document has the unknown key \"veiw\"");
  EXPECT_EQ(messageOf(replaced(json, "\"up\": \"z\"", "\"up\": \"x\"")),
            "sample.esm: /source/up is \"x\", it must be one of y, z");
  EXPECT_EQ(messageOf(replaced(json, "\"length\": \"m\"", "\"length\": \"mm\"")),
            "sample.esm: /units/length is \"mm\", it must be one of m");
  EXPECT_EQ(messageOf(replaced(json, "\"inputs\": {\"hardness\": 0.5", "\"inputs\": {\"hardnes\": 0.5")),
            "sample.esm: /inputs/hardnes is no input of the rule base");
  EXPECT_EQ(messageOf(replaced(json, "\"solver\": \"auto\"", "\"solver\": \"euler\"")),
            "sample.esm: the solver \"euler\" is unknown; use auto or a name of `esm solvers`");
  EXPECT_THAT(messageOf(replaced(json, "\"term\": \"soft\"", "\"term\": \"mellow\"")),
              HasSubstr("sample.esm: /rule_base does not hold together: "));
}

// What a later program wrote is not judged by today's rules: the unknown block must not be the complaint.
TEST(ProjectFile, NewerSchemaIsRefusedClearly)
{
  std::string json = toJson(test::smallProject());
  json = replaced(json, "\"schema_version\": 1,", "\"schema_version\": 2, \"surprise\": {},");
  const Result<Project> project = parseProject(json, "sample.esm");
  ASSERT_FALSE(project);
  EXPECT_EQ(project.error().code, ErrorCode::NewerVersion);
  EXPECT_EQ(project.error().detail,
            "sample.esm: the document was written by a newer version of this program (schema "
            "version 2, this program knows 1); open it with that version");
}

TEST(ProjectFile, SavingKeepsThePreviousVersion)
{
  const test::Scratch scratch;
  Project project = test::smallProject();
  for (const char* name : {"p.esm", "p.esmb"}) {
    const auto path = scratch / name;
    project.name = "first";
    ASSERT_TRUE(saveProject(project, path));
    project.name = "second";
    ASSERT_TRUE(saveProject(project, path));
    EXPECT_EQ(loadProject(path)->name, "second");
    EXPECT_EQ(loadProject(path.string() + ".bak")->name, "first");
  }
  EXPECT_EQ(readFile(scratch / "p.esm")->front(), '{');
  EXPECT_NE(readFile(scratch / "p.esmb")->front(), '{');
}

// What could not be opened again is not saved: the former file is worth more.
TEST(ProjectFile, UnsoundProjectsAreNotSaved)
{
  const test::Scratch scratch;
  const auto path = scratch / "p.esm";
  const Project good = test::smallProject();
  ASSERT_TRUE(saveProject(good, path));
  const std::string before = *readFile(path);

  Project nan = good, view = good, load = good, inputs = good;
  nan.net.stiffness[3] = std::nan("");
  view.view.azimuth = std::nan("");
  load.loads.forces.push_back({{99}, {{0.0}, Eigen::Vector3d::Zero()}});
  inputs.tissue.inputs.pop_back();
  for (const Project& bad : {nan, view, load, inputs}) {
    const Status saved = saveProject(bad, path);
    ASSERT_FALSE(saved);
    EXPECT_THAT(saved.error().detail, HasSubstr("not written"));
    EXPECT_EQ(*readFile(path), before);
  }
  EXPECT_THAT(saveProject(view, path).error().detail, HasSubstr("/view/azimuth is not a finite number"));
  EXPECT_EQ(scratch.fileCount(), 1u);
}

// A name may come from anywhere; the file stays JSON.
TEST(ProjectFile, TextThatIsNoUtf8IsReplaced)
{
  Project project = test::smallProject();
  project.name = "Ute\xFFrus";
  const Result<Project> json = parseProject(toJson(project), "p.esm"),
                        cbor = parseProject(toCbor(project), "p.esmb");
  ASSERT_TRUE(json && cbor);
  EXPECT_EQ(json->name, "Ute\xEF\xBF\xBDrus");
  EXPECT_EQ(cbor->name, json->name);
}

} // namespace
} // namespace esm
