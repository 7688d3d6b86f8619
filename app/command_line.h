// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace esm {

/// What the program was started with. Parsed before QApplication, which changes the locale.
struct CommandLine {
  std::string file;          ///< project or mesh; empty: the sample
  std::string language;      ///< "de", "en" or empty: as last time
  std::string theme;         ///< "system", "light", "dark" or empty: as last time
  std::string screenshot;    ///< picture file; the program then plays a scripted pull and ends
  double after = 3.0;        ///< [s] until the picture
  std::string dumpState;     ///< diagnostic file, see StateDump
  std::string emulate;       ///< device in the computer in place of the USB ones: "falcon"; empty: none
  int width = 0, height = 0; ///< of the window [pixel]; 0: as last time
};

/// @return -1 to go on, else the program's exit code (help, version: 0; wrong usage: 2).
int parseCommandLine(int argc, char** argv, CommandLine& options);

} // namespace esm
