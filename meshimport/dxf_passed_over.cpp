// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/dxf_passed_over.h"

#include "core/base/ascii_case.h"

#include <algorithm>
#include <numeric>

namespace esm {

namespace {

constexpr std::size_t kMostKinds = 64, kMostNamed = 6, kLongestName = 30, kMostParts = 20;
constexpr std::string_view kCurves[] = {"SPLINE", "CIRCLE", "ARC", "ELLIPSE", "HELIX", "MLINE", "LEADER"};
constexpr std::string_view kFilled[] = {"SOLID", "TRACE", "HATCH", "MPOLYGON"};
constexpr std::string_view kSolids[] = {"3DSOLID",
                                        "BODY",
                                        "REGION",
                                        "SURFACE",
                                        "EXTRUDEDSURFACE",
                                        "LOFTEDSURFACE",
                                        "REVOLVEDSURFACE",
                                        "SWEPTSURFACE",
                                        "PLANESURFACE",
                                        "NURBSURFACE",
                                        "MESH"};

std::string joined(const std::vector<std::string>& parts, const char* between)
{
  std::string all;
  for (const std::string& part : parts) all += (all.empty() ? "" : between) + part;
  return all;
}

template <std::size_t n, class Map>
bool holdsOneOf(const std::string_view (&names)[n], const Map& kinds)
{
  return std::any_of(std::begin(names), std::end(names),
                     [&](std::string_view name) { return kinds.find(name) != kinds.end(); });
}

} // namespace

void DxfPassedOver::addKind(std::string_view name)
{
  const auto known = m_kinds.find(name.substr(0, kLongestName));
  if (known != m_kinds.end())
    ++known->second;
  else
    ++m_kinds[m_kinds.size() < kMostKinds ? std::string(name.substr(0, kLongestName)) : "others"];
}

void DxfPassedOver::addLayer(const DxfEntity& layer)
{
  const std::string name = asciiLower(layer.text(2));
  if ((layer.integer(70) & 1) != 0) m_frozen.insert(name);
  if (layer.integer(62) < 0) m_off.insert(name);
}

bool DxfPassedOver::shows(const DxfEntity& entity, std::string_view layer)
{
  const std::string name = asciiLower(layer);
  const bool isPaper = entity.integer(67) != 0, isInvisible = entity.integer(60) != 0;
  const bool onHidden = m_frozen.contains(name) || (entity.name != "INSERT" && m_off.contains(name));
  if (!isPaper && !isInvisible && !onHidden) return true;
  // A viewport is how the sheet shows the model, every layout has one.
  if (entity.name == "VIEWPORT") return false;
  ++(isPaper ? m_paper : isInvisible ? m_invisible : m_onHiddenLayer);
  if (!isPaper && !isInvisible && m_hiddenLayers.size() <= kMostNamed)
    m_hiddenLayers.insert(std::string(layer.substr(0, kLongestName)));
  return false;
}

std::vector<std::string> DxfPassedOver::hidden() const
{
  std::vector<std::string> parts;
  if (m_paper > 0) parts.push_back(std::to_string(m_paper) + " entities in paper space");
  if (m_invisible > 0) parts.push_back(std::to_string(m_invisible) + " invisible entities");
  if (m_onHiddenLayer > 0) {
    std::vector<std::string> names(m_hiddenLayers.begin(), m_hiddenLayers.end());
    if (names.size() > kMostNamed) names.back() = "...";
    parts.push_back(std::to_string(m_onHiddenLayer) + " entities on layers that are frozen or off (" +
                    joined(names, ", ") + ")");
  }
  return parts;
}

/// "3 CIRCLE, 1 TEXT ...", the most frequent ones first.
std::string DxfPassedOver::kinds() const
{
  std::vector<std::pair<std::string, std::size_t>> order(m_kinds.begin(), m_kinds.end());
  std::stable_sort(order.begin(), order.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  std::vector<std::string> parts;
  for (const auto& [name, count] : order) {
    if (parts.size() == kMostNamed) return joined(parts, ", ") + " ...";
    parts.push_back(std::to_string(count) + " " + name);
  }
  return joined(parts, ", ");
}

void DxfPassedOver::tellNotes(std::vector<std::string>& notes) const
{
  const auto total = std::accumulate(m_kinds.begin(), m_kinds.end(), std::size_t{0},
                                     [](std::size_t sum, const auto& kind) { return sum + kind.second; });
  if (total > 0)
    notes.push_back(std::to_string(total) +
                    " entities that are no lines or faces were passed over: " + kinds() + ".");
  for (const std::string& part : hidden()) notes.push_back(part + " were passed over.");
  std::size_t named = 0;
  for (const std::string& part : m_parts) {
    if (named++ == kMostParts) {
      notes.push_back(std::to_string(m_parts.size() - kMostParts) + " more of its parts are missing.");
      break;
    }
    notes.push_back("Its part '" + part +
                    "' is missing here: external drawings are not read; bind them in the drawing program.");
  }
}

std::string DxfPassedOver::reason() const
{
  std::vector<std::string> parts = hidden();
  const bool isHidden = !parts.empty();
  if (!m_kinds.empty()) parts.push_back(kinds());
  if (!m_parts.empty())
    parts.push_back("external drawings ('" + *m_parts.begin() + (m_parts.size() > 1 ? "' ...)" : "')"));
  std::vector<std::string> waysOut;
  if (holdsOneOf(kCurves, m_kinds)) waysOut.push_back("convert curves to polylines in the drawing program");
  if (holdsOneOf(kSolids, m_kinds)) waysOut.push_back("save solids and surfaces as STL");
  if (holdsOneOf(kFilled, m_kinds)) waysOut.push_back("draw filled areas as 3DFACE or polylines");
  if (!m_parts.empty()) waysOut.push_back("bind external drawings in the drawing program");
  if (isHidden) waysOut.push_back("move what is wanted to model space and show it");
  return (parts.empty() ? "" : ", only " + joined(parts, ", ")) +
         (waysOut.empty() ? "" : "; " + joined(waysOut, ", "));
}

} // namespace esm
