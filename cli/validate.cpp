// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "cli/arguments.h"
#include "cli/commands.h"
#include "core/base/json_line.h"
#include "core/project/project_io.h"

namespace esm::cli {

namespace {

struct ValidateOptions {
  std::string file;
  bool json = false;
};

Exit validate(const ValidateOptions& options)
{
  const Result<Project> project = loadProject(options.file);
  if (!project) return fail(project.error());
  if (options.json) {
    JsonLine line;
    line.add("file", options.file);
    line.add("valid", true);
    print(line.text());
  } else {
    print(options.file + ": valid");
  }
  return Exit::Done;
}

} // namespace

void addValidate(CLI::App& program, Work& work)
{
  auto options = std::make_shared<ValidateOptions>();
  CLI::App* command =
    program.add_subcommand("validate", "Check a project; the first fault is named with its place");
  command->add_option("PROJECT", options->file, ".esm, .esmb or net.json")->required();
  addJsonFlag(*command, options->json);
  command->callback([options, &work] { work = [options] { return validate(*options); }; });
}

} // namespace esm::cli
