// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/text_number.h"

#include <charconv>

namespace esm {

namespace {

template <class T>
std::optional<T> parseWhole(std::string_view text) noexcept
{
  if (!text.empty() && text.front() == '+') {
    text.remove_prefix(1);
    if (!text.empty() && text.front() == '-') return std::nullopt;
  }
  T value{};
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

} // namespace

std::optional<double> parseDouble(std::string_view text) noexcept
{
  return parseWhole<double>(text);
}

std::optional<long long> parseInteger(std::string_view text) noexcept
{
  return parseWhole<long long>(text);
}

void appendDouble(std::string& text, double value)
{
  char buffer[32];
  const auto result = std::to_chars(buffer, buffer + sizeof buffer, value);
  text.append(buffer, result.ptr);
}

std::string formatDouble(double value)
{
  std::string text;
  appendDouble(text, value);
  return text;
}

std::string formatDouble(double value, int digits)
{
  char buffer[64];
  const auto result =
    std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, digits);
  return std::string(buffer, result.ptr);
}

} // namespace esm
