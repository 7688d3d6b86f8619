// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/project/net_format.h"
#include "core/project/project_io.h"
#include "tests/core/project/random_project.h"

#include <gmock/gmock.h>

#include <random>

namespace esm {
namespace {

using testing::HasSubstr;

/// Cuts, flips, doubles, removes or overwrites bytes somewhere.
std::string mutated(std::string bytes, std::mt19937& dice)
{
  const auto place = [&] { return dice() % bytes.size(); };
  switch (dice() % 6) {
  case 0:
    bytes.resize(place());
    break;
  case 1:
    bytes[place()] = static_cast<char>(dice());
    break;
  case 2:
    bytes.erase(place(), 1 + dice() % 40);
    break;
  case 3:
    bytes.insert(place(), bytes.substr(place(), 1 + dice() % 40));
    break;
  case 4: {
    constexpr const char* kNasty[] = {"1e999", "-1",  "null",       "[[[[",     "{}",
                                      "\"",    "NaN", "4294967296", "\xFF\xFE", "]"};
    bytes.insert(place(), kNasty[dice() % std::size(kNasty)]);
    break;
  }
  default:
    for (int i = 0; i < 8; ++i) bytes[place()] = static_cast<char>(dice());
  }
  return bytes;
}

/// Reads as a whole project that can be saved and read again, or gives one line that names the file.
void expectProjectOrOneLine(const std::string& bytes, int& refused)
{
  const Result<Project> project = parseProject(bytes, "hostile.esm");
  if (project) {
    EXPECT_TRUE(checkProject(*project));
    EXPECT_TRUE(parseProject(toJson(*project), "again.esm"));
    return;
  }
  ++refused;
  const std::string& line = project.error().detail;
  EXPECT_THAT(line, HasSubstr("hostile.esm"));
  EXPECT_EQ(line.find('\n'), std::string::npos) << line;
  EXPECT_LT(line.size(), 500u) << line;
}

TEST(HostileProjectFiles, MutatedFilesGiveOneErrorLineEach)
{
  std::mt19937 dice(42);
  int refused = 0;
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const Project project = test::randomProject(seed);
    for (const std::string& whole : {toJson(project), toCbor(project), toNetFormat(project)})
      for (int i = 0; i < 25; ++i) expectProjectOrOneLine(mutated(whole, dice), refused);
  }
  EXPECT_GT(refused, 400) << "of 750; the rest are changes that keep the file whole";
}

TEST(HostileProjectFiles, EveryTruncationIsRefused)
{
  const Project project = test::smallProject();
  for (const std::string& whole : {toJson(project), toCbor(project)}) {
    const std::size_t end = whole.find_last_not_of('\n'); // the last byte that counts
    for (std::size_t size = 0; size <= end; size += 61) {
      int refused = 0;
      expectProjectOrOneLine(whole.substr(0, size), refused);
      EXPECT_EQ(refused, 1) << size;
    }
  }
}

std::string repeated(const std::string& piece, std::size_t count)
{
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += piece;
  return text;
}

// A parser that recurses would run out of stack: 1 million levels.
TEST(HostileProjectFiles, DeepNestingIsRefused)
{
  const std::size_t deep = 1000000;
  for (const std::string& bytes : {"{\"format\": " + repeated("[", deep), repeated("{\"a\":", deep),
                                   "\xA1" + ("aa" + repeated("\x81", deep)), repeated("\xA1\x61\x61", deep),
                                   "\xA1\x61\x61" + repeated("\x9F", deep)}) {
    const Result<Project> project = parseProject(bytes, "deep.esm");
    ASSERT_FALSE(project);
    EXPECT_EQ(project.error().detail, "deep.esm: nested deeper than 32 levels");
  }
}

// A header may promise more than there is memory; it must not be believed before the bytes are there.
TEST(HostileProjectFiles, HugeCountsAreRefused)
{
  const std::string huge = "\xFF\xFF\xFF\xFF\xFF\xFF\xFF\x00",
                    large = std::string("\x00\x00\x00\x7F", 4) + "\xFF\xFF\xFF\xFF";
  for (const std::string& size : {huge, large})
    for (const std::string& start : {"\xBB" + size, "\xA1\x61\x61\x9B" + size, "\xA1\x61\x61\x7B" + size,
                                     "\xA1\x7B" + size, "\xA1\x61\x61\x5B" + size}) {
      const Result<Project> project = parseProject(start, "huge.esmb");
      ASSERT_FALSE(project);
      EXPECT_THAT(project.error().detail, HasSubstr("huge.esmb: "));
    }
}

TEST(HostileProjectFiles, OtherContentIsNamed)
{
  const auto message = [](const std::string& bytes) { return parseProject(bytes, "x").error().detail; };
  EXPECT_EQ(message(""), "x: is empty, it holds no project");
  EXPECT_EQ(message(" \n\t"), "x: is empty, it holds no project");
  EXPECT_THAT(message("solid organ"), HasSubstr("neither a project"));
  EXPECT_THAT(message("{}"), HasSubstr("/format is missing, it must be one of esm-project"));
  EXPECT_THAT(message("{\"format\": \"esm-net-2\"}"), HasSubstr("/format is \"esm-net-2\""));
  EXPECT_THAT(message("{\"format\": 1e999}"), HasSubstr("number overflow"));
  std::string keys = "{\"a\":0";
  for (int i = 0; i < 2000; ++i) keys += ",\"k" + std::to_string(i) + "\":0";
  EXPECT_THAT(message(keys + "}"), HasSubstr("more than 1000 keys"));
}

} // namespace
} // namespace esm
