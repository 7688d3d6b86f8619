// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/file_io.h"
#include "core/project/export.h"
#include "tests/core/project/random_project.h"

#include <gmock/gmock.h>

#include <cstring>
#include <fstream>

namespace esm {
namespace {

using testing::HasSubstr;

/// Three frames of the small net, each moved by 0.1 m along x.
Status writeThree(const std::filesystem::path& path)
{
  const Project project = test::smallProject();
  Result<TrajectoryWriter> writer = TrajectoryWriter::create(path);
  if (!writer) return writer.error();
  for (int k = 0; k < 3; ++k) {
    Eigen::Matrix3Xd position = project.net.restPosition;
    position.row(0).array() += 0.1 * k;
    if (Status status = writer->addFrame({&project.net, &position, nullptr, nullptr, 0.5 * k}); !status)
      return status;
  }
  return writer->finish();
}

TEST(Trajectory, RawIsFramesTimesNodesTimesThree)
{
  const test::Scratch scratch;
  ASSERT_TRUE(writeThree(scratch / "m.f64"));
  const std::string bytes = *readFile(scratch / "m.f64");
  ASSERT_EQ(bytes.size(), 3u * 5u * 3u * 8u);
  std::vector<double> values(45);
  std::memcpy(values.data(), bytes.data(), bytes.size());
  const SpringNet net = test::smallProject().net;
  EXPECT_EQ(values[1 * 3 + 0], net.restPosition(0, 1)) << "frame 0, node 1, x";
  EXPECT_EQ(values[2 * 15 + 4 * 3 + 2], net.restPosition(2, 4)) << "frame 2, node 4, z";
  EXPECT_EQ(values[2 * 15 + 4 * 3 + 0], net.restPosition(0, 4) + 0.2);
}

TEST(Trajectory, CsvIsOneLinePerNodeAndFrame)
{
  const test::Scratch scratch;
  ASSERT_TRUE(writeThree(scratch / "m.csv"));
  const std::string text = *readFile(scratch / "m.csv");
  EXPECT_THAT(text, testing::StartsWith("t,id,x,y,z\n0,0,0,0,0\n0,1,0.01,0,0\n"));
  EXPECT_THAT(text, HasSubstr("\n0.5,0,0.1,0,0\n"));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1 + 3 * 5);
}

TEST(Trajectory, CollectionNamesItsFramesRelatively)
{
  const test::Scratch scratch;
  ASSERT_TRUE(writeThree(scratch / "m & n.pvd"));
  const std::string text = *readFile(scratch / "m & n.pvd");
  EXPECT_THAT(text,
              HasSubstr("timestep=\"0.5\" group=\"\" part=\"0\" file=\"m &amp; n_frames/frame_000001.vtu\""));
  EXPECT_TRUE(std::filesystem::exists(scratch / "m & n_frames/frame_000002.vtu"));
  ASSERT_TRUE(writeThree(scratch / "m & n.pvd")) << "a second run replaces the first";
  EXPECT_EQ(scratch.fileCount(), 4u);
}

// Until finish() the name is free, and a writer that is dropped leaves nothing.
TEST(Trajectory, UnfinishedLeavesNothing)
{
  const test::Scratch scratch;
  for (const char* name : {"m.csv", "m.f64", "m.pvd"}) {
    {
      const Project project = test::smallProject();
      Result<TrajectoryWriter> writer = TrajectoryWriter::create(scratch / name);
      ASSERT_TRUE(writer);
      ASSERT_TRUE(writer->addFrame({&project.net, &project.net.restPosition, nullptr, nullptr, 0.0}));
      EXPECT_FALSE(std::filesystem::exists(scratch / name));
    }
    EXPECT_EQ(scratch.fileCount(), 0u) << name;
  }
}

TEST(Trajectory, ForeignFilesAreNotRemoved)
{
  const test::Scratch scratch;
  std::filesystem::create_directory(scratch / "m_frames");
  std::ofstream(scratch / "m_frames/thesis.txt") << "years of work";
  const Status status = writeThree(scratch / "m.pvd");
  ASSERT_FALSE(status);
  EXPECT_THAT(status.error().detail, HasSubstr("holds \"thesis.txt\""));
  EXPECT_EQ(scratch.fileCount(), 1u);
}

TEST(Trajectory, BadEndingsFoldersAndNumbersAreRefused)
{
  const test::Scratch scratch;
  EXPECT_EQ(writeThree(scratch / "m.avi").error().code, ErrorCode::Unsupported);
  EXPECT_EQ(writeThree(scratch / "absent/m.csv").error().code, ErrorCode::FileUnwritable);
  const Project project = test::smallProject();
  Eigen::Matrix3Xd position = project.net.restPosition;
  position(2, 2) = std::nan("");
  Result<TrajectoryWriter> writer = TrajectoryWriter::create(scratch / "m.f64");
  ASSERT_TRUE(writer);
  EXPECT_EQ(writer->addFrame({&project.net, &position, nullptr, nullptr, 0.0}).error().code,
            ErrorCode::Numerics);
}

} // namespace
} // namespace esm
