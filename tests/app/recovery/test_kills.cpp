// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/file_io.h"
#include "tests/app/recovery/session.h"

#include <QCoreApplication>

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <random>
#include <spawn.h>
#include <sstream>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

using namespace esm;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace {

/// What the log of the killed program says.
struct Progress {
  int begun = -1, done = -1;
};

struct KillTest : testing::Test {
  fs::path folder;
  std::vector<std::string> after; ///< fingerprint of the document after each step
  std::mt19937 random{20};

  void SetUp() override
  {
    std::string name = (fs::temp_directory_path() / "esm-kills-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder = name;
    Document document;
    test::Session session(&document, file(), [&] { ASSERT_TRUE(document.saveAs(document.path())); });
    session.open();
    after.push_back(test::fingerprint(document.project(), document.ruleDraft()));
    for (int step = 1; step <= test::Session::kSteps; ++step) {
      session.step(step);
      after.push_back(test::fingerprint(document.project(), document.ruleDraft()));
    }
  }
  void TearDown() override { fs::remove_all(folder); }
  fs::path file() const { return folder / "organ.esm"; }

  Progress progress() const
  {
    Progress progress;
    const Result<std::string> log = readFile(folder / "log");
    std::istringstream words(log ? *log : std::string());
    std::string word;
    for (int step = 0; words >> word >> step;) (word == "begin" ? progress.begun : progress.done) = step;
    return progress;
  }
  pid_t start(const char* kind)
  {
    for (const auto& entry : fs::directory_iterator(folder)) fs::remove_all(entry.path());
    const std::string where = folder.string();
    const char* arguments[] = {ESM_KILL_SESSION, where.c_str(), kind, nullptr};
    pid_t process = 0;
    if (::posix_spawn(&process, ESM_KILL_SESSION, nullptr, nullptr, const_cast<char* const*>(arguments),
                      environ) != 0)
      return 0;
    while (progress().done < 0 && ::waitpid(process, nullptr, WNOHANG) == 0) std::this_thread::sleep_for(1ms);
    return process;
  }
  static void kill(pid_t process)
  {
    ::kill(process, SIGKILL);
    ::waitpid(process, nullptr, 0);
  }
  /// How long a session takes that nobody ends.
  std::chrono::microseconds lengthOf(const char* kind)
  {
    const pid_t process = start(kind);
    const auto begin = std::chrono::steady_clock::now();
    while (progress().done < test::Session::kSteps) std::this_thread::sleep_for(1ms);
    const auto length = std::chrono::steady_clock::now() - begin;
    kill(process);
    return std::chrono::duration_cast<std::chrono::microseconds>(length);
  }
  void killAtRandom(const char* kind, int times)
  {
    const auto length = lengthOf(kind);
    int inside = 0;
    for (int i = 0; i < times; ++i) {
      const pid_t process = start(kind);
      ASSERT_GT(process, 0);
      std::this_thread::sleep_for(length * (random() % 1000) / 1000);
      kill(process);
      const Progress now = progress();
      ASSERT_GE(now.done, 0) << "it did not begin";
      inside += now.begun > now.done ? 1 : 0;
      const std::string found = test::foundFingerprint(folder / "recovery", file());
      const auto place = static_cast<std::size_t>(now.done);
      const bool isThere = found == after[place] || (now.begun > now.done && found == after[place + 1]);
      ASSERT_TRUE(isThere) << "kill " << i << ", done " << now.done << ", begun " << now.begun << ": "
                           << found;
    }
    RecordProperty("killed_inside_a_step", inside);
  }
};

} // namespace

// A process that is killed at any moment loses at most the step under way, and never the file. What is found
// is compared bit for bit with what a session that nobody kills has after each step.
TEST_F(KillTest, DocumentLosesAtMostTheStepUnderWay)
{
  killAtRandom("document", 180);
}

TEST_F(KillTest, WindowLosesAtMostTheStepUnderWay)
{
  killAtRandom("window", 20);
}

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  const QCoreApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
