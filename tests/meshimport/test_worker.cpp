// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/file_io.h"
#include "meshimport/worker/worker_process.h"
#include "tests/meshimport/foreign_files.h"
#include "tests/meshimport/worker_children.h"

#include <gmock/gmock.h>

#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <thread>

namespace {

using namespace esm;
using namespace esm::test;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// For its life, a shell script is the worker.
class FalseWorker {
public:
  explicit FalseWorker(const std::string& script)
  {
    const auto program = m_folder.write("worker", "#!/bin/sh\n" + script + "\n");
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    ::setenv("ESM_IMPORT_WORKER", program.c_str(), 1);
  }
  ~FalseWorker() { ::unsetenv("ESM_IMPORT_WORKER"); }
  FalseWorker(const FalseWorker&) = delete;
  FalseWorker& operator=(const FalseWorker&) = delete;

private:
  TempFolder m_folder;
};

std::string sentenceOf(const Result<WorkerReply>& reply)
{
  return reply ? "it was read" : reply.error().detail;
}

/// What comes of a file in a worker that misbehaves.
std::string sentenceOfScript(const std::string& script)
{
  const FalseWorker worker(script);
  return sentenceOf(readInWorker({"assimp", "dae", "organ.dae", std::chrono::seconds(1)}, nullptr));
}

TEST(Worker, everyEndWithoutAnAnswerIsOneSentence)
{
  EXPECT_EQ(
    sentenceOfScript("kill -SEGV $$"),
    "organ.dae: the reader for this format failed: it crashed (segmentation fault), by a fault of its own or "
    "because the file is damaged; convert the file to OBJ, PLY or STL");
  EXPECT_THAT(sentenceOfScript("kill -ABRT $$"), HasSubstr("crashed (it aborted)"));
  EXPECT_THAT(sentenceOfScript("kill -KILL $$"), HasSubstr("killed from outside"));
  EXPECT_THAT(sentenceOfScript("kill -XCPU $$"), HasSubstr("took too long for a file of this size"));
  EXPECT_THAT(sentenceOfScript("exit 3"), HasSubstr("crashed (exit code 3)"));
  EXPECT_THAT(sentenceOfScript("exit 0"), HasSubstr("ended without an answer"));
  EXPECT_THAT(sentenceOfScript("echo a; echo first >&2; echo the last word >&2; exit 1"),
              AllOf(HasSubstr("crashed (the last word)"), Not(HasSubstr("first"))));
  EXPECT_THAT(sentenceOfScript("yes complaint | head -c 3000000 | tr -d '\\n' >&2; exit 1"),
              AllOf(HasSubstr("complaintcomplaint"), HasSubstr("...), by a fault"),
                    ::testing::ResultOf([](auto& s) { return s.size(); }, testing::Lt(400u))));
  EXPECT_THAT(sentenceOfScript("exec 3>&-; exec sleep 100"), HasSubstr("crashed"));
  EXPECT_THAT(sentenceOfScript("exec sleep 100"), HasSubstr("did not end within 1 s"));
  EXPECT_TRUE(childrenOfThisProcess().empty());
}

TEST(Worker, garbageIsOneSentence)
{
  for (const char* script : {"echo hello >&3", "head -c 100000 /dev/urandom >&3", "cat /dev/zero >&3",
                             "printf 'WSME' >&3; cat /dev/zero >&3", "printf 'ESMW' >&3"})
    EXPECT_THAT(sentenceOfScript(script), HasSubstr("answered with garbage")) << script;
  // A head that promises 100 vertices and then goes on for ever: no more is taken than it promised.
  EXPECT_THAT(
    sentenceOfScript(
      "printf 'ESMW\\003\\0\\0\\0\\377\\377\\377\\377\\377\\377\\377\\377' >&3; printf "
      "'\\001\\0\\0\\0\\0\\0\\0\\0' >&3; head -c 16 /dev/zero >&3; printf '\\144' >&3; cat /dev/zero >&3"),
    HasSubstr("answered with garbage (it holds 2482 bytes where its head promises 2481)"));
  EXPECT_TRUE(childrenOfThisProcess().empty());
}

TEST(Worker, aMissingProgramIsNamed)
{
  ::setenv("ESM_IMPORT_WORKER", "/nowhere/esm-import-worker", 1);
  const std::string sentence = sentenceOf(readInWorker({"assimp", "dae", "organ.dae"}, nullptr));
  ::unsetenv("ESM_IMPORT_WORKER");
  EXPECT_THAT(sentence, AllOf(HasSubstr("/nowhere/esm-import-worker"), HasSubstr("install it again")));
}

TEST(Worker, seesNoOpenFileAndNoBlockedSignalOfItsParent)
{
  const int file = ::open("/dev/null", O_RDONLY); // not close-on-exec, as a careless library would open it
  ASSERT_EQ(::dup2(file, 57), 57);
  sigset_t blocked, before;
  sigemptyset(&blocked);
  sigaddset(&blocked, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &blocked, &before);
  const std::string files = sentenceOfScript("echo $(ls /proc/$$/fd) >&2; exit 1");
  const std::string signals = sentenceOfScript("kill -TERM $$; exec sleep 100");
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  ::close(57);
  ::close(file);
  EXPECT_THAT(files, AllOf(HasSubstr("(0 1 "), Not(HasSubstr("57")))); // the shell adds its script
  EXPECT_THAT(signals, HasSubstr("crashed (signal 15)"));
}

TEST(Worker, endsWithinAMomentOfTheWishToStop)
{
  const FalseWorker worker("exec sleep 100");
  WorkControl control;
  std::jthread user([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    control.cancelled = true;
  });
  const auto reply = readInWorker({"assimp", "dae", "organ.dae"}, &control);
  ASSERT_FALSE(reply);
  EXPECT_EQ(reply.error().code, ErrorCode::Cancelled);
}

// From here on the worker is the real one, and what it reads was seen to end assimp 5.2.5.

TEST(Worker, readsTheFormatsThatAreSentToIt)
{
  const TempFolder folder;
  const auto list = folder.path() / "formats";
  ASSERT_EQ(std::system(("'" + importWorker().string() + "' --formats > '" + list.string() + "'").c_str()),
            0);
  const std::string formats = ";" + *readFile(list) + ";";
  const MeshReader& reader = readerTable().back();
  for (const std::string ending :
       {"3ds", "3mf", "ac", "amf", "dae", "fbx", "glb", "gltf", "lwo", "x", "x3d"}) {
    EXPECT_THAT(formats, HasSubstr("*." + ending + ";"));
    EXPECT_TRUE(reader.recognises("something", ending)) << ending;
  }
}

TEST(Worker, aCrashOfTheLibraryIsOneSentence)
{
#ifdef ESM_SANITIZED
  const char* const cause = ""; // the sanitizer ends the worker in its own way
#else
  const char* const cause = "segmentation fault)";
#endif
  EXPECT_THAT(
    summary(importBytes("organ.dae", deepCollada(200'000))),
    AllOf(HasSubstr(std::string("organ.dae: the reader for this format failed: it crashed (") + cause),
          Not(HasSubstr("\n"))));
}

TEST(Worker, aFileThatLiesAboutItsSizeGetsNoMemory)
{
#ifdef ESM_SANITIZED
  GTEST_SKIP() << "a sanitizer needs terabytes of addresses";
#endif
  const TempFolder folder;
  const auto file =
    folder.write("lie.ply", "ply\nformat ascii 1.0\nelement vertex 1000000000\nproperty float x\n"
                            "property float y\nproperty float z\nend_header\n0 0 0\n");
  const auto reply = readInWorker({"assimp", "ply", file}, nullptr);
  ASSERT_FALSE(reply);
  EXPECT_THAT(reply.error().detail, HasSubstr("lie.ply: "));
}

TEST(Worker, aFileThatNeverEndsIsStopped)
{
  const TempFolder folder;
  const auto file =
    folder.write("cut.ply", "ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty fl");
  EXPECT_THAT(sentenceOf(readInWorker({"assimp", "ply", file}, nullptr)),
              HasSubstr("took too long for a file of this size"));
}

TEST(Worker, pathsOutOfTheFolderStayClosed)
{
  const TempFolder folder;
  const auto gltf = [](const std::string& uri) {
    return R"({"asset":{"version":"2.0"},"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":)"
           R"([{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],"bufferViews":[{"buffer":0,)"
           R"("byteLength":36}],"buffers":[{"byteLength":36,"uri":")" +
           uri + R"("}],"nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}],"scene":0})";
  };
  for (const char* uri :
       {"../../etc/passwd", "../../../../../../../etc/passwd", "/etc/passwd", "file:///etc/passwd"})
    EXPECT_FALSE(importMesh(folder.write("x.gltf", gltf(uri)))) << uri;
}

// Whoever started it may die at any moment; the worker must not go on alone.
TEST(Worker, diesWithItsParent)
{
  const TempFolder folder;
  const auto file =
    folder.write("cut.ply", "ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty fl");
  const pid_t parent = ::fork();
  if (parent == 0) {
    const auto reply = readInWorker({"assimp", "ply", file}, nullptr);
    ::_exit(reply ? 0 : 1);
  }
  std::vector<pid_t> workers;
  for (int i = 0; i < 2000 && workers.empty(); ++i) {
    ::usleep(1000);
    workers = childrenOf(parent);
  }
  ::kill(parent, SIGKILL);
  ::waitpid(parent, nullptr, 0);
  ASSERT_EQ(workers.size(), 1u);
  bool gone = false; // init may take its time to bury it
  for (int i = 0; i < 2000 && !gone; ++i) {
    ::usleep(1000);
    gone = ::kill(workers.front(), 0) != 0 || isZombie(workers.front());
  }
  EXPECT_TRUE(gone);
}

} // namespace
