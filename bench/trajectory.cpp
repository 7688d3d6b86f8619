// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "bench/trajectory.h"

#include "bench/reference/plain_net.h"
#include "core/base/file_io.h"
#include "core/base/text_number.h"
#include "core/geometry/extent.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>

namespace esm::bench {
namespace {

/// Goes up when a program that makes references changes its results.
constexpr char kReferenceVersion[] = "1";
constexpr double kWantedAgreement = 2e-8; ///< a fiftieth of the smallest error that is asked for
constexpr double kLongestPlainRun = 4e10; ///< spring evaluations, about ten minutes

Scales scalesOf(const Trajectory& frames)
{
  double displacement = 0.0, speed = 0.0;
  for (std::size_t f = 1; f < frames.size(); ++f) {
    displacement += (frames[f] - frames[0]).squaredNorm();
    speed += (frames[f] - frames[f - 1]).squaredNorm() * kFrameRate * kFrameRate;
  }
  const double count = static_cast<double>(frames[0].cols()) * static_cast<double>(frames.size() - 1);
  return {std::sqrt(displacement / count) + 1e-12, std::sqrt(speed / count) + 1e-9};
}

Trajectory runDormandPrince(const Scene& scene, double tolerance, const Scales& scales, std::int64_t& passes)
{
  FastNet net(scene.net, scene.loads);
  const std::unique_ptr<Method> method = makeDormandPrince();
  method->prepare(net, tolerance, scales);
  Nodes x, v;
  net.start(x, v);
  Trajectory frames(1, scene.net.restPosition);
  for (long frame = 0; frame < scene.frames(); ++frame) {
    const double t0 = static_cast<double>(frame) / kFrameRate,
                 t1 = static_cast<double>(frame + 1) / kFrameRate;
    const bool changed = net.beginFrame(t0, x, v);
    if (!method->frame(net, t0, t1, changed, x, v)) break;
    frames.emplace_back();
    net.positions(x, frames.back());
  }
  passes = net.passes();
  return frames;
}

Trajectory runPlain(const Scene& scene, int stepsPerFrame)
{
  PlainNet net(scene.net, scene.loads);
  Trajectory frames(1);
  net.positions(frames[0]);
  for (long frame = 0; frame < scene.frames(); ++frame) {
    for (int step = 0; step < stepsPerFrame; ++step) net.stepRungeKutta4(1.0 / kFrameRate / stepsPerFrame);
    frames.emplace_back();
    net.positions(frames.back());
  }
  return frames;
}

Reference compute(const Scene& scene)
{
  std::fprintf(stderr, "%s: computing the reference ...\n", scene.name.c_str());
  std::int64_t passes = 0;
  const double extent = extentOf(scene.net.restPosition);
  const Trajectory rough = runDormandPrince(scene, 1e-4, {0.01 * extent, extent}, passes);
  const Scales scales = scalesOf(rough);
  const Trajectory other = runDormandPrince(scene, 3e-8, scales, passes);
  Reference reference;
  // The adaptive run tells how small steps must be: six passes a step.
  const std::int64_t adaptiveSteps = passes / 6 / scene.frames();
  int steps = std::max(8, static_cast<int>(1.4 * static_cast<double>(adaptiveSteps)));
  const double perStep = 4.0 * static_cast<double>(scene.frames()) * scene.net.springCount();
  double before = std::numeric_limits<double>::infinity();
  while (true) {
    reference.frames = runPlain(scene, steps);
    reference.agreement =
      other.size() == reference.frames.size() ? trajectoryError(reference.frames, other) : std::nan("");
    std::fprintf(stderr, "%s: %d steps per frame, the references are %.1e apart\n", scene.name.c_str(), steps,
                 reference.agreement);
    if (reference.agreement < kWantedAgreement || 2 * steps * perStep > kLongestPlainRun) break;
    if (reference.agreement > 0.9 * before) break; // it is the other one that errs
    before = reference.agreement;
    steps *= 2;
  }
  reference.scales = scalesOf(reference.frames);
  return reference;
}

std::string bytesOf(const Reference& reference)
{
  std::string bytes;
  const auto add = [&](const void* data, std::size_t size) {
    bytes.append(static_cast<const char*>(data), size);
  };
  add(&reference.agreement, sizeof(double));
  for (const Eigen::Matrix3Xd& x : reference.frames)
    add(x.data(), sizeof(double) * static_cast<std::size_t>(x.size()));
  return bytes;
}

bool fromBytes(const std::string& bytes, const Scene& scene, Reference& reference)
{
  const auto frames = static_cast<std::size_t>(scene.frames() + 1);
  const std::size_t one = 3 * sizeof(double) * static_cast<std::size_t>(scene.net.nodeCount());
  if (bytes.size() != sizeof(double) + frames * one) return false;
  std::memcpy(&reference.agreement, bytes.data(), sizeof(double));
  for (std::size_t f = 0; f < frames; ++f) {
    reference.frames.emplace_back(3, scene.net.nodeCount());
    std::memcpy(reference.frames.back().data(), bytes.data() + sizeof(double) + f * one, one);
  }
  reference.scales = scalesOf(reference.frames);
  return true;
}

} // namespace

double trajectoryError(const Trajectory& reference, const Trajectory& other)
{
  double error = 0.0, displacement = 0.0;
  for (std::size_t frame = 0; frame < reference.size(); ++frame) {
    error += (other[frame] - reference[frame]).squaredNorm();
    displacement += (reference[frame] - reference[0]).squaredNorm();
  }
  return std::sqrt(error / displacement);
}

ErrorMeter::ErrorMeter(const Reference& reference) : m_reference(reference)
{
  for (const Eigen::Matrix3Xd& x : reference.frames)
    m_displacement += (x - reference.frames[0]).squaredNorm();
}

void ErrorMeter::add(std::size_t frame, const Eigen::Matrix3Xd& x)
{
  m_error += (x - m_reference.frames[frame]).squaredNorm();
  if (!(m_error < 1e4 * m_displacement)) m_lost = true; // true for NaN, too
}

double ErrorMeter::error() const
{
  return std::sqrt(m_error / m_displacement);
}

std::filesystem::path& cacheFolder()
{
  static std::filesystem::path folder = [] {
    if (const char* own = std::getenv("ESM_BENCH_CACHE")) return std::filesystem::path(own);
    if (const char* cache = std::getenv("XDG_CACHE_HOME")) return std::filesystem::path(cache) / "esm-bench";
    const char* home = std::getenv("HOME");
    return std::filesystem::path(home ? home : ".") / ".cache" / "esm-bench";
  }();
  return folder;
}

Reference referenceOf(const Scene& scene)
{
  char name[64];
  std::snprintf(name, sizeof name, "reference-%s-%016llx.f64", kReferenceVersion,
                static_cast<unsigned long long>(hashOf(scene)));
  const std::filesystem::path file = cacheFolder() / name;
  Reference reference;
  std::error_code ignored;
  if (std::filesystem::exists(file, ignored))
    if (const Result<std::string> bytes = readFile(file); bytes && fromBytes(*bytes, scene, reference))
      return reference;
  reference = compute(scene);
  std::filesystem::create_directories(cacheFolder(), ignored);
  if (Status status = writeFileAtomically(file, bytesOf(reference)); !status)
    std::fprintf(stderr, "%s\n", status.error().detail.c_str()); // only slower next time
  return reference;
}

} // namespace esm::bench
