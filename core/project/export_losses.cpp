// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/project/frame_writers.h"

#include <algorithm>

namespace esm {

namespace {

template <class Values, class Predicate>
Index countOf(const Values& values, const Predicate& predicate)
{
  return static_cast<Index>(std::count_if(values.begin(), values.end(), predicate));
}

bool isSet(std::uint8_t flag)
{
  return flag != 0;
}

/// "3 anchors", "1 anchor"
std::string counted(Index count, const std::string& what)
{
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

/// What a format of linear springs between masses has no place for.
std::vector<std::string> lostInLinearSprings(const Frame& frame)
{
  const SpringNet& net = *frame.net;
  std::vector<std::string> lost;
  const auto tell = [&lost](Index count, const std::string& what, const std::string& instead) {
    if (count > 0) lost.push_back("the " + counted(count, what) + "; " + instead);
  };
  tell(net.anchors.count(), "anchor", "nothing holds these nodes to their places");
  tell(static_cast<Index>(net.pressure.size()), "closed surface under pressure", "nothing keeps its volume");
  tell(countOf(net.law, [](SpringLaw law) { return law != SpringLaw::Linear; }), "nonlinear spring law",
       "these springs become linear, as they are for small strains");
  tell(countOf(net.tensionOnly, isSet), "tension-only flag", "these springs also push");
  if (frame.loads) {
    tell(static_cast<Index>(frame.loads->forces.size()), "force", "nothing pulls");
    tell(static_cast<Index>(frame.loads->motions.size()), "motion", "these nodes move freely");
  }
  return lost;
}

bool hasDamping(const SpringNet& net)
{
  return net.massDamping.size() > 0 && (net.massDamping != 0.0).any();
}

} // namespace

bool isUniform(const Eigen::ArrayXd& values)
{
  return values.size() == 0 || (values == values[0]).all();
}

std::vector<std::string> lostInExport(const Frame& frame, const std::filesystem::path& path)
{
  const SpringNet& net = *frame.net;
  const std::string ending = path.extension().string();
  const bool holdsSprings = ending == ".scn" || ending == ".xsp";
  if (holdsSprings) {
    std::vector<std::string> lost = lostInLinearSprings(frame);
    if (hasDamping(net) && (ending == ".xsp" || !isUniform(net.massDamping)))
      lost.push_back("the damping of the masses");
    if (ending == ".xsp" && net.triangleCount() > 0)
      lost.push_back("the " + counted(net.triangleCount(), "triangle") + " of the surface");
    return lost;
  }
  if (ending == ".obj" || ending == ".glb" || ending == ".gltf")
    return {"masses, fixed nodes, anchors, pressure, the springs' numbers and loads: it is the shape alone"};
  if (ending == ".stl") {
    std::vector<std::string> lost{
      "masses, fixed nodes, anchors, pressure, springs and loads: it is the surface alone"};
    if (const auto struts = static_cast<Index>(springsWithoutTriangle(net).size()); struts > 0)
      lost.push_back("the " + counted(struts, "spring") + " that are no triangle's edge");
    return lost;
  }
  if (ending == ".ply" || ending == ".vtu" || ending == ".csv")
    return {"spring laws, anchors, pressure and loads"};
  return {};
}

} // namespace esm
