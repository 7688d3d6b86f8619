// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/worker/opened_archive.h"

#include "core/base/ascii_case.h"
#include "meshimport/library_words.h"
#include "meshimport/worker/joined_model.h"
#include "meshimport/worker/limits.h"
#include "meshimport/worker/scene_text.h"
#include "meshimport/worker/zip_archive.h"
#include "meshimport/xml_tags.h"

#include <algorithm>

namespace esm {

namespace {

constexpr std::size_t kMostPartText = 1 << 16; ///< bytes of the scene that are looked at
constexpr std::size_t kMostUnpacked = 1032;    ///< bytes that deflate makes of one
constexpr std::size_t kMostName = 80;          ///< bytes of a part's name in a message

bool hasEnding(const ZipEntry& entry, std::string_view ending)
{
  const std::string name = asciiLower(entry.name);
  return name.size() >= ending.size() && name.substr(name.size() - ending.size()) == ending;
}

std::string whole(const ZipEntry& entry)
{
  std::string text = unpack(entry, kMostUnpacked * (entry.packed.size() + 1));
  allowFor(text.size() / 8); // for the joined text beside what the library makes of it
  return text;
}

/// The entry with the scene; the end if there is none.
std::vector<ZipEntry>::const_iterator sceneOf(const std::vector<ZipEntry>& entries, std::string_view ending)
{
  const auto scene = std::find_if(entries.begin(), entries.end(),
                                  [](const ZipEntry& entry) { return hasEnding(entry, "3d/3dmodel.model"); });
  if (scene != entries.end()) return scene;
  return std::find_if(entries.begin(), entries.end(), [&](const ZipEntry& entry) {
    return hasEnding(entry, ending == "3mf" ? ".model" : ".dae");
  });
}

std::string shortName(std::string_view name)
{
  return std::string(name.substr(0, kMostName));
}
std::string lostText(std::string_view name)
{
  return "its part '" + shortName(name) + "' is missing here: the archive does not hold it";
}

/// Of what a 3MF must have: the list of its relations, and what this names as the root model.
std::string missingPart(const std::vector<ZipEntry>& entries)
{
  const auto find = [&](const std::string& name) {
    return std::find_if(entries.begin(), entries.end(),
                        [&](const ZipEntry& entry) { return asciiLower(entry.name) == asciiLower(name); });
  };
  const auto relations = find("_rels/.rels");
  if (relations == entries.end()) return lostText("_rels/.rels");
  const std::string text = whole(*relations);
  XmlTags tags(text);
  for (XmlTag tag; tags.next(tag);) {
    std::string_view target = tag.attribute("Target");
    if (!tag.attribute("Type").ends_with("/3dmodel") || target.empty()) continue;
    if (target.front() == '/') target.remove_prefix(1);
    return find(std::string(target)) == entries.end() ? lostText(target) : std::string();
  }
  return {};
}

/// The first entry that cannot be unpacked, and why.
std::string brokenPart(const std::vector<ZipEntry>& entries)
{
  for (const ZipEntry& entry : entries) {
    if (entry.size == 0) return "its part '" + shortName(entry.name) + "' is empty";
    if (!canUnpack(entry))
      return "its part '" + shortName(entry.name) + "' is packed by method " + std::to_string(entry.method) +
             ", which is not read";
    if (!isWhole(entry)) return "its part '" + shortName(entry.name) + "' cannot be unpacked";
  }
  return {};
}

/// The root model with what it takes from other files of the archive; empty if it is one file as it is.
std::string oneModel(const ZipEntry& root, const std::vector<ZipEntry>& entries,
                     std::vector<std::string>& lost)
{
  if (std::none_of(
        entries.begin(), entries.end(),
        [&](const ZipEntry& entry) { return hasEnding(entry, ".model") && entry.name != root.name; }) &&
      unpack(root, kMostPartText).find(":path=") == std::string::npos)
    return {};
  return joinedModel(
    whole(root),
    [&](std::string_view path) {
      if (path.substr(0, 1) == "/") path.remove_prefix(1);
      for (const ZipEntry& entry : entries)
        if (entry.name == path) return whole(entry);
      return std::string();
    },
    lost);
}

} // namespace

OpenedArchive openArchive(std::string_view bytes, std::string_view ending)
{
  OpenedArchive opened;
  if (ending != "3mf" && ending != "zae") return opened;
  std::optional<std::vector<ZipEntry>> entries = listZip(bytes);
  if (!entries) return opened;
  auto scene = entries->begin() + (sceneOf(*entries, ending) - entries->cbegin());
  if (ending == "3mf") opened.fault = missingPart(*entries);
  if (opened.fault.empty() && scene != entries->end()) opened.fault = brokenPart({*scene});
  if (ending == "3mf" && opened.fault.empty() && scene != entries->end())
    if (const std::string number = wrongNumber(whole(*scene), ending); !number.empty())
      opened.fault = "its part '" + shortName(scene->name) + "': " + number;
  if (!opened.fault.empty()) return opened;
  if (scene != entries->end()) opened.text = unpack(*scene, kMostPartText);
  if (ending != "3mf" || scene == entries->end()) return opened;
  std::string record;
  const std::string model = oneModel(*scene, *entries, opened.lost);
  if (!model.empty()) *scene = storedEntry(*scene, model, record);
  const auto isNeeded = [](const ZipEntry& entry) {
    return hasEnding(entry, ".model") || hasEnding(entry, ".rels") || hasEnding(entry, "[content_types].xml");
  };
  const std::size_t dropped =
    std::erase_if(*entries, [&](const ZipEntry& entry) { return !isNeeded(entry); });
  if (dropped > 0 || !model.empty()) opened.plain = makeZip(*entries);
  return opened;
}

std::optional<Error> emptyArchive(std::string_view bytes, std::string_view ending, const std::string& origin)
{
  if (ending != "3mf" && ending != "zae") return std::nullopt;
  const std::optional<std::vector<ZipEntry>> entries = listZip(bytes);
  if (!entries) return damagedFile("its ZIP archive is damaged", true, origin);
  const auto scene = sceneOf(*entries, ending);
  if (scene == entries->end()) return std::nullopt;
  const std::string text = whole(*scene);
  if (hasTornTags(text))
    return libraryRefusal("malformed XML", text, "xml",
                          origin + ": its part '" + shortName(scene->name) + "'");
  if (ending == "3mf" && text.find("<triangle ") != text.npos)
    return damagedFile("its <build> places none of its objects", false, origin);
  return std::nullopt;
}

} // namespace esm
