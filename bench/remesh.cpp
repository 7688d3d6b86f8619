// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/repair/remesh.h"
#include "bench/runs.h"
#include "bench/sub_benches.h"
#include "core/base/text_number.h"
#include "core/geometry/edge_table.h"
#include "core/geometry/mesh_report.h"
#include "core/geometry/repair/repair.h"
#include "core/geometry/weld.h"

#if defined(ESM_BENCH_MESHOPTIMIZER)
#include <meshoptimizer.h>
#endif

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

namespace esm::bench {
namespace {

constexpr double kRadius = 50.0;

/// A closed bumpy surface: r(d) = 50 (1 + 0.1 sin 4x sin 4y sin 4z) over the directions d = (x, y, z).
double radiusAlong(const Eigen::Vector3d& d)
{
  return kRadius * (1.0 + 0.1 * std::sin(4.0 * d[0]) * std::sin(4.0 * d[1]) * std::sin(4.0 * d[2]));
}

/// A cube's sides cut into n x n squares each and blown up to the surface: 12 n^2 triangles.
Mesh bumpySphere(Index n)
{
  Mesh mesh;
  std::vector<Eigen::Vector3d> points;
  std::vector<Index> corners;
  for (int side = 0; side < 6; ++side) {
    const auto first = static_cast<Index>(points.size());
    const int axis = side / 2;
    const double sign = side % 2 ? 1.0 : -1.0;
    for (Index i = 0; i <= n; ++i)
      for (Index j = 0; j <= n; ++j) {
        Eigen::Vector3d d;
        d[axis] = sign;
        // Equal angles, so that squares in the middle of a side are no larger than at its rim.
        d[(axis + 1) % 3] = sign * std::tan(0.25 * M_PI * (2.0 * i / n - 1.0));
        d[(axis + 2) % 3] = std::tan(0.25 * M_PI * (2.0 * j / n - 1.0));
        if (i == 0 || i == n) d[(axis + 1) % 3] = i == 0 ? -sign : sign; // bit-equal along the cube's edges
        if (j == 0 || j == n) d[(axis + 2) % 3] = j == 0 ? -1.0 : 1.0;
        points.push_back(d);
        if (i == n || j == n) continue;
        const Index a = first + i * (n + 1) + j, b = a + n + 1;
        const bool turn = (i + j) % 2;
        if (turn)
          corners.insert(corners.end(), {a, b, a + 1, b, b + 1, a + 1});
        else
          corners.insert(corners.end(), {a, b, b + 1, a, b + 1, a + 1});
      }
  }
  mesh.position.resize(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d d = points[i].normalized();
    mesh.position.col(static_cast<Eigen::Index>(i)) = radiusAlong(d) * d;
  }
  mesh.triangles =
    Eigen::Map<TriangleMatrix>(corners.data(), 3, static_cast<Eigen::Index>(corners.size() / 3));
  return mesh;
}

struct Quality {
  double rms = 0.0, most = 0.0, aspect = 0.0, lengths = 0.0;
  Index nonManifold = 0;
};

/// Samples by area, fixed seed: how far the triangles are from the surface, along the direction.
Quality qualityOf(const Mesh& mesh, int samples)
{
  std::vector<double> upTo, aspects;
  double sum = 0.0;
  for (Index t = 0; t < mesh.triangleCount(); ++t) {
    const Eigen::Vector3d a = mesh.position.col(mesh.triangles(0, t)),
                          b = mesh.position.col(mesh.triangles(1, t)),
                          c = mesh.position.col(mesh.triangles(2, t));
    const double area = 0.5 * (b - a).cross(c - a).norm();
    const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    aspects.push_back(area > 0.0 ? longest * longest * std::sqrt(3.0) / (4.0 * area) : 1e9); // equilateral: 1
    upTo.push_back(sum += area);
  }
  std::mt19937_64 random(7);
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  Quality quality;
  for (int i = 0; i < samples; ++i) {
    const auto t =
      static_cast<Index>(std::lower_bound(upTo.begin(), upTo.end(), uniform() * sum) - upTo.begin());
    double u = uniform(), v = uniform();
    if (u + v > 1.0) {
      u = 1.0 - u;
      v = 1.0 - v;
    }
    const Eigen::Vector3d p = (1.0 - u - v) * mesh.position.col(mesh.triangles(0, t)) +
                              u * mesh.position.col(mesh.triangles(1, t)) +
                              v * mesh.position.col(mesh.triangles(2, t));
    const double error = std::abs(p.norm() - radiusAlong(p.normalized()));
    quality.rms += error * error;
    quality.most = std::max(quality.most, error);
  }
  quality.rms = std::sqrt(quality.rms / samples);
  const std::size_t p99 = aspects.size() * 99 / 100;
  std::nth_element(aspects.begin(), aspects.begin() + static_cast<std::ptrdiff_t>(p99), aspects.end());
  quality.aspect = aspects[p99];
  const EdgeLengths lengths = edgeLengths(mesh);
  quality.lengths = lengths.longest / lengths.shortest;
  quality.nonManifold = examine(mesh).nonManifoldEdges;
  return quality;
}

#if defined(ESM_BENCH_MESHOPTIMIZER)
Mesh simplifiedByMeshoptimizer(const Mesh& mesh, Index triangles)
{
  std::vector<float> position(static_cast<std::size_t>(mesh.position.size()));
  for (Eigen::Index i = 0; i < mesh.position.size(); ++i)
    position[static_cast<std::size_t>(i)] = static_cast<float>(mesh.position.data()[i]);
  std::vector<unsigned int> corner(static_cast<std::size_t>(mesh.triangles.size()));
  for (Eigen::Index i = 0; i < mesh.triangles.size(); ++i)
    corner[static_cast<std::size_t>(i)] = static_cast<unsigned int>(mesh.triangles.data()[i]);
  const std::size_t count =
    meshopt_simplify(corner.data(), corner.data(), corner.size(), position.data(), position.size() / 3,
                     3 * sizeof(float), static_cast<std::size_t>(3 * triangles), 1.0f, 0, nullptr);
  Mesh simple;
  simple.position = mesh.position;
  simple.triangles.resize(3, static_cast<Eigen::Index>(count / 3));
  for (std::size_t i = 0; i < count; ++i) simple.triangles.data()[i] = static_cast<Index>(corner[i]);
  return simple;
}
#endif

Mesh remeshed(const Mesh& mesh, Index triangles)
{
  Mesh result = mesh;
  RepairOptions options;
  options.triangles = triangles;
  RepairReport report;
  if (const Status status = repairMesh(result, options, report); !status)
    std::fprintf(stderr, "%s\n", status.error().detail.c_str());
  return result;
}

template <class Make>
double measure(const char* method, Index from, Index to, int repeats, double competitor, const Make& make)
{
  std::vector<double> seconds;
  Mesh mesh;
  for (int i = 0; i < repeats; ++i) {
    const double start = cpuSeconds();
    mesh = make();
    seconds.push_back(cpuSeconds() - start);
  }
  const Quality quality = qualityOf(mesh, 400'000);
  const double time = medianTime(seconds);
  std::printf("%s,%d,%d,%d,%s,%s,%s,%s,%s,%s,%d\n", method, static_cast<int>(from), static_cast<int>(to),
              static_cast<int>(mesh.triangleCount()), formatDouble(time, 3).c_str(),
              formatDouble(competitor > 0.0 ? time / competitor : 1.0, 3).c_str(),
              formatDouble(quality.rms, 3).c_str(), formatDouble(quality.most, 3).c_str(),
              formatDouble(quality.aspect, 3).c_str(), formatDouble(quality.lengths, 3).c_str(),
              static_cast<int>(quality.nonManifold));
  std::fflush(stdout);
  return time;
}

} // namespace

int runRemesh(const std::vector<std::string>& words)
{
  const bool quick = isQuick(words);
  Mesh mesh = bumpySphere(quick ? 91 : 289); // 99,372 or 1,002,252 triangles
  weldVertices(mesh, 1e-6);                  // where sides of the cube meet, directions differ by rounding
  std::printf("method,from,wished,to,seconds,times_meshoptimizer,rms_error,max_error,aspect_p99,length_ratio,"
              "nonmanifold\n");
  for (const Index wished : {10'000, 100'000, 1'000}) {
    double competitor = 0.0;
    if (wished >= mesh.triangleCount()) continue;
#if defined(ESM_BENCH_MESHOPTIMIZER)
    competitor = measure("meshoptimizer", mesh.triangleCount(), wished, quick ? 1 : 3, 0.0,
                         [&] { return simplifiedByMeshoptimizer(mesh, wished); });
#endif
    measure("remesh", mesh.triangleCount(), wished, quick ? 1 : 3, competitor,
            [&] { return remeshed(mesh, wished); });
  }
  return 0;
}

} // namespace esm::bench
