// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/json_line.h"

#include "core/base/text_number.h"

#include <cmath>

namespace esm {

void JsonLine::member(std::string_view key, const std::string& json)
{
  if (!m_members.empty()) m_members += ", ";
  m_members += quoted(key) + ": " + json;
}

std::string JsonLine::number(double value)
{
  return std::isfinite(value) ? formatDouble(value) : "null";
}

std::string JsonLine::quoted(std::string_view value)
{
  constexpr char kHex[] = "0123456789abcdef";
  std::string out = "\"";
  for (const char c : value) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\')
      out.append(1, '\\').append(1, c);
    else if (byte < 0x20)
      out.append("\\u00").append(1, kHex[byte >> 4]).append(1, kHex[byte & 15]);
    else
      out += c;
  }
  return out + "\"";
}

void JsonLine::add(std::string_view key, const Eigen::Vector3d& value)
{
  member(key, "[" + number(value[0]) + ", " + number(value[1]) + ", " + number(value[2]) + "]");
}

void JsonLine::add(std::string_view key, const std::vector<std::string>& values)
{
  std::string list;
  for (const std::string& value : values) list += (list.empty() ? "" : ", ") + quoted(value);
  member(key, "[" + list + "]");
}

void JsonLine::add(std::string_view key, const std::vector<Index>& values)
{
  std::string list;
  for (const Index value : values) list += (list.empty() ? "" : ",") + std::to_string(value);
  member(key, "[" + list + "]");
}

void JsonLine::add(std::string_view key, const std::vector<JsonLine>& objects)
{
  std::string list;
  for (const JsonLine& object : objects) list += (list.empty() ? "" : ", ") + object.text();
  member(key, "[" + list + "]");
}

} // namespace esm
