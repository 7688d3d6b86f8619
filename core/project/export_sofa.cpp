// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/file_io.h"
#include "core/base/text_number.h"
#include "core/project/frame_writers.h"

namespace esm {

namespace {

constexpr const char* kPlugins[] = {"Sofa.Component.Constraint.Projective",
                                    "Sofa.Component.LinearSolver.Iterative",
                                    "Sofa.Component.Mass",
                                    "Sofa.Component.ODESolver.Backward",
                                    "Sofa.Component.SolidMechanics.Spring",
                                    "Sofa.Component.StateContainer",
                                    "Sofa.Component.Topology.Container.Constant"};

void appendNumber(std::string& text, double value)
{
  appendDouble(text, value);
}
void appendNumber(std::string& text, Index value)
{
  text += std::to_string(value);
}

/// The numbers with blanks between them.
template <class Number>
std::string listOf(const Number* values, Eigen::Index count)
{
  std::string text;
  for (Eigen::Index i = 0; i < count; ++i) {
    if (i > 0) text += ' ';
    appendNumber(text, values[i]);
  }
  return text;
}
template <class Array>
std::string listOf(const Array& values)
{
  return listOf(values.data(), static_cast<Eigen::Index>(values.size()));
}

std::string fixedNodes(const SpringNet& net)
{
  std::vector<Index> fixed;
  for (Index node = 0; node < net.nodeCount(); ++node)
    if (net.fixed[static_cast<std::size_t>(node)]) fixed.push_back(node);
  return listOf(fixed);
}

/// "m1 m2 ks kd L" for each spring.
std::string springs(const SpringNet& net)
{
  std::string text;
  for (Index s = 0; s < net.springCount(); ++s) {
    text += (s > 0 ? "  " : "") + std::to_string(net.ends(0, s)) + ' ' + std::to_string(net.ends(1, s));
    for (const double value : {net.stiffness[s], net.viscosity[s], net.restLength[s]}) {
      text += ' ';
      appendDouble(text, value);
    }
  }
  return text;
}

/// Attribute by attribute, so that a scene is written in one look.
class Scene {
public:
  Scene& open(const char* element, int depth)
  {
    m_text += std::string(static_cast<std::size_t>(2 * depth), ' ') + "<" + element;
    return *this;
  }
  Scene& with(const char* attribute, const std::string& value)
  {
    m_text += std::string(" ") + attribute + "=\"" + value + "\"";
    return *this;
  }
  void closed() { m_text += "/>\n"; }
  void children() { m_text += ">\n"; }
  void end(const char* element, int depth)
  {
    m_text += std::string(static_cast<std::size_t>(2 * depth), ' ') + "</" + element + ">\n";
  }
  void comment(const std::string& what) { m_text += "<!-- " + what + " -->\n"; }
  const std::string& text() const { return m_text; }

private:
  std::string m_text = "<?xml version=\"1.0\"?>\n";
};

} // namespace

/// A scene for SOFA (from v24.06 on): the net with one entry per spring, masses, fixed nodes and an implicit
/// solver. SI units.
Status writeSofa(const Frame& frame, const std::filesystem::path& path)
{
  const SpringNet& net = *frame.net;
  const Eigen::Vector3d gravity = frame.loads ? frame.loads->gravity : Eigen::Vector3d::Zero();
  const double rayleighMass =
    net.massDamping.size() > 0 && isUniform(net.massDamping) ? net.massDamping[0] : 0.0;
  Scene scene;
  scene.comment("Elastodynamic Shape Modeler: metres, kilograms, seconds, z up");
  for (const std::string& what : lostInExport(frame, path)) scene.comment("not in this scene: " + what);
  scene.open("Node", 0).with("name", "root").with("gravity", listOf(gravity)).with("dt", "0.01").children();
  for (const char* plugin : kPlugins) scene.open("RequiredPlugin", 1).with("name", plugin).closed();
  scene.open("Node", 1).with("name", "net").children();
  scene.open("EulerImplicitSolver", 2)
    .with("rayleighStiffness", "0")
    .with("rayleighMass", formatDouble(rayleighMass))
    .closed();
  scene.open("CGLinearSolver", 2)
    .with("iterations", "200")
    .with("tolerance", "1e-09")
    .with("threshold", "1e-09")
    .closed();
  scene.open("MeshTopology", 2).with("name", "topology").with("position", listOf(*frame.position));
  if (net.triangleCount() > 0) scene.with("triangles", listOf(net.triangles));
  scene.with("edges", listOf(net.ends)).closed();
  scene.open("MechanicalObject", 2)
    .with("name", "state")
    .with("template", "Vec3")
    .with("position", listOf(*frame.position))
    .with("rest_position", listOf(net.restPosition));
  if (frame.velocity) scene.with("velocity", listOf(*frame.velocity));
  scene.closed();
  scene.open("DiagonalMass", 2).with("vertexMass", listOf(net.mass)).closed();
  if (const std::string fixed = fixedNodes(net); !fixed.empty())
    scene.open("FixedProjectiveConstraint", 2).with("indices", fixed).closed();
  scene.open("SpringForceField", 2).with("name", "springs").with("spring", springs(net)).closed();
  scene.end("Node", 1);
  scene.end("Node", 0);
  return writeFileAtomically(path, scene.text());
}

} // namespace esm
