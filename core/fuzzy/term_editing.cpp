// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/term_editing.h"

#include "core/fuzzy/term_cores.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace esm::fuzzy {

namespace editing {

Core coreOf(const Term& term) noexcept
{
  const std::vector<double>& p = term.parameters;
  if (term.shape == Shape::Gaussian) return {p[0], p[0]};
  return term.shape == Shape::Triangle ? Core{p[1], p[1]} : Core{p[1], p[2]};
}

double middleOf(const Term& term) noexcept
{
  const Core core = coreOf(term);
  if (!endsLeft(term) && endsRight(term)) return core.right;
  if (endsLeft(term) && !endsRight(term)) return core.left;
  return core.left + 0.5 * (core.right - core.left);
}

double spanOf(const Axis& axis) noexcept
{
  return axis.high - axis.low;
}

namespace {

void setCore(Term& term, const Core& core)
{
  term.parameters[1] = core.left;
  if (term.shape == Shape::Trapezoid) term.parameters[2] = core.right;
}

/// The foot on the outer side of an outermost term. `side` is -1 on the left, 1 on the right; all but places
/// are measured outward.
double outerFoot(double foot, double core, double innerWidth, double newCore, double newInnerWidth,
                 double end, int side, double span)
{
  if (!std::isfinite(foot)) return foot;
  const bool reachesEnd = side * (core - end) >= 0.0;
  if (reachesEnd)
    return side * (newCore - end) >= 0.0 ? side * std::max(side * foot, side * newCore) : side * HUGE_VAL;
  const double width = side * (foot - core);
  const bool mirrored = std::abs(width - innerWidth) <= 1e-9 * span;
  return newCore + side * (mirrored ? newInnerWidth : width);
}

} // namespace

void putCores(std::vector<Term>& terms, const std::vector<int>& order, const std::vector<Core>& cores,
              const Axis& axis)
{
  const std::size_t count = order.size();
  for (std::size_t i = 0; i < count; ++i) {
    Term& term = terms[static_cast<std::size_t>(order[i])];
    const Core old = coreOf(term), now = cores[i];
    const double oldLeft = leftFoot(term), oldRight = rightFoot(term);
    double& left = term.parameters.front();
    double& right = term.parameters.back();
    const bool first = i == 0, last = i + 1 == count;
    if (!first) left = cores[i - 1].right;
    if (!last) right = cores[i + 1].left;
    if (first)
      left = outerFoot(oldLeft, old.left, oldRight - old.right, now.left, right - now.right, axis.low, -1,
                       spanOf(axis));
    if (last)
      right = outerFoot(oldRight, old.right, old.left - oldLeft, now.right, now.left - left, axis.high, 1,
                        spanOf(axis));
    setCore(term, now);
  }
}

} // namespace editing

using namespace editing;

namespace {

/// Cores in order, if the terms are a partition.
struct Partition {
  std::vector<int> order;
  std::vector<Core> cores;
};

std::optional<Partition> partitionOf(const Variable& variable)
{
  if (variable.terms.empty() || !std::all_of(variable.terms.begin(), variable.terms.end(), hasCorners))
    return std::nullopt;
  const double slack = 1e-9 * spanOf(axisOf(variable));
  Partition partition{orderOfCores(variable), {}};
  const Term* before = nullptr;
  for (const int index : partition.order) {
    const Term& term = variable.terms[static_cast<std::size_t>(index)];
    const Core core = coreOf(term);
    if (before != nullptr) {
      const Core last = partition.cores.back();
      if (!(last.right < core.left) || !(std::abs(rightFoot(*before) - core.left) <= slack) ||
          !(std::abs(leftFoot(term) - last.right) <= slack))
        return std::nullopt;
    }
    partition.cores.push_back(core);
    before = &term;
  }
  return partition;
}

/// The ends of a partition's cores that move with a handle.
struct Grip {
  std::size_t core = 0; ///< in order
  bool left = false, right = false;
};

/// Nothing for what no neighbour follows: outer feet.
std::optional<Grip> gripOf(const Variable& variable, const Partition& partition, int term, Handle handle)
{
  const auto found = std::find(partition.order.begin(), partition.order.end(), term);
  const auto place = static_cast<std::size_t>(found - partition.order.begin());
  const auto isPeak = [&](std::size_t i) {
    return variable.terms[static_cast<std::size_t>(partition.order[i])].shape == Shape::Triangle;
  };
  switch (handle) {
  case Handle::LeftFoot:
    if (place == 0) return std::nullopt;
    return Grip{place - 1, isPeak(place - 1), true};
  case Handle::RightFoot:
    if (place + 1 == partition.order.size()) return std::nullopt;
    return Grip{place + 1, true, isPeak(place + 1)};
  case Handle::LeftShoulder:
    return Grip{place, true, false};
  case Handle::RightShoulder:
    return Grip{place, false, true};
  default:
    return Grip{place, true, true};
  }
}

/// Limits of the shift of a core, whole or one end of it, so that the partition is kept.
Limits shiftLimits(const Variable& variable, const Partition& partition, const Grip& grip)
{
  const Axis axis = axisOf(variable);
  const double gap = kLeastGap * spanOf(axis);
  const Core core = partition.cores[grip.core];
  const Term& term = variable.terms[static_cast<std::size_t>(partition.order[grip.core])];
  const bool first = grip.core == 0, last = grip.core + 1 == partition.cores.size();
  const double least = first ? axis.low : std::max(axis.low, partition.cores[grip.core - 1].right + gap);
  const double greatest = last ? axis.high : std::min(axis.high, partition.cores[grip.core + 1].left - gap);
  if (grip.left && grip.right)
    return {least - (endsLeft(term) ? core.left : core.right),
            greatest - (endsRight(term) ? core.right : core.left)};
  // The end of a term that fills the range up to its end must stay there, or the sum would fall.
  if (grip.left)
    return first && core.left <= axis.low ? Limits{} : Limits{least - core.left, core.right - core.left};
  return last && core.right >= axis.high ? Limits{} : Limits{core.left - core.right, greatest - core.right};
}

/// Limits of one corner among the others.
Limits cornerLimits(const Term& term, std::size_t corner, const Axis& axis)
{
  const std::vector<double>& p = term.parameters;
  const double width = kLeastGap * spanOf(axis);
  Limits limits{axis.low, axis.high};
  if (corner > 0) limits.least = std::max(limits.least, p[corner - 1]);
  if (corner + 1 < p.size()) limits.greatest = std::min(limits.greatest, p[corner + 1]);
  if (corner == 0) limits.greatest = std::min(limits.greatest, std::min(p.back(), axis.high) - width);
  if (corner + 1 == p.size()) limits.least = std::max(limits.least, std::max(p.front(), axis.low) + width);
  return limits;
}

/// Limits of the shift of a whole term: its core stays in the range, some width of its feet too.
Limits curveLimits(const Term& term, const Axis& axis)
{
  const Core core = coreOf(term);
  const double width = kLeastGap * spanOf(axis);
  Limits limits{axis.low - (endsLeft(term) ? core.left : core.right),
                axis.high - (endsRight(term) ? core.right : core.left)};
  if (!hasCorners(term)) return limits;
  if (endsRight(term)) limits.least = std::max(limits.least, axis.low + width - rightFoot(term));
  if (endsLeft(term)) limits.greatest = std::min(limits.greatest, axis.high - width - leftFoot(term));
  return limits;
}

/// The corner that a handle moves; parameters of a Gaussian have none.
std::size_t cornerOf(const Term& term, Handle handle)
{
  switch (handle) {
  case Handle::LeftFoot:
    return 0;
  case Handle::RightFoot:
    return term.parameters.size() - 1;
  case Handle::RightShoulder:
    return 2;
  default:
    return 1;
  }
}

Limits freeLimits(const Term& term, Handle handle, const Axis& axis)
{
  const double width = kLeastGap * spanOf(axis);
  if (handle == Handle::Curve) {
    const Limits shift = curveLimits(term, axis);
    return {middleOf(term) + shift.least, middleOf(term) + shift.greatest};
  }
  if (hasCorners(term)) return cornerLimits(term, cornerOf(term, handle), axis);
  const double mean = term.parameters[0];
  if (handle == Handle::LeftFlank) return {axis.low, mean - width};
  if (handle == Handle::RightFlank) return {mean + width, axis.high};
  return {axis.low, axis.high};
}

void moveFree(Term& term, Handle handle, double to)
{
  std::vector<double>& p = term.parameters;
  if (handle == Handle::Curve) {
    const double shift = to - middleOf(term);
    for (std::size_t i = 0; i < (hasCorners(term) ? p.size() : 1); ++i) p[i] += shift;
  } else if (hasCorners(term)) {
    p[cornerOf(term, handle)] = to;
  } else if (handle == Handle::Peak) {
    p[0] = to;
  } else {
    p[1] = std::abs(to - p[0]);
  }
}

} // namespace

std::vector<int> orderOfCores(const Variable& variable)
{
  std::vector<int> order(variable.terms.size());
  std::iota(order.begin(), order.end(), 0);
  const auto middle = [&](int i) { return middleOf(variable.terms[static_cast<std::size_t>(i)]); };
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return middle(a) < middle(b); });
  return order;
}

std::vector<Handle> handlesOf(const Term& term)
{
  if (term.shape == Shape::Gaussian) return {Handle::LeftFlank, Handle::Peak, Handle::RightFlank};
  std::vector<Handle> handles;
  if (!endsLeft(term) && !endsRight(term)) return handles; // 1 everywhere
  if (endsLeft(term)) handles.push_back(Handle::LeftFoot);
  if (term.shape == Shape::Triangle) {
    handles.push_back(Handle::Peak);
  } else {
    if (endsLeft(term)) handles.push_back(Handle::LeftShoulder);
    if (endsRight(term)) handles.push_back(Handle::RightShoulder);
  }
  if (endsRight(term)) handles.push_back(Handle::RightFoot);
  return handles;
}

double placeOf(const Term& term, Handle handle) noexcept
{
  if (handle == Handle::Curve) return middleOf(term);
  if (hasCorners(term)) return term.parameters[cornerOf(term, handle)];
  const double mean = term.parameters[0], deviation = term.parameters[1];
  return handle == Handle::LeftFlank    ? mean - deviation
         : handle == Handle::RightFlank ? mean + deviation
                                        : mean;
}

double heightOf(Handle handle) noexcept
{
  if (handle == Handle::LeftFoot || handle == Handle::RightFoot) return 0.0;
  return handle == Handle::LeftFlank || handle == Handle::RightFlank ? 0.60653065971263342 : 1.0; // exp(-1/2)
}

bool isPartition(const Variable& variable)
{
  return partitionOf(variable).has_value();
}

Limits limitsOf(const Variable& variable, int term, Handle handle, bool keepPartition)
{
  const Term& moved = variable.terms[static_cast<std::size_t>(term)];
  const double place = placeOf(moved, handle);
  Limits limits = freeLimits(moved, handle, axisOf(variable));
  const std::optional<Partition> partition = keepPartition ? partitionOf(variable) : std::nullopt;
  if (partition)
    if (const std::optional<Grip> grip = gripOf(variable, *partition, term, handle)) {
      const Limits shift = shiftLimits(variable, *partition, *grip);
      limits = {place + shift.least, place + shift.greatest};
    }
  return limits.least <= limits.greatest ? limits : Limits{place, place};
}

std::vector<Term> moveHandle(const Variable& variable, int term, Handle handle, double to, bool keepPartition)
{
  std::vector<Term> terms = variable.terms;
  Term& moved = terms[static_cast<std::size_t>(term)];
  const double place = placeOf(moved, handle);
  const Limits limits = limitsOf(variable, term, handle, keepPartition);
  if (!std::isfinite(to) || limits.least == limits.greatest) return terms;
  to = std::max(limits.least, std::min(to, limits.greatest));
  std::optional<Partition> partition = keepPartition ? partitionOf(variable) : std::nullopt;
  const std::optional<Grip> grip =
    partition ? gripOf(variable, *partition, term, handle) : std::optional<Grip>{};
  if (!grip) {
    moveFree(moved, handle, to);
    return terms;
  }
  Core& core = partition->cores[grip->core];
  const double shift = to - place;
  if (grip->left) core.left = handle == Handle::Curve ? core.left + shift : to;
  if (grip->right) core.right = handle == Handle::Curve ? core.right + shift : to;
  putCores(terms, partition->order, partition->cores, axisOf(variable));
  return terms;
}

} // namespace esm::fuzzy
