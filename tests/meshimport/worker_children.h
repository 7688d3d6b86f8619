// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace esm::test {

/// The processes that the process has started and not yet reaped.
inline std::vector<pid_t> childrenOf(pid_t process)
{
  std::vector<pid_t> children;
  std::error_code code;
  const auto threads = "/proc/" + std::to_string(process) + "/task";
  for (const auto& thread : std::filesystem::directory_iterator(threads, code)) {
    std::ifstream list(thread.path() / "children");
    for (pid_t child = 0; list >> child;) children.push_back(child);
  }
  return children;
}

inline std::vector<pid_t> childrenOfThisProcess()
{
  return childrenOf(::getpid());
}

inline bool isZombie(pid_t process)
{
  std::ifstream status("/proc/" + std::to_string(process) + "/stat");
  std::string word;
  status >> word >> word >> word;
  return word == "Z";
}

} // namespace esm::test
