// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace esm {

/// One tag of an XML text: <name a="b">, </name> or <name/>.
struct XmlTag {
  std::string_view name;
  std::string_view attributes; ///< everything behind the name
  bool isEnd = false;          ///< </name>
  bool isEmpty = false;        ///< <name/>

  /// Empty if there is none.
  std::string_view attribute(std::string_view wanted) const;
};

/// Walks through the tags of an XML text; comments, declarations and processing instructions are passed over.
/// No tree is built and nothing is decoded: for formats whose attributes are plain names and numbers.
class XmlTags {
public:
  explicit XmlTags(std::string_view text) : m_text(text) {}
  bool next(XmlTag& tag);
  /// The text behind the last tag, up to the next '<'.
  std::string_view content() const { return m_text.substr(m_at, m_text.find('<', m_at) - m_at); }
  std::size_t position() const { return m_at; } ///< just behind the last tag

private:
  std::string_view m_text;
  std::size_t m_at = 0;
};

} // namespace esm
