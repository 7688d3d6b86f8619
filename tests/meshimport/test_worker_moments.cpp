// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
// What happens at random moments of an import: the worker is killed, the user gives up.
#include "tests/meshimport/foreign_files.h"
#include "tests/meshimport/worker_children.h"

#include <gmock/gmock.h>

#include <chrono>
#include <csignal>
#include <iostream>
#include <random>
#include <thread>

namespace {

using namespace esm;
using namespace esm::test;
using ::testing::AnyOf;
using ::testing::HasSubstr;
using Clock = std::chrono::steady_clock;

double msSince(Clock::time_point start)
{
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

std::string stlSheet(std::uint32_t n)
{
  std::vector<std::array<float, 9>> facets;
  const auto corner = [](std::uint32_t row, std::uint32_t column) {
    return std::array{static_cast<float>(column), static_cast<float>(row), static_cast<float>(row % 7)};
  };
  const auto add = [&](const auto& a, const auto& b, const auto& c) {
    facets.push_back({a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2]});
  };
  for (std::uint32_t row = 0; row < n; ++row)
    for (std::uint32_t column = 0; column < n; ++column) {
      add(corner(row, column), corner(row, column + 1), corner(row + 1, column + 1));
      add(corner(row, column), corner(row + 1, column + 1), corner(row + 1, column));
    }
  return binaryStl(facets, 2 * n * n);
}

std::size_t filesIn(const std::filesystem::path& folder)
{
  return static_cast<std::size_t>(
    std::distance(std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator()));
}

TEST(WorkerMoments, twoHundredKillsLeaveTheParentIntact)
{
  const TempFolder folder;
  const auto file = folder.write("sheet.glb", glbSheet(60));
  const auto start = Clock::now();
  const std::string whole = summary(importMesh(file));
  ASSERT_EQ(whole, "3721/10920/7200"); // (n+1)^2, 3n^2 + 2n, 2n^2
  const double usual = msSince(start) * 1.2;
  std::mt19937 random(4);
  int crashed = 0;
  for (int i = 0; i < 200; ++i) {
    std::jthread killer([&, moment = std::uniform_real_distribution(0.0, usual)(random)] {
      std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(moment));
      for (const pid_t worker : childrenOfThisProcess()) ::kill(worker, SIGKILL);
    });
    const std::string got = summary(importMesh(file));
    if (got == whole) continue;
    ++crashed;
    EXPECT_THAT(
      got, HasSubstr("sheet.glb: the reader for this format failed: it crashed (it was killed from outside"));
  }
  EXPECT_GT(crashed, 20) << "hardly a kill met a worker";
  EXPECT_TRUE(childrenOfThisProcess().empty());
  EXPECT_EQ(filesIn(folder.path()), 1u);
  EXPECT_EQ(summary(importMesh(file)), whole);
}

/// Stops the import at twenty random moments; returns the longest time from the wish to the answer [ms].
double longestWayBack(const std::filesystem::path& file)
{
  // The first import also reads the file from the disk: a later one may be over before the wish. Then the
  // moments move nearer to the start.
  const auto first = Clock::now();
  const auto whole = importMesh(file);
  EXPECT_TRUE(whole) << whole.error().detail;
  double usual = msSince(first);
  std::mt19937 random(5);
  double longest = 0.0;
  int stopped = 0;
  for (int attempts = 0; stopped < 20 && attempts < 400; ++attempts) {
    WorkControl control;
    Clock::time_point wish;
    const auto start = Clock::now();
    std::jthread user([&, moment = std::uniform_real_distribution(0.0, usual)(random)] {
      std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(moment));
      wish = Clock::now();
      control.cancelled = true;
    });
    const auto imported = importMesh(file, {}, &control);
    const auto back = Clock::now();
    user.join();
    if (imported) { // it was done before the wish
      usual = std::min(usual, std::chrono::duration<double, std::milli>(back - start).count());
      continue;
    }
    ++stopped;
    EXPECT_EQ(imported.error().code, ErrorCode::Cancelled) << imported.error().detail;
    longest = std::max(longest, std::chrono::duration<double, std::milli>(back - wish).count());
    EXPECT_TRUE(childrenOfThisProcess().empty());
  }
  EXPECT_EQ(stopped, 20);
  std::cout << "import " << usual << " ms, longest way back " << longest << " ms of " << stopped
            << " stops\n";
  return longest;
}

// The window promises a tenth of a second on a machine that is not busy with other tests; here a bound that
// only a hang exceeds.
constexpr double kHang = 10'000.0;

TEST(WorkerMoments, aMillionTrianglesThroughTheWorkerStopAtAnyMoment)
{
  const TempFolder folder;
  EXPECT_LT(longestWayBack(folder.write("sheet.glb", glbSheet(707))), kHang);
  EXPECT_EQ(filesIn(folder.path()), 1u);
}

TEST(WorkerMoments, aMillionTrianglesThroughAReaderOfOurOwnStopAtAnyMoment)
{
  const TempFolder folder;
  EXPECT_LT(longestWayBack(folder.write("sheet.stl", stlSheet(707))), kHang);
  EXPECT_EQ(filesIn(folder.path()), 1u);
}

} // namespace
