// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/worker/sandbox.h"
#include "tests/meshimport/import_bytes.h"

#include <cerrno>
#include <fcntl.h>
#include <sys/socket.h>
#include <sys/wait.h>

namespace {

using namespace esm;
using namespace esm::test;

constexpr int kHolds = 0, kBroken = 1, kNotOffered = 2;

/// The exit code of a child process that does this; walls cannot be taken down again.
template <class Work>
int inChild(const Work& work)
{
  const pid_t child = ::fork();
  if (child == 0) ::_exit(work());
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : kBroken;
}

bool isRefused(int result)
{
  return result < 0 && errno == EACCES;
}

TEST(WorkerWalls, noSocketAndNoProgramOnceTheNetworkIsClosed)
{
  const int outcome = inChild([] {
    if (!closeNetwork()) return kNotOffered;
    char program[] = "/bin/true";
    char* const words[] = {program, nullptr};
    for (const int family : {AF_UNIX, AF_INET, AF_INET6, AF_NETLINK})
      if (!isRefused(::socket(family, SOCK_STREAM, 0))) return kBroken;
    int pair[2];
    if (!isRefused(::socketpair(AF_UNIX, SOCK_STREAM, 0, pair)) || !isRefused(::execv(program, words)))
      return kBroken;
    return ::open("/dev/null", O_RDONLY) >= 0 ? kHolds : kBroken; // all else goes on
  });
  if (outcome == kNotOffered) GTEST_SKIP() << "no seccomp here";
  EXPECT_EQ(outcome, kHolds);
}

TEST(WorkerWalls, onlyTheModelsFolderIsOpenOnceTheOthersAreClosed)
{
  const TempFolder folder;
  const auto outside = folder.write("outside.txt", "a"), inside = folder.write("model/deep/part.txt", "b");
  std::filesystem::create_symlink(outside, folder.path() / "model" / "link.txt");
  const auto opens = [](const std::filesystem::path& file) { return ::open(file.c_str(), O_RDONLY) >= 0; };
  const int outcome = inChild([&] {
    if (!closeOtherFolders(folder.path() / "model")) return kNotOffered;
    const bool holds = opens(inside) && !opens(outside) && !opens(folder.path() / "model" / "link.txt") &&
                       !opens("/etc/passwd") && !opens("/proc/self/environ");
    return holds ? kHolds : kBroken;
  });
  if (outcome == kNotOffered) GTEST_SKIP() << "no Landlock here";
  EXPECT_EQ(outcome, kHolds);
}

} // namespace
