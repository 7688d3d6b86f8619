// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace esm::cli {

/// Throws the parser's ValidationError if a command would write over a file that it reads, or twice into one;
/// by whatever name or link. Empty names are passed over; devices and pipes may be named as often as one likes.
void keepFilesApart(const std::vector<std::string>& read, const std::vector<std::string>& written);

/// The files of an export to `output`: for .csv there are two.
std::vector<std::string> exportedFiles(const std::string& output);

} // namespace esm::cli
