// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "bench/runs.h"

#include "core/base/csv_reader.h"
#include "core/base/file_io.h"
#include "core/base/text_number.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <optional>

namespace esm::bench {

double cpuSeconds()
{
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double medianTime(std::vector<double> times)
{
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

void CpuClock::pause()
{
  m_sum += cpuSeconds() - m_start;
}

void CpuClock::resume()
{
  m_start = cpuSeconds();
}

double CpuClock::seconds() const
{
  return m_sum;
}

SolverSettings settingsOf(const Scene& scene, double tolerance)
{
  SolverSettings settings;
  settings.tolerance = tolerance;
  settings.effort = 1e13;
  settings.workLimit = 0.0;
  settings.duration = scene.duration;
  return settings;
}

namespace {

/// Measures the frame off the clock. @return false to stop.
bool record(Row& row, CpuClock& clock, ErrorMeter& meter, std::size_t frame, const Eigen::Matrix3Xd& x,
            double cap)
{
  meter.add(frame, x);
  row.good = !meter.lost() && clock.seconds() < cap;
  if (!row.good) row.note = meter.lost() ? "lost" : "too slow";
  return row.good;
}

} // namespace

Row runEngine(const Scene& scene, const std::string& solver, double tolerance, int stepsPerFrame,
              const Reference& reference, double cap)
{
  Row row{
    scene.name, solver, true, stepsPerFrame > 0, stepsPerFrame > 0 ? stepsPerFrame : tolerance, 0.0, 0.0,
    0,          true,   ""};
  SolverSettings settings = settingsOf(scene, tolerance > 0.0 ? tolerance : 1e-3);
  settings.solver = solver;
  if (stepsPerFrame > 0) settings.fixedStep = 1.0 / kFrameRate / stepsPerFrame;
  ErrorMeter meter(reference);
  CpuClock clock;
  Result<Simulation> simulation = Simulation::create(scene.net, scene.loads, settings);
  if (!simulation) {
    row.good = false;
    row.note = simulation.error().detail;
  }
  bool going = row.good;
  StepReport report;
  for (long frame = 0; frame < scene.frames() && going; ++frame) {
    report.add(simulation->advance(1.0 / kFrameRate));
    clock.pause();
    going = record(row, clock, meter, static_cast<std::size_t>(frame + 1), simulation->state().position, cap);
    if (!report.good()) {
      row.good = going = false;
      row.note = simulation->why();
    }
    clock.resume();
  }
  clock.pause();
  row.seconds = clock.seconds();
  row.error = row.good ? meter.error() : std::nan("");
  row.springs = report.springsEvaluated;
  if (row.good && solver == "auto") row.note = simulation->solverName();
  return row;
}

Row runCompetitor(const Scene& scene, const MethodEntry& entry, double setting, const Reference& reference,
                  double cap)
{
  Row row{scene.name, entry.name, false, !entry.adaptive, setting, 0.0, 0.0, 0, true, ""};
  ErrorMeter meter(reference);
  Eigen::Matrix3Xd positions;
  Nodes x, v;
  CpuClock clock;
  FastNet net(scene.net, scene.loads);
  const std::unique_ptr<Method> method = entry.make();
  method->prepare(net, setting, reference.scales);
  net.start(x, v);
  bool going = true;
  for (long frame = 0; frame < scene.frames() && going; ++frame) {
    const double t0 = static_cast<double>(frame) / kFrameRate,
                 t1 = static_cast<double>(frame + 1) / kFrameRate;
    const bool changed = net.beginFrame(t0, x, v);
    const bool done = method->frame(net, t0, t1, changed, x, v);
    clock.pause();
    net.positions(x, positions);
    going = record(row, clock, meter, static_cast<std::size_t>(frame + 1), positions, cap) && done;
    if (!done) {
      row.good = false;
      row.note = "gave up";
    }
    clock.resume();
  }
  clock.pause();
  row.seconds = clock.seconds();
  row.error = row.good ? meter.error() : std::nan("");
  row.springs = net.passes() * net.springCount();
  return row;
}

Row runAgain(const Scene& scene, const Row& row, const Reference& reference, double cap)
{
  if (row.ours)
    return runEngine(scene, row.method, row.fixed ? 0.0 : row.setting,
                     row.fixed ? static_cast<int>(row.setting) : 0, reference, cap);
  for (const MethodEntry& entry : competitors())
    if (entry.name == row.method) return runCompetitor(scene, entry, row.setting, reference, cap);
  Row unknown = row;
  unknown.good = false;
  unknown.note = "no such competitor";
  return unknown;
}

const char* csvHeader()
{
  return "scene,method,ours,fixed,setting,seconds,error,springs_evaluated,note\n";
}

std::string csvLine(const Row& row)
{
  std::string note = row.note;
  for (char& letter : note)
    if (letter == ',') letter = ';';
  return "\"" + row.scene + "\"," + row.method + "," + (row.ours ? "1" : "0") + "," +
         (row.fixed ? "1" : "0") + "," + formatDouble(row.setting) + "," + formatDouble(row.seconds, 5) +
         "," + (row.good ? formatDouble(row.error, 4) : "") + "," + std::to_string(row.springs) + "," + note +
         "\n";
}

std::string csvText(const std::vector<Row>& rows)
{
  std::string text = csvHeader();
  for (const Row& row : rows) text += csvLine(row);
  return text;
}

namespace {

std::optional<Row> rowOf(const std::vector<std::string>& fields)
{
  const auto flag = [&](std::size_t i) { return fields[i] == "1"; };
  const std::optional<double> setting = parseDouble(fields[4]), seconds = parseDouble(fields[5]),
                              error = fields[6].empty() ? std::nan("") : parseDouble(fields[6]);
  const std::optional<long long> springs = parseInteger(fields[7]);
  if (!setting || !(*setting > 0.0) || !seconds || !error || !springs) return std::nullopt;
  return Row{fields[0], fields[1],          flag(2),  flag(3), *setting, *seconds, *error,
             *springs,  !fields[6].empty(), fields[8]};
}

} // namespace

Result<std::vector<Row>> readCsv(const std::filesystem::path& file)
{
  const Result<std::string> text = readFile(file);
  if (!text) return text.error();
  Result<CsvReader> table = CsvReader::open(*text, file.string());
  if (!table) return table.error();
  const auto fault = [&](const CsvRow& row) {
    return table->error(row, "not a row of esm_bench work_precision --csv");
  };
  std::string header;
  for (const std::string& cell : table->header().cells) header += (header.empty() ? "" : ",") + cell;
  if (header + '\n' != csvHeader()) return fault(table->header());
  std::vector<Row> rows;
  for (CsvRow line;;) {
    const Result<bool> more = table->next(line);
    if (!more) return more.error();
    if (!*more) return rows;
    const std::optional<Row> row = rowOf(line.cells);
    if (!row) return fault(line);
    rows.push_back(*row);
  }
}

} // namespace esm::bench
