// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/worker/model_folder.h"

#include "core/base/ascii_case.h"

#include <algorithm>
#include <map>
#include <span>

namespace esm {

namespace {

namespace fs = std::filesystem;

const char* const kOutside = "it lies outside the model's folder and stays closed";
const char* const kNoFile = "it is no regular file and stays closed";
const char* const kAbsent = "there is no such file in the model's folder";
const char* const kOnline = "nothing is fetched from other machines";
constexpr std::size_t kMostNamed = 20;      ///< lost parts; more are counted
constexpr std::size_t kMostMissed = 1000;   ///< names that are remembered
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

/// Whether both may mean one file: the shorter name is the end of the longer one.
bool mayBeOne(std::string_view a, std::string_view b)
{
  if (a.size() < b.size()) std::swap(a, b);
  return a.substr(a.size() - b.size()) == b && (a.size() == b.size() || a[a.size() - b.size() - 1] == '/');
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
  m_model = fs::weakly_canonical(m_folder / model.filename(), code);
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
    miss(std::string(name), kOnline);
    return {};
  }
  std::string reason;
  const std::string_view local = name.substr(0, 7) == "file://" ? name.substr(7) : name;
  for (const fs::path& folder : {from.empty() ? m_folder : from, m_folder})
    for (const std::string& spelling : {std::string(local), plainName(local)})
      if (fs::path found = beneath(folder / spelling, reason); !found.empty()) {
        m_found.insert(withoutFolder(plainName(local)));
        return found;
      }
  miss(withoutFolder(std::string(name)), reason);
  return {};
}

/// A library may have put the folder before the name.
std::string ModelFolder::withoutFolder(const std::string& name) const
{
  const std::string folder = m_folder.string() + "/";
  return name.compare(0, folder.size(), folder) == 0 ? name.substr(folder.size()) : name;
}

void ModelFolder::miss(const std::string& name, const std::string& reason)
{
  const bool isKnown =
    std::any_of(m_missed.begin(), m_missed.end(), [&](const Lost& missed) { return missed.name == name; });
  if (!isKnown && m_missed.size() < kMostMissed) m_missed.push_back({name, reason});
}

void ModelFolder::lose(std::string_view name, const std::string& reason)
{
  forget(name);
  m_lost.push_back({std::string(name), reason});
}

void ModelFolder::forget(std::string_view name)
{
  std::erase_if(m_missed, [&](const Lost& lost) { return mayBeOne(plainName(lost.name), plainName(name)); });
  std::erase_if(m_lost, [&](const Lost& lost) { return lost.name == name; });
}

/// Of names with the same last part those that stand in the document, or else the first.
void ModelFolder::dropGuesses(std::vector<Lost>& all, std::string_view document)
{
  const auto isWritten = [&](const Lost& lost) {
    std::string windows = lost.name;
    std::replace(windows.begin(), windows.end(), '/', '\\');
    return document.find(lost.name) != document.npos || document.find(windows) != document.npos;
  };
  std::map<std::string, std::vector<Lost>> byLastPart;
  for (Lost& lost : all) byLastPart[lastPart(lost.name)].push_back(std::move(lost));
  all.clear();
  for (auto& [last, group] : byLastPart) {
    const auto guesses = std::stable_partition(group.begin(), group.end(), isWritten);
    // "part.bin" stands in "../part.bin", too
    for (auto lost = group.begin(); lost != guesses; ++lost)
      if (std::none_of(group.begin(), guesses, [&](const Lost& other) {
            return other.name.size() > lost->name.size() &&
                   mayBeOne(plainName(other.name), plainName(lost->name));
          }))
        all.push_back(*lost);
    if (guesses == group.begin()) all.push_back(group.front());
  }
}

std::vector<std::string>
ModelFolder::lostParts(std::string_view document,
                       const std::function<bool(std::string_view name)>& counts) const
{
  std::vector<Lost> missed = m_missed, all = m_lost;
  std::erase_if(missed, [&](const Lost& lost) {
    return std::any_of(m_found.begin(), m_found.end(),
                       [&](const std::string& found) { return mayBeOne(found, plainName(lost.name)); });
  });
  if (!document.empty()) dropGuesses(missed, document);
  if (counts) std::erase_if(missed, [&](const Lost& lost) { return !counts(lost.name); });
  all.insert(all.end(), missed.begin(), missed.end());
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
