// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/repair/half_edge_mesh.h"

#include "core/base/assert.h"

#include <Eigen/Geometry>

namespace esm {

Index HalfEdgeMesh::valence(Index vertex) const
{
  Index count = 0;
  forNeighbours(vertex, [&](Index, Index) { ++count; });
  return count;
}

bool HalfEdgeMesh::isOnBorder(Index vertex) const
{
  const Index out = firstOut[at(vertex)];
  return out != kNoIndex && twinOf(out) == kNoIndex;
}

bool HalfEdgeMesh::areNeighbours(Index a, Index b) const
{
  bool found = false;
  forNeighbours(a, [&](Index neighbour, Index) { found |= neighbour == b; });
  return found;
}

Eigen::Vector3d HalfEdgeMesh::areaVector(Index t) const
{
  const Eigen::Vector3d& a = position[at(from(3 * t))];
  const Eigen::Vector3d u = position[at(from(3 * t + 1))] - a, v = position[at(from(3 * t + 2))] - a;
  return u.cross(v);
}

void HalfEdgeMesh::setFirstOut()
{
  firstOut.assign(position.size(), kNoIndex);
  liveTriangles = 0;
  for (Index h = 0; h < halfEdges(); ++h) {
    if (!isLive(h)) continue;
    if (h % 3 == 0) ++liveTriangles;
    Index& first = firstOut[at(from(h))];
    if (first == kNoIndex || twinOf(h) == kNoIndex) first = h;
  }
  m_stamp.assign(position.size(), kNoIndex);
  m_stampNow = 0;
}

void HalfEdgeMesh::link(Index h, Index k)
{
  if (h != kNoIndex) twin[at(h)] = k;
  if (k != kNoIndex) twin[at(k)] = h;
}

/// Goes clockwise from `out` to the border, if there is one.
void HalfEdgeMesh::turnToBorder(Index vertex, Index out)
{
  Index h = out;
  while (twinOf(h) != kNoIndex) {
    h = next(twinOf(h));
    if (h == out) break;
  }
  firstOut[at(vertex)] = h;
}

void HalfEdgeMesh::setTriangle(Index t, Index a, Index b, Index c)
{
  corner[at(3 * t)] = a;
  corner[at(3 * t + 1)] = b;
  corner[at(3 * t + 2)] = c;
}

void HalfEdgeMesh::removeTriangle(Index t)
{
  setTriangle(t, kNoIndex, kNoIndex, kNoIndex);
  --liveTriangles;
}

Index HalfEdgeMesh::split(Index h, const Eigen::Vector3d& where)
{
  const Index m = vertices();
  position.push_back(where);
  freedom.push_back(isCurve[at(h)] ? Freedom::Curve : Freedom::Surface);
  isSeam.push_back(0);
  firstOut.push_back(kNoIndex);
  m_stamp.push_back(kNoIndex);

  // Triangle (u, x, a) becomes (u, m, a) and a new (m, x, a); the twin's likewise.
  const auto halve = [&](Index side) {
    const Index x = to(side), a = apex(side), onward = next(side), outer = twinOf(onward);
    const Index added = halfEdges();
    corner.insert(corner.end(), {m, x, a});
    twin.insert(twin.end(), 3, kNoIndex);
    isCurve.insert(isCurve.end(), {isCurve[at(side)], isCurve[at(onward)], 0});
    isRigid.insert(isRigid.end(), {isRigid[at(side)], isRigid[at(onward)], 0});
    corner[at(onward)] = m;
    isCurve[at(onward)] = isRigid[at(onward)] = 0;
    if (outer != kNoIndex) twin[at(outer)] = added + 1;
    twin[at(added + 1)] = outer;
    twin[at(onward)] = added + 2;
    twin[at(added + 2)] = onward;
    if (firstOut[at(x)] == onward) firstOut[at(x)] = added + 1;
    ++liveTriangles;
    return added;
  };
  const Index other = twinOf(h);
  const Index near = halve(h); // m -> x
  firstOut[at(m)] = near;
  if (other == kNoIndex) return m; // twins of h and near are kNoIndex, as they should
  const Index far = halve(other);  // m -> u
  twin[at(h)] = far;
  twin[at(far)] = h;
  twin[at(near)] = other;
  twin[at(other)] = near;
  return m;
}

bool HalfEdgeMesh::canCollapse(Index h, Index gone)
{
  const Index o = twinOf(h);
  const Index kept = from(h) == gone ? to(h) : from(h);
  if (o != kNoIndex && isOnBorder(gone) && isOnBorder(kept)) return false; // would pinch the surface
  // The third corners must not lose their last neighbours.
  for (const Index side : {h, o}) {
    if (side == kNoIndex) continue;
    const Index left = twinOf(next(side)), right = twinOf(previous(side));
    if (left == kNoIndex && right == kNoIndex) return false;
    if (isCurve[at(next(side))] && isCurve[at(previous(side))])
      return false; // would fold a curve onto itself
    if (left != kNoIndex && right != kNoIndex && apex(left) == apex(right) && valence(apex(side)) == 3)
      return false;
  }
  // Link condition: nobody but the third corners is a neighbour of both ends.
  ++m_stampNow;
  forNeighbours(kept, [&](Index neighbour, Index) { m_stamp[at(neighbour)] = m_stampNow; });
  Index common = 0;
  bool joinsSeams = false;
  forNeighbours(gone, [&](Index neighbour, Index) {
    if (m_stamp[at(neighbour)] == m_stampNow)
      ++common;
    else if (neighbour != kept && isSeam[at(kept)] && isSeam[at(neighbour)])
      joinsSeams = true;
  });
  return !joinsSeams && common == (o == kNoIndex ? 1 : 2);
}

void HalfEdgeMesh::collapse(Index h, Index gone)
{
  const Index o = twinOf(h);
  const Index kept = from(h) == gone ? to(h) : from(h);
  // All triangles at `gone` go over to `kept`; collected first, for the walk reads what it changes.
  Index out = firstOut[at(gone)];
  const Index first = out;
  do {
    const Index following = twinOf(previous(out));
    corner[at(out)] = kept;
    out = following;
  } while (out != kNoIndex && out != first);

  for (const Index side : {h, o}) {
    if (side == kNoIndex) continue;
    const Index a = apex(side), left = twinOf(next(side)), right = twinOf(previous(side));
    const Index t = side / 3;
    const bool isFirst = firstOut[at(a)] / 3 == t;
    // The two edges become one: a curve, if one of them was. A border has its mark on this side only.
    const auto curve = static_cast<std::uint8_t>(isCurve[at(next(side))] | isCurve[at(previous(side))]);
    const auto rigid = static_cast<std::uint8_t>(isRigid[at(next(side))] | isRigid[at(previous(side))]);
    for (const Index merged : {left, right})
      if (merged != kNoIndex) {
        isCurve[at(merged)] = curve;
        isRigid[at(merged)] = rigid;
      }
    link(left, right);
    removeTriangle(t);
    // left runs a -> kept, right kept -> a.
    if (isFirst) turnToBorder(a, left != kNoIndex ? left : next(right));
    firstOut[at(kept)] = right != kNoIndex ? right : next(left);
  }
  turnToBorder(kept, firstOut[at(kept)]);
  firstOut[at(gone)] = kNoIndex;
}

bool HalfEdgeMesh::canFlip(Index h) const
{
  const Index o = twinOf(h);
  if (o == kNoIndex || isCurve[at(h)] || isRigid[at(h)]) return false;
  const Index a = apex(h), b = apex(o);
  if (a == b || (isSeam[at(a)] && isSeam[at(b)])) return false;
  return !areNeighbours(a, b);
}

void HalfEdgeMesh::flip(Index h)
{
  const Index o = twinOf(h), t = h / 3, s = o / 3;
  struct Side {
    Index twin;
    std::uint8_t isCurve, isRigid;
  };
  const auto take = [&](Index k) { return Side{twinOf(k), isCurve[at(k)], isRigid[at(k)]}; };
  const auto put = [&](Index k, const Side& side) {
    twin[at(k)] = side.twin;
    if (side.twin != kNoIndex) twin[at(side.twin)] = k;
    isCurve[at(k)] = side.isCurve;
    isRigid[at(k)] = side.isRigid;
  };
  const Index u = from(h), x = to(h), a = apex(h), b = apex(o);
  const Side xa = take(next(h)), au = take(previous(h)), ub = take(next(o)), bx = take(previous(o));
  const auto inside = [&](Index vertex) {
    const Index triangle = firstOut[at(vertex)] / 3;
    return triangle == t || triangle == s;
  };
  const bool fixU = inside(u), fixX = inside(x), fixA = inside(a), fixB = inside(b);
  setTriangle(t, a, u, b);
  setTriangle(s, b, x, a);
  put(3 * t, au);
  put(3 * t + 1, ub);
  put(3 * s, bx);
  put(3 * s + 1, xa);
  put(3 * t + 2, {3 * s + 2, 0, 0}); // the new edge: b -> a and a -> b
  put(3 * s + 2, {3 * t + 2, 0, 0});
  if (fixA) firstOut[at(a)] = 3 * t;
  if (fixU) firstOut[at(u)] = 3 * t + 1;
  if (fixB) firstOut[at(b)] = 3 * s;
  if (fixX) firstOut[at(x)] = 3 * s + 1;
}

} // namespace esm
