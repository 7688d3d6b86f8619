// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "bench/work_precision.h"

#include "core/base/file_io.h"
#include "core/base/text_number.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace esm::bench {
namespace {

/// Goes up when a competitor or the way of sweeping changes.
constexpr char kSweepVersion[] = "3";

std::filesystem::path sweepFile(const Scene& scene, const WorkOptions& options)
{
  char name[96];
  std::snprintf(name, sizeof name, "competitors-%s-%s-%016llx.csv", kSweepVersion,
                options.allCompetitors ? "all" : "front", static_cast<unsigned long long>(hashOf(scene)));
  return cacheFolder() / name;
}

void save(const std::filesystem::path& file, const std::string& text)
{
  if (file.empty()) return;
  if (Status status = writeFileAtomically(file, text); !status)
    std::fprintf(stderr, "%s\n", status.error().detail.c_str()); // only slower next time, if it is a cache
}

void append(std::vector<Row>& rows, const std::vector<Row>& more)
{
  for (const Row& row : more) std::printf("%s", csvLine(row).c_str());
  std::fflush(stdout);
  rows.insert(rows.end(), more.begin(), more.end());
}

void refine(const Scene& scene, const Reference& reference, std::vector<Row>& rows)
{
  const std::size_t before = rows.size();
  refineWinners(rows, [&](Row like, int steps) {
    like.setting = steps;
    return runAgain(scene, like, reference, 1e9);
  });
  for (std::size_t i = before; i < rows.size(); ++i) std::printf("%s", csvLine(rows[i]).c_str());
}

std::vector<Row> sweepCompetitors(const Scene& scene, const Reference& reference, Front& front,
                                  const WorkOptions& options)
{
  const std::filesystem::path file = sweepFile(scene, options);
  std::vector<Row> rows;
  if (!options.retune && options.competitors.empty())
    if (Result<std::vector<Row>> cached = readCsv(file)) rows = std::move(*cached); // else there is none yet
  for (const Row& row : rows) front.add(row);
  if (!rows.empty()) return rows;
  for (const bool adaptive : {true, false}) // the adaptive ones show the others what is worth trying
    for (const MethodEntry& entry : competitors()) {
      const auto& named = options.competitors;
      const bool wanted = named.empty() ? options.allCompetitors || !entry.secondary
                                        : std::find(named.begin(), named.end(), entry.name) != named.end();
      if (entry.adaptive != adaptive || !wanted) continue;
      if (entry.largestNet > 0 && scene.net.nodeCount() > entry.largestNet) continue;
      const auto run = [&](double setting, double cap) {
        return runCompetitor(scene, entry, setting, reference, cap);
      };
      append(rows, adaptive ? sweepTolerances(run, front, options.patience)
                            : sweepSteps(run, entry.implicit ? 4 : 64, front, options.patience));
    }
  refine(scene, reference, rows);
  for (const Row& row : rows) front.add(row);
  if (options.competitors.empty()) {
    std::error_code ignored;
    std::filesystem::create_directories(cacheFolder(), ignored);
    save(file, csvText(rows));
  }
  return rows;
}

int firstSteps(const Scene& scene)
{
  const Result<Simulation> simulation = Simulation::create(scene.net, scene.loads, {});
  const double step = simulation ? simulation->stableStep() : 0.0;
  return step > 0.0 ? static_cast<int>(std::clamp(1.0 / kFrameRate / step, 1.0, 1e5)) : 64;
}

std::vector<Row> sweepOurs(const Scene& scene, const Reference& reference, Front& front,
                           const WorkOptions& options)
{
  std::vector<Row> rows;
  const int guess = firstSteps(scene);
  for (const SolverInfo& solver : solverNames()) {
    const auto& wanted = options.solvers;
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), solver.name) == wanted.end()) continue;
    append(rows, sweepTolerances(
                   [&](double tolerance, double cap) {
                     return runEngine(scene, solver.name, tolerance, 0, reference, cap);
                   },
                   front, options.patience, std::sqrt(10.0)));
    if (!options.fixedSteps) continue;
    append(rows,
           sweepSteps(
             [&](int steps, double cap) { return runEngine(scene, solver.name, 0.0, steps, reference, cap); },
             guess, front, options.patience));
  }
  refine(scene, reference, rows);
  return rows;
}

/// The rows that are best or second at some error, or best at a tolerance.
std::vector<Row> winners(const std::vector<Row>& rows)
{
  std::vector<Row> result;
  std::vector<bool> taken(rows.size(), false);
  /// The fastest of those for which isOne(i) holds, unless it is among the winners.
  const auto take = [&](const auto& isOne) {
    std::size_t best = rows.size();
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (isOne(i) && (best == rows.size() || rows[i].seconds < rows[best].seconds)) best = i;
    if (best == rows.size() || taken[best]) return;
    taken[best] = true;
    result.push_back(rows[best]);
  };
  for (const double target : kTargets) {
    const auto errsLess = [&](std::size_t i) { return rows[i].good && rows[i].error <= target; };
    take(errsLess);
    take([&](std::size_t i) { return errsLess(i) && !taken[i]; });
    take([&](std::size_t i) { return keepsTolerance(rows[i], target); });
  }
  return result;
}

/// Median seconds, all rows in turn, so that a slow minute of the machine hits all alike.
void timeAgain(const Scene& scene, const Reference& reference, const WorkOptions& options,
               std::vector<Row>& rows)
{
  double round = 0.0;
  for (const Row& row : rows) round += row.seconds;
  const int runs = std::clamp(static_cast<int>(options.budget / std::max(round, 1e-3)), 1, options.runs);
  std::vector<std::vector<double>> seconds(rows.size());
  for (int repeat = 0; repeat < runs; ++repeat)
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (!rows[i].good) continue;
      const Row again = runAgain(scene, rows[i], reference, 1e9);
      seconds[i].push_back(again.seconds);
      rows[i].good = again.good;
      rows[i].error = again.error; // the settings of the competitors may come from the cache
      rows[i].springs = again.springs;
      rows[i].note = again.note;
    }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!seconds[i].empty()) rows[i].seconds = medianTime(seconds[i]);
    if (!rows[i].good)
      std::fprintf(stderr, "%s, %s: %s\n", scene.name.c_str(), rows[i].method.c_str(), rows[i].note.c_str());
  }
}

/// One run that may take ten times as long as the others did where they came.
Row runAuto(const Scene& scene, const Reference& reference, const WorkOptions& options, double tolerance,
            double secondsOfOthers)
{
  const double cap = std::min(5.0 + 10.0 * secondsOfOthers, 10.0 * options.patience.cap);
  return runEngine(scene, "auto", tolerance, 0, reference, cap);
}

/// Runs of auto at the tolerances between kTargets that reach an error sooner than those at kTargets do.
std::vector<Row> autoBetween(const Scene& scene, const Reference& reference, const Front& front,
                             const WorkOptions& options, const std::vector<Row>& automatic)
{
  std::vector<Row> rows;
  const double ratio = std::pow(10.0, 0.25); // as fine as the settings in candidates.csv were searched
  for (double tolerance = kTargets.front(); tolerance > 1.5 * kTargets.back(); tolerance /= ratio) {
    const auto isTarget = [&](double target) { return isSameTolerance(tolerance, target); };
    if (std::none_of(kTargets.begin(), kTargets.end(), isTarget))
      rows.push_back(runAuto(scene, reference, options, tolerance, front.seconds.back()));
  }
  std::erase_if(rows, [&](const Row& row) {
    return std::none_of(kTargets.begin(), kTargets.end(), [&](double target) {
      const auto isSooner = [&](const Row& other) {
        return other.good && other.error <= target && other.seconds <= row.seconds;
      };
      return row.good && row.error <= target && std::none_of(automatic.begin(), automatic.end(), isSooner);
    });
  });
  return rows;
}

/// auto at kTargets, and between them where that is sooner.
std::vector<Row> sweepAuto(const Scene& scene, const Reference& reference, const Front& front,
                           const WorkOptions& options)
{
  std::vector<Row> rows;
  for (std::size_t i = 0; i < kTargets.size(); ++i)
    append(rows, {runAuto(scene, reference, options, kTargets[i], front.seconds[i])});
  append(rows, autoBetween(scene, reference, front, options, rows));
  return rows;
}

/// @param candidates  of any scene; empty = search for them
std::vector<Cell> measure(const Scene& scene, const WorkOptions& options, const std::vector<Row>& candidates,
                          std::vector<Row>& all)
{
  const Reference reference = referenceOf(scene);
  std::fprintf(stderr, "%s: %d nodes, %d springs, references %.1e apart\n", scene.name.c_str(),
               static_cast<int>(scene.net.nodeCount()), static_cast<int>(scene.net.springCount()),
               reference.agreement);
  Front front;
  std::vector<Row> timed;
  if (candidates.empty()) {
    for (const auto& sweep : {sweepCompetitors, sweepOurs}) {
      const std::vector<Row> rows = sweep(scene, reference, front, options), best = winners(rows);
      all.insert(all.end(), rows.begin(), rows.end());
      timed.insert(timed.end(), best.begin(), best.end());
    }
  } else {
    std::copy_if(candidates.begin(), candidates.end(), std::back_inserter(timed),
                 [&](const Row& row) { return row.scene == scene.name && row.good && row.method != "auto"; });
    for (const Row& row : timed) front.add(row);
  }
  const std::vector<Row> automatic = sweepAuto(scene, reference, front, options);
  timed.insert(timed.end(), automatic.begin(), automatic.end());
  timeAgain(scene, reference, options, timed);
  // Medians where there are candidates, which are few; else what a picture wants: the searches' single runs.
  const std::vector<Row>& kept = candidates.empty() ? automatic : timed;
  all.insert(all.end(), kept.begin(), kept.end());
  return cellsOf(scene.name, timed, reference.agreement);
}

/// The names of their scenes, each once.
std::vector<std::string> scenesOf(const std::vector<Row>& rows)
{
  std::vector<std::string> names;
  for (const Row& row : rows)
    if (std::find(names.begin(), names.end(), row.scene) == names.end()) names.push_back(row.scene);
  return names;
}

/// At least one for each scene that is asked for. Errors: those of readCsv(); EmptyResult.
Result<std::vector<Row>> readCandidates(const WorkOptions& options)
{
  Result<std::vector<Row>> rows = readCsv(options.candidatesFile);
  if (!rows) return rows;
  const std::vector<std::string> known = scenesOf(*rows);
  const auto isUnknown = [&](const std::string& name) {
    return std::find(known.begin(), known.end(), name) == known.end();
  };
  const auto unknown = std::find_if(options.scenes.begin(), options.scenes.end(), isUnknown);
  if (!known.empty() && unknown == options.scenes.end()) return rows;
  return Error{ErrorCode::EmptyResult, options.candidatesFile + " names no candidate" +
                                         (known.empty() ? "" : " for '" + *unknown + "'") +
                                         "; without --again they are searched for"};
}

std::vector<std::string> splitAtCommas(std::string_view text)
{
  std::vector<std::string> parts;
  for (std::size_t comma = 0; comma != text.npos;) {
    comma = text.find(',');
    parts.emplace_back(text.substr(0, comma));
    if (comma != text.npos) text.remove_prefix(comma + 1);
  }
  return parts;
}

bool readOptions(const std::vector<std::string>& words, WorkOptions& options)
{
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    const auto value = [&] { return i + 1 < words.size() ? words[++i] : std::string(); };
    const auto number = [&] { return parseDouble(value()).value_or(-1.0); };
    if (word == "--all")
      options.allCompetitors = true;
    else if (word == "--no-fixed")
      options.fixedSteps = false;
    else if (word == "--retune")
      options.retune = true;
    else if (word == "--again")
      options.candidatesFile = value();
    else if (word == "--theirs") // for a look at one competitor; keeps no sweep
      options.competitors = splitAtCommas(value());
    else if (word == "--ours")
      options.solvers = splitAtCommas(value());
    else if (word == "--runs")
      options.runs = static_cast<int>(number());
    else if (word == "--budget")
      options.budget = number();
    else if (word == "--cap")
      options.patience.cap = number();
    else if (word == "--patience")
      options.patience.factor = number();
    else if (word == "--csv")
      options.csvFile = value();
    else if (word == "--table")
      options.tableFile = value();
    else if (word == "--cache")
      cacheFolder() = value();
    else if (word.starts_with("-"))
      return false;
    else
      options.scenes.push_back(word);
  }
  return options.runs > 0 && options.budget > 0.0 && options.patience.cap > 0.0 &&
         options.patience.factor > 0.0;
}

} // namespace

int runWorkPrecision(const std::vector<std::string>& words)
{
  WorkOptions options;
  if (!readOptions(words, options)) {
    std::fprintf(stderr,
                 "usage: esm_bench work_precision [SCENE[:seed=S,size=F,time=T]...] [--all] [--no-fixed]\n"
                 "         [--ours NAME,...] [--theirs NAME,...] [--retune] [--runs N] [--budget S] [--cap "
                 "S] [--patience F]\n"
                 "         [--again CSV] [--csv FILE] [--table FILE] [--cache FOLDER]\n");
    return 2;
  }
#if !defined(ESM_BENCH_SUNDIALS)
  if (options.allCompetitors) std::fprintf(stderr, "built without libsundials-dev: no CVODE, no ARKODE\n");
#endif
  std::vector<Row> all, candidates;
  if (!options.candidatesFile.empty()) {
    Result<std::vector<Row>> read = readCandidates(options);
    if (!read) {
      std::fprintf(stderr, "%s\n", read.error().detail.c_str());
      return 2;
    }
    candidates = std::move(*read);
  }
  if (options.scenes.empty()) options.scenes = scenesOf(candidates);
  if (options.scenes.empty()) options.scenes = {"tube", "uterus", "sheet", "stiff"};
  std::vector<Cell> cells;
  std::printf("%s", csvHeader());
  for (const std::string& name : options.scenes) {
    const Result<Scene> scene = makeScene(name);
    if (!scene) {
      std::fprintf(stderr, "%s\n", scene.error().detail.c_str());
      return 2;
    }
    const std::vector<Cell> more = measure(*scene, options, candidates, all);
    cells.insert(cells.end(), more.begin(), more.end());
    save(options.csvFile, csvText(all)); // after every scene: whoever interrupts has something
    save(options.tableFile, tableOf(cells));
    std::printf("\n%s\n", tableOf(more).c_str());
    std::fflush(stdout);
  }
  return 0;
}

} // namespace esm::bench
