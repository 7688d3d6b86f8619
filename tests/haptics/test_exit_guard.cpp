// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/exit_guard.h"

#include "servo_bench.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <exception>
#include <functional>

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>
#include <vector>

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
  explicit RecordingDevice(SentForces& sent) : m_sent(sent) { m_profile.armTime = 0.01; }
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
    ServoLoop loop(std::make_unique<RecordingDevice>(*sent), std::make_unique<SteadyClock>(), tool, contact);
    loop.core().orders().give(ForceOrder::Arm);
    loop.start();
    for (std::uint64_t i = 1; i < 4000 && sent->largest < 1.9; ++i) {
      if (i > 100) { // armed without force first
        contact.back() = constantForce({2.0, 0.0, 0.0});
        contact.back().sequence = i;
        contact.publish();
      }
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

} // namespace esm
