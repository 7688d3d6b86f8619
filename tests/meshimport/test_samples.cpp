// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/net/net_builder.h"
#include "tests/meshimport/import_bytes.h"

#include <nlohmann/json.hpp>

#include <fstream>

namespace {

using namespace esm;
using esm::test::kSamples;

nlohmann::json counts()
{
  std::ifstream file(kSamples / "counts.json");
  return nlohmann::json::parse(file);
}

TEST(Samples, theReportIsWhatTheSampleScriptCountedByItself)
{
  const nlohmann::json all = counts();
  ASSERT_EQ(all.size(), 3u);
  for (const auto& [name, expected] : all.items()) {
    SCOPED_TRACE(name);
    const Result<ImportedMesh> imported = importMesh(kSamples / name);
    ASSERT_TRUE(imported) << imported.error().detail;
    const MeshReport& report = imported->report;
    EXPECT_EQ(report.nodes, expected["nodes"]);
    EXPECT_EQ(report.springs, expected["springs"]);
    EXPECT_EQ(report.triangles, expected["triangles"]);
    EXPECT_EQ(report.components, expected["components"]);
    EXPECT_EQ(report.isolatedVertices, expected["isolated_vertices"]);
    EXPECT_EQ(report.boundaryEdges, expected["boundary_edges"]);
    EXPECT_EQ(report.nonManifoldEdges, expected["nonmanifold_edges"]);
    EXPECT_EQ(report.degenerateFaces, expected["degenerate_faces"]);
    EXPECT_EQ(report.duplicateFaces, expected["duplicate_faces"]);
    EXPECT_EQ(report.nonFiniteVertices, expected["nonfinite_vertices"]);
    EXPECT_EQ(report.finite, expected["finite"]);
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(report.boxMin[k], expected["bbox_min"][static_cast<std::size_t>(k)]);
      EXPECT_EQ(report.boxMax[k], expected["bbox_max"][static_cast<std::size_t>(k)]);
    }
    // Rounding of a few thousand additions in another order.
    const double sum = sumRestLength(imported->mesh, imported->edges);
    EXPECT_NEAR(sum, expected["sum_rest_length"].get<double>(), 1e-12 * 4000 * sum);
  }
}

TEST(Samples, becomeNetsOfThePapersSizes)
{
  const auto netOf = [](const char* name) {
    Mesh mesh = importMesh(kSamples / name)->mesh;
    toScene(mesh, LengthUnit::Millimetre, UpAxis::Z);
    return *buildNet(mesh);
  };
  const SpringNet tube = netOf("fallopian_tube.obj"), uterus = netOf("uterus.stl"),
                  gallbladder = netOf("gallbladder.obj");
  EXPECT_EQ(tube.nodeCount(), 400);
  EXPECT_NEAR(tube.springCount(), 1200, 24);                         // "about": 2 %
  EXPECT_NEAR(uterus.nodeCount() + uterus.springCount(), 5000, 100); // likewise
  EXPECT_GT(std::count(gallbladder.kind.begin(), gallbladder.kind.end(), SpringKind::Line), 100);
  for (const SpringNet* net : {&tube, &uterus, &gallbladder}) {
    EXPECT_TRUE(checkNet(*net));
    // The shortest spring sets the time step: no sliver may spoil it.
    EXPECT_GT(net->restLength.minCoeff(), 0.25 * net->restLength.mean());
  }
}

} // namespace
