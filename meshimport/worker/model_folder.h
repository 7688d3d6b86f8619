// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace esm {

/// Where the parts of a scene may lie: in the folder of the model or below, as regular files. A scene may
/// name
/// "../../etc/passwd" or a device; symbolic links are followed before the check. The working directory does
/// not count. What was asked for in vain is remembered.
class ModelFolder {
public:
  explicit ModelFolder(const std::filesystem::path& model);

  const std::filesystem::path& path() const noexcept { return m_folder; }

  /// The file to open for a name in the model, or empty. Names that a browser or Windows would write
  /// ("a%20b", "parts\b") are understood too.
  /// @param from the folder of the part that has the name, if it is another one; looked into first
  std::filesystem::path find(std::string_view name, const std::filesystem::path& from = {});

  /// A part that is not read, and why; the first reason stays.
  void lose(std::string_view name, const std::string& reason);

  /// A sentence for each lost part that `counts` holds for. What was missed in one place and found in another
  /// is not lost.
  std::vector<std::string> lostParts(bool (*counts)(std::string_view name) = nullptr) const;

private:
  struct Lost {
    std::string name, reason;
  };
  std::filesystem::path beneath(const std::filesystem::path& file, std::string& reason) const;

  std::filesystem::path m_folder;
  std::vector<Lost> m_lost;
  std::map<std::string, Lost, std::less<>>
    m_missed;                                 ///< by the last part of the name, as the rest is guessed at
  std::set<std::string, std::less<>> m_found; ///< last parts of the names that were found
};

/// "; its part 'a.iv' is missing here: ..." for each, to end a message with.
std::string withSemicolons(const std::vector<std::string>& sentences);

} // namespace esm
