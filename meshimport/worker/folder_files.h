// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "meshimport/worker/model_folder.h"

#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace esm {

/// The files that assimp may see: the model itself, from memory, and for reading what ModelFolder finds.
class FolderFiles : public Assimp::IOSystem {
public:
  /// @param model its path; `name()` is what assimp must be asked for
  /// @param bytes of the model; not owned, outlives this
  /// @param ending to give the model in place of its own, empty to keep it
  /// @param announce is told the size of each companion before it is read
  FolderFiles(const std::filesystem::path& model, std::string_view bytes, std::string_view ending,
              void (*announce)(std::uint64_t bytes));

  std::string name() const { return m_model.string(); }
  const ModelFolder& folder() const noexcept { return m_folder; }

  bool Exists(const char* file) const override;
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* file, const char* mode) override;
  void Close(Assimp::IOStream* stream) override { delete stream; }

private:
  bool isModel(const std::filesystem::path& file) const;

  mutable ModelFolder m_folder; ///< remembers what was asked for
  std::filesystem::path m_model;
  std::string m_plain; ///< the model as the library bears it; empty where that is its bytes
  std::string_view m_bytes;
  void (*m_announce)(std::uint64_t bytes);
};

} // namespace esm
