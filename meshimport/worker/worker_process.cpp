// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/worker/worker_process.h"

#include "meshimport/raw_mesh.h"
#include "meshimport/worker_place.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <memory>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace esm {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kReplyFile = 3;                        ///< of the worker, where it writes its reply
constexpr std::size_t kTakenAtOnce = 1 << 22;        ///< bytes, then somebody may wish to stop
constexpr std::size_t kMostComplaint = 1 << 12;      ///< bytes kept of what the worker says on stderr
constexpr std::size_t kMostComplaintShown = 160;     ///< bytes of it in a message
constexpr std::chrono::milliseconds kLookAround{10}; ///< how often a wish to stop is looked for
constexpr std::chrono::seconds kLastBreath{1};       ///< between the closed pipe and the end of the worker
const char* const kWayOut = "convert the file to OBJ, PLY or STL";
const char* const kWhoseFault = ", by a fault of its own or because the file is damaged; ";

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

/// Both ends above the worker's own files, so that no end is overwritten while these are put in place.
std::optional<Pipe> makePipe()
{
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) return std::nullopt;
  const Descriptor low[] = {Descriptor(ends[0]), Descriptor(ends[1])};
  Pipe pipe{Descriptor(::fcntl(ends[0], F_DUPFD_CLOEXEC, kReplyFile + 1)),
            Descriptor(::fcntl(ends[1], F_DUPFD_CLOEXEC, kReplyFile + 1))};
  if (!pipe.out.open() || !pipe.in.open()) return std::nullopt;
  ::fcntl(pipe.out.get(), F_SETFL, O_NONBLOCK);
  return pipe;
}

/// A running worker; its end of life is a kill and a wait.
class Child {
public:
  explicit Child(pid_t id) : m_id(id) {}
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() { end(); }

  /// Its wait status if it is over; after that it is reaped.
  std::optional<int> ended(int flags = WNOHANG)
  {
    while (m_id > 0) {
      const pid_t got = ::waitpid(m_id, &m_status, flags);
      if (got == 0) return std::nullopt;
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) m_status = 0; // somebody else has reaped it
      m_id = 0;
    }
    return m_status;
  }
  /// Kills it, unless it is over, and reaps it.
  int end()
  {
    if (m_id > 0) ::kill(m_id, SIGKILL);
    return *ended(0);
  }

private:
  pid_t m_id;
  int m_status = 0;
};

/// Starts the program with nothing of ours but the two pipes: no other file, no blocked or ignored signal.
int spawn(const std::vector<std::string>& words, int replyIn, int complaintIn, pid_t& id)
{
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str())); // it is copied
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&files, complaintIn, STDERR_FILENO);
  posix_spawn_file_actions_adddup2(&files, replyIn, kReplyFile);
  posix_spawn_file_actions_addclosefrom_np(&files, kReplyFile + 1);
  posix_spawnattr_t how;
  posix_spawnattr_init(&how);
  sigset_t signals;
  sigemptyset(&signals);
  posix_spawnattr_setsigmask(&how, &signals);
  sigfillset(&signals);
  posix_spawnattr_setsigdefault(&how, &signals);
  posix_spawnattr_setflags(&how, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  const int fault = ::posix_spawn(&id, arguments[0], &files, &how, arguments.data(), environ);
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

/// What is heard of a worker until it closes its reply or is no longer wanted.
struct Hearing {
  std::string reply, complaint;
  bool cancelled = false, tooLong = false, garbled = false;
};

/// Keeps the last of what the worker says on stderr: the reason stands at the end.
void listen(Pipe& complaint, std::string& words)
{
  if (!complaint.out.open()) return;
  take(complaint.out, words, words.size() + kMostComplaint);
  if (words.size() > kMostComplaint) words.erase(0, words.size() - kMostComplaint);
}

Hearing hear(Pipe& reply, Pipe& complaint, Clock::time_point deadline, WorkControl* control)
{
  Hearing heard;
  std::uint64_t size = sizeof(ReplyHead); // then, of the whole reply, as its head promises
  bool headed = false;
  while (reply.out.open() && !heard.cancelled && !heard.tooLong && !heard.garbled) {
    pollfd files[] = {{reply.out.get(), POLLIN, 0}, {complaint.out.get(), POLLIN, 0}};
    ::poll(files, 2, static_cast<int>(kLookAround.count()));
    listen(complaint, heard.complaint);
    take(reply.out, heard.reply, headed ? size + 1 : size); // one byte too many tells enough
    if (!headed && heard.reply.size() == size) {
      const std::optional<std::uint64_t> promised = replySize(heard.reply);
      headed = true;
      size = promised.value_or(0);
    }
    heard.garbled = headed && heard.reply.size() > size;
    heard.cancelled = stopWanted(control);
    heard.tooLong = Clock::now() > deadline;
  }
  return heard;
}

/// The last line of what the worker complained of, short enough for a message.
std::string gist(std::string_view complaint)
{
  while (!complaint.empty() && static_cast<unsigned char>(complaint.back()) <= ' ')
    complaint.remove_suffix(1);
  const std::size_t start = complaint.find_last_of("\r\n");
  if (start != complaint.npos) complaint.remove_prefix(start + 1);
  if (complaint.size() <= kMostComplaintShown) return std::string(complaint);
  return std::string(complaint.substr(0, kMostComplaintShown)) + "...";
}

std::string named(int signal)
{
  switch (signal) {
  case SIGSEGV:
    return "segmentation fault";
  case SIGABRT:
    return "it aborted";
  case SIGBUS:
    return "bus error";
  case SIGFPE:
    return "arithmetic error";
  case SIGILL:
    return "illegal instruction";
  case SIGKILL:
    return "it was killed from outside, perhaps for want of memory";
  default:
    return "signal " + std::to_string(signal);
  }
}

/// The sentence for a worker that ended without a whole reply.
Error obituary(const std::string& origin, int status, const std::string& complaint)
{
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)
    return fault(ErrorCode::Unsupported, origin, 0,
                 std::string("the reader for this format took too long for a file of this size; ") + kWayOut);
  const std::string why = WIFSIGNALED(status)        ? named(WTERMSIG(status))
                          : !complaint.empty()       ? gist(complaint)
                          : WEXITSTATUS(status) != 0 ? "exit code " + std::to_string(WEXITSTATUS(status))
                                                     : std::string("it ended without an answer");
  return fault(ErrorCode::BadFormat, origin, 0,
               "the reader for this format failed: it crashed (" + why + ")" + kWhoseFault + kWayOut);
}

/// Waits for a worker that has closed its pipe; one that does not end is killed.
int lastStatus(Child& child)
{
  for (const auto limit = Clock::now() + kLastBreath; Clock::now() < limit; ::usleep(200))
    if (const auto status = child.ended()) return *status;
  return child.end();
}

} // namespace

Result<WorkerReply> readInWorker(const WorkerTask& task, WorkControl* control)
{
  const std::string origin = task.file.string();
  const std::string program = importWorker().string();
  std::optional<Pipe> reply = makePipe(), complaint = makePipe();
  if (!reply || !complaint)
    return fault(ErrorCode::Internal, origin, 0, "this program has too many files open to read it");
  pid_t id = 0;
  const int failed = spawn({program, std::to_string(::getpid()), task.library, task.ending, origin},
                           reply->in.get(), complaint->in.get(), id);
  if (failed != 0)
    return fault(ErrorCode::Internal, origin, 0,
                 "the program that reads this format, " + program + ", cannot be started (" +
                   std::generic_category().message(failed) + "); install it again");
  Child child(id);
  reply->in.close();
  complaint->in.close();

  Hearing heard = hear(*reply, *complaint, Clock::now() + task.wall, control);
  if (heard.cancelled) {
    child.end();
    return cancelledError();
  }
  if (heard.tooLong)
    return fault(ErrorCode::Unsupported, origin, 0,
                 "the reader for this format did not end within " + std::to_string(task.wall.count()) +
                   " s; " + kWayOut);
  const int status = heard.garbled ? child.end() : lastStatus(child);
  listen(*complaint, heard.complaint);
  if (!heard.garbled && (WIFSIGNALED(status) || heard.reply.empty()))
    return obituary(origin, status, heard.complaint);
  Result<WorkerReply> answer = decodeReply(heard.reply);
  if (!answer)
    return fault(ErrorCode::BadFormat, origin, 0,
                 "the reader for this format failed: it answered with garbage (" + answer.error().detail +
                   ")" + kWhoseFault + kWayOut);
  if (answer->refusal) return *std::move(answer->refusal);
  return answer;
}

} // namespace esm
