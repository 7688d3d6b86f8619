// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/file_io.h"
#include "core/project/frame_writers.h"

namespace esm {

/// Stanford PLY, binary: the whole net. Springs are the `edge` element with their parameters in SI units.
Status writePly(const Frame& frame, const std::filesystem::path& path)
{
  const SpringNet& net = *frame.net;
  const Eigen::ArrayXd strain = springStrains(frame);
  std::string bytes = "ply\nformat binary_little_endian 1.0\n"
                      "comment Elastodynamic Shape Modeler, metres, z up\n";
  bytes += "element vertex " + std::to_string(net.nodeCount()) +
           "\nproperty double x\nproperty double y\nproperty double z\n"
           "property double mass\nproperty uchar fixed\n";
  bytes +=
    "element face " + std::to_string(net.triangleCount()) + "\nproperty list uchar int vertex_indices\n";
  bytes += "element edge " + std::to_string(net.springCount()) +
           "\nproperty int vertex1\nproperty int vertex2\nproperty double rest_length\n"
           "property double stiffness\nproperty double damping\nproperty double strain\n";
  if (frame.tension) bytes += "property double force\n";
  bytes += "end_header\n";

  for (Index node = 0; node < net.nodeCount(); ++node) {
    appendRaw(bytes, frame.position->col(node).data(), 3);
    appendRaw(bytes, net.mass[node]);
    appendRaw(bytes, static_cast<std::uint8_t>(net.fixed[static_cast<std::size_t>(node)] != 0));
  }
  for (Index t = 0; t < net.triangleCount(); ++t) {
    appendRaw(bytes, std::uint8_t{3});
    appendRaw(bytes, net.triangles.col(t).data(), 3);
  }
  for (Index s = 0; s < net.springCount(); ++s) {
    appendRaw(bytes, net.ends.col(s).data(), 2);
    for (const double value : {net.restLength[s], net.stiffness[s], net.viscosity[s], strain[s]})
      appendRaw(bytes, value);
    if (frame.tension) appendRaw(bytes, (*frame.tension)[s]);
  }
  return writeFileAtomically(path, bytes);
}

} // namespace esm
