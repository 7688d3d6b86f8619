// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "cli/apply_edits.h"
#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/output_files.h"
#include "cli/rules_file.h"
#include "core/base/json_line.h"
#include "core/project/project_io.h"

#include <algorithm>

namespace esm::cli {

namespace {

struct ApplyOptions {
  std::string file, output, rules;
  std::vector<Edit> edits;
  bool json = false;
};

bool touchesTissue(const ApplyOptions& options)
{
  using Kind = Edit::Kind;
  return !options.rules.empty() ||
         std::any_of(options.edits.begin(), options.edits.end(), [](const Edit& edit) {
           return edit.kind == Kind::Set || edit.kind == Kind::Region || edit.kind == Kind::Rule;
         });
}

Exit apply(const ApplyOptions& options)
{
  Result<Project> project = loadProject(options.file);
  if (!project) return fail(project.error());
  if (!options.rules.empty())
    if (const Status status = takeRules(options.rules, project->tissue); !status) return fail(status.error());
  if (const Status status = applyEdits(options.edits, *project); !status) return fail(status.error());

  project->source =
    withRelativeNames(withAbsoluteNames(project->source, folderOf(options.file)), folderOf(options.output));
  // A net that brought its own numbers keeps them until somebody speaks of tissue.
  project->parametersFromTissue |= touchesTissue(options) || options.edits.empty();
  ApplyReport report;
  if (project->parametersFromTissue) {
    const Result<ApplyReport> applied = applyTissue(project->tissue, project->net);
    if (!applied) return fail({applied.error().code, options.file + ": " + applied.error().detail});
    report = *applied;
  }
  if (const Status saved = saveProject(*project, options.output); !saved) return fail(saved.error());

  say(options.output + ": " + std::to_string(report.springsChanged) + " springs and " +
      std::to_string(report.nodesChanged) + " nodes changed, " +
      std::to_string(project->tissue.regions.size()) + " regions");
  if (options.json) {
    JsonLine line;
    line.add("file", options.output);
    line.add("springs_changed", report.springsChanged);
    line.add("nodes_changed", report.nodesChanged);
    line.add("min_youngs_modulus", report.minYoungsModulus);
    line.add("max_youngs_modulus", report.maxYoungsModulus);
    line.add("total_mass", project->net.mass.sum());
    line.add("regions", project->tissue.regions.size());
    line.add("rules", project->tissue.rules.rules.size());
    print(line.text());
  }
  return Exit::Done;
}

/// An argument that is kept in the order of the command line; `read` gets its numbers, or throws.
void addEdit(CLI::App& command, ApplyOptions& options, const std::string& name, Edit::Kind kind,
             const std::string& shape, const std::string& help,
             const std::function<std::vector<double>(const std::string&)>& read)
{
  const auto keep = [&options, kind, read](const std::string& text) {
    options.edits.push_back({kind, text, read(text)});
  };
  command.add_option_function<std::string>(name, keep, help)->type_name(shape)->trigger_on_parse();
}

void addTissueArguments(CLI::App& command, ApplyOptions& options)
{
  using Kind = Edit::Kind;
  addEdit(
    command, options, "--set", Kind::Set, "NAME=VALUE",
    "an input, as a number or a word: hardness=0.8, \"hardness=very hard\"; before the first --region for "
    "the base tissue, after one for that region; all before and none after: for the regions",
    [](const std::string& text) {
      if (text.find('=') == std::string::npos)
        throw CLI::ValidationError("--set", "\"" + text + "\" is not NAME=VALUE");
      return std::vector<double>{};
    });
  addEdit(command, options, "--region", Kind::Region, "CX,CY,CZ,RX,RY,RZ",
          "an ellipsoid with tissue of its own: centre and semi-axes [m]", [](const std::string& text) {
            const auto numbers = numbersArgument("--region", text, 6, 6);
            if (*std::min_element(numbers.begin() + 3, numbers.end()) <= 0.0)
              throw CLI::ValidationError("--region", "\"" + text + "\": the semi-axes must be > 0");
            return numbers;
          });
  addEdit(command, options, "--falloff", Kind::Falloff, "SHARE",
          "share of the radius, 0 to 1, over which the region before it (or those to come) fades out",
          [](const std::string& text) {
            const double share = numberArgument("--falloff", text, NumberRange::NotNegative);
            if (share > 1.0)
              throw CLI::ValidationError("--falloff", "\"" + text + "\" is not between 0 and 1");
            return std::vector<double>{share};
          });
  addEdit(command, options, "--rule", Kind::Rule, "TEXT",
          "one more rule: \"IF hardness IS ... THEN ... IS ...\"",
          [](const std::string&) { return std::vector<double>{}; });
  command.add_option("--rules", options.rules,
                     "rules in place of those of the project: a text file or a project");
}

void addLoadArguments(CLI::App& command, ApplyOptions& options)
{
  using Kind = Edit::Kind;
  const auto list = [](const char* name, std::size_t least, std::size_t most) {
    return [=](const std::string& text) { return numbersArgument(name, text, least, most); };
  };
  addEdit(command, options, "--fix-box", Kind::FixBox, "X0,Y0,Z0,X1,Y1,Z1", "fix all nodes in this box [m]",
          list("--fix-box", 6, 6));
  addEdit(
    command, options, "--poke", Kind::Poke, "X,Y,Z,FX,FY,FZ,RADIUS[,RELEASE]",
    "a force [N], shared by all free nodes within the radius [m] of the point; rises within 0.1 s, then "
    "holds, and falls within 0.1 s from the release time [s], if given",
    list("--poke", 7, 8));
  addEdit(command, options, "--gravity", Kind::Gravity, "GX,GY,GZ", "gravity [m/s^2]",
          list("--gravity", 3, 3));
  command.add_flag_callback(
    "--clear-loads",
    [&options] {
      options.edits.push_back({Kind::ClearLoads, {}, {}});
    },
    "remove all loads that the project had");
}

} // namespace

void addApply(CLI::App& program, Work& work)
{
  auto options = std::make_shared<ApplyOptions>();
  CLI::App* command = program.add_subcommand("apply", "Rules to parameters: set inputs, regions and loads");
  command->add_option("PROJECT", options->file, ".esm, .esmb or net.json")->required();
  command->add_option("-o,--output", options->output, "the changed project")->required();
  addTissueArguments(*command, *options);
  addLoadArguments(*command, *options);
  addJsonFlag(*command, options->json);
  command->footer("Example:\n  esm apply uterus.esm -o poked.esm --set hardness=0.3 \\\n"
                  "    --region \"0,0,0.03,0.02,0.02,0.02\" --set \"hardness=very hard\" \\\n"
                  "    --fix-box \"-1,-1,-1,1,1,0.005\" --poke \"0,0,0.06,0,0,-0.5,0.01\"");
  command->callback([options, &work] {
    keepFilesApart({options->rules}, {options->output}); // a project may be changed in place
    work = [options] { return apply(*options); };
  });
}

} // namespace esm::cli
