// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/worker/scene_text.h"

#include "core/base/ascii_case.h"
#include "core/base/text_number.h"
#include "meshimport/worker/edited_text.h"
#include "meshimport/xml_tags.h"

#include <algorithm>
#include <span>
#include <vector>

namespace esm {

namespace {

constexpr std::string_view kBlanks = " \t\r\n";
constexpr std::size_t kMostValue = 30; ///< bytes of a wrong value in a message
const char* const kOtherKind = "of an X3D scene only X3D parts are read";
const char* const kPartOfPart = "parts of parts of an X3D scene are not read";
const char* const kItself = "it would be a part of itself";
const char* const kOtherCollada = "parts in other COLLADA files are not read";

std::string withoutEntities(std::string_view text)
{
  std::string plain;
  while (!text.empty()) {
    static constexpr std::pair<std::string_view, char> kEntities[] = {
      {"&quot;", '"'}, {"&apos;", '\''}, {"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}};
    const auto* const entity =
      std::find_if(std::begin(kEntities), std::end(kEntities),
                   [&](const auto& known) { return text.substr(0, known.first.size()) == known.first; });
    const bool isEntity = entity != std::end(kEntities);
    plain += isEntity ? entity->second : text.front();
    text.remove_prefix(isEntity ? entity->first.size() : 1);
  }
  return plain;
}

/// The names in `"a.x3d" "b.x3d"`; a name without quotes stands for itself.
std::vector<std::string> namesIn(std::string_view value)
{
  const std::string text = withoutEntities(value);
  if (text.find('"') == text.npos) return {text};
  std::vector<std::string> names;
  for (std::size_t at = 0;;) {
    const std::size_t begin = text.find('"', at), end = text.find('"', begin + 1);
    if (begin == text.npos || end == text.npos) return names;
    names.push_back(text.substr(begin + 1, end - begin - 1));
    at = end + 1;
  }
}

bool isX3d(const std::filesystem::path& file)
{
  return asciiLower(file.extension().string()) == ".x3d";
}

/// The first of the places at which there is a part to read; what is lost is told if there is none.
std::string placeOfPart(const std::vector<std::string>& names, ModelFolder& folder)
{
  for (const std::string& name : names) {
    const std::filesystem::path file = folder.find(name);
    if (file.empty()) continue;
    if (file != folder.model() && isX3d(file)) {
      for (const std::string& other : names) folder.forget(other);
      return file.lexically_relative(folder.path()).string();
    }
    folder.lose(name, file == folder.model() ? kItself : kOtherKind);
  }
  return {};
}

std::string inQuotes(std::string_view plain)
{
  std::string text = "\"";
  for (const char c : plain) {
    if (c == '&')
      text += "&amp;";
    else if (c == '"')
      text += "&quot;";
    else if (c == ' ')
      text += "%20"; // blanks end a name in a list
    else if (c == '%')
      text += "%25";
    else
      text += c;
  }
  return text + '"';
}

/// The text of a glTF, which a .glb has in its first chunk.
std::string_view jsonOf(std::string_view bytes)
{
  constexpr std::size_t kChunk = 20; ///< where the first chunk of a .glb begins
  if (bytes.substr(0, 4) != "glTF" || bytes.size() < kChunk) return bytes;
  std::size_t size = 0;
  for (int i = 3; i >= 0; --i)
    size = size << 8 | static_cast<unsigned char>(bytes[12 + static_cast<std::size_t>(i)]);
  return bytes.substr(kChunk, size);
}

/// Extensions that change how things look, or that the library reads.
bool isHarmless(std::string_view extension)
{
  constexpr std::string_view kLooks[] = {"KHR_materials_",
                                         "KHR_texture_",
                                         "EXT_texture_",
                                         "MSFT_texture_",
                                         "KHR_lights_",
                                         "EXT_lights_",
                                         "KHR_xmp",
                                         "KHR_animation",
                                         "KHR_audio",
                                         "VRM",
                                         "KHR_draco_mesh_compression"};
  return std::any_of(std::begin(kLooks), std::end(kLooks),
                     [&](std::string_view known) { return extension.substr(0, known.size()) == known; });
}

} // namespace

std::string plainX3d(std::string_view text, ModelFolder& folder, bool isPart)
{
  EditedText edited(text);
  XmlTags tags(text);
  for (XmlTag tag; tags.next(tag);) {
    const std::string_view value = tag.attribute("url");
    if (value.empty()) continue;
    std::string place;
    if (tag.name == "Inline" && !isPart)
      place = placeOfPart(namesIn(value), folder);
    else if (tag.name == "Inline" || tag.name == "ExternProtoDeclare")
      for (const std::string& name : namesIn(value)) folder.lose(name.substr(0, name.find('#')), kPartOfPart);
    const auto begin = static_cast<std::size_t>(value.data() - text.data());
    const std::size_t name = text.rfind("url", begin - 1);
    edited.replace(name, begin + value.size() + 1, place.empty() ? "" : "url=" + inQuotes(place));
  }
  return edited.take();
}

std::string plainCollada(std::string_view text, ModelFolder& folder)
{
  EditedText edited(text);
  XmlTags tags(text);
  for (XmlTag tag; tags.next(tag);) {
    const std::string_view url = tag.attribute("url");
    if (tag.name.substr(0, 9) != "instance_" || url.empty() || url[0] == '#') continue;
    const auto begin = static_cast<std::size_t>(tag.name.data() - text.data()) - 1;
    edited.replace(begin, endOfElement(tags, tag), "");
    folder.lose(withoutEntities(url.substr(0, url.find('#'))), kOtherCollada);
  }
  return edited.take();
}

std::string plainAmf(std::string_view text)
{
  EditedText edited(text);
  XmlTags tags(text);
  bool hasVolume = false;                  // in this mesh
  std::size_t endBegin = 0, endBehind = 0; // of the tag that ends it; equal: it has gone
  for (XmlTag tag; tags.next(tag);) {
    const auto begin = static_cast<std::size_t>(tag.name.data() - text.data()) - (tag.isEnd ? 2 : 1);
    if (tag.name == "mesh") {
      if (tag.isEnd && hasVolume && endBegin == endBehind) edited.replace(begin, begin, "</volume>");
      hasVolume = false;
    }
    if (hasVolume && endBegin == endBehind && !tag.isEnd && (tag.name == "color" || tag.name == "metadata"))
      edited.replace(begin, endOfElement(tags, tag), ""); // a volume may have one colour, of each name one
    if (tag.name != "volume") continue;
    if (tag.isEnd) {
      endBegin = begin, endBehind = tags.position();
    } else if (hasVolume || tag.isEmpty) {
      if (hasVolume && endBegin != endBehind) edited.replace(endBegin, endBehind, "");
      if (hasVolume) endBegin = endBehind;
      edited.replace(begin, tags.position(), "");
    } else {
      hasVolume = true;
      endBegin = endBehind = begin;
      if (!tag.attributes.empty()) edited.replace(begin, tags.position(), "<volume>");
    }
  }
  return edited.take();
}

std::string wrongNumber(std::string_view text, std::string_view ending)
{
  constexpr std::string_view kValues[] = {"x", "y", "z", "v1", "v2", "v3"};
  const auto isNumber = [](std::string_view value) {
    value.remove_prefix(std::min(value.find_first_not_of(kBlanks), value.size()));
    return parseDouble(value.substr(0, value.find_last_not_of(kBlanks) + 1)).has_value();
  };
  const auto lineOf = [&](const XmlTag& tag) {
    return std::to_string(1 + std::count(text.data(), tag.name.data(), '\n'));
  };
  XmlTags tags(text);
  for (XmlTag tag; tags.next(tag);) {
    if (tag.isEnd) continue;
    if (ending == "amf" && std::ranges::find(kValues, tag.name) != std::end(kValues) &&
        !isNumber(tags.content()))
      return "line " + lineOf(tag) + ": '" + std::string(tags.content().substr(0, kMostValue)) +
             "' stands where a number should be";
    if (ending != "3mf" || (tag.name != "vertex" && tag.name != "triangle")) continue;
    for (const std::string_view name : std::span(kValues).subspan(tag.name == "vertex" ? 0 : 3, 3))
      if (!isNumber(tag.attribute(name)))
        return "line " + lineOf(tag) + ": '" + std::string(name) + "' of " + std::string(tag.name) +
               " holds something else than it should";
  }
  return {};
}

std::string unreadableExtension(std::string_view bytes)
{
  std::string_view text = jsonOf(bytes);
  const std::size_t place = text.find("\"extensionsRequired\"");
  if (place == text.npos) return {};
  text.remove_prefix(place);
  text = text.substr(0, text.find(']'));
  for (std::size_t at = text.find('['); at < text.size();) {
    const std::size_t begin = text.find('"', at), end = text.find('"', begin + 1);
    if (begin == text.npos || end == text.npos) return {};
    const std::string_view extension = text.substr(begin + 1, end - begin - 1);
    if (!isHarmless(extension)) return std::string(extension);
    at = end + 1;
  }
  return {};
}

} // namespace esm
