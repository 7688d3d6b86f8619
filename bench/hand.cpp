// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "bench/runs.h"
#include "bench/sub_benches.h"
#include "core/base/text_number.h"
#include "core/project/project_io.h"
#include "core/runtime/sim_runner.h"

#include <algorithm>
#include <cstdio>

namespace esm::bench {
namespace {

constexpr double kPeriod = 1.0 / kFrameRate;
constexpr double kLongestFrame = 0.05; ///< after which SimThread breaks a frame off [s]
constexpr double kPull = 0.01, kPullTime = 0.3, kEnd = 1.5;

/// The window's simulation on a clock of its own, which goes by processor time: a frame takes its period, or as
/// long as it takes.
class HandScene {
public:
  explicit HandScene(const Project& project) : m_runner(kFrameRate, m_tool, m_contact)
  {
    Loads loads = project.loads;
    loads.motions.clear();
    loads.forces.clear();
    m_runner.apply(command::SetQuality{QualityPlan{}});
    m_runner.apply(command::Load{1, project.net, std::move(loads), project.simulation.solver});
    m_runner.apply(command::Play{});
  }
  void apply(SimCommand&& command) { m_runner.apply(std::move(command)); }
  /// @return simulated time [s]; `took` receives the processor time, the picture included.
  double frame(double& took)
  {
    const double begin = cpuSeconds();
    const double simulated = m_runner.runFrame([&] { return cpuSeconds() - begin > kLongestFrame; });
    m_runner.keepTime(cpuSeconds() - begin);
    m_runner.draw(m_picture);
    took = cpuSeconds() - begin;
    return simulated;
  }
  const SimSnapshot& picture() const noexcept { return m_picture; }

private:
  TripleBuffer<ToolState> m_tool;
  TripleBuffer<ContactModel> m_contact;
  SimRunner m_runner;
  SimSnapshot m_picture;
};

struct Pull {
  double first = 0.0;   ///< processor time until a picture has moved [s]
  double longest = 0.0; ///< between two pictures [s]
  double factor = 0.0;  ///< simulated over wall time from kPullTime on
  double release = 0.0; ///< the frame after it [s]
  std::string solver;   ///< in the middle of the pull
};

/// Its outermost node in x is pulled, with the patch around it, 10 mm in 0.3 s, held, and let go.
Pull pull(const Project& project)
{
  HandScene scene(project);
  double took = 0.0;
  for (int i = 0; i < 60; ++i) scene.frame(took); // to rest
  Eigen::Index node = 0;
  project.net.restPosition.row(0).maxCoeff(&node);
  const Eigen::Vector3d grip = scene.picture().position.col(node);
  scene.apply(command::Grab{static_cast<Index>(node), grip, 5.0, kGripRadius});
  Pull result;
  bool hasMoved = false;
  double simulated = 0.0, held = 0.0;
  for (double wall = 0.0; wall < kEnd;) {
    const double way = kPull * std::min(1.0, wall / kPullTime);
    scene.apply(command::MoveGrab{grip + Eigen::Vector3d(way, 0, 0)});
    const double moved = scene.frame(took), passed = std::max(took, kPeriod);
    wall += passed;
    result.longest = std::max(result.longest, took);
    if (!hasMoved) result.first += took;
    hasMoved = hasMoved || (scene.picture().position.col(node) - grip).norm() > 1e-5;
    if (wall < 0.5 * kPullTime || result.solver.empty()) result.solver = scene.picture().solver;
    if (wall > kPullTime) simulated += moved, held += passed;
  }
  result.factor = simulated / held;
  scene.apply(command::Release{});
  scene.frame(result.release);
  return result;
}

} // namespace

int runHand(const std::vector<std::string>& words)
{
  std::printf("project,nodes,springs,first_ms,longest_ms,factor,release_ms,solver\n");
  const auto milliseconds = [](double seconds) { return formatDouble(1e3 * seconds, 3); };
  for (const std::string& word : words) {
    const Result<Project> project = loadProject(word);
    if (!project) {
      std::fprintf(stderr, "%s\n", project.error().detail.c_str());
      return 1;
    }
    std::vector<Pull> pulls;
    for (int repeat = 0; repeat < 5; ++repeat) pulls.push_back(pull(*project));
    std::sort(pulls.begin(), pulls.end(), [](const Pull& a, const Pull& b) { return a.longest < b.longest; });
    const Pull& median = pulls[pulls.size() / 2];
    std::printf("%s,%d,%d,%s,%s,%s,%s,%s\n", project->name.c_str(),
                static_cast<int>(project->net.nodeCount()), static_cast<int>(project->net.springCount()),
                milliseconds(median.first).c_str(), milliseconds(median.longest).c_str(),
                formatDouble(median.factor, 3).c_str(), milliseconds(median.release).c_str(),
                median.solver.c_str());
    std::fflush(stdout);
  }
  return 0;
}

} // namespace esm::bench
