// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "bench/runs.h"
#include "bench/sub_benches.h"
#include "core/base/text_number.h"
#include "core/project/project_io.h"
#include "core/runtime/sim_runner.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>

namespace esm::bench {
namespace {

constexpr double kPeriod = 1.0 / kFrameRate;
constexpr double kLongestFrame = 0.05; ///< after which SimThread breaks a frame off [s]
constexpr double kPull = 0.01, kPullTime = 0.3, kEnd = 1.5;

/// Processor time of this thread, which waits for those that help it by looking out for them [s].
double threadSeconds()
{
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The window's simulation on a clock of its own, which goes by processor time: a frame takes its period, or as
/// long as it takes.
class HandScene {
public:
  /// @param tolerance  0: as the window has it; else it is kept, whatever that takes.
  explicit HandScene(const Project& project, double tolerance = 0.0) : m_runner(kFrameRate, m_tool, m_contact)
  {
    Loads loads = project.loads;
    loads.motions.clear();
    loads.forces.clear();
    SolverSettings settings = project.simulation.solver;
    if (tolerance > 0.0) settings.tolerance = tolerance;
    m_runner.apply(command::SetQuality{tolerance > 0.0 ? QualityPlan::clockOnly() : QualityPlan{}});
    m_runner.apply(command::Load{1, project.net, std::move(loads), std::move(settings)});
    m_runner.apply(command::Play{});
  }
  void apply(SimCommand&& command) { m_runner.apply(std::move(command)); }
  /// To its end, whatever it takes.
  const Eigen::Matrix3Xd& wholeFrame()
  {
    m_runner.runFrame();
    m_runner.draw(m_picture);
    return m_picture.position;
  }
  /// @return simulated time [s]; `took` receives the processor time, the picture included.
  double frame(double& took)
  {
    const double begin = threadSeconds();
    const double simulated = m_runner.runFrame([&] { return threadSeconds() - begin > kLongestFrame; });
    m_runner.keepTime(threadSeconds() - begin);
    m_runner.draw(m_picture);
    took = threadSeconds() - begin;
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

/// Outermost in x.
Eigen::Index gripOf(const Project& project)
{
  Eigen::Index node = 0;
  project.net.restPosition.row(0).maxCoeff(&node);
  return node;
}

Eigen::Vector3d wayAt(double time)
{
  return {kPull * std::min(1.0, time / kPullTime), 0.0, 0.0};
}

/// How far the window's motion, on a machine that is fast enough, is from one at a tolerance of 1e-3, over the
/// first second of the pull: root of the squares of all nodes and frames over those of the displacements.
double errorOfPull(const Project& project)
{
  HandScene scene(project), exact(project, 1e-3);
  for (int i = 0; i < 60; ++i) scene.wholeFrame(), exact.wholeFrame(); // to rest
  const Eigen::Index node = gripOf(project);
  const Eigen::Matrix3Xd start = exact.wholeFrame();
  scene.wholeFrame();
  const Eigen::Vector3d grip = start.col(node);
  for (HandScene* one : {&scene, &exact})
    one->apply(command::Grab{static_cast<Index>(node), grip, 5.0, kGripRadius});
  double wrong = 0.0, moved = 0.0;
  for (int frame = 1; frame <= 60; ++frame) {
    for (HandScene* one : {&scene, &exact}) one->apply(command::MoveGrab{grip + wayAt(frame * kPeriod)});
    const Eigen::Matrix3Xd& right = exact.wholeFrame();
    wrong += (scene.wholeFrame() - right).squaredNorm();
    moved += (right - start).squaredNorm();
  }
  return std::sqrt(wrong / moved);
}

/// Pulled with the patch around it 10 mm in 0.3 s, held, and let go.
Pull pull(const Project& project)
{
  HandScene scene(project);
  double took = 0.0;
  for (int i = 0; i < 60; ++i) scene.frame(took); // to rest
  const Eigen::Index node = gripOf(project);
  const Eigen::Vector3d grip = scene.picture().position.col(node);
  scene.apply(command::Grab{static_cast<Index>(node), grip, 5.0, kGripRadius});
  Pull result;
  bool hasMoved = false;
  double simulated = 0.0, held = 0.0;
  for (double wall = 0.0; wall < kEnd;) {
    scene.apply(command::MoveGrab{grip + wayAt(wall)});
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
  std::printf("project,nodes,springs,first_ms,longest_ms,factor,release_ms,solver,error\n");
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
    std::printf("%s,%d,%d,%s,%s,%s,%s,%s,%s\n", project->name.c_str(),
                static_cast<int>(project->net.nodeCount()), static_cast<int>(project->net.springCount()),
                milliseconds(median.first).c_str(), milliseconds(median.longest).c_str(),
                formatDouble(median.factor, 3).c_str(), milliseconds(median.release).c_str(),
                median.solver.c_str(), formatDouble(errorOfPull(*project), 2).c_str());
    std::fflush(stdout);
  }
  return 0;
}

} // namespace esm::bench
