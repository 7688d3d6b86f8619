// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"

#include <string>

namespace esm::cli {

/// What the program says with its exit code. Scripts rely on the numbers.
enum class Exit { Done = 0, BadInput = 1, WrongUsage = 2, Numerics = 3, Internal = 4 };

/// One line on stderr: "esm: ...".
void say(const std::string& message);
/// Says why, and returns the exit code for this kind of fault.
Exit fail(const Error& error);
/// One line on stdout: results for people, or the JSON object, which begins with a brace.
void print(const std::string& line);
/// For a command with --json that failed before it printed its object: prints one with what was said last and
/// the exit code, so that a caller always has an object to read.
void printFailure(Exit exit);

/// Per cent of a long work on stderr, if that is a terminal; gone when the work ends.
class Progress {
public:
  explicit Progress(std::string what);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  void show(long long done, long long total);

private:
  std::string m_what;
  bool m_terminal;
  long long m_shown = -1;
};

} // namespace esm::cli
