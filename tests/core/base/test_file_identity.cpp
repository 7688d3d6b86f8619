// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/file_identity.h"
#include "core/base/file_io.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace esm {

namespace {

struct FileIdentityTest : ::testing::Test {
  std::filesystem::path folder, path;
  std::optional<FileIdentity> known;

  void SetUp() override
  {
    std::string name = (std::filesystem::temp_directory_path() / "esm-identity-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder = name;
    path = folder / "a.esm";
    ASSERT_TRUE(writeFileAtomically(path, "first"));
    known = identityOf(path);
    ASSERT_TRUE(known);
  }
  void TearDown() override { std::filesystem::remove_all(folder); }
  void setTimes(const FileIdentity& identity)
  {
    const timespec time{identity.modified / 1'000'000'000, identity.modified % 1'000'000'000};
    const timespec times[] = {time, time};
    ASSERT_EQ(::utimensat(AT_FDCWD, path.c_str(), times, 0), 0);
  }
};

} // namespace

TEST_F(FileIdentityTest, AFileThatNobodyTouchedIsTheSame)
{
  EXPECT_FALSE(isOtherFile(path, known));
}

TEST_F(FileIdentityTest, OtherBytesAreAnotherFile)
{
  ASSERT_TRUE(writeFileAtomically(path, "longer than it was"));
  EXPECT_TRUE(isOtherFile(path, known));
}

// What a copy that keeps the time, or a tool that sets it back, leaves: only the bytes tell.
TEST_F(FileIdentityTest, OtherBytesOfTheSameLengthAndTimeAreAnotherFile)
{
  FILE* file = std::fopen(path.c_str(), "r+"); // in place: the same inode
  ASSERT_NE(file, nullptr);
  std::fputs("other", file);
  std::fclose(file);
  setTimes(*known);
  EXPECT_TRUE(isOtherFile(path, known));
}

TEST_F(FileIdentityTest, TouchedCopiedBackOrMovedIsTheSame)
{
  FileIdentity later = *known;
  later.modified += 5'000'000'000;
  setTimes(later);
  EXPECT_FALSE(isOtherFile(path, known));
  ASSERT_TRUE(writeFileAtomically(path, "first"));
  EXPECT_FALSE(isOtherFile(path, known));
  ASSERT_EQ(::chmod(path.c_str(), 0640), 0);
  EXPECT_FALSE(isOtherFile(path, known));
}

TEST_F(FileIdentityTest, NothingThereCannotBeLost)
{
  ASSERT_TRUE(std::filesystem::remove(path));
  EXPECT_FALSE(isOtherFile(path, known));
  EXPECT_FALSE(identityOf(path));
  EXPECT_FALSE(identityOf(folder));
}

// Neither opened, which would wait for a writer, nor taken for a version of the file.
TEST_F(FileIdentityTest, APipeIsNoVersion)
{
  ASSERT_TRUE(std::filesystem::remove(path));
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  EXPECT_FALSE(isOtherFile(path, known));
  EXPECT_FALSE(identityOf(path));
}

TEST_F(FileIdentityTest, OfAFileThatIsNotKnownAnythingIsAnother)
{
  EXPECT_TRUE(isOtherFile(path, std::nullopt));
}

} // namespace esm
