// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/xml_tags.h"

namespace esm {

namespace {

constexpr std::string_view kBlanks = " \t\r\n";

} // namespace

std::string_view XmlTag::attribute(std::string_view wanted) const
{
  for (std::string_view rest = attributes;;) {
    const std::size_t first = rest.find_first_not_of(kBlanks);
    if (first == std::string_view::npos) return {};
    const std::size_t equals = rest.find('=', first);
    if (equals == std::string_view::npos) return {};
    std::string_view key = rest.substr(first, equals - first);
    key = key.substr(0, key.find_first_of(kBlanks));
    const std::size_t quote = rest.find_first_of("\"'", equals);
    if (quote == std::string_view::npos) return {};
    const std::size_t end = rest.find(rest[quote], quote + 1);
    if (end == std::string_view::npos) return {};
    if (key == wanted) return rest.substr(quote + 1, end - quote - 1);
    rest.remove_prefix(end + 1);
  }
}

bool XmlTags::next(XmlTag& tag)
{
  for (;;) {
    m_at = m_text.find('<', m_at);
    if (m_at == std::string_view::npos) {
      m_at = m_text.size();
      return false;
    }
    const std::string_view rest = m_text.substr(m_at);
    std::string_view close = ">";
    bool isTag = false;
    if (rest.substr(0, 4) == "<!--") {
      close = "-->";
    } else if (rest.substr(0, 9) == "<![CDATA[") {
      close = "]]>";
    } else if (rest.substr(0, 2) == "<?") {
      close = "?>";
    } else {
      isTag = rest.substr(0, 2) != "<!";
    }
    std::size_t end = rest.find(close);
    if (isTag) { // a '>' within quotes ends nothing
      char quote = '\0';
      for (end = 1; end < rest.size() && (quote != '\0' || rest[end] != '>'); ++end) {
        if (quote == '\0' && (rest[end] == '"' || rest[end] == '\''))
          quote = rest[end];
        else if (rest[end] == quote)
          quote = '\0';
      }
      if (end == rest.size()) end = std::string_view::npos;
    }
    if (end == std::string_view::npos) {
      m_at = m_text.size();
      return false;
    }
    m_at += end + close.size();
    if (!isTag) continue;
    std::string_view inside = rest.substr(1, end - 1);
    tag = {};
    if (inside.substr(0, 1) == "/") {
      tag.isEnd = true;
      inside.remove_prefix(1);
    }
    if (!inside.empty() && inside.back() == '/') {
      tag.isEmpty = true;
      inside.remove_suffix(1);
    }
    tag.name = inside.substr(0, inside.find_first_of(kBlanks));
    tag.attributes = inside.substr(tag.name.size());
    return true;
  }
}

} // namespace esm
