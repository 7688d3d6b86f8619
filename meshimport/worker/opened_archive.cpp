// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/worker/opened_archive.h"

#include "core/base/ascii_case.h"
#include "meshimport/worker/zip_archive.h"

#include <algorithm>

namespace esm {

namespace {

constexpr std::size_t kMostPartText = 1 << 16; ///< bytes of the scene that are looked at

bool hasEnding(const ZipEntry& entry, std::string_view ending)
{
  const std::string name = asciiLower(entry.name);
  return name.size() >= ending.size() && name.substr(name.size() - ending.size()) == ending;
}

} // namespace

OpenedArchive openArchive(std::string_view bytes, std::string_view ending)
{
  OpenedArchive opened;
  if (ending != "3mf" && ending != "zae") return opened;
  std::optional<std::vector<ZipEntry>> entries = listZip(bytes);
  if (!entries) return opened;
  const char* const sceneEnding = ending == "3mf" ? ".model" : ".dae";
  auto scene = std::find_if(entries->begin(), entries->end(),
                            [](const ZipEntry& entry) { return hasEnding(entry, "3d/3dmodel.model"); });
  if (scene == entries->end())
    scene = std::find_if(entries->begin(), entries->end(),
                         [&](const ZipEntry& entry) { return hasEnding(entry, sceneEnding); });
  if (scene != entries->end()) opened.text = unpack(*scene, kMostPartText);
  if (ending != "3mf") return opened;
  const auto isNeeded = [](const ZipEntry& entry) {
    return hasEnding(entry, ".model") || hasEnding(entry, ".rels") || hasEnding(entry, "[content_types].xml");
  };
  if (std::erase_if(*entries, [&](const ZipEntry& entry) { return !isNeeded(entry); }) > 0)
    opened.without = makeZip(*entries);
  return opened;
}

} // namespace esm
