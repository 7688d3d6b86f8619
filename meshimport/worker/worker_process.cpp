// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/worker/worker_process.h"

#include "core/base/child_process.h"
#include "meshimport/raw_mesh.h"
#include "meshimport/worker_place.h"

#include <csignal>
#include <unistd.h>
#include <utility>

namespace esm {

namespace {

const char* const kWayOut = "convert the file to OBJ, PLY or STL";
const char* const kWhoseFault = ", by a fault of its own or because the file is damaged; ";

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
Error obituary(const std::string& origin, const ChildEnd& end)
{
  const bool isKilled = end.way == ChildEnd::Way::Killed;
  if (isKilled && end.number == SIGXCPU)
    return fault(ErrorCode::Unsupported, origin, 0,
                 std::string("the reader for this format took too long for a file of this size; ") + kWayOut);
  const std::string why = isKilled                 ? named(end.number)
                          : !end.complaint.empty() ? gistOf(end.complaint)
                          : end.number != 0        ? "exit code " + std::to_string(end.number)
                                                   : std::string("it ended without an answer");
  return fault(ErrorCode::BadFormat, origin, 0,
               "the reader for this format failed: it crashed (" + why + ")" + kWhoseFault + kWayOut);
}

} // namespace

Result<WorkerReply> readInWorker(const WorkerTask& task, WorkControl* control)
{
  const std::string origin = task.file.string();
  const std::string program = importWorker().string();
  ChildTask child;
  child.words = {program, std::to_string(::getpid()), task.library, task.ending, origin};
  child.wall = task.wall;
  child.answerBytes = replySize;
  child.headBytes = sizeof(ReplyHead);
  const Result<ChildEnd> end = runChild(child, control);
  if (!end && end.error().code == ErrorCode::Cancelled) return end.error();
  if (!end)
    return fault(ErrorCode::Internal, origin, 0,
                 "the program that reads this format, " + program + ", cannot be started (" +
                   end.error().detail + "); install it again");
  if (end->way == ChildEnd::Way::TooLong)
    return fault(ErrorCode::Unsupported, origin, 0,
                 "the reader for this format did not end within " + std::to_string(task.wall.count()) +
                   " s; " + kWayOut);
  if (end->way != ChildEnd::Way::Garbled && (end->way == ChildEnd::Way::Killed || end->answer.empty()))
    return obituary(origin, *end);
  Result<WorkerReply> answer = decodeReply(end->answer);
  if (!answer)
    return fault(ErrorCode::BadFormat, origin, 0,
                 "the reader for this format failed: it answered with garbage (" + answer.error().detail +
                   ")" + kWhoseFault + kWayOut);
  if (answer->refusal) return *std::move(answer->refusal);
  return answer;
}

} // namespace esm
