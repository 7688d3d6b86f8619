// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "cli/commands.h"
#include "cli/suggestion.h"
#include "core/base/large_pages.h"
#include "core/base/version.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <string_view>
#include <system_error>
#include <unistd.h>

namespace {

using namespace esm::cli;

constexpr const char* kFooter =
  "Examples:\n"
  "  esm inspect uterus.obj\n"
  "  esm import uterus.obj --unit mm -o uterus.esm\n"
  "  esm apply uterus.esm -o soft.esm --region \"0,0,0.03,0.02,0.02,0.02\" --set \"hardness=very soft\"\n"
  "  esm simulate soft.esm --duration 2 --frames 60 -o motion.pvd\n"
  "  esm export soft.esm -o soft.ply\n"
  "\n"
  "Exit codes: 0 done, 1 the input is bad, 2 wrong usage, 3 the numerics failed or the tolerance was\n"
  "given up, 4 internal, or out of memory.\n"
  "Lengths are metres, forces newtons, times seconds; numbers take a point in every locale.";

/// Scripts with a variable that is not set give it: an output would be left out without a word.
void refuseEmptyValues(CLI::App& app)
{
  for (CLI::Option* option : app.get_options())
    if (option->get_items_expected_max() > 0)
      option->check([](const std::string& text) {
        return text.empty() ? "an empty text is given; name a value, or leave the option out" : std::string();
      });
  for (CLI::App* command : app.get_subcommands([](CLI::App*) { return true; })) refuseEmptyValues(*command);
}

Exit run(int argc, char** argv)
{
  CLI::App program("esm - the Elastodynamic Shape Modeler without a window", "esm");
  program.set_version_flag("--version", std::string("esm ") + esm::version());
  program.require_subcommand(1);
  program.footer(kFooter);
  Work work;
  for (const auto add : {addInspect, addImport, addInfo, addValidate, addApply, addExplain, addSimulate,
                         addReplayLog, addExport, addFuzzy, addHaptics, addLearn, addSolvers})
    add(program, work);
  refuseEmptyValues(program);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& fault) {
    if (fault.get_exit_code() == 0) return static_cast<Exit>(program.exit(fault)); // --help, --version
    const auto chosen = program.get_subcommands();
    const std::string meant = nearestName(program, argc, argv);
    say(std::string(fault.what()) + (meant.empty() ? "" : "; did you mean " + meant + "?") + "; see esm " +
        (chosen.empty() ? "" : chosen.front()->get_name() + " ") + "--help");
    return Exit::WrongUsage;
  }
  return work();
}

/// Where no handler can be reached, in a destructor or another thread: a message and an exit code all the
/// same.
[[noreturn]] void endUncaught()
{
  try {
    if (const auto thrown = std::current_exception()) std::rethrow_exception(thrown);
  } catch (const std::bad_alloc&) {
    constexpr std::string_view kMessage = "esm: not enough memory\n";
    if (::write(STDERR_FILENO, kMessage.data(), kMessage.size()) >= 0)
      ::_exit(static_cast<int>(Exit::Internal));
  } catch (...) { // a fault of ours: a core to look at
  }
  std::abort();
}

Exit guardedRun(int argc, char** argv)
{
  try {
    return run(argc, argv);
  } catch (const std::bad_alloc&) {
    say("not enough memory");
  } catch (const std::system_error& fault) {
    const bool isThread = fault.code() == std::errc::resource_unavailable_try_again;
    say(isThread ? "not enough memory for one more thread, or too many processes"
                 : std::string("internal error: ") + fault.what());
  } catch (const std::exception& fault) {
    say(std::string("internal error: ") + fault.what());
  }
  return Exit::Internal;
}

} // namespace

int main(int argc, char** argv)
{
  esm::keepBigArraysInHeap();
  std::set_terminate(endUncaught);
  std::signal(SIGXFSZ, SIG_IGN); // a file beyond the limit of its size is a fault of writing, not the end
  const Exit exit = guardedRun(argc, argv);
  const bool json =
    std::any_of(argv + 1, argv + argc, [](const char* word) { return std::string_view(word) == "--json"; });
  if (json && exit != Exit::Done) printFailure(exit);
  if (std::cout.flush()) return static_cast<int>(exit);
  say("the standard output cannot be written");
  return static_cast<int>(exit == Exit::Done ? Exit::BadInput : exit);
}
