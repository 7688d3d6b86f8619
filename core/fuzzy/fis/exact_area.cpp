// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/fis/exact_area.h"

#include "core/fuzzy/fis/quadrature.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace esm::fis {

namespace {

/// Of the whole area, for the error of one part. What a part is really off by is far less.
constexpr double kTolerance = 1e-14;

/// The limits of a straight function at the ends of [u0, u1], from two places inside: at the ends it may
/// jump.
template <class F>
std::array<double, 2> lineEnds(const F& f, double u0, double u1)
{
  const double low = f(0.75 * u0 + 0.25 * u1), high = f(0.25 * u0 + 0.75 * u1);
  return {1.5 * low - 0.5 * high, 1.5 * high - 0.5 * low};
}

} // namespace

ExactArea::ExactArea(const FlatOutput& output, Scratch& s)
  : m_output(output), m_s(s), m_length(output.maximum - output.minimum)
{
  s.marks.clear();
  s.segments.clear();
  addMark({});
  Mark end;
  end.u = 1.0;
  addMark(end);
  m_straight = output.aggregation == SNorm::Maximum;
  for (std::size_t k = 0; k < s.sets.size(); ++k) {
    m_straight = m_straight && s.sets[k].straight;
    addMarksOf(static_cast<int>(k));
  }
  sortMarks();
  if (!m_straight && output.aggregation == SNorm::Maximum) addChanges();
  if (output.aggregation == SNorm::BoundedSum || output.aggregation == SNorm::NormalizedSum) addSaturations();
  if (!m_straight)
    for (std::size_t i = 0; i + 1 < s.marks.size(); ++i)
      m_scale +=
        (s.marks[i + 1].u - s.marks[i].u) * std::abs(height(0.5 * (s.marks[i].u + s.marks[i + 1].u)));
  for (std::size_t i = 0; i + 1 < s.marks.size(); ++i) {
    s.segments.push_back(integrate(s.marks[i].u, s.marks[i + 1].u));
    m_area += s.segments.back().area;
    m_moment += s.segments.back().moment;
  }
}

void ExactArea::addMark(const Mark& mark) noexcept
{
  if (mark.u >= 0.0 && mark.u <= 1.0 && m_s.marks.size() < m_s.marks.capacity()) m_s.marks.push_back(mark);
}

void ExactArea::sortMarks() noexcept
{
  std::sort(m_s.marks.begin(), m_s.marks.end(), [](const Mark& a, const Mark& b) {
    return std::tie(a.u, a.kind, a.set) < std::tie(b.u, b.kind, b.set);
  });
}

void ExactArea::addMarksOf(int setIndex) noexcept
{
  const ActiveSet& set = m_s.sets[at(setIndex)];
  const std::size_t first = m_s.marks.size();
  forEachCorner(set.curve, [&](const Corner& corner) {
    Mark mark;
    mark.u = u(corner.x);
    mark.kind = Mark::Kind::Corner;
    mark.set = setIndex;
    mark.corner = corner;
    addMark(mark);
  });
  addLevels(setIndex, first);
  Mark guide;
  forEachGuide(set.curve, [&](double place) {
    guide.u = u(place);
    addMark(guide);
  });
  if (set.curve.shape != Shape::Function || setIndex > 0) return;
  for (int i = 1; i < 32; ++i) { // a formula may do anything anywhere
    guide.u = i / 32.0;
    addMark(guide);
  }
}

/// Between its corners a curve is monotone, so it passes a level once at most.
void ExactArea::addLevels(int setIndex, std::size_t firstMark) noexcept
{
  const ActiveSet& set = m_s.sets[at(setIndex)];
  const bool cuts = set.implication == TNorm::Minimum || set.implication == TNorm::NilpotentMinimum;
  const bool shifts =
    set.implication == TNorm::BoundedDifference || set.implication == TNorm::NilpotentMinimum;
  if (!cuts && !shifts) return;
  const std::size_t end = m_s.marks.size();
  std::sort(m_s.marks.begin() + static_cast<std::ptrdiff_t>(firstMark), m_s.marks.end(),
            [](const Mark& a, const Mark& b) { return a.u < b.u; });
  double u0 = 0.0;
  for (std::size_t i = firstMark; i <= end; ++i) {
    const double u1 = i < end ? m_s.marks[i].u : 1.0;
    if (u1 > u0) {
      if (cuts) addLevel(setIndex, set.degree, false, u0, u1);
      if (shifts) addLevel(setIndex, 1.0 - set.degree, true, u0, u1);
    }
    u0 = u1;
  }
}

void ExactArea::addLevel(int setIndex, double level, bool complement, double u0, double u1) noexcept
{
  const ActiveSet& set = m_s.sets[at(setIndex)];
  const auto plain = [&](double place) { return membership(set.curve, x(place)); };
  const auto above = [&](double place) { return applyHedges(set.hedges, plain(place)) - level; };
  const bool line = isPiecewiseLinear(set.curve.shape);
  const auto ends = line ? lineEnds(plain, u0, u1) : std::array<double, 2>{plain(u0), plain(u1)};
  const double f0 = applyHedges(set.hedges, ends[0]) - level, f1 = applyHedges(set.hedges, ends[1]) - level;
  if (!(f0 * f1 < 0.0)) return;
  Mark mark;
  mark.u = line && set.hedges.empty() ? u0 + (u1 - u0) * (f0 / (f0 - f1)) : root(above, u0, u1, f0, f1);
  mark.kind = Mark::Kind::Level;
  mark.set = setIndex;
  mark.complement = complement;
  addMark(mark);
}

int ExactArea::winner(double place) const noexcept
{
  int best = -1;
  double highest = 0.0;
  for (std::size_t k = 0; k < m_s.sets.size(); ++k) {
    const double height = heightOf(m_s.sets[k], x(place));
    if (best >= 0 && !(height > highest)) continue;
    best = static_cast<int>(k);
    highest = height;
  }
  return best;
}

/// Marks where another set becomes the highest, near enough that the kink no longer counts.
void ExactArea::addChanges() noexcept
{
  const std::size_t end = m_s.marks.size();
  for (std::size_t i = 0; i + 1 < end; ++i) {
    const double width = m_s.marks[i + 1].u - m_s.marks[i].u;
    if (!(width > 1e-9)) continue;
    double from = m_s.marks[i].u + 1e-6 * width;
    const double to = m_s.marks[i + 1].u - 1e-6 * width;
    const int last = winner(to);
    for (int changes = 0, first = winner(from); first != last && changes < 8;
         ++changes, first = winner(from)) {
      double low = from, high = to;
      for (int step = 0; step < 34; ++step) {
        const double middle = 0.5 * (low + high);
        (winner(middle) == first ? low : high) = middle;
      }
      Mark mark;
      mark.u = 0.5 * (low + high);
      addMark(mark);
      from = high;
    }
  }
  sortMarks();
}

/// Marks where sums that end at 1 reach it.
void ExactArea::addSaturations() noexcept
{
  const auto excess = [&](double place) {
    double sum = -1.0;
    for (const ActiveSet& set : m_s.sets) sum += heightOf(set, x(place));
    return sum;
  };
  const std::size_t end = m_s.marks.size();
  for (std::size_t i = 0; i + 1 < end; ++i) {
    const double width = m_s.marks[i + 1].u - m_s.marks[i].u;
    if (!(width > 1e-9)) continue;
    const double from = m_s.marks[i].u + 1e-6 * width, to = m_s.marks[i + 1].u - 1e-6 * width;
    const double before = excess(from), after = excess(to);
    if (!(before * after < 0.0)) continue;
    Mark mark;
    mark.u = root(excess, from, to, before, after);
    addMark(mark);
  }
  sortMarks();
}

namespace {

/// Adds a straight stretch from (u0, v0) to (u1, v1).
void addLine(Segment& sum, double u0, double v0, double u1, double v1) noexcept
{
  const double width = u1 - u0;
  sum.area += 0.5 * width * (v0 + v1);
  sum.moment += width / 6.0 * (u0 * (2.0 * v0 + v1) + u1 * (v0 + 2.0 * v1));
}

} // namespace

/// Walks along the upper envelope of the lines, from crossing to crossing.
Segment ExactArea::integrateLines(double u0, double u1) const noexcept
{
  const std::size_t count = m_s.sets.size();
  std::size_t current = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const auto ends = lineEnds([&](double place) { return heightOf(m_s.sets[k], x(place)); }, u0, u1);
    m_s.starts[k] = ends[0];
    m_s.ends[k] = ends[1];
    if (std::tie(ends[0], ends[1]) > std::tie(m_s.starts[current], m_s.ends[current])) current = k;
  }
  Segment sum;
  const auto value = [&](std::size_t k, double t) {
    return m_s.starts[k] + t * (m_s.ends[k] - m_s.starts[k]);
  };
  for (double t = 0.0;;) {
    double next = 1.0;
    std::size_t follower = current;
    for (std::size_t k = 0; k < count; ++k) {
      const double before = m_s.starts[current] - m_s.starts[k], after = m_s.ends[current] - m_s.ends[k];
      if (!(after < 0.0)) continue;
      const double crossing = std::max(t, before / (before - after));
      if (crossing < next || (crossing == next && follower != current && m_s.ends[k] > m_s.ends[follower]))
        next = crossing, follower = k;
    }
    addLine(sum, u0 + t * (u1 - u0), value(current, t), u0 + next * (u1 - u0), value(current, next));
    if (follower == current) return sum;
    t = next;
    current = follower;
  }
}

Segment ExactArea::integrate(double u0, double u1) const noexcept
{
  Segment sum;
  if (!(u1 > u0)) return sum;
  if (m_straight) return integrateLines(u0, u1);
  halve(u0, u1, [&](double a, double b, bool last) {
    Segment part, rough;
    ClenshawCurtis::forEachNode(a, b, [&](double place, double weight, double coarse) {
      const double value = height(place);
      part.area += weight * value;
      part.moment += weight * place * value;
      rough.area += coarse * value;
      rough.moment += coarse * place * value;
    });
    const double tolerance = kTolerance * m_scale;
    const bool fine =
      std::abs(part.area - rough.area) <= tolerance && std::abs(part.moment - rough.moment) <= tolerance;
    if (!fine && !last && part.area == part.area) return false;
    sum.area += part.area;
    sum.moment += part.moment;
    return true;
  });
  return sum;
}

double ExactArea::centroid() const noexcept
{
  return m_moment / m_area;
}

double ExactArea::bisector() const noexcept
{
  double missing = 0.5 * m_area;
  std::size_t i = 0;
  while (i + 1 < m_s.segments.size() && m_s.segments[i].area < missing) missing -= m_s.segments[i++].area;
  const double start = m_s.marks[i].u;
  double low = start, high = m_s.marks[i + 1].u;
  double place = 0.5 * (low + high);
  for (int step = 0; step < 100 && high > low; ++step) { // Newton, held in a shrinking bracket
    const double excess = integrate(start, place).area - missing;
    (excess > 0.0 ? high : low) = place;
    double next = place - excess / height(place);
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (std::abs(next - place) <= 1e-16) break;
    place = next;
  }
  return place;
}

/// The greatest height between two marks if it is greater than at all probes: products and sums may rise
/// there. Golden section around the best probe.
double ExactArea::riseBetween(std::size_t mark, double known, double& place) const noexcept
{
  double low = m_s.marks[mark].u, high = m_s.marks[mark + 1].u, best = known, bestPlace = low;
  if (!(high - low > 1e-12)) return known;
  ClenshawCurtis::forEachNode(low, high, [&](double u, double, double) {
    if (const double value = height(u); value > best) best = value, bestPlace = u;
  });
  if (!(best > known * (1.0 + 1e-12))) return known;
  const double reach = 0.2 * (high - low); // two probes are never farther apart
  low = std::max(low, bestPlace - reach), high = std::min(high, bestPlace + reach);
  for (int step = 0; step < 80; ++step) {
    const double a = high - 0.6180339887498949 * (high - low), b = low + 0.6180339887498949 * (high - low);
    if (height(a) < height(b))
      low = a;
    else
      high = b;
  }
  place = 0.5 * (low + high);
  return std::max(best, height(place));
}

/// Where the plateau that begins (ends) at `from` really does, up to `limit`: sums saturate between marks.
double ExactArea::plateauEdge(double from, double limit, double least) const noexcept
{
  const auto isHigh = [&](double u) { return height(u) >= least; };
  // A plateau, not the round top of a bell: high a good way off, too.
  if (m_straight || from == limit || !isHigh(from + 1e-3 * (limit - from))) return from;
  double in = from + 1e-3 * (limit - from), out = limit;
  for (int step = 0; step < 60; ++step) {
    const double middle = 0.5 * (in + out);
    (isHigh(middle) ? in : out) = middle;
  }
  return in;
}

ExactArea::Plateau ExactArea::highest() const noexcept
{
  Plateau plateau;
  const auto& marks = m_s.marks;
  const std::size_t count = marks.size();
  for (const Mark& mark : marks) plateau.height = std::max(plateau.height, heightAt(mark));
  double inside = -1.0;
  std::size_t insideMark = 0;
  for (std::size_t i = 0; i + 1 < count && !m_straight; ++i) {
    double place = -1.0;
    const double rise = riseBetween(i, plateau.height, place);
    if (place >= 0.0) plateau.height = rise, inside = place, insideMark = i;
  }
  const double least = plateau.height * (1.0 - 1e-11);
  const auto isHigh = [&](std::size_t mark) { return heightAt(marks[mark]) >= least; };
  const auto staysHigh = [&](std::size_t mark) {
    return height(0.5 * (marks[mark].u + marks[mark + 1].u)) >= least;
  };
  const bool atMark =
    std::any_of(marks.begin(), marks.end(), [&](const Mark& m) { return heightAt(m) >= least; });
  if (!atMark) {
    plateau.first = plateauEdge(inside, marks[insideMark].u, least);
    plateau.firstEnd = plateau.last = plateauEdge(inside, marks[insideMark + 1].u, least);
    plateau.firstMark = plateau.firstEndMark = plateau.lastMark = kNoMark;
    return plateau;
  }
  std::size_t i = 0;
  while (i + 1 < count && !isHigh(i)) ++i;
  plateau.first = i > 0 ? plateauEdge(marks[i].u, marks[i - 1].u, least) : marks[i].u;
  plateau.firstMark = plateau.first == marks[i].u ? i : kNoMark;
  while (i + 1 < count && isHigh(i + 1) && staysHigh(i)) ++i;
  plateau.firstEnd = i + 1 < count ? plateauEdge(marks[i].u, marks[i + 1].u, least) : marks[i].u;
  plateau.firstEndMark = plateau.firstEnd == marks[i].u ? i : kNoMark;
  std::size_t last = count - 1;
  while (last > i && !isHigh(last)) --last;
  plateau.last = last + 1 < count ? plateauEdge(marks[last].u, marks[last + 1].u, least) : marks[last].u;
  plateau.lastMark = plateau.last == marks[last].u ? last : kNoMark;
  return plateau;
}

double defuzzifyExact(const FlatOutput& output, Scratch& s) noexcept
{
  const ExactArea area(output, s);
  if (!(area.area() > 0.0)) return kNoValue;
  double place = 0.0;
  if (output.defuzzifier == Defuzzifier::Centroid) {
    place = area.centroid();
  } else if (output.defuzzifier == Defuzzifier::Bisector) {
    place = area.bisector();
  } else {
    const auto plateau = area.highest();
    place = output.defuzzifier == Defuzzifier::SmallestOfMaximum  ? plateau.first
            : output.defuzzifier == Defuzzifier::LargestOfMaximum ? plateau.last
                                                                  : 0.5 * (plateau.first + plateau.firstEnd);
  }
  return area.x(std::clamp(place, 0.0, 1.0));
}

} // namespace esm::fis
