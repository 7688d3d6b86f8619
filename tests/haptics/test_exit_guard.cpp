// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/exit_guard.h"

#include "haptics/device/driven_device.h"
#include "servo_bench.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <functional>

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>
#include <vector>

#ifdef ESM_SANITIZED
/// A program that calls exit() leaves its servo thread behind on purpose; ThreadSanitizer would end it
/// with 66.
extern "C" const char* __tsan_default_options()
{
  return "report_thread_leaks=0";
}
#endif

namespace esm {

namespace {

/// What a device was sent, in memory that outlives the process that sent it.
struct SentForces {
  std::atomic<int> writes{0}, zerosAtEnd{0};
  std::atomic<double> largest{0.0};
};

/// Keeps its place, and records.
class RecordingDevice final : public HapticDevice {
public:
  explicit RecordingDevice(SentForces& sent, double armTime = 0.01) : m_sent(sent)
  {
    m_profile.armTime = armTime;
  }
  const DeviceProfile& profile() const noexcept override { return m_profile; }
  DeviceLink read(double, DeviceSample& sample) noexcept override
  {
    sample.position.setZero();
    return DeviceLink::Ready;
  }
  bool write(const Eigen::Vector3d& force) noexcept override
  {
    ++m_sent.writes;
    m_sent.zerosAtEnd = force.isZero(0.0) ? m_sent.zerosAtEnd + 1 : 0;
    m_sent.largest = std::max(m_sent.largest.load(), force.norm());
    return true;
  }

private:
  DeviceProfile m_profile;
  SentForces& m_sent;
};

/// Far slower than USB: what it is given leaves 5 ms later.
class SlowDriver final : public DeviceDriver {
public:
  explicit SlowDriver(SentForces& sent) : m_device(sent) { m_state.link = DeviceLink::Ready; }
  const DeviceProfile& profile() const noexcept override { return m_device.profile(); }
  void step(double now, const Eigen::Vector3d& force, bool) noexcept override
  {
    usleep(5000);
    m_state.heard = now + 1.0;
    m_device.write(force);
  }
  void close(double) noexcept override {}
  void sendLastZero() noexcept override { m_device.write(Eigen::Vector3d::Zero()); }

private:
  RecordingDevice m_device;
};

/// A program with 2 N in the hand that comes to an end by `end`.
class ExitGuardTest : public testing::Test {
protected:
  ExitGuardTest()
    : sent(new (mmap(nullptr, sizeof(SentForces), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0))
             SentForces)
  {}
  ~ExitGuardTest() override { munmap(sent, sizeof(SentForces)); }

  [[noreturn]] void runProgram(const std::function<void()>& end)
  {
    const ExitGuard guard;
    TripleBuffer<ToolState> tool;
    TripleBuffer<ContactModel> contact;
    std::unique_ptr<HapticDevice> device = std::make_unique<RecordingDevice>(*sent, armTime);
    if (driven) device = std::make_unique<DrivenDevice>(std::make_unique<SlowDriver>(*sent));
    ServoLoop loop(std::move(device), std::make_unique<SteadyClock>(), tool, contact);
    loop.start();
    for (std::uint64_t i = 1; i < 4000 && sent->largest < enough; ++i) {
      if (i == 20) loop.core().orders().give(ForceOrder::Arm); // the driver has told that it is ready
      contact.back() = i > 100 ? constantForce({2.0, 0.0, 0.0}) : ContactModel{}; // armed without force first
      contact.back().sequence = i;
      contact.publish();
      usleep(5000);
    }
    end();
    for (int i = 0; i < 2000 && sent->zerosAtEnd < 3; ++i) usleep(5000); // the main program hangs, say
    _exit(7);
  }

  /// @return wait status of the program.
  int outcome(const std::function<void()>& end)
  {
    const pid_t child = fork();
    if (child == 0) runProgram(end);
    int status = 0;
    waitpid(child, &status, 0);
    return status;
  }

  SentForces* sent;
  double armTime = 0.01, enough = 1.9; ///< [s]; force at which the end comes [N]
  bool driven = false;                 ///< with a driver in a thread of its own between servo and device
};

} // namespace

TEST_F(ExitGuardTest, SigtermTakesTheForceAwayThoughTheProgramDoesNothing)
{
  const int status = outcome([] { raise(SIGTERM); });
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 7);
  EXPECT_GE(sent->largest, 1.9);
  EXPECT_GE(sent->zerosAtEnd, 3);
}

TEST_F(ExitGuardTest, SigintTellsTheProgramToEnd)
{
  const int status = outcome([] {
    raise(SIGINT);
    std::uint64_t count = 0;
    if (!ExitGuard::requested() || ExitGuard::signal() != SIGINT) _exit(1);
    if (read(ExitGuard::descriptor(), &count, sizeof count) != sizeof count) _exit(2);
  });
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 7);
  EXPECT_GE(sent->zerosAtEnd, 3);
}

TEST_F(ExitGuardTest, AProgramThatTerminatesOrCrashesSendsZeroFirst)
{
  std::vector<std::pair<std::function<void()>, int>> ends = {{[] { std::terminate(); }, SIGABRT}};
#ifndef ESM_SANITIZED // which has handlers of its own for these
  ends.push_back({[] { raise(SIGFPE); }, SIGFPE});
#endif
  for (const auto& [end, signal] : ends) {
    sent->largest = 0.0;
    sent->zerosAtEnd = 0;
    const int status = outcome(end);
    ASSERT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(WTERMSIG(status), signal);
    EXPECT_GE(sent->largest, 1.9);
    EXPECT_GE(sent->zerosAtEnd, 3);
  }
}

TEST_F(ExitGuardTest, SigtermWhileForceFadesInTakesItAway)
{
  armTime = 2.0;
  enough = 0.5;
  const int status = outcome([] { raise(SIGTERM); });
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 7);
  EXPECT_LT(sent->largest, 1.9); // it was still fading in
  EXPECT_GE(sent->zerosAtEnd, 3);
}

TEST_F(ExitGuardTest, AProgramThatCallsExitSendsZeroFirst)
{
  const int status = outcome([] { std::exit(3); });
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 3);
  EXPECT_GE(sent->largest, 1.9);
  EXPECT_GE(sent->zerosAtEnd, 3);
}

// The servo's zero is only on its way when the servo is silent: the driver still has to send it.
TEST_F(ExitGuardTest, AProgramThatTerminatesWaitsUntilTheDriverHasSentTheZero)
{
  driven = true;
  const int status = outcome([] { std::terminate(); });
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_GE(sent->largest, 1.9);
  EXPECT_GE(sent->zerosAtEnd, 1);
}

} // namespace esm
