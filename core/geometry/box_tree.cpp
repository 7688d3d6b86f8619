// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/box_tree.h"

#include <algorithm>
#include <numeric>

namespace esm {

namespace {

constexpr Index kMostInLeaf = 4;

struct BoxSplitter {
  const std::vector<Eigen::AlignedBox3d>& boxes;
  double margin;
  const std::function<bool()>& isOver;
  std::vector<BoxTree::Node>& nodes;
  std::vector<Index>& order;

  void split(Index node, Index first, Index count)
  {
    Eigen::AlignedBox3d box;
    for (Index i = first; i < first + count; ++i) box.extend(boxes[at(order[at(i)])]);
    const Eigen::Vector3d sides = box.sizes();
    int axis = 0;
    const Eigen::Vector3d more = Eigen::Vector3d::Constant(margin * sides.maxCoeff(&axis));
    BoxTree::Node& here = nodes[at(node)];
    here.box = {box.min() - more, box.max() + more};
    here.first = first;
    here.count = count;
    if (count <= kMostInLeaf || isOver()) return;
    const auto begin = order.begin() + first;
    const auto middle = [&](Index i) { return boxes[at(i)].min()[axis] + boxes[at(i)].max()[axis]; };
    std::nth_element(begin, begin + count / 2, begin + count, [&](Index a, Index b) {
      return middle(a) != middle(b) ? middle(a) < middle(b) : a < b;
    });
    const auto child = static_cast<Index>(nodes.size());
    here.first = child;
    here.count = 0;
    nodes.resize(nodes.size() + 2);
    split(child, first, count / 2);
    split(child + 1, first + count / 2, count - count / 2);
  }
};

} // namespace

BoxTree::BoxTree(const std::vector<Eigen::AlignedBox3d>& boxes, double margin,
                 const std::function<bool()>& isOver)
  : m_order(boxes.size())
{
  if (boxes.empty()) return;
  std::iota(m_order.begin(), m_order.end(), 0);
  m_nodes.reserve(boxes.size());
  m_nodes.emplace_back();
  BoxSplitter{boxes, margin, isOver, m_nodes, m_order}.split(0, 0, static_cast<Index>(boxes.size()));
}

} // namespace esm
