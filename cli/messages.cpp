// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "cli/messages.h"

#include <algorithm>
#include <iostream>
#include <unistd.h>

namespace esm::cli {

namespace {

/// Names in files may hold line breaks and escape sequences, which would steer the terminal.
std::string masked(std::string line, bool keepLines)
{
  const auto steers = [&](char c) {
    return (static_cast<unsigned char>(c) < 0x20 && !(keepLines && (c == '\n' || c == '\t'))) || c == 0x7f;
  };
  for (char& c : line)
    if (steers(c)) c = c == '\n' || c == '\r' || c == '\t' ? ' ' : '?';
  return line;
}

} // namespace

void say(const std::string& message)
{
  std::cerr << "esm: " + masked(message, false) + "\n" << std::flush;
}

Exit fail(const Error& error)
{
  say(error.detail);
  switch (error.code) {
  case ErrorCode::Numerics:
    return Exit::Numerics;
  case ErrorCode::Internal:
    return Exit::Internal;
  default:
    return Exit::BadInput;
  }
}

void print(const std::string& line)
{
  std::cout << masked(line, true) + "\n" << std::flush;
}

Progress::Progress(std::string what) : m_what(std::move(what)), m_terminal(::isatty(STDERR_FILENO) == 1) {}

Progress::~Progress()
{
  if (m_terminal && m_shown >= 0) std::cerr << "\r\x1b[K" << std::flush;
}

void Progress::show(long long done, long long total)
{
  const long long percent = total > 0 ? 100 * done / total : 100;
  if (!m_terminal || percent == m_shown) return;
  m_shown = percent;
  std::cerr << "\r" + m_what + " " + std::to_string(percent) + " %\x1b[K" << std::flush;
}

} // namespace esm::cli
