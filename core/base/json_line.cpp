// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/json_line.h"

#include "core/base/text_encoding.h"
#include "core/base/text_number.h"

#include <algorithm>
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
  while (!value.empty()) {
    const std::size_t length = utf8Length(value);
    const std::string_view character = value.substr(0, length);
    const auto last = static_cast<unsigned char>(value[length > 0 ? length - 1 : 0]);
    if (length == 0) // names of files are bytes
      out += "\uFFFD";
    else if (isControlCharacter(character)) // the last byte holds its number
      out.append("\\u00").append(1, kHex[last >> 4]).append(1, kHex[last & 15]);
    else
      out.append(character == "\"" || character == "\\" ? "\\" : "").append(character);
    value.remove_prefix(std::max<std::size_t>(length, 1));
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
