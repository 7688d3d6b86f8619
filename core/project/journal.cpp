// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/project/journal.h"

#include "core/base/file_identity.h"
#include "core/base/file_io.h"
#include "core/base/hash.h"
#include "core/base/state_folder.h"
#include "core/project/journal_line.h"
#include "core/project/journal_reader.h"
#include "core/project/project_tree.h"

#include <algorithm>

namespace esm {

using json::Json;

namespace {

constexpr std::chrono::milliseconds kShortWait{50};    // nobody feels it, and small nets are written by then
constexpr std::chrono::seconds kPauseAfterFailure{30}; // a full disk may have got room

/// Which version of a file it is, without reading it. Rights and links may change.
std::optional<FileIdentity> stampOf(const std::filesystem::path& path)
{
  std::optional<FileIdentity> stamp = statusOf(path);
  if (stamp) stamp->changed = 0;
  return stamp;
}

/// Writes project and net beside the journal, then the line that names them.
Status writeCopy(JournalFile& file, Json tree, const SpringNet& net, const std::string& name, Json line)
{
  try {
    json::addNet(tree, net);
    if (const auto place = json::findNonFinite(tree))
      return Error{ErrorCode::Numerics, name + ": not written, " + *place + " is not a finite number"};
    const std::string bytes = json::writeCbor(tree);
    if (const Status written = file.writeBeside(name, bytes); !written) return written.error();
    line["fingerprint"] = json::fingerprintText(fingerprintOf(bytes));
    return file.writeLine(json::sealedLine(line));
  } catch (const std::exception& fault) { // memory
    return Error{ErrorCode::Internal, name + ": not written, " + fault.what()};
  }
}

/// Takes the saved file itself as what the lines begin from: cheap, and safe from what happens to it.
Status copySaved(JournalFile& file, const std::filesystem::path& path, const std::string& name, Json line)
{
  if (const Status copied = file.copyBeside(path, name); !copied) return copied.error();
  const Result<std::string> bytes = readFile(file.folder() / name);
  if (!bytes) return bytes.error();
  line["fingerprint"] = json::fingerprintText(fingerprintOf(*bytes));
  line["file"]["fingerprint"] = line["fingerprint"];
  return file.writeLine(json::sealedLine(line));
}

std::vector<Index> heldNodes(const std::vector<std::uint8_t>& fixed)
{
  std::vector<Index> nodes;
  for (std::size_t i = 0; i < fixed.size(); ++i)
    if (fixed[i] != 0) nodes.push_back(static_cast<Index>(i));
  return nodes;
}

} // namespace

std::filesystem::path recoveryFolder()
{
  return stateFolder("recovery");
}

struct Journal::Impl {
  /// What the lines so far say.
  struct Told {
    Json tree; ///< of the project without its net
    std::uint64_t netNumber = 0;
    bool netDerived = false;
    std::string copy; ///< the file that has the net
    std::vector<std::uint8_t> fixed;
    int steps = 0;
    RuleDraft draft;
    int undoIndex = 0;
    std::shared_ptr<const SpringNet> net; ///< of work that no file holds, until it is written
    int model = 0;                        ///< number of the organ
  };
  /// A net in the folder.
  struct NetCopy {
    std::uint64_t number;
    bool derived; ///< its parameters are those of some tissue: no good where the net's own are meant
    std::string name;
    std::vector<std::uint8_t> fixed;
  };

  std::filesystem::path parent, path;
  std::function<void(const Error&)> failed;
  std::optional<FileIdentity> stamp; ///< of the saved file, as long as `saved` is what it holds
  Told saved, told;
  std::vector<NetCopy> copies;
  int copyCount = 0;
  std::unique_ptr<JournalFile> file;
  std::unique_ptr<JournalFile> former; ///< that failed; goes when its follower is whole
  std::chrono::steady_clock::time_point lastTry;
  bool triedInVain = false;

  static Told toldBy(const JournalState& state)
  {
    return {json::treeWithoutNet(*state.project),
            state.netNumber,
            state.netDerived,
            {},
            state.project->net.fixed,
            state.steps,
            state.draft,
            state.undoIndex,
            {},
            state.model};
  }
  const NetCopy* copyFor(const JournalState& state) const
  {
    for (const NetCopy& copy : copies)
      if (copy.number == state.netNumber && (state.netDerived || !copy.derived)) return &copy;
    return nullptr;
  }
  std::string nextCopyName()
  {
    std::string name;
    do name = std::to_string(copyCount++) + ".esmb";
    while (std::filesystem::exists(file->folder() / name));
    return name;
  }
  void addBase(Json& line, bool isSaved) const
  {
    line["base"] = told.copy;
    line["derived"] = told.netDerived;
    line["model"] = told.model;
    line["undo"] = {{"index", told.undoIndex}, {"saved", isSaved}};
  }
  bool mayTry();
  void begin(const JournalState& now);
  void write(const JournalState& now);
  void goOn(const JournalState& saved);
  void clear();
};

bool Journal::Impl::mayTry()
{
  const bool may = !triedInVain || std::chrono::steady_clock::now() - lastTry > kPauseAfterFailure;
  if (may) lastTry = std::chrono::steady_clock::now();
  return may;
}

/// Makes the folder and says where its lines begin: at the saved file, or at what is there now.
void Journal::Impl::begin(const JournalState& now)
{
  if (!mayTry()) return;
  if (parent.empty()) {
    if (!std::exchange(triedInVain, true))
      failed({ErrorCode::FileUnwritable, "there is no state folder: neither XDG_STATE_HOME nor HOME is set"});
    return;
  }
  if (file) former = std::move(file);
  auto created = JournalFile::create(parent);
  if (!created) {
    if (!std::exchange(triedInVain, true)) failed(created.error());
    return;
  }
  file = std::move(created).value();
  const bool sayIt = !triedInVain && !former; // once is enough for one cause
  triedInVain = true;                         // until all is written
  file->onFailure([handler = failed, sayIt](const Error& error) {
    if (sayIt) handler(error);
  });
  copies.clear();
  copyCount = 0;
  Json line = {{"format", json::kJournalFormat},
               {"version", json::kJournalVersion},
               {"time", secondsNow()},
               {"name", json::validUtf8(now.project->name)}};
  if (!path.empty()) line["file"]["path"] = json::validUtf8(path.string());
  if (stamp && stampOf(path) == stamp) {
    told = saved;
    told.copy = "saved.esm";
    addBase(line, true);
    file->post(
      [from = path, name = told.copy, line](JournalFile& to) { return copySaved(to, from, name, line); });
  } else {
    const bool isAsBegun = saved.net != nullptr; // and never saved: all of it can be undone
    told = isAsBegun ? std::exchange(saved, {}) : toldBy(now);
    told.copy = nextCopyName();
    told.steps = 0, told.draft = {};
    addBase(line, isAsBegun);
    auto net = told.net ? std::move(told.net) : now.net();
    file->post([tree = told.tree, net = std::move(net), name = told.copy, line](JournalFile& to) {
      return writeCopy(to, tree, *net, name, line);
    });
  }
  copies.push_back({told.netNumber, told.netDerived, told.copy, told.fixed});
}

/// What differs from what was told, as one line.
void Journal::Impl::write(const JournalState& now)
{
  Told next = toldBy(now);
  Json line = {{"time", secondsNow()}, {"steps", now.steps}};
  if (Json patch = Json::diff(told.tree, next.tree); !patch.empty()) line["patch"] = std::move(patch);
  if (now.netDerived != told.netDerived) line["derived"] = now.netDerived;
  if (now.model != told.model) line["model"] = now.model;
  if (now.draft != told.draft) line["draft"] = json::draftOf(now.draft);

  next.copy = told.copy;
  const bool staysWithNet = now.netNumber == told.netNumber && (now.netDerived || !told.netDerived);
  const NetCopy* copy = staysWithNet ? nullptr : copyFor(now);
  const bool isNewNet = !staysWithNet && copy == nullptr;
  if (isNewNet) {
    next.copy = nextCopyName();
    copies.push_back({now.netNumber, now.netDerived, next.copy, next.fixed});
  } else if (copy != nullptr) {
    next.copy = copy->name;
  }
  const bool isSameCopy = next.copy == told.copy;
  const std::vector<std::uint8_t>& fixedBefore = isNewNet                         ? next.fixed
                                                 : copy != nullptr && !isSameCopy ? copy->fixed
                                                                                  : told.fixed;
  if (!isSameCopy) line["net"] = next.copy;
  if (next.fixed != fixedBefore) line["fixed"] = heldNodes(next.fixed);
  const bool changed = line.size() > 2 || next.steps != told.steps || next.undoIndex != told.undoIndex;
  line["undo"] = {
    {"index", now.undoIndex}, {"count", now.undoCount}, {"text", json::validUtf8(now.undoText)}};
  if (now.undoIndex < now.undoCount) line["undo"]["next"] = json::validUtf8(now.redoText);
  told = std::move(next);
  if (!changed) return;
  if (!isNewNet) return file->append(json::sealedLine(line));
  file->post([tree = told.tree, net = now.net(), name = told.copy, line](JournalFile& to) {
    return writeCopy(to, tree, *net, name, line);
  });
}

/// A save that does not hold everything: the lines go on, for there must be no moment without them.
void Journal::Impl::goOn(const JournalState& state)
{
  write(state);
  Json line = {{"time", secondsNow()}, {"steps", state.steps}};
  line["file"]["path"] = json::validUtf8(path.string());
  file->post([from = path, line](JournalFile& to) mutable -> Status {
    const Result<std::string> bytes = readFile(from);
    if (bytes) line["file"]["fingerprint"] = json::fingerprintText(fingerprintOf(*bytes));
    return to.writeLine(json::sealedLine(line));
  });
}

void Journal::Impl::clear()
{
  for (auto* each : {&file, &former}) {
    if (*each) (*each)->remove();
    each->reset();
  }
}

Journal::Journal(std::filesystem::path parent, std::function<void(const Error&)> failed)
  : m_impl(std::make_unique<Impl>())
{
  m_impl->parent = std::move(parent);
  m_impl->failed = std::move(failed);
}

Journal::~Journal() = default;

void Journal::start(const JournalState& saved, const std::filesystem::path& path)
{
  const bool goesOn = m_impl->file && !m_impl->file->hasFailed() && !saved.isSaved();
  if (!goesOn) leave();
  m_impl->path = path;
  m_impl->stamp = stampOf(path);
  m_impl->saved = Impl::toldBy(saved);
  m_impl->saved.steps = 0;
  m_impl->saved.draft = {};
  if (!m_impl->stamp && saved.steps == 0) m_impl->saved.net = saved.net();
  if (goesOn) m_impl->goOn(saved);
}

void Journal::record(const JournalState& now)
{
  Impl& it = *m_impl;
  const bool hadFile = it.file && !it.file->hasFailed();
  if (it.file && it.file->hasFailed()) it.begin(now);
  if (!it.file) {
    if (now.isSaved()) return;
    it.begin(now);
  }
  if (!it.file || it.file->hasFailed()) return;
  const std::size_t copies = it.copies.size();
  it.write(now);
  if ((!hadFile || it.copies.size() != copies) && !it.file->waitWritten(kShortWait)) return;
  if (it.file->hasFailed() || !it.file->waitWritten(std::chrono::milliseconds(0))) return;
  it.triedInVain = false;
  if (it.former) it.former->remove();
  it.former.reset();
}

void Journal::leave()
{
  m_impl->clear();
}

Status Journal::adopt(FoundJournal&& found, const RecoveredWork& work, const JournalState& now)
{
  Impl& it = *m_impl;
  it.clear();
  std::error_code code;
  if (work.isCutShort) // what cannot be read is not thrown away either
    std::filesystem::copy_file(found.folder / kJournalLines, found.folder.string() + ".damaged", code);
  auto file = JournalFile::adopt(found.folder, std::move(found.lock), work.length);
  if (!file) return file.error();
  it.file = std::move(file).value();
  it.file->onFailure(it.failed);
  it.path = work.fileChanged ? std::string() : work.path;
  it.stamp.reset();
  it.told = Impl::toldBy(now);
  it.told.copy = work.copy;
  it.copies = {{now.netNumber, now.netDerived, work.copy, {}}};
  std::filesystem::remove(found.folder / kJournalPostponed, code);
  if (work.fileChanged)
    it.file->append(json::sealedLine({{"time", secondsNow()}, {"steps", now.steps}, {"file", nullptr}}));
  return {};
}

void Journal::setPicture(std::string png)
{
  if (m_impl->file)
    m_impl->file->post(
      [bytes = std::move(png)](JournalFile& to) { return to.writeBeside(kJournalPicture, bytes); });
}

bool Journal::isKept() const noexcept
{
  return m_impl->file != nullptr;
}

bool Journal::waitWritten(std::chrono::milliseconds limit)
{
  return !m_impl->file || m_impl->file->waitWritten(limit);
}

} // namespace esm
