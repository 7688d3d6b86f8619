// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "bench/runs.h"
#include "bench/scenes.h"
#include "bench/sub_benches.h"
#include "core/base/text_number.h"
#include "core/dynamics/simulation.h"
#include "core/geometry/extent.h"
#include "core/net/net_builder.h"
#include "core/tissue/tissue_derivation.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <functional>
#include <memory>
#include <vector>

namespace esm::bench {
namespace {

/// An edit as a hand makes it: `t` in [0, 1] goes to and fro like a slider or a handle.
struct HandEdit {
  const char* name;
  std::function<void(TissueModel&, double t)> move;
};

Region regionAt(const Eigen::Vector3d& centre, double radius, const TissueModel& model, double hardness)
{
  Region region;
  region.ellipsoid.centre = centre;
  region.ellipsoid.semiAxes = Eigen::Vector3d(1.0, 0.8, 0.6) * radius;
  region.inputs = model.inputs;
  region.inputs[0] = hardness;
  return region;
}

/// Five regions spread over the organ; the last one is turned inside out and fades over all of it, so that
/// no place has a tissue of its own: the dearest field there is.
TissueModel tissueOf(const SpringNet& net, bool isBlendedEverywhere)
{
  TissueModel model = defaultTissue();
  const Eigen::AlignedBox3d box = boxOf(net.restPosition);
  const Eigen::Vector3d low = box.min(), high = box.max();
  const double size = extentOf(net.restPosition);
  for (int i = 0; i < 5; ++i) {
    const Eigen::Vector3d share(0.2 * i + 0.1, i % 2 ? 0.9 : 0.1, 0.5);
    model.regions.push_back(
      regionAt(low + share.cwiseProduct(high - low), 0.15 * size, model, 0.15 * i + 0.1));
  }
  if (isBlendedEverywhere) {
    model.regions.push_back(regionAt(0.5 * (low + high), 2.0 * size, model, 0.8));
    model.regions.back().falloff = 1.0;
    model.regions.back().insideOut = true;
  }
  return model;
}

/// The scene's organ as an import makes it: with its surface, which gives its springs their stiffness, and at rest.
SpringNet importedOrgan(const SceneOptions& options)
{
  const SpringNet scene = organ100k(options).net;
  std::vector<std::vector<Index>> above(
    static_cast<std::size_t>(scene.nodeCount())); // neighbours of a higher number
  for (const auto& ends : scene.ends.colwise())
    above[static_cast<std::size_t>(ends.minCoeff())].push_back(ends.maxCoeff());
  for (std::vector<Index>& nodes : above) std::sort(nodes.begin(), nodes.end());
  Mesh mesh;
  mesh.position = scene.restPosition;
  std::vector<Eigen::Vector3i> triangles;
  for (Index a = 0; a < scene.nodeCount(); ++a)
    for (const Index b : above[static_cast<std::size_t>(a)])
      for (const Index c : above[static_cast<std::size_t>(b)])
        if (std::binary_search(above[static_cast<std::size_t>(a)].begin(),
                               above[static_cast<std::size_t>(a)].end(), c))
          triangles.emplace_back(a, b, c);
  mesh.triangles.resize(3, static_cast<Eigen::Index>(triangles.size()));
  for (std::size_t t = 0; t < triangles.size(); ++t)
    mesh.triangles.col(static_cast<Eigen::Index>(t)) = triangles[t];
  return buildNet(std::move(mesh)).value();
}

bool sameBits(const SpringNet& a, const SpringNet& b)
{
  const auto same = [](const Eigen::ArrayXd& x, const Eigen::ArrayXd& y) {
    return x.size() == y.size() &&
           std::memcmp(x.data(), y.data(), static_cast<std::size_t>(x.size()) * sizeof(double)) == 0;
  };
  return same(a.stiffness, b.stiffness) && same(a.viscosity, b.viscosity) &&
         same(a.lawParameter, b.lawParameter) && same(a.mass, b.mass) &&
         same(a.anchors.stiffness, b.anchors.stiffness) && same(a.anchors.viscosity, b.anchors.viscosity);
}

/// An edit on its way to the engine, by what it changes or by the net as a whole, as it went before there were
/// patches: a copy for those who look on, one for the command. Both engines are asleep at first.
class EngineWays {
public:
  explicit EngineWays(const SpringNet& net)
    : m_patched(Simulation::create(net, {}, {}).value()), m_whole(Simulation::create(net, {}, {}).value())
  {}

  bool take(const SpringNet& net, const ParameterPatch& patch)
  {
    double start = cpuSeconds();
    const auto change = m_patched.setParameters(patch);
    m_patchTimes.push_back(cpuSeconds() - start);
    start = cpuSeconds();
    const auto sent = std::make_unique<SpringNet>(net); // a command holds its own
    const Status taken = m_whole.setParameters(*sent);
    m_wholeTimes.push_back(cpuSeconds() - start);
    if (!change || !taken) return false;
    m_seen = change->springsSeen;
    m_patched.advance(1.0 / 60.0);
    m_whole.advance(1.0 / 60.0);
    return m_patched.state().position == m_whole.state().position;
  }
  double patchMilliseconds() const { return 1e3 * medianTime(m_patchTimes); }
  double wholeMilliseconds() const { return 1e3 * medianTime(m_wholeTimes); }
  std::int64_t springsSeen() const noexcept { return m_seen; } ///< by the last patch

private:
  Simulation m_patched, m_whole;
  std::vector<double> m_patchTimes, m_wholeTimes;
  std::int64_t m_seen = 0;
};

/// @return false if the two ways do not agree to the bit.
bool measure(const SpringNet& bare, const char* field, TissueModel model, const HandEdit& edit, int repeats)
{
  SpringNet net = bare, fullNet = bare;
  auto derivation = TissueDerivation::create(model, net);
  if (!derivation) return false;
  EngineWays engine(net);
  std::vector<double> ours, full;
  DerivationReport report;
  for (int i = 0; i < repeats; ++i) {
    edit.move(model, 0.3 + 0.4 * (i % 7) / 6.0);
    double start = cpuSeconds();
    ParameterPatch patch;
    report = derivation->update(model, net, &patch).value();
    ours.push_back(cpuSeconds() - start);
    if (!engine.take(net, patch)) return false;
    if (i % 4 != 3) continue; // the full derivation is dearer: every fourth time, at the same places
    start = cpuSeconds();
    (void)applyTissue(model, fullNet).value();
    full.push_back(cpuSeconds() - start);
    if (!sameBits(net, fullNet)) return false;
  }
  const double milliseconds = 1e3 * medianTime(ours), fullMilliseconds = 1e3 * medianTime(full);
  std::printf(
    "%s,%s,%d,%d,%d,%s,%s,%s,%s,%lld,%s,%s,%s\n", edit.name, field, static_cast<int>(net.springCount()),
    static_cast<int>(report.springsChanged), static_cast<int>(report.nodesChanged),
    formatDouble(milliseconds, 3).c_str(),
    formatDouble(1e3 * *std::max_element(ours.begin(), ours.end()), 3).c_str(),
    formatDouble(fullMilliseconds, 3).c_str(), formatDouble(fullMilliseconds / milliseconds, 3).c_str(),
    static_cast<long long>(engine.springsSeen()), formatDouble(engine.patchMilliseconds(), 3).c_str(),
    formatDouble(engine.wholeMilliseconds(), 3).c_str(),
    formatDouble(engine.wholeMilliseconds() / engine.patchMilliseconds(), 3).c_str());
  std::fflush(stdout);
  return true;
}

} // namespace

int runTissueEdit(const std::vector<std::string>& words)
{
  SceneOptions options;
  options.size = (isQuick(words) ? 3'400 : 34'000) / 100'002.0;
  const SpringNet net = importedOrgan(options);
  const HandEdit edits[] = {
    {"slider of the base", [](TissueModel& m, double t) { m.inputs[0] = t; }},
    {"slider of a region", [](TissueModel& m, double t) { m.regions[2].inputs[0] = t; }},
    {"falloff of a region", [](TissueModel& m, double t) { m.regions[2].falloff = t; }},
    {"region moved",
     [](TissueModel& m, double t) {
       const double middle = 0.5 * (m.regions[1].ellipsoid.centre[0] + m.regions[3].ellipsoid.centre[0]);
       m.regions[2].ellipsoid.centre[0] = middle + (t - 0.5) * m.regions[2].ellipsoid.semiAxes[0];
     }},
    {"region put in order", [](TissueModel& m, double) { std::swap(m.regions[1], m.regions[2]); }},
    {"wall thickness", [](TissueModel& m, double t) { m.thickness = 0.004 * t; }}};
  std::printf("edit,field,springs,springs_derived,nodes_derived,median_ms,worst_ms,full_ms,times_full,"
              "engine_springs_seen,engine_patch_ms,engine_whole_ms,times_whole\n");
  bool isSame = true;
  for (const bool isBlendedEverywhere : {false, true})
    for (const HandEdit& edit : edits)
      isSame &= measure(net, isBlendedEverywhere ? "blended everywhere" : "five regions",
                        tissueOf(net, isBlendedEverywhere), edit, isQuick(words) ? 8 : 40);
  if (!isSame) std::fprintf(stderr, "an incremental derivation differs from the full one\n");
  return isSame ? 0 : 1;
}

} // namespace esm::bench
