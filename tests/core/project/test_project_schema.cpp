// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/file_io.h"
#include "core/project/net_format.h"
#include "core/project/project_io.h"
#include "tests/core/project/random_project.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace esm {
namespace {

/// Exit code of the checker, which knows nothing of our reader: python3-jsonschema.
int checkSchema(const std::string& files)
{
  const std::string root = ESM_SOURCE_DIR;
  const int status = std::system(("'" ESM_PYTHON "' '" + root + "/tests/core/project/check_schema.py' '" +
                                  root + "/docs/project.schema.json' " + files)
                                   .c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

// Whatever we write fits the published schema, which allows no key that it does not name.
TEST(ProjectSchema, WrittenFilesFit)
{
  const test::Scratch scratch;
  std::string files;
  for (unsigned seed = 1; seed <= 30; ++seed) {
    const auto path = scratch / ("random" + std::to_string(seed) + ".esm");
    ASSERT_TRUE(saveProject(test::randomProject(seed), path));
    files += " '" + path.string() + "'";
  }
  const auto small = scratch / "small.esm";
  ASSERT_TRUE(saveProject(test::smallProject(), small));
  EXPECT_EQ(checkSchema(files + " '" + small.string() + "'"), 0);
}

TEST(ProjectSchema, SampleProjectsFit)
{
  std::string files;
  for (const auto& entry : std::filesystem::directory_iterator(ESM_SOURCE_DIR "/resources/samples"))
    if (entry.path().extension() == ".esm") files += " '" + entry.path().string() + "'";
  if (files.empty()) return; // no samples in this tree
  EXPECT_EQ(checkSchema(files), 0);
}

// The checker itself must be able to say no.
TEST(ProjectSchema, ForeignKeysDoNotFit)
{
  const test::Scratch scratch;
  std::string json = toJson(test::smallProject());
  json.insert(json.rfind('}'), ", \"surprise\": 1");
  ASSERT_TRUE(writeFileAtomically(scratch / "bad.esm", json));
  EXPECT_EQ(checkSchema("'" + (scratch / "bad.esm").string() + "' 2>/dev/null"), 1);
}

} // namespace
} // namespace esm
