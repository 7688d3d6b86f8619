// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/file_io.h"
#include "core/base/temporary_beside.h"

#include <gtest/gtest.h>

#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sys/inotify.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

namespace esm {

class FileIo : public ::testing::Test {
protected:
  void SetUp() override
  {
    std::string name = (std::filesystem::temp_directory_path() / "esm-file-io-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder = name;
  }
  void TearDown() override { std::filesystem::remove_all(folder); }
  std::size_t fileCount() const
  {
    std::size_t count = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder)) ++count;
    return count;
  }
  std::filesystem::path folder;
};

TEST_F(FileIo, WhatIsWrittenIsReadBackAndThePreviousVersionStays)
{
  const auto path = folder / "a.esm";
  ASSERT_TRUE(writeFileAtomically(path, std::string("old\0bytes", 9), true));
  ASSERT_TRUE(writeFileAtomically(path, "new", true));
  EXPECT_EQ(*readFile(path), "new");
  EXPECT_EQ(*readFile(path.string() + ".bak"), std::string("old\0bytes", 9));
  EXPECT_EQ(fileCount(), 2u) << "no temporary file stays behind";
}

// A disk that fills up in the middle of a save: the write fails, the old file must be untouched. RLIMIT_FSIZE
// plays the full disk (SIGXFSZ ignored, so that write() reports EFBIG).
TEST_F(FileIo, AFailedWriteLeavesTheOldFile)
{
  const auto path = folder / "a.esm";
  ASSERT_TRUE(writeFileAtomically(path, "precious"));
  ::signal(SIGXFSZ, SIG_IGN);
  rlimit old{};
  ::getrlimit(RLIMIT_FSIZE, &old);
  rlimit small = old;
  small.rlim_cur = 1000;
  ::setrlimit(RLIMIT_FSIZE, &small);
  const Status status = writeFileAtomically(path, std::string(100000, 'x'), true);
  ::setrlimit(RLIMIT_FSIZE, &old);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::FileUnwritable);
  EXPECT_EQ(*readFile(path), "precious");
  EXPECT_EQ(fileCount(), 1u);
}

TEST_F(FileIo, SavingThroughALinkKeepsTheLink)
{
  ASSERT_TRUE(writeFileAtomically(folder / "real.esm", "1"));
  std::filesystem::create_symlink("real.esm", folder / "link.esm");
  ASSERT_TRUE(writeFileAtomically(folder / "link.esm", "2"));
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.esm"));
  EXPECT_EQ(*readFile(folder / "real.esm"), "2");
}

// rename() would put the file in the place of the link, and what it leads to would never come into being.
TEST_F(FileIo, WritingThroughALinkThatLeadsNowhereYetMakesItsFile)
{
  std::filesystem::create_directories(folder / "disk");
  std::filesystem::create_symlink("disk/real.esm", folder / "second");
  std::filesystem::create_symlink(folder / "second", folder / "first");
  ASSERT_TRUE(writeFileAtomically(folder / "first", "1"));
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "first"));
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "second"));
  EXPECT_EQ(*readFile(folder / "disk" / "real.esm"), "1");
}

TEST_F(FileIo, LinksInACircleAreRefused)
{
  std::filesystem::create_symlink("b", folder / "a");
  std::filesystem::create_symlink("a", folder / "b");
  const Status status = writeFileAtomically(folder / "a", "1");
  ASSERT_FALSE(status);
  EXPECT_NE(status.error().detail.find("symbolic links"), std::string::npos) << status.error().detail;
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "a"));
}

TEST_F(FileIo, ASeriesIsWrittenThroughItsLink)
{
  std::ofstream(folder / "real.csv") << "old";
  std::filesystem::create_symlink("real.csv", folder / "link.csv");
  {
    auto temporary = TemporaryBeside::create(folder / "link.csv", TemporaryBeside::Kind::File);
    ASSERT_TRUE(temporary);
    ASSERT_TRUE(writeAll(temporary->descriptor(), "new"));
    ASSERT_TRUE(temporary->takeName());
  }
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.csv"));
  EXPECT_EQ(*readFile(folder / "real.csv"), "new");
}

// A program that is killed between two steps of a save leaves a backup behind: no step removes it.
TEST_F(FileIo, ThereIsABackupAtEveryMoment)
{
  const auto path = folder / "a.esm";
  ASSERT_TRUE(writeFileAtomically(path, "1", true));
  ASSERT_TRUE(writeFileAtomically(path, "2", true));
  const int watch = ::inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
  ASSERT_GE(::inotify_add_watch(watch, folder.c_str(), IN_DELETE | IN_MOVED_FROM | IN_MOVED_TO), 0);
  ASSERT_TRUE(writeFileAtomically(path, "3", true));
  alignas(inotify_event) char buffer[4096];
  const ssize_t size = ::read(watch, buffer, sizeof buffer);
  ::close(watch);
  int renamed = 0;
  for (ssize_t at = 0; at < size;) {
    const auto* event = reinterpret_cast<const inotify_event*>(buffer + at);
    at += static_cast<ssize_t>(sizeof(inotify_event) + event->len);
    if (event->len == 0 || std::string(event->name) != "a.esm.bak") continue;
    EXPECT_TRUE(event->mask & IN_MOVED_TO) << event->mask;
    ++renamed;
  }
  EXPECT_EQ(renamed, 1);
  EXPECT_EQ(*readFile(path.string() + ".bak"), "2");
  EXPECT_EQ(fileCount(), 2u);

  std::filesystem::remove(path.string() + ".bak"); // two names of one file, as a save that failed leaves them
  std::filesystem::create_hard_link(path, path.string() + ".bak");
  ASSERT_TRUE(writeFileAtomically(path, "4", true));
  EXPECT_EQ(*readFile(path.string() + ".bak"), "3");
  EXPECT_EQ(fileCount(), 2u);
}

TEST_F(FileIo, APipeAtThePlaceOfTheBackupIsNotReplaced)
{
  ASSERT_TRUE(writeFileAtomically(folder / "a.esm", "1"));
  ASSERT_EQ(::mkfifo((folder / "a.esm.bak").c_str(), 0600), 0);
  EXPECT_FALSE(writeFileAtomically(folder / "a.esm", "2", true));
  EXPECT_TRUE(std::filesystem::is_fifo(folder / "a.esm.bak"));
  EXPECT_EQ(*readFile(folder / "a.esm"), "1");
}

TEST_F(FileIo, ErrorsNameTheFileAndTheCause)
{
  EXPECT_NE(readFile(folder / "none").error().detail.find("none: cannot be read (No such file"),
            std::string::npos);
  EXPECT_NE(readFile(folder).error().detail.find("is a folder"), std::string::npos);
  EXPECT_FALSE(writeFileAtomically(folder / "no" / "such.esm", "x"));
}

// A rename would put a file where the pipe was; as root, where /dev/null was.
TEST_F(FileIo, APipeIsWrittenIntoAndNeverReplaced)
{
  const std::filesystem::path pipe = folder / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(writeFileAtomically(pipe, "x").error().code,
            ErrorCode::FileUnwritable); // nobody reads; does not wait
  const int reader = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
  ASSERT_GE(reader, 0);
  EXPECT_TRUE(writeFileAtomically(pipe, "bytes"));
  char read[8] = {};
  EXPECT_EQ(::read(reader, read, sizeof read), 5);
  EXPECT_STREQ(read, "bytes");
  ::close(reader);
  EXPECT_TRUE(std::filesystem::is_fifo(pipe));
  EXPECT_EQ(fileCount(), 1U);
}

TEST_F(FileIo, DevicesAndPipesAreNoInput)
{
  const std::filesystem::path pipe = folder / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0); // would wait for ever
  EXPECT_EQ(readFile(pipe).error().detail, pipe.string() + ": is a pipe, not a file");
  EXPECT_EQ(readFile("/dev/zero").error().detail, "/dev/zero: is a device, not a file"); // would never end
}

// What a killed program left is known by its free lock; what a living one writes is not touched.
TEST_F(FileIo, TheNextWriteSweepsWhatKilledWritersLeft)
{
  const auto alive = TemporaryBeside::create(folder / "alive.csv", TemporaryBeside::Kind::File);
  const auto aliveFolder = TemporaryBeside::create(folder / "alive", TemporaryBeside::Kind::Folder);
  ASSERT_TRUE(alive);
  ASSERT_TRUE(aliveFolder);
  for (const char* name : {"run.csv.esm-tmp-a1B2c3", "mine.esm-tmp-", "x.esm-tmp-12345!"})
    std::ofstream(folder / name) << "half";
  std::filesystem::create_directories(folder / "motion.esm-tmp-AAAAAA");
  std::ofstream(folder / "motion.esm-tmp-AAAAAA" / "0.vtu") << "half";
  std::filesystem::create_directories(folder / "kept.esm-tmp-BBBBBB" / "of somebody");

  ASSERT_TRUE(writeFileAtomically(folder / "a.esm", "new"));

  EXPECT_FALSE(std::filesystem::exists(folder / "run.csv.esm-tmp-a1B2c3"));
  EXPECT_FALSE(std::filesystem::exists(folder / "motion.esm-tmp-AAAAAA"));
  EXPECT_TRUE(std::filesystem::exists(folder / "kept.esm-tmp-BBBBBB" / "of somebody")) << "no folder of ours";
  EXPECT_TRUE(std::filesystem::exists(folder / "mine.esm-tmp-")) << "no name of ours";
  EXPECT_TRUE(std::filesystem::exists(folder / "x.esm-tmp-12345!")) << "no name of ours";
  EXPECT_TRUE(std::filesystem::exists(alive->path()));
  EXPECT_TRUE(std::filesystem::exists(aliveFolder->path()));
}

// rename() cannot put a folder in the place of one that holds files, so the two change places.
TEST_F(FileIo, AFolderTakesThePlaceOfAnother)
{
  std::filesystem::create_directories(folder / "motion");
  std::ofstream(folder / "motion" / "old.vtu") << "old";
  {
    auto temporary = TemporaryBeside::create(folder / "motion", TemporaryBeside::Kind::Folder);
    ASSERT_TRUE(temporary);
    std::ofstream(temporary->path() / "new.vtu") << "new";
    ASSERT_TRUE(temporary->takeName());
  }
  EXPECT_TRUE(std::filesystem::exists(folder / "motion" / "new.vtu"));
  EXPECT_FALSE(std::filesystem::exists(folder / "motion" / "old.vtu"));
  EXPECT_EQ(fileCount(), 1u) << "no temporary folder stays behind";
}

} // namespace esm
