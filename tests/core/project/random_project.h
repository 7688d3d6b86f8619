// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/project/project.h"

#include <filesystem>
#include <string>

namespace esm::test {

/// A project with everything in it that the file can hold, and numbers from the whole range of double (the
/// smallest denormal, -0, the largest). Equal seeds give equal projects. It passes checkProject().
Project randomProject(unsigned seed);

/// Five nodes, four triangles and two struts with default tissue: small enough to read in a failure.
Project smallProject();

/// A folder of its own for a test, emptied at the start and removed at the end.
class Scratch {
public:
  Scratch();
  ~Scratch();
  std::filesystem::path operator/(const std::string& name) const { return m_path / name; }
  std::size_t fileCount() const; ///< of all depths

private:
  std::filesystem::path m_path;
};

} // namespace esm::test
