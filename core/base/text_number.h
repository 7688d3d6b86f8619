// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <charconv>
#include <optional>
#include <string>
#include <string_view>

namespace esm {

/// Numbers in files and on the command line. Always with a point, whatever the locale: Qt calls
/// setlocale(), and under de_DE strtod("1.5") is 1. Any thread.

/// The whole of `text` as a number; a leading '+' is allowed, blanks are not. "inf" and "nan" parse.
std::optional<double> parseDouble(std::string_view text) noexcept;
std::optional<long long> parseInteger(std::string_view text) noexcept;

/// The same for numbers of files that other programs write: exponents may be those of Fortran: with
/// D (1.0D+01), or of three digits without a letter (1.0-101).
std::optional<double> parseForeignDouble(std::string_view text) noexcept;

/// std::from_chars() that knows Fortran's exponents.
std::from_chars_result foreignDoubleFromChars(const char* from, const char* end, double& value) noexcept;

/// The shortest text that reads back to the same bits.
std::string formatDouble(double value);
void appendDouble(std::string& text, double value);

/// `digits` significant digits, for messages.
std::string formatDouble(double value, int digits);

} // namespace esm
