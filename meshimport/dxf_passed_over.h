// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "meshimport/dxf_groups.h"

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace esm {

/// What a drawing holds that becomes no spring: kinds that are no lines or faces, and what does not show in
/// its model (the sheet of paper around it, invisible entities, layers that are frozen or off).
class DxfPassedOver {
public:
  void addKind(std::string_view name);
  void addPaper() { ++m_paper; }
  /// A placed block whose lines are in another drawing.
  void addPart(std::string_view name) { m_parts.insert(std::string(name.substr(0, 160))); }
  /// An entry of the table of layers.
  void addLayer(const DxfEntity& layer);
  /// Whether the entity shows if it lies on this layer; if not, it is counted. A block on a layer that is off
  /// shows what it has on layers of its own.
  bool shows(const DxfEntity& entity, std::string_view layer);

  void tellNotes(std::vector<std::string>& notes) const;
  /// For a drawing of nothing else: what it holds, and what would make lines of it.
  std::string reason() const;

private:
  std::vector<std::string> hidden() const;
  std::string kinds() const;
  std::map<std::string, std::size_t, std::less<>> m_kinds;
  std::set<std::string> m_parts;         ///< files
  std::set<std::string> m_frozen, m_off; ///< layers, in lower case
  std::set<std::string> m_hiddenLayers;  ///< some of those that something lies on
  std::size_t m_paper = 0, m_invisible = 0, m_onHiddenLayer = 0;
};

} // namespace esm
