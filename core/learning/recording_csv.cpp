// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/learning/recording_csv.h"

#include "core/base/csv_reader.h"
#include "core/base/text_number.h"
#include "core/geometry/distance.h"
#include "core/geometry/nearest_weights.h"
#include "core/learning/recording_frame.h"
#include "core/learning/statics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace esm::learning {
namespace {

constexpr double kNotSeen = std::numeric_limits<double>::quiet_NaN();
constexpr double kFarFromExpected = 150.0; ///< of a net's softness

enum class Column { What, Node, X, Y, Z, VX, VY, VZ, Sd };
constexpr const char* kColumns[] = {"what", "node", "x", "y", "z", "vx", "vy", "vz", "sd"};
constexpr std::size_t kColumnCount = std::size(kColumns);

class Reading {
public:
  Reading(CsvReader reader, const std::string& fileName, const SpringNet& net, const RecordingUnits& units)
    : m_reader(std::move(reader)), m_net(net), m_units(units), m_edge(medianRestLength(net))
  {
    m_recording.name = fileName;
    for (Index i = 0; i < net.nodeCount(); ++i) m_nodeOf[static_cast<Index>(net.nodeId[at(i)])] = i;
  }

  Result<Recording> read()
  {
    if (const Status status = findColumns(); !status) return status.error();
    for (;;) {
      CsvRow row;
      const Result<bool> more = m_reader.next(row);
      if (!more) return more.error();
      if (!*more) break;
      if (const Status status = take(row); !status) return status.error();
    }
    return finish();
  }

private:
  Status findColumns()
  {
    m_column.fill(std::nullopt);
    const CsvRow& header = m_reader.header();
    for (std::size_t c = 0; c < header.cells.size(); ++c) {
      const auto known = std::find(std::begin(kColumns), std::end(kColumns), header.cells[c]);
      if (known == std::end(kColumns))
        return m_reader.error(header, c, "no such column; there are what, node, x, y, z, vx, vy, vz, sd");
      auto& column = m_column[static_cast<std::size_t>(known - std::begin(kColumns))];
      if (column) return m_reader.error(header, c, "the column occurs twice");
      column = c;
    }
    for (const Column needed : {Column::What, Column::VX, Column::VY, Column::VZ})
      if (!has(needed))
        return m_reader.error(header, std::string("the column ") +
                                        kColumns[static_cast<std::size_t>(needed)] + " is missing");
    if (!has(Column::Node) && !(has(Column::X) && has(Column::Y) && has(Column::Z)))
      return m_reader.error(header, "there is neither a column node nor are there x, y and z");
    return {};
  }
  bool has(Column column) const { return m_column[static_cast<std::size_t>(column)].has_value(); }
  std::string cell(const CsvRow& row, Column column) const
  {
    const auto& place = m_column[static_cast<std::size_t>(column)];
    return place ? row.cells[*place] : std::string();
  }

  /// NaN for an empty cell.
  Result<double> number(const CsvRow& row, Column column)
  {
    const std::string text = cell(row, column);
    if (text.empty()) return kNotSeen;
    const CsvNumber number = m_reader.number(text);
    const std::size_t place = *m_column[static_cast<std::size_t>(column)];
    if (number.kind == CsvNumber::Kind::Unclear) return m_reader.error(row, place, number.why);
    if (number.kind == CsvNumber::Kind::Text || !std::isfinite(number.value))
      return m_reader.error(row, place, "\"" + text + "\" is no finite number");
    return number.value;
  }

  /// All three or none (NaN).
  Result<Eigen::Vector3d> vector(const CsvRow& row, Column first)
  {
    Eigen::Vector3d value;
    for (int axis = 0; axis < 3; ++axis) {
      const auto one = number(row, static_cast<Column>(static_cast<int>(first) + axis));
      if (!one) return one.error();
      value[axis] = *one;
    }
    if (!value.allFinite() && !value.array().isNaN().all())
      return m_reader.error(row, "one or two of three coordinates are missing");
    return value;
  }

  Status take(const CsvRow& row)
  {
    const std::string what = cell(row, Column::What);
    auto value = vector(row, Column::VX);
    if (!value) return value.error();
    if (what == "gravity") {
      if (!value->allFinite()) return m_reader.error(row, "gravity has no vx, vy, vz");
      m_recording.loads.gravity = *value;
      return {};
    }
    auto place = vector(row, Column::X);
    if (!place) return place.error();
    *place *= m_units.length;
    const auto node = nodeOf(row);
    if (!node) return node.error();
    if (*node == kNoIndex && !place->allFinite())
      return m_reader.error(row, "there is neither a node nor a place");
    if (*node != kNoIndex && place->allFinite()) m_told.push_back({*node, *place, row.line});
    if (what == "marker") return takeMarker(row, *node, *place, m_units.length * *value);
    if (!value->allFinite()) return m_reader.error(row, what + " has no vx, vy, vz");
    if (what == "force") return takeLoad(row, *node, *place, m_units.force * *value, true);
    if (what == "move") return takeLoad(row, *node, *place, m_units.length * *value, false);
    return m_reader.error(row, "\"" + what + "\" is no kind of row; there are marker, force, move, gravity");
  }

  /// kNoIndex for an empty cell.
  Result<Index> nodeOf(const CsvRow& row)
  {
    const std::string text = cell(row, Column::Node);
    if (text.empty()) return kNoIndex;
    const auto id = parseInteger(text);
    const auto found = id && *id >= 0 && *id <= std::numeric_limits<Index>::max()
                         ? m_nodeOf.find(static_cast<Index>(*id))
                         : m_nodeOf.end();
    if (found != m_nodeOf.end()) return found->second;
    return m_reader.error(row, *m_column[static_cast<std::size_t>(Column::Node)],
                          "the net has no node with the id \"" + text + "\"");
  }

  Status takeMarker(const CsvRow& row, Index node, const Eigen::Vector3d& place, const Eigen::Vector3d& seen)
  {
    Marker marker = Marker::ofNode(node);
    if (node == kNoIndex) {
      m_loose.push_back({m_recording.markers.size(), place, row.line});
    } else if (!m_lineOf.emplace(node, row.line).second) {
      return m_reader.error(row, "the node has a marker already, in line " + std::to_string(m_lineOf[node]));
    }
    const auto sd = number(row, Column::Sd);
    if (!sd) return sd.error();
    if (*sd <= 0.0) return m_reader.error(row, "sd must be above 0");
    m_recording.markers.push_back(marker);
    m_seen.push_back(seen);
    m_sd.push_back(m_units.length * *sd);
    return {};
  }

  Status takeLoad(const CsvRow& row, Index node, const Eigen::Vector3d& place, const Eigen::Vector3d& value,
                  bool isForce)
  {
    if (node == kNoIndex) {
      node = nearestOf(m_net.restPosition, place);
      if (!((m_net.restPosition.col(node) - place).norm() <= 0.5 * m_edge))
        return m_reader.error(row, "no node is nearer than half an edge (" + formatDouble(0.5 * m_edge, 3) +
                                     " m); is the unit of length right (--length-unit)?");
    }
    VectorCurve curve;
    curve.time = {0.0};
    curve.value = value;
    if (isForce)
      m_recording.loads.forces.push_back({{node}, std::move(curve)});
    else
      m_recording.loads.motions.push_back({{node}, std::move(curve), {}});
    return {};
  }

  Result<Recording> finish()
  {
    if (m_recording.markers.empty())
      return Error{ErrorCode::EmptyResult, m_recording.name + ": holds no marker"};
    if (const Status status = checkPlaces(); !status) return status.error();
    if (const Status status = tieLoose(); !status) return status.error();
    m_recording.position.resize(3, static_cast<Eigen::Index>(m_seen.size()));
    for (std::size_t m = 0; m < m_seen.size(); ++m)
      m_recording.position.col(static_cast<Eigen::Index>(m)) = m_seen[m];
    if (const Status status = takeWeights(); !status) return status.error();
    if (const Status status = checkRecording(m_recording, m_net); !status) return status.error();
    return std::move(m_recording);
  }

  Status named(const Status& status) const
  {
    if (status) return {};
    return Error{status.error().code, m_recording.name + ": " + status.error().detail};
  }

  /// The frame of the places: those at rest where the file tells them, and those seen.
  Status checkPlaces() const
  {
    std::vector<std::string> names;
    const auto check = [&](const std::vector<std::pair<Index, Eigen::Vector3d>>& pairs) {
      Eigen::Matrix3Xd seen(3, static_cast<Eigen::Index>(pairs.size())), rest = seen;
      names.clear();
      for (std::size_t i = 0; i < pairs.size(); ++i) {
        seen.col(static_cast<Eigen::Index>(i)) = pairs[i].second;
        rest.col(static_cast<Eigen::Index>(i)) = m_net.restPosition.col(pairs[i].first);
        names.push_back("node " + std::to_string(static_cast<Index>(m_net.nodeId[at(pairs[i].first)])));
      }
      return named(checkFrame(names, seen, rest));
    };
    std::vector<std::pair<Index, Eigen::Vector3d>> pairs;
    for (const Told& told : m_told) pairs.emplace_back(told.node, told.place);
    if (const Status status = check(pairs); !status) return status.error();
    for (const Told& told : m_told)
      if (!((m_net.restPosition.col(told.node) - told.place).norm() <= 0.5 * m_edge))
        return invalidValue(m_recording.name + ":" + std::to_string(told.line) +
                            ": node and place do not belong together: "
                            "they are more than half an edge apart");
    pairs.clear();
    for (std::size_t m = 0; m < m_seen.size(); ++m)
      if (const Index node = m_recording.markers[m].node[0]; node != kNoIndex && m_seen[m].allFinite())
        pairs.emplace_back(node, m_seen[m]);
    return check(pairs);
  }

  /// Markers off the nodes to the nearest point of the surface; without one to the nearest node.
  Status tieLoose()
  {
    for (const Loose& loose : m_loose) {
      Marker best;
      double least = std::numeric_limits<double>::infinity();
      for (Index t = 0; t < m_net.triangleCount(); ++t) {
        const auto corner = [&](int k) -> Eigen::Vector3d {
          return m_net.restPosition.col(m_net.triangles(k, t));
        };
        const Eigen::Vector3d share = nearestWeights(loose.place, corner(0), corner(1), corner(2));
        const double distance =
          (share[0] * corner(0) + share[1] * corner(1) + share[2] * corner(2) - loose.place).norm();
        if (!(distance < least)) continue;
        least = distance;
        best = {{m_net.triangles(0, t), m_net.triangles(1, t), m_net.triangles(2, t)},
                {share[0], share[1], share[2]}};
      }
      if (m_net.triangleCount() == 0) {
        best = Marker::ofNode(nearestOf(m_net.restPosition, loose.place));
        least = (m_net.restPosition.col(best.node[0]) - loose.place).norm();
      }
      if (!(least <= 0.5 * m_edge))
        return invalidValue(m_recording.name + ":" + std::to_string(loose.line) + ": the marker lies " +
                            formatDouble(least, 3) +
                            " m off the net, more than half an edge; is the unit of length "
                            "right (--length-unit), and are the axes those of the net?");
      m_recording.markers[loose.marker] = best;
      m_seen[loose.marker] +=
        best.at(restOf(m_net)) - loose.place; // how far it moved counts, not the way to the net
    }
    return {};
  }

  Status takeWeights()
  {
    const auto isNone = [](double sd) { return std::isnan(sd); };
    if (std::all_of(m_sd.begin(), m_sd.end(), isNone)) return {};
    if (std::any_of(m_sd.begin(), m_sd.end(), isNone))
      return invalidValue(m_recording.name +
                          ": some markers have an sd and some have none; give all or none");
    for (const double sd : m_sd) m_recording.weight.push_back(1.0 / sd);
    return {};
  }

  struct Loose {
    std::size_t marker;
    Eigen::Vector3d place;
    int line;
  };
  struct Told {
    Index node;
    Eigen::Vector3d place;
    int line;
  };
  CsvReader m_reader;
  const SpringNet& m_net;
  RecordingUnits m_units;
  double m_edge;
  std::array<std::optional<std::size_t>, kColumnCount> m_column;
  std::map<Index, Index> m_nodeOf;
  std::map<Index, int> m_lineOf; ///< of the marker of a node
  std::vector<Eigen::Vector3d> m_seen;
  std::vector<double> m_sd;
  std::vector<Loose> m_loose;
  std::vector<Told> m_told;
  Recording m_recording;
};

} // namespace

Result<Recording> readRecordingCsv(std::string_view bytes, const std::string& fileName, const SpringNet& net,
                                   const RecordingUnits& units)
{
  Result<CsvReader> reader = CsvReader::open(bytes, fileName);
  if (!reader) return reader.error();
  return Reading(std::move(*reader), fileName, net, units).read();
}

std::string recordingCsv(const Recording& recording, const SpringNet& net)
{
  std::string text = "what,node,x,y,z,vx,vy,vz,sd\n";
  const auto row = [&](const char* what, Index node, const Eigen::Vector3d* place,
                       const Eigen::Vector3d& value, double sd) {
    text += what;
    text += ',';
    if (node != kNoIndex) text += std::to_string(static_cast<Index>(net.nodeId[at(node)]));
    for (int axis = 0; axis < 3; ++axis) {
      text += ',';
      if (place != nullptr) appendDouble(text, (*place)[axis]);
    }
    for (int axis = 0; axis < 3; ++axis) {
      text += ',';
      appendDouble(text, value[axis]);
    }
    text += ',';
    if (sd > 0.0) appendDouble(text, sd);
    text += '\n';
  };
  const Loads& loads = recording.loads;
  if (!loads.gravity.isZero(0.0)) row("gravity", kNoIndex, nullptr, loads.gravity, 0.0);
  for (const NodalForce& force : loads.forces)
    for (const Index node : force.nodes) row("force", node, nullptr, force.force.at(recording.time), 0.0);
  for (const PrescribedMotion& motion : loads.motions)
    for (const Index node : motion.nodes)
      row("move", node, nullptr, motion.displacement.at(recording.time), 0.0);
  for (std::size_t m = 0; m < recording.markers.size(); ++m) {
    const Marker& marker = recording.markers[m];
    const Eigen::Vector3d seen = recording.position.col(static_cast<Eigen::Index>(m));
    if (!seen.allFinite()) continue;
    const double sd = recording.weight.empty() ? 0.0 : 1.0 / recording.weight[m];
    if (marker.node[1] == kNoIndex) {
      row("marker", marker.node[0], nullptr, seen, sd);
      continue;
    }
    Eigen::Vector3d rest = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < 3 && marker.node[k] != kNoIndex; ++k)
      rest += marker.share[k] * net.restPosition.col(marker.node[k]);
    row("marker", kNoIndex, &rest, seen, sd);
  }
  return text;
}

Status checkForceUnit(const Recording& recording, const SpringNet& net)
{
  const Loads& loads = recording.loads;
  if (loads.forces.empty() || !loads.motions.empty() || !loads.gravity.isZero(0.0)) return {};
  Statics unloaded(net, {}), pushed(net, loads, recording.time);
  if (unloaded.solve().outcome != StaticsOutcome::Balanced) return {};
  NodeArray change;
  pushed.setPlace(unloaded.place());
  if (!pushed.firstStep(change)) return {};
  double seen = 0.0, answered = 0.0;
  for (std::size_t m = 0; m < recording.markers.size(); ++m) {
    Eigen::Vector3d rest = Eigen::Vector3d::Zero(), way = rest;
    const Marker& marker = recording.markers[m];
    for (std::size_t k = 0; k < 3 && marker.node[k] != kNoIndex; ++k) {
      rest += marker.share[k] * net.restPosition.col(marker.node[k]);
      way += marker.share[k] * toVector(change[at(marker.node[k])]);
    }
    const Eigen::Vector3d ofMarker = recording.position.col(static_cast<Eigen::Index>(m)) - rest;
    if (!ofMarker.allFinite()) continue;
    seen += ofMarker.squaredNorm();
    answered += way.squaredNorm();
  }
  if (!(answered > 0.0)) return {};
  const double ratio = std::sqrt(answered / seen);
  if (ratio > kFarFromExpected)
    return invalidValue(recording.name + ": pushed by these forces the net would move " +
                        formatDouble(ratio, 2) +
                        " times as far as was seen: are they in mN? Then give --force-unit mN");
  if (ratio < 1.0 / kFarFromExpected)
    return invalidValue(recording.name + ": pushed by these forces the net would move a " +
                        formatDouble(1.0 / ratio, 2) +
                        "th of what was seen: are they in kN? Then give --force-unit kN");
  return {};
}

} // namespace esm::learning
