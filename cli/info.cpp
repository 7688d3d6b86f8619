// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "cli/arguments.h"
#include "cli/commands.h"
#include "core/base/json_line.h"
#include "core/base/text_number.h"
#include "core/project/project_io.h"

#include <algorithm>

namespace esm::cli {

namespace {

struct InfoOptions {
  std::string file;
  bool json = false;
};

Index countSet(const std::vector<std::uint8_t>& flags)
{
  return static_cast<Index>(std::count_if(flags.begin(), flags.end(), [](std::uint8_t f) { return f != 0; }));
}

double least(const Eigen::ArrayXd& values)
{
  return values.size() > 0 ? values.minCoeff() : 0.0;
}

double largest(const Eigen::ArrayXd& values)
{
  return values.size() > 0 ? values.maxCoeff() : 0.0;
}

JsonLine inputsOf(const std::vector<fuzzy::InputValue>& inputs, const fuzzy::RuleBase& rules)
{
  JsonLine line;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const fuzzy::Variable& variable = rules.inputs[i];
    if (const double* crisp = std::get_if<double>(&inputs[i]))
      line.add(variable.id, *crisp);
    else
      line.add(variable.id, fuzzy::formatInput(inputs[i], variable, Language::English));
  }
  return line;
}

JsonLine jsonOf(const Project& project)
{
  const SpringNet& net = project.net;
  JsonLine line;
  line.add("name", project.name);
  line.add("source", project.source.files.empty() ? std::string() : project.source.files.front().name);
  line.add("nodes", net.nodeCount());
  line.add("springs", net.springCount());
  line.add("triangles", net.triangleCount());
  line.add("fixed_nodes", countSet(net.fixed));
  line.add("anchors", net.anchors.count());
  line.add("total_mass", net.mass.sum());
  line.add("min_stiffness", least(net.stiffness));
  line.add("max_stiffness", largest(net.stiffness));
  line.add("parameters_from_tissue", project.parametersFromTissue);
  line.add("inputs", inputsOf(project.tissue.inputs, project.tissue.rules));
  line.add("rules", project.tissue.rules.rules.size());
  line.add("regions", project.tissue.regions.size());
  line.add("forces", project.loads.forces.size());
  line.add("motions", project.loads.motions.size());
  line.add("duration", project.simulation.duration);
  line.add("frame_rate", project.simulation.frameRate);
  line.add("solver", project.simulation.solver.solver);
  return line;
}

void printInfo(const Project& project)
{
  const SpringNet& net = project.net;
  const auto count = [](auto number, const char* what) { return std::to_string(number) + " " + what; };
  print("name       " + project.name);
  for (const SourceFile& file : project.source.files)
    print("made from  " + file.name + " (" + lengthUnitName(project.source.unit) + ")");
  print("net        " + count(net.nodeCount(), "nodes, ") + count(net.springCount(), "springs, ") +
        count(net.triangleCount(), "triangles, ") + count(countSet(net.fixed), "fixed, ") +
        count(net.anchors.count(), "anchors"));
  print("mass       " + formatDouble(net.mass.sum(), 6) + " kg");
  print("stiffness  " + formatDouble(least(net.stiffness), 6) + " to " +
        formatDouble(largest(net.stiffness), 6) + " N/m" +
        (project.parametersFromTissue ? ", from the tissue" : ", the net's own"));
  for (std::size_t i = 0; i < project.tissue.inputs.size(); ++i) {
    const fuzzy::Variable& variable = project.tissue.rules.inputs[i];
    print("input      " + variable.id + " = " +
          fuzzy::formatInput(project.tissue.inputs[i], variable, Language::English));
  }
  for (const fuzzy::Rule& rule : project.tissue.rules.rules)
    print("rule       " + fuzzy::formatRule(rule, project.tissue.rules, Language::English) +
          (rule.enabled ? "" : "   (off)"));
  for (const Region& region : project.tissue.regions) print("region     " + region.name);
  print("loads      " + count(project.loads.forces.size(), "forces, ") +
        count(project.loads.motions.size(), "motions"));
  print("story      " + formatDouble(project.simulation.duration, 6) + " s at " +
        formatDouble(project.simulation.frameRate, 6) + " frames/s, solver " +
        project.simulation.solver.solver);
}

Exit info(const InfoOptions& options)
{
  const Result<Project> project = loadProject(options.file);
  if (!project) return fail(project.error());
  if (options.json)
    print(jsonOf(*project).text());
  else
    printInfo(*project);
  return Exit::Done;
}

} // namespace

void addInfo(CLI::App& program, Work& work)
{
  auto options = std::make_shared<InfoOptions>();
  CLI::App* command = program.add_subcommand("info", "Say what a project holds");
  command->add_option("PROJECT", options->file, ".esm, .esmb or net.json")->required();
  addJsonFlag(*command, options->json);
  command->callback([options, &work] { work = [options] { return info(*options); }; });
}

} // namespace esm::cli
