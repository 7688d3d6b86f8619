// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/fis/compiled.h"

namespace esm::fis {

namespace {

/// Weighted defuzzifiers over the rules that fired: w the degree, z the term's number at it.
class Weighted {
public:
  Weighted(const Compiled& c, const FlatOutput& output, int outputIndex, Scratch& s)
    : m_c(c), m_output(output), m_s(s), m_count(s.activatedCount[at(outputIndex)])
  {
    const Shape first = c.terms[at(activated(0).term)].shape;
    m_inverts = output.weightedType == WeightedType::Tsukamoto ||
                (output.weightedType == WeightedType::Automatic && !isNumber(first));
    for (int k = 0; k < m_count; ++k) {
      if (!leads(k)) continue;
      const double degree = joinedDegree(k);
      m_sum += degree * z(k, degree);
      m_weights += degree;
    }
  }

  double value() const { return averages() ? m_sum / m_weights : m_sum; }

  void addSlopes(double factor, const Slopes& slopes)
  {
    const double scale = averages() ? factor / m_weights : factor;
    const double centre = averages() ? value() : 0.0;
    for (int k = 0; k < m_count; ++k) {
      if (!leads(k)) continue;
      const Activated& fired = activated(k);
      const Curve curve = m_c.curve(fired.term, m_s.variables);
      const double w = joinedDegree(k);
      double number = z(k, w), byDegree = 0.0;
      if (m_inverts && isMonotone(curve.shape)) {
        const CurveSlope slope = tsukamotoSlope(curve, w, m_output.minimum, m_output.maximum, asFuzzylite());
        byDegree = slope.byX;
        const auto first = at(m_c.terms[at(fired.term)].parameters.first);
        for (int i = 0; i < slope.count; ++i)
          slopes.byNumber[first + at(slope.index[at(i)])] += scale * w * slope.byParameter[at(i)];
        slopes.byNumber[first + curve.parameters.size()] += scale * w * slope.byHeight;
      } else {
        byDegree = addCurveSlopes(m_c, fired.term, curve, w, scale * w, slopes);
      }
      const double byJoined = scale * (number - centre + w * byDegree);
      for (int j = k; j < m_count; ++j)
        if (j == k || (m_output.joins && activated(j).term == fired.term))
          m_s.activatedAdjoint[at(m_output.activated.first + j)] += byJoined * slopeOfJoined(k, j);
    }
  }

private:
  const Activated& activated(int k) const { return m_s.activated[at(m_output.activated.first + k)]; }
  bool averages() const { return m_output.defuzzifier == Defuzzifier::WeightedAverage; }
  bool asFuzzylite() const { return m_c.options.area == Options::Area::Sampled; }

  /// Whether conclusion k counts: by itself, or for all that conclude its term.
  bool leads(int k) const
  {
    for (int j = 0; j < k && m_output.joins; ++j)
      if (activated(j).term == activated(k).term) return false;
    return true;
  }

  /// The degrees of all conclusions of the term of `leader`, gathered; T is double or Dual.
  template <class T, class DegreeOf>
  T gathered(int leader, const DegreeOf& degreeOf) const
  {
    T degree = degreeOf(leader);
    for (int j = leader + 1; j < m_count && m_output.joins; ++j)
      if (activated(j).term == activated(leader).term)
        degree = apply(m_output.aggregation, degree, degreeOf(j), m_c.width);
    return degree;
  }
  double joinedDegree(int leader) const
  {
    return gathered<double>(leader, [&](int k) { return activated(k).degree; });
  }
  /// d(joinedDegree)/d(degree of conclusion `by`).
  double slopeOfJoined(int leader, int by) const
  {
    using D = Dual<1>;
    const D joined = gathered<D>(
      leader, [&](int k) { return k == by ? D::variable(activated(k).degree, 0) : D(activated(k).degree); });
    return joined.d[0];
  }

  double z(int k, double degree) const
  {
    const Curve curve = m_c.curve(activated(k).term, m_s.variables);
    return m_inverts ? tsukamoto(curve, degree, m_output.minimum, m_output.maximum, asFuzzylite())
                     : membership(curve, degree);
  }

  const Compiled& m_c;
  const FlatOutput& m_output;
  Scratch& m_s;
  int m_count;
  bool m_inverts = false;
  double m_sum = 0.0, m_weights = 0.0;
};

} // namespace

double defuzzifyWeighted(const Compiled& c, const FlatOutput& output, int outputIndex, Scratch& s) noexcept
{
  return Weighted(c, output, outputIndex, s).value();
}

void addWeightedSlopes(const Compiled& c, const FlatOutput& output, int outputIndex, Scratch& s,
                       double factor, const Slopes& slopes) noexcept
{
  Weighted(c, output, outputIndex, s).addSlopes(factor, slopes);
}

} // namespace esm::fis
