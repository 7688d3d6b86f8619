// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/project/journal_line.h"

#include "core/base/hash.h"

namespace esm::json {

namespace {

constexpr std::string_view kSumKey = ", \"sum\": \"";
constexpr std::size_t kSumDigits = 16;

} // namespace

std::string fingerprintText(std::uint64_t fingerprint)
{
  std::string text(kSumDigits, '0');
  for (std::size_t i = kSumDigits; i-- > 0; fingerprint >>= 4) text[i] = "0123456789abcdef"[fingerprint & 15];
  return text;
}

std::string sealedLine(const Json& object)
{
  std::string line = writeLine(object);
  line.pop_back();
  const std::string sum = fingerprintText(fingerprintOf(line));
  line += kSumKey;
  return line + sum + "\"}";
}

std::optional<Json> openedLine(std::string_view line, const std::string& origin)
{
  constexpr std::size_t kTail = kSumKey.size() + kSumDigits + 2;
  if (line.size() < kTail) return {};
  const std::string_view body = line.substr(0, line.size() - kTail);
  const std::string_view tail = line.substr(body.size());
  if (!tail.starts_with(kSumKey) ||
      tail.substr(kSumKey.size(), kSumDigits) != fingerprintText(fingerprintOf(body)))
    return {};
  Result<Json> object = parseJson(std::string(body) + '}', origin);
  if (!object || !object->is_object()) return {};
  return std::move(object).value();
}

Json draftOf(const RuleDraft& draft)
{
  Json object;
  if (!draft.text.empty()) object["text"] = validUtf8(draft.text);
  if (draft.row >= 0) {
    object["row"] = draft.row;
    object["column"] = draft.column;
    object["cell"] = validUtf8(draft.cell);
  }
  return object;
}

RuleDraft readDraft(const View& value)
{
  RuleDraft draft;
  if (value.has("text")) draft.text = value["text"].text();
  if (value.has("row")) {
    draft.row = value["row"].integer(0, 1000000);
    draft.column = value["column"].integer(0, 100);
    draft.cell = value["cell"].text();
  }
  return draft;
}

} // namespace esm::json
