// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/file_io.h"
#include "core/base/hash.h"
#include "core/project/journal_reader.h"
#include "core/project/project_io.h"
#include "tests/core/project/random_project.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <random>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

using namespace esm;
namespace fs = std::filesystem;

namespace {

/// A line with its sum; `open` is the object without its last brace.
std::string sealed(const std::string& open)
{
  char sum[17];
  std::snprintf(sum, sizeof sum, "%016llx", static_cast<unsigned long long>(fingerprintOf(open)));
  return open + ", \"sum\": \"" + sum + "\"}\n";
}

struct JournalTest : testing::Test {
  fs::path folder, parent;
  Project project;
  std::uint64_t netNumber = 0;
  bool derived = false;
  RuleDraft draft;
  int failures = 0;
  std::unique_ptr<Journal> journal;

  void SetUp() override
  {
    std::string name = (fs::temp_directory_path() / "esm-journal-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder = name;
    parent = folder / "state" / "recovery";
    project = test::randomProject(7);
    journal = makeJournal();
  }
  void TearDown() override
  {
    journal.reset();
    ::chmod(folder.c_str(), 0700);
    fs::remove_all(folder);
  }
  std::unique_ptr<Journal> makeJournal()
  {
    return std::make_unique<Journal>(parent, [this](const Error&) { ++failures; });
  }
  JournalState state(int steps)
  {
    JournalState now;
    now.project = &project;
    now.netNumber = netNumber;
    now.netDerived = derived;
    now.net = [this] { return std::make_shared<const SpringNet>(project.net); };
    now.steps = steps;
    now.draft = draft;
    return now;
  }
  /// As a process that is killed: the folder and its lines stay, the lock goes.
  void die() { journal.reset(); }
  RecoveredWork recovered()
  {
    auto found = findJournals(parent);
    EXPECT_EQ(found.size(), 1u);
    if (found.size() != 1) return {};
    auto work = readJournal(found[0]);
    EXPECT_TRUE(work) << (work ? "" : work.error().detail);
    return work ? std::move(work).value() : RecoveredWork();
  }
  fs::path linesFile() const
  {
    for (const auto& entry : fs::directory_iterator(parent))
      if (entry.is_directory()) return entry.path() / kJournalLines;
    return {};
  }
};

} // namespace

// The states between the steps come back too, those that were undone included, and nothing of a step that another
// one has replaced.
TEST_F(JournalTest, StepsComeBackWithTheStatesBetweenThem)
{
  const std::string begun = toJson(project);
  journal->start(state(0), {});
  const auto record = [&](int index, int count, const char* text, const char* next) {
    JournalState now = state(index);
    now.undoIndex = index;
    now.undoCount = count;
    now.undoText = text;
    now.redoText = next;
    journal->record(now);
  };
  project.name = "dropped";
  record(1, 1, "dropped", "");
  project.name = "first";
  record(1, 1, "rename", ""); // undone, and another one done
  const std::string first = toJson(project);
  project.loads.gravity = {1.0, 2.0, 3.0};
  record(2, 2, "gravity", "");
  const std::string second = toJson(project);
  project.net.fixed[0] ^= 1;
  record(3, 3, "hold", "");
  const std::string third = toJson(project);
  project.net.fixed[0] ^= 1;
  record(2, 3, "gravity", "hold");
  ASSERT_TRUE(journal->waitWritten(std::chrono::seconds(10)));
  die();

  const RecoveredHistory history = recovered().history;
  ASSERT_EQ(history.states.size(), 4u);
  EXPECT_EQ(history.first, 0);
  EXPECT_EQ(history.present, 2);
  EXPECT_EQ(history.saved, 0);
  const std::string texts[] = {"", "rename", "gravity", "hold"}, due[] = {begun, first, second, third};
  for (std::size_t i = 0; i < 4; ++i) {
    Project there = history.states[i].project;
    there.net = *history.states[i].net;
    EXPECT_EQ(toJson(there), due[i]) << i;
    EXPECT_EQ(history.states[i].text, texts[i]);
  }
  EXPECT_TRUE(history.states[1].netStays);
  EXPECT_FALSE(history.states[2].netStays) << "other loads move it otherwise";
}

// What was never saved comes back byte for byte, whichever part of the project the steps changed.
TEST_F(JournalTest, UnsavedWorkComesBackByteForByte)
{
  journal->start(state(0), {});
  EXPECT_FALSE(journal->isKept()) << "looking at a project leaves nothing behind";
  std::mt19937 random(8);
  for (int step = 1; step <= 12; ++step) {
    const Project other = test::randomProject(100u + static_cast<unsigned>(step));
    switch (step % 6) {
    case 0:
      project.name = other.name + "\nÄ\"\\";
      break;
    case 1:
      project.loads.gravity = Eigen::Vector3d(0.1 * step, -0.0, 1.0 / 3.0);
      break;
    case 2:
      project.simulation.solver.tolerance *= 0.7;
      break;
    case 3:
      project.tissue.thickness *= 1.1;
      break;
    case 4:
      for (std::uint8_t& fixed : project.net.fixed) fixed = random() % 3 == 0 ? 1 : 0;
      break;
    case 5:
      project = other;
      ++netNumber;
      break;
    }
    journal->record(state(step));
  }
  die();
  const RecoveredWork work = recovered();
  EXPECT_EQ(toJson(work.project), toJson(project));
  EXPECT_EQ(work.steps, 12);
  EXPECT_TRUE(work.path.empty());
  EXPECT_FALSE(work.isCutShort);
}

// Of a saved project the journal keeps the saved file and what followed; the file may change or go.
TEST_F(JournalTest, SavedFileIsTheBeginningAndMayChange)
{
  project.source = {};
  const fs::path path = folder / "organ.esm";
  ASSERT_TRUE(saveProject(project, path));
  journal->start(state(0), path);
  project.tissue.density = 1234.5;
  journal->record(state(1));
  die();
  RecoveredWork work = recovered();
  EXPECT_EQ(toJson(work.project), toJson(project));
  EXPECT_EQ(work.path, path.string());
  EXPECT_FALSE(work.fileChanged);

  ASSERT_TRUE(writeFileAtomically(path, "somebody else's"));
  work = recovered();
  EXPECT_EQ(toJson(work.project), toJson(project));
  EXPECT_TRUE(work.fileChanged);
  fs::remove(path);
  EXPECT_TRUE(recovered().fileChanged);
}

// A file that changed under the window before the first step is no beginning: the whole state is kept.
TEST_F(JournalTest, FileThatChangedBeforeTheFirstStepIsNotTheBeginning)
{
  project.source = {};
  const fs::path path = folder / "organ.esm";
  ASSERT_TRUE(saveProject(project, path));
  journal->start(state(0), path);
  ASSERT_TRUE(writeFileAtomically(path, "somebody else's"));
  project.tissue.density = 1234.5;
  journal->record(state(1));
  die();
  const RecoveredWork work = recovered();
  EXPECT_EQ(toJson(work.project), toJson(project));
  EXPECT_TRUE(work.fileChanged);
}

// Undo goes back to a net that the journal has already: it is named, not written again.
TEST_F(JournalTest, FormerNetsAreWrittenOnce)
{
  journal->start(state(0), {});
  const Project first = project;
  const Project second = test::randomProject(9);
  for (int step = 1; step <= 7; ++step) {
    project = step % 2 == 0 ? second : first;
    netNumber = step % 2 == 0 ? 1 : 0;
    journal->record(state(step));
  }
  ASSERT_TRUE(journal->waitWritten(std::chrono::seconds(10)));
  int copies = 0;
  for (const auto& entry : fs::directory_iterator(linesFile().parent_path()))
    copies += entry.path().extension() == ".esmb" ? 1 : 0;
  EXPECT_EQ(copies, 2);
  die();
  EXPECT_EQ(toJson(recovered().project), toJson(first));
}

// A text that is no rule yet is unsaved work of its own.
TEST_F(JournalTest, RuleBeingWrittenIsKept)
{
  journal->start(state(0), {});
  draft = {"IF hardness IS verry hard\nTHEN ä", 3, 1, "hardnes IS \"x\""};
  journal->record(state(0));
  EXPECT_TRUE(journal->isKept());
  die();
  EXPECT_EQ(recovered().draft, draft);
}

// A process that dies while it writes loses that line and no other. Every length of the file is tried.
TEST_F(JournalTest, TornLastLineLosesOnlyItself)
{
  project = test::smallProject();
  journal->start(state(0), {});
  for (int step = 1; step <= 4; ++step) {
    project.tissue.density = 1000.0 + step;
    journal->record(state(step));
  }
  ASSERT_TRUE(journal->waitWritten(std::chrono::seconds(10)));
  die();
  const fs::path file = linesFile();
  const std::string whole = readFile(file).value();
  std::vector<std::size_t> ends;
  for (std::size_t i = 0; i < whole.size(); ++i)
    if (whole[i] == '\n') ends.push_back(i + 1);
  ASSERT_EQ(ends.size(), 5u); // header and four steps
  for (std::size_t length = ends[1]; length <= whole.size(); ++length) {
    std::ofstream(file, std::ios::binary | std::ios::trunc) << whole.substr(0, length);
    const auto found = findJournals(parent);
    ASSERT_EQ(found.size(), 1u) << length;
    const auto work = readJournal(found[0]);
    ASSERT_TRUE(work) << work.error().detail;
    const auto lines =
      std::count_if(ends.begin(), ends.end(), [&](std::size_t end) { return end <= length; });
    EXPECT_EQ(work->steps, lines - 1);
    EXPECT_EQ(work->project.tissue.density, 1000.0 + static_cast<double>(lines - 1));
    EXPECT_FALSE(work->isCutShort);
  }
}

// Damage elsewhere is told: what stands before it is still good, nothing after it is believed.
TEST_F(JournalTest, DamageInTheMiddleIsTold)
{
  journal->start(state(0), {});
  for (int step = 1; step <= 4; ++step) {
    project.tissue.density = 1000.0 + step;
    journal->record(state(step));
  }
  die();
  const fs::path file = linesFile();
  std::string bytes = readFile(file).value();
  const std::size_t place = bytes.find("1003");
  ASSERT_NE(place, std::string::npos);
  bytes[place + 3] = '4';
  std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
  const RecoveredWork work = recovered();
  EXPECT_TRUE(work.isCutShort);
  EXPECT_EQ(work.steps, 2);
  EXPECT_EQ(work.project.tissue.density, 1002.0);
}

// Any damage gives a message or a project that holds together, never a crash.
TEST_F(JournalTest, DamagedBytesNeverCrash)
{
  journal->start(state(0), {});
  project.tissue.density = 1234.5;
  journal->record(state(1));
  die();
  const fs::path home = linesFile().parent_path();
  std::mt19937 random(11);
  for (const auto& entry : fs::directory_iterator(home)) {
    if (entry.path().filename() == kJournalLock) continue;
    const std::string whole = readFile(entry.path()).value();
    for (int i = 0; i < 60; ++i) {
      std::string bytes = whole;
      bytes[random() % bytes.size()] ^= static_cast<char>(1 + random() % 255);
      std::ofstream(entry.path(), std::ios::binary | std::ios::trunc) << bytes;
      auto found = findJournals(parent);
      if (found.size() == 1 && !found[0].fault) {
        const auto work = readJournal(found[0]);
        if (!work) {
          EXPECT_FALSE(work.error().detail.empty());
        }
      }
      if (!fs::exists(home)) fs::create_directories(home); // a journal without a step was cleared away
    }
    std::ofstream(entry.path(), std::ios::binary | std::ios::trunc) << whole;
  }
}

// What cannot be read is said to be so, and stays where it is until it is set aside.
TEST_F(JournalTest, UnreadableJournalsAreToldAndKept)
{
  const fs::path home = parent / "1-abc";
  fs::create_directories(home);
  const std::string later = R"({"format": "esm-journal", "version": 2, "time": 1, "new": [])";
  const std::pair<std::string, ErrorCode> cases[] = {
    {"{\"format\": \"esm-journal\"}\n", ErrorCode::BadFormat},
    {"rubbish\n", ErrorCode::BadFormat},
    {sealed(R"({"format": "other", "version": 1, "time": 1)"), ErrorCode::InvalidValue},
    {sealed(later), ErrorCode::NewerVersion}};
  for (const auto& [text, code] : cases) {
    std::ofstream(home / kJournalLines) << text;
    auto found = findJournals(parent);
    ASSERT_EQ(found.size(), 1u) << text;
    ASSERT_TRUE(found[0].fault) << text;
    EXPECT_EQ(found[0].fault->code, code) << found[0].fault->detail;
    EXPECT_NE(found[0].fault->detail.find("1-abc"), std::string::npos);
    EXPECT_TRUE(fs::exists(home));
  }
  auto found = findJournals(parent);
  const fs::path kept = setJournalAside(found[0]);
  EXPECT_TRUE(fs::exists(kept / kJournalLines));
  EXPECT_TRUE(findJournals(parent).empty());
}

// Saving, or letting go on purpose, leaves nothing; a step after it begins anew.
TEST_F(JournalTest, SavingEndsTheJournal)
{
  journal->start(state(0), {});
  project.tissue.density = 1001.0;
  journal->record(state(1));
  EXPECT_TRUE(journal->isKept());
  journal->start(state(0), {});
  EXPECT_FALSE(journal->isKept());
  EXPECT_TRUE(fs::is_empty(parent));
  project.tissue.density = 1002.0;
  journal->record(state(1));
  journal->leave();
  EXPECT_TRUE(fs::is_empty(parent));
  // Everything undone is nothing to offer either.
  journal->start(state(0), {});
  project.tissue.density = 1003.0;
  journal->record(state(1));
  project.tissue.density = 1002.0;
  journal->record(state(0));
  die();
  EXPECT_TRUE(findJournals(parent).empty());
  EXPECT_TRUE(fs::is_empty(parent));
}

// A save does not hold a rule that is being written: its journal goes on, tied to the file that there is now.
TEST_F(JournalTest, SavingKeepsTheRuleBeingWritten)
{
  project.source.files = {
    {(folder / "a" / "mesh.obj").string(), 0}}; // seen from another folder after the save
  journal->start(state(0), {});
  project.tissue.density = 1001.0;
  draft.text = "IF";
  journal->record(state(1));
  const fs::path path = folder / "b" / "organ.esm";
  fs::create_directories(path.parent_path());
  ASSERT_TRUE(saveProject(project, path));
  journal->start(state(0), path);
  journal->record(state(0));
  die();
  RecoveredWork work = recovered();
  EXPECT_EQ(work.draft, draft);
  EXPECT_EQ(work.steps, 0);
  EXPECT_EQ(work.path, path.string());
  EXPECT_FALSE(work.fileChanged);
  EXPECT_EQ(toJson(work.project), toJson(project));
}

// What belongs to a living process is not offered; two finders do not get the same.
TEST_F(JournalTest, ProcessesKeepApart)
{
  journal->start(state(0), {});
  project.tissue.density = 1001.0;
  journal->record(state(1));
  ASSERT_TRUE(journal->waitWritten(std::chrono::seconds(10)));
  EXPECT_TRUE(findJournals(parent).empty());
  auto second = makeJournal();
  second->start(state(0), {});
  project.tissue.density = 1002.0;
  second->record(state(1));
  die();
  {
    const auto found = findJournals(parent);
    EXPECT_EQ(found.size(), 1u);
    EXPECT_TRUE(findJournals(parent).empty());
  }
  EXPECT_EQ(findJournals(parent).size(), 1u);
  second.reset();
  EXPECT_EQ(findJournals(parent).size(), 2u);
}

// "Later" is remembered, and so is "discard".
TEST_F(JournalTest, AnswersAreRemembered)
{
  journal->start(state(0), {});
  project.tissue.density = 1001.0;
  journal->record(state(1));
  die();
  {
    auto found = findJournals(parent);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_FALSE(found[0].postponed);
    postponeJournal(found[0]);
  }
  auto found = findJournals(parent);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(found[0].postponed);
  discardJournal(found[0]);
  EXPECT_TRUE(findJournals(parent).empty());
  EXPECT_TRUE(fs::is_empty(parent));
}

// Recovered work goes on in the same folder: a second crash loses nothing of the first.
TEST_F(JournalTest, RecoveredWorkIsKeptOn)
{
  journal->start(state(0), {});
  project.tissue.density = 1001.0;
  journal->record(state(1));
  die();
  {
    auto found = findJournals(parent);
    ASSERT_EQ(found.size(), 1u);
    postponeJournal(found[0]);
    const auto work = readJournal(found[0]);
    ASSERT_TRUE(work);
    project = work->project;
    netNumber = 40; // of another document
    derived = work->netDerived;
    journal = makeJournal();
    ASSERT_TRUE(journal->adopt(std::move(found[0]), *work, state(1)));
  }
  project.net.fixed.assign(project.net.fixed.size(), 1);
  journal->record(state(2));
  const Project before = project;
  project = test::randomProject(10);
  netNumber = 41;
  journal->record(state(3));
  project = before;
  netNumber = 40;
  journal->record(state(4));
  die();
  const RecoveredWork work = recovered();
  EXPECT_EQ(work.steps, 4);
  EXPECT_EQ(toJson(work.project), toJson(before));
  EXPECT_FALSE(findJournals(parent)[0].postponed);
}

// A state folder that cannot be had is said once; the work goes on.
TEST_F(JournalTest, UnwritableFolderIsSaidOnce)
{
  std::ofstream(folder / "state") << "a file where a folder should be";
  journal->start(state(0), {});
  for (int step = 1; step <= 3; ++step) {
    project.tissue.density = 1000.0 + step;
    journal->record(state(step));
  }
  EXPECT_EQ(failures, 1);
  EXPECT_FALSE(journal->isKept());
}

// A disk that is full is said once; what was whole can be recovered, and with room again all is kept anew.
TEST_F(JournalTest, FullDiskIsSaidOnceAndLeavesWhatWasWhole)
{
  journal->start(state(0), {});
  const auto step = [&](int number) {
    project.tissue.density = 1000.0 + number;
    journal->record(state(number));
    EXPECT_TRUE(journal->waitWritten(std::chrono::seconds(10)));
  };
  step(1);
  const auto length = fs::file_size(linesFile());
  rlimit limit = {};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &limit), 0);
  const rlimit full{length + 20, limit.rlim_max};
  std::signal(SIGXFSZ, SIG_IGN); // the write fails instead
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &full), 0);
  step(2);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
  EXPECT_EQ(failures, 1);
  EXPECT_EQ(fs::file_size(linesFile()), length);
  step(3);
  step(4);
  EXPECT_EQ(failures, 1);
  die();
  const RecoveredWork work = recovered();
  EXPECT_EQ(work.steps, 4);
  EXPECT_EQ(toJson(work.project), toJson(project));
}

// The state folder follows the XDG rules: absolute names only, ~/.local/state without the variable.
TEST(RecoveryFolder, FollowsTheEnvironment)
{
  const auto with = [](const char* state, const char* home) {
    state ? ::setenv("XDG_STATE_HOME", state, 1) : ::unsetenv("XDG_STATE_HOME");
    home ? ::setenv("HOME", home, 1) : ::unsetenv("HOME");
    return recoveryFolder();
  };
  const char* was = std::getenv("HOME");
  const std::string home = was ? was : "";
  EXPECT_EQ(with("/s", "/h"), fs::path("/s/esm-modeler/recovery"));
  EXPECT_EQ(with(nullptr, "/h"), fs::path("/h/.local/state/esm-modeler/recovery"));
  EXPECT_EQ(with("relative", "/h"), fs::path("/h/.local/state/esm-modeler/recovery"));
  EXPECT_EQ(with("", nullptr), fs::path());
  if (was) ::setenv("HOME", home.c_str(), 1);
}
