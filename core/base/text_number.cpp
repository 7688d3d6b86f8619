// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/text_number.h"

#include <algorithm>
#include <charconv>
#include <iterator>

namespace esm {

namespace {

constexpr auto kPlain = [](const char* from, const char* end, auto& value) noexcept {
  return std::from_chars(from, end, value);
};

/// @param read  as std::from_chars()
template <class T, class Read>
std::optional<T> parseWhole(std::string_view text, const Read& read) noexcept
{
  if (!text.empty() && text.front() == '+') {
    text.remove_prefix(1);
    if (!text.empty() && text.front() == '-') return std::nullopt;
  }
  T value{};
  const auto [end, code] = read(text.data(), text.data() + text.size(), value);
  if (code != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

} // namespace

std::optional<double> parseDouble(std::string_view text) noexcept
{
  return parseWhole<double>(text, kPlain);
}

std::optional<double> parseForeignDouble(std::string_view text) noexcept
{
  return parseWhole<double>(text, foreignDoubleFromChars);
}

std::from_chars_result foreignDoubleFromChars(const char* from, const char* end, double& value) noexcept
{
  const auto isSign = [](char c) { return c == '+' || c == '-'; };
  const std::from_chars_result plain = std::from_chars(from, end, value);
  const char* const mantissaEnd = plain.ptr;
  if (plain.ec == std::errc::invalid_argument || mantissaEnd == end) return plain;
  const bool hasLetter = *mantissaEnd == 'D' || *mantissaEnd == 'd';
  if (!hasLetter && !isSign(*mantissaEnd)) return plain;
  const char* const exponent = mantissaEnd + (hasLetter ? 1 : 0);
  const char* const digits = exponent != end && isSign(*exponent) ? exponent + 1 : exponent;
  const char* const behind = std::find_if(digits, end, [](char c) { return c < '0' || c > '9'; });
  // Fortran leaves the letter out where the exponent takes three digits, and never the point.
  if (!hasLetter && (behind - digits != 3 || std::find(from, mantissaEnd, '.') == mantissaEnd)) return plain;
  char text[64]; // Fortran writes 17 digits; of longer ones the value would be another
  if (behind == digits || behind - from >= std::ssize(text)) return plain;
  char* last = std::copy(from, mantissaEnd, text);
  *last++ = 'e';
  last = std::copy(exponent, behind, last);
  double whole = 0.0;
  const std::from_chars_result result = std::from_chars(text, last, whole);
  if (result.ptr != last) return plain; // it had an exponent already
  if (result.ec == std::errc{}) value = whole;
  return {behind, result.ec};
}

std::optional<long long> parseInteger(std::string_view text) noexcept
{
  return parseWhole<long long>(text, kPlain);
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
