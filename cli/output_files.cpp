// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "cli/output_files.h"

#include "core/base/ascii_case.h"
#include "core/base/file_io.h"

#include <CLI/CLI.hpp>

#include <filesystem>

namespace esm::cli {

namespace {

namespace fs = std::filesystem;

/// One name for one file, also for one that is not there yet.
fs::path placeOf(const std::string& name)
{
  const Result<fs::path> file = behindLinks(name);
  std::error_code code;
  const fs::path whole = fs::absolute(file ? *file : fs::path(name), code);
  const fs::path place = fs::weakly_canonical(whole, code);
  return code ? whole : place;
}

bool isOneFile(const std::string& a, const std::string& b)
{
  std::error_code code;
  return placeOf(a) == placeOf(b) || fs::equivalent(a, b, code);
}

} // namespace

void keepFilesApart(const std::vector<std::string>& read, const std::vector<std::string>& written)
{
  for (std::size_t i = 0; i < written.size(); ++i) {
    const std::string& output = written[i];
    if (output.empty() || !specialFileKind(output).empty()) continue;
    for (const std::string& input : read)
      if (!input.empty() && isOneFile(input, output))
        throw CLI::ValidationError(output, "would be written over what is read from it; name another file");
    for (std::size_t k = 0; k < i; ++k)
      if (!written[k].empty() && isOneFile(written[k], output))
        throw CLI::ValidationError(output, "is named for two outputs; give each a file of its own");
  }
}

std::vector<std::string> exportedFiles(const std::string& output)
{
  const fs::path path = output;
  if (asciiLower(path.extension().string()) != ".csv") return {output};
  return {output, (path.parent_path() / (path.stem().string() + "_springs.csv")).string()};
}

} // namespace esm::cli
