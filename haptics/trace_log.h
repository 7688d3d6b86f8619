// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "haptics/haptic_types.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace esm {

/// A recording of ticks that grows on the disk while it is made: whatever ends the program, `kill -9` too,
/// the file ends at most half a second before, with a whole line but for the last. A file that is there
/// already is written over from the first tick on; pipes and terminals get the lines as they come.
///
///     TraceLog log = *TraceLog::create("felt.csv", TraceLog::Columns::All);
///     log.add(ticks); ... log.add(ticks);  Status written = log.finish();
/// @note One thread, not the servo's: the disk may take its time.
class TraceLog {
public:
  enum class Columns : std::uint8_t {
    All, ///< "t [s],x [m],...,lateness [s]": all of a tick
    Path ///< "t,x,y,z": the way of the hand from t = 0 on, see readHandPath()
  };
  /// Errors: FileUnwritable, with the system's reason; a block device, a socket or a folder is one.
  static Result<TraceLog> create(const std::filesystem::path& file, Columns columns);

  void add(std::span<const TraceSample> ticks);
  /// Once. What is left goes to the disk. Errors: FileUnwritable, of any write so far.
  Status finish();

private:
  using Clock = std::chrono::steady_clock;
  struct Descriptor {
    explicit Descriptor(int newNumber) noexcept : number(newNumber) {}
    ~Descriptor();
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int number;
  };
  TraceLog(std::filesystem::path path, int descriptor, Columns columns);
  void addLine(const TraceSample& tick);
  void write();

  std::filesystem::path m_path;
  std::unique_ptr<Descriptor> m_descriptor;
  Columns m_columns;
  std::string m_text; ///< not written yet
  Clock::time_point m_written, m_synced;
  double m_start = 0.0;
  bool m_hasStart = false;
  int m_fault = 0; ///< errno of the first write that failed
};

/// The same as one text.
std::string traceCsv(std::span<const TraceSample> ticks);

} // namespace esm
