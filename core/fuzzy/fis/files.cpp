// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/fis/files.h"

#include "core/fuzzy/fis/source_text.h"

namespace esm::fis {

std::optional<Format> formatOf(const std::filesystem::path& path)
{
  const std::string ending = path.extension().string();
  if (equalIgnoringCase(ending, ".fll")) return Format::Fll;
  if (equalIgnoringCase(ending, ".fcl")) return Format::Fcl;
  if (equalIgnoringCase(ending, ".fis")) return Format::Fis;
  return std::nullopt;
}

std::string_view nameOf(Format format) noexcept
{
  return format == Format::Fll ? "FLL" : format == Format::Fcl ? "FCL" : "FIS";
}

Result<System> readSystem(Format format, std::string_view text, std::string_view fileName,
                          const ReadOptions& options)
{
  if (format != Format::Fcl && !options.block.empty())
    return Error{ErrorCode::InvalidValue, std::string(fileName) + ": only FCL has function blocks to choose"};
  switch (format) {
  case Format::Fll:
    return readFll(text, fileName, options);
  case Format::Fcl:
    return readFcl(text, fileName, options);
  case Format::Fis:
    break;
  }
  return readFis(text, fileName, options);
}

Written writeSystem(Format format, const System& system)
{
  switch (format) {
  case Format::Fll:
    return writeFll(system);
  case Format::Fcl:
    return writeFcl(system);
  case Format::Fis:
    break;
  }
  return writeFis(system);
}

} // namespace esm::fis
