// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "meshimport/xml_tags.h"

#include <string>
#include <string_view>
#include <utility>

namespace esm {

/// A text with pieces of it replaced, from its beginning to its end.
class EditedText {
public:
  explicit EditedText(std::string_view text) : m_text(text) {}

  void replace(std::size_t begin, std::size_t end, std::string_view by)
  {
    m_out.append(m_text.substr(m_done, begin - m_done));
    m_out += by;
    m_done = end;
  }

  /// Empty if nothing was replaced.
  std::string take()
  {
    if (m_done > 0) m_out.append(m_text.substr(m_done));
    return std::move(m_out);
  }

private:
  std::string_view m_text;
  std::string m_out;
  std::size_t m_done = 0;
};

/// Just behind the end of the element whose first tag was read last.
inline std::size_t endOfElement(XmlTags& tags, const XmlTag& first)
{
  const std::string_view name = first.name;
  int depth = first.isEmpty ? 0 : 1;
  for (XmlTag tag; depth > 0 && tags.next(tag);)
    if (tag.name == name && !tag.isEmpty) depth += tag.isEnd ? -1 : 1;
  return tags.position();
}

} // namespace esm
