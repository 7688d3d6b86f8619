// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "cli/apply_edits.h"

#include "cli/rules_file.h"
#include "core/base/text_number.h"
#include "core/fuzzy/words.h"

#include <algorithm>
#include <limits>

namespace esm::cli {

namespace {

using EditKind = Edit::Kind;

/// "hardness=0.8" or "hardness=very hard", over the variables' ids and names.
Status setInput(const std::string& text, const fuzzy::RuleBase& rules, std::vector<fuzzy::InputValue>& inputs)
{
  const std::string name = text.substr(0, text.find('='));
  const std::vector<std::string> words = fuzzy::foldedWords(name); // upper and lower case, umlauts too
  std::string known;
  for (std::size_t i = 0; i < rules.inputs.size(); ++i) {
    const fuzzy::Variable& variable = rules.inputs[i];
    known += (known.empty() ? "" : ", ") + variable.id;
    const auto named = [&](const std::string& spelling) { return words == fuzzy::foldedWords(spelling); };
    if (!named(variable.id) && !named(variable.name.english) && !named(variable.name.german)) continue;
    auto parsed = fuzzy::parseInput(std::string_view(text).substr(name.size() + 1), variable);
    if (const auto* fault = std::get_if<fuzzy::RuleTextError>(&parsed))
      return Error{ErrorCode::InvalidValue, "--set " + text + ": " + fault->message};
    inputs[i] = std::get<fuzzy::InputValue>(std::move(parsed));
    return {};
  }
  return Error{ErrorCode::InvalidValue,
               "--set " + text + ": the rule base has no input \"" + name + "\", only " + known};
}

Region newRegion(const Edit& edit, const TissueModel& tissue)
{
  Region region;
  region.name = "Region " + std::to_string(tissue.regions.size() + 1);
  region.ellipsoid.centre = Eigen::Map<const Eigen::Vector3d>(edit.numbers.data());
  region.ellipsoid.semiAxes = Eigen::Map<const Eigen::Vector3d>(edit.numbers.data() + 3);
  region.inputs = tissue.inputs;
  return region;
}

Status fixBox(const Edit& edit, SpringNet& net)
{
  const Eigen::Map<const Eigen::Array3d> a(edit.numbers.data()), b(edit.numbers.data() + 3);
  const Eigen::Array3d low = a.min(b), high = a.max(b);
  bool any = false;
  for (Index node = 0; node < net.nodeCount(); ++node) {
    const Eigen::Array3d p = net.restPosition.col(node).array();
    if ((p < low).any() || (p > high).any()) continue;
    net.fixed[static_cast<std::size_t>(node)] = 1;
    any = true;
  }
  if (!any) return Error{ErrorCode::InvalidValue, "--fix-box " + edit.text + ": no node lies in this box"};
  return {};
}

/// A force that rises smoothly (3 s^2 - 2 s^3) within kRamp, holds, and from `release` on falls likewise.
VectorCurve pokeCurve(const Eigen::Vector3d& force, std::optional<double> release)
{
  constexpr double kRamp = 0.1; // [s]
  constexpr int kPieces = 10;
  VectorCurve curve;
  std::vector<double> share;
  for (int i = 0; i <= kPieces; ++i) {
    const double s = static_cast<double>(i) / kPieces;
    curve.time.push_back(s * kRamp);
    share.push_back(s * s * (3.0 - 2.0 * s));
  }
  if (release) {
    const double start = std::max(*release, kRamp);
    for (int i = 0; i <= kPieces; ++i) {
      const double s = static_cast<double>(i) / kPieces;
      curve.time.push_back(start + s * kRamp);
      share.push_back(1.0 - s * s * (3.0 - 2.0 * s));
    }
  }
  curve.value =
    force * Eigen::Map<const Eigen::RowVectorXd>(share.data(), static_cast<Eigen::Index>(share.size()));
  return curve;
}

/// The force is shared alike by all free nodes within the radius.
Status poke(const Edit& edit, Project& project)
{
  const std::vector<double>& n = edit.numbers;
  const Eigen::Vector3d point(n[0], n[1], n[2]), force(n[3], n[4], n[5]);
  const SpringNet& net = project.net;
  NodalForce load;
  double nearest = std::numeric_limits<double>::infinity();
  for (Index node = 0; node < net.nodeCount(); ++node) {
    if (net.fixed[static_cast<std::size_t>(node)]) continue;
    const double distance = (net.restPosition.col(node) - point).norm();
    nearest = std::min(nearest, distance);
    if (distance <= n[6]) load.nodes.push_back(node);
  }
  if (load.nodes.empty())
    return Error{ErrorCode::InvalidValue, "--poke " + edit.text +
                                            ": no free node lies within the radius; the nearest is " +
                                            formatDouble(nearest, 4) + " m away"};
  const auto share = static_cast<double>(load.nodes.size());
  load.force = pokeCurve(force / share, n.size() > 7 ? std::optional(n[7]) : std::nullopt);
  project.loads.forces.push_back(std::move(load));
  return {};
}

/// Tissue arguments, whose meaning depends on their order.
class TissueEditor {
public:
  TissueEditor(const std::vector<Edit>& edits, TissueModel& tissue) : m_tissue(tissue)
  {
    bool inRegion = false, regionHasOwn = false;
    for (const Edit& edit : edits) {
      inRegion |= edit.kind == EditKind::Region;
      regionHasOwn |= inRegion && edit.kind == EditKind::Set;
    }
    m_setsAreForRegions = inRegion && !regionHasOwn;
  }

  Status apply(const Edit& edit)
  {
    switch (edit.kind) {
    case EditKind::Set:
      if (m_setsAreForRegions) m_forRegions.push_back(edit.text);
      return m_setsAreForRegions ? Status{} : setInput(edit.text, m_tissue.rules, currentInputs());
    case EditKind::Region:
      m_tissue.regions.push_back(newRegion(edit, m_tissue));
      m_tissue.regions.back().falloff = m_falloff;
      m_inRegion = true;
      for (const std::string& text : m_forRegions)
        if (const Status status = setInput(text, m_tissue.rules, currentInputs()); !status) return status;
      return {};
    case EditKind::Falloff:
      (m_inRegion ? m_tissue.regions.back().falloff : m_falloff) = edit.numbers[0];
      return {};
    default:
      return {};
    }
  }

private:
  std::vector<fuzzy::InputValue>& currentInputs()
  {
    return m_inRegion ? m_tissue.regions.back().inputs : m_tissue.inputs;
  }

  TissueModel& m_tissue;
  bool m_setsAreForRegions = false, m_inRegion = false;
  std::vector<std::string> m_forRegions;
  double m_falloff = Region{}.falloff;
};

} // namespace

Status applyEdits(const std::vector<Edit>& edits, Project& project)
{
  // Fixed nodes first, so that a poke takes free nodes only, wherever it stands on the command line.
  for (const Edit& edit : edits)
    if (edit.kind == EditKind::FixBox)
      if (const Status status = fixBox(edit, project.net); !status) return status;
  if (std::any_of(edits.begin(), edits.end(), [](const Edit& e) { return e.kind == EditKind::ClearLoads; }))
    project.loads = Loads{};

  TissueEditor tissue(edits, project.tissue);
  for (const Edit& edit : edits) {
    Status status;
    if (edit.kind == EditKind::Poke) {
      status = poke(edit, project);
    } else if (edit.kind == EditKind::Gravity) {
      project.loads.gravity = Eigen::Map<const Eigen::Vector3d>(edit.numbers.data());
    } else if (edit.kind == EditKind::Rule) {
      Result<fuzzy::Rule> rule = readRule(edit.text, project.tissue.rules);
      if (!rule) return rule.error();
      project.tissue.rules.rules.push_back(std::move(*rule));
    } else {
      status = tissue.apply(edit);
    }
    if (!status) return status;
  }
  return {};
}

} // namespace esm::cli
