// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/fis/exact_area.h"
#include "core/fuzzy/fis/quadrature.h"

#include <algorithm>
#include <cmath>

namespace esm::fis {

namespace {

/// Derivatives of a value that is an integral over the set: value' = integral of arm(u) * height'(u), where
/// the arm is how far the value follows what is added at u.
class ExactSlopes {
public:
  ExactSlopes(const Compiled& c, const FlatOutput& output, Scratch& s, const ExactArea& area)
    : m_c(c),
      m_output(output),
      m_s(s),
      m_area(area),
      m_size(s.sets.size() + c.numbers.size() + s.variableSlopes.size())
  {}

  template <class Arm>
  void addIntegral(const Arm& arm, double split, double factor, const Slopes& slopes)
  {
    std::fill_n(m_s.partialScale.begin(), m_size, 0.0);
    forEachPiece(split, [&](double u0, double u1) {
      computePart(arm, u0, u1);
      for (std::size_t i = 0; i < m_size; ++i) m_s.partialScale[i] += std::abs(m_s.partial[i]);
    });
    forEachPiece(split, [&](double u0, double u1) {
      halve(u0, u1, [&](double a, double b, bool last) {
        computePart(arm, a, b);
        if (!last && !isFine()) return false;
        addPart(factor, slopes);
        return true;
      });
    });
    addJumps(arm, factor, slopes);
  }

  /// The derivative of a mark's place, in the output's unit.
  void addMark(std::size_t markIndex, double least, double factor, const Slopes& slopes)
  {
    const Mark* mark = markIndex == ExactArea::kNoMark ? nullptr : responsible(markIndex, least);
    if (!mark) return;
    const ActiveSet& set = m_s.sets[at(mark->set)];
    const std::size_t first = at(m_c.terms[at(set.term)].parameters.first);
    if (mark->kind == Mark::Kind::Corner) {
      for (std::size_t i = 0; i < 2; ++i)
        if (mark->corner.index[i] >= 0)
          slopes.byNumber[first + at(mark->corner.index[i])] += factor * mark->corner.slope[i];
      return;
    }
    const double x = m_area.x(mark->u), plain = membership(set.curve, x);
    const double byX = membershipSlope(set.curve, x).byX, bend = hedgeSlope(set.hedges, plain);
    if (byX == 0.0 || bend == 0.0) return;
    m_s.activatedAdjoint[at(set.activated)] += factor * (mark->complement ? -1.0 : 1.0) / (bend * byX);
    addCurveSlopes(m_c, set.term, set.curve, x, -factor / byX, slopes);
  }

private:
  std::span<double> byDegree(std::vector<double>& part) const
  {
    return std::span(part).first(m_s.sets.size());
  }
  Slopes slopesOf(std::vector<double>& part) const
  {
    const std::span<double> rest = std::span(part).subspan(m_s.sets.size());
    return {rest.first(m_c.numbers.size()), rest.subspan(m_c.numbers.size(), m_s.variableSlopes.size())};
  }

  template <class Visit>
  void forEachPiece(double split, const Visit& visit) const
  {
    for (std::size_t i = 0; i + 1 < m_s.marks.size(); ++i) {
      const double u0 = m_s.marks[i].u, u1 = m_s.marks[i + 1].u;
      if (!(u1 > u0)) continue;
      if (split > u0 && split < u1) {
        visit(u0, split);
        visit(split, u1);
      } else {
        visit(u0, u1);
      }
    }
  }

  template <class Arm>
  void computePart(const Arm& arm, double u0, double u1)
  {
    std::fill_n(m_s.partial.begin(), m_size, 0.0);
    std::fill_n(m_s.partialCoarse.begin(), m_size, 0.0);
    ClenshawCurtis::forEachNode(u0, u1, [&](double u, double weight, double coarse) {
      const double x = m_area.x(u), pull = arm(u);
      addHeightSlopes(m_c, m_output, m_s, x, weight * pull, byDegree(m_s.partial), slopesOf(m_s.partial));
      if (coarse != 0.0)
        addHeightSlopes(m_c, m_output, m_s, x, coarse * pull, byDegree(m_s.partialCoarse),
                        slopesOf(m_s.partialCoarse));
    });
  }

  bool isFine() const
  {
    for (std::size_t i = 0; i < m_size; ++i)
      if (std::abs(m_s.partial[i] - m_s.partialCoarse[i]) > 1e-13 * m_s.partialScale[i]) return false;
    return true;
  }

  void addPart(double factor, const Slopes& slopes)
  {
    for (std::size_t k = 0; k < m_s.sets.size(); ++k)
      m_s.activatedAdjoint[at(m_s.sets[k].activated)] += factor * m_s.partial[k];
    const Slopes part = slopesOf(m_s.partial);
    for (std::size_t i = 0; i < part.byNumber.size(); ++i) slopes.byNumber[i] += factor * part.byNumber[i];
    for (std::size_t i = 1; i < part.byVariable.size(); ++i)
      slopes.byVariable[i] += factor * part.byVariable[i];
  }

  /// Edges of rectangles move: what they uncover counts at once. All sets of one term move together.
  template <class Arm>
  void addJumps(const Arm& arm, double factor, const Slopes& slopes)
  {
    const double length = m_output.maximum - m_output.minimum;
    for (const Mark& mark : m_s.marks) {
      if (mark.kind != Mark::Kind::Corner) continue;
      const ActiveSet& set = m_s.sets[at(mark.set)];
      const auto& p = set.curve.parameters;
      if (set.curve.shape != Shape::Rectangle && set.curve.shape != Shape::Binary) continue;
      const auto sameTerm = [&](const ActiveSet& other) { return other.term == set.term; };
      if (&*std::find_if(m_s.sets.begin(), m_s.sets.end(), sameTerm) != &set) continue;
      const bool rises = set.curve.shape == Shape::Binary ? p[1] > p[0] : mark.corner.index[0] == 0;
      const double high = set.curve.height;
      const double step = heightWith(set.term, rises ? 0.0 : high, mark.corner.x) -
                          heightWith(set.term, rises ? high : 0.0, mark.corner.x);
      slopes.byNumber[at(m_c.terms[at(set.term)].parameters.first + mark.corner.index[0])] +=
        factor * arm(mark.u) * step / length;
    }
  }

  /// At x, with this membership of the term in place of its own.
  double heightWith(int term, double plain, double x) const
  {
    double height = 0.0;
    for (const ActiveSet& set : m_s.sets) {
      const double own = set.term == term ? apply(set.implication, applyHedges(set.hedges, plain), set.degree)
                                          : heightOf(set, x);
      height = apply(m_output.aggregation, height, own);
    }
    return height;
  }

  /// Of the marks at one place that which makes the height there: its set reaches it.
  const Mark* responsible(std::size_t markIndex, double least) const
  {
    const double u = m_s.marks[markIndex].u;
    std::size_t i = markIndex;
    while (i > 0 && u - m_s.marks[i - 1].u <= 1e-15) --i;
    for (; i < m_s.marks.size() && m_s.marks[i].u - u <= 1e-15; ++i) {
      const Mark& mark = m_s.marks[i];
      if (mark.set < 0) continue;
      const ActiveSet& set = m_s.sets[at(mark.set)];
      const double x = mark.kind == Mark::Kind::Corner ? mark.corner.x : m_area.x(mark.u);
      if (heightOf(set, x) >= least) return &mark;
    }
    return nullptr;
  }

  const Compiled& m_c;
  const FlatOutput& m_output;
  Scratch& m_s;
  const ExactArea& m_area;
  std::size_t m_size;
};

} // namespace

void addExactSlopes(const Compiled& c, const FlatOutput& output, Scratch& s, double value, double factor,
                    const Slopes& slopes) noexcept
{
  const ExactArea area(output, s);
  ExactSlopes exact(c, output, s, area);
  const double length = output.maximum - output.minimum, place = area.u(value);
  if (output.defuzzifier == Defuzzifier::Centroid) {
    exact.addIntegral([&](double u) { return (u - place) * length / area.area(); }, -1.0, factor, slopes);
    return;
  }
  if (output.defuzzifier == Defuzzifier::Bisector) {
    const double height = area.height(place);
    if (!(height > 0.0)) return;
    exact.addIntegral([&](double u) { return (u < place ? -0.5 : 0.5) * length / height; }, place, factor,
                      slopes);
    return;
  }
  const auto plateau = area.highest();
  const double least = plateau.height * (1.0 - 1e-10);
  if (output.defuzzifier == Defuzzifier::SmallestOfMaximum)
    exact.addMark(plateau.firstMark, least, factor, slopes);
  if (output.defuzzifier == Defuzzifier::LargestOfMaximum)
    exact.addMark(plateau.lastMark, least, factor, slopes);
  if (output.defuzzifier == Defuzzifier::MeanOfMaximum) {
    exact.addMark(plateau.firstMark, least, 0.5 * factor, slopes);
    exact.addMark(plateau.firstEndMark, least, 0.5 * factor, slopes);
  }
}

} // namespace esm::fis
