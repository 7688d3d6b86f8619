// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// Extended position based dynamics (Macklin, Mueller, Chentanez 2016) with many small substeps of one
// iteration each (Macklin et al. 2019) and the damping of section 5.2 of the first paper. A nonlinear spring
// has the compliance of its secant.
#include "bench/reference/method.h"

#include <cmath>

namespace esm::bench {
namespace {

class Xpbd final : public Method {
public:
  void prepare(FastNet& net, double setting, const Scales&) override
  {
    m_steps = static_cast<int>(setting);
    m_force.resize(net.nodeCount());
  }

  bool frame(FastNet& net, double t0, double t1, bool, Nodes& x, Nodes& v) override
  {
    const double h = (t1 - t0) / m_steps;
    const std::vector<double>& w = net.inverseMass();
    for (int step = 0; step < m_steps; ++step) {
      m_before = x;
      net.externalForces(t0 + (step + 1) * h, m_force.data());
      for (std::size_t i = 0; i < x.size(); ++i) x[i] += (v[i] + m_force[i] * (h * w[i])) * h;
      for (const FastNet::Anchor& anchor : net.anchors()) { // a constraint per axis, solved exactly
        const auto i = static_cast<std::size_t>(anchor.node);
        if (w[i] == 0.0) continue;
        const double pull = h * h * w[i] * anchor.stiffness, drag = h * w[i] * anchor.viscosity;
        x[i] = (x[i] + anchor.point * pull + m_before[i] * drag) / (1.0 + pull + drag);
      }
      for (const FastNet::Spring& spring : net.springs()) project(spring, w, h, x);
      for (std::size_t i = 0; i < x.size(); ++i)
        if (w[i] > 0.0) v[i] = (x[i] - m_before[i]) / h;
    }
    return true;
  }

private:
  void project(const FastNet::Spring& spring, const std::vector<double>& w, double h, Nodes& x) const
  {
    const auto a = static_cast<std::size_t>(spring.a), b = static_cast<std::size_t>(spring.b);
    const double weight = w[a] + w[b];
    const Vec4 d = x[b] - x[a];
    const double length = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    if (weight == 0.0 || length < 1e-12) return;
    const double c = length - spring.rest;
    double k = spring.stiffness;
    if (spring.law != SpringLaw::Linear && std::abs(c) > 1e-12) k = FastNet::tension(spring, c) / c;
    if (!(k > 0.0)) return;
    const Vec4 u = d / length, moved = (d - (m_before[b] - m_before[a])) * u;
    const double compliance = 1.0 / (k * h * h), gamma = spring.viscosity / (k * h);
    const double lambda =
      (-c - gamma * (moved[0] + moved[1] + moved[2])) / ((1.0 + gamma) * weight + compliance);
    x[a] -= u * (lambda * w[a]);
    x[b] += u * (lambda * w[b]);
  }

  int m_steps = 1;
  Nodes m_force, m_before;
};

} // namespace

std::unique_ptr<Method> makeXpbd()
{
  return std::make_unique<Xpbd>();
}

} // namespace esm::bench
