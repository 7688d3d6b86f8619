// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace esm {

/// Where the parts of a scene may lie: in the folder of the model or below, as regular files. A scene may
/// name "../../etc/passwd" or a device; symbolic links are followed before the check. The working directory
/// does not count. What was asked for in vain is remembered.
class ModelFolder {
public:
  explicit ModelFolder(const std::filesystem::path& model);

  const std::filesystem::path& path() const noexcept { return m_folder; }
  const std::filesystem::path& model() const noexcept { return m_model; } ///< the file itself

  /// The file to open for a name in the model, or empty. Names that a browser or Windows would write
  /// ("a%20b", "parts\b") are understood too.
  /// @param from the folder of the part that has the name, if it is another one; looked into first
  std::filesystem::path find(std::string_view name, const std::filesystem::path& from = {});

  /// A part that is not read, and why; the first reason stays.
  void lose(std::string_view name, const std::string& reason);

  /// What was lost under this name is read from another place.
  void forget(std::string_view name);

  /// A sentence for each part that was lost, or asked for in vain if `counts` holds for its name.
  /// @param document of a library that asks for one part under several names ("a/b.bin", "b.bin"): what was
  /// found under one of them is not lost, and what was not is named as it stands there
  std::vector<std::string> lostParts(std::string_view document = {},
                                     const std::function<bool(std::string_view name)>& counts = {}) const;

private:
  struct Lost {
    std::string name, reason;
  };
  std::filesystem::path beneath(const std::filesystem::path& file, std::string& reason) const;

  static void dropGuesses(std::vector<Lost>& all, std::string_view document);
  std::string withoutFolder(const std::string& name) const;
  void miss(const std::string& name, const std::string& reason);

  std::filesystem::path m_folder, m_model;
  std::vector<Lost> m_lost;
  std::vector<Lost> m_missed;                 ///< maybe a guess of the library only
  std::set<std::string, std::less<>> m_found; ///< names in plain spelling
};

/// "; its part 'a.iv' is missing here: ..." for each, to end a message with.
std::string withSemicolons(const std::vector<std::string>& sentences);

} // namespace esm
