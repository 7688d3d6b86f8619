// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/lanes.h"
#include "core/fuzzy/fis/compiled.h"

#include <algorithm>
#include <type_traits>

namespace esm::fis {

namespace {

/// Within which fuzzylite takes numbers as equal.
constexpr double kWidth = 1e-6;

/// Norms known at compile time, so that loops over samples run several at once. Minimum and maximum without
/// the care for NaN that slots need: a set's height is a number.
template <TNorm N>
struct Cut {
  double operator()(double a, double b) const
  {
    if constexpr (N == TNorm::Minimum) return a < b ? a : b;
    return apply(N, a, b, kWidth);
  }
};
template <SNorm N>
struct Join {
  double operator()(double a, double b) const
  {
    if constexpr (N == SNorm::Maximum) return a > b ? a : b;
    return apply(N, a, b, kWidth);
  }
};

template <class Use>
void withCut(TNorm norm, const Use& use)
{
  switch (norm) {
  case TNorm::Minimum:
    return use(Cut<TNorm::Minimum>{});
  case TNorm::AlgebraicProduct:
    return use(Cut<TNorm::AlgebraicProduct>{});
  case TNorm::BoundedDifference:
    return use(Cut<TNorm::BoundedDifference>{});
  case TNorm::DrasticProduct:
    return use(Cut<TNorm::DrasticProduct>{});
  case TNorm::EinsteinProduct:
    return use(Cut<TNorm::EinsteinProduct>{});
  case TNorm::HamacherProduct:
    return use(Cut<TNorm::HamacherProduct>{});
  case TNorm::NilpotentMinimum:
    return use(Cut<TNorm::NilpotentMinimum>{});
  }
}
template <class Use>
void withJoin(SNorm norm, const Use& use)
{
  switch (norm) {
  case SNorm::Maximum:
    return use(Join<SNorm::Maximum>{});
  case SNorm::AlgebraicSum:
    return use(Join<SNorm::AlgebraicSum>{});
  case SNorm::BoundedSum:
    return use(Join<SNorm::BoundedSum>{});
  case SNorm::DrasticSum:
    return use(Join<SNorm::DrasticSum>{});
  case SNorm::EinsteinSum:
    return use(Join<SNorm::EinsteinSum>{});
  case SNorm::HamacherSum:
    return use(Join<SNorm::HamacherSum>{});
  case SNorm::NilpotentMaximum:
    return use(Join<SNorm::NilpotentMaximum>{});
  case SNorm::NormalizedSum:
    return use(Join<SNorm::NormalizedSum>{});
  case SNorm::UnboundedSum:
    return use(Join<SNorm::UnboundedSum>{});
  }
}

/// y = max(y, min(table, degree)): nearly every evaluation of nearly every rule base.
ESM_CPU_CLONES void joinCut(double* y, const double* table, double degree, std::size_t count) noexcept
{
  for (std::size_t i = 0; i < count; ++i) {
    const double cut = table[i] < degree ? table[i] : degree;
    y[i] = y[i] > cut ? y[i] : cut;
  }
}

struct Moments {
  double area = 0.0, moment = 0.0;
};
/// Eight sums side by side: one alone waits for each addition before.
ESM_CPU_CLONES Moments momentsOf(const double* x, const double* y, std::size_t count) noexcept
{
  Lanes area0{}, area1{}, moment0{}, moment1{};
  std::size_t i = 0;
  for (; i + 8 <= count; i += 8) {
    Lanes x0, x1, y0, y1;
    loadLanes(x + i, x0);
    loadLanes(x + i + 4, x1);
    loadLanes(y + i, y0);
    loadLanes(y + i + 4, y1);
    area0 += y0;
    area1 += y1;
    moment0 += x0 * y0;
    moment1 += x1 * y1;
  }
  const Lanes area = area0 + area1, moment = moment0 + moment1;
  Moments sum{(area[0] + area[2]) + (area[1] + area[3]), (moment[0] + moment[2]) + (moment[1] + moment[3])};
  for (; i < count; ++i) {
    sum.area += y[i];
    sum.moment += x[i] * y[i];
  }
  return sum;
}

/// The aggregated set at the middles of n equal steps.
class Samples {
public:
  Samples(const Compiled& c, const FlatOutput& output, Scratch& s)
    : m_c(c),
      m_output(output),
      m_s(s),
      m_count(at(output.resolution)),
      m_step((output.maximum - output.minimum) / output.resolution)
  {}

  double x(std::size_t i) const { return m_output.minimum + (static_cast<double>(i) + 0.5) * m_step; }
  double xFromRight(std::size_t i) const
  {
    return m_output.maximum - (static_cast<double>(i) + 0.5) * m_step;
  }
  double y(std::size_t i) const { return m_s.samples[i]; }
  std::size_t count() const { return m_count; }

  /// The part outside of which all samples are 0.
  std::size_t first() const { return std::min(m_first, m_end); }
  std::size_t end() const { return m_end; }
  const double* values() const { return m_s.samples.data(); }
  /// The places of the samples, or null if they were not tabulated.
  const double* grid() const { return m_output.tabulated ? m_c.tables.data() + m_output.gridFirst : nullptr; }

  void fill()
  {
    std::fill_n(m_s.samples.begin(), m_count, 0.0);
    m_first = m_count;
    m_end = 0;
    for (const ActiveSet& set : m_s.sets)
      withCut(set.implication,
              [&](auto cut) { withJoin(m_output.aggregation, [&](auto join) { add(set, cut, join); }); });
  }

private:
  template <class CutNorm, class JoinNorm>
  void add(const ActiveSet& set, CutNorm cut, JoinNorm join)
  {
    double* y = m_s.samples.data();
    const double degree = set.degree;
    if (m_output.tabulated && set.hedges.empty()) {
      const FlatTerm& term = m_c.terms[at(set.term)];
      const double* table = m_c.tables.data() + term.tableFirst;
      // Where the curve is 0 nothing is added, but for sums that round up to 1 or cuts of degrees above 1.
      const bool skips = degree <= 1.0 && m_output.aggregation != SNorm::NilpotentMaximum;
      const std::size_t from = skips ? at(term.support.first) : 0,
                        to = skips ? at(term.support.end()) : m_count;
      m_first = std::min(m_first, from), m_end = std::max(m_end, to);
      if constexpr (std::is_same_v<CutNorm, Cut<TNorm::Minimum>> &&
                    std::is_same_v<JoinNorm, Join<SNorm::Maximum>>)
        joinCut(y + from, table + from, degree, to - from);
      else
        for (std::size_t i = from; i < to; ++i) y[i] = join(y[i], cut(table[i], degree));
      return;
    }
    m_first = 0, m_end = m_count;
    for (std::size_t i = 0; i < m_count; ++i)
      y[i] = join(y[i], cut(applyHedges(set.hedges, membership(set.curve, x(i))), degree));
  }

  const Compiled& m_c;
  const FlatOutput& m_output;
  Scratch& m_s;
  std::size_t m_count, m_first = 0, m_end = 0;
  double m_step;
};

double centroid(const Samples& samples)
{
  const std::size_t first = samples.first(), count = samples.end() - first;
  Moments sum;
  if (const double* x = samples.grid())
    sum = momentsOf(x + first, samples.values() + first, count);
  else
    for (std::size_t i = first; i < samples.end(); ++i) {
      sum.area += samples.y(i);
      sum.moment += samples.y(i) * samples.x(i);
    }
  return sum.moment / sum.area;
}

/// Grows the smaller of two areas from both ends until they meet, as fuzzylite does.
struct Bisection {
  double left = 0.0, right = 0.0, xLeft = 0.0, xRight = 0.0;
  std::size_t leftCount = 0, rightCount = 0;
  double value() const { return (left * xRight + right * xLeft) / (left + right); }
};

Bisection bisect(const Samples& samples, double minimum, double maximum)
{
  Bisection b;
  b.xLeft = minimum;
  b.xRight = maximum;
  while (b.leftCount + b.rightCount < samples.count()) {
    if (b.left < b.right || near(b.left, b.right, kWidth)) {
      b.xLeft = samples.x(b.leftCount);
      b.left += samples.y(b.leftCount++);
    } else {
      b.xRight = samples.xFromRight(b.rightCount);
      b.right += samples.y(samples.count() - 1 - b.rightCount++);
    }
  }
  return b;
}

/// Step by step as fuzzylite does it, so that plateaus which rise a little end alike.
double maximumOf(const Samples& samples, Defuzzifier defuzzifier)
{
  const bool largest = defuzzifier == Defuzzifier::LargestOfMaximum;
  double highest = -1.0;
  std::size_t first = 0, last = 0;
  bool onPlateau = false;
  for (std::size_t i = 0; i < samples.count(); ++i) {
    const double y = samples.y(i);
    const bool equal = near(y, highest, kWidth);
    if (largest ? equal || y > highest : !equal && y > highest) {
      highest = y;
      first = last = i;
      onPlateau = true;
    } else if (onPlateau && equal) {
      last = i;
    } else if (y < highest) {
      onPlateau = onPlateau && equal;
    }
  }
  return defuzzifier == Defuzzifier::MeanOfMaximum ? 0.5 * (samples.x(first) + samples.x(last))
                                                   : samples.x(first);
}

} // namespace

double defuzzifySampled(const Compiled& c, const FlatOutput& output, Scratch& s) noexcept
{
  Samples samples(c, output, s);
  samples.fill();
  switch (output.defuzzifier) {
  case Defuzzifier::Centroid:
    return centroid(samples);
  case Defuzzifier::Bisector:
    return bisect(samples, output.minimum, output.maximum).value();
  default:
    return maximumOf(samples, output.defuzzifier);
  }
}

void addSampledSlopes(const Compiled& c, const FlatOutput& output, Scratch& s, double factor,
                      const Slopes& slopes) noexcept
{
  if (output.defuzzifier != Defuzzifier::Centroid && output.defuzzifier != Defuzzifier::Bisector)
    return; // a place on the grid does not move
  Samples samples(c, output, s);
  samples.fill();
  std::fill_n(s.byDegree.begin(), s.sets.size(), 0.0);
  double area = 0.0;
  for (std::size_t i = 0; i < samples.count(); ++i) area += samples.y(i);
  const Bisection b = output.defuzzifier == Defuzzifier::Bisector
                        ? bisect(samples, output.minimum, output.maximum)
                        : Bisection{};
  const double value = output.defuzzifier == Defuzzifier::Bisector ? b.value() : centroid(samples);
  for (std::size_t i = 0; i < samples.count(); ++i) {
    double arm = samples.x(i) - value;
    if (output.defuzzifier == Defuzzifier::Bisector) arm = (i < b.leftCount ? b.xRight : b.xLeft) - value;
    addHeightSlopes(c, output, s, samples.x(i), factor * arm / area, s.byDegree, slopes);
  }
  for (std::size_t k = 0; k < s.sets.size(); ++k)
    s.activatedAdjoint[at(s.sets[k].activated)] += s.byDegree[k];
}

} // namespace esm::fis
