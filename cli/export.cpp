// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/project/export.h"
#include "core/base/json_line.h"
#include "core/dynamics/simulation.h"

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/output_files.h"
#include "core/base/file_io.h"
#include "core/project/net_format.h"
#include "core/project/project_io.h"

namespace esm::cli {

namespace {

struct ExportOptions {
  std::string file, output;
  bool json = false;
};

/// The net at rest, with the forces that its springs already have there.
Status exportAtRest(const Project& project, const std::string& path, std::vector<std::string>& lost)
{
  Result<Simulation> simulation = Simulation::create(project.net, project.loads, {});
  if (!simulation) return simulation.error();
  Eigen::ArrayXd tension(project.net.springCount());
  simulation->springTensions(tension);
  const NetState& state = simulation->state();
  const Frame frame{&project.net, &state.position, &state.velocity, &tension, 0.0, &project.loads};
  lost = lostInExport(frame, path);
  if (project.parametersFromTissue && !lost.empty())
    lost.push_back("the rules, inputs and regions; the springs keep the numbers made from them");
  return exportFrame(frame, path);
}

Exit exportProject(const ExportOptions& options)
{
  Result<Project> project = loadProject(options.file);
  if (!project) return fail(project.error());
  const std::string ending = std::filesystem::path(options.output).extension().string();
  std::vector<std::string> lost;
  Status written;
  if (ending == ".json")
    written = writeFileAtomically(options.output, toNetFormat(*project, &lost));
  else if (ending == ".esm" || ending == ".esmb") {
    project->source =
      withRelativeNames(withAbsoluteNames(project->source, folderOf(options.file)), folderOf(options.output));
    written = saveProject(*project, options.output);
  } else
    written = exportAtRest(*project, options.output, lost);
  if (!written) return fail(written.error());
  for (const std::string& what : lost) say(options.output + ": does not hold " + what);
  if (options.json) {
    JsonLine line;
    line.add("file", options.output);
    line.add("nodes", project->net.nodeCount());
    line.add("springs", project->net.springCount());
    line.add("triangles", project->net.triangleCount());
    line.add("lost", lost);
    print(line.text());
  }
  return Exit::Done;
}

} // namespace

void addExport(CLI::App& program, Work& work)
{
  auto options = std::make_shared<ExportOptions>();
  CLI::App* command = program.add_subcommand("export", "Write the net of a project for other programs");
  command->add_option("PROJECT", options->file, ".esm, .esmb or net.json")->required();
  command
    ->add_option("-o,--output", options->output,
                 "by its ending: obj, ply, stl, glb, gltf, vtu, csv, scn (SOFA), xsp; json is the plain net "
                 "format esm-net-1, "
                 "esm and esmb are the two forms of a project")
    ->required();
  addJsonFlag(*command, options->json);
  command->footer("Example:\n  esm export uterus.esm -o uterus.vtu");
  command->callback([options, &work] {
    keepFilesApart({options->file}, exportedFiles(options->output));
    work = [options] { return exportProject(*options); };
  });
}

} // namespace esm::cli
