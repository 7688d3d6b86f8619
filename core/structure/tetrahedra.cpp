// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/file_io.h"
#include "core/base/text_number.h"
#include "core/net/solid_net.h"
#include "core/structure/child_program.h"
#include "core/structure/support_parts.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>

namespace esm::support {

namespace {

/// Reads white-spaced numbers one after the other; `#` begins a comment.
class Numbers {
public:
  explicit Numbers(std::string_view text) : m_rest(text) {}
  std::string_view word()
  {
    for (;;) {
      while (!m_rest.empty() && static_cast<unsigned char>(m_rest.front()) <= ' ') m_rest.remove_prefix(1);
      if (m_rest.empty() || m_rest.front() != '#') break;
      m_rest.remove_prefix(std::min(m_rest.find('\n'), m_rest.size()));
    }
    std::size_t end = 0;
    while (end < m_rest.size() && static_cast<unsigned char>(m_rest[end]) > ' ') ++end;
    const std::string_view found = m_rest.substr(0, end);
    m_rest.remove_prefix(end);
    return found;
  }
  double number()
  {
    const auto value = parseDouble(word());
    m_good = m_good && value.has_value() && std::isfinite(*value);
    return m_good ? *value : 0.0;
  }
  /// A count or index below `limit`.
  Index whole(double limit)
  {
    const double value = number();
    m_good = m_good && value >= 0.0 && value < limit && value == std::floor(value);
    return m_good ? static_cast<Index>(value) : 0;
  }
  void skipTo(std::string_view section)
  {
    const std::size_t place = m_rest.find(section);
    m_good = m_good && place != std::string_view::npos;
    m_rest.remove_prefix(m_good ? place + section.size() : m_rest.size());
  }
  bool good() const noexcept { return m_good; }

private:
  std::string_view m_rest;
  bool m_good = true;
};

constexpr double kMostNodes = 1e8;

/// What a program has made: its own nodes, and tetrahedra over them.
struct Filling {
  Eigen::Matrix3Xd nodes{3, 0};
  TetrahedronMatrix tetrahedra{4, 0};
};

Error unreadable(const std::string& program)
{
  return {ErrorCode::Numerics,
          "the program " + program +
            " ended well but left no tetrahedra that could be read; repair the surface, or "
            "choose struts"};
}

std::string row(const Eigen::Vector3d& p)
{
  return formatDouble(p[0]) + " " + formatDouble(p[1]) + " " + formatDouble(p[2]) + "\n";
}

Result<Filling> byTetgen(const Eigen::Matrix3Xd& places, const TriangleMatrix& triangles,
                         const SupportOptions& options, WorkControl* control)
{
  const ScratchFolder folder;
  std::string text =
    "OFF\n" + std::to_string(places.cols()) + " " + std::to_string(triangles.cols()) + " 0\n";
  for (Eigen::Index i = 0; i < places.cols(); ++i) text += row(places.col(i));
  for (Eigen::Index t = 0; t < triangles.cols(); ++t)
    text += "3 " + std::to_string(triangles(0, t)) + " " + std::to_string(triangles(1, t)) + " " +
            std::to_string(triangles(2, t)) + "\n";
  if (Status status = writeFileAtomically(folder.path() / "body.off", text); !status) return status.error();
  if (Status status = runProgram({"tetgen", "-pYQ", "body.off"}, folder.path(), options.timeLimit, control);
      !status)
    return status.error();
  const auto nodes = readFile(folder.path() / "body.1.node"),
             elements = readFile(folder.path() / "body.1.ele");
  if (!nodes || !elements) return unreadable("tetgen");

  Filling filling;
  Numbers node(*nodes);
  const Index count = node.whole(kMostNodes);
  node.word(), node.word(), node.word(); // dimension 3, no attributes, no marks
  if (!node.good() || static_cast<double>(count) > static_cast<double>(nodes->size()))
    return unreadable("tetgen");
  filling.nodes.resize(3, count);
  for (Index i = 0; i < count; ++i) {
    node.word();
    for (int k = 0; k < 3; ++k) filling.nodes(k, i) = node.number();
  }
  Numbers element(*elements);
  const Index tetrahedra = element.whole(kMostNodes);
  element.word(), element.word(); // 4 corners, no attributes
  if (!element.good() || static_cast<double>(tetrahedra) > static_cast<double>(elements->size()))
    return unreadable("tetgen");
  filling.tetrahedra.resize(4, tetrahedra);
  for (Index t = 0; t < tetrahedra; ++t) {
    element.word();
    for (int k = 0; k < 4; ++k) filling.tetrahedra(k, t) = element.whole(count);
  }
  if (!node.good() || !element.good()) return unreadable("tetgen");
  return filling;
}

Result<Filling> byGmsh(const Eigen::Matrix3Xd& places, const TriangleMatrix& triangles,
                       const SupportOptions& options, WorkControl* control)
{
  const ScratchFolder folder;
  std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" + std::to_string(places.cols()) + "\n";
  for (Eigen::Index i = 0; i < places.cols(); ++i) text += std::to_string(i + 1) + " " + row(places.col(i));
  text += "$EndNodes\n$Elements\n" + std::to_string(triangles.cols()) + "\n";
  for (Eigen::Index t = 0; t < triangles.cols(); ++t)
    text += std::to_string(t + 1) + " 2 2 1 1 " + std::to_string(triangles(0, t) + 1) + " " +
            std::to_string(triangles(1, t) + 1) + " " + std::to_string(triangles(2, t) + 1) + "\n";
  text += "$EndElements\n";
  const std::string geometry = "Merge \"body.msh\";\nSurface Loop(1) = {1};\nVolume(1) = {1};\n";
  if (Status status = writeFileAtomically(folder.path() / "body.msh", text); !status) return status.error();
  if (Status status = writeFileAtomically(
        folder.path() / "body.geo",
        "Merge \"body.msh\";\nSurface Loop(1) = {1};\nVolume(1) = {1};\nMesh.SaveAll = 1;\n");
      !status)
    return status.error();
  if (Status status = runProgram({"gmsh", "-3", "-format", "msh22", "-o", "filled.msh", "body.geo"},
                                 folder.path(), options.timeLimit, control);
      !status)
    return status.error();
  const auto content = readFile(folder.path() / "filled.msh");
  if (!content) return unreadable("gmsh");

  Filling filling;
  Numbers numbers(*content);
  numbers.skipTo("$Nodes");
  const Index count = numbers.whole(kMostNodes);
  if (!numbers.good() || static_cast<double>(count) > static_cast<double>(content->size()))
    return unreadable("gmsh");
  filling.nodes.resize(3, count);
  std::map<Index, Index> placeOf;
  for (Index i = 0; i < count; ++i) {
    const Index tag = numbers.whole(2e9);
    placeOf[tag] = i;
    for (int k = 0; k < 3; ++k) filling.nodes(k, i) = numbers.number();
    // It writes a digit less than a number has: the surface's nodes are given their own places back.
    if (tag >= 1 && tag <= places.cols() &&
        (filling.nodes.col(i) - places.col(tag - 1)).norm() <= 1e-12 * places.cwiseAbs().maxCoeff())
      filling.nodes.col(i) = places.col(tag - 1);
  }
  numbers.skipTo("$Elements");
  const Index elements = numbers.whole(kMostNodes);
  std::vector<std::array<Index, 4>> found;
  for (Index e = 0; e < elements && numbers.good(); ++e) {
    numbers.word();
    const Index type = numbers.whole(1000), tags = numbers.whole(1000);
    for (Index tag = 0; tag < tags; ++tag) numbers.word();
    const Index corners = type == 15 ? 1 : type == 1 ? 2 : type == 2 ? 3 : type == 4 ? 4 : 0;
    if (corners == 0) return unreadable("gmsh");
    std::array<Index, 4> corner{};
    for (Index k = 0; k < corners; ++k) {
      const auto place = placeOf.find(numbers.whole(2e9));
      if (place == placeOf.end()) return unreadable("gmsh");
      corner[static_cast<std::size_t>(k)] = place->second;
    }
    if (corners == 4) found.push_back(corner);
  }
  if (!numbers.good()) return unreadable("gmsh");
  filling.tetrahedra.resize(4, static_cast<Eigen::Index>(found.size()));
  for (std::size_t t = 0; t < found.size(); ++t)
    for (std::size_t k = 0; k < 4; ++k)
      filling.tetrahedra(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(t)) = found[t][k];
  return filling;
}

double volumeOf(const Filling& filling, Eigen::Index t)
{
  const Eigen::Vector3d a = filling.nodes.col(filling.tetrahedra(0, t));
  const Eigen::Vector3d u = filling.nodes.col(filling.tetrahedra(1, t)) - a,
                        v = filling.nodes.col(filling.tetrahedra(2, t)) - a,
                        w = filling.nodes.col(filling.tetrahedra(3, t)) - a;
  return std::abs(u.cross(v).dot(w)) / 6.0;
}

/// The net's node for each of the filling's, new ones numbered on; the filling must fill the surface and keep
/// it.
Result<Layer> layerOf(const SpringNet& net, const std::vector<Index>& nodeOfPlace,
                      const Eigen::Matrix3Xd& places, const OutwardSurface& surface, const Filling& filling,
                      const std::string& program)
{
  const auto wrong = [&](const std::string& what) {
    return Error{ErrorCode::Numerics, "the program " + program + " ended well but " + what +
                                        "; repair the surface, or choose struts"};
  };
  double volume = 0.0;
  for (Eigen::Index t = 0; t < filling.tetrahedra.cols(); ++t) volume += volumeOf(filling, t);
  if (filling.tetrahedra.cols() == 0 || !(std::abs(volume - surface.volume()) <= 1e-6 * surface.volume()))
    return wrong("its tetrahedra fill " + formatDouble(100.0 * volume / surface.volume(), 3) +
                 " % of the body");

  std::map<std::array<double, 3>, Index> surfaceNode;
  for (std::size_t i = 0; i < nodeOfPlace.size(); ++i) {
    const Eigen::Vector3d p = places.col(static_cast<Eigen::Index>(i));
    surfaceNode.emplace(std::array{p[0], p[1], p[2]}, nodeOfPlace[i]);
  }
  std::vector<std::uint8_t> isUsed(static_cast<std::size_t>(filling.nodes.cols()), 0);
  for (Eigen::Index i = 0; i < filling.tetrahedra.size(); ++i)
    isUsed[static_cast<std::size_t>(filling.tetrahedra.data()[i])] = 1;
  Layer layer;
  layer.nodes.resize(3, filling.nodes.cols());
  std::vector<Index> nodeOf(isUsed.size(), kNoIndex);
  Index added = 0;
  std::size_t met = 0;
  for (std::size_t i = 0; i < isUsed.size(); ++i) {
    if (!isUsed[i]) continue;
    const Eigen::Vector3d p = filling.nodes.col(static_cast<Eigen::Index>(i));
    if (const auto found = surfaceNode.find({p[0], p[1], p[2]}); found != surfaceNode.end()) {
      nodeOf[i] = found->second;
      ++met;
    } else {
      layer.nodes.col(added) = p;
      nodeOf[i] = net.nodeCount() + added++;
    }
  }
  if (met != surfaceNode.size()) return wrong("it changed the surface");
  layer.nodes.conservativeResize(Eigen::NoChange, added);
  layer.volume.setZero(added);

  layer.tetrahedra =
    filling.tetrahedra.unaryExpr([&](Index node) { return nodeOf[static_cast<std::size_t>(node)]; });
  JoinedPairs joined(net);
  for (Eigen::Index t = 0; t < layer.tetrahedra.cols(); ++t)
    for (int i = 0; i < 4; ++i)
      for (int j = i + 1; j < 4; ++j) {
        const Index a = layer.tetrahedra(i, t), b = layer.tetrahedra(j, t);
        if (joined.join(a, b)) layer.struts.push_back({a, b, 0.0});
      }
  return layer;
}

} // namespace

Result<Layer> makeTetrahedra(const SpringNet& net, const SupportOptions& options, WorkControl* control)
{
  const OutwardSurface surface(net, control);
  if (stopWanted(control)) return cancelledError();
  const bool isClean = std::all_of(surface.parts().begin(), surface.parts().end(),
                                   [](const auto& part) { return part.isClosed && part.isOriented; });
  if (!isClean || !(surface.volume() > 0.0))
    return Error{ErrorCode::InvalidValue,
                 "tetrahedra need a closed surface without edges of three triangles; repair it, "
                 "or choose struts"};
  // The surface's own nodes, numbered anew.
  std::vector<Index> nodeOfPlace, placeOf(static_cast<std::size_t>(net.nodeCount()), kNoIndex);
  for (Eigen::Index i = 0; i < net.triangles.size(); ++i) {
    const Index node = net.triangles.data()[i];
    Index& place = placeOf[static_cast<std::size_t>(node)];
    if (place != kNoIndex) continue;
    place = static_cast<Index>(nodeOfPlace.size());
    nodeOfPlace.push_back(node);
  }
  Eigen::Matrix3Xd places(3, static_cast<Eigen::Index>(nodeOfPlace.size()));
  for (std::size_t i = 0; i < nodeOfPlace.size(); ++i)
    places.col(static_cast<Eigen::Index>(i)) = net.restPosition.col(nodeOfPlace[i]);
  const TriangleMatrix triangles =
    surface.triangles().unaryExpr([&](Index node) { return placeOf[static_cast<std::size_t>(node)]; });

  std::string program = options.program;
  if (program.empty()) program = isInPath("tetgen") || !isInPath("gmsh") ? "tetgen" : "gmsh";
  if (program != "tetgen" && program != "gmsh")
    return Error{ErrorCode::InvalidValue, "the program for tetrahedra is tetgen or gmsh, not " + program};
  const Result<Filling> filling = program == "tetgen" ? byTetgen(places, triangles, options, control)
                                                      : byGmsh(places, triangles, options, control);
  if (!filling) return filling.error();
  return layerOf(net, nodeOfPlace, places, surface, *filling, program);
}

} // namespace esm::support
