// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/types.h"

#include <Eigen/Core>

#include <concepts>
#include <string>
#include <string_view>
#include <vector>

namespace esm {

/// Builds the one JSON object that a command prints as its last line. Numbers in their shortest exact form,
/// whatever the locale; what is not finite becomes null.
class JsonLine {
public:
  void add(std::string_view key, std::integral auto value) { member(key, std::to_string(value)); }
  void add(std::string_view key, bool value) { member(key, value ? "true" : "false"); }
  void add(std::string_view key, double value) { member(key, number(value)); }
  void add(std::string_view key, std::string_view value) { member(key, quoted(value)); }
  void add(std::string_view key, const char* value) { member(key, quoted(value)); }
  void add(std::string_view key, const Eigen::Vector3d& value);
  void add(std::string_view key, const std::vector<std::string>& values);
  void add(std::string_view key, const std::vector<Index>& values);
  void add(std::string_view key, const std::vector<JsonLine>& objects);
  void add(std::string_view key, const JsonLine& object) { member(key, object.text()); }

  std::string text() const { return "{" + m_members + "}"; }

private:
  void member(std::string_view key, const std::string& json);
  static std::string number(double value);
  static std::string quoted(std::string_view value);

  std::string m_members;
};

} // namespace esm
