// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "bench/quick.h"

#include "bench/runs.h"
#include "core/base/file_io.h"
#include "core/base/hash.h"
#include "core/base/text_number.h"

#include <algorithm>
#include <cinttypes>
#include <cstdio>
#include <span>
#include <utility>

namespace esm::bench {
namespace {

struct Run {
  const char* solver;
  double step; ///< [s]
  int frames;
};
constexpr Run kRuns[] = {{"leapfrog", 6e-5, 6},     {"chebyshev", 2e-4, 6}, {"stoermer3", 1.5e-4, 6},
                         {"verlet", 4e-5, 6},       {"stoermer", 4e-5, 6},  {"rk4", 4e-5, 6},
                         {"implicit", 1.0 / 120, 3}};

std::string hex(std::uint64_t value)
{
  char text[17];
  std::snprintf(text, sizeof text, "%016" PRIx64, value);
  return text;
}

std::uint64_t hashArray(const Eigen::Matrix3Xd& x, std::uint64_t seed)
{
  return hashBytes(x.data(), sizeof(double) * static_cast<std::size_t>(x.size()), seed);
}

/// The hash of the last positions and velocities, 0 if the run failed; prints a line.
std::uint64_t hashAfter(const Scene& scene, const std::string& solver, double step, int frames)
{
  SolverSettings settings;
  settings.solver = solver;
  settings.fixedStep = step;
  const double start = cpuSeconds();
  Result<Simulation> simulation = Simulation::create(scene.net, scene.loads, settings);
  if (!simulation) return 0;
  StepReport report;
  for (int frame = 0; frame < frames && report.good(); ++frame)
    report.add(simulation->advance(1.0 / kFrameRate));
  const NetState& state = simulation->state();
  const std::uint64_t hash = report.good() ? hashArray(state.velocity, hashArray(state.position, 0)) : 0;
  std::printf("%s,%s,%s,%s,%" PRId64 ",%s\n", scene.name.c_str(), solver.c_str(),
              formatDouble(step, 4).c_str(), formatDouble(cpuSeconds() - start, 4).c_str(),
              report.springsEvaluated, hex(hash).c_str());
  std::fflush(stdout);
  return hash;
}

/// What `auto` is led through, frame by frame.
struct Story {
  const char* name;
  double tolerance;
  bool isPulled = false;  ///< a hand takes a node out and lets it go; meanwhile all springs stiffen
  bool keepsTime = false; ///< with little effort
};
constexpr Story kStories[] = {{"auto 1e-1", 1e-1},
                              {"auto 1e-2", 1e-2},
                              {"auto 1e-3", 1e-3},
                              {"auto 1e-4", 1e-4},
                              {"auto 1e-6", 1e-6},
                              {"auto pulled", 1e-2, true},
                              {"auto pulled in time", 1e-2, true, true}};
constexpr int kStoryFrames = 30, kGrab = 3, kLed = 15, kStiffen = 18, kLetGo = 24;

/// The hand and the slider at the beginning of a frame.
bool lead(Simulation& simulation, const Scene& scene, int frame)
{
  ToolSpring hand;
  hand.node = scene.net.nodeCount() / 2;
  const double way = 1e-3 * std::min(frame - kGrab, kLed - kGrab);
  hand.target = scene.net.restPosition.col(hand.node) + Eigen::Vector3d(0, 0, way);
  hand.stiffness = 3.0 * scene.net.stiffness.mean();
  const bool isHeld = frame >= kGrab && frame < kLetGo;
  simulation.setTools(isHeld ? std::span(&hand, 1) : std::span<const ToolSpring>());
  if (frame != kStiffen) return true;
  SpringNet stiffer = scene.net;
  stiffer.stiffness *= 1.5;
  return bool(simulation.setParameters(stiffer));
}

/// The hash of all that a control decides, frame by frame: steps, work and method, besides the motion; 0 if the
/// run failed.
std::uint64_t hashOfStory(const Scene& scene, const Story& story)
{
  SolverSettings settings;
  settings.tolerance = story.tolerance;
  settings.keepsTime = story.keepsTime;
  if (story.keepsTime) settings.effort = 20.0 * static_cast<double>(scene.net.springCount());
  const double start = cpuSeconds();
  Result<Simulation> simulation = Simulation::create(scene.net, scene.loads, settings);
  if (!simulation) return 0;
  std::uint64_t hash = 0;
  std::int64_t springs = 0;
  for (int frame = 0; frame < kStoryFrames; ++frame) {
    if (story.isPulled && !lead(*simulation, scene, frame)) return 0;
    const StepReport report = simulation->advance(1.0 / kFrameRate);
    if (!report.good()) return 0;
    const std::int64_t counts[] = {report.steps, report.rejectedSteps, report.springsEvaluated,
                                   report.nodesAwake};
    hash = hashBytes(counts, sizeof counts, hash);
    hash = hashBytes(simulation->solverName().data(), simulation->solverName().size(), hash);
    hash = hashArray(simulation->state().velocity, hashArray(simulation->state().position, hash));
    springs += report.springsEvaluated;
  }
  std::printf("%s,%s,,%s,%" PRId64 ",%s\n", scene.name.c_str(), story.name,
              formatDouble(cpuSeconds() - start, 4).c_str(), springs, hex(hash).c_str());
  std::fflush(stdout);
  return hash;
}

/// Rows of the file of golden hashes.
class Golden {
public:
  explicit Golden(std::string file, std::string text) : m_file(std::move(file)), m_text(std::move(text)) {}
  void compare(const std::string& scene, const std::string& run, std::uint64_t hash)
  {
    const bool isKnown =
      m_file.empty() || m_text.find(scene + "," + run + "," + hex(hash) + "\n") != m_text.npos;
    if (hash != 0 && isKnown) return;
    ++m_wrong;
    if (hash == 0)
      std::fprintf(stderr, "%s with %s came to no end\n", scene.c_str(), run.c_str());
    else
      std::fprintf(stderr, "%s with %s ends in state %s, which is not in %s\n", scene.c_str(), run.c_str(),
                   hex(hash).c_str(), m_file.c_str());
  }
  int wrong() const noexcept { return m_wrong; }

private:
  std::string m_file, m_text;
  int m_wrong = 0;
};

} // namespace

int runQuick(const std::string& goldenFile)
{
  std::string text;
  if (!goldenFile.empty()) {
    Result<std::string> read = readFile(goldenFile);
    if (!read) {
      std::fprintf(stderr, "%s\n", read.error().detail.c_str());
      return 1;
    }
    text = std::move(*read);
  }
  Golden golden(goldenFile, std::move(text));
  std::printf("scene,solver,step_s,seconds,springs_evaluated,hash\n");
  for (const Scene& scene : {tube(), uterus(), smallSheet()})
    for (const auto& [solver, step, frames] : kRuns)
      golden.compare(scene.name, solver, hashAfter(scene, solver, step, frames));
  for (const Scene& scene : {tube(), uterus(), smallSheet(), stiff()})
    for (const Story& story : kStories) golden.compare(scene.name, story.name, hashOfStory(scene, story));
  return golden.wrong() == 0 ? 0 : 1;
}

} // namespace esm::bench
