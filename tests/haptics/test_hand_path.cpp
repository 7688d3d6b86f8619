// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/hand_path.h"

#include "core/base/file_io.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace esm {

namespace {

class HandPathTest : public testing::Test {
protected:
  ~HandPathTest() override { std::filesystem::remove(file); }
  std::filesystem::path file =
    std::filesystem::temp_directory_path() /
    (std::string("esm_hand_path_") + testing::UnitTest::GetInstance()->current_test_info()->name() + ".csv");
};

} // namespace

TEST_F(HandPathTest, ComesBackToTheSameBits)
{
  HandPath path;
  path.time = {0.0, 1.0 / 3.0, 0.7};
  path.position = Eigen::Matrix3Xd::Random(3, 3) / 7.0;
  ASSERT_TRUE(writeHandPath(file, path));
  const Result<HandPath> read = readHandPath(file);
  ASSERT_TRUE(read) << read.error().detail;
  EXPECT_EQ(read->time, path.time);
  EXPECT_EQ(read->position, path.position);
}

TEST_F(HandPathTest, LeadsOnStraightLinesAndRestsAtItsEnds)
{
  HandPath path;
  path.time = {1.0, 2.0};
  path.position.resize(3, 2);
  path.position << 0.0, 0.1, 0.0, 0.0, 0.0, -0.2;
  EXPECT_TRUE(path.at(1.5).isApprox(Eigen::Vector3d(0.05, 0.0, -0.1), 1e-12));
  EXPECT_EQ(path.at(0.0), path.position.col(0));
  EXPECT_EQ(path.at(9.0), path.position.col(1));
}

TEST_F(HandPathTest, AFaultNamesItsLine)
{
  for (const auto& [text, fault] :
       {std::pair{"x,y\n", ":1: a hand path begins with the columns \"t,x,y,z\""},
        {"t,x,y,z\n0,0,0,0\n0,1,1,1\n", ":3: column 1: the times must rise"},
        {"t,x,y,z\n0,0,0\n", ":2: column 4: the row has 3 cells"},
        {"t,x,y,z\n0,nan,0,0\n", ":2: column 2: four finite numbers"},
        {"t,x,y,z\n0,0,0,0,0\n", ":2: column 5: the row has 5 cells"},
        {"t,x,y,z\n0,0,0,009,0,084\n",
         ":2: column 5: the row has 6 cells, the header 4; are there decimal commas?"},
        {"t;x;y;z\n0;0;0,5;0.5\n", ":2: column 4: '0.5' has a decimal point, line 2 a decimal comma"}}) {
    ASSERT_TRUE(writeFileAtomically(file, text));
    const Result<HandPath> read = readHandPath(file);
    ASSERT_FALSE(read) << text;
    EXPECT_NE(read.error().detail.find(fault), std::string::npos) << read.error().detail;
  }
}

// The same two points, as programs of several regions write them.
TEST_F(HandPathTest, IsReadInTheStylesOfSpreadsheets)
{
  for (const char* text : {"t,x,y,z\n0,0,0.009,0.084\n0.01,0,0.009,0.085\n",
                           "t;x;y;z\n0,0;0,0;0,009;0,084\n0,01;0,0;0,009;0,085\n",
                           "t, x, y, z\n0.0, 0.0, 0.009, 0.084\n 0.01, 0.0, 0.009, 0.085 \n",
                           "\xEF\xBB\xBFT\tX\tY\tZ\r\n0\t0\t0,009\t0,084\r\n\r\n0,01\t0\t0,009\t0,085\r\n",
                           "\"t\",\"x\",\"y\",\"z\",\n\"0\",\"0\",\"0.009\",\"0.084\",\n,,,,\n\"0.01\",\"0\","
                           "\"0.009\",\"0.085\",\n"}) {
    ASSERT_TRUE(writeFileAtomically(file, text));
    const Result<HandPath> read = readHandPath(file);
    ASSERT_TRUE(read) << text << read.error().detail;
    EXPECT_EQ(read->time, (std::vector<double>{0.0, 0.01})) << text;
    EXPECT_EQ(read->position.col(1), Eigen::Vector3d(0.0, 0.009, 0.085)) << text;
  }
}

// A replay waits until force is on; each start lets go and begins anew.
TEST(WaitingHand, RestsUntilItIsToldToGo)
{
  HandPath path;
  path.time = {0.0, 1.0};
  path.position.resize(3, 2);
  path.position << 0.0, 1.0, 0.0, 0.0, 0.0, 0.0;
  WaitingHand hand(path);
  EXPECT_EQ(hand.pose(5.0).target.x(), 0.0);
  EXPECT_EQ(hand.pose(50.0).target.x(), 0.0);
  hand.go();
  EXPECT_EQ(hand.pose(100.0).target.x(), 0.0);
  EXPECT_EQ(hand.pose(100.5).target.x(), 0.5);
  const std::uint32_t places = hand.pose(103.0).placeCount;
  EXPECT_EQ(hand.pose(103.0).target.x(), 1.0);
  hand.go();
  EXPECT_EQ(hand.pose(104.0).target.x(), 0.0);
  EXPECT_NE(hand.pose(104.0).placeCount, places);
}

TEST(HandPathOf, BeginsAtZero)
{
  std::vector<TraceSample> trace(2);
  trace[0].time = 7.0;
  trace[1].time = 7.001;
  trace[1].position = {0.1, 0.2, 0.3};
  trace[1].force = {0.0, 0.0, 1.5};
  const HandPath path = handPathOf(trace);
  EXPECT_EQ(path.time.front(), 0.0);
  EXPECT_EQ(path.position.col(1), trace[1].position);
}

} // namespace esm
