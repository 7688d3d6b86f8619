// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/file_io.h"
#include "core/base/text_number.h"
#include "core/project/frame_writers.h"

namespace esm {

/// Wavefront OBJ: nodes in their order, triangles, and as `l` what is no triangle's edge.
Status writeObj(const Frame& frame, const std::filesystem::path& path)
{
  const SpringNet& net = *frame.net;
  std::string text = "# Elastodynamic Shape Modeler, metres, z up\n";
  for (Index node = 0; node < net.nodeCount(); ++node) {
    text += 'v';
    for (int k = 0; k < 3; ++k) {
      text += ' ';
      appendDouble(text, (*frame.position)(k, node));
    }
    text += '\n';
  }
  const auto number = [](Index node) { return " " + std::to_string(node + 1); };
  for (const auto& corners : net.triangles.colwise())
    text += "f" + number(corners[0]) + number(corners[1]) + number(corners[2]) + "\n";
  for (const Index s : springsWithoutTriangle(net))
    text += "l" + number(net.ends(0, s)) + number(net.ends(1, s)) + "\n";
  return writeFileAtomically(path, text);
}

} // namespace esm
