// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/term_cores.h"
#include "core/fuzzy/term_editing.h"

#include <algorithm>
#include <cmath>

namespace esm::fuzzy {

using namespace editing;

namespace {

/// Half the width of a Gaussian at membership 1/2, in deviations: sqrt(2 ln 2).
constexpr double kHalfWidth = 1.1774100225154747;

/// The term as a trapezoid without infinite feet: where it rises and falls.
struct Corners {
  double leftFoot, left, right, rightFoot;
};

Corners finiteCorners(const Term& term, const Axis& axis)
{
  const Core core = coreOf(term);
  if (!hasCorners(term)) {
    const double flank = 2.0 * kHalfWidth * term.parameters[1];
    return {core.left - flank, core.left, core.right, core.left + flank};
  }
  Corners corners{leftFoot(term), core.left, core.right, rightFoot(term)};
  if (!endsLeft(term) && !endsRight(term)) return {axis.low, core.left, core.right, axis.high};
  if (!endsLeft(term)) { // as steep as on the other side
    corners.left =
      term.shape == Shape::Triangle ? core.left : std::max(core.left, std::min(core.right, axis.low));
    corners.leftFoot = corners.left - (corners.rightFoot - corners.right);
  }
  if (!endsRight(term)) {
    corners.right =
      term.shape == Shape::Triangle ? core.right : std::min(core.right, std::max(core.left, axis.high));
    corners.rightFoot = corners.right + (corners.left - corners.leftFoot);
  }
  return corners;
}

/// Whether memberships reach 1 at the left end of the range, so that a new outermost term must too.
bool coversLeft(const Term& term, const Axis& axis)
{
  return !endsLeft(term) || coreOf(term).left <= axis.low;
}
bool coversRight(const Term& term, const Axis& axis)
{
  return !endsRight(term) || coreOf(term).right >= axis.high;
}

/// The widest room between cores, or outside them if there is nothing between. Shoulders fill what is
/// beyond them.
struct Room {
  double left, right;
};
Room widestRoom(const Variable& variable, bool betweenOnly)
{
  const Axis axis = axisOf(variable);
  const std::vector<int> order = orderOfCores(variable);
  if (order.empty()) return {axis.low, axis.high};
  const auto term = [&](std::size_t i) -> const Term& {
    return variable.terms[static_cast<std::size_t>(order[i])];
  };
  std::vector<Room> rooms;
  for (std::size_t i = 1; i < order.size(); ++i)
    rooms.push_back({coreOf(term(i - 1)).right, coreOf(term(i)).left});
  if (!betweenOnly || rooms.empty()) {
    const Term &first = term(0), &last = term(order.size() - 1);
    if (!coversLeft(first, axis)) rooms.push_back({axis.low, coreOf(first).left});
    if (!coversRight(last, axis)) rooms.push_back({coreOf(last).right, axis.high});
  }
  Room widest{axis.low, axis.high};
  double width = 0.0;
  for (const Room& room : rooms)
    if (room.right - room.left > width) {
      widest = room;
      width = room.right - room.left;
    }
  return widest;
}

} // namespace

Form formOf(const Term& term) noexcept
{
  if (term.shape == Shape::Gaussian) return Form::Gaussian;
  if (!endsLeft(term) && endsRight(term)) return Form::LeftShoulder;
  if (endsLeft(term) && !endsRight(term)) return Form::RightShoulder;
  return term.shape == Shape::Triangle ? Form::Triangle : Form::Trapezoid;
}

Term withForm(const Term& term, Form form, const Axis& axis)
{
  if (formOf(term) == form) return term;
  const Corners c = finiteCorners(term, axis);
  const double width = kLeastGap * spanOf(axis);
  const double middle = c.left + 0.5 * (c.right - c.left);
  const double halfLeft = 0.5 * (c.leftFoot + c.left), halfRight = 0.5 * (c.right + c.rightFoot);
  Term made = term;
  made.shape = form == Form::Trapezoid  ? Shape::Trapezoid
               : form == Form::Gaussian ? Shape::Gaussian
                                        : Shape::Triangle;
  switch (form) {
  case Form::Triangle:
    made.parameters = {2.0 * halfLeft - middle, middle, 2.0 * halfRight - middle};
    break;
  case Form::Trapezoid: {
    const bool flat = c.right > c.left;
    const double left = flat ? c.left : 0.5 * (halfLeft + middle),
                 right = flat ? c.right : 0.5 * (middle + halfRight);
    made.parameters = {2.0 * halfLeft - left, left, right, 2.0 * halfRight - right};
    break;
  }
  case Form::LeftShoulder:
    made.parameters = {-HUGE_VAL, c.right, std::max(c.rightFoot, axis.low + width)};
    break;
  case Form::RightShoulder:
    made.parameters = {std::min(c.leftFoot, axis.high - width), c.left, HUGE_VAL};
    break;
  case Form::Gaussian:
    made.parameters = {middle, std::max(0.5 * (halfRight - halfLeft) / kHalfWidth, width)};
    break;
  }
  return made;
}

std::optional<std::vector<Term>> fittedPartition(const Variable& variable)
{
  std::vector<Term> terms = variable.terms;
  if (!std::all_of(terms.begin(), terms.end(), hasCorners)) return std::nullopt;
  const std::vector<int> order = orderOfCores(variable);
  std::vector<Core> cores;
  for (const int index : order) {
    cores.push_back(coreOf(terms[static_cast<std::size_t>(index)]));
    if (cores.size() > 1 && !(cores[cores.size() - 2].right < cores.back().left)) return std::nullopt;
  }
  putCores(terms, order, cores, axisOf(variable));
  return terms;
}

std::vector<Term> spreadEvenly(const Variable& variable, Outside outside)
{
  std::vector<Term> terms = variable.terms;
  const std::vector<int> order = orderOfCores(variable);
  const Axis axis = axisOf(variable);
  const bool shoulders = outside == Outside::Shoulder && order.size() > 1;
  const auto count = static_cast<int>(order.size());
  const int parts = shoulders ? count - 1 : count + 1;
  const auto peak = [&](int i) { // of places -1 to count; exact at the ends of the range
    const int step = shoulders ? i : i + 1;
    return step == parts ? axis.high : axis.low + spanOf(axis) * step / parts;
  };
  for (int i = 0; i < count; ++i) {
    Term& term = terms[static_cast<std::size_t>(order[static_cast<std::size_t>(i)])];
    term.shape = Shape::Triangle;
    term.parameters = {shoulders && i == 0 ? -HUGE_VAL : peak(i - 1), peak(i),
                       shoulders && i + 1 == count ? HUGE_VAL : peak(i + 1)};
  }
  return terms;
}

std::vector<Term> withNewTerm(const Variable& variable, bool keepPartition)
{
  const bool keep = keepPartition && isPartition(variable);
  const Room room = widestRoom(variable, keep);
  Variable changed = variable;
  changed.terms.push_back(
    {{}, {}, Shape::Triangle, {room.left, room.left + 0.5 * (room.right - room.left), room.right}});
  if (keep)
    if (auto fitted = fittedPartition(changed)) return std::move(*fitted);
  return changed.terms;
}

std::vector<Term> withoutTerm(const Variable& variable, int term, bool keepPartition)
{
  const bool keep = keepPartition && isPartition(variable);
  const std::vector<int> order = orderOfCores(variable);
  Variable changed = variable;
  const Term removed = changed.terms[static_cast<std::size_t>(term)];
  changed.terms.erase(changed.terms.begin() + term);
  if (!keep || changed.terms.empty()) return changed.terms;
  const Axis axis = axisOf(variable);
  const std::vector<int> left = orderOfCores(changed);
  if (order.front() == term && coversLeft(removed, axis))
    changed.terms[static_cast<std::size_t>(left.front())].parameters.front() = -HUGE_VAL;
  if (order.back() == term && coversRight(removed, axis))
    changed.terms[static_cast<std::size_t>(left.back())].parameters.back() = HUGE_VAL;
  if (auto fitted = fittedPartition(changed)) return std::move(*fitted);
  return changed.terms;
}

std::vector<int> rulesWith(const RuleBase& ruleBase, const std::string& variable, const std::string& term)
{
  const auto speaks = [&](const Proposition& said) { return said.variable == variable && said.term == term; };
  std::vector<int> found;
  for (std::size_t i = 0; i < ruleBase.rules.size(); ++i) {
    const Rule& rule = ruleBase.rules[i];
    const bool inCondition =
      std::any_of(rule.condition.nodes.begin(), rule.condition.nodes.end(), [&](const Condition::Node& node) {
        return node.kind == Condition::Kind::Proposition && speaks(node.proposition);
      });
    if (inCondition || std::any_of(rule.consequents.begin(), rule.consequents.end(), speaks))
      found.push_back(static_cast<int>(i));
  }
  return found;
}

} // namespace esm::fuzzy
