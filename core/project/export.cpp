// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/project/export.h"

#include "core/geometry/pair_key.h"
#include "core/project/frame_writers.h"

#include <algorithm>
#include <cstdint>

namespace esm {

namespace {

constexpr FrameFormat kFormats[] = {{".obj", writeObj}, {".ply", writePly},   {".stl", writeStl},
                                    {".glb", writeGlb}, {".gltf", writeGltf}, {".vtu", writeVtu},
                                    {".csv", writeCsv}, {".scn", writeSofa},  {".xsp", writeXsp}};

} // namespace

Status checkFrame(const Frame& frame, const std::filesystem::path& path)
{
  ESM_ASSERT(frame.net && frame.position && frame.position->cols() == frame.net->nodeCount());
  ESM_ASSERT(!frame.velocity || frame.velocity->cols() == frame.net->nodeCount());
  ESM_ASSERT(!frame.tension || frame.tension->size() == frame.net->springCount());
  const auto refuse = [&](const std::string& what) {
    return Error{ErrorCode::Numerics, path.string() + ": not written, " + what + " is not finite"};
  };
  for (Index node = 0; node < frame.net->nodeCount(); ++node)
    if (!frame.position->col(node).allFinite() || (frame.velocity && !frame.velocity->col(node).allFinite()))
      return refuse("the motion of node " + std::to_string(node));
  if (frame.tension && !frame.tension->isFinite().all()) return refuse("a spring's force");
  return {};
}

Eigen::ArrayXd springStrains(const Frame& frame)
{
  const SpringNet& net = *frame.net;
  Eigen::ArrayXd strain = Eigen::ArrayXd::Zero(net.springCount());
  for (Index s = 0; s < net.springCount(); ++s) {
    const double rest = net.restLength[s];
    const double length = (frame.position->col(net.ends(1, s)) - frame.position->col(net.ends(0, s))).norm();
    if (rest > 0.0) strain[s] = (length - rest) / rest;
  }
  return strain;
}

std::vector<Index> springsWithoutTriangle(const SpringNet& net)
{
  std::vector<std::uint64_t> edges;
  edges.reserve(static_cast<std::size_t>(net.triangleCount()) * 3);
  for (Index t = 0; t < net.triangleCount(); ++t)
    for (int k = 0; k < 3; ++k) edges.push_back(pairKey(net.triangles(k, t), net.triangles((k + 1) % 3, t)));
  std::sort(edges.begin(), edges.end());
  std::vector<Index> springs;
  for (Index s = 0; s < net.springCount(); ++s)
    if (!std::binary_search(edges.begin(), edges.end(), pairKey(net.ends(0, s), net.ends(1, s))))
      springs.push_back(s);
  return springs;
}

Status exportFrame(const Frame& frame, const std::filesystem::path& path)
{
  std::string ending = path.extension().string(), known;
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : static_cast<char>(c);
  });
  for (const FrameFormat& format : kFormats) {
    known += std::string(known.empty() ? "" : ", ") + format.ending;
    if (ending != format.ending) continue;
    if (const Status status = checkFrame(frame, path); !status) return status;
    return format.write(frame, path);
  }
  return Error{ErrorCode::Unsupported,
               path.string() + ": cannot be written in this format; the ending must be one of " + known};
}

} // namespace esm
