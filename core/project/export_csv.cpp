// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/file_io.h"
#include "core/base/text_number.h"
#include "core/project/frame_writers.h"

namespace esm {

namespace {

void appendCell(std::string& text, double value)
{
  text += ',';
  appendDouble(text, value);
}

std::string nodeTable(const Frame& frame)
{
  const SpringNet& net = *frame.net;
  std::string text = "id,x,y,z,mass,fixed\n";
  for (Index node = 0; node < net.nodeCount(); ++node) {
    const auto place = static_cast<std::size_t>(node);
    text += std::to_string(static_cast<Index>(net.nodeId[place]));
    for (int k = 0; k < 3; ++k) appendCell(text, (*frame.position)(k, node));
    appendCell(text, net.mass[node]);
    text += net.fixed[place] ? ",1\n" : ",0\n";
  }
  return text;
}

std::string springTable(const Frame& frame)
{
  const SpringNet& net = *frame.net;
  const Eigen::ArrayXd strain = springStrains(frame);
  const auto nodeId = [&](Index node) {
    return std::to_string(static_cast<Index>(net.nodeId[static_cast<std::size_t>(node)]));
  };
  std::string text = "id,a,b,rest,stiffness,damping,strain,force\n";
  for (Index s = 0; s < net.springCount(); ++s) {
    text += std::to_string(static_cast<Index>(net.springId[static_cast<std::size_t>(s)]));
    text += "," + nodeId(net.ends(0, s)) + "," + nodeId(net.ends(1, s));
    for (const double value : {net.restLength[s], net.stiffness[s], net.viscosity[s], strain[s]})
      appendCell(text, value);
    if (frame.tension)
      appendCell(text, (*frame.tension)[s]);
    else
      text += ','; // unknown, not zero
    text += '\n';
  }
  return text;
}

} // namespace

/// Two tables over ids: NAME.csv for the nodes, NAME_springs.csv for the springs. SI units.
Status writeCsv(const Frame& frame, const std::filesystem::path& path)
{
  const auto springs = path.parent_path() / (path.stem().string() + "_springs.csv");
  if (Status status = writeFileAtomically(springs, springTable(frame)); !status) return status;
  return writeFileAtomically(path, nodeTable(frame));
}

} // namespace esm
