// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/tissue/tissue_derivation.h"

#include "core/base/assert.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace esm {

namespace {

using CompiledRegion = TissueField::CompiledRegion;

bool sameTissue(const CompiledRegion& a, const CompiledRegion& b)
{
  return (a.logs == b.logs).all();
}

bool same(const CompiledRegion& a, const CompiledRegion& b)
{
  return sameTissue(a, b) && a.shape == b.shape;
}

/// What no region can hide: edits after which every spring and node is another.
bool differEverywhere(const TissueModel& a, const TissueModel& b)
{
  const auto isFromRules = [&](double TissueParameters::*value) { return comesFromRules(b.rules, value); };
  return a.thickness != b.thickness || a.law != b.law ||
         (a.density != b.density && !isFromRules(&TissueParameters::density)) ||
         (a.lawParameter != b.lawParameter && !isFromRules(&TissueParameters::stiffening)) ||
         std::any_of(kTissueOutputs.begin(), kTissueOutputs.end(), [&](const TissueOutput& output) {
           return comesFromRules(a.rules, output.value) != isFromRules(output.value);
         });
}

/// Blends place after place, ascending, from remembered weights.
class Blender {
public:
  Blender(const TissueField& field, const std::vector<std::shared_ptr<const Reach>>& reaches)
    : m_field(field), m_reaches(reaches), m_next(reaches.size(), 0)
  {}

  TissueBlend at(Index place)
  {
    TissueBlend blend = m_field.baseBlend();
    for (std::size_t r = 0; r < m_reaches.size(); ++r) {
      const Reach& reach = *m_reaches[r];
      std::size_t& next = m_next[r];
      while (next < reach.place.size() && reach.place[next] < place) ++next;
      if (next < reach.place.size() && reach.place[next] == place)
        blend.cover(static_cast<int>(r), reach.weight[next], m_field.regions()[r].logs);
    }
    return blend;
  }

private:
  const TissueField& m_field;
  const std::vector<std::shared_ptr<const Reach>>& m_reaches;
  std::vector<std::size_t> m_next;
};

/// A mesh that came in a thousand times too small, say: without area there is no mass.
bool surfaceHasArea(const SpringNet& net, const DerivationPlaces& places)
{
  return net.triangleCount() == 0 || places.dualArea.sum() > 0.0;
}

} // namespace

TissueDerivation::TissueDerivation(TissueField field, const SpringNet& net)
  : m_places(net),
    m_field(std::move(field)),
    m_touched(static_cast<std::size_t>(m_places.springs + m_places.nodes), 1),
    m_modulus(m_places.springs),
    m_springDensity(m_places.loose.empty() ? 0 : m_places.springs),
    m_anchoring(Eigen::ArrayXd::Zero(m_places.nodes)),
    m_anchorViscosity(Eigen::ArrayXd::Zero(m_places.nodes)),
    m_anchorOfNode(static_cast<std::size_t>(m_places.nodes), kNoIndex)
{
  for (Index anchor = 0; anchor < net.anchors.count(); ++anchor)
    if (net.anchors.isBand(anchor))
      m_bands.push_back({net.anchors.node[static_cast<std::size_t>(anchor)], net.anchors.point.col(anchor),
                         net.anchors.bandLength[anchor]});
}

Result<TissueDerivation> TissueDerivation::create(const TissueModel& model, SpringNet& net)
{
  auto field = TissueField::create(model);
  if (!field) return field.error();
  TissueDerivation derivation(std::move(*field), net);
  if (!surfaceHasArea(net, derivation.m_places))
    return Error{
      ErrorCode::InvalidValue,
      "the surface has triangles but no area, so that its tissue has no mass; import the mesh with "
      "a smaller weld tolerance or the right unit"};
  net.stiffness.resize(net.springCount());
  net.viscosity.resize(net.springCount());
  net.lawParameter.resize(net.springCount());
  net.mass.resize(net.nodeCount());
  net.law.assign(static_cast<std::size_t>(net.springCount()), model.law);
  derivation.m_places.setThickness(model.thickness, net);
  derivation.m_reaches = derivation.reachesOf(derivation.m_field);
  derivation.deriveTouched(net);
  return derivation;
}

Result<ApplyReport> TissueDerivation::update(const TissueModel& model, SpringNet& net)
{
  auto field = TissueField::create(model);
  if (!field) return field.error();
  return update(std::move(*field), net);
}

const ApplyReport& TissueDerivation::update(TissueField field, SpringNet& net)
{
  ESM_ASSERT(net.springCount() == m_places.springs && net.nodeCount() == m_places.nodes);
  const TissueModel &before = m_field.model(), &model = field.model();
  Reaches reaches = reachesOf(field);
  if (differEverywhere(before, model)) {
    if (before.thickness != model.thickness) m_places.setThickness(model.thickness, net);
    std::fill(net.law.begin(), net.law.end(), model.law);
    std::fill(m_touched.begin(), m_touched.end(), std::uint8_t{1});
  } else {
    markWhatDiffers(field, reaches);
  }
  m_field = std::move(field);
  m_reaches = std::move(reaches);
  deriveTouched(net);
  return m_report;
}

/// Weights of shapes that were there before are not computed again.
TissueDerivation::Reaches TissueDerivation::reachesOf(const TissueField& field) const
{
  Reaches reaches;
  for (const CompiledRegion& region : field.regions()) {
    std::shared_ptr<const Reach> reach;
    for (std::size_t old = 0; old < m_reaches.size() && !reach; ++old)
      if (m_field.regions()[old].shape == region.shape) reach = m_reaches[old];
    reaches.push_back(reach ? reach : std::make_shared<Reach>(reachOf(region.shape, m_places.point)));
  }
  return reaches;
}

/// Old and new regions are laid side by side: the same at the bottom, the same at the top, and between them
/// those that were edited, in pairs if they are as many, else all of them taken away and put there.
void TissueDerivation::markWhatDiffers(const TissueField& field, const Reaches& reaches)
{
  const auto &before = m_field.regions(), &after = field.regions();
  const std::size_t common = std::min(before.size(), after.size());
  std::size_t bottom = 0, top = 0;
  while (bottom < common && same(before[bottom], after[bottom])) ++bottom;
  while (bottom + top < common && same(before[before.size() - 1 - top], after[after.size() - 1 - top])) ++top;

  const bool sameBase = (m_field.baseBlend().logs == field.baseBlend().logs).all();
  std::fill(m_touched.begin(), m_touched.end(), static_cast<std::uint8_t>(sameBase ? 0 : 1));
  for (std::size_t r = 0; r < bottom; ++r) hideUnder(*reaches[r], m_touched);
  const std::size_t beforeEnd = before.size() - top, afterEnd = after.size() - top;
  if (beforeEnd == afterEnd) {
    for (std::size_t r = bottom; r < afterEnd; ++r) {
      if (sameTissue(before[r], after[r])) {
        markMoved(*m_reaches[r], *reaches[r], m_touched);
      } else {
        markAll(*m_reaches[r], m_touched);
        markAll(*reaches[r], m_touched);
      }
    }
  } else {
    for (std::size_t r = bottom; r < beforeEnd; ++r) markAll(*m_reaches[r], m_touched);
    for (std::size_t r = bottom; r < afterEnd; ++r) markAll(*reaches[r], m_touched);
  }
  for (std::size_t r = afterEnd; r < after.size(); ++r) hideUnder(*reaches[r], m_touched);
}

void TissueDerivation::deriveTouched(SpringNet& net)
{
  m_report = {};
  m_anchorsChangePlaces = false;
  m_cubicFromStiffening = cubicFromStiffening(m_field.model());
  deriveSprings(net);
  deriveNodes(net);
  deriveBands();
  deriveAnchors(net);
  if (m_places.springs > 0) {
    m_report.minYoungsModulus = m_modulus.minCoeff();
    m_report.maxYoungsModulus = m_modulus.maxCoeff();
  }
  m_report.totalMass = net.mass.sum();
}

void TissueDerivation::deriveSprings(SpringNet& net)
{
  Blender blender(m_field, m_reaches);
  const unsigned wanted = m_places.loose.empty() ? kSpringParameters : kSpringParameters | kNodeParameters;
  for (Index s = 0; s < m_places.springs; ++s) {
    if (!m_touched[static_cast<std::size_t>(s)]) continue;
    writeSpring(s, m_field.plain(blender.at(s), wanted), net);
    ++m_report.springsChanged;
  }
}

void TissueDerivation::writeSpring(Index spring, const TissueParameters& tissue, SpringNet& net)
{
  const SpringNumbers numbers = springNumbers(tissue, m_places.perModulus[spring], m_cubicFromStiffening);
  net.stiffness[spring] = numbers.stiffness;
  net.viscosity[spring] = numbers.viscosity;
  net.lawParameter[spring] = numbers.lawParameter;
  m_modulus[spring] = tissue.youngsModulus;
  if (!(m_places.section[spring] > 0.0)) return;
  m_springDensity[spring] = tissue.density;
  for (int end = 0; end < 2; ++end) // its mass is theirs
    if (const Index node = net.ends(end, spring);
        m_places.looseOfNode[static_cast<std::size_t>(node)] != kNoIndex)
      m_touched[placeOfNode(node)] = 1;
}

void TissueDerivation::deriveNodes(SpringNet& net)
{
  Blender blender(m_field, m_reaches);
  const double thickness = m_field.model().thickness;
  for (Index node = 0; node < m_places.nodes; ++node) {
    const Index place = m_places.springs + node;
    if (!m_touched[static_cast<std::size_t>(place)]) continue;
    ++m_report.nodesChanged;
    const double area = m_places.dualArea[node], volume = m_places.volumeOf(node);
    if (m_places.hasTissue(node)) {
      const TissueParameters tissue = m_field.plain(blender.at(place), kNodeParameters);
      net.mass[node] = volume > 0.0 ? massOfVolume(tissue, volume) : massOfSurface(tissue, thickness, area);
      const AnchorNumbers anchor = anchorNumbers(tissue, area);
      m_anchorsChangePlaces |= (anchor.stiffness > 0.0) != (m_anchoring[node] > 0.0);
      m_anchoring[node] = anchor.stiffness;
      m_anchorViscosity[node] = anchor.viscosity;
      continue;
    }
    const auto i = static_cast<std::size_t>(m_places.looseOfNode[static_cast<std::size_t>(node)]);
    net.mass[node] = 0.0;
    for (const Index s : m_places.looseSprings[i])
      net.mass[node] += halfMassOfLine(m_springDensity[s], m_places.section[s], net.restLength[s]);
  }
  if (!m_places.loose.empty()) fillLoneMasses(net);
}

/// Nodes to which nothing belongs get the smallest mass of the others, so that nobody divides by zero.
void TissueDerivation::fillLoneMasses(SpringNet& net) const
{
  const auto isLone = [&](Index node) {
    const auto i = static_cast<std::size_t>(m_places.looseOfNode[static_cast<std::size_t>(node)]);
    double volume = 0.0;
    for (const Index s : m_places.looseSprings[i]) volume += m_places.section[s] * net.restLength[s];
    return !(volume > 0.0);
  };
  std::vector<Index> lone;
  std::copy_if(m_places.loose.begin(), m_places.loose.end(), std::back_inserter(lone), isLone);
  for (const Index node : lone) net.mass[node] = std::numeric_limits<double>::infinity();
  const double least = net.mass.size() > 0 ? net.mass.minCoeff() : 0.0;
  for (const Index node : lone)
    net.mass[node] = std::isfinite(least)
                       ? least
                       : m_field.base().density * std::pow(m_field.model().thickness, 3.0); // only lone nodes
}

void TissueDerivation::deriveBands()
{
  for (Band& band : m_bands)
    if (m_touched[placeOfNode(band.node)])
      band.numbers = bandNumbers(m_field.at(m_places.point.col(m_places.springs + band.node)),
                                 m_places.dualArea[band.node], band.length);
}

void TissueDerivation::deriveAnchors(SpringNet& net)
{
  AnchorSet& anchors = net.anchors;
  const auto write = [&](Index anchor, Index node) {
    anchors.stiffness[anchor] = m_anchoring[node];
    anchors.viscosity[anchor] = m_anchorViscosity[node];
  };
  const auto writeBands = [&] {
    Index anchor = anchors.count() - static_cast<Index>(m_bands.size());
    for (const Band& band : m_bands) {
      anchors.stiffness[anchor] = band.numbers.stiffness;
      anchors.viscosity[anchor++] = band.numbers.viscosity;
    }
  };
  const bool isFirst = m_report.nodesChanged == m_places.nodes; // whatever anchors the net brought go
  if (!m_anchorsChangePlaces && !isFirst) {
    for (Index node = 0; node < m_places.nodes; ++node)
      if (const Index anchor = m_anchorOfNode[static_cast<std::size_t>(node)];
          anchor != kNoIndex && m_touched[placeOfNode(node)])
        write(anchor, node);
    writeBands();
    return;
  }
  anchors.node.clear();
  for (Index node = 0; node < m_places.nodes; ++node) {
    const bool isHeld = m_anchoring[node] > 0.0;
    m_anchorOfNode[static_cast<std::size_t>(node)] = isHeld ? anchors.count() : kNoIndex;
    if (isHeld) anchors.node.push_back(node);
  }
  const Index ownAnchors = anchors.count();
  for (const Band& band : m_bands) anchors.node.push_back(band.node);
  anchors.point.resize(3, anchors.count());
  anchors.stiffness.resize(anchors.count());
  anchors.viscosity.resize(anchors.count());
  for (Index anchor = 0; anchor < ownAnchors; ++anchor) {
    const Index node = anchors.node[static_cast<std::size_t>(anchor)];
    anchors.point.col(anchor) = net.restPosition.col(node);
    write(anchor, node);
  }
  if (m_bands.empty()) {
    anchors.bandLength.resize(0);
    return;
  }
  anchors.bandLength.setZero(anchors.count());
  for (std::size_t i = 0; i < m_bands.size(); ++i) {
    const Index anchor = ownAnchors + static_cast<Index>(i);
    anchors.point.col(anchor) = m_bands[i].point;
    anchors.bandLength[anchor] = m_bands[i].length;
  }
  writeBands();
}

} // namespace esm
