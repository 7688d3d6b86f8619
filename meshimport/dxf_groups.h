// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/text_number.h"

#include <Eigen/Core>

#include <limits>
#include <string_view>
#include <vector>

namespace esm {

/// A DXF file is pairs of lines: a number that tells what follows, and the value.
struct DxfGroup {
  int code = 0;
  std::string_view value; ///< without blanks around it
};

/// One entity: its name (code 0) and its groups. The text outlives it.
struct DxfEntity {
  std::string_view name;
  long line = 0;
  std::vector<DxfGroup> groups;

  std::string_view text(int code) const
  {
    for (const DxfGroup& group : groups)
      if (group.code == code) return group.value;
    return {};
  }
  /// `missing` if there is no such group; NaN if it is no number.
  double number(int code, double missing = 0.0) const
  {
    const std::string_view value = text(code);
    if (value.data() == nullptr) return missing;
    return parseForeignDouble(value).value_or(std::numeric_limits<double>::quiet_NaN());
  }
  long long integer(int code) const { return parseInteger(text(code)).value_or(0); }
  Eigen::Vector3d point(int code) const { return {number(code), number(code + 10), number(code + 20)}; }
};

/// Walks through the entities of a file. Copying it marks a place.
class DxfEntities {
public:
  explicit DxfEntities(std::string_view text) : m_rest(text) {}
  /// False at the end of the file, or where no group follows any more (ask atEnd()).
  bool next(DxfEntity& entity);
  bool atEnd() const { return m_rest.find_first_not_of(" \t\r\n\x1a") == std::string_view::npos; }
  std::size_t bytesLeft() const { return m_rest.size(); }
  long line() const { return m_line; }

private:
  std::string_view takeLine();
  bool takeGroup(DxfGroup& group);
  std::string_view m_rest;
  long m_line = 1;
};

} // namespace esm
