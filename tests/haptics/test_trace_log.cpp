// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/trace_log.h"

#include "core/base/file_io.h"
#include "haptics/hand_path.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <vector>

namespace esm {

namespace {

class TraceLogTest : public testing::Test {
protected:
  static std::vector<TraceSample> twoTicks()
  {
    std::vector<TraceSample> ticks(2);
    ticks[0].time = 7.0;
    ticks[1].time = 7.001;
    ticks[1].position = {0.1, 0.2, 0.3};
    ticks[1].force = {0.0, 0.0, 1.5};
    return ticks;
  }
  std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "esm_trace_log.csv";
};

} // namespace

TEST_F(TraceLogTest, ATraceIsATableWithUnits)
{
  const std::string csv = traceCsv(twoTicks());
  EXPECT_EQ(csv.substr(0, csv.find('\n')), "t [s],x [m],y [m],z [m],vx [m/s],vy [m/s],vz [m/s],fx [N],fy [N],"
                                           "fz [N],work [J],lateness [s]");
  EXPECT_NE(csv.find("7.001,0.1,0.2,0.3,0,0,0,0,0,1.5,0,0\n"), std::string::npos) << csv;
}

TEST_F(TraceLogTest, WhatWasAddedIsInTheFileInPlaceOfAnOlderOne)
{
  ASSERT_TRUE(writeFileAtomically(file, std::string(10000, 'x')));
  Result<TraceLog> log = TraceLog::create(file, TraceLog::Columns::All);
  ASSERT_TRUE(log);
  EXPECT_EQ(*readFile(file), std::string(10000, 'x')); // until there is something better
  log->add(twoTicks());
  ASSERT_TRUE(log->finish());
  EXPECT_EQ(*readFile(file), traceCsv(twoTicks()));
}

TEST_F(TraceLogTest, AWayIsAHandPath)
{
  Result<TraceLog> log = TraceLog::create(file, TraceLog::Columns::Path);
  ASSERT_TRUE(log);
  log->add(twoTicks());
  ASSERT_TRUE(log->finish());
  const Result<HandPath> path = readHandPath(file);
  ASSERT_TRUE(path);
  EXPECT_EQ(path->time.front(), 0.0);
  EXPECT_EQ(path->position.col(1), twoTicks()[1].position);
}

TEST_F(TraceLogTest, ADiskThatIsFullIsSaidAtTheEnd)
{
  Result<TraceLog> log = TraceLog::create("/dev/full", TraceLog::Columns::All);
  ASSERT_TRUE(log);
  log->add(twoTicks());
  EXPECT_FALSE(log->finish());
  EXPECT_FALSE(TraceLog::create(testing::TempDir(), TraceLog::Columns::All)); // a folder
}

} // namespace esm
