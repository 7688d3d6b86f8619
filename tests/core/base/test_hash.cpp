// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/hash.h"

#include <gtest/gtest.h>

#include <string>

namespace esm {

// It is kept in project files, so the same bytes must have the same one for ever.
TEST(Fingerprint, IsTheOneOfOlderVersions)
{
  EXPECT_EQ(fingerprintOf(""), 12153745711578692512ull);
  EXPECT_EQ(fingerprintOf("solid scan\nfacet normal 0 0 1\n  outer loop"), 4294368493869308544ull);
}

TEST(Fingerprint, OfPiecesIsThatOfTheWhole)
{
  std::string text;
  for (int i = 0; i < 300; ++i) text += static_cast<char>(i * i);
  for (std::size_t size = 0; size < text.size(); size += 7) {
    const std::string_view whole = std::string_view(text).substr(0, size);
    Fingerprint fingerprint;
    for (std::size_t come = 0; come < size; come += 1 + come / 3) fingerprint.follow(whole.substr(0, come));
    EXPECT_EQ(fingerprint.finish(whole), fingerprintOf(whole)) << size;
  }
}

} // namespace esm
