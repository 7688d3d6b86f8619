// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/axis.h"
#include "core/fuzzy/control_surface.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace esm::fuzzy {

namespace {

/// An edge of the grid, by its lower left end: (row * columns + column) * 2, plus 1 for an upright edge.
using Edge = std::size_t;

/// Segments of one level, joined where they meet on an edge. Each edge is crossed at most once.
class Joints {
public:
  void connect(Edge a, Edge b)
  {
    m_neighbours[a].push_back(b);
    m_neighbours[b].push_back(a);
  }
  /// Takes out one line, open ones first; empty if there is none left.
  std::vector<Edge> takeLine()
  {
    const auto end = std::find_if(m_neighbours.begin(), m_neighbours.end(),
                                  [](const auto& joint) { return joint.second.size() == 1; });
    auto start = end != m_neighbours.end() ? end : m_neighbours.begin();
    if (start == m_neighbours.end()) return {};
    std::vector<Edge> line{start->first};
    for (;;) {
      const auto here = m_neighbours.find(line.back());
      if (here == m_neighbours.end()) return line;
      const Edge next = here->second.back();
      forget(here->first, next);
      line.push_back(next);
    }
  }

private:
  void forget(Edge a, Edge b)
  {
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
      const auto joint = m_neighbours.find(from);
      auto& others = joint->second;
      others.erase(std::find(others.begin(), others.end(), to));
      if (others.empty()) m_neighbours.erase(joint);
    }
  }
  std::map<Edge, std::vector<Edge>> m_neighbours; // ordered: equal input gives equal lines
};

} // namespace

std::vector<ContourLine> contourLines(const ControlSurface& surface, const Variable& output, double level)
{
  const std::size_t columns = surface.columns(), rows = surface.rows();
  const double wanted = toAxis(output, level);
  std::vector<double> height(surface.value.size());
  std::transform(surface.value.begin(), surface.value.end(), height.begin(),
                 [&](double value) { return toAxis(output, value) - wanted; });
  const auto flat = [&](std::size_t row, std::size_t column) { return 2 * (row * columns + column); };
  Joints joints;
  for (std::size_t r = 0; r + 1 < rows; ++r)
    for (std::size_t c = 0; c + 1 < columns; ++c) {
      if (!surface.firedAt(r, c) || !surface.firedAt(r, c + 1) || !surface.firedAt(r + 1, c) ||
          !surface.firedAt(r + 1, c + 1))
        continue;
      const double corner[4] = {height[r * columns + c], height[r * columns + c + 1],
                                height[(r + 1) * columns + c + 1], height[(r + 1) * columns + c]};
      const Edge edge[4] = {flat(r, c), flat(r, c + 1) + 1, flat(r + 1, c),
                            flat(r, c) + 1}; // i: corner i to i + 1
      const auto above = [&](int i) { return corner[i % 4] >= 0.0; };
      std::vector<int> crossed;
      for (int i = 0; i < 4; ++i)
        if (above(i) != above(i + 1)) crossed.push_back(i);
      if (crossed.size() == 2) joints.connect(edge[crossed[0]], edge[crossed[1]]);
      if (crossed.size() == 4) { // a saddle: cut off the corners that differ from the middle
        const bool middle = corner[0] + corner[1] + corner[2] + corner[3] >= 0.0;
        const int first = above(0) != middle ? 0 : 1;
        joints.connect(edge[first], edge[(first + 3) % 4]);
        joints.connect(edge[first + 1], edge[(first + 2) % 4]);
      }
    }
  const auto pointOn = [&](Edge edge) -> std::array<double, 2> {
    const std::size_t place = edge / 2, next = place + (edge % 2 == 0 ? 1 : columns);
    const double share = height[place] / (height[place] - height[next]);
    const std::size_t whole = place / columns;
    const auto column = static_cast<double>(place % columns), row = static_cast<double>(whole);
    return edge % 2 == 0 ? std::array{column + share, row} : std::array{column, row + share};
  };
  std::vector<ContourLine> lines;
  for (std::vector<Edge> line = joints.takeLine(); !line.empty(); line = joints.takeLine()) {
    lines.emplace_back();
    for (const Edge edge : line) lines.back().push_back(pointOn(edge));
  }
  return lines;
}

std::vector<double> contourLevels(double least, double greatest, bool logarithmic, int most)
{
  std::vector<double> levels;
  if (!(greatest > least) || most < 1) return levels;
  if (!logarithmic) {
    double power = std::pow(10.0, std::floor(std::log10((greatest - least) / (most + 1))));
    for (int number = 0;; ++number) { // 1, 2, 5, 10, 20, ... powers
      const double step = power * (number % 3 == 0 ? 1.0 : number % 3 == 1 ? 2.0 : 5.0);
      levels.clear();
      for (double i = std::floor(least / step) + 1.0; i * step < greatest; i += 1.0)
        levels.push_back(i * step);
      if (levels.size() <= static_cast<std::size_t>(most)) return levels;
      if (number % 3 == 2) power *= 10.0;
    }
  }
  // 1, 2 and 5 of each decade; only the tens, every second, third ... of them where that is too many.
  const auto lowest = static_cast<int>(std::floor(std::log10(least)));
  const auto highest = static_cast<int>(std::ceil(std::log10(greatest)));
  for (int every = 0;; ++every) {
    levels.clear();
    for (int decade = lowest; decade <= highest; ++decade)
      for (const double factor : {1.0, 2.0, 5.0}) {
        if (every > 0 && (factor > 1.0 || decade % every != 0)) continue;
        const double level = factor * std::pow(10.0, decade);
        if (level > least && level < greatest) levels.push_back(level);
      }
    if (levels.size() <= static_cast<std::size_t>(most)) return levels;
  }
}

} // namespace esm::fuzzy
