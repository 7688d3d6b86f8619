// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/runtime/sim_thread.h"

#include "core/runtime/coalesce.h"
#include "core/runtime/command_queue.h"
#include "core/runtime/frame_clock.h"
#include "core/runtime/sim_runner.h"

#include <algorithm>
#include <atomic>
#include <ctime>
#include <exception>
#include <thread>
#include <vector>

namespace esm {

namespace {

using WallClock = CommandQueue<SimCommand>::Clock;

/// A frame that is not done after this long ends where it is [s]: then the picture still moves, a command is
/// obeyed soon, and the hand's model does not come late (for the servo it does after 100 ms).
constexpr double kLongestFrame = 0.05;
/// So long may one be whose steps are dearer than that, if nobody wants anything meanwhile [s].
constexpr double kLongestStep = 10.0;

double seconds(WallClock::time_point time)
{
  return std::chrono::duration<double>(time.time_since_epoch()).count();
}

WallClock::time_point timePoint(double time)
{
  return WallClock::time_point(
    std::chrono::duration_cast<WallClock::duration>(std::chrono::duration<double>(time)));
}

/// Of this thread [s].
double processorTime()
{
  std::timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

} // namespace

void readClock(SimSnapshot& picture, double now) noexcept
{
  const Pace pace = picture.playing ? picture.clock.paceAt(now) : Pace{};
  picture.realTimeFactor = pace.realTimeFactor;
  picture.lag = pace.lag;
  picture.frameTime = pace.frameTime;
  const bool runs = picture.stability != Stability::Idle && picture.stability != Stability::Stopped;
  if (runs && picture.playing && pace.isSlow()) picture.stability = Stability::Slow;
}

NetPicture& NetPicture::operator=(const NetPicture& other)
{
  if (revision != 0 && revision == other.revision) return *this;
  revision = other.revision;
  position = other.position;
  tension = other.tension;
  return *this;
}

struct SimThread::Impl {
  explicit Impl(double frameRate) : runner(frameRate, tool, contact), clock(runner.framePeriod()) {}

  void run(const std::stop_token& stop);
  void waitPaused(const std::stop_token& stop);
  void playFrame(const std::stop_token& stop);
  void obey();
  void runFrame(const std::stop_token& stop);
  void publish();

  TripleBuffer<ToolState> tool;
  TripleBuffer<ContactModel> contact;
  TripleBuffer<SimSnapshot> pictures;
  CommandQueue<SimCommand> commands;
  std::uint64_t lastGeneration = 0; ///< the caller's
  std::atomic<bool> isLetGo{false}; ///< a Release waits: a late frame works for a hand that is gone

  // The simulation thread's
  SimRunner runner;
  FrameClock clock;
  std::vector<SimCommand> batch;
  std::uint64_t sequence = 0;
  double longest = kLongestFrame; ///< that the next frame may take [s]

  std::jthread thread; ///< last: joins before the rest goes
};

void SimThread::Impl::run(const std::stop_token& stop)
{
  while (!stop.stop_requested()) {
    try {
      if (runner.wantsFrame())
        playFrame(stop);
      else
        waitPaused(stop);
    } catch (const std::exception& trouble) { // in practice: no memory for a large net
      runner.stopWith("The simulation had to stop (" + std::string(trouble.what()) +
                      "); load a smaller net or close other programs");
    }
    publish();
  }
}

/// Costs nothing until there is a command.
void SimThread::Impl::waitPaused(const std::stop_token& stop)
{
  commands.waitForNews(stop);
  obey();
  clock.start(seconds(WallClock::now()));
}

void SimThread::Impl::playFrame(const std::stop_token& stop)
{
  commands.sleepUntil(timePoint(clock.deadline()), stop);
  obey();
  if (!stop.stop_requested()) runFrame(stop);
}

void SimThread::Impl::obey()
{
  isLetGo = false;
  commands.take(batch);
  coalesce(batch);
  for (SimCommand& command : batch) runner.apply(std::move(command));
  batch.clear();
  clock.setPeriod(runner.framePeriod());
}

void SimThread::Impl::runFrame(const std::stop_token& stop)
{
  const double before = processorTime(), begin = seconds(WallClock::now());
  const double simulated = runner.runFrame([&] {
    const double passed = seconds(WallClock::now()) - begin;
    return stop.stop_requested() || passed >= longest || (passed >= kLongestFrame && commands.hasNews()) ||
           (passed >= runner.framePeriod() && isLetGo);
  });
  const double end = seconds(WallClock::now());
  longest = simulated > 0.0 ? kLongestFrame : std::min(2.0 * longest, kLongestStep);
  clock.endFrame(end, simulated, processorTime() - before);
  runner.keepTime(end - begin);
}

void SimThread::Impl::publish()
{
  SimSnapshot& picture = pictures.back();
  runner.draw(picture);
  picture.sequence = ++sequence;
  picture.clock = clock;
  picture.frameCost = runner.playing() ? clock.frameCost() : 0.0;
  readClock(picture, seconds(WallClock::now()));
  pictures.publish();
}

SimThread::SimThread(double frameRate) : m_impl(std::make_unique<Impl>(frameRate))
{
  m_impl->thread = std::jthread([impl = m_impl.get()](const std::stop_token& stop) { impl->run(stop); });
}

SimThread::~SimThread() = default;

std::uint64_t SimThread::load(SpringNet net, Loads loads, SolverSettings settings)
{
  const std::uint64_t generation = ++m_impl->lastGeneration;
  m_impl->commands.push(command::Load{generation, std::move(net), std::move(loads), std::move(settings)});
  return generation;
}

void SimThread::setParameters(SpringNet net)
{
  m_impl->commands.push(command::SetParameters{std::move(net)});
}

void SimThread::setParameters(std::shared_ptr<const ParameterPatch> patch)
{
  m_impl->commands.push(command::PatchParameters{{std::move(patch)}});
}

void SimThread::play()
{
  m_impl->commands.push(command::Play{});
}

void SimThread::pause()
{
  m_impl->commands.push(command::Pause{});
}

void SimThread::stepOnce()
{
  m_impl->commands.push(command::StepOnce{});
}

void SimThread::reset()
{
  m_impl->commands.push(command::Reset{});
}

void SimThread::setFrameRate(double framesPerSecond)
{
  m_impl->commands.push(command::SetFrameRate{framesPerSecond});
}

void SimThread::setQuality(QualityPlan plan)
{
  m_impl->commands.push(command::SetQuality{std::move(plan)});
}

void SimThread::grab(Index node, const Eigen::Vector3d& target, double maxForce, double radius)
{
  m_impl->commands.push(command::Grab{node, target, maxForce, radius});
}

void SimThread::moveGrab(const Eigen::Vector3d& target)
{
  m_impl->commands.push(command::MoveGrab{target});
}

void SimThread::release()
{
  m_impl->isLetGo = true; // first: taken too early it is only heard later
  m_impl->commands.push(command::Release{});
}

void SimThread::followDevice(bool on)
{
  m_impl->commands.push(command::FollowDevice{on});
}

void SimThread::touch(bool on, double radius, double maxForce)
{
  m_impl->commands.push(command::Touch{on, radius, maxForce});
}

const SimSnapshot& SimThread::latest()
{
  return m_impl->pictures.latest();
}

double SimThread::now() noexcept
{
  return seconds(WallClock::now());
}

TripleBuffer<ToolState>& SimThread::toolInput() noexcept
{
  return m_impl->tool;
}

TripleBuffer<ContactModel>& SimThread::contactOutput() noexcept
{
  return m_impl->contact;
}

} // namespace esm
