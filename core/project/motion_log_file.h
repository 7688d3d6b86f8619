// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/motion_log.h"
#include "core/dynamics/solver_settings.h"
#include "core/project/project.h"

#include <cstdint>
#include <filesystem>

namespace esm {

/// Files of MotionLog, `.esmlog`: a line of settings, the whole project, then one line of JSON an entry
/// (docs/FILE_FORMAT.md). Numbers round-trip bit for bit, so whoever gets the file can replay the run.

/// Writes a log while the run goes on. What is written stays when the process is killed.
class MotionLogWriter {
public:
  /// @param project  as the run begins with it. @param settings  of its Simulation
  /// Errors: FileUnwritable, also for devices, pipes, and a file that another run is being written to.
  static Result<MotionLogWriter> create(const std::filesystem::path& path, const Project& project,
                                        const SolverSettings& settings);
  MotionLogWriter(MotionLogWriter&& other) noexcept;
  MotionLogWriter& operator=(MotionLogWriter&&) = delete;
  ~MotionLogWriter();

  Status add(const MotionLog& entries); ///< that have come since the last call. Errors: FileUnwritable
  Status finish();                      ///< the run has come to its end. Errors: as above

private:
  MotionLogWriter(std::filesystem::path path, int file) : m_path(std::move(path)), m_file(file) {}

  std::filesystem::path m_path;
  int m_file = -1;
};

struct RecordedRun {
  Project project;
  SolverSettings settings;
  MotionLog log;
  std::string cut; ///< why what follows the last entry was left out; empty: nothing does
};

/// Errors: FileUnreadable; BadFormat, InvalidValue (detail: file, entry, what); NewerVersion. A last line that is not
/// whole is left out. A log without an end is said: the run was killed.
Result<RecordedRun> readMotionLog(const std::filesystem::path& path);

} // namespace esm
