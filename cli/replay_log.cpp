// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/output_files.h"
#include "core/base/json_line.h"
#include "core/base/text_number.h"
#include "core/dynamics/simulation.h"
#include "core/project/motion_log_file.h"
#include "core/project/project_io.h"

#include <algorithm>
#include <map>

namespace esm::cli {

namespace {

struct ReplayOptions {
  std::string file, saved;
  std::optional<int> threads;
  bool json = false;
};

/// Steps of each method, as "12 of chebyshev, 3 of implicit".
std::string stepsOf(const MotionLog& log)
{
  std::map<std::string, std::int64_t> steps;
  for (const LogEntry& entry : log)
    if (const auto* advance = std::get_if<logged::Advance>(&entry))
      for (const logged::Advance::Part& part : advance->parts)
        for (const Stretch& stretch : part.stretches) steps[stretch.method] += stretch.steps;
  std::string text;
  for (const auto& [method, count] : steps)
    text += (text.empty() ? "" : ", ") + std::to_string(count) + " of " + method;
  return text.empty() ? "none" : text;
}

Exit replay(const ReplayOptions& options)
{
  Result<RecordedRun> run = readMotionLog(options.file);
  if (!run) return fail(run.error());
  if (!run->cut.empty()) say(run->cut);
  if (!options.saved.empty())
    if (const Status status = saveProject(run->project, options.saved); !status) return fail(status.error());
  SolverSettings settings = run->settings;
  settings.threads = options.threads.value_or(settings.threads);
  Result<Simulation> simulation =
    Simulation::create(std::move(run->project.net), std::move(run->project.loads), settings);
  if (!simulation) return fail(simulation.error());
  Progress progress("replaying");
  std::string difference;
  std::size_t done = 0;
  while (done < run->log.size() && difference.empty()) {
    Result<std::string> found = simulation->replay(run->log[done]);
    if (!found)
      return fail({found.error().code,
                   options.file + ", entry " + std::to_string(done + 1) + ": " + found.error().detail});
    difference = std::move(*found);
    progress.show(static_cast<long long>(++done), static_cast<long long>(run->log.size()));
  }
  const double time = simulation->state().time;
  const auto advances = std::ranges::count_if(
    run->log, [](const LogEntry& entry) { return std::holds_alternative<logged::Advance>(entry); });
  if (difference.empty())
    say(options.file + ": the same to the bit up to " + formatDouble(time, 6) + " s, in " +
        std::to_string(advances) + " calls; steps that were kept: " + stepsOf(run->log));
  else
    say(options.file + ", entry " + std::to_string(done) + ": " + difference +
        "; another version of the program, or a fault of it, moves this net otherwise");
  if (options.json) {
    JsonLine line;
    line.add("entries", static_cast<std::int64_t>(run->log.size()));
    line.add("advances", static_cast<std::int64_t>(advances));
    line.add("replayed", static_cast<std::int64_t>(done));
    line.add("simulated_time", time);
    line.add("same", difference.empty());
    line.add("difference", difference);
    line.add("whole", run->cut.empty());
    print(line.text());
  }
  return difference.empty() ? Exit::Done : Exit::Numerics;
}

} // namespace

void addReplayLog(CLI::App& program, Work& work)
{
  auto options = std::make_shared<ReplayOptions>();
  CLI::App* command =
    program.add_subcommand("replay-log", "Repeat a run that was written down, and compare it bit for bit");
  command->add_option("LOG", options->file, "what `esm simulate --log` has written")->required();
  addInteger(*command, "--threads", options->threads,
             "threads that may share a large net (default: those of the run); the result is the same", 1,
             1024);
  command->add_option("--project", options->saved,
                      "also write the project that the log holds: .esm or .esmb");
  addJsonFlag(*command, options->json);
  command->footer("Exit code 3 and the first thing that came out otherwise, if anything did.\n\n"
                  "Example:\n  esm simulate poked.esm --log poked.esmlog && esm replay-log poked.esmlog");
  command->callback([options, &work] {
    keepFilesApart({options->file}, {options->saved});
    work = [options] { return replay(*options); };
  });
}

} // namespace esm::cli
