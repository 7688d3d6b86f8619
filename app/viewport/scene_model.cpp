// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/viewport/scene_model.h"

#include "app/viewport/picker.h"
#include "core/geometry/extent.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace esm {

namespace {

constexpr double kPickRadius = 12.0; ///< [pixels]

constexpr std::pair<Colouring, const char*> kColouringNames[] = {{Colouring::None, "none"},
                                                                 {Colouring::Stiffness, "stiffness"},
                                                                 {Colouring::Strain, "strain"},
                                                                 {Colouring::Force, "force"},
                                                                 {Colouring::RegionWeight, "region_weight"}};

/// |l - L| / L of each spring, S [1].
Eigen::ArrayXd strains(const SpringNet& net, const Eigen::Matrix3Xd& position)
{
  Eigen::ArrayXd strain(net.springCount());
  for (Index s = 0; s < net.springCount(); ++s) {
    const double rest = net.restLength(s);
    const double length = (position.col(net.ends(1, s)) - position.col(net.ends(0, s))).norm();
    strain(s) = rest > 0.0 ? std::abs(length - rest) / rest : std::numeric_limits<double>::quiet_NaN();
  }
  return strain;
}

double largest(const Eigen::ArrayXd& values)
{
  double result = 0.0;
  for (const double value : values)
    if (value > result) result = value; // false for NaN
  return result;
}

} // namespace

QString colouringName(Colouring colouring)
{
  for (const auto& [value, name] : kColouringNames)
    if (value == colouring) return QString::fromLatin1(name);
  return QStringLiteral("none");
}

Colouring colouringFromName(const std::string& name)
{
  for (const auto& [value, known] : kColouringNames)
    if (name == known) return value;
  return Colouring::None;
}

bool SceneModel::setNet(std::shared_ptr<const SpringNet> net, std::uint64_t generation)
{
  m_net = std::move(net);
  m_generation = generation;
  m_sequence = m_revision = 0;
  m_time = m_largest = 0.0;
  m_grabbed = kNoIndex;
  m_grip.setNet(m_net);
  m_position = m_net ? m_net->restPosition : Eigen::Matrix3Xd(3, 0);
  m_tension = Eigen::ArrayXd::Zero(m_net ? m_net->springCount() : 0);
  m_strainRange.reset();
  m_forceRange.reset();
  if (m_net) {
    takeStiffness();
    const Eigen::AlignedBox3d box = boxOf(m_net->restPosition);
    m_origin = box.isEmpty() ? Eigen::Vector3d::Zero() : Eigen::Vector3d(box.center());
  }
  m_selection.clear();
  weighSprings();
  dirty = {};
  updateBounds();
  if (m_autoFit) fit();
  return true;
}

bool SceneModel::setSnapshot(const SimSnapshot& snapshot)
{
  if (!m_net || snapshot.generation != m_generation || snapshot.position.cols() != m_position.cols() ||
      snapshot.sequence == m_sequence)
    return false;
  m_sequence = snapshot.sequence;
  const bool isKnown = snapshot.revision != 0 && snapshot.revision == m_revision;
  const bool fits = snapshot.tension.size() == m_tension.size();
  const bool moved =
    !isKnown && !(snapshot.position == m_position && (!fits || (snapshot.tension == m_tension).all()));
  const double elapsed = snapshot.time - m_time;
  const Index wasGrabbed = m_grabbed;
  const ValueRange before = valueRange();
  if (elapsed < 0.0) { // started again from t = 0
    m_strainRange.reset();
    m_forceRange.reset();
  }
  m_time = snapshot.time;
  m_revision = snapshot.revision;
  m_grabbed =
    snapshot.grabbedNode >= 0 && snapshot.grabbedNode < m_net->nodeCount() ? snapshot.grabbedNode : kNoIndex;
  std::vector<Index> held = m_grabbed != kNoIndex ? snapshot.heldNodes : std::vector<Index>();
  std::erase_if(held, [this](Index node) { return node < 0 || node >= m_net->nodeCount(); });
  if (held != m_grip.heldNodes() || m_grabbed != m_grip.heldNode())
    m_grip.hold(m_position, m_grabbed, held); // as the net lay before the hand moved it
  if (moved) {
    m_position = snapshot.position;
    if (fits) m_tension = snapshot.tension;
    updateBounds();
  }
  if (SteadyRange* range = movingRange()) {
    if (moved) m_largest = largest(springValues());
    range->add(m_largest, elapsed);
  }
  const bool rescaled = valueRange() != before; // of a net that rests the legend still draws in
  dirty.frame = dirty.frame || moved || rescaled;
  return moved || rescaled || m_grabbed != wasGrabbed;
}

bool SceneModel::letGo()
{
  if (m_grabbed == kNoIndex) return false;
  m_grabbed = kNoIndex;
  m_grip.hold(m_position, kNoIndex, {});
  return true;
}

bool SceneModel::setParameters(std::shared_ptr<const SpringNet> net)
{
  if (!net || !m_net || net->nodeCount() != m_net->nodeCount() || net->springCount() != m_net->springCount())
    return false;
  m_net = std::move(net);
  takeStiffness();
  return true;
}

bool SceneModel::setParameters(const ParameterPatch& patch)
{
  if (!m_net || patch.springs.empty()) return false;
  for (const ParameterPatch::Spring& spring : patch.springs) m_stiffness[spring.spring] = spring.stiffness;
  m_stiffnessRange = logRange(m_stiffness);
  dirty.frame = true;
  return true;
}

void SceneModel::takeStiffness()
{
  m_stiffness = m_net->stiffness;
  m_stiffnessRange = logRange(m_stiffness);
  dirty.frame = true;
}

bool SceneModel::setRegions(const std::vector<Region>& regions, int selected)
{
  m_regions = regions;
  m_selectedRegion = selected;
  dirty.regions = true;
  weighSprings();
  updateBounds();
  return true;
}

const Region* SceneModel::chosenRegion() const noexcept
{
  const bool there = m_selectedRegion >= 0 && static_cast<std::size_t>(m_selectedRegion) < m_regions.size();
  return there ? &m_regions[static_cast<std::size_t>(m_selectedRegion)] : nullptr;
}

const Region* SceneModel::gizmoRegion() const noexcept
{
  const Region* region = chosenRegion();
  return region != nullptr && region->visible && !region->locked ? region : nullptr;
}

bool SceneModel::setSelection(std::vector<Index> nodes)
{
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  std::erase_if(nodes, [this](Index node) { return node < 0 || node >= m_position.cols(); });
  if (nodes == m_selection) return false;
  m_selection = std::move(nodes);
  dirty.selection = true;
  return true;
}

/// Weights belong to places at rest, as the tissue does.
void SceneModel::weighSprings()
{
  if (m_colouring != Colouring::RegionWeight || !m_net) return;
  m_weight.setConstant(m_net->springCount(), std::numeric_limits<double>::quiet_NaN());
  dirty.frame = true;
  const Region* region = chosenRegion();
  if (region == nullptr) return;
  const RegionShape shape(*region);
  for (Index s = 0; s < m_net->springCount(); ++s)
    m_weight(s) = shape.weight(
      0.5 * (m_net->restPosition.col(m_net->ends(0, s)) + m_net->restPosition.col(m_net->ends(1, s))));
}

bool SceneModel::setColouring(Colouring colouring)
{
  if (colouring == m_colouring) return false;
  m_colouring = colouring;
  m_strainRange.reset();
  m_forceRange.reset();
  weighSprings();
  if (SteadyRange* range = movingRange()) {
    m_largest = largest(springValues());
    range->add(m_largest, 0.0);
  }
  dirty.frame = true;
  return true;
}

bool SceneModel::setMarks(const Eigen::Matrix3Xd& places)
{
  if (m_marks.cols() == 0 && places.cols() == 0) return false;
  m_marks = places;
  return true;
}

bool SceneModel::setInstrument(const Instrument& instrument)
{
  constexpr double kLeast = 2e-5; // [m]; a resting hand trembles by less
  const Instrument& old = m_instrument;
  const bool same =
    instrument.visible == old.visible &&
    (!instrument.visible ||
     (instrument.touches == old.touches && instrument.workspace.isApprox(old.workspace) &&
      (instrument.hand - old.hand).norm() < kLeast && (instrument.tip - old.tip).norm() < kLeast));
  if (!same) m_instrument = instrument;
  return !same;
}

bool SceneModel::setShown(bool surface, bool springs, bool struts)
{
  if (surface == m_surface && springs == m_springs && struts == m_struts) return false;
  m_surface = surface;
  m_springs = springs;
  m_struts = struts;
  return true;
}

void SceneModel::setViewport(double width, double height)
{
  camera.setViewport(width, height);
  if (m_autoFit) fit();
}

bool SceneModel::setCovered(double right)
{
  if (right == camera.covered()) return false;
  camera.setCovered(right);
  if (m_autoFit) fit();
  return true;
}

void SceneModel::fit()
{
  m_autoFit = true;
  if (m_net) camera.fit(m_net->restPosition);
}

ViewSettings SceneModel::viewSettings() const
{
  ViewSettings settings;
  if (!m_autoFit) {
    settings.target = camera.target();
    settings.distance = camera.distance();
  }
  settings.azimuth = camera.azimuth();
  settings.elevation = camera.elevation();
  settings.colouring = colouringName(m_colouring).toStdString();
  settings.showSurface = m_surface;
  settings.showSprings = m_springs;
  settings.showStruts = m_struts;
  return settings;
}

void SceneModel::setViewSettings(const ViewSettings& settings)
{
  camera.setPose(settings.target, settings.distance, settings.azimuth, settings.elevation);
  m_autoFit = !(settings.distance > 0.0);
  if (m_autoFit) fit();
  setColouring(colouringFromName(settings.colouring));
  setShown(settings.showSurface, settings.showSprings, settings.showStruts);
}

/// The one that follows the motion, if the present colouring does.
SteadyRange* SceneModel::movingRange() noexcept
{
  if (m_colouring == Colouring::Strain) return &m_strainRange;
  return m_colouring == Colouring::Force ? &m_forceRange : nullptr;
}

ValueRange SceneModel::valueRange() const
{
  switch (m_colouring) {
  case Colouring::Stiffness:
    return m_stiffnessRange;
  case Colouring::Strain:
    return m_strainRange.range();
  case Colouring::Force:
    return m_forceRange.range();
  case Colouring::RegionWeight:
    return {0.0, 1.0, false};
  case Colouring::None:
    break;
  }
  return {};
}

Eigen::ArrayXd SceneModel::springValues() const
{
  if (!m_net) return {};
  switch (m_colouring) {
  case Colouring::Stiffness:
    return m_stiffness;
  case Colouring::Strain:
    return strains(*m_net, m_position);
  case Colouring::Force:
    return m_tension.abs();
  case Colouring::RegionWeight:
    return m_weight;
  case Colouring::None:
    break;
  }
  return {};
}

std::vector<float> SceneModel::springShares() const
{
  const Eigen::ArrayXd values = springValues();
  const ValueRange range = valueRange();
  std::vector<float> shares(static_cast<std::size_t>(values.size()));
  for (Eigen::Index s = 0; s < values.size(); ++s) {
    const double share = range.share(values(s));
    shares[static_cast<std::size_t>(s)] =
      std::isnan(share) ? kNoValue : static_cast<float>(std::clamp(share, 0.0, 1.0));
  }
  return shares;
}

Eigen::Matrix3Xd SceneModel::nodeNormals() const
{
  // The cross product's length is twice the area, so larger triangles weigh more.
  Eigen::Matrix3Xd normal = Eigen::Matrix3Xd::Zero(3, m_position.cols());
  for (Index t = 0; t < m_net->triangleCount(); ++t) {
    const Index a = m_net->triangles(0, t), b = m_net->triangles(1, t), c = m_net->triangles(2, t);
    const Eigen::Vector3d ab = m_position.col(b) - m_position.col(a);
    const Eigen::Vector3d ac = m_position.col(c) - m_position.col(a);
    const Eigen::Vector3d n = ab.cross(ac);
    normal.col(a) += n;
    normal.col(b) += n;
    normal.col(c) += n;
  }
  for (Eigen::Index i = 0; i < normal.cols(); ++i)
    if (const double length = normal.col(i).norm(); length > 0.0) normal.col(i) /= length;
  return normal;
}

std::vector<NodeVertex> SceneModel::nodeVertices() const
{
  std::vector<NodeVertex> vertices;
  if (!m_net) return vertices;
  const Eigen::Matrix3Xd normal = nodeNormals();
  const std::vector<float> shares = springShares();
  std::vector<float> sum(static_cast<std::size_t>(m_position.cols()), 0.0f), count(sum);
  for (std::size_t s = 0; s < shares.size(); ++s) {
    if (shares[s] == kNoValue) continue;
    for (int end = 0; end < 2; ++end) {
      const auto node = static_cast<std::size_t>(m_net->ends(end, static_cast<Eigen::Index>(s)));
      sum[node] += shares[s];
      count[node] += 1.0f;
    }
  }
  vertices.resize(sum.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const auto col = static_cast<Eigen::Index>(i);
    const Eigen::Vector3f relative = (m_position.col(col) - m_origin).cast<float>();
    for (int c = 0; c < 3; ++c) {
      vertices[i].position[c] = relative(c);
      vertices[i].normal[c] = static_cast<float>(normal(c, col));
    }
    vertices[i].value = count[i] > 0.0f ? sum[i] / count[i] : kNoValue;
  }
  return vertices;
}

Index SceneModel::nodeAt(const Eigen::Vector2d& pixel) const
{
  if (!m_net) return kNoIndex;
  static const TriangleMatrix kNone(3, 0);
  return pickNode(camera, m_position, m_surface ? m_net->triangles : kNone, pixel, kPickRadius);
}

/// Edges belong to the surface too, and can be meant without being drawn.
bool SceneModel::isShown(Index spring) const
{
  return m_struts || !isOfSupport(m_net->kind[static_cast<std::size_t>(spring)]);
}

Index SceneModel::springAt(const Eigen::Vector2d& pixel) const
{
  if (!m_net) return kNoIndex;
  static const TriangleMatrix kNone(3, 0);
  const Index spring = pickSpring(camera, m_position, m_net->ends, m_surface ? m_net->triangles : kNone,
                                  pixel, kPickRadius, [this](Index s) { return isShown(s); });
  const Index node = nodeAt(pixel);
  if (spring == kNoIndex || node == kNoIndex) return spring;
  const auto distance = [&](const Eigen::Vector3d& point) {
    return (camera.project(point).pixel - pixel).norm();
  };
  return distance(middleOf(spring)) < distance(m_position.col(node)) ? spring : kNoIndex;
}

Eigen::Vector3d SceneModel::middleOf(Index spring) const
{
  return 0.5 * (m_position.col(m_net->ends(0, spring)) + m_position.col(m_net->ends(1, spring)));
}

std::vector<Index> SceneModel::nodesIn(const Eigen::AlignedBox2d& pixels) const
{
  if (!m_net) return {};
  static const TriangleMatrix kNone(3, 0);
  return nodesInBox(camera, m_position, m_surface ? m_net->triangles : kNone, pixels);
}

void SceneModel::updateBounds()
{
  Eigen::AlignedBox3d box = boxOf(m_position);
  const auto extendBy = [&box](const Ellipsoid& ellipsoid) {
    constexpr double kSpines = 1.2; // of an inside-out one stand over
    const Eigen::Vector3d reach = Eigen::Vector3d::Constant(kSpines * ellipsoid.semiAxes.maxCoeff());
    if (!ellipsoid.centre.allFinite() || !reach.allFinite()) return;
    box.extend(Eigen::Vector3d(ellipsoid.centre - reach));
    box.extend(Eigen::Vector3d(ellipsoid.centre + reach));
  };
  for (const Region& region : m_regions) {
    if (!region.visible) continue;
    extendBy(region.ellipsoid);
    if (region.mirror) extendBy(mirrored(region.ellipsoid, *region.mirror));
  }
  if (box.isEmpty()) return;
  m_radius = std::max(box.diagonal().norm() / 2.0, 1e-6);
  camera.setScene(box.center(), 1.05 * m_radius);
}

} // namespace esm
