// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/worker/model_folder.h"

#include "core/base/ascii_case.h"

#include <algorithm>
#include <span>

namespace esm {

namespace {

namespace fs = std::filesystem;

const char* const kOutside = "it lies outside the model's folder and stays closed";
const char* const kNoFile = "it is no regular file and stays closed";
const char* const kAbsent = "there is no such file in the model's folder";
const char* const kOnline = "nothing is fetched from other machines";
constexpr std::size_t kMostNamed = 20;      ///< lost parts; more are counted
constexpr std::size_t kMostNameShown = 160; ///< bytes of a name in a sentence

int hexDigit(char c)
{
  const std::size_t place = std::string_view("0123456789abcdef0123456789ABCDEF").find(c);
  return place == std::string_view::npos ? -1 : static_cast<int>(place % 16);
}

/// "a%20b\c" as "a b/c".
std::string plainName(std::string_view name)
{
  std::string plain;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const bool isCode =
      name[i] == '%' && i + 2 < name.size() && hexDigit(name[i + 1]) >= 0 && hexDigit(name[i + 2]) >= 0;
    if (isCode) {
      plain += static_cast<char>(16 * hexDigit(name[i + 1]) + hexDigit(name[i + 2]));
      i += 2;
    } else {
      plain += name[i] == '\\' ? '/' : name[i];
    }
  }
  return plain;
}

std::string lastPart(std::string_view name)
{
  return std::string(name.substr(name.find_last_of("/\\") + 1));
}

/// A name on one line and not too long.
std::string shown(std::string_view name)
{
  std::string text(name.substr(0, kMostNameShown));
  std::replace_if(
    text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 32 || c == 127; }, '?');
  return name.size() > kMostNameShown ? text + "..." : text;
}

bool isOnline(std::string_view name)
{
  return name.find("://") != name.npos && name.substr(0, 5) != "file:";
}

} // namespace

ModelFolder::ModelFolder(const fs::path& model)
{
  std::error_code code;
  m_folder = fs::weakly_canonical(fs::absolute(model, code).parent_path(), code);
}

fs::path ModelFolder::beneath(const fs::path& file, std::string& reason) const
{
  std::error_code code;
  const fs::path whole = fs::weakly_canonical(file, code);
  const auto [folder, rest] = std::mismatch(m_folder.begin(), m_folder.end(), whole.begin(), whole.end());
  const fs::file_status status = fs::status(whole, code);
  if (folder == m_folder.end() && fs::is_regular_file(status)) return whole;
  // That it is closed says more than that it is absent under another spelling.
  if (folder != m_folder.end())
    reason = kOutside;
  else if (fs::exists(status))
    reason = kNoFile;
  else if (reason.empty())
    reason = kAbsent;
  return {};
}

fs::path ModelFolder::find(std::string_view name, const fs::path& from)
{
  if (name.empty()) return {};
  if (isOnline(name)) {
    lose(name, kOnline);
    return {};
  }
  std::string reason;
  const std::string_view local = name.substr(0, 7) == "file://" ? name.substr(7) : name;
  for (const fs::path& folder : {from.empty() ? m_folder : from, m_folder})
    for (const std::string& spelling : {std::string(local), plainName(local)})
      if (fs::path found = beneath(folder / spelling, reason); !found.empty()) {
        m_found.insert(lastPart(name));
        return found;
      }
  const std::string folder = m_folder.string() + "/"; // a library may have put it before the name
  if (name.substr(0, folder.size()) == folder) name.remove_prefix(folder.size());
  m_missed.emplace(lastPart(name), Lost{std::string(name), reason});
  return {};
}

void ModelFolder::lose(std::string_view name, const std::string& reason)
{
  m_missed.erase(lastPart(name));
  for (const Lost& lost : m_lost)
    if (lost.name == name) return;
  m_lost.push_back({std::string(name), reason});
}

std::vector<std::string> ModelFolder::lostParts(bool (*counts)(std::string_view name)) const
{
  std::vector<Lost> all = m_lost;
  for (const auto& [last, lost] : m_missed)
    if (m_found.count(last) == 0) all.push_back(lost);
  if (counts) std::erase_if(all, [counts](const Lost& lost) { return !counts(lost.name); });
  std::vector<std::string> sentences;
  for (const Lost& lost : std::span(all).first(std::min(all.size(), kMostNamed)))
    sentences.push_back("Its part '" + shown(lost.name) + "' is missing here: " + lost.reason + ".");
  if (all.size() > kMostNamed)
    sentences.push_back(std::to_string(all.size() - kMostNamed) + " more of its parts are missing.");
  return sentences;
}

std::string withSemicolons(const std::vector<std::string>& sentences)
{
  std::string text;
  for (const std::string& sentence : sentences) {
    text += "; " + sentence.substr(0, sentence.size() - 1);
    text[text.size() - sentence.size() + 1] = asciiLower(sentence.front());
  }
  return text;
}

} // namespace esm
