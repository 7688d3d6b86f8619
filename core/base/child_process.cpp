// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/child_process.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace esm {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kTakenAtOnce = 1 << 22;        ///< bytes, then somebody may wish to stop
constexpr std::size_t kMostComplaint = 1 << 12;      ///< bytes kept of what it says on stderr
constexpr std::size_t kMostGist = 160;               ///< bytes of it in a message
constexpr std::chrono::milliseconds kLookAround{10}; ///< how often a wish to stop is looked for
constexpr std::chrono::seconds kLastBreath{1};       ///< between the closed answer and its end

/// An open file that closes itself.
class Descriptor {
public:
  explicit Descriptor(int file = -1) : m_file(file) {}
  Descriptor(Descriptor&& other) noexcept : m_file(std::exchange(other.m_file, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept
  {
    std::swap(m_file, other.m_file);
    return *this;
  }
  ~Descriptor() { close(); }

  void close()
  {
    if (m_file >= 0) ::close(std::exchange(m_file, -1));
  }
  int get() const noexcept { return m_file; }
  bool open() const noexcept { return m_file >= 0; }

private:
  int m_file;
};

struct Pipe {
  Descriptor out, in; ///< where to read, where to write
};

/// Both ends above the child's own files, so that no end is overwritten while these are put in place.
std::optional<Pipe> makePipe()
{
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) return std::nullopt;
  const Descriptor low[] = {Descriptor(ends[0]), Descriptor(ends[1])};
  Pipe pipe{Descriptor(::fcntl(ends[0], F_DUPFD_CLOEXEC, ChildTask::kAnswerFile + 1)),
            Descriptor(::fcntl(ends[1], F_DUPFD_CLOEXEC, ChildTask::kAnswerFile + 1))};
  if (!pipe.out.open() || !pipe.in.open()) return std::nullopt;
  ::fcntl(pipe.out.get(), F_SETFL, O_NONBLOCK);
  return pipe;
}

/// A running program, the first of a process group; its end of life is a kill and a wait.
class Child {
public:
  explicit Child(pid_t id) : m_id(id) {}
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() { end(); }

  /// Its wait status if it is over; after that it is reaped.
  std::optional<int> ended()
  {
    siginfo_t state = {};
    // Not reaped yet, so that its number still names its own group and no other.
    if (m_id > 0 && ::waitid(P_PID, static_cast<id_t>(m_id), &state, WEXITED | WNOHANG | WNOWAIT) == 0 &&
        state.si_pid == 0)
      return std::nullopt;
    return end();
  }
  /// Kills what is left of it and of its group, and reaps it.
  int end()
  {
    if (m_id <= 0) return m_status;
    ::kill(-m_id, SIGKILL);
    pid_t got = 0;
    while ((got = ::waitpid(m_id, &m_status, 0)) < 0 && errno == EINTR) continue;
    if (got < 0) m_status = 0; // somebody else has reaped it
    m_id = 0;
    return m_status;
  }
  /// Waits a moment for one that has closed its answer; one that does not end is killed.
  int lastStatus()
  {
    for (const auto limit = Clock::now() + kLastBreath; Clock::now() < limit; ::usleep(200))
      if (const auto status = ended()) return *status;
    return end();
  }

private:
  pid_t m_id;
  int m_status = 0;
};

/// @param answer where it writes its answer, or -1
int spawn(const ChildTask& task, int answer, int complaint, pid_t& id)
{
  std::vector<char*> arguments;
  for (const std::string& word : task.words)
    arguments.push_back(const_cast<char*>(word.c_str())); // it is copied
  arguments.push_back(nullptr);
  const int ours = answer < 0 ? ChildTask::kAnswerFile : ChildTask::kAnswerFile + 1;
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&files, complaint, STDERR_FILENO);
  if (answer >= 0) posix_spawn_file_actions_adddup2(&files, answer, ChildTask::kAnswerFile);
  posix_spawn_file_actions_addclosefrom_np(&files, ours);
  if (!task.folder.empty()) posix_spawn_file_actions_addchdir_np(&files, task.folder.c_str());
  posix_spawnattr_t how;
  posix_spawnattr_init(&how);
  sigset_t signals;
  sigemptyset(&signals);
  posix_spawnattr_setsigmask(&how, &signals);
  sigfillset(&signals);
  posix_spawnattr_setsigdefault(&how, &signals);
  posix_spawnattr_setpgroup(&how, 0);
  posix_spawnattr_setflags(&how, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
  const int fault = ::posix_spawnp(&id, arguments[0], &files, &how, arguments.data(), environ);
  posix_spawnattr_destroy(&how);
  posix_spawn_file_actions_destroy(&files);
  return fault;
}

/// Takes what has arrived until there are `most` bytes in all; closes the file at its end.
void take(Descriptor& file, std::string& bytes, std::size_t most)
{
  char part[1 << 16];
  const std::size_t start = bytes.size();
  while (bytes.size() < most && bytes.size() < start + kTakenAtOnce) {
    const ssize_t count = ::read(file.get(), part, std::min(sizeof part, most - bytes.size()));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0 && errno == EAGAIN) return;
    if (count <= 0) return file.close();
    bytes.append(part, static_cast<std::size_t>(count));
  }
}

/// Keeps the last of what it says on stderr: the reason stands at the end.
void listen(Descriptor& complaint, std::string& words)
{
  constexpr int kMostRounds = 64; // more than a pipe holds; who goes on talking is not waited for
  bool isMore = true;
  for (int round = 0; round < kMostRounds && isMore && complaint.open(); ++round) {
    const std::size_t most = words.size() + kMostComplaint;
    take(complaint, words, most);
    isMore = words.size() == most;
    if (words.size() > kMostComplaint) words.erase(0, words.size() - kMostComplaint);
  }
}

/// An answer as it arrives.
class Answer {
public:
  explicit Answer(const ChildTask& task) : m_task(task), m_bytes(task.headBytes) {}

  /// @return whether it is still one that its head allows
  bool takeFrom(Descriptor& file, std::string& bytes)
  {
    take(file, bytes, m_headed ? m_bytes + 1 : m_bytes); // one byte too many tells enough
    if (!m_headed && bytes.size() == m_bytes) {
      m_headed = true;
      m_bytes = m_task.answerBytes(bytes).value_or(0);
    }
    return !m_headed || bytes.size() <= m_bytes;
  }

private:
  const ChildTask& m_task;
  std::uint64_t m_bytes; ///< of the head, then of the whole
  bool m_headed = false;
};

ChildEnd endOf(int status)
{
  ChildEnd end;
  end.way = WIFSIGNALED(status) ? ChildEnd::Way::Killed : ChildEnd::Way::Exited;
  end.number = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
  return end;
}

/// Until it is over, or its answer is, or it is no longer wanted.
Result<ChildEnd> attend(const ChildTask& task, Child& child, Descriptor answer, Descriptor complaint,
                        WorkControl* control)
{
  const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(task.wall);
  Answer expected(task);
  std::string said, complained;
  ChildEnd end;
  for (;;) {
    pollfd files[] = {{answer.get(), POLLIN, 0}, {complaint.get(), POLLIN, 0}};
    ::poll(files, 2, static_cast<int>(kLookAround.count()));
    listen(complaint, complained);
    const bool sound = !answer.open() || expected.takeFrom(answer, said);
    if (stopWanted(control)) return cancelledError(); // its destructor kills the child
    if (!sound) {
      child.end();
      end.way = ChildEnd::Way::Garbled;
      break;
    }
    if (task.answerBytes && !answer.open()) {
      end = endOf(child.lastStatus());
      break;
    }
    if (!task.answerBytes)
      if (const auto status = child.ended()) {
        end = endOf(*status);
        break;
      }
    if (Clock::now() > deadline) {
      child.end();
      end.way = ChildEnd::Way::TooLong;
      break;
    }
  }
  listen(complaint, complained);
  end.answer = std::move(said);
  end.complaint = std::move(complained);
  return end;
}

} // namespace

Result<ChildEnd> runChild(const ChildTask& task, WorkControl* control)
{
  std::optional<Pipe> answer, complaint = makePipe();
  if (task.answerBytes) answer = makePipe();
  if (!complaint || (task.answerBytes && !answer))
    return Error{ErrorCode::Internal, "this program has too many files open"};
  pid_t id = 0;
  if (const int fault = spawn(task, answer ? answer->in.get() : -1, complaint->in.get(), id); fault != 0)
    return Error{ErrorCode::Internal, std::generic_category().message(fault)};
  Child child(id);
  complaint->in.close();
  if (answer) answer->in.close();
  return attend(task, child, answer ? std::move(answer->out) : Descriptor(), std::move(complaint->out),
                control);
}

bool isInPath(const std::string& program)
{
  const char* path = std::getenv("PATH");
  std::string_view rest = path ? path : "";
  while (!rest.empty()) {
    const std::size_t end = rest.find(':');
    const std::filesystem::path folder(rest.substr(0, end));
    if (!folder.empty() && ::access((folder / program).c_str(), X_OK) == 0) return true;
    rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
  }
  return false;
}

std::string gistOf(std::string_view complaint)
{
  while (!complaint.empty() && static_cast<unsigned char>(complaint.back()) <= ' ')
    complaint.remove_suffix(1);
  const std::size_t start = complaint.find_last_of("\r\n");
  if (start != complaint.npos) complaint.remove_prefix(start + 1);
  if (complaint.size() <= kMostGist) return std::string(complaint);
  return std::string(complaint.substr(0, kMostGist)) + "...";
}

} // namespace esm
