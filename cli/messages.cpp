// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "cli/messages.h"

#include "core/base/json_line.h"
#include "core/base/text_encoding.h"

#include <algorithm>
#include <iostream>
#include <string_view>
#include <unistd.h>

namespace esm::cli {

namespace {

std::string lastSaid;
bool objectPrinted = false;

/// Names in files may hold line breaks and escape sequences, which would steer the terminal.
std::string masked(std::string_view line, bool keepLines)
{
  std::string out;
  while (!line.empty()) {
    const std::size_t length = utf8Length(line);
    const std::string_view character = line.substr(0, length);
    const char c = line.front();
    const bool blank = c == '\n' || c == '\r' || c == '\t';
    if (keepLines && (c == '\n' || c == '\t'))
      out += c;
    else if (length == 0 || isControlCharacter(character))
      out += blank ? ' ' : '?';
    else
      out += character;
    line.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return out;
}

} // namespace

void say(const std::string& message)
{
  lastSaid = message;
  std::cerr << "esm: " + masked(message, false) + "\n" << std::flush;
}

Exit fail(const Error& error)
{
  say(error.detail);
  switch (error.code) {
  case ErrorCode::Numerics:
    return Exit::Numerics;
  case ErrorCode::OutOfMemory:
  case ErrorCode::Internal:
    return Exit::Internal;
  default:
    return Exit::BadInput;
  }
}

void print(const std::string& line)
{
  objectPrinted |= line.starts_with('{');
  std::cout << masked(line, true) + "\n" << std::flush;
}

void printFailure(Exit exit)
{
  if (objectPrinted) return;
  JsonLine object;
  object.add("error", lastSaid);
  object.add("exit_code", static_cast<int>(exit));
  print(object.text());
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
