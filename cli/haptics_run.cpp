// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "cli/haptics.h"

#include "core/base/json_line.h"
#include "core/base/text_number.h"
#include "core/project/project_io.h"
#include "core/runtime/sim_thread.h"
#include "haptics/device_registry.h"
#include "haptics/exit_guard.h"
#include "haptics/hand_path.h"
#include "haptics/haptic_session.h"
#include "haptics/replay/true_force.h"
#include "haptics/simulated_device.h"
#include "haptics/trace_log.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <optional>
#include <thread>
#include <vector>

namespace esm::cli {

namespace {

constexpr double kDefaultLimit = 5.0, kDefaultFrames = 60.0, kDefaultSeconds = 5.0;

/// What the ticks told, and the file that they go to meanwhile, if any.
struct Recording {
  void take()
  {
    for (const TraceSample& tick : ticks) {
      if (count++ == 0) start = tick.time;
      largestForce = std::max(largestForce, tick.force.norm());
      work = tick.work;
      duration = tick.time - start;
    }
    if (log) log->add(ticks);
    ticks.clear();
  }
  Status finish() { return log ? log->finish() : Status{}; }

  std::optional<TraceLog> log;
  std::vector<TraceSample> ticks; ///< not taken yet
  std::int64_t count = 0;
  double start = 0.0, duration = 0.0, largestForce = 0.0, work = 0.0;
};

/// @param file empty: none.
Status logTo(Recording& recording, const std::string& file, TraceLog::Columns columns)
{
  if (file.empty()) return {};
  Result<TraceLog> log = TraceLog::create(file, columns);
  if (!log) return log.error();
  recording.log.emplace(std::move(*log));
  return {};
}

JsonLine jsonOf(const JitterCounts& jitter)
{
  JsonLine line;
  line.add("ticks", jitter.ticks);
  line.add("missed", jitter.missed);
  line.add("p50", jitter.percentile(0.5));
  line.add("p99", jitter.percentile(0.99));
  line.add("p999", jitter.percentile(0.999));
  line.add("worst", jitter.worst);
  return line;
}

std::string microseconds(double time)
{
  return formatDouble(1e6 * time, 3) + " us";
}

/// The user's device, or a simulated one that a path leads.
Result<std::unique_ptr<HapticDevice>> deviceFor(const HapticRunOptions& options, Eigen::Vector3d& hand)
{
  if (options.path.empty()) return openDevice(options.device, options.own);
  if (options.device != "simulated")
    return Error{ErrorCode::InvalidValue, "--path leads the simulated device; '" + options.device +
                                            "' is led by a hand; leave out one of the two"};
  Result<HandPath> path = readHandPath(options.path);
  if (!path) return path.error();
  hand = path->position.col(0);
  return std::unique_ptr<HapticDevice>(std::make_unique<SimulatedDevice>(
    SimulatedDeviceSettings{}, std::make_unique<RecordedHand>(std::move(*path))));
}

/// Until the time is over or somebody wants the program to end.
void waitWhile(HapticSession& session, double seconds, Recording& recording)
{
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  const auto take = [&] {
    session.takeTrace(recording.ticks);
    recording.take();
  };
  while (Clock::now() < end && !ExitGuard::requested()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    take();
  }
  if (ExitGuard::requested()) // the servo lets the force fall by itself; its last ticks belong to the record
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
  take();
}

void endAsAsked()
{
  if (const int signal = ExitGuard::signal(); signal != 0) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
}

} // namespace

Exit runDevice(const HapticRunOptions& options)
{
  const ExitGuard guard;
  Eigen::Vector3d hand = Eigen::Vector3d::Zero();
  Recording recording;
  SimThread simulation(options.frameRate.value_or(kDefaultFrames));
  if (!options.project.empty()) {
    Result<Project> project = loadProject(options.project);
    if (!project) return fail(project.error());
    simulation.load(std::move(project->net), std::move(project->loads),
                    std::move(project->simulation.solver));
    simulation.setQuality({});
  }
  Result<std::unique_ptr<HapticDevice>> device = deviceFor(options, hand);
  if (!device) return fail(device.error());
  if (const Status open = logTo(recording, options.csv, TraceLog::Columns::All); !open)
    return fail(open.error());
  auto session = HapticSession::start(std::move(*device), simulation.toolInput(), simulation.contactOutput());
  if (!session) return fail(session.error());
  const double limit = options.forceLimit.value_or(kDefaultLimit);
  (*session)->setForceLimit(limit);
  (*session)->setForceScale(options.gain.value_or(1.0));
  if (!options.project.empty()) {
    if (options.node)
      simulation.grab(*options.node, hand, limit);
    else
      simulation.touch(true, options.radius, limit);
    simulation.followDevice(true);
    simulation.play();
  }
  if (options.arm) (*session)->arm();
  waitWhile(**session, options.seconds.value_or(kDefaultSeconds), recording);
  const HapticStatus status = (*session)->status();
  const JitterCounts jitter = (*session)->jitter();
  session->reset(); // zero force, whatever comes now
  if (const Status written = recording.finish(); !written) return fail(written.error());
  if (options.json) {
    JsonLine line;
    line.add("device", status.device);
    line.add("priority", status.priority);
    line.add("rate", status.rate);
    line.add("largest_force", recording.largestForce);
    line.add("reason", status.reason);
    line.add("lateness", jsonOf(jitter));
    print(line.text());
  } else {
    print(status.device + ": " + std::to_string(jitter.ticks) + " ticks (" + std::to_string(jitter.missed) +
          " missed) at " + status.priority + " priority, largest force " +
          formatDouble(recording.largestForce, 3) + " N");
    print("late by " + microseconds(jitter.percentile(0.5)) + " (half), " +
          microseconds(jitter.percentile(0.99)) + " (99 %), " + microseconds(jitter.percentile(0.999)) +
          " (99.9 %), " + microseconds(jitter.worst) + " (worst)");
    if (!status.reason.empty()) print(status.reason);
  }
  endAsAsked();
  return Exit::Done;
}

Exit recordPath(const HapticRunOptions& options)
{
  const ExitGuard guard;
  TripleBuffer<ToolState> tool;
  TripleBuffer<ContactModel> contact;
  auto session = HapticSession::open(options.device, tool, contact, options.own);
  if (!session) return fail(session.error());
  Recording recording;
  if (const Status open = logTo(recording, options.output, TraceLog::Columns::Path); !open)
    return fail(open.error());
  waitWhile(**session, options.seconds.value_or(kDefaultSeconds), recording);
  session->reset();
  if (recording.count == 0)
    return fail(
      {ErrorCode::EmptyResult, "the device '" + options.device + "' told no position; is it homed?"});
  if (const Status written = recording.finish(); !written) return fail(written.error());
  say(std::to_string(recording.count) + " positions in " + formatDouble(recording.duration, 3) + " s");
  endAsAsked();
  return Exit::Done;
}

namespace {

Result<ReplayDevice> replayDevice(const std::string& name)
{
  if (name == "simulated") return ReplayDevice::Simulated;
  if (name == "falcon") return ReplayDevice::Falcon;
  return Error{ErrorCode::InvalidValue,
               "a path cannot lead '" + name + "'; those that can be led are: simulated, falcon"};
}

/// What is to be played, as the user says.
Result<ReplayScene> sceneFor(const HapticRunOptions& options)
{
  Result<Project> project = loadProject(options.project);
  if (!project) return project.error();
  if (options.node && *options.node >= project->net.nodeCount())
    return Error{ErrorCode::InvalidValue, "there is no node " + std::to_string(*options.node) +
                                            "; the net has " + std::to_string(project->net.nodeCount())};
  ReplayScene scene{std::move(project->net), std::move(project->loads), std::move(project->simulation.solver),
                    std::nullopt};
  if (options.node) scene.node = *options.node;
  scene.tipRadius = options.radius;
  scene.toolLimit = options.forceLimit.value_or(kDefaultLimit);
  return scene;
}

} // namespace

Exit replayPath(const HapticRunOptions& options)
{
  Result<HandPath> path = readHandPath(options.path);
  if (!path) return fail(path.error());
  const Result<ReplayDevice> device = replayDevice(options.device);
  if (!device) return fail(device.error());
  const Result<ReplayScene> scene = sceneFor(options);
  if (!scene) return fail(scene.error());
  const double seconds = options.seconds.value_or(path->duration());
  auto replay = Replay::create(*scene, std::move(*path), *device, options.frameRate.value_or(kDefaultFrames));
  if (!replay) return fail(replay.error());
  Replay& play = **replay;
  const double scale = options.gain.value_or(1.0);
  play.servo().setForceLimit(options.forceLimit.value_or(kDefaultLimit));
  play.servo().setForceScale(scale);
  play.arm();
  Recording recording;
  if (const Status open = logTo(recording, options.csv, TraceLog::Columns::All); !open)
    return fail(open.error());
  std::vector<ReplayTick> ticks;
  while (play.now() < seconds - 0.5 * play.loop().device().profile().period) {
    if (options.stopAfter && play.now() > *options.stopAfter) play.killSimulation();
    play.tick();
    play.servo().trace().takeNew(recording.ticks);
    recording.take();
    ticks.push_back(play.last());
  }
  if (const Status written = recording.finish(); !written) return fail(written.error());
  const ServoStatus status = play.servo().status();
  SimSnapshot picture;
  play.simulation().draw(picture);
  JsonLine line;
  line.add("device", options.device);
  line.add("ticks", std::ssize(ticks));
  line.add("largest_force", recording.largestForce);
  line.add("force", status.force);
  line.add("work", recording.work);
  line.add("generated", status.generated);
  line.add("tip", picture.tipPosition);
  line.add("touches", picture.tipTouches);
  line.add("reason", reasonText(status.reason));
  line.add("simulation", picture.message);
  std::string said = std::to_string(ticks.size()) + " ticks, largest force " +
                     formatDouble(recording.largestForce, 3) + " N, at the end " +
                     formatDouble(status.force.norm(), 3) + " N";
  if (options.compare) {
    const Result<Eigen::Matrix3Xd> truth = trueForce(*scene, ticks);
    if (!truth) return fail(truth.error());
    const ForceError error = forceError(ticks, *truth, scale);
    line.add("true_peak", error.peak);
    line.add("error_most", error.most);
    line.add("error_rms", error.rms);
    said += "\nagainst the force at 5 kHz (" + formatDouble(error.peak, 3) + " N at most): off by " +
            formatDouble(100.0 * error.most, 3) + " % at most, " + formatDouble(100.0 * error.rms, 3) +
            " % root mean square";
  }
  print(options.json ? line.text() : said);
  if (!options.json && status.reason != ServoReason::Plain) print(reasonText(status.reason));
  return Exit::Done;
}

} // namespace esm::cli
