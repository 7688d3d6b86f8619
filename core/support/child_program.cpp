// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/support/child_program.h"

#include "core/base/text_number.h"

#include <chrono>
#include <cstdlib>
#include <string_view>
#include <thread>

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

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

bool isInPath(const std::string& program)
{
  const char* path = std::getenv("PATH");
  std::string_view rest = path ? path : "";
  while (!rest.empty()) {
    const std::size_t end = rest.find(':');
    const std::filesystem::path folder(rest.substr(0, end));
    if (!folder.empty() && access((folder / program).c_str(), X_OK) == 0) return true;
    rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
  }
  return false;
}

Status runProgram(const std::vector<std::string>& command, const std::filesystem::path& folder,
                  double timeLimit, WorkControl* control)
{
  const std::string& name = command.front();
  if (!isInPath(name))
    return Error{ErrorCode::Unsupported,
                 "the program " + name + " is not there; install it, or choose struts"};
  std::vector<char*> words; // made here: between fork and exec nothing may allocate
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);

  const pid_t child = fork();
  if (child < 0) return Error{ErrorCode::Internal, "no process could be started for " + name};
  if (child == 0) {
    setpgid(0, 0); // so that what it starts goes with it
    const int nowhere = open("/dev/null", O_RDWR);
    if (nowhere < 0 || dup2(nowhere, 0) < 0 || dup2(nowhere, 1) < 0 || dup2(nowhere, 2) < 0 ||
        chdir(folder.c_str()) != 0)
      _exit(127);
    execvp(words[0], words.data());
    _exit(127);
  }
  setpgid(child, child); // whoever comes first
  const auto start = std::chrono::steady_clock::now();
  for (;;) {
    int state = 0;
    const pid_t done = waitpid(child, &state, WNOHANG);
    if (done == child) {
      if (WIFEXITED(state) && WEXITSTATUS(state) == 0) return {};
      return Error{ErrorCode::Numerics,
                   "the program " + name + " failed (" +
                     (WIFSIGNALED(state) ? "signal " + std::to_string(WTERMSIG(state))
                                         : "exit " + std::to_string(WEXITSTATUS(state))) +
                     "); the surface probably crosses itself, repair it or choose struts"};
    }
    const bool isLate =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() > timeLimit;
    if (isLate || stopWanted(control) || done < 0) {
      kill(-child, SIGKILL);
      waitpid(child, &state, 0);
      if (stopWanted(control)) return cancelledError();
      return Error{ErrorCode::Numerics, "the program " + name + " was stopped after " +
                                          formatDouble(timeLimit, 3) +
                                          " s; allow it more time, simplify the surface, or choose struts"};
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

} // namespace esm::support
