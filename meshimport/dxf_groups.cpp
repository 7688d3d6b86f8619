// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/dxf_groups.h"

namespace esm {

std::string_view DxfEntities::takeLine()
{
  const std::size_t end = m_rest.find_first_of("\r\n");
  std::string_view line = m_rest.substr(0, end);
  if (end == std::string_view::npos) {
    m_rest = {};
  } else {
    const bool pair = m_rest[end] == '\r' && m_rest.substr(end + 1, 1) == "\n";
    m_rest.remove_prefix(end + (pair ? 2 : 1));
    ++m_line;
  }
  const std::size_t first = line.find_first_not_of(" \t"), last = line.find_last_not_of(" \t");
  return first == std::string_view::npos ? line.substr(0, 0) : line.substr(first, last - first + 1);
}

bool DxfEntities::takeGroup(DxfGroup& group)
{
  if (atEnd()) return false;
  const DxfEntities before = *this;
  const auto code = parseInteger(takeLine());
  if (!code || *code < -5 || *code > 1071 || m_rest.empty()) {
    *this = before;
    return false;
  }
  group.code = static_cast<int>(*code);
  group.value = takeLine();
  return true;
}

bool DxfEntities::next(DxfEntity& entity)
{
  DxfGroup group;
  do {
    if (!takeGroup(group)) return false;
  } while (group.code != 0);
  entity.name = group.value;
  entity.line = m_line - 1;
  entity.groups.clear();
  for (;;) {
    const DxfEntities before = *this;
    if (!takeGroup(group)) return true;
    if (group.code == 0) {
      *this = before;
      return true;
    }
    entity.groups.push_back(group);
  }
}

} // namespace esm
