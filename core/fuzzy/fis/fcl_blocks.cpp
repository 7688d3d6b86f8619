// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/fis/fcl_blocks.h"

#include "core/fuzzy/fis/fcl_scanner.h"

#include <algorithm>
#include <array>

namespace esm::fis {

namespace {

/// What may begin the body of a function block, which then has no name.
constexpr std::array<std::string_view, 9> kParts = {"VAR_INPUT", "VAR_OUTPUT", "VAR",
                                                    "FUZZIFY",   "DEFUZZIFY",  "RULEBLOCK",
                                                    "OPTION",    "OPTIONS",    "END_FUNCTION_BLOCK"};

std::string titleOf(const FunctionBlock& block, std::size_t index)
{
  return block.name.empty() ? std::to_string(index + 1) : block.name;
}

} // namespace

std::vector<FunctionBlock> functionBlocksOf(std::string_view text)
{
  FclScanner scan(text);
  std::vector<FunctionBlock> blocks;
  if (!scan.is("FUNCTION_BLOCK")) return {{std::string(), text}};
  while (!scan.atEnd()) {
    scan.expect("FUNCTION_BLOCK");
    const std::size_t from = scan.place();
    const bool named = std::none_of(kParts.begin(), kParts.end(), [&](auto part) { return scan.is(part); });
    std::string name = named && !scan.atEnd() ? std::string(scan.word()) : std::string();
    while (!scan.atEnd() && !scan.is("END_FUNCTION_BLOCK") && !scan.is("FUNCTION_BLOCK")) scan.take();
    blocks.push_back({std::move(name), text.substr(from, scan.place() - from)});
    scan.accept("END_FUNCTION_BLOCK");
  }
  return blocks;
}

const FunctionBlock& chooseBlock(const std::vector<FunctionBlock>& blocks, std::string_view wanted,
                                 Notes& notes)
{
  std::string names;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const bool isWanted = equalIgnoringCase(blocks[i].name, wanted) || std::to_string(i + 1) == wanted;
    if (!wanted.empty() && isWanted) return blocks[i];
    if (i > 0 || !wanted.empty()) names += (names.empty() ? "'" : ", '") + titleOf(blocks[i], i) + '\'';
  }
  const char* at = blocks.front().text.data();
  if (!wanted.empty())
    throw Fault{at, "there is no function block " + shown(wanted) + "; there are " + names};
  if (blocks.size() > 1)
    notes.add(blocks[1].text.data(), "the file holds " + std::to_string(blocks.size()) +
                                       " function blocks; '" + titleOf(blocks[0], 0) + "' is read, not " +
                                       names + " (--block NAME chooses)");
  return blocks.front();
}

} // namespace esm::fis
