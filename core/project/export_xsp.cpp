// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/file_io.h"
#include "core/base/text_number.h"
#include "core/project/frame_writers.h"

#include <algorithm>

namespace esm {

namespace {

/// " 1.5" for each number.
void appendNumbers(std::string& text, std::initializer_list<double> values)
{
  for (const double value : values) {
    text += ' ';
    appendDouble(text, value);
  }
}

/// Nodes of the surface are `s`, inner ones `v`.
std::vector<char> places(const SpringNet& net)
{
  std::vector<char> place(static_cast<std::size_t>(net.nodeCount()), 'v');
  for (Eigen::Index i = 0; i < net.triangles.size(); ++i)
    place[static_cast<std::size_t>(net.triangles.data()[i])] = 's';
  return place;
}

} // namespace

/// Xsp 3.0, the mass-spring text format of SOFA: masses first, a negative one for a fixed node, then linear
/// springs over masses that count from 1, with stiffness and damping as they are (a length of -1 would
/// divide them by the distance).
Status writeXsp(const Frame& frame, const std::filesystem::path& path)
{
  const SpringNet& net = *frame.net;
  std::string text = "Xsp 3.0\nnumm " + std::to_string(net.nodeCount()) + "\nnums " +
                     std::to_string(net.springCount()) + "\ngrav";
  const Eigen::Vector3d gravity = frame.loads ? frame.loads->gravity : Eigen::Vector3d::Zero();
  appendNumbers(text, {gravity[0], gravity[1], gravity[2]});
  text += "\nvisc 0\n";
  const std::vector<char> place = places(net);
  for (Index node = 0; node < net.nodeCount(); ++node) {
    const auto i = static_cast<std::size_t>(node);
    const auto p = frame.position->col(node);
    const Eigen::Vector3d v =
      frame.velocity ? Eigen::Vector3d(frame.velocity->col(node)) : Eigen::Vector3d::Zero();
    text += "mass " + std::to_string(node + 1) + ' ' + place[i];
    appendNumbers(text,
                  {p[0], p[1], p[2], v[0], v[1], v[2], net.fixed[i] ? -net.mass[node] : net.mass[node], 0.0});
    text += '\n';
  }
  for (Index s = 0; s < net.springCount(); ++s) {
    text += "lspg " + std::to_string(s + 1) + ' ' + std::to_string(net.ends(0, s) + 1) + ' ' +
            std::to_string(net.ends(1, s) + 1);
    appendNumbers(text, {net.stiffness[s], net.viscosity[s], net.restLength[s]});
    text += '\n';
  }
  return writeFileAtomically(path, text);
}

} // namespace esm
