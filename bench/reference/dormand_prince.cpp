// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// The embedded pair 5(4) of Dormand and Prince (J. Comput. Appl. Math. 6, 1980), first same as last, with the
// PI step control of Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, II.4.
#include "bench/reference/method.h"

#include <algorithm>
#include <cmath>

namespace esm::bench {
namespace {

constexpr double kA[6][6] = {{1.0 / 5},
                             {3.0 / 40, 9.0 / 40},
                             {44.0 / 45, -56.0 / 15, 32.0 / 9},
                             {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
                             {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
                             {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}};
constexpr double kC[6] = {1.0 / 5, 3.0 / 10, 4.0 / 5, 8.0 / 9, 1, 1};
constexpr double kE[7] = {71.0 / 57600,      0,          -71.0 / 16695, 71.0 / 1920,
                          -17253.0 / 339200, 22.0 / 525, -1.0 / 40};

template <int terms>
BENCH_INLINE void combine(std::size_t count, const double* weight, const Vec4* base, const Nodes* slopes,
                          Vec4* out)
{
  const Vec4* k[terms];
  for (int j = 0; j < terms; ++j) k[j] = slopes[j].data();
  for (std::size_t i = 0; i < count; ++i) {
    Vec4 sum = base[i];
    for (int j = 0; j < terms; ++j) sum += k[j][i] * weight[j];
    out[i] = sum;
  }
}

BENCH_CLONES void stageState(int terms, std::size_t count, const double* weight, const Vec4* base,
                             const Nodes* slopes, Vec4* out)
{
  switch (terms) {
  case 1:
    return combine<1>(count, weight, base, slopes, out);
  case 2:
    return combine<2>(count, weight, base, slopes, out);
  case 3:
    return combine<3>(count, weight, base, slopes, out);
  case 4:
    return combine<4>(count, weight, base, slopes, out);
  case 5:
    return combine<5>(count, weight, base, slopes, out);
  default:
    return combine<6>(count, weight, base, slopes, out);
  }
}

BENCH_CLONES double squaredError(std::size_t count, const double* weight, const Nodes* slopes)
{
  Vec4 sum = {0, 0, 0, 0};
  for (std::size_t i = 0; i < count; ++i) {
    Vec4 error = {0, 0, 0, 0};
    for (int j = 0; j < 7; ++j) error += slopes[j][i] * weight[j];
    sum += error * error;
  }
  return sum[0] + sum[1] + sum[2];
}

BENCH_CLONES void scaleByInverseMass(std::size_t count, const double* inverseMass, Vec4* force)
{
  for (std::size_t i = 0; i < count; ++i) force[i] *= inverseMass[i];
}

class DormandPrince final : public Method {
public:
  void prepare(FastNet& net, double setting, const Scales& scales) override
  {
    m_tolerance = setting;
    m_scales = scales;
    for (Nodes& k : m_kx) k.resize(net.nodeCount());
    for (Nodes& k : m_kv) k.resize(net.nodeCount());
    m_h = 1e-6;
  }

  bool frame(FastNet& net, double t0, double t1, bool changed, Nodes& x, Nodes& v) override
  {
    if (changed) firstSlope(net, t0, x, v);
    double t = t0;
    for (long tries = 0; t < t1; ++tries) {
      if (tries > 10'000'000) return false;
      const double left = t1 - t;
      double h = std::min(m_h, left);
      const bool last = h > left * (1 - 1e-12);
      if (!last && h > 0.5 * left) h = 0.5 * left; // no crumb at the end
      const double error = attempt(net, t, h, x, v);
      if (!(error <= 1.0)) {
        m_h = h * (std::isfinite(error) ? std::max(0.2, 0.9 * std::pow(error, -0.2)) : 0.1);
        if (m_h < 1e-12) return false;
        continue;
      }
      const double growth = 0.9 * std::pow(std::max(error, 1e-8), -0.17) * std::pow(m_lastError, 0.04);
      if (!last || growth < 1.0) m_h = h * std::clamp(growth, 0.2, 5.0);
      m_lastError = std::max(error, 1e-4);
      x.swap(m_kxNew);
      v.swap(m_kx[6]);
      m_kx[0] = v;
      m_kv[0].swap(m_kv[6]);
      t = last ? t1 : t + h;
    }
    return true;
  }

private:
  void firstSlope(FastNet& net, double t, const Nodes& x, const Nodes& v)
  {
    m_kx[0] = v;
    net.forces(t, x.data(), v.data(), m_kv[0].data());
    scaleByInverseMass(x.size(), net.inverseMass().data(), m_kv[0].data());
  }

  /// Leaves the new positions in m_kxNew, the new velocities in m_kx[6]. @return error over tolerance.
  double attempt(FastNet& net, double t, double h, const Nodes& x, const Nodes& v)
  {
    const std::size_t count = x.size();
    m_kxNew.resize(count);
    double weight[7];
    for (int s = 0; s < 6; ++s) {
      for (int j = 0; j <= s; ++j) weight[j] = h * kA[s][j];
      stageState(s + 1, count, weight, x.data(), m_kx, m_kxNew.data());
      stageState(s + 1, count, weight, v.data(), m_kv, m_kx[s + 1].data());
      net.forces(t + kC[s] * h, m_kxNew.data(), m_kx[s + 1].data(), m_kv[s + 1].data());
      scaleByInverseMass(count, net.inverseMass().data(), m_kv[s + 1].data());
    }
    for (int j = 0; j < 7; ++j) weight[j] = h * kE[j];
    const double nodes = static_cast<double>(count);
    const double ex = std::sqrt(squaredError(count, weight, m_kx) / nodes) / m_scales.displacement;
    const double ev = std::sqrt(squaredError(count, weight, m_kv) / nodes) / m_scales.speed;
    return std::max(ex, ev) / m_tolerance;
  }

  double m_tolerance = 1e-3, m_h = 1e-6, m_lastError = 1.0;
  Scales m_scales;
  Nodes m_kx[7], m_kv[7], m_kxNew;
};

} // namespace

std::unique_ptr<Method> makeDormandPrince()
{
  return std::make_unique<DormandPrince>();
}

} // namespace esm::bench
