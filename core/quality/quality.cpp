// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/quality/quality.h"

#include "core/base/text_number.h"
#include "core/geometry/extent.h"
#include "core/net/net_builder.h"
#include "core/quality/hinges.h"
#include "core/quality/linear_net.h"
#include "core/quality/poke.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace esm {

namespace {

using Finding = QualityFinding;
using FindingKind = Finding::Kind;
using Severity = Finding::Severity;

constexpr Index kMostNodes = 40000; ///< whose factor is a matter of seconds
constexpr double kMechanism = 1e-9; ///< of the stiffest rate
constexpr double kSoft = 0.1;       ///< of the size: so deep a dent is soft
constexpr double kCollapse = 0.5;   ///< of the size

std::string inMillimetres(double metres)
{
  return formatDouble(1e3 * metres, 2) + " mm";
}

std::string counted(std::size_t count, const char* one, const char* many)
{
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

Finding at(FindingKind kind, Severity severity, const SpringNet& net, const std::vector<Index>& nodes,
           std::string text)
{
  Finding finding;
  finding.kind = kind;
  finding.severity = severity;
  finding.count = static_cast<std::int64_t>(nodes.size());
  for (std::size_t i = 0; i < std::min(nodes.size(), Finding::kMostNodes); ++i)
    finding.nodes.push_back(net.nodeId[static_cast<std::size_t>(nodes[i])]);
  finding.text = std::move(text);
  return finding;
}

bool hasInside(const SpringNet& net)
{
  return std::any_of(net.kind.begin(), net.kind.end(),
                     [](SpringKind kind) { return kind != SpringKind::Edge; }) ||
         (net.section.size() > 0 && net.section.maxCoeff() > 0.0);
}

void lookForHinges(const SpringNet& net, QualityReport& report)
{
  if (const std::vector<Index> nodes = hingeNodes(net); !nodes.empty())
    report.findings.push_back(
      at(FindingKind::HingeNode, Severity::Warning, net, nodes,
         "Parts hang together at " + counted(nodes.size(), "single node", "single nodes") +
           " only and turn about it freely. Join them by more springs, or weld the mesh with a "
           "larger tolerance."));
  std::vector<Index> onLines;
  const std::vector<std::vector<Index>> lines = hingeLines(net);
  for (const std::vector<Index>& line : lines) onLines.insert(onLines.end(), line.begin(), line.end());
  if (!lines.empty()) {
    report.findings.push_back(
      at(FindingKind::HingeLine, Severity::Warning, net, onLines,
         "Parts hang together along " + counted(lines.size(), "straight line", "straight lines") +
           " only and swing about it like a door. Join them by springs off the line."));
    report.findings.back().count = static_cast<std::int64_t>(lines.size());
  }
  if (const std::vector<Index> flat = flatNodes(net); !flat.empty())
    report.findings.push_back(
      at(FindingKind::FlatNodes, Severity::Warning, net, flat,
         "At " + counted(flat.size(), "node", "nodes") +
           " all springs lie in one plane: nothing holds it against a push across that plane. "
           "Add interior struts or anchors."));
}

void lookForHold(const SpringNet& net, QualityReport& report)
{
  const RigidMotions rigid(net, true);
  std::vector<Index> loose;
  std::vector<std::uint8_t> seen(static_cast<std::size_t>(rigid.partCount()), 0);
  for (Index node = 0; node < net.nodeCount(); ++node) {
    std::uint8_t& mark = seen[static_cast<std::size_t>(rigid.partOf(node))];
    if (!mark && rigid.isLoose(rigid.partOf(node))) loose.push_back(node);
    mark = 1;
  }
  if (loose.empty()) return;
  const bool all = static_cast<Index>(loose.size()) == rigid.partCount();
  report.findings.push_back(
    at(FindingKind::Unheld, Severity::Note, net, loose,
       (all && loose.size() == 1 ? std::string("Nothing holds the net")
                                 : "Nothing holds " + counted(loose.size(), "part", "parts") + " of " +
                                     std::to_string(rigid.partCount())) +
         ": with gravity it falls. Anchor it to the cavity, or fix some nodes."));
}

Status measure(const SpringNet& net, QualityReport& report, WorkControl* control)
{
  LinearNet free(net, false);
  const double rate = free.stiffestRate();
  if (!(rate > 0.0))
    return Error{ErrorCode::InvalidValue, "the net has no stiffness yet; apply a tissue before judging it"};
  const RigidMotions rigid(net, false);
  std::int64_t rigidMotions = 0;
  for (Index part = 0; part < rigid.partCount(); ++part) rigidMotions += rigid.isLoose(part) ? 6 : 0;
  if (free.factor(-kMechanism * rate))
    report.mechanisms = std::max<std::int64_t>(0, free.modesBelow() - rigidMotions);
  else // Maxwell's count: no fewer
    report.mechanisms =
      std::max<std::int64_t>(0, 3 * std::int64_t{free.freeCount()} - net.springCount() - rigidMotions);
  if (stopWanted(control)) return cancelledError();
  LinearNet held(net);
  held.watch(control);
  const SlowModes modes = slowestModes(held, 1, control);
  if (modes.frequency.size() > 0) report.frequency = modes.frequency[0];
  if (stopWanted(control)) return cancelledError();
  const Dent dent = deepestDent(net, held, report.poke, report.pokeRadius, control);
  if (stopWanted(control)) return cancelledError();
  report.dent = dent.depth;
  if (dent.node != kNoIndex) report.dentNode = net.nodeId[static_cast<std::size_t>(dent.node)];
  return {};
}

void judgeDent(const SpringNet& net, QualityReport& report)
{
  const std::string poke = "A poke of " + formatDouble(report.poke, 2) + " N ";
  const bool collapses = !(report.dent < kCollapse * report.size),
             isSoft = report.dent >= kSoft * report.size;
  Finding finding;
  finding.value = report.dent;
  if (report.dent > 0.0) finding.nodes = {report.dentNode};
  const std::string depth = "would dent it by about " + inMillimetres(report.dent);
  if (collapses) {
    finding.kind = FindingKind::Collapses;
    finding.severity = Severity::Warning;
    finding.text = poke + "would push it in by more than half its size: the net collapses.";
  } else if (isSoft) {
    finding.kind = FindingKind::Soft;
    finding.severity = Severity::Warning;
    finding.text =
      poke + depth + ", " + formatDouble(100.0 * report.dent / report.size, 2) + " % of its size.";
  } else {
    finding.severity = Severity::Good;
    finding.text = "The net carries load. " + poke + depth + ".";
  }
  if (net.triangleCount() > 0 && !hasInside(net)) {
    Finding inside;
    inside.kind = FindingKind::NothingInside;
    inside.severity = isSoft || report.mechanisms > 0 ? Severity::Warning : Severity::Note;
    inside.text = "The wall alone holds: nothing inside. Add interior struts.";
    report.findings.push_back(std::move(inside));
  }
  report.findings.push_back(std::move(finding));
  if (report.mechanisms > 0) {
    Finding loose;
    loose.kind = FindingKind::Mechanisms;
    loose.severity = Severity::Warning;
    loose.count = report.mechanisms;
    loose.text = counted(static_cast<std::size_t>(report.mechanisms), "motion", "motions") + " of the net " +
                 (report.mechanisms == 1 ? "is" : "are") +
                 " resisted by no spring. Add interior struts or anchors.";
    report.findings.push_back(std::move(loose));
  }
}

} // namespace

const char* nameOf(QualityFinding::Kind kind) noexcept
{
  constexpr const char* kNames[] = {"carries_load", "soft",       "collapses",  "nothing_inside",
                                    "mechanisms",   "flat_nodes", "hinge_node", "hinge_line",
                                    "unheld",       "too_large"};
  return kNames[static_cast<std::size_t>(kind)];
}

bool QualityReport::carriesLoad() const noexcept
{
  return std::none_of(findings.begin(), findings.end(),
                      [](const Finding& finding) { return finding.severity == Severity::Warning; });
}

Result<QualityReport> judgeNet(const SpringNet& net, WorkControl* control)
{
  QualityReport report;
  if (net.nodeCount() == 0) return Error{ErrorCode::InvalidValue, "the net is empty"};
  report.size = extentOf(net.restPosition);
  report.pokeRadius = std::min(0.005, report.size / 8.0);
  if (net.nodeCount() > kMostNodes) {
    Finding finding;
    finding.kind = FindingKind::TooLarge;
    finding.severity = Severity::Note;
    finding.count = net.nodeCount();
    finding.text = "The net has more than " + std::to_string(kMostNodes) +
                   " nodes: how far a poke dents it was not computed.";
    report.findings.push_back(std::move(finding));
  } else {
    if (Status status = measure(net, report, control); !status) return status.error();
    judgeDent(net, report);
  }
  if (stopWanted(control)) return cancelledError();
  lookForHinges(net, report);
  lookForHold(net, report);
  std::stable_sort(report.findings.begin(), report.findings.end(),
                   [](const Finding& a, const Finding& b) { return a.severity > b.severity; });
  return report;
}

} // namespace esm
