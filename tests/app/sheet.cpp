// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/sheet.h"

#include "core/net/net_builder.h"

namespace esm::test {

Mesh sheetMesh(Index n)
{
  Mesh mesh;
  mesh.position.resize(3, n * n);
  for (Index y = 0; y < n; ++y)
    for (Index x = 0; x < n; ++x) mesh.position.col(y * n + x) = Eigen::Vector3d(0.01 * x, 0.01 * y, 0.0);
  mesh.triangles.resize(3, 2 * (n - 1) * (n - 1));
  Index t = 0;
  for (Index y = 0; y + 1 < n; ++y)
    for (Index x = 0; x + 1 < n; ++x) {
      const Index a = y * n + x;
      mesh.triangles.col(t++) << a, a + 1, a + n;
      mesh.triangles.col(t++) << a + 1, a + n + 1, a + n;
    }
  mesh.segments.resize(2, 0);
  return mesh;
}

Project sheetProject(Index n)
{
  Project project;
  project.name = "sheet";
  project.net = buildNet(sheetMesh(n)).value();
  project.tissue = defaultTissue();
  applyTissue(project.tissue, project.net).value();
  return project;
}

} // namespace esm::test
