// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/file_io.h"
#include "core/project/frame_writers.h"

#include <Eigen/Geometry>

namespace esm {

/// Binary STL: the surface only, in single precision, each corner written anew.
Status writeStl(const Frame& frame, const std::filesystem::path& path)
{
  const SpringNet& net = *frame.net;
  if (net.triangleCount() == 0)
    return Error{ErrorCode::EmptyResult,
                 path.string() +
                   ": not written, the net has no triangles and STL holds nothing else; use obj or ply"};
  std::string bytes = "Elastodynamic Shape Modeler, binary STL, metres, z up";
  bytes.resize(80, ' ');
  appendRaw(bytes, static_cast<std::uint32_t>(net.triangleCount()));
  for (Index t = 0; t < net.triangleCount(); ++t) {
    Eigen::Matrix3d corners;
    for (int k = 0; k < 3; ++k) corners.col(k) = frame.position->col(net.triangles(k, t));
    const Eigen::Vector3d across = (corners.col(1) - corners.col(0)).cross(corners.col(2) - corners.col(0));
    const Eigen::Vector3f normal = across.stableNormalized().cast<float>(); // zero stays zero
    const Eigen::Matrix3f single = corners.cast<float>();
    appendRaw(bytes, normal.data(), 3);
    appendRaw(bytes, single.data(), 9);
    appendRaw(bytes, std::uint16_t{0});
  }
  return writeFileAtomically(path, bytes);
}

} // namespace esm
