// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line.h"

#include "core/base/version.h"

#include <CLI/CLI.hpp>

namespace esm {

int parseCommandLine(int argc, char** argv, CommandLine& options)
{
  CLI::App app(
    "Elastodynamic Shape Modeler: import a mesh, give it tissue by rules, see it move, feel its force",
    "esm-modeler");
  app.set_version_flag("--version", std::string("esm-modeler ") + version());
  app.add_option("file", options.file, "Project (.esm, .esmb) or mesh to open; without it the sample runs");
  app.add_option("--lang", options.language, "Language of the window")->check(CLI::IsMember({"de", "en"}));
  app.add_option("--theme", options.theme, "Colours")->check(CLI::IsMember({"system", "light", "dark"}));
  app.add_option("--screenshot", options.screenshot,
                 "Play with a scripted pull, save a picture of the window to this file and end");
  app.add_option("--after", options.after, "Seconds until the picture")->check(CLI::Range(0.1, 600.0));
  app.add_option("--dump-state", options.dumpState,
                 "Diagnostic: write the window's state as JSON to this file twice a second");
  app
    .add_option("--emulate-device", options.emulate,
                "Show an emulated haptic device in place of those on USB, to try everything without one")
    ->check(CLI::IsMember({"falcon"}));
  app.add_option("--width", options.width, "Width of the window in pixels")->check(CLI::Range(640, 10000));
  app.add_option("--height", options.height, "Height of the window in pixels")->check(CLI::Range(400, 10000));
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  return -1;
}

} // namespace esm
