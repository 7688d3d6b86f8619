// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/project/json_view.h"

#include "core/base/text_number.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace esm::json {

namespace {

const Json kNull;

std::string describe(const Json& value)
{
  if (value.is_object()) return "an object";
  if (value.is_array()) return "a list of " + std::to_string(value.size());
  if (value.is_binary()) return "a byte string";
  if (value.is_number_float()) return formatDouble(value.get<double>());
  std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
  if (text.size() > 40) text = validUtf8(text.substr(0, 40)) + "...";
  return text;
}

bool inRange(double number, Range range)
{
  if (!std::isfinite(number)) return false;
  switch (range) {
  case Range::Any:
    return true;
  case Range::NotNegative:
    return number >= 0.0;
  case Range::Positive:
    return number > 0.0;
  case Range::ZeroToOne:
    return number >= 0.0 && number <= 1.0;
  }
  return false;
}

const char* nameOf(Range range)
{
  switch (range) {
  case Range::Any:
    break;
  case Range::NotNegative:
    return ">= 0";
  case Range::Positive:
    return "> 0";
  case Range::ZeroToOne:
    return "between 0 and 1";
  }
  return "a finite number";
}

/// An integer, also one written as 3.0 (as some programs do).
std::optional<Index> asIndex(const Json& value)
{
  if (!value.is_number()) return std::nullopt;
  const double number = value.get<double>();
  if (!(std::abs(number) <= 2147483647.0) || number != std::trunc(number)) return std::nullopt;
  return static_cast<Index>(number);
}

std::string escaped(const char* key)
{
  std::string text;
  for (; *key; ++key) text += *key == '~' ? "~0" : *key == '/' ? "~1" : std::string(1, *key);
  return text;
}

} // namespace

void View::complain(const std::string& text, ErrorCode code) const
{
  if (m_faults->first) return;
  const std::string place = m_path.empty() ? "the document" : m_path;
  std::string line = m_faults->origin + ": " + place + " " + text;
  std::replace(line.begin(), line.end(), '\n', ' ');
  m_faults->first = Error{code, std::move(line)};
}

void View::mustBe(const char* what) const
{
  if (m_value->is_null())
    complain(std::string("is missing, it must be ") + what);
  else
    complain("is " + describe(*m_value) + ", it must be " + what);
}

void View::expectKeys(std::initializer_list<const char*> required,
                      std::initializer_list<const char*> optional) const
{
  if (!m_value->is_object()) return mustBe("an object");
  for (const auto& item : m_value->items()) {
    const auto same = [&](const char* key) { return item.key() == key; };
    if (std::none_of(required.begin(), required.end(), same) &&
        std::none_of(optional.begin(), optional.end(), same))
      return complain("has the unknown key " + describe(Json(item.key())));
  }
  for (const char* key : required)
    if (!m_value->contains(key)) return complain(std::string("lacks \"") + key + "\"");
}

View View::operator[](const char* key) const
{
  const std::string path = m_path + "/" + escaped(key);
  if (m_value->is_object())
    if (const auto found = m_value->find(key); found != m_value->end()) return {*found, *m_faults, path};
  return {kNull, *m_faults, path};
}

View View::operator[](std::size_t item) const
{
  const std::string path = m_path + "/" + std::to_string(item);
  if (m_value->is_array() && item < m_value->size()) return {(*m_value)[item], *m_faults, path};
  return {kNull, *m_faults, path};
}

std::vector<std::string> View::keys() const
{
  std::vector<std::string> names;
  if (!m_value->is_object()) {
    mustBe("an object");
    return names;
  }
  for (const auto& item : m_value->items()) names.push_back(item.key());
  return names;
}

std::size_t View::size() const
{
  if (m_value->is_array()) return m_value->size();
  mustBe("a list");
  return 0;
}

void View::expectSize(std::size_t items) const
{
  if (!m_value->is_array() || m_value->size() != items)
    mustBe(("a list of " + std::to_string(items)).c_str());
}

double View::number(Range range) const
{
  const double smallest = range == Range::Positive ? 1.0 : 0.0;
  if (!m_value->is_number()) {
    mustBe("a number");
    return smallest;
  }
  const double number = m_value->get<double>();
  if (inRange(number, range)) return number;
  mustBe(nameOf(range));
  return smallest;
}

Index View::integer(Index minimum, Index maximum) const
{
  const auto number = asIndex(*m_value);
  if (number && *number >= minimum && *number <= maximum) return *number;
  mustBe(("an integer from " + std::to_string(minimum) + " to " + std::to_string(maximum)).c_str());
  return minimum;
}

bool View::boolean() const
{
  if (m_value->is_boolean()) return m_value->get<bool>();
  mustBe("true or false");
  return false;
}

std::string View::text() const
{
  if (m_value->is_string()) {
    std::string text = m_value->get<std::string>();
    if (validUtf8(text) == text) return text; // CBOR may bring any bytes
    complain("is not valid UTF-8 text");
    return {};
  }
  mustBe("a text");
  return {};
}

std::size_t View::choice(std::span<const char* const> words) const
{
  if (m_value->is_string())
    for (std::size_t i = 0; i < words.size(); ++i)
      if (m_value->get_ref<const std::string&>() == words[i]) return i;
  std::string list;
  for (const char* word : words) list += (list.empty() ? "" : ", ") + std::string(word);
  mustBe(("one of " + list).c_str());
  return 0;
}

Eigen::ArrayXd View::numbers(Index count, Range range) const
{
  if (!m_value->is_array()) return Eigen::ArrayXd::Constant(count, number(range));
  Eigen::ArrayXd values = Eigen::ArrayXd::Zero(count);
  if (m_value->size() != static_cast<std::size_t>(count)) {
    mustBe(("a number or a list of " + std::to_string(count)).c_str());
    return values;
  }
  for (std::size_t i = 0; i < m_value->size(); ++i) {
    const Json& item = (*m_value)[i];
    const double value = item.is_number() ? item.get<double>() : 0.0;
    if (!item.is_number() || !inRange(value, range)) {
      (*this)[i].number(range);
      return values;
    }
    values[static_cast<Index>(i)] = value;
  }
  return values;
}

std::vector<std::size_t> View::choices(Index count, std::span<const char* const> words) const
{
  const auto size = static_cast<std::size_t>(count);
  if (!m_value->is_array()) return std::vector<std::size_t>(size, choice(words));
  std::vector<std::size_t> places(size, 0);
  if (m_value->size() != size) {
    mustBe(("a word or a list of " + std::to_string(count)).c_str());
    return places;
  }
  for (std::size_t i = 0; i < size && sound(); ++i) places[i] = (*this)[i].choice(words);
  return places;
}

std::vector<double> View::numberList(Range range) const
{
  const Eigen::ArrayXd values = numbers(static_cast<Index>(size()), range);
  if (!isList()) return {};
  return {values.data(), values.data() + values.size()};
}

std::vector<Index> View::indexList(Index limit) const
{
  std::vector<Index> list;
  list.reserve(size());
  for (std::size_t i = 0; i < list.capacity() && i < size(); ++i) {
    const auto place = asIndex((*m_value)[i]);
    if (!place || *place < 0 || *place >= limit) {
      (*this)[i].mustBe(limit > 0 ? ("an integer from 0 to " + std::to_string(limit - 1)).c_str()
                                  : "absent, there is nothing to refer to");
      return {};
    }
    list.push_back(*place);
  }
  return list;
}

Eigen::Matrix3Xd View::points() const
{
  const std::vector<double> flat = numberList();
  if (flat.size() % 3 != 0) {
    mustBe("a list of x, y, z triples, flat, so its length a multiple of 3");
    return {};
  }
  return Eigen::Map<const Eigen::Matrix3Xd>(flat.data(), 3, static_cast<Eigen::Index>(flat.size() / 3));
}

Eigen::Vector3d View::vector() const
{
  if (!isList() || size() != 3) {
    mustBe("a list of three numbers");
    return Eigen::Vector3d::Zero();
  }
  return numbers(3).matrix();
}

} // namespace esm::json
