// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/worker/joined_model.h"

#include "core/base/text_number.h"
#include "meshimport/worker/edited_text.h"
#include "meshimport/xml_tags.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>

namespace esm {

namespace {

/// The value of "p:path", whatever its prefix is.
std::string_view pathOf(const XmlTag& tag)
{
  const std::size_t place = tag.attributes.find(":path");
  if (place == std::string_view::npos) return {};
  const std::size_t begin = tag.attributes.find_last_of(" \t\r\n", place) + 1;
  return tag.attribute(tag.attributes.substr(begin, place + 5 - begin));
}

class ModelJoiner {
public:
  ModelJoiner(const std::function<std::string(std::string_view)>& part, std::vector<std::string>& lost)
    : m_part(part), m_lost(lost)
  {}

  std::string run(std::string_view root)
  {
    XmlTags tags(root);
    bool hasParts = false;
    for (XmlTag tag; tags.next(tag);) {
      if (const auto id = parseInteger(tag.attribute("id"))) m_last = std::max<std::int64_t>(m_last, *id);
      hasParts = hasParts || !pathOf(tag).empty();
    }
    if (!hasParts) return {};
    std::string text = renumbered(root, "");
    std::string objects;
    for (std::size_t i = 0; i < m_wanted.size(); ++i) objects += objectsOf(m_wanted[i]); // grows meanwhile
    const std::size_t end = text.find("</resources>");
    return end == text.npos ? text : text.insert(end, objects);
  }

private:
  /// A number of its own in the joined text for each object of another file.
  std::int64_t idOf(std::string_view path, std::string_view id)
  {
    if (path.empty()) return parseInteger(id).value_or(0);
    const auto [place, isNew] = m_ids.try_emplace({std::string(path), std::string(id)}, m_last + 1);
    if (isNew) ++m_last;
    return place->second;
  }

  bool isThere(const std::string& path)
  {
    const auto [place, isNew] = m_texts.try_emplace(path);
    if (!isNew) return !place->second.empty();
    place->second = m_part(path);
    if (place->second.empty()) m_lost.push_back(path);
    m_wanted.push_back(path);
    return !place->second.empty();
  }

  /// The text with its objects under their numbers in the joined one; what names an absent file goes.
  std::string renumbered(std::string_view text, std::string_view path)
  {
    EditedText edited(text);
    XmlTags tags(text);
    for (XmlTag tag; tags.next(tag);) {
      if (tag.isEnd) continue;
      const bool isObject = tag.name == "object", isPlaced = tag.name == "component" || tag.name == "item";
      if (!isObject && !isPlaced) continue;
      const std::string other(isPlaced ? pathOf(tag) : std::string_view());
      if (!other.empty() && !isThere(other)) {
        const auto begin = static_cast<std::size_t>(tag.name.data() - text.data()) - 1;
        edited.replace(begin, tags.position(), "");
        continue;
      }
      const std::string_view id = tag.attribute(isObject ? "id" : "objectid");
      if (id.empty()) continue;
      const auto begin = static_cast<std::size_t>(id.data() - text.data());
      edited.replace(begin, begin + id.size(),
                     std::to_string(idOf(other.empty() ? path : std::string_view(other), id)));
    }
    const std::string out = edited.take();
    return out.empty() ? std::string(text) : out;
  }

  std::string objectsOf(const std::string& path)
  {
    const std::string text = renumbered(m_texts[path], path);
    std::string objects;
    XmlTags tags(text);
    for (XmlTag tag; tags.next(tag);) {
      if (tag.name != "object" || tag.isEnd) continue;
      const auto begin = static_cast<std::size_t>(tag.name.data() - text.data()) - 1;
      objects += std::string_view(text).substr(begin, endOfElement(tags, tag) - begin);
    }
    m_texts[path] = "-"; // its text is in use no longer, but it was there
    return objects;
  }

  const std::function<std::string(std::string_view)>& m_part;
  std::vector<std::string>& m_lost;
  std::int64_t m_last = 0;
  std::map<std::pair<std::string, std::string>, std::int64_t> m_ids;
  std::map<std::string, std::string, std::less<>> m_texts;
  std::vector<std::string> m_wanted;
};

} // namespace

std::string joinedModel(std::string_view root, const std::function<std::string(std::string_view path)>& part,
                        std::vector<std::string>& lost)
{
  return ModelJoiner(part, lost).run(root);
}

} // namespace esm
