// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"

#include <filesystem>
#include <functional>
#include <string>

namespace esm::test {

/// A written session with a document: equal steps whoever runs it. Steps of every kind: drags, regions,
/// rules, held nodes, gravity, models that replace or join, undo, redo, rules with a mistake, and saving.
class Session {
public:
  static constexpr int kSteps = 78;
  /// @param save how this program saves; must succeed.
  Session(Document* document, std::filesystem::path file, std::function<void()> save)
    : m_document(document), m_file(std::move(file)), m_save(std::move(save))
  {}
  void open();         ///< makes the file and opens it
  void step(int step); ///< from 1 on

private:
  void import(int step, bool replace);

  Document* m_document; ///< not owned
  std::filesystem::path m_file;
  std::function<void()> m_save;
};

/// Equal for equal documents: the bytes of the project but for the place of the camera, and the rule that is
/// being written.
std::string fingerprint(Project project, const RuleDraft& draft);

/// What a start after the end of a process finds: the work that can be recovered, else the file.
/// Empty if the file itself cannot be read.
std::string foundFingerprint(const std::filesystem::path& recovery, const std::filesystem::path& file);

} // namespace esm::test
