// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/project/json_tree.h"

#include "core/base/text_encoding.h"
#include "core/base/text_number.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <set>
#include <vector>

namespace esm::json {

namespace {

/// Builds the tree from parser events and stops the parser where a document leaves the limits.
class BoundedTree : public nlohmann::json_sax<Json> {
public:
  explicit BoundedTree(Json& tree) : m_builder(tree, false) {}

  bool null() override { return m_builder.null(); }
  bool boolean(bool value) override { return m_builder.boolean(value); }
  bool number_integer(number_integer_t value) override { return m_builder.number_integer(value); }
  bool number_unsigned(number_unsigned_t value) override { return m_builder.number_unsigned(value); }
  bool number_float(number_float_t value, const string_t& text) override
  {
    return m_builder.number_float(value, text);
  }
  bool string(string_t& value) override { return m_builder.string(value); }
  bool binary(binary_t& value) override { return m_builder.binary(value); }
  bool start_object(std::size_t size) override { return enter() && m_builder.start_object(size); }
  bool key(string_t& name) override
  {
    std::set<std::string>& names = m_keys.back();
    if (names.size() == kMaxKeys) return refuse("an object has more than 1000 keys");
    if (!names.insert(name).second) return refuse("the key \"" + name + "\" occurs twice in one object");
    return m_builder.key(name);
  }
  bool end_object() override { return leave() && m_builder.end_object(); }
  bool start_array(std::size_t size) override { return enter() && m_builder.start_array(size); }
  bool end_array() override { return leave() && m_builder.end_array(); }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception& fault) override
  {
    return refuse(fault.what());
  }

  const std::string& fault() const noexcept { return m_fault; }

private:
  bool enter()
  {
    m_keys.emplace_back();
    return m_keys.size() <= kMaxDepth || refuse("nested deeper than 32 levels");
  }
  bool leave()
  {
    m_keys.pop_back();
    return true;
  }
  bool refuse(const std::string& why)
  {
    if (m_fault.empty()) m_fault = why;
    return false;
  }

  nlohmann::detail::json_sax_dom_parser<Json> m_builder;
  std::vector<std::set<std::string>> m_keys; ///< of every open object; of a list: none
  std::string m_fault;
};

/// The parser's own words without its error number, on one line of bearable length.
std::string oneLine(const std::string& message)
{
  const std::size_t bracket = message.starts_with('[') ? message.find("] ") : std::string::npos;
  std::string text = validUtf8(bracket == std::string::npos ? message : message.substr(bracket + 2));
  std::replace_if(
    text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
  if (text.size() > 200) text = validUtf8(text.substr(0, 160)) + " ...";
  return text;
}

Result<Json> parse(std::string_view bytes, const std::string& origin, Json::input_format_t format)
{
  const auto bad = [&](const std::string& why) {
    return Error{ErrorCode::BadFormat, origin + ": " + oneLine(why)};
  };
  try {
    Json tree;
    BoundedTree handler(tree);
    if (!Json::sax_parse(bytes.begin(), bytes.end(), &handler, format))
      return bad(handler.fault().empty() ? "cannot be read" : handler.fault());
    return tree;
  } catch (...) { // lengths beyond memory, a number beyond double
    return thrownWhileReading(origin);
  }
}

// === Writing

constexpr std::size_t kLineLength = 170;  // so that a term and most rules are one line each
constexpr std::size_t kItemsPerLine = 12; // four points, four triangles, six springs

void appendScalar(std::string& out, const Json& value)
{
  if (value.is_number_float()) {
    const double number = value.get<double>();
    if (!std::isfinite(number))
      out += "null";
    else if (number == 0.0 && std::signbit(number))
      out += "-0.0"; // "-0" would be read as an integer, which has no such thing
    else
      appendDouble(out, number);
  } else {
    out += value.dump(-1, ' ', false, Json::error_handler_t::replace);
  }
}

/// The value on one line, as long as the line stays within `limit`.
bool appendCompact(std::string& out, const Json& value, std::size_t limit)
{
  if (!value.is_structured()) {
    appendScalar(out, value);
    return out.size() <= limit;
  }
  if (value.size() > limit) return false;
  out += value.is_object() ? '{' : '[';
  bool first = true;
  for (const auto& item : value.items()) {
    if (!first) out += ", ";
    first = false;
    if (value.is_object()) {
      appendScalar(out, item.key());
      out += ": ";
    }
    if (!appendCompact(out, item.value(), limit)) return false;
  }
  out += value.is_object() ? '}' : ']';
  return out.size() <= limit;
}

void appendValue(std::string& out, const Json& value, std::size_t indent, bool top);

/// A list of numbers or words: a fixed number of items per line.
void appendLongList(std::string& out, const Json& list, std::size_t indent)
{
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (i % kItemsPerLine == 0)
      out.append(1, '\n').append(indent, ' ');
    else
      out += ' ';
    appendScalar(out, list[i]);
    if (i + 1 < list.size()) out += ',';
  }
}

void appendItems(std::string& out, const Json& value, std::size_t indent)
{
  bool first = true;
  for (const auto& item : value.items()) {
    if (!first) out += ',';
    first = false;
    out.append(1, '\n').append(indent, ' ');
    if (value.is_object()) {
      appendScalar(out, item.key());
      out += ": ";
    }
    appendValue(out, item.value(), indent, false);
  }
}

void appendValue(std::string& out, const Json& value, std::size_t indent, bool top)
{
  const bool scalars = value.is_array() && std::none_of(value.begin(), value.end(), [](const Json& item) {
                         return item.is_structured();
                       });
  if (!value.is_structured() || value.empty() || (scalars && value.size() <= kItemsPerLine)) {
    appendCompact(out, value, std::string::npos);
    return;
  }
  std::string line;
  if (!top && !scalars && appendCompact(line, value, kLineLength - std::min(indent, kLineLength))) {
    out += line;
    return;
  }
  out += value.is_object() ? '{' : '[';
  if (scalars)
    appendLongList(out, value, indent + 2);
  else
    appendItems(out, value, indent + 2);
  out.append(1, '\n').append(indent, ' ');
  out += value.is_object() ? '}' : ']';
}

} // namespace

Result<Json> parseJson(std::string_view bytes, const std::string& origin)
{
  return parse(withoutByteOrderMark(bytes), origin, Json::input_format_t::json);
}

Result<Json> parseCbor(std::string_view bytes, const std::string& origin)
{
  return parse(bytes, origin, Json::input_format_t::cbor);
}

std::string write(const Json& tree)
{
  std::string text;
  appendValue(text, tree, 0, true);
  text += '\n';
  return text;
}

std::string writeLine(const Json& tree)
{
  std::string text;
  appendCompact(text, tree, std::string::npos);
  return text;
}

std::string writeCbor(const Json& tree)
{
  std::string bytes;
  Json::to_cbor(tree, bytes);
  return bytes;
}

std::optional<std::string> findNonFinite(const Json& tree)
{
  if (tree.is_number_float() && !std::isfinite(tree.get<double>())) return std::string();
  if (!tree.is_structured()) return std::nullopt;
  std::size_t place = 0;
  for (const auto& item : tree.items()) {
    if (item.value().is_structured() || item.value().is_number_float())
      if (const auto rest = findNonFinite(item.value()))
        return "/" + (tree.is_object() ? item.key() : std::to_string(place)) + *rest;
    ++place;
  }
  return std::nullopt;
}

Error thrownWhileReading(const std::string& origin)
{
  try {
    throw;
  } catch (const std::bad_alloc&) {
    return {ErrorCode::OutOfMemory, origin + ": there is not enough memory to read it"};
  } catch (const std::exception& fault) {
    return {ErrorCode::BadFormat, origin + ": cannot be read (" + oneLine(fault.what()) + ")"};
  }
}

std::string validUtf8(const std::string& text)
{
  const std::string quoted = Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
  return Json::parse(quoted, nullptr, false).get<std::string>();
}

} // namespace esm::json
