// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/forces/loads.h"
#include "core/net/spring_net.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace esm {

/// A net at one instant, for writers. Everything optional but the net and the positions.
struct Frame {
  const SpringNet* net = nullptr;             ///< not owned
  const Eigen::Matrix3Xd* position = nullptr; ///< 3 x N [m], not owned
  const Eigen::Matrix3Xd* velocity = nullptr; ///< 3 x N [m/s] or null
  const Eigen::ArrayXd* tension = nullptr;    ///< S [N] or null
  double time = 0.0;                          ///< [s]
  const Loads* loads = nullptr;               ///< or null, not owned
};

/// Writes by the ending: obj (with `l` lines), ply (binary, with edge elements and per-spring parameters),
/// stl (binary), glb and gltf (triangles and lines), vtu (springs as line cells with stiffness, damping,
/// rest_length, strain, force), csv (two files: NAME.csv nodes, NAME_springs.csv springs), scn (a SOFA
/// scene), xsp (Xsp 3.0). Atomic. Errors: Unsupported (the list of endings), FileUnwritable, Numerics (a
/// non-finite coordinate).
Status exportFrame(const Frame& frame, const std::filesystem::path& path);

/// What a file of this ending cannot hold of the frame, to be said before or while it is written: "the 3
/// anchors; nothing holds these nodes to their places".
std::vector<std::string> lostInExport(const Frame& frame, const std::filesystem::path& path);

/// The time series of a run: writer of `.csv` (t,id,x,y,z), `.f64` (little-endian float64, frames x nodes
/// x 3) or `.pvd` (a ParaView collection with one .vtu per frame in NAME_frames/). The file appears when
/// finish() succeeds, nothing half-written stays behind.
class TrajectoryWriter {
public:
  static Result<TrajectoryWriter> create(const std::filesystem::path& path);
  Status addFrame(const Frame& frame); ///< frames in rising time, the initial state first
  Status finish();
  TrajectoryWriter(TrajectoryWriter&&) noexcept;
  TrajectoryWriter& operator=(TrajectoryWriter&&) noexcept;
  ~TrajectoryWriter();

  struct Impl; ///< one kind of file, see trajectory_writer.cpp

private:
  explicit TrajectoryWriter(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> m_impl;
};

} // namespace esm
