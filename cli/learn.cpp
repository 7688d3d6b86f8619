// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/learning/learn.h"
#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/output_files.h"
#include "core/base/file_io.h"
#include "core/base/json_line.h"
#include "core/base/text_number.h"
#include "core/learning/recording_csv.h"
#include "core/project/project_io.h"

#include <algorithm>
#include <csignal>

namespace esm::cli {

namespace {

using namespace esm::learning;

struct LearnOptions {
  std::string file, output, report;
  std::vector<std::string> recordings, validation, what;
  std::string lengthUnit = "m", forceUnit = "N";
  std::optional<int> rounds, threads;
  bool checkGradient = false, json = false;
};

/// The first Ctrl-C ends learning with the best so far, a second one the program.
std::atomic<bool>* g_stop = nullptr;
extern "C" void stopLearning(int signal)
{
  if (g_stop != nullptr) g_stop->store(true, std::memory_order_relaxed);
  std::signal(signal, SIG_DFL);
}

class SoftInterrupt {
public:
  explicit SoftInterrupt(WorkControl& control)
  {
    g_stop = &control.cancelled;
    m_before = std::signal(SIGINT, stopLearning);
    if (m_before == SIG_IGN) std::signal(SIGINT, SIG_IGN);
  }
  ~SoftInterrupt()
  {
    std::signal(SIGINT, m_before == SIG_ERR ? SIG_DFL : m_before);
    g_stop = nullptr;
  }
  SoftInterrupt(const SoftInterrupt&) = delete;
  SoftInterrupt& operator=(const SoftInterrupt&) = delete;

private:
  void (*m_before)(int);
};

RecordingUnits unitsOf(const LearnOptions& options)
{
  RecordingUnits units;
  units.length = options.lengthUnit == "mm" ? 1e-3 : options.lengthUnit == "cm" ? 1e-2 : 1.0;
  units.force = options.forceUnit == "mN" ? 1e-3 : options.forceUnit == "kN" ? 1e3 : 1.0;
  return units;
}

Result<std::vector<learning::Recording>> readRecordings(const std::vector<std::string>& files,
                                                        const SpringNet& net, const RecordingUnits& units)
{
  std::vector<learning::Recording> recordings;
  for (const std::string& file : files) {
    const Result<std::string> bytes = readFile(file);
    if (!bytes) return bytes.error();
    Result<learning::Recording> recording = readRecordingCsv(*bytes, file, net, units);
    if (!recording) return recording.error();
    if (const Status status = checkForceUnit(*recording, net); !status) return status.error();
    recordings.push_back(std::move(*recording));
  }
  return recordings;
}

std::string percent(double error)
{
  return formatDouble(100.0 * error, 3) + " %";
}

void sayRound(const FitRound& round, bool validates)
{
  say("round " + std::to_string(round.round) + ": error " + percent(round.training) +
      (validates ? ", validation " + percent(round.validation) : ""));
}

JsonLine caseLine(const FitCase& one)
{
  JsonLine line;
  line.add("recording", one.name);
  line.add("validates", one.validates);
  line.add("used", one.isUsed);
  line.add("error_before", one.before);
  line.add("error_after", one.after);
  return line;
}

JsonLine reportOf(const LearnResult& result, const LearnOptions& options)
{
  JsonLine line;
  line.add("file", options.output);
  line.add("what", options.what);
  line.add("helped", result.hasHelped);
  line.add("training_before", result.trainingBefore);
  line.add("training_after", result.trainingAfter);
  if (!options.validation.empty()) {
    line.add("validation_before", result.validationBefore);
    line.add("validation_after", result.validationAfter);
  }
  std::vector<JsonLine> cases, rounds, parameters;
  for (const FitCase& one : result.last.cases) cases.push_back(caseLine(one));
  for (const FitReport* report : {&result.first, &result.last})
    for (const FitRound& round : report->rounds) {
      JsonLine one;
      one.add("stage", report == &result.first ? "global" : "asked");
      one.add("round", round.round);
      one.add("training", round.training);
      if (!options.validation.empty()) one.add("validation", round.validation);
      one.add("rejected", round.rejected);
      rounds.push_back(one);
    }
  for (std::size_t j = 0; j < result.names.size(); ++j) {
    JsonLine one;
    one.add("name", result.names[j]);
    one.add("value", result.last.theta[j]);
    one.add("deviation", result.last.deviations[j]);
    one.add("seen", result.last.isSeen[j] != 0);
    parameters.push_back(one);
  }
  line.add("parameters", parameters);
  line.add("recordings", cases);
  line.add("rounds", rounds);
  line.add("notes", result.notes);
  line.add("end", result.last.end);
  line.add("forwards", result.first.forwards + result.last.forwards);
  return line;
}

Exit checkedGradient(const Project& project, const std::vector<learning::Recording>& training,
                     const LearnSettings& settings)
{
  const auto checks = esm::learning::checkGradient(project.tissue, project.net, training, settings);
  if (!checks) return fail(checks.error());
  constexpr double kWrong = 1e-6; ///< far from what rounding leaves of differences
  Exit exit = Exit::Done;
  for (const GradientCheck& check : *checks) {
    print(check.block + ": slope " + formatDouble(check.exact) + ", by differences " +
          formatDouble(check.measured) + ", apart by " + formatDouble(check.relativeError(), 2));
    if (!(check.relativeError() <= kWrong)) exit = Exit::Numerics;
  }
  return exit;
}

Exit learnFrom(const LearnOptions& options)
{
  Result<Project> project = loadProject(options.file);
  if (!project) return fail(project.error());
  if (!project->parametersFromTissue)
    return fail(invalidValue(options.file +
                             ": its net keeps numbers of its own, so that nothing learned about tissue would "
                             "reach them; let it follow the tissue first (esm apply " +
                             options.file + " -o ...)"));
  const auto training = readRecordings(options.recordings, project->net, unitsOf(options));
  if (!training) return fail(training.error());
  const auto validation = readRecordings(options.validation, project->net, unitsOf(options));
  if (!validation) return fail(validation.error());

  WorkControl control;
  WorkerPool workers(options.threads.value_or(project->simulation.solver.threads));
  LearnSettings settings;
  settings.what = options.what;
  settings.fit.control = &control;
  settings.fit.workers = &workers;
  if (options.rounds) settings.fit.mostRounds = *options.rounds;
  if (options.checkGradient) return checkedGradient(*project, *training, settings);
  settings.fit.onRound = [&](const FitRound& round) { sayRound(round, !options.validation.empty()); };

  const SoftInterrupt interrupt(control);
  const auto result = learn(project->tissue, project->net, *training, *validation, settings);
  if (!result) return fail(result.error());
  for (const std::string& note : result->notes) say(note);
  if (!options.report.empty())
    if (const Status written = writeFileAtomically(options.report, reportOf(*result, options).text() + "\n");
        !written)
      return fail(written.error());
  if (options.json) print(reportOf(*result, options).text());
  if (!result->hasHelped) {
    say("nothing that was learned helps" +
        std::string(validation->empty() ? "" : " the validation recordings") + ": " + options.output +
        " is not written");
    return Exit::Numerics;
  }
  project->tissue.learned = result->layer;
  if (const auto applied = applyTissue(project->tissue, project->net); !applied) return fail(applied.error());
  project->source =
    withRelativeNames(withAbsoluteNames(project->source, folderOf(options.file)), folderOf(options.output));
  if (const Status saved = saveProject(*project, options.output); !saved) return fail(saved.error());
  say(
    options.output + ": error " + percent(result->trainingBefore) + " -> " + percent(result->trainingAfter) +
    (validation->empty()
       ? ""
       : ", validation " + percent(result->validationBefore) + " -> " + percent(result->validationAfter)) +
    ", " + std::to_string(result->layer.factors.size() + result->layer.springs.size()) + " numbers learned");
  return Exit::Done;
}

std::string knownBlocks()
{
  std::string text;
  for (const ParameterBlock& block : parameterBlocks())
    text += "\n  " + std::string(block.id) + std::string(10 - std::string_view(block.id).size(), ' ') +
            block.description;
  return text;
}

} // namespace

void addLearn(CLI::App& program, Work& work)
{
  auto options = std::make_shared<LearnOptions>();
  CLI::App* command =
    program.add_subcommand("learn", "Learn the net's stiffness from recorded loads and movements");
  command->add_option("PROJECT", options->file, ".esm or .esmb")->required();
  command
    ->add_option("-r,--recording", options->recordings,
                 "tables of what was seen, one per experiment (docs/LEARNING.md)")
    ->required()
    ->expected(1, -1);
  command->add_option("--validate", options->validation, "recordings that judge and are not learned from")
    ->expected(1, -1);
  std::vector<std::string> known;
  for (const ParameterBlock& block : parameterBlocks()) known.emplace_back(block.id);
  command->add_option("--what", options->what, "what may change, several with commas (default: classes)")
    ->delimiter(',')
    ->check(CLI::IsMember(known));
  command->add_option("-o,--output", options->output, "the project that has learned");
  command->add_option("--report", options->report, "errors, rounds and learned numbers as JSON");
  command->add_option("--length-unit", options->lengthUnit, "of the recordings: m, cm or mm")
    ->check(CLI::IsMember({"m", "cm", "mm"}));
  command->add_option("--force-unit", options->forceUnit, "of the recordings: N, mN or kN")
    ->check(CLI::IsMember({"N", "mN", "kN"}));
  addInteger(*command, "--rounds", options->rounds, "the most rounds of each stage", 1, 100000);
  addInteger(*command, "--threads", options->threads, "that share the recordings; the result is the same", 1,
             1024);
  command->add_flag("--check-gradient", options->checkGradient,
                    "learn nothing, hold the exact slopes against differences");
  addJsonFlag(*command, options->json);
  command->footer(
    "What may change:" + knownBlocks() +
    "\n\nExample:\n  esm learn tube.esm -r poke.csv pull.csv drag.csv --validate twist.csv -o taught.esm\n\n"
    "Ctrl-C ends with the best so far. Exit code 3: nothing helped, no project is written.");
  command->callback([options, &work] {
    if (options->what.empty()) options->what = {"classes"};
    if (options->output.empty() && !options->checkGradient) throw CLI::RequiredError("--output");
    std::vector<std::string> read = options->recordings;
    read.insert(read.end(), options->validation.begin(), options->validation.end());
    keepFilesApart(read, {options->output, options->report}); // a project may learn in place
    work = [options] { return learnFrom(*options); };
  });
}

} // namespace esm::cli
