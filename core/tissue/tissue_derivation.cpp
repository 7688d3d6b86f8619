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
  const bool hasMoved = !b.learned.isEmpty() && !(a.regions == b.regions); // factors fade with regions
  return a.thickness != b.thickness || a.law != b.law || !(a.learned == b.learned) || hasMoved ||
         (a.density != b.density && !isFromRules(&TissueParameters::density)) ||
         (a.lawParameter != b.lawParameter && !isFromRules(&TissueParameters::stiffening)) ||
         std::any_of(kTissueOutputs.begin(), kTissueOutputs.end(), [&](const TissueOutput& output) {
           return comesFromRules(a.rules, output.value) != isFromRules(output.value);
         });
}

/// Blends place after place, ascending, from remembered weights.
class Blender {
public:
  Blender(const TissueField& field, const std::vector<std::shared_ptr<const Reach>>& reaches) : m_field(field)
  {
    for (const std::shared_ptr<const Reach>& reach : reaches) m_weights.emplace_back(*reach);
  }

  TissueBlend at(Index place)
  {
    TissueBlend blend = m_field.baseBlend();
    for (std::size_t r = 0; r < m_weights.size(); ++r)
      blend.cover(static_cast<int>(r), m_weights[r].weightAt(place), m_field.regions()[r].logs);
    return blend;
  }

private:
  const TissueField& m_field;
  std::vector<ReachCursor> m_weights;
};

/// Whether two sets hold the same nodes at the same points, so that they differ in numbers alone.
bool samePlaces(const AnchorSet& a, const AnchorSet& b)
{
  const auto same = [](const auto& x, const auto& y) {
    return x.rows() == y.rows() && x.cols() == y.cols() && (x.array() == y.array()).all();
  };
  return a.node == b.node && same(a.point, b.point) && same(a.bandLength, b.bandLength) &&
         a.stiffness.size() == b.stiffness.size() && a.viscosity.size() == b.viscosity.size();
}

/// A mesh that came in a thousand times too small, say: without area there is no mass.
bool surfaceHasArea(const SpringNet& net, const DerivationPlaces& places)
{
  return net.triangleCount() == 0 || places.dualArea.sum() > 0.0;
}

} // namespace

TissueDerivation::TissueDerivation(TissueField field, const SpringNet& net)
  : m_places(net),
    m_field(std::move(field)),
    m_touched(m_places.springs + m_places.nodes),
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
  if (m_bands.empty()) return;
  m_bandsOfNode.build(static_cast<std::size_t>(m_places.nodes), [&](const auto& add) {
    for (std::size_t i = 0; i < m_bands.size(); ++i) add(m_bands[i].node, static_cast<Index>(i));
  });
}

Result<TissueDerivation> TissueDerivation::prepare(const TissueModel& model, const SpringNet& net)
{
  auto field = TissueField::create(model);
  if (!field) return field.error();
  TissueDerivation derivation(std::move(*field), net);
  if (!surfaceHasArea(net, derivation.m_places))
    return Error{
      ErrorCode::InvalidValue,
      "the surface has triangles but no area, so that its tissue has no mass; import the mesh with "
      "a smaller weld tolerance or the right unit"};
  return derivation;
}

Result<TissueDerivation> TissueDerivation::create(const TissueModel& model, SpringNet& net)
{
  auto derivation = prepare(model, net);
  if (derivation) derivation->update(TissueField(derivation->m_field), net);
  return derivation;
}

Result<DerivationReport> TissueDerivation::update(const TissueModel& model, SpringNet& net,
                                                  ParameterPatch* patch)
{
  auto field = TissueField::create(model);
  if (!field) return field.error();
  return update(std::move(*field), net, patch);
}

const DerivationReport& TissueDerivation::update(TissueField field, SpringNet& net, ParameterPatch* patch)
{
  ESM_ASSERT(net.springCount() == m_places.springs && net.nodeCount() == m_places.nodes);
  m_touched.clear();
  m_report = {};
  if (patch != nullptr) *patch = {};
  const TissueModel &before = m_field.model(), &model = field.model();
  if (m_isFirst || before.thickness != model.thickness) setThickness(model.thickness, net);
  Reaches reaches = reachesOf(field);
  if (m_isFirst || differEverywhere(before, model)) {
    m_touched.addAll();
    m_learned = learnedNumbers(model, net);
  } else {
    markWhatDiffers(field, reaches);
  }
  m_field = std::move(field);
  m_reaches = std::move(reaches);
  deriveTouched(net, patch);
  m_isFirst = false;
  return m_report;
}

ApplyReport TissueDerivation::account(const SpringNet& net) const
{
  ApplyReport report{m_report};
  if (m_places.springs > 0) {
    report.minYoungsModulus = m_modulus.minCoeff();
    report.maxYoungsModulus = m_modulus.maxCoeff();
  }
  report.totalMass = net.mass.sum();
  return report;
}

/// Sections depend on it, and on them who has no mass of his own.
void TissueDerivation::setThickness(double thickness, const SpringNet& net)
{
  m_places.setThickness(thickness, net);
  m_report.placesSeen += m_places.springs;
  m_lone.clear();
  for (std::size_t i = 0; i < m_places.loose.size(); ++i) {
    double volume = 0.0;
    for (const Index s : m_places.looseSprings[i]) volume += m_places.section[s] * net.restLength[s];
    if (!(volume > 0.0)) m_lone.push_back(m_places.loose[i]);
  }
}

/// Weights of shapes that were there before are not computed again.
TissueDerivation::Reaches TissueDerivation::reachesOf(const TissueField& field)
{
  Reaches reaches;
  for (const CompiledRegion& region : field.regions()) {
    std::shared_ptr<const Reach> reach;
    for (std::size_t old = 0; old < m_reaches.size() && !reach; ++old)
      if (m_field.regions()[old].shape == region.shape) reach = m_reaches[old];
    if (!reach) {
      reach = std::make_shared<Reach>(reachOf(region.shape, m_places.point));
      m_report.placesSeen += m_places.point.cols();
    }
    reaches.push_back(std::move(reach));
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

  if (!(m_field.baseBlend().logs == field.baseBlend().logs).all()) {
    m_touched.addAll();
    for (std::size_t r = 0; r < bottom; ++r) m_touched.hideUnder(*reaches[r]);
  }
  const std::size_t beforeEnd = before.size() - top, afterEnd = after.size() - top;
  if (beforeEnd == afterEnd) {
    for (std::size_t r = bottom; r < afterEnd; ++r) {
      if (sameTissue(before[r], after[r])) {
        m_touched.addMoved(*m_reaches[r], *reaches[r]);
      } else {
        m_touched.addReach(*m_reaches[r]);
        m_touched.addReach(*reaches[r]);
      }
    }
  } else {
    for (std::size_t r = bottom; r < beforeEnd; ++r) m_touched.addReach(*m_reaches[r]);
    for (std::size_t r = bottom; r < afterEnd; ++r) m_touched.addReach(*reaches[r]);
  }
  for (std::size_t r = afterEnd; r < after.size(); ++r) m_touched.hideUnder(*reaches[r]);
}

void TissueDerivation::deriveTouched(SpringNet& net, ParameterPatch* patch)
{
  m_anchorsChangePlaces = m_isFirst; // whatever anchors the net brought go
  m_cubicFromStiffening = cubicFromStiffening(m_field.model());
  if (m_isFirst) {
    net.stiffness.resize(m_places.springs);
    net.viscosity.resize(m_places.springs);
    net.lawParameter.resize(m_places.springs);
    net.law.resize(static_cast<std::size_t>(m_places.springs), m_field.model().law);
    net.mass.resize(m_places.nodes);
  }
  deriveSprings(net, patch);
  deriveNodes(net, patch);
  deriveAnchors(net, patch);
  m_report.placesSeen += m_touched.looks();
}

void TissueDerivation::deriveSprings(SpringNet& net, ParameterPatch* patch)
{
  Blender blender(m_field, m_reaches);
  const SpringLaw law = m_field.model().law;
  const unsigned wanted = m_places.loose.empty() ? kSpringParameters : kSpringParameters | kNodeParameters;
  const std::vector<Index>& touched = m_touched.sorted();
  const auto count = static_cast<std::size_t>(
    std::lower_bound(touched.begin(), touched.end(), m_places.springs) - touched.begin());
  for (std::size_t i = 0; i < count; ++i) { // nodes may come in behind them
    const Index s = touched[i];
    const TissueParameters tissue = m_field.plain(blender.at(s), wanted);
    const SpringNumbers numbers =
      learned(springNumbers(tissue, m_places.perModulus[s], m_cubicFromStiffening), m_learned.factorOf(s),
              law == SpringLaw::Exponential ? m_learned.shiftOf(s) : 0.0);
    SpringLaw& lawNow = net.law[static_cast<std::size_t>(s)];
    if (patch != nullptr && (net.stiffness[s] != numbers.stiffness || net.viscosity[s] != numbers.viscosity ||
                             net.lawParameter[s] != numbers.lawParameter || lawNow != law))
      patch->springs.push_back({s, law, numbers.stiffness, numbers.viscosity, numbers.lawParameter});
    lawNow = law;
    net.stiffness[s] = numbers.stiffness;
    net.viscosity[s] = numbers.viscosity;
    net.lawParameter[s] = numbers.lawParameter;
    m_modulus[s] = tissue.youngsModulus;
    if (!(m_places.section[s] > 0.0)) continue;
    m_springDensity[s] = tissue.density;
    for (int end = 0; end < 2; ++end) // its mass is theirs
      if (const Index node = net.ends(end, s);
          m_places.looseOfNode[static_cast<std::size_t>(node)] != kNoIndex)
        m_touched.add(placeOfNode(node));
  }
  m_report.springsChanged = static_cast<Index>(count);
}

namespace {

void putMass(Index node, double mass, SpringNet& net, ParameterPatch* patch)
{
  if (patch != nullptr && net.mass[node] != mass)
    patch->nodes.push_back({node, mass, net.massDamping.size() > 0 ? net.massDamping[node] : 0.0});
  net.mass[node] = mass;
}

} // namespace

void TissueDerivation::deriveNodes(SpringNet& net, ParameterPatch* patch)
{
  Blender blender(m_field, m_reaches);
  const double thickness = m_field.model().thickness;
  const std::vector<Index>& touched = m_touched.sorted();
  for (auto it = std::lower_bound(touched.begin(), touched.end(), m_places.springs); it != touched.end();
       ++it) {
    const Index node = *it - m_places.springs;
    ++m_report.nodesChanged;
    const double area = m_places.dualArea[node], volume = m_places.volumeOf(node);
    if (!m_places.hasTissue(node)) {
      if (!std::binary_search(m_lone.begin(), m_lone.end(), node))
        putMass(node, massOfLines(node, net), net, patch);
      continue;
    }
    const TissueParameters tissue = m_field.plain(blender.at(*it), kNodeParameters);
    putMass(node, volume > 0.0 ? massOfVolume(tissue, volume) : massOfSurface(tissue, thickness, area), net,
            patch);
    const AnchorNumbers anchor = learned(anchorNumbers(tissue, area), m_learned.nodeFactorOf(node));
    m_anchorsChangePlaces |= (anchor.stiffness > 0.0) != (m_anchoring[node] > 0.0);
    m_anchoring[node] = anchor.stiffness;
    m_anchorViscosity[node] = anchor.viscosity;
  }
  if (!m_lone.empty() && m_report.nodesChanged > 0) fillLoneMasses(net, patch);
}

double TissueDerivation::massOfLines(Index node, const SpringNet& net) const
{
  const auto i = static_cast<std::size_t>(m_places.looseOfNode[static_cast<std::size_t>(node)]);
  double mass = 0.0;
  for (const Index s : m_places.looseSprings[i])
    mass += halfMassOfLine(m_springDensity[s], m_places.section[s], net.restLength[s]);
  return mass;
}

/// Nodes to which nothing belongs get the smallest mass of the others, so that nobody divides by zero.
void TissueDerivation::fillLoneMasses(SpringNet& net, ParameterPatch* patch) const
{
  double least = std::numeric_limits<double>::infinity();
  auto lone = m_lone.begin();
  for (Index node = 0; node < m_places.nodes; ++node)
    if (lone != m_lone.end() && *lone == node)
      ++lone;
    else
      least = std::min(least, net.mass[node]);
  if (!std::isfinite(least))
    least = m_field.base().density * std::pow(m_field.model().thickness, 3.0); // only lone nodes
  for (const Index node : m_lone) putMass(node, least, net, patch);
  if (patch != nullptr)
    std::sort(patch->nodes.begin(), patch->nodes.end(),
              [](const ParameterPatch::Node& a, const ParameterPatch::Node& b) { return a.node < b.node; });
}

/// Those of touched nodes; all where a node has gained or lost its own.
void TissueDerivation::deriveAnchors(SpringNet& net, ParameterPatch* patch)
{
  const std::vector<Index>& touched = m_touched.sorted();
  const auto firstNode = std::lower_bound(touched.begin(), touched.end(), m_places.springs);
  for (auto it = firstNode; it != touched.end() && !m_bands.empty(); ++it)
    for (const Index i : m_bandsOfNode[static_cast<std::size_t>(*it - m_places.springs)]) {
      Band& band = m_bands[static_cast<std::size_t>(i)];
      band.numbers =
        bandNumbers(m_field.at(m_places.point.col(*it)), m_places.dualArea[band.node], band.length);
    }
  AnchorSet& anchors = net.anchors;
  if (m_anchorsChangePlaces) {
    const AnchorSet before = patch != nullptr ? anchors : AnchorSet{};
    placeAnchors(net);
    if (patch == nullptr) return;
    if (!samePlaces(before, anchors)) patch->anchorSet = anchors;
    for (Index i = 0; i < anchors.count() && !patch->anchorSet; ++i)
      if (before.stiffness[i] != anchors.stiffness[i] || before.viscosity[i] != anchors.viscosity[i])
        patch->anchors.push_back({i, anchors.stiffness[i], anchors.viscosity[i]});
    return;
  }
  const auto put = [&](Index anchor, const AnchorNumbers& numbers) {
    if (patch != nullptr &&
        (anchors.stiffness[anchor] != numbers.stiffness || anchors.viscosity[anchor] != numbers.viscosity))
      patch->anchors.push_back({anchor, numbers.stiffness, numbers.viscosity});
    anchors.stiffness[anchor] = numbers.stiffness;
    anchors.viscosity[anchor] = numbers.viscosity;
  };
  for (auto it = firstNode; it != touched.end(); ++it) {
    const Index node = *it - m_places.springs;
    if (const Index anchor = m_anchorOfNode[static_cast<std::size_t>(node)]; anchor != kNoIndex)
      put(anchor, {m_anchoring[node], m_anchorViscosity[node]});
  }
  const Index firstBand = anchors.count() - static_cast<Index>(m_bands.size());
  std::vector<Index> bands;
  for (auto it = firstNode; it != touched.end() && !m_bands.empty(); ++it)
    for (const Index i : m_bandsOfNode[static_cast<std::size_t>(*it - m_places.springs)]) bands.push_back(i);
  std::sort(bands.begin(), bands.end());
  for (const Index i : bands) put(firstBand + i, m_bands[static_cast<std::size_t>(i)].numbers);
}

/// Tissue's own by their nodes, then the bands.
void TissueDerivation::placeAnchors(SpringNet& net)
{
  AnchorSet& anchors = net.anchors;
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
    anchors.stiffness[anchor] = m_anchoring[node];
    anchors.viscosity[anchor] = m_anchorViscosity[node];
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
    anchors.stiffness[anchor] = m_bands[i].numbers.stiffness;
    anchors.viscosity[anchor] = m_bands[i].numbers.viscosity;
  }
}

} // namespace esm
