// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "bench/runs.h"
#include "bench/sub_benches.h"
#include "core/base/text_number.h"
#include "core/project/project_io.h"
#include "core/runtime/sim_runner.h"
#include "core/runtime/sim_thread.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <memory>
#include <thread>
#include <utility>

namespace esm::bench {
namespace {

constexpr double kPeriod = 1.0 / kFrameRate;
constexpr double kLongestFrame = 0.05; ///< after which SimThread breaks a frame off [s]
constexpr double kMoved = 1e-5;        ///< what is seen of a node [m]
constexpr int kPullFrames = 18;
constexpr double kPull = 0.01, kPullTime = kPullFrames * kPeriod, kEnd = 1.5;

/// Processor time of this thread, which waits for those that help it by looking out for them [s].
double threadSeconds()
{
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Loads loadsOfHand(const Project& project)
{
  Loads loads = project.loads;
  loads.motions.clear();
  loads.forces.clear();
  return loads;
}

/// The window's simulation on a clock of its own, which goes by processor time: a frame takes its period, or as
/// long as it takes.
class HandScene {
public:
  /// @param tolerance  0: as the window has it; else it is kept, whatever that takes.
  explicit HandScene(const Project& project, double tolerance = 0.0) : m_runner(kFrameRate, m_tool, m_contact)
  {
    SolverSettings settings = project.simulation.solver;
    if (tolerance > 0.0) settings.tolerance = tolerance;
    m_runner.apply(command::SetQuality{tolerance > 0.0 ? QualityPlan::clockOnly() : QualityPlan{}});
    m_runner.apply(command::Load{1, project.net, loadsOfHand(project), std::move(settings)});
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
  double release = 0.0; ///< the picture after it [s]
  double closing = 0.0; ///< while it is held and moves, through the thread only [s]
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

/// How far the window's motion, on a machine that is fast enough, is from one at a tolerance of 1e-3 over the
/// first second of the pull.
struct PullError {
  double all = 0.0;  ///< root of the squares of all nodes and frames over those of the displacements
  double told = 0.0; ///< the same as the window tells it
  double near =
    0.0; ///< RMS of the nodes within two radii of the grip over the hand's way, in the worst frame
  double passes = 0.0; ///< force passes a frame while the hand moves
};

PullError errorOfPull(const Project& project)
{
  HandScene scene(project), exact(project, 1e-3);
  for (int i = 0; i < 60; ++i) scene.wholeFrame(), exact.wholeFrame(); // to rest
  const Eigen::Index node = gripOf(project);
  const Eigen::Matrix3Xd start = exact.wholeFrame();
  scene.wholeFrame();
  const Eigen::Vector3d grip = start.col(node);
  for (HandScene* one : {&scene, &exact})
    one->apply(command::Grab{static_cast<Index>(node), grip, 5.0, kGripRadius});
  std::vector<Eigen::Index> around;
  for (Eigen::Index i = 0; i < start.cols(); ++i)
    if ((start.col(i) - grip).norm() < 2.0 * kGripRadius) around.push_back(i);
  double wrong = 0.0, moved = 0.0;
  std::int64_t evaluated = 0;
  PullError error;
  for (int frame = 1; frame <= 60; ++frame) {
    for (HandScene* one : {&scene, &exact}) one->apply(command::MoveGrab{grip + wayAt(frame * kPeriod)});
    const Eigen::Matrix3Xd& right = exact.wholeFrame();
    const Eigen::Matrix3Xd apart = scene.wholeFrame() - right;
    wrong += apart.squaredNorm();
    moved += (right - start).squaredNorm();
    if (frame <= kPullFrames) evaluated += scene.picture().report.springsEvaluated;
    double squares = 0.0;
    for (const Eigen::Index i : around) squares += apart.col(i).squaredNorm();
    error.near = std::max(error.near, std::sqrt(squares / static_cast<double>(around.size())) /
                                        wayAt(frame * kPeriod).norm());
  }
  error.passes =
    static_cast<double>(evaluated) / static_cast<double>(project.net.springCount()) / kPullFrames;
  error.all = std::sqrt(wrong / moved);
  error.told = scene.picture().toldError;
  return error;
}

/// Force passes a frame that plain steps at their limit take where no hand holds the net.
double passesOfFreeNet(const Project& project)
{
  SolverSettings settings;
  settings.solver = "leapfrog";
  Result<Simulation> simulation = Simulation::create(project.net, {}, settings);
  return simulation ? kPeriod / simulation->stableStep() : std::nan("");
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
    hasMoved = hasMoved || (scene.picture().position.col(node) - grip).norm() > kMoved;
    if (wall < 0.5 * kPullTime || result.solver.empty()) result.solver = scene.picture().solver;
    if (wall > kPullTime) simulated += moved, held += passed;
  }
  result.factor = simulated / held;
  scene.apply(command::Release{});
  scene.frame(result.release);
  return result;
}

/// The same as the window has it, on the wall clock: the thread, its commands and its pictures.
Pull pullThroughThread(const Project& project)
{
  const auto pause = [] { std::this_thread::sleep_for(std::chrono::milliseconds(1)); };
  auto thread = std::make_unique<SimThread>(kFrameRate);
  thread->setQuality(QualityPlan{});
  thread->load(project.net, loadsOfHand(project), project.simulation.solver);
  thread->play();
  while (thread->latest().time < 1.0) pause(); // to rest
  const Eigen::Index node = gripOf(project);
  const Eigen::Vector3d grip = thread->latest().position.col(node);
  Pull result;
  std::uint64_t sequence = thread->latest().sequence;
  const double begin = SimThread::now();
  double last = begin, heldFrom = 0.0, simulatedFrom = 0.0;
  thread->grab(static_cast<Index>(node), grip, 5.0, kGripRadius);
  for (double now = begin; now < begin + kEnd; now = SimThread::now()) {
    thread->moveGrab(grip + wayAt(now - begin));
    pause();
    const SimSnapshot& picture = thread->latest();
    if (picture.sequence == sequence) continue;
    now = SimThread::now();
    sequence = picture.sequence;
    result.longest = std::max(result.longest, now - std::exchange(last, now));
    if (result.first == 0.0 && (picture.position.col(node) - grip).norm() > kMoved)
      result.first = now - begin;
    if (now < begin + 0.5 * kPullTime || result.solver.empty()) result.solver = picture.solver;
    if (heldFrom > 0.0)
      result.factor = (picture.time - simulatedFrom) / (now - heldFrom);
    else if (now > begin + kPullTime)
      heldFrom = now, simulatedFrom = picture.time;
  }
  const double released = SimThread::now();
  thread->release();
  while (thread->latest().grabbedNode != kNoIndex) pause();
  result.release = SimThread::now() - released;
  thread->grab(static_cast<Index>(node), grip + wayAt(kPullTime), 5.0, kGripRadius);
  while (thread->latest().grabbedNode == kNoIndex) pause();
  const double closed = SimThread::now();
  thread.reset();
  result.closing = SimThread::now() - closed;
  return result;
}

std::string medianOf(const std::vector<Pull>& pulls, double Pull::*figure, double scale)
{
  std::vector<double> all;
  for (const Pull& pull : pulls) all.push_back(pull.*figure);
  std::sort(all.begin(), all.end());
  return formatDouble(scale * all[all.size() / 2], 3);
}

} // namespace

/// Medians of five. @param words  projects, after "--thread" for the wall clock instead of processor time
int runHand(const std::vector<std::string>& words)
{
  const bool byThread = !words.empty() && words.front() == "--thread";
  std::printf("project,nodes,springs,first_ms,longest_ms,factor,release_ms,closing_ms,solver,error,told,near,"
              "passes,free_passes\n");
  for (std::size_t i = byThread ? 1 : 0; i < words.size(); ++i) {
    const Result<Project> project = loadProject(words[i]);
    if (!project) {
      std::fprintf(stderr, "%s\n", project.error().detail.c_str());
      return 1;
    }
    std::vector<Pull> pulls;
    for (int repeat = 0; repeat < 5; ++repeat)
      pulls.push_back(byThread ? pullThroughThread(*project) : pull(*project));
    const PullError error = errorOfPull(*project);
    std::printf("%s,%d,%d,%s,%s,%s,%s,%s,%s,%s,%s,%s,%s,%s\n", project->name.c_str(),
                static_cast<int>(project->net.nodeCount()), static_cast<int>(project->net.springCount()),
                medianOf(pulls, &Pull::first, 1e3).c_str(), medianOf(pulls, &Pull::longest, 1e3).c_str(),
                medianOf(pulls, &Pull::factor, 1.0).c_str(), medianOf(pulls, &Pull::release, 1e3).c_str(),
                medianOf(pulls, &Pull::closing, 1e3).c_str(), pulls.front().solver.c_str(),
                formatDouble(error.all, 2).c_str(), formatDouble(error.told, 2).c_str(),
                formatDouble(error.near, 2).c_str(), formatDouble(error.passes, 3).c_str(),
                formatDouble(passesOfFreeNet(*project), 3).c_str());
    std::fflush(stdout);
  }
  return 0;
}

} // namespace esm::bench
