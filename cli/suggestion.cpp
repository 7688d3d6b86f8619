// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "cli/suggestion.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <string_view>
#include <vector>

namespace esm::cli {

namespace {

/// Letters to insert, delete, replace or exchange with their neighbour (optimal string alignment).
std::size_t distanceBetween(std::string_view a, std::string_view b)
{
  std::vector<std::vector<std::size_t>> rows(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        rows[i][j] = i + j;
        continue;
      }
      rows[i][j] = std::min(
        {rows[i - 1][j] + 1, rows[i][j - 1] + 1, rows[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        rows[i][j] = std::min(rows[i][j], rows[i - 2][j - 2] + 1);
    }
  return rows[a.size()][b.size()];
}

/// At most a letter and a quarter of the word may differ; whoever typed the beginning meant the rest.
std::string nearest(const std::string& typed, const std::vector<std::string>& names)
{
  std::string best;
  std::size_t bound = 2 + typed.size() / 4;
  for (const std::string& name : names) {
    const bool begun = typed.size() >= 3 && name.starts_with(typed);
    const std::size_t distance = begun ? 1 : distanceBetween(typed, name);
    if (distance >= bound) continue;
    best = name;
    bound = distance;
  }
  return best;
}

std::string nearestOption(const CLI::App& command, const std::string& typed)
{
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return nearest(typed, names);
}

std::vector<const CLI::App*> subcommandsOf(const CLI::App& command)
{
  return command.get_subcommands([](const CLI::App*) { return true; });
}

std::string nearestSubcommand(const CLI::App& command, const std::string& typed)
{
  std::vector<std::string> names;
  for (const CLI::App* sub : subcommandsOf(command)) names.push_back(sub->get_name());
  return nearest(typed, names);
}

} // namespace

std::string nearestName(const CLI::App& program, int argc, const char* const* argv)
{
  const CLI::App* command = &program;
  for (int i = 1; i < argc; ++i) {
    const std::string typed = argv[i];
    if (typed.starts_with("--") && typed.size() > 2) {
      const std::string option = typed.substr(0, typed.find('='));
      if (!command->get_option_no_throw(option)) return nearestOption(*command, option);
      continue;
    }
    const std::vector<const CLI::App*> subs = subcommandsOf(*command);
    if (typed.starts_with('-') || subs.empty()) continue; // a short option, or an argument of the command
    const auto met =
      std::find_if(subs.begin(), subs.end(), [&](const CLI::App* sub) { return sub->get_name() == typed; });
    if (met == subs.end()) return nearestSubcommand(*command, typed);
    command = *met;
  }
  return {};
}

} // namespace esm::cli
