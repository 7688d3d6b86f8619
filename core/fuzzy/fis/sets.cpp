// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/fis/compiled.h"

#include <algorithm>

namespace esm::fis {

namespace {

bool keepsStraight(TNorm implication)
{
  return implication == TNorm::Minimum || implication == TNorm::AlgebraicProduct ||
         implication == TNorm::BoundedDifference;
}

} // namespace

void collectSets(const Compiled& c, const FlatOutput& output, int outputIndex, Scratch& s) noexcept
{
  s.sets.clear();
  const bool joins = output.aggregation == SNorm::Maximum;
  std::fill(s.setOfTerm.begin() + output.terms.first, s.setOfTerm.begin() + output.terms.end(), -1);
  for (int k = 0; k < s.activatedCount[at(outputIndex)]; ++k) {
    const int place = output.activated.first + k;
    const Activated& activated = s.activated[at(place)];
    int& known = s.setOfTerm[at(activated.term)];
    if (joins && known >= 0) {
      ActiveSet& set = s.sets[at(known)];
      // max(T(set, a), T(set, b)) = T(set, max(a, b)): norms never fall.
      if (set.implication == activated.implication && activated.setHedges.count == 0 &&
          set.setHedges.count == 0) {
        if (activated.degree > set.degree) set.degree = activated.degree, set.activated = place;
        continue;
      }
    }
    known = static_cast<int>(s.sets.size());
    ActiveSet set;
    set.activated = place;
    set.curve = c.curve(activated.term, s.variables);
    set.term = activated.term;
    set.degree = activated.degree;
    set.implication = activated.implication;
    set.setHedges = activated.setHedges;
    set.hedges = c.hedgesOf(activated.setHedges);
    set.straight =
      c.terms[at(activated.term)].straight && set.hedges.empty() && keepsStraight(set.implication);
    s.sets.push_back(set);
  }
}

double heightOf(const ActiveSet& set, double x, double width) noexcept
{
  return apply(set.implication, applyHedges(set.hedges, membership(set.curve, x)), set.degree, width);
}

double heightOfAll(const FlatOutput& output, std::span<const ActiveSet> sets, double x) noexcept
{
  double height = 0.0;
  for (const ActiveSet& set : sets) height = apply(output.aggregation, height, heightOf(set, x));
  return height;
}

double addCurveSlopes(const Compiled& c, int term, const Curve& curve, double x, double factor,
                      const Slopes& slopes) noexcept
{
  const FlatTerm& flat = c.terms[at(term)];
  const auto first = at(flat.parameters.first);
  if (curve.shape == Shape::Linear) {
    const std::size_t inputs = curve.variables.size(), count = curve.parameters.size();
    for (std::size_t i = 0; i < std::min(inputs, count); ++i) {
      slopes.byNumber[first + i] += factor * curve.variables[i];
      slopes.byVariable[1 + i] += factor * curve.parameters[i];
    }
    if (count > inputs) slopes.byNumber[first + count - 1] += factor;
    return 0.0;
  }
  if (curve.shape == Shape::Function) {
    // Place 0 collects the derivative by x, which is the caller's to use.
    slopes.byVariable[0] = 0.0;
    curve.formula->addSlopes(x, curve.variables, factor, slopes.byVariable);
    const double byX = factor != 0.0 ? slopes.byVariable[0] / factor : 0.0;
    return byX;
  }
  const CurveSlope slope = membershipSlope(curve, x);
  for (int i = 0; i < slope.count; ++i)
    slopes.byNumber[first + at(slope.index[at(i)])] += factor * slope.byParameter[at(i)];
  slopes.byNumber[first + curve.parameters.size()] += factor * slope.byHeight;
  return slope.byX;
}

void addHeightSlopes(const Compiled& c, const FlatOutput& output, Scratch& s, double x, double factor,
                     std::span<double> byDegree, const Slopes& slopes) noexcept
{
  double height = 0.0;
  for (std::size_t k = 0; k < s.sets.size(); ++k) {
    s.heights[k] = heightOf(s.sets[k], x, c.width);
    s.prefix[k] = height;
    height = apply(output.aggregation, height, s.heights[k], c.width);
  }
  using D = Dual<2>;
  for (std::size_t k = s.sets.size(); k-- > 0 && factor != 0.0;) {
    const ActiveSet& set = s.sets[k];
    const D joined =
      apply(output.aggregation, D::variable(s.prefix[k], 0), D::variable(s.heights[k], 1), c.width);
    const double own = factor * joined.d[1];
    factor *= joined.d[0];
    if (own == 0.0) continue;
    const double plain = membership(set.curve, x);
    const double hedged = applyHedges(set.hedges, plain);
    const D cut = apply(set.implication, D::variable(hedged, 0), D::variable(set.degree, 1), c.width);
    byDegree[k] += own * cut.d[1];
    const double bySet = own * cut.d[0] * hedgeSlope(set.hedges, plain);
    if (bySet != 0.0) addCurveSlopes(c, set.term, set.curve, x, bySet, slopes);
  }
}

} // namespace esm::fis
