// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/output_files.h"
#include "cli/simulate_run.h"
#include "core/base/file_io.h"
#include "core/base/json_line.h"
#include "core/base/text_number.h"
#include "core/project/project_io.h"

#include <algorithm>
#include <cmath>

namespace esm::cli {

namespace {

struct SimulateOptions {
  std::string file, report;
  std::optional<std::string> solver;
  std::optional<double> duration, frameRate, tolerance, fixedStep, workLimit;
  std::optional<int> threads;
  std::optional<bool> skipResting;
  RunOutputs outputs;
  bool verify = false, json = false, acceptRough = false;
};

/// Of a part of the net whose energy is not accounted for; null: all is well. A large part excuses no small one.
const EnergyReport* unaccountedEnergy(const RunSummary& summary, double tolerance)
{
  const auto bad = std::ranges::find_if(summary.energyOfParts,
                                        [&](const EnergyReport& part) { return !part.isKept(tolerance); });
  return bad == summary.energyOfParts.end() ? nullptr : &*bad;
}

constexpr double kMostGrowth = 100.0; ///< of errors; steps of stiff nets leave room for snaps of 20 to 60

/// Of a part of the net whose method has taken most of its energy away; null: of none.
const EnergyReport* lostEnergy(const RunSummary& summary)
{
  const auto lost = std::ranges::find_if(summary.energyOfParts, &EnergyReport::hasLost);
  return lost == summary.energyOfParts.end() ? nullptr : &*lost;
}

/// @return whether the numerics went well, the tolerance was not given up, and no energy has come or gone that
/// nobody accounts for or that the method has eaten, and errors have not grown
bool isGood(const RunSummary& summary, double tolerance)
{
  return summary.steps.good() && !summary.steps.rough && unaccountedEnergy(summary, tolerance) == nullptr &&
         lostEnergy(summary) == nullptr && summary.errorGrowth < kMostGrowth;
}

JsonLine jsonOf(const RunSummary& summary, const Project& project)
{
  JsonLine line;
  line.add("integration_seconds", summary.integrationSeconds);
  line.add("steps", summary.steps.steps);
  line.add("rejected_steps", summary.steps.rejectedSteps);
  line.add("springs_evaluated", summary.steps.springsEvaluated);
  line.add("factorizations", summary.steps.factorizations);
  line.add("newton_iterations", summary.steps.newtonIterations);
  line.add("nodes_awake", summary.steps.nodesAwake);
  line.add("mean_nodes_awake", summary.nodesAwake);
  line.add("parts", static_cast<std::int64_t>(summary.energyOfParts.size()));
  line.add("smallest_step", summary.steps.smallestStep);
  line.add("solver", summary.solver);
  line.add("reason", summary.reason);
  line.add("initial_energy", summary.energy.atStart.total());
  line.add("energy", summary.energy.atEnd.total());
  line.add("kinetic_energy", summary.energy.atEnd.kinetic);
  line.add("elastic_energy", summary.energy.atEnd.elastic);
  line.add("external_work", summary.energy.work);
  line.add("dissipated_energy", summary.energy.heat);
  line.add("method_loss", summary.energy.loss);
  line.add("restored_energy", summary.energy.restored);
  line.add("energy_residual", summary.energy.residual());
  line.add("largest_force", summary.largestForce);
  line.add("finite", !summary.steps.nonFinite);
  line.add("good", isGood(summary, project.simulation.solver.tolerance));
  line.add("tolerance_given_up", summary.steps.rough);
  line.add("error_growth", summary.errorGrowth);
  line.add("simulated_time", summary.steps.simulatedTime);
  line.add("frames", summary.frames);
  if (const std::optional<Verification>& check = summary.verification) {
    line.add("tolerance_kept", check->kept);
    if (check->measuredError) {
      line.add("measured_error", *check->measuredError);
      line.add("measured_error_time", check->worstTime);
    }
    line.add("tolerance_used", check->toleranceUsed);
    line.add("verification", check->why);
    line.add("verification_seconds", check->seconds);
  }
  line.add("nodes", summary.nodes);
  line.add("springs", summary.springs);
  return line;
}

/// What the command line says instead of the project.
void override(SimulationSettings& settings, const SimulateOptions& options)
{
  settings.duration = options.duration.value_or(settings.duration);
  settings.frameRate = options.frameRate.value_or(settings.frameRate);
  settings.solver.solver = options.solver.value_or(settings.solver.solver);
  settings.solver.tolerance = options.tolerance.value_or(settings.solver.tolerance);
  settings.solver.fixedStep = options.fixedStep.value_or(settings.solver.fixedStep);
  settings.solver.skipResting = options.skipResting.value_or(settings.solver.skipResting);
  settings.solver.workLimit = options.workLimit.value_or(settings.solver.workLimit);
  settings.solver.threads = options.threads.value_or(settings.solver.threads);
}

/// @return whether the tolerance is kept, as far as anybody has asked
bool sayVerification(const SimulateOptions& options, const RunSummary& summary, double tolerance)
{
  if (!summary.verification) return true;
  const Verification& check = *summary.verification;
  const std::string wanted = "the tolerance of " + formatDouble(tolerance, 3);
  const bool isFiner = check.toleranceUsed < tolerance;
  const std::string how = isFiner ? ", with the steps of one of " + formatDouble(check.toleranceUsed, 3) : "";
  if (check.kept)
    say(wanted + " is kept" + how + ": " + check.why);
  else
    say(options.file + ": " + wanted + " is not kept" + how + ": " + check.why);
  return check.kept;
}

double largestBesideLoss(EnergyReport energy)
{
  energy.loss = 0.0;
  return energy.largestTerm();
}

/// Whether the balance bears out what the method says it has added: what nobody accounts for is less than any
/// other energy of the run.
bool isBorneOut(const EnergyReport& energy)
{
  return std::abs(energy.residual()) <= largestBesideLoss(energy);
}

/// @return whether the energy is accounted for
bool sayEnergy(const SimulateOptions& options, const RunSummary& summary, double tolerance)
{
  const EnergyReport* energy = unaccountedEnergy(summary, tolerance);
  if (energy == nullptr) return true;
  if (!std::isfinite(energy->residual())) {
    say(options.file + ": energy has grown beyond what numbers can hold; use a smaller --step, or none");
    return false;
  }
  if (energy->hasAdded(tolerance) && isBorneOut(*energy)) {
    say(options.file + ": by its own estimate the method has added " + formatDouble(-energy->loss, 3) +
        " J to the motion, beside " + formatDouble(energy->heat, 3) +
        " J of heat; use a smaller --tolerance, or a smaller --step where one is given");
    return false;
  }
  say(options.file + ": energy is not accounted for: " + formatDouble(energy->residual(), 3) + " J of " +
      formatDouble(energy->largestTerm(), 3) + " J, more than the tolerance of " +
      formatDouble(tolerance, 3) +
      " bears; use a smaller --tolerance, or a smaller --step where one is given");
  return false;
}

/// @return whether the method has left the motion its energy
bool sayLoss(const SimulateOptions& options, const RunSummary& summary)
{
  const EnergyReport* energy = lostEnergy(summary);
  if (energy == nullptr) return true;
  say(options.file + ": the method itself has taken " + formatDouble(energy->loss, 3) +
      " J from the motion, of " + formatDouble(largestBesideLoss(*energy), 3) +
      " J: vibrations have died that nothing damps, and the tolerance may well be missed; use a smaller "
      "--tolerance, or --solver verlet with a --step of a tenth of their time");
  return false;
}

/// @return whether the tolerance is believable, as steps keep it that know nothing of what becomes of errors
bool sayGrowth(const SimulateOptions& options, const RunSummary& summary, double tolerance)
{
  if (summary.errorGrowth < kMostGrowth) return true;
  say(options.file + ": this motion multiplies small errors, " + formatDouble(summary.errorGrowth, 2) +
      "-fold and more up to " + formatDouble(summary.errorGrowthTime, 3) + " s: the tolerance of " +
      formatDouble(tolerance, 3) + " may well be missed; --verify measures the error and takes finer steps");
  return false;
}

/// What happened, where, and what helps.
void sayRough(const SimulateOptions& options, const RunSummary& summary, double tolerance)
{
  const std::string frames = std::to_string(summary.roughFrames) + " of " +
                             std::to_string(std::max(summary.frames - 1, summary.roughFrames)) + " frames";
  const std::string cause = summary.suddenMotion.empty()
                              ? summary.roughReason
                              : summary.suddenMotion + ", and " + summary.roughReason;
  const std::string help =
    summary.suddenMotion.empty()
      ? "a larger --tolerance or more --work may keep it, as softer springs and heavier nodes do"
      : "spread that motion over more time, or take a larger --tolerance";
  say(options.file + ": the tolerance of " + formatDouble(tolerance, 3) + " was given up in " + frames +
      ", first in the one that ends at " + formatDouble(summary.roughTime, 3) + " s: " + cause +
      ". The motion is bounded, but rough there: " + help + "; --accept-rough takes it as it is");
}

Exit simulate(const SimulateOptions& options)
{
  Result<Project> project = loadProject(options.file);
  if (!project) return fail(project.error());
  override(project->simulation, options);
  if (project->simulation.duration * project->simulation.frameRate > 1e9)
    return fail(
      {ErrorCode::InvalidValue, options.file + ": more than 1e9 frames; use less --duration or --frames"});

  const double fixedStep = project->simulation.solver.fixedStep;
  if (fixedStep > 0.0 && project->simulation.duration / fixedStep > 1e18)
    return fail({ErrorCode::InvalidValue, options.file + ": more than 1e18 steps; use a larger --step"});
  for (const std::string& later : {options.report, options.outputs.forceCurve, options.outputs.mesh})
    if (const Status status = later.empty() ? Status{} : canBeWritten(later); !status)
      return fail(status.error());
  const Result<RunSummary> summary =
    options.verify ? runVerified(*project, options.outputs) : runSimulation(*project, options.outputs);
  if (!summary) return fail(summary.error());
  const std::string json = jsonOf(*summary, *project).text();
  if (!options.report.empty())
    if (const Status written = writeFileAtomically(options.report, json + "\n"); !written)
      return fail(written.error());
  const bool good = summary->steps.good();
  if (good)
    say(std::to_string(summary->frames) + " frames, " + std::to_string(summary->steps.steps) +
        " steps with " + summary->solver + " in " + formatDouble(summary->integrationSeconds, 3) +
        " s of processor time");
  else
    say(options.file + ": stopped after " + std::to_string(summary->frames) + " frames, at " +
        formatDouble(summary->steps.simulatedTime, 3) + " s: " + summary->reason);
  const double tolerance = project->simulation.solver.tolerance;
  if (summary->steps.rough) sayRough(options, *summary, tolerance);
  const bool isAccountedFor = !good || sayEnergy(options, *summary, tolerance);
  const bool isVerified = !good || sayVerification(options, *summary, tolerance);
  const bool isCredible = !good || sayGrowth(options, *summary, tolerance);
  const bool isAlive = !good || summary->steps.rough || sayLoss(options, *summary);
  const bool isRough = summary->steps.rough || !isAccountedFor || !isCredible || !isAlive;
  if (options.json) print(json);
  return good && isVerified && (!isRough || options.acceptRough) ? Exit::Done : Exit::Numerics;
}

/// A solver's name, or the list of them as a usage fault.
void addSolverOption(CLI::App& command, SimulateOptions& options)
{
  const auto read = [&options](const std::string& name) {
    std::string known = "auto";
    bool found = name == "auto";
    for (const SolverInfo& solver : solverNames()) {
      known += ", " + solver.name;
      found |= solver.name == name;
    }
    if (!found) throw CLI::ValidationError("--solver", "\"" + name + "\" is not one of " + known);
    options.solver = name;
  };
  command.add_option_function<std::string>("--solver", read, "auto, or a name of `esm solvers`")
    ->type_name("NAME");
}

} // namespace

void addSimulate(CLI::App& program, Work& work)
{
  auto options = std::make_shared<SimulateOptions>();
  CLI::App* command = program.add_subcommand("simulate", "Move a net and write its motion");
  command->add_option("PROJECT", options->file, ".esm, .esmb or net.json")->required();
  addNumber(*command, "--duration", options->duration, "[s] (default: the project's)",
            NumberRange::NotNegative);
  addNumber(*command, "--frames", options->frameRate, "frames per second (default: the project's)",
            NumberRange::Positive);
  addSolverOption(*command, *options);
  addNumber(*command, "--tolerance", options->tolerance, "wanted relative error (default: the project's)",
            NumberRange::Positive);
  CLI::Option* verify = command->add_flag(
    "--verify", options->verify,
    "measure the error by finer runs, and take finer steps where the tolerance is not kept; "
    "exit code 3 if it cannot be");
  command->add_flag(
    "--accept-rough", options->acceptRough,
    "exit code 0, not 3, where the tolerance was given up to bound the work, where errors grow "
    "or energy is not accounted for");
  addNumber(*command, "--step", options->fixedStep, "fixed substep [s] without error control; 0: automatic",
            NumberRange::NotNegative);
  addNumber(
    *command, "--work", options->workLimit,
    "most force passes for each 1/60 s of motion, in the mean of the run (default: 2e5); beyond it the run "
    "ends with what it has, and exit code 3",
    NumberRange::Positive);
  command->add_flag_function(
    "--skip-resting,!--no-skip", [&skip = options->skipResting](std::int64_t count) { skip = count > 0; },
    "nodes at rest sleep and cost nothing, or not (default: the project's)");
  addInteger(*command, "--threads", options->threads,
             "threads that may share a large net; the result is the same bit for bit", 1, 1024);
  command->add_option("-o,--output", options->outputs.motion,
                      "the motion: .csv (t,id,x,y,z), .f64 (float64, frames x nodes x 3) or .pvd (ParaView)");
  command->add_option("--report", options->report, "what it cost and came to, as JSON");
  command->add_option("--force-curve", options->outputs.forceCurve,
                      "CSV: t, applied force, reaction force [N], displacement of the loaded nodes [m]");
  command->add_option("--mesh", options->outputs.mesh,
                      "the deformed net at the end: obj, ply, stl, glb, vtu or csv");
  command
    ->add_option(
      "--log", options->outputs.log,
      "the run as `esm replay-log` repeats it to the bit: project, what was asked, methods and steps")
    ->excludes(verify);
  addJsonFlag(*command, options->json);
  command->footer("Example:\n  esm simulate poked.esm --duration 2 --frames 60 -o motion.pvd "
                  "--report report.json");
  command->callback([options, &work] {
    std::vector<std::string> written = exportedFiles(options->outputs.mesh);
    for (const std::string& output :
         {options->outputs.motion, options->report, options->outputs.forceCurve, options->outputs.log})
      written.push_back(output);
    keepFilesApart({options->file}, written);
    work = [options] { return simulate(*options); };
  });
}

} // namespace esm::cli
