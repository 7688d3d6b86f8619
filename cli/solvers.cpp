// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "cli/arguments.h"
#include "cli/commands.h"
#include "core/base/json_line.h"
#include "core/dynamics/simulation.h"

namespace esm::cli {

namespace {

Exit listSolvers(bool json)
{
  JsonLine line;
  for (const SolverInfo& solver : solverNames()) {
    line.add(solver.name, solver.description);
    if (!json)
      print(solver.name + std::string(solver.name.size() < 12 ? 12 - solver.name.size() : 1, ' ') +
            solver.description);
  }
  if (json) print(line.text());
  return Exit::Done;
}

} // namespace

void addSolvers(CLI::App& program, Work& work)
{
  auto json = std::make_shared<bool>(false);
  CLI::App* command = program.add_subcommand("solvers", "List the solvers that simulate takes");
  addJsonFlag(*command, *json);
  command->callback([json, &work] { work = [json] { return listSolvers(*json); }; });
}

} // namespace esm::cli
