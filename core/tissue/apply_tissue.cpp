// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/net/net_builder.h"
#include "core/tissue/tissue_model.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace esm {

namespace {

/// Section of a line that has no surface to take its share from: a round cord as thick as the wall [m^2].
double cordSection(const TissueModel& model)
{
  return std::numbers::pi / 4.0 * model.thickness * model.thickness;
}

/// Section of a line between two nodes [m^2]: the mean of their dual areas, where only one end lies on the
/// surface that one's, else a cord.
double lineSection(double areaA, double areaB, const TissueModel& model)
{
  if (areaA > 0.0 && areaB > 0.0) return 0.5 * (areaA + areaB);
  const double area = std::max(areaA, areaB);
  return area > 0.0 ? area : cordSection(model);
}

class TissueWriter {
public:
  TissueWriter(const TissueModel& model, const TissueField& field, SpringNet& net)
    : m_model(model),
      m_field(field),
      m_net(net),
      m_dualAreas(nodeDualAreas(net)),
      m_edgeAreas(edgeTriangleAreas(net))
  {}

  ApplyReport write()
  {
    resizeArrays();
    for (Index s = 0; s < m_net.springCount(); ++s) writeSpring(s);
    if (m_net.springCount() == 0) m_report.minYoungsModulus = 0.0;
    writeMasses();
    writeAnchors();
    m_report.springsChanged = m_net.springCount();
    m_report.nodesChanged = m_net.nodeCount();
    m_report.totalMass = m_net.mass.sum();
    return m_report;
  }

  bool surfaceHasArea() const { return m_net.triangleCount() == 0 || m_dualAreas.sum() > 0.0; }

private:
  void resizeArrays()
  {
    const Index springs = m_net.springCount();
    m_net.stiffness.resize(springs);
    m_net.viscosity.resize(springs);
    m_net.law.assign(static_cast<std::size_t>(springs), m_model.law);
    m_net.lawParameter = Eigen::ArrayXd::Constant(springs, m_model.lawParameter);
    m_net.mass.resize(m_net.nodeCount());
  }

  double section(Index s) const
  {
    return lineSection(m_dualAreas[m_net.ends(0, s)], m_dualAreas[m_net.ends(1, s)], m_model);
  }

  void writeSpring(Index s)
  {
    const Eigen::Vector3d middle =
      0.5 * (m_net.restPosition.col(m_net.ends(0, s)) + m_net.restPosition.col(m_net.ends(1, s)));
    const TissueParameters tissue = m_field.at(middle);
    const double length = m_net.restLength[s];
    const double modulus = tissue.youngsModulus;
    const bool isEdge = m_net.kind[static_cast<std::size_t>(s)] == SpringKind::Edge;
    m_net.stiffness[s] = !(length > 0.0) ? 0.0
                         : isEdge        ? modulus * m_model.thickness * m_edgeAreas[s] / (length * length)
                                         : modulus * section(s) / length;
    m_net.viscosity[s] = tissue.viscosity * m_net.stiffness[s];
    m_report.minYoungsModulus = std::min(m_report.minYoungsModulus, modulus);
    m_report.maxYoungsModulus = std::max(m_report.maxYoungsModulus, modulus);
  }

  void writeMasses()
  {
    m_net.mass = m_model.density * m_model.thickness * m_dualAreas;
    // Off the surface a node carries half of each of its lines.
    for (Index s = 0; s < m_net.springCount(); ++s)
      for (int end = 0; end < 2; ++end) {
        const Index node = m_net.ends(end, s);
        if (m_dualAreas[node] > 0.0) continue;
        m_net.mass[node] += 0.5 * m_model.density * section(s) * m_net.restLength[s];
      }
    double least = std::numeric_limits<double>::infinity();
    for (const double mass : m_net.mass)
      if (mass > 0.0) least = std::min(least, mass);
    if (std::isinf(least)) least = m_model.density * std::pow(m_model.thickness, 3.0); // only lone nodes
    for (double& mass : m_net.mass)
      if (!(mass > 0.0)) mass = least;
  }

  void writeAnchors()
  {
    AnchorSet anchors;
    std::vector<double> stiffness, viscosity;
    for (Index node = 0; node < m_net.nodeCount(); ++node) {
      if (!(m_dualAreas[node] > 0.0)) continue;
      const TissueParameters tissue = m_field.at(m_net.restPosition.col(node));
      const double k = tissue.anchoring * m_dualAreas[node];
      if (!(k > 0.0)) continue;
      anchors.node.push_back(node);
      stiffness.push_back(k);
      viscosity.push_back(tissue.viscosity * k);
    }
    const auto count = static_cast<Eigen::Index>(anchors.node.size());
    anchors.point.resize(3, count);
    for (Eigen::Index a = 0; a < count; ++a)
      anchors.point.col(a) = m_net.restPosition.col(anchors.node[static_cast<std::size_t>(a)]);
    anchors.stiffness = Eigen::Map<Eigen::ArrayXd>(stiffness.data(), count);
    anchors.viscosity = Eigen::Map<Eigen::ArrayXd>(viscosity.data(), count);
    m_net.anchors = std::move(anchors);
  }

  const TissueModel& m_model;
  const TissueField& m_field;
  SpringNet& m_net;
  const Eigen::ArrayXd m_dualAreas, m_edgeAreas;
  ApplyReport m_report{0, 0, std::numeric_limits<double>::infinity(), 0.0, 0.0};
};

} // namespace

Result<ApplyReport> applyTissue(const TissueModel& model, SpringNet& net)
{
  const auto field = TissueField::create(model);
  if (!field) return field.error();
  TissueWriter writer(model, *field, net);
  if (!writer.surfaceHasArea())
    return Error{
      ErrorCode::InvalidValue,
      "the surface has triangles but no area, so that its tissue has no mass; import the mesh with "
      "a smaller weld tolerance or the right unit"};
  return writer.write();
}

} // namespace esm
