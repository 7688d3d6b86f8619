// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/child_process.h"

#include <gmock/gmock.h>

#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace {

using namespace esm;
using ::testing::HasSubstr;
using ::testing::Not;

ChildTask shell(const std::string& script)
{
  ChildTask task;
  task.words = {"sh", "-c", script};
  return task;
}

ChildEnd endOfScript(const std::string& script)
{
  const auto end = runChild(shell(script), nullptr);
  EXPECT_TRUE(end);
  return *end;
}

/// An answer whose first byte says how many there are, as a digit; an x is no head.
std::optional<std::uint64_t> bytesByDigit(std::string_view head)
{
  if (head[0] == 'x') return std::nullopt;
  return static_cast<std::uint64_t>(head[0] - '0');
}

ChildEnd endOfAnswer(const std::string& script)
{
  ChildTask task = shell(script);
  task.answerBytes = bytesByDigit;
  task.headBytes = 1;
  const auto end = runChild(task, nullptr);
  EXPECT_TRUE(end);
  return *end;
}

TEST(ChildProcess, tellsHowItEnded)
{
  EXPECT_TRUE(endOfScript("exit 0").done());
  const ChildEnd failed = endOfScript("echo one >&2; echo two >&2; exit 7");
  EXPECT_EQ(failed.way, ChildEnd::Way::Exited);
  EXPECT_EQ(failed.number, 7);
  EXPECT_EQ(failed.complaint, "one\ntwo\n");
  EXPECT_EQ(gistOf(failed.complaint), "two");
  const ChildEnd killed = endOfScript("kill -SEGV $$");
  EXPECT_EQ(killed.way, ChildEnd::Way::Killed);
  EXPECT_EQ(killed.number, SIGSEGV);
  EXPECT_FALSE(killed.done());
}

TEST(ChildProcess, worksInItsFolderWithNothingOfOursOpen)
{
  const int file = ::open("/dev/null", O_RDONLY); // not close-on-exec
  ChildTask task =
    shell("pwd >&2; for file in /proc/$$/fd/*; do [ -e $file ] && echo ${file##*/} >&2; done; true");
  task.folder = "/usr";
  const auto end = runChild(task, nullptr);
  ::close(file);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->complaint, "/usr\n0\n1\n2\n");
}

// 100 KB on stderr, of which 4 KB are kept: the last ones.
TEST(ChildProcess, ofItsWordsTheLastAreKept)
{
  const ChildEnd end = endOfScript("head -c 100000 /dev/zero | tr '\\0' a >&2; printf end >&2");
  EXPECT_EQ(end.complaint.size(), 4096u);
  EXPECT_EQ(end.complaint.substr(4090), "aaaend");
}

TEST(ChildProcess, anAnswerIsAsLongAsItsHeadSays)
{
  EXPECT_EQ(endOfAnswer("printf 4abc >&3").answer, "4abc");
  EXPECT_TRUE(endOfAnswer("printf 4abc >&3").done());
  EXPECT_EQ(endOfAnswer("printf 4ab >&3").answer, "4ab"); // the reader sees that a byte is missing
  const ChildEnd tooMuch = endOfAnswer("printf 4abcdefg >&3; exec sleep 100");
  EXPECT_EQ(tooMuch.way, ChildEnd::Way::Garbled);
  EXPECT_EQ(tooMuch.answer, "4abcd");
  EXPECT_EQ(endOfAnswer("printf x >&3; exec sleep 100").way, ChildEnd::Way::Garbled);
}

// What it has started would go on for 100 s, and holds its files open.
TEST(ChildProcess, whatItHasStartedEndsWithIt)
{
  ChildTask task = shell("sleep 100 & echo $! >&2; exec sleep 100");
  task.wall = std::chrono::duration<double>(0.3);
  const auto late = runChild(task, nullptr);
  ASSERT_TRUE(late);
  EXPECT_EQ(late->way, ChildEnd::Way::TooLong);
  const ChildEnd left = endOfScript("sleep 100 & echo $! >&2");
  EXPECT_TRUE(left.done());
  for (const std::string& words : {late->complaint, left.complaint}) {
    const pid_t started = static_cast<pid_t>(std::stol(words));
    ASSERT_GT(started, 0);
    // Killed; it may be waiting to be reaped by the system's first process, or be gone.
    for (int i = 0; i < 500 && ::kill(started, 0) == 0; ++i) {
      std::error_code code;
      if (std::filesystem::read_symlink("/proc/" + std::to_string(started) + "/exe", code).empty()) break;
      ::usleep(10000);
    }
    std::error_code code;
    EXPECT_THAT(std::filesystem::read_symlink("/proc/" + std::to_string(started) + "/exe", code).string(),
                Not(HasSubstr("sleep")));
  }
}

TEST(ChildProcess, aWishToStopEndsIt)
{
  WorkControl control;
  std::jthread user([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    control.cancelled = true;
  });
  const auto end = runChild(shell("exec sleep 100"), &control);
  ASSERT_FALSE(end);
  EXPECT_EQ(end.error().code, ErrorCode::Cancelled);
  EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1); // reaped
  EXPECT_EQ(errno, ECHILD);
}

TEST(ChildProcess, oneThatIsNotThereIsTold)
{
  ChildTask task;
  task.words = {"/nowhere/program"};
  const auto end = runChild(task, nullptr);
  ASSERT_FALSE(end);
  EXPECT_EQ(end.error().code, ErrorCode::Internal);
  EXPECT_THAT(end.error().detail, HasSubstr("No such file"));
  EXPECT_TRUE(isInPath("sh"));
  EXPECT_FALSE(isInPath("a-program-that-nobody-has"));
}

} // namespace
