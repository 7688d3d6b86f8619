// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/base/work_control.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace esm {

/// Another program, and the limits that it has.
struct ChildTask {
  std::vector<std::string> words; ///< the program (without a slash: one of the PATH) and its arguments
  std::filesystem::path folder;   ///< where it works; empty: where we do
  std::chrono::duration<double> wall{600.0};

  /// How long the answer is that it writes to its file kAnswerFile, told from the first `headBytes` of it;
  /// nothing: it is none. Null: it has no such file, and is over when it ends.
  std::optional<std::uint64_t> (*answerBytes)(std::string_view head) = nullptr;
  std::size_t headBytes = 0;

  static constexpr int kAnswerFile = 3;
};

/// How it ended, and what it has left.
struct ChildEnd {
  enum class Way {
    Exited,  ///< number: its exit code
    Killed,  ///< number: the signal that ended it, from whomever
    TooLong, ///< we ended it
    Garbled  ///< we ended it, for its answer had no head or was longer than its head says
  };
  Way way = Way::Exited;
  int number = 0;
  std::string answer;    ///< one byte more than its head says where it is longer
  std::string complaint; ///< the last of what it said on stderr, at most 4 KB

  bool done() const noexcept { return way == Way::Exited && number == 0; }
};

/// Runs a program and waits for its end. It inherits nothing of ours but the environment: no open file, no
/// blocked or ignored signal; it reads nothing on stdin, and what it says on stdout is thrown away. When it is
/// over, or no longer wanted, it is reaped, and what it has started in its process group is killed.
/// @param control when cancelled, it is killed within 20 ms, and the answer is Cancelled
/// @note Threads: any; blocks. Errors: Internal with the reason (of the system) why it cannot be started.
Result<ChildEnd> runChild(const ChildTask& task, WorkControl* control);

/// Whether the PATH has a program of that name.
bool isInPath(const std::string& program);

/// The last line of a complaint, short enough for a message.
std::string gistOf(std::string_view complaint);

} // namespace esm
