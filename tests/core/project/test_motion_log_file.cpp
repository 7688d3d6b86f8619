// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/file_io.h"
#include "core/dynamics/simulation.h"
#include "core/project/motion_log_file.h"
#include "core/project/project_io.h"
#include "tests/core/project/random_project.h"

#include <gtest/gtest.h>

namespace esm {

namespace {

class MotionLogFile : public testing::Test {
protected:
  MotionLogFile()
  {
    auto loaded = loadProject(ESM_SOURCE_DIR "/resources/samples/fallopian_tube.esm");
    EXPECT_TRUE(loaded);
    project = std::move(*loaded);
    settings = project.simulation.solver;
    settings.keepsTime = true;
  }

  /// Everything that an entry can be, with numbers that are no round ones.
  void writeRun()
  {
    auto writer = MotionLogWriter::create(path, project, settings);
    ASSERT_TRUE(writer) << writer.error().detail;
    auto simulation = Simulation::create(project.net, project.loads, settings);
    ASSERT_TRUE(simulation);
    simulation->record(&log);
    simulation->watchGrowth();
    ToolSpring hand;
    hand.node = 17;
    hand.target = project.net.restPosition.col(17) + Eigen::Vector3d(1e-3 / 3.0, 2e-3 / 7.0, -0.0);
    hand.targetVelocity = {1.0 / 3.0, 0.0, 1e-300};
    hand.stiffness = 100.0 / 3.0;
    hand.moves = true;
    simulation->setTools({&hand, 1});
    int left = 2;
    Budget budget;
    budget.isSpent = [&] { return left-- <= 0; };
    simulation->advance(1.0 / 60.0, budget);
    simulation->advance(1.0 / 30.0);
    ParameterPatch patch;
    patch.springs = {{3, SpringLaw::Exponential, 20.0 / 3.0, 0.1, 1.7}};
    patch.nodes = {{5, 1e-3 / 3.0, 0.25}};
    if (project.net.anchors.count() > 1) patch.anchors = {{1, 2.5, 0.125}};
    patch.anchorSet = project.net.anchors;
    EXPECT_TRUE(simulation->setParameters(patch));
    EXPECT_TRUE(simulation->setAccuracy(0.03, 1e6));
    simulation->advance(1.0 / 60.0);
    SpringNet other = project.net;
    other.stiffness *= 1.25;
    EXPECT_TRUE(simulation->setParameters(other));
    simulation->advance(1.0 / 60.0);
    simulation->reset();
    simulation->advance(1.0 / 60.0);
    ASSERT_TRUE(writer->add(log));
    EXPECT_FALSE(MotionLogWriter::create(path, project, settings)) << "while it is being written";
    ASSERT_TRUE(writer->finish());
  }

  test::Scratch scratch;
  std::filesystem::path path = scratch / "run.esmlog";
  Project project;
  SolverSettings settings;
  MotionLog log;
};

} // namespace

TEST_F(MotionLogFile, AReadLogReplaysToTheBit)
{
  writeRun();
  const auto run = readMotionLog(path);
  ASSERT_TRUE(run) << run.error().detail;
  EXPECT_TRUE(run->cut.empty());
  EXPECT_EQ(toJson(run->project), toJson(project));
  EXPECT_EQ(run->settings.keepsTime, true);
  ASSERT_EQ(run->log.size(), log.size());
  for (std::size_t i = 0; i < log.size(); ++i) EXPECT_EQ(run->log[i].index(), log[i].index()) << i;
  auto simulation = Simulation::create(run->project.net, run->project.loads, run->settings);
  ASSERT_TRUE(simulation);
  for (const LogEntry& entry : run->log) {
    const auto difference = simulation->replay(entry);
    ASSERT_TRUE(difference) << difference.error().detail;
    EXPECT_EQ(*difference, "");
  }
}

TEST_F(MotionLogFile, ARunThatWasKilledCanBeReplayedUpToThere)
{
  writeRun();
  const std::string bytes = *readFile(path);
  const std::size_t end = bytes.rfind("{\"end\"");
  for (const auto& [cut, missing] :
       {std::pair(bytes.size() - end, 0), std::pair(bytes.size() - end + 20, 1)}) {
    ASSERT_TRUE(writeFileAtomically(path, bytes.substr(0, bytes.size() - cut)));
    const auto run = readMotionLog(path);
    ASSERT_TRUE(run) << run.error().detail;
    EXPECT_EQ(run->log.size() + static_cast<std::size_t>(missing), log.size());
    EXPECT_NE(run->cut.find("killed"), std::string::npos);
  }
}

TEST_F(MotionLogFile, WhatIsNoLogIsRefusedWithItsPlace)
{
  const auto detailOf = [&](const std::string& bytes) {
    EXPECT_TRUE(writeFileAtomically(path, bytes));
    const auto run = readMotionLog(path);
    return run ? std::string("was read") : run.error().detail;
  };
  EXPECT_NE(detailOf("t,id,x,y,z\n").find("is no log"), std::string::npos);
  EXPECT_NE(detailOf(toJson(project)).find("is no log"), std::string::npos);
  writeRun();
  const std::string bytes = *readFile(path);
  EXPECT_NE(detailOf(bytes.substr(0, 2000)).find("cut off"), std::string::npos);
  const std::string open = bytes.substr(0, bytes.rfind("{\"end\""));
  EXPECT_NE(detailOf(open + "{\"tools\":[{\"node\":-1}]}\n").find("entry "), std::string::npos);
  EXPECT_NE(detailOf(open + "{\"leap\":1}\n").find("no entry that this version knows"), std::string::npos);
  std::string newer = bytes;
  newer.replace(newer.find("\"version\":"), 11, "\"version\":2");
  EXPECT_NE(detailOf(newer).find("newer version"), std::string::npos) << detailOf(newer);
  EXPECT_FALSE(MotionLogWriter::create("/dev/null", project, settings));
}

} // namespace esm
