// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/project/journal_reader.h"

#include "core/base/file_io.h"
#include "core/base/hash.h"
#include "core/project/journal_history.h"
#include "core/project/journal_line.h"
#include "core/project/project_io.h"
#include "core/project/project_tree.h"

#include <algorithm>
#include <limits>
#include <map>
#include <sys/stat.h>

namespace esm {

using json::Json;
using json::View;

namespace {

constexpr const char* kKeptPrefix = "kept-"; ///< of journals that could not be read

/// The lines of a journal up to the first that is not whole.
struct Lines {
  std::vector<Json> good;
  std::uint64_t length = 0; ///< of these [byte]
  bool isCutShort = false;  ///< more than the end of one line is damaged
};

Lines linesOf(std::string_view bytes, const std::string& origin)
{
  Lines lines;
  while (lines.length < bytes.size()) {
    const std::string_view rest = bytes.substr(lines.length);
    const std::size_t end = rest.find('\n');
    std::optional<Json> line;
    if (end != std::string_view::npos) line = json::openedLine(rest.substr(0, end), origin);
    if (!line) { // the process ended while it wrote its last line; anything else is damage
      lines.isCutShort = end != std::string_view::npos;
      break;
    }
    lines.good.push_back(std::move(*line));
    lines.length += end + 1;
  }
  return lines;
}

Error faultOf(const std::filesystem::path& folder, const std::string& what,
              ErrorCode code = ErrorCode::BadFormat)
{
  return {code, folder.string() + ": " + what};
}

/// Lines of which the first is a header that this program knows.
Result<Lines> readLines(const std::filesystem::path& folder)
{
  const Result<std::string> bytes = readFile(folder / kJournalLines);
  if (!bytes) return bytes.error();
  Lines lines = linesOf(*bytes, (folder / kJournalLines).string());
  if (lines.good.empty()) return faultOf(folder, "is damaged from its first line on");
  json::Faults faults{folder.string(), {}};
  const View header(lines.good.front(), faults);
  constexpr const char* kFormats[] = {json::kJournalFormat};
  header["format"].choice(kFormats);
  if (header["version"].integer(1, 1000000) > json::kJournalVersion)
    return faultOf(folder, "was written by a newer version of this program", ErrorCode::NewerVersion);
  if (faults.first) return *faults.first;
  return lines;
}

/// What all lines say together.
struct Replay {
  Replay(const std::filesystem::path& where, json::Faults& into) : folder(where), faults(into) {}

  const std::filesystem::path& folder;
  json::Faults& faults;
  std::string path, fileFingerprint;
  std::filesystem::path home;                      ///< what names in the saved file are relative to
  std::map<std::string, std::string> fingerprints; ///< of the files beside the journal
  std::string base, copy;
  bool derived = false;
  std::optional<std::vector<Index>> fixed;
  int steps = 0, model = 0, fileModel = 0;
  RuleDraft draft;
  std::int64_t time = 0;
  std::string name;

  void take(const Json& json);
};

void Replay::take(const Json& json)
{
  const View line(json, faults);
  if (line.has("file") && !json["file"].is_null()) {
    path = line["file"]["path"].text();
    if (line.has("base")) home = std::filesystem::path(path).parent_path();
    if (line["file"].has("fingerprint")) fileFingerprint = line["file"]["fingerprint"].text();
  } else if (line.has("file")) {
    path.clear();
  }
  if (line.has("base")) copy = base = line["base"].text();
  if (line.has("net")) {
    copy = line["net"].text();
    fixed.reset();
  }
  if (line.has("fingerprint")) fingerprints[copy] = line["fingerprint"].text();
  if (line.has("derived")) derived = line["derived"].boolean();
  if (line.has("fixed")) fixed = line["fixed"].indexList(std::numeric_limits<Index>::max());
  if (line.has("model")) model = line["model"].integer(0, std::numeric_limits<Index>::max());
  if (line.has("base") || line.has("file")) fileModel = model; // it was saved
  if (line.has("steps")) steps = line["steps"].integer(0, std::numeric_limits<Index>::max());
  if (line.has("draft")) draft = json["draft"].is_null() ? RuleDraft() : json::readDraft(line["draft"]);
  if (line.has("name")) name = line["name"].text();
  time = static_cast<std::int64_t>(line["time"].number());
  if (line.has("patch"))
    for (const Json& step : json["patch"])
      if (step.is_object() && step.value("path", Json()) == "/name" && step.contains("value") &&
          step["value"].is_string())
        name = step["value"].get<std::string>();
}

Result<Project> projectBeside(const Replay& replay, const std::string& name)
{
  const std::filesystem::path path = replay.folder / name;
  if (name.empty() || path.filename() != name || name.find('/') != std::string::npos)
    return faultOf(replay.folder, "names a file outside of its folder");
  const Result<std::string> bytes = readFile(path);
  if (!bytes) return bytes.error();
  const auto known = replay.fingerprints.find(name);
  if (known == replay.fingerprints.end() || known->second != json::fingerprintText(fingerprintOf(*bytes)))
    return faultOf(replay.folder, name + " is not as it was written");
  Result<Project> project = parseProject(*bytes, path.string());
  if (!project) return project.error();
  if (!replay.home.empty()) project->source = withAbsoluteNames(std::move(project->source), replay.home);
  return project;
}

Result<Json> treeBeside(const Replay& replay, const std::string& name)
{
  const Result<Project> project = projectBeside(replay, name);
  if (!project) return project.error();
  return json::treeOf(*project);
}

Json withoutNet(const Json& tree)
{
  Json rest = Json::object();
  for (const auto& [key, value] : tree.items())
    if (key != "geometry" && key != "net") rest[key] = value;
  return rest;
}

/// All that the lines made of the base without its net. Where that cannot be told, nothing.
RecoveredHistory historyOf(const Lines& lines, const Replay& replay, Json base)
{
  const Json& head = lines.good.front();
  std::map<std::string, std::shared_ptr<const SpringNet>> nets;
  const auto netOf = [&](const std::string& name) {
    auto& net = nets[name];
    if (net) return net;
    if (Result<Project> beside = projectBeside(replay, name))
      net = std::make_shared<const SpringNet>(std::move(beside->net));
    return net;
  };
  try {
    const auto undo = head.find("undo");
    if (undo == head.end()) return {};
    json::JournalHistory history(std::move(base), replay.base, head.value("derived", false),
                                 head.value("model", 0), undo->at("index").get<int>(),
                                 undo->at("saved").get<bool>());
    for (std::size_t i = 1; i < lines.good.size(); ++i) history.take(lines.good[i]);
    return history.states(netOf, replay.folder.string());
  } catch (const std::exception&) {
    return {};
  }
}

/// The project's tree after all lines of the base's.
Result<Json> treeOfLines(const Lines& lines, const Replay& replay, Json base)
{
  Result<Json> tree = std::move(base);
  if (replay.copy != replay.base) {
    Result<Json> other = treeBeside(replay, replay.copy);
    if (!other) return other.error();
    for (const char* key : {"geometry", "net"}) (*tree)[key] = std::move((*other)[key]);
  }
  try {
    for (const Json& line : lines.good)
      if (const auto patch = line.find("patch"); patch != line.end()) tree->patch_inplace(*patch);
  } catch (const std::exception& fault) {
    return faultOf(replay.folder, std::string("does not fit its own beginning (") + fault.what() + ")");
  }
  return tree;
}

Status holdNodes(SpringNet& net, const std::vector<Index>& nodes, const std::filesystem::path& folder)
{
  std::fill(net.fixed.begin(), net.fixed.end(), std::uint8_t{0});
  for (const Index node : nodes) {
    if (node < 0 || node >= net.nodeCount()) return faultOf(folder, "holds nodes that the net does not have");
    net.fixed[static_cast<std::size_t>(node)] = 1;
  }
  return {};
}

bool isOurs(const std::filesystem::path& folder)
{
  struct stat info = {};
  return ::lstat(folder.c_str(), &info) == 0 && S_ISDIR(info.st_mode);
}

void removeFolder(const std::filesystem::path& folder)
{
  std::error_code code;
  const std::filesystem::path gone = folder.parent_path() / (".gone-" + folder.filename().string());
  std::filesystem::rename(folder, gone, code);
  std::filesystem::remove_all(code ? folder : gone, code);
}

/// Leftovers of a removal or a beginning that was cut short.
void sweepHidden(const std::filesystem::path& folder)
{
  constexpr auto kAge = std::chrono::hours(1); // a window may just be making it
  std::error_code code;
  const auto written = std::filesystem::last_write_time(folder, code);
  if (code || std::filesystem::file_time_type::clock::now() - written < kAge) return;
  const JournalLock lock = JournalLock::take(folder);
  if (lock) std::filesystem::remove_all(folder, code);
}

/// What can be said of a journal without reading the files beside it. Nothing if it holds nothing.
std::optional<FoundJournal> look(const std::filesystem::path& folder)
{
  FoundJournal found;
  found.folder = folder;
  found.lock = JournalLock::take(folder);
  if (!found.lock) return {};
  std::error_code code;
  found.postponed = std::filesystem::exists(folder / kJournalPostponed, code);
  const auto size = std::filesystem::file_size(folder / kJournalLines, code);
  if (code || size == 0) { // ended before its first line
    removeFolder(folder);
    return {};
  }
  const Result<Lines> lines = readLines(folder);
  if (!lines) {
    // A first line without an end is no damage: nothing was lost but the step under way.
    const Result<std::string> bytes = readFile(folder / kJournalLines);
    if (bytes && bytes->find('\n') == std::string::npos) {
      removeFolder(folder);
      return {};
    }
    found.fault = lines.error();
    return found;
  }
  json::Faults faults{folder.string(), {}};
  Replay replay(folder, faults);
  for (const Json& line : lines->good) replay.take(line);
  if (faults.first) found.fault = faults.first;
  found.name = replay.name;
  found.path = replay.path;
  found.time = replay.time;
  found.steps = replay.steps;
  found.hasDraft = !replay.draft.isEmpty();
  if (!found.fault && !lines->isCutShort && found.steps == 0 && !found.hasDraft) {
    removeFolder(folder);
    return {};
  }
  return found;
}

} // namespace

std::vector<FoundJournal> findJournals(const std::filesystem::path& parent)
{
  std::vector<FoundJournal> found;
  std::error_code code;
  std::vector<std::filesystem::path> folders;
  for (std::filesystem::directory_iterator it(parent, code), end; !code && it != end; it.increment(code))
    if (isOurs(it->path())) folders.push_back(it->path());
  for (const std::filesystem::path& folder : folders) {
    const std::string name = folder.filename().string();
    if (name.starts_with('.'))
      sweepHidden(folder);
    else if (!name.starts_with(kKeptPrefix))
      if (auto journal = look(folder)) found.push_back(std::move(*journal));
  }
  std::sort(found.begin(), found.end(),
            [](const FoundJournal& a, const FoundJournal& b) { return a.time > b.time; });
  return found;
}

Result<RecoveredWork> readJournal(const FoundJournal& found)
{
  const Result<Lines> lines = readLines(found.folder);
  if (!lines) return lines.error();
  json::Faults faults{found.folder.string(), {}};
  Replay replay(found.folder, faults);
  for (const Json& line : lines->good) replay.take(line);
  if (faults.first) return *faults.first;
  Result<Json> base = treeBeside(replay, replay.base);
  if (!base) return base.error();
  Json rest = withoutNet(*base);
  const Result<Json> tree = treeOfLines(*lines, replay, std::move(base).value());
  if (!tree) return tree.error();
  Result<Project> project = json::readProject(*tree, found.folder.string());
  if (!project) return project.error();

  RecoveredWork work;
  work.project = std::move(project).value();
  if (replay.fixed)
    if (const Status held = holdNodes(work.project.net, *replay.fixed, found.folder); !held)
      return held.error();
  if (replay.derived && work.project.net.nodeCount() > 0)
    if (auto applied = applyTissue(work.project.tissue, work.project.net); !applied) return applied.error();
  work.path = replay.path;
  if (!replay.path.empty()) {
    const Result<std::string> now = readFile(replay.path);
    work.fileChanged = !now || json::fingerprintText(fingerprintOf(*now)) != replay.fileFingerprint;
  }
  work.netDerived = replay.derived;
  work.copy = replay.copy;
  work.model = replay.model;
  work.fileModel = replay.fileModel;
  work.steps = replay.steps;
  work.draft = replay.draft;
  work.isCutShort = lines->isCutShort;
  work.length = lines->length;
  work.history = historyOf(*lines, replay, std::move(rest));
  return work;
}

void discardJournal(FoundJournal& found)
{
  removeFolder(found.folder);
  found.lock = JournalLock();
}

void postponeJournal(const FoundJournal& found)
{
  (void)writeFileAtomically(found.folder / kJournalPostponed, ""); // else it is offered once more: no harm
}

std::filesystem::path setJournalAside(FoundJournal& found)
{
  const std::filesystem::path kept =
    found.folder.parent_path() / (kKeptPrefix + found.folder.filename().string());
  std::error_code code;
  std::filesystem::rename(found.folder, kept, code);
  found.lock = JournalLock();
  return code ? found.folder : kept;
}

} // namespace esm
