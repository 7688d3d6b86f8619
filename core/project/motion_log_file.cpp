// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/project/motion_log_file.h"

#include "core/base/file_io.h"
#include "core/base/text_number.h"
#include "core/base/version.h"
#include "core/project/journal_line.h"
#include "core/project/net_json.h"
#include "core/project/project_io.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <fcntl.h>
#include <limits>
#include <optional>
#include <sys/file.h>
#include <unistd.h>
#include <utility>

namespace esm {

using json::Json;
using json::Range;
using json::View;

namespace {

constexpr const char* kLogFormat = "esm-motion-log";
constexpr int kLogVersion = 1;
constexpr Index kMostIndex = std::numeric_limits<Index>::max();

/// A zero in brackets would be the null of a key as well.
View item(const View& list, std::size_t place)
{
  return list[place];
}

Json vectorOf(const Eigen::Vector3d& vector)
{
  return {vector.x(), vector.y(), vector.z()};
}

// === Settings
Json solverSettingsOf(const SolverSettings& settings)
{
  return {{"solver", settings.solver},           {"tolerance", settings.tolerance},
          {"fixed_step", settings.fixedStep},    {"threads", settings.threads},
          {"effort", settings.effort},           {"work_limit", settings.workLimit},
          {"keeps_time", settings.keepsTime},    {"duration", settings.duration},
          {"skip_resting", settings.skipResting}};
}

SolverSettings readSolverSettings(const View& object)
{
  object.expectKeys({"solver", "tolerance", "fixed_step", "threads", "effort", "work_limit", "keeps_time",
                     "duration", "skip_resting"});
  SolverSettings settings;
  settings.solver = object["solver"].text();
  settings.tolerance = object["tolerance"].number(Range::Positive);
  settings.fixedStep = object["fixed_step"].number(Range::NotNegative);
  settings.threads = object["threads"].integer(1, 1024);
  settings.effort = object["effort"].number(Range::Positive);
  settings.workLimit = object["work_limit"].number(Range::NotNegative);
  settings.keepsTime = object["keeps_time"].boolean();
  settings.duration = object["duration"].number(Range::NotNegative);
  settings.skipResting = object["skip_resting"].boolean();
  return settings;
}

// === Entries
Json patchOf(const ParameterPatch& patch)
{
  Json springs = Json::array(), nodes = Json::array(), anchors = Json::array();
  for (const ParameterPatch::Spring& each : patch.springs)
    springs.push_back(
      {each.spring, static_cast<int>(each.law), each.stiffness, each.viscosity, each.lawParameter});
  for (const ParameterPatch::Node& each : patch.nodes)
    nodes.push_back({each.node, each.mass, each.massDamping});
  for (const ParameterPatch::Anchor& each : patch.anchors)
    anchors.push_back({each.anchor, each.stiffness, each.viscosity});
  Json object = {
    {"springs", springs}, {"nodes", nodes}, {"anchors", anchors}, {"bulk_moduli", patch.bulkModuli}};
  if (patch.anchorSet) object["anchor_set"] = json::anchorsOf(*patch.anchorSet);
  return object;
}

ParameterPatch readPatch(const View& object, Index nodes)
{
  object.expectKeys({"springs", "nodes", "anchors", "bulk_moduli"}, {"anchor_set"});
  ParameterPatch patch;
  const View springs = object["springs"], nodeList = object["nodes"], anchors = object["anchors"];
  for (std::size_t i = 0; i < springs.size(); ++i) {
    const View each = springs[i];
    each.expectSize(5);
    patch.springs.push_back(
      {item(each, 0).integer(0, kMostIndex),
       SpringLaw(item(each, 1).integer(0, static_cast<Index>(std::size(json::kLawNames)) - 1)),
       item(each, 2).number(), item(each, 3).number(), item(each, 4).number()});
  }
  for (std::size_t i = 0; i < nodeList.size(); ++i) {
    const View each = nodeList[i];
    each.expectSize(3);
    patch.nodes.push_back(
      {item(each, 0).integer(0, kMostIndex), item(each, 1).number(), item(each, 2).number()});
  }
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    const View each = anchors[i];
    each.expectSize(3);
    patch.anchors.push_back(
      {item(each, 0).integer(0, kMostIndex), item(each, 1).number(), item(each, 2).number()});
  }
  patch.bulkModuli = object["bulk_moduli"].numberList();
  if (object.has("anchor_set")) {
    SpringNet held;
    held.restPosition.setZero(3, nodes);
    json::readAnchors(object["anchor_set"], held);
    patch.anchorSet = std::move(held.anchors);
  }
  return patch;
}

Json advanceOf(const logged::Advance& advance)
{
  Json parts = Json::array();
  for (const logged::Advance::Part& part : advance.parts) {
    Json stretches = Json::array();
    for (const Stretch& each : part.stretches)
      stretches.push_back({each.begin, each.end, each.steps, each.method});
    Json object = {{"moved", part.isMoved}, {"stretches", stretches}};
    if (part.grants != logged::Advance::kAll) object["grants"] = part.grants;
    parts.push_back(std::move(object));
  }
  return {{"interval", advance.interval}, {"steps", advance.steps},
          {"asked", advance.isAsked},     {"parts", parts},
          {"time", advance.time},         {"state", json::fingerprintText(advance.state)}};
}

std::uint64_t readHash(const View& value)
{
  const std::string text = value.text();
  std::uint64_t hash = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), hash, 16);
  if (error != std::errc() || end != text.data() + text.size() || text.size() != 16)
    value.mustBe("16 hexadecimal digits");
  return hash;
}

std::int64_t readCount(const View& value)
{
  constexpr double kMost = 9e15; // whole numbers that a double holds
  const double number = value.number(Range::NotNegative);
  if (number > kMost || number != std::floor(number)) value.mustBe("a whole number");
  return number <= kMost ? static_cast<std::int64_t>(number) : 0;
}

logged::Advance readAdvance(const View& object)
{
  object.expectKeys({"interval", "steps", "asked", "parts", "time", "state"});
  logged::Advance advance;
  advance.interval = object["interval"].number(Range::Positive);
  advance.steps = readCount(object["steps"]);
  advance.isAsked = object["asked"].boolean();
  advance.time = object["time"].number(Range::NotNegative);
  advance.state = readHash(object["state"]);
  const View parts = object["parts"];
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const View each = parts[k];
    each.expectKeys({"moved", "stretches"}, {"grants"});
    logged::Advance::Part part;
    part.isMoved = each["moved"].boolean();
    if (each.has("grants")) part.grants = readCount(each["grants"]);
    const View stretches = each["stretches"];
    for (std::size_t i = 0; i < stretches.size(); ++i) {
      const View stretch = stretches[i];
      stretch.expectSize(4);
      part.stretches.push_back({item(stretch, 0).number(Range::NotNegative),
                                item(stretch, 1).number(Range::NotNegative), readCount(item(stretch, 2)),
                                item(stretch, 3).text()});
    }
    advance.parts.push_back(std::move(part));
  }
  return advance;
}

struct Writing {
  Json operator()(const logged::Tools& tools) const
  {
    Json list = Json::array();
    for (const ToolSpring& tool : tools.springs)
      list.push_back({{"node", tool.node},
                      {"target", vectorOf(tool.target)},
                      {"velocity", vectorOf(tool.targetVelocity)},
                      {"stiffness", tool.stiffness},
                      {"viscosity", tool.viscosity},
                      {"moves", tool.moves}});
    return {{"tools", list}};
  }
  Json operator()(const logged::Patch& patch) const { return {{"patch", patchOf(patch.patch)}}; }
  Json operator()(const logged::Net& net) const
  {
    return {{"geometry", json::geometryOf(net.net)}, {"net", json::netOf(net.net)}};
  }
  Json operator()(const logged::Accuracy& wanted) const
  {
    return {{"tolerance", wanted.tolerance}, {"effort", wanted.effort}};
  }
  Json operator()(const logged::Reset&) const { return {{"reset", true}}; }
  Json operator()(const logged::GrowthWatch&) const { return {{"growth_watch", true}}; }
  Json operator()(const logged::Advance& advance) const { return {{"advance", advanceOf(advance)}}; }
};

LogEntry readEntry(const View& object, Index nodes)
{
  if (object.has("advance")) return readAdvance(object["advance"]);
  if (object.has("tools")) {
    logged::Tools tools;
    const View list = object["tools"];
    for (std::size_t i = 0; i < list.size(); ++i) {
      const View each = list[i];
      each.expectKeys({"node", "target", "velocity", "stiffness", "viscosity", "moves"});
      tools.springs.push_back({each["node"].integer(0, nodes - 1), each["target"].vector(),
                               each["velocity"].vector(), each["stiffness"].number(Range::NotNegative),
                               each["viscosity"].number(Range::NotNegative), each["moves"].boolean()});
    }
    return tools;
  }
  if (object.has("patch")) return logged::Patch{readPatch(object["patch"], nodes)};
  if (object.has("net")) return logged::Net{json::readNet(object["geometry"], object["net"])};
  if (object.has("tolerance"))
    return logged::Accuracy{object["tolerance"].number(Range::Positive),
                            object["effort"].number(Range::Positive)};
  if (object.has("growth_watch")) return logged::GrowthWatch{};
  if (!object.has("reset")) object.complain("is no entry that this version knows");
  return logged::Reset{};
}

/// The first call, counted from 1, that somebody has given so long an interval that repeating it might not end; 0 if
/// there is none. It is out of proportion to what any call has moved on by, and to what the others asked for: where a
/// budget or a fault had ended a call early, it had asked for no more than these.
std::size_t endlessCall(const MotionLog& log)
{
  constexpr double kProportion = 10.0, kLongestUnmoved = 1000.0; // [1], [s]
  double longest = 0.0, nextLongest = 0.0, moved = 0.0, time = 0.0;
  for (const LogEntry& entry : log) {
    if (std::holds_alternative<logged::Reset>(entry)) time = 0.0;
    const auto* advance = std::get_if<logged::Advance>(&entry);
    if (!advance) continue;
    nextLongest = std::max(nextLongest, std::min(longest, advance->interval));
    longest = std::max(longest, advance->interval);
    moved = std::max(moved, advance->time - time);
    time = advance->time;
  }
  for (std::size_t i = 0; i < log.size(); ++i) {
    const auto* advance = std::get_if<logged::Advance>(&log[i]);
    if (!advance) continue;
    const double others = advance->interval < longest ? longest : nextLongest;
    const double unmoved = others > 0.0 ? std::min(kProportion * others, kLongestUnmoved) : kLongestUnmoved;
    if (advance->interval > std::max(unmoved, kProportion * moved)) return i + 1;
  }
  return 0;
}

/// What there is of a file, piece by piece.
class Pieces {
public:
  explicit Pieces(std::string_view bytes) : m_rest(bytes) {}
  /// The next line, without its end; nothing if it has none.
  std::optional<std::string_view> next()
  {
    const std::size_t end = m_rest.find('\n');
    if (end == m_rest.npos) return std::nullopt;
    ++m_number;
    return take(end);
  }
  /// As many bytes and the end of their line.
  std::optional<std::string_view> block(std::size_t size)
  {
    if (m_rest.size() <= size || m_rest[size] != '\n') return std::nullopt;
    return take(size);
  }
  int number() const noexcept { return m_number; } ///< of the line that came last, blocks not counted

private:
  std::string_view take(std::size_t size)
  {
    const std::string_view piece = m_rest.substr(0, size);
    m_rest.remove_prefix(size + 1);
    return piece;
  }
  std::string_view m_rest;
  int m_number = 0;
};

} // namespace

Result<MotionLogWriter> MotionLogWriter::create(const std::filesystem::path& path, const Project& project,
                                                const SolverSettings& settings)
{
  if (const std::string kind = specialFileKind(path); !kind.empty())
    return Error{ErrorCode::FileUnwritable,
                 path.string() + ": is " + kind + "; a log needs a file of its own"};
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
  if (file < 0) return fileUnwritable(path, errno);
  MotionLogWriter writer(path, file);
  if (::flock(file, LOCK_EX | LOCK_NB) != 0)
    return Error{ErrorCode::FileUnwritable, path.string() + ": another run is being written to it"};
  if (::ftruncate(file, 0) != 0) return fileUnwritable(path, errno);
  const std::string text = toJson(project);
  const Json head = {{"format", kLogFormat},
                     {"version", kLogVersion},
                     {"program", version()},
                     {"settings", solverSettingsOf(settings)},
                     {"project_bytes", text.size()}};
  if (!writeAll(file, json::writeLine(head) + "\n" + text + "\n")) return fileUnwritable(path, errno);
  return writer;
}

MotionLogWriter::MotionLogWriter(MotionLogWriter&& other) noexcept
  : m_path(std::move(other.m_path)), m_file(std::exchange(other.m_file, -1))
{}

MotionLogWriter::~MotionLogWriter()
{
  if (m_file >= 0) ::close(m_file);
}

Status MotionLogWriter::add(const MotionLog& entries)
{
  std::string text;
  for (const LogEntry& entry : entries) text += json::writeLine(std::visit(Writing{}, entry)) + "\n";
  if (!writeAll(m_file, text)) return fileUnwritable(m_path, errno);
  return {};
}

Status MotionLogWriter::finish()
{
  const Json end = {{"end", true}};
  if (!writeAll(m_file, json::writeLine(end) + "\n")) return fileUnwritable(m_path, errno);
  return {};
}

Result<RecordedRun> readMotionLog(const std::filesystem::path& path)
{
  const std::string origin = path.string();
  try {
    const Result<std::string> bytes = readFile(path);
    if (!bytes) return bytes.error();
    const auto fault = [&](const std::string& what) {
      return Error{ErrorCode::BadFormat, origin + ": " + what};
    };
    Pieces lines(*bytes);
    const std::optional<std::string_view> first = lines.next();
    const std::string noLog = "is no log of a run, which `esm simulate --log` writes";
    if (!first) return fault(noLog);
    const Result<Json> head = json::parseJson(*first, origin);
    if (!head || !head->is_object() || !head->contains("format") || (*head)["format"] != kLogFormat)
      return fault(noLog);
    json::Faults faults{origin, {}};
    const View root(*head, faults);
    root.expectKeys({"format", "version", "program", "settings", "project_bytes"});
    if (root["version"].integer(1, kMostIndex) > kLogVersion)
      return Error{ErrorCode::NewerVersion, origin + ": was written by a newer version (" +
                                              root["program"].text() + "); update this program"};
    RecordedRun run;
    run.settings = readSolverSettings(root["settings"]);
    const std::int64_t size = readCount(root["project_bytes"]);
    if (faults.first) return *faults.first;
    const auto block = lines.block(static_cast<std::size_t>(size));
    if (!block) return fault("ends within its project: the log is cut off, and there is nothing to replay");
    Result<Project> project = parseProject(*block, origin + " (its project)");
    if (!project) return project.error();
    run.project = std::move(*project);
    const Index nodes = run.project.net.nodeCount();
    bool isEnded = false;
    while (!isEnded) {
      const std::optional<std::string_view> line = lines.next();
      if (!line) break;
      const std::string where = origin + ", entry " + std::to_string(lines.number() - 1);
      const Result<Json> entry = json::parseJson(*line, where);
      if (!entry) return entry.error();
      json::Faults wrong{where, {}};
      const View object(*entry, wrong);
      isEnded = object.has("end");
      if (!isEnded) run.log.push_back(readEntry(object, nodes));
      if (wrong.first) return *wrong.first;
    }
    if (const std::size_t endless = endlessCall(run.log); endless > 0)
      return Error{
        ErrorCode::InvalidValue,
        origin + ", entry " + std::to_string(endless) + ": its interval of " +
          formatDouble(std::get<logged::Advance>(run.log[endless - 1]).interval, 6) +
          " s is more than ten times what the calls of the run have moved on by: the log has been edited, "
          "and repeating it might not end"};
    if (!isEnded) run.cut = origin + ": has no end; the run was killed, or lines are missing";
    return run;
  } catch (...) {
    return json::thrownWhileReading(origin);
  }
}

} // namespace esm
