// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/structure/child_program.h"

#include "core/base/text_number.h"

#include <cstdlib>

namespace esm::support {

ScratchFolder::ScratchFolder()
{
  std::error_code code;
  std::string name = (std::filesystem::temp_directory_path(code) / "esm-XXXXXX").string();
  if (!code && mkdtemp(name.data())) m_path = name;
}

ScratchFolder::~ScratchFolder()
{
  std::error_code code;
  if (!m_path.empty()) std::filesystem::remove_all(m_path, code);
}

Status runProgram(const std::vector<std::string>& command, const std::filesystem::path& folder,
                  double timeLimit, WorkControl* control)
{
  const std::string& name = command.front();
  if (!isInPath(name))
    return Error{ErrorCode::Unsupported,
                 "the program " + name + " is not there; install it, or choose struts"};
  ChildTask task;
  task.words = command;
  task.folder = folder;
  task.wall = std::chrono::duration<double>(timeLimit);
  const Result<ChildEnd> end = runChild(task, control);
  if (!end && end.error().code == ErrorCode::Cancelled) return end.error();
  if (!end)
    return Error{ErrorCode::Internal,
                 "the program " + name + " cannot be started (" + end.error().detail + ")"};
  if (end->done()) return {};
  if (end->way == ChildEnd::Way::TooLong)
    return Error{ErrorCode::Numerics, "the program " + name + " was stopped after " +
                                        formatDouble(timeLimit, 3) +
                                        " s; allow it more time, simplify the surface, or choose struts"};
  return Error{ErrorCode::Numerics, "the program " + name + " failed (" +
                                      (end->way == ChildEnd::Way::Killed ? "signal " : "exit ") +
                                      std::to_string(end->number) +
                                      "); the surface probably crosses itself, repair it or choose struts"};
}

} // namespace esm::support
