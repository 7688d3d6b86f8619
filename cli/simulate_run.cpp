// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "cli/simulate_run.h"

#include "cli/interrupt_watch.h"
#include "cli/messages.h"
#include "core/base/file_io.h"
#include "core/base/machine_memory.h"
#include "core/base/text_number.h"
#include "core/dynamics/simulation.h"
#include "core/dynamics/tolerance_check.h"
#include "core/project/export.h"
#include "core/project/motion_log_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <set>

namespace esm::cli {

namespace {

/// A prescribed motion that goes further than the net is large in less than a hundredth of a frame, up to `time`.
std::string suddenMotion(const SpringNet& net, const Loads& loads, double time)
{
  constexpr double kSudden = 0.01 / 60.0; // [s]
  const double extent =
    (net.restPosition.rowwise().maxCoeff() - net.restPosition.rowwise().minCoeff()).norm();
  for (const PrescribedMotion& motion : loads.motions) {
    const VectorCurve& curve = motion.displacement;
    for (std::size_t i = 1; i < curve.time.size() && curve.time[i - 1] < time && !motion.nodes.empty(); ++i) {
      const double lasts = curve.time[i] - curve.time[i - 1];
      const auto at = static_cast<Eigen::Index>(i);
      const double way = (curve.value.col(at) - curve.value.col(at - 1)).norm();
      if (lasts < kSudden && way > extent)
        return "node " + std::to_string(motion.nodes.front()) + " is moved by " + formatDouble(way, 3) +
               " m within " + formatDouble(lasts, 3) + " s at " + formatDouble(curve.time[i - 1], 3) + " s";
    }
  }
  return {};
}

/// Adds the processor time that passes in its life to `seconds`.
class ProcessorClock {
public:
  explicit ProcessorClock(double& seconds) : m_seconds(seconds), m_start(now()) {}
  ~ProcessorClock() { m_seconds += now() - m_start; }
  ProcessorClock(const ProcessorClock&) = delete;
  ProcessorClock& operator=(const ProcessorClock&) = delete;

private:
  static double now()
  {
    timespec time = {};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }
  double& m_seconds;
  double m_start;
};

/// Force against time, as a device would feel it: `t,applied_force,reaction_force,displacement`.
///   applied_force   |sum of all nodal forces| [N]
///   reaction_force  |sum of what the supports of fixed and moved nodes exert| [N]
///   displacement    |mean displacement| of the nodes that are pushed or moved [m]
class ForceCurve {
public:
  explicit ForceCurve(const Simulation& simulation) : m_start(simulation.state().position)
  {
    const SpringNet& net = simulation.net();
    for (const NodalForce& force : simulation.loads().forces)
      m_loaded.insert(force.nodes.begin(), force.nodes.end());
    for (const PrescribedMotion& motion : simulation.loads().motions) {
      m_loaded.insert(motion.nodes.begin(), motion.nodes.end());
      m_supported.insert(motion.nodes.begin(), motion.nodes.end());
    }
    for (Index node = 0; node < net.nodeCount(); ++node)
      if (net.fixed[static_cast<std::size_t>(node)]) m_supported.insert(node);
  }

  void add(const Simulation& simulation)
  {
    const NetState& state = simulation.state();
    Eigen::Vector3d applied = Eigen::Vector3d::Zero(), reaction = applied, displacement = applied;
    for (const NodalForce& force : simulation.loads().forces)
      applied += static_cast<double>(force.nodes.size()) * force.force.at(state.time);
    for (const Index node : m_supported) reaction += simulation.reaction(node);
    for (const Index node : m_loaded) displacement += state.position.col(node) - m_start.col(node);
    if (!m_loaded.empty()) displacement /= static_cast<double>(m_loaded.size());
    for (const double value : {state.time, applied.norm(), reaction.norm(), displacement.norm()}) {
      if (m_text.back() != '\n') m_text += ',';
      appendDouble(m_text, value);
    }
    m_text += '\n';
  }

  const std::string& text() const noexcept { return m_text; }

private:
  Eigen::Matrix3Xd m_start;
  std::set<Index> m_loaded, m_supported;
  std::string m_text = "t,applied_force,reaction_force,displacement\n";
};

/// The files of a run, all opened before the first step, so that a bad path costs no computing.
class RunFiles {
public:
  static Result<RunFiles> create(const RunOutputs& outputs, const Simulation& simulation)
  {
    RunFiles files(outputs);
    if (!outputs.motion.empty()) {
      Result<TrajectoryWriter> writer = TrajectoryWriter::create(outputs.motion);
      if (!writer) return writer.error();
      files.m_motion = std::move(*writer);
    }
    if (!outputs.forceCurve.empty()) files.m_curve.emplace(simulation);
    return files;
  }

  Status add(const Simulation& simulation)
  {
    if (m_curve) m_curve->add(simulation);
    return m_motion ? m_motion->addFrame(frameOf(simulation)) : Status{};
  }

  Status finish(const Simulation& simulation)
  {
    Status status;
    if (m_motion) status = m_motion->finish();
    if (status && m_curve) status = writeFileAtomically(m_outputs.forceCurve, m_curve->text());
    if (status && !m_outputs.mesh.empty()) status = exportFrame(frameOf(simulation), m_outputs.mesh);
    return status;
  }

private:
  explicit RunFiles(const RunOutputs& outputs) : m_outputs(outputs) {}

  Frame frameOf(const Simulation& simulation)
  {
    m_tension.resize(simulation.net().springCount());
    simulation.springTensions(m_tension);
    const NetState& state = simulation.state();
    // A net so stiff that its forces overflow still has a shape to show.
    const bool finite = m_tension.isFinite().all();
    return {&simulation.net(), &state.position, &state.velocity, finite ? &m_tension : nullptr, state.time};
  }

  RunOutputs m_outputs;
  std::optional<TrajectoryWriter> m_motion;
  std::optional<ForceCurve> m_curve;
  Eigen::ArrayXd m_tension;
};

/// One run, its files not yet in place.
struct Run {
  std::optional<Simulation> simulation;
  std::optional<RunFiles> files;
  RunSummary summary;
};

/// Runs a project, once or more often; a signal removes what any run has begun to write.
class Runner {
public:
  Runner(const Project& project, const RunOutputs& outputs) : m_project(project), m_outputs(outputs) {}

  /// Fills `run`, whatever it held before. @param check  looks on, or null
  Status compute(Run& run, SpringNet net, SolverSettings solver, const std::string& doing,
                 ToleranceCheck* check);
  /// The coming run is written down. @pre the project still has its net
  Status beginLog()
  {
    SolverSettings settings = m_project.simulation.solver;
    settings.duration = m_project.simulation.duration;
    Result<MotionLogWriter> writer = MotionLogWriter::create(m_outputs.log, m_project, settings);
    if (!writer) return writer.error();
    m_log.emplace(std::move(*writer));
    return {};
  }
  Status endLog() { return m_log ? m_log->finish() : Status{}; }
  /// Its files appear.
  Status finish(Run& run)
  {
    return withFiles([&] { return run.files->finish(*run.simulation); });
  }

  Run& current() noexcept { return m_runs[m_current]; }
  Run& former() noexcept { return m_runs[1 - m_current]; }
  void next() noexcept { m_current = 1 - m_current; }

private:
  /// Holds off the end of the program while files are touched.
  template <class Work>
  Status withFiles(const Work& work)
  {
    const std::lock_guard lock(m_watch.mutex());
    return work();
  }
  Status open(Run& run)
  {
    run.files.reset();
    Result<RunFiles> fresh = RunFiles::create(m_outputs, *run.simulation);
    if (!fresh) return fresh.error();
    run.files.emplace(std::move(*fresh));
    return {};
  }

  Status writeLog()
  {
    if (!m_log) return {};
    Status written = m_log->add(m_entries);
    m_entries.clear();
    return written;
  }

  const Project& m_project;
  const RunOutputs& m_outputs;
  std::optional<MotionLogWriter> m_log;
  MotionLog m_entries;
  std::array<Run, 2> m_runs;
  std::size_t m_current = 0;
  InterruptWatch m_watch{[this] {
    for (Run& run : m_runs) run.files.reset();
  }};
};

Status Runner::compute(Run& run, SpringNet net, SolverSettings solver, const std::string& doing,
                       ToleranceCheck* check)
{
  RunSummary& summary = run.summary = {};
  const auto timed = [&](auto&& work) {
    const ProcessorClock clock(summary.integrationSeconds);
    return work();
  };
  const SimulationSettings& settings = m_project.simulation;
  solver.duration = settings.duration;
  Result<Simulation> created =
    timed([&] { return Simulation::create(std::move(net), m_project.loads, solver); });
  if (!created) return created.error();
  run.simulation.emplace(std::move(*created));
  Simulation& simulation = *run.simulation;
  if (m_log) simulation.record(&m_entries);
  const auto addFrame = [&] {
    return withFiles([&] {
      const Status added = run.files->add(simulation);
      return added ? writeLog() : added;
    });
  };
  if (const Status opened = withFiles([&] { return open(run); }); !opened) return opened.error();

  const long long last = std::llround(settings.duration * settings.frameRate);
  Progress progress(doing);
  if (const Status added = addFrame(); !added) return added.error();
  if (!check && !(solver.fixedStep > 0.0)) timed([&] { simulation.watchGrowth(); });
  if (check) check->start(simulation.state());
  summary.frames = 1;
  summary.nodes = simulation.net().nodeCount();
  summary.springs = simulation.net().springCount();
  summary.nodesAwake = summary.nodes;
  double awake = 0.0;
  while (summary.frames <= last && summary.steps.good()) {
    // From the frame's number, so that rounding does not add up over the frames.
    const double time = static_cast<double>(summary.frames) / settings.frameRate;
    const StepReport step = timed([&] { return simulation.advance(time - simulation.state().time); });
    summary.steps.add(step);
    if (step.rough && summary.roughFrames++ == 0) {
      summary.roughTime = time;
      summary.roughReason = simulation.why();
      summary.suddenMotion = suddenMotion(simulation.net(), m_project.loads, time);
    }
    summary.largestForce = std::max(summary.largestForce, step.largestForce);
    awake += static_cast<double>(step.nodesAwake);
    summary.nodesAwake = awake / static_cast<double>(summary.frames);
    if (!step.good()) break;
    if (check) check->add(simulation.state(), step);
    if (const Status added = addFrame(); !added) return added.error();
    progress.show(summary.frames++, last);
  }
  simulation.record(nullptr);
  if (const Status written = withFiles([&] { return writeLog(); }); !written) return written.error();
  summary.energyOfParts = simulation.islandEnergies();
  for (const EnergyReport& part : summary.energyOfParts) summary.energy += part;
  summary.errorGrowth = simulation.errorGrowth();
  summary.errorGrowthTime = simulation.errorGrowthTime();
  summary.solver = simulation.solverName();
  summary.reason = simulation.why();
  return {};
}

/// Whether a motion can be kept in memory, as runVerified() does.
Status checkMemory(const Project& project)
{
  const double frames = std::round(project.simulation.duration * project.simulation.frameRate) + 1.0;
  const double needed = ToleranceCheck::memory(frames, project.net.nodeCount());
  const double most = 0.5 * static_cast<double>(machineMemory());
  if (needed <= most) return {};
  const auto gigabytes = [](double bytes) { return formatDouble(bytes / 1e9, 3) + " GB"; };
  return Error{ErrorCode::InvalidValue,
               "to verify a motion takes it into memory: " + gigabytes(needed) + ", more than the " +
                 gigabytes(most) + " that are half of this machine's; use less --frames or --duration"};
}

} // namespace

Result<RunSummary> runSimulation(Project& project, const RunOutputs& outputs)
{
  Runner runner(project, outputs);
  Run& run = runner.current();
  Status status = outputs.log.empty() ? Status{} : runner.beginLog();
  if (status)
    status = runner.compute(run, std::move(project.net), project.simulation.solver, "simulating", nullptr);
  if (status) status = runner.endLog();
  if (status) status = runner.finish(run);
  if (!status) return status.error();
  return run.summary;
}

Result<RunSummary> runVerified(const Project& project, const RunOutputs& outputs)
{
  if (const Status fits = checkMemory(project); !fits) return fits.error();
  Runner runner(project, outputs);
  ToleranceCheck check(project.simulation.solver);
  double seconds = 0.0;
  ToleranceCheck::Next next = ToleranceCheck::Next::RunAgain;
  while (ToleranceCheck::isOpen(next)) {
    if (next == ToleranceCheck::Next::RunAgain) runner.next();
    const Status done =
      runner.compute(runner.current(), project.net, check.settings(),
                     "simulating with a tolerance of " + formatDouble(check.settings().tolerance, 3), &check);
    if (!done) return done.error();
    seconds += runner.current().summary.integrationSeconds;
    next = check.endRun(runner.current().summary.steps);
  }
  Run& result = next == ToleranceCheck::Next::TakeThis ? runner.current() : runner.former();
  if (const Status finished = runner.finish(result); !finished) return finished.error();
  seconds -= result.summary.integrationSeconds;
  result.summary.verification = {
    check.kept(), check.measuredError(), check.worstTime(), check.resultTolerance(), seconds, check.why()};
  return result.summary;
}

} // namespace esm::cli
