// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// Symplectic Euler, velocity Verlet and the classical Runge-Kutta method with steps chosen by hand.
#include "bench/reference/method.h"

namespace esm::bench {
namespace {

BENCH_CLONES void kick(std::size_t count, double h, const double* inverseMass, const Vec4* force, Vec4* x,
                       Vec4* v)
{
  for (std::size_t i = 0; i < count; ++i) {
    v[i] += force[i] * (h * inverseMass[i]);
    x[i] += v[i] * h;
  }
}

class FixedStep : public Method {
public:
  void prepare(FastNet& net, double setting, const Scales&) override
  {
    m_steps = static_cast<int>(setting);
    m_force.resize(net.nodeCount());
  }

protected:
  int m_steps = 1;
  Nodes m_force;
};

class SymplecticEuler final : public FixedStep {
public:
  bool frame(FastNet& net, double t0, double t1, bool, Nodes& x, Nodes& v) override
  {
    const double h = (t1 - t0) / m_steps;
    for (int step = 0; step < m_steps; ++step) {
      net.forces(t0 + step * h, x.data(), v.data(), m_force.data());
      kick(x.size(), h, net.inverseMass().data(), m_force.data(), x.data(), v.data());
    }
    return true;
  }
};

/// To the new place with the velocity predicted, which the viscous forces look at.
BENCH_CLONES void drift(std::size_t count, double h, const double* inverseMass, const Vec4* force, Vec4* x,
                        Vec4* v)
{
  for (std::size_t i = 0; i < count; ++i) {
    const Vec4 dv = force[i] * (h * inverseMass[i]);
    x[i] += (v[i] + dv * 0.5) * h;
    v[i] += dv;
  }
}

/// v was predicted with the old force; now the mean of both.
BENCH_CLONES void correct(std::size_t count, double h, const double* inverseMass, const Vec4* force,
                          const Vec4* next, Vec4* v)
{
  for (std::size_t i = 0; i < count; ++i) v[i] += (next[i] - force[i]) * (0.5 * h * inverseMass[i]);
}

class VelocityVerlet final : public FixedStep {
public:
  void prepare(FastNet& net, double setting, const Scales& scales) override
  {
    FixedStep::prepare(net, setting, scales);
    m_next.resize(net.nodeCount());
  }
  bool frame(FastNet& net, double t0, double t1, bool changed, Nodes& x, Nodes& v) override
  {
    const double h = (t1 - t0) / m_steps;
    const double* inverseMass = net.inverseMass().data();
    if (changed) net.forces(t0, x.data(), v.data(), m_force.data());
    for (int step = 0; step < m_steps; ++step) {
      drift(x.size(), h, inverseMass, m_force.data(), x.data(), v.data());
      net.forces(t0 + (step + 1) * h, x.data(), v.data(), m_next.data());
      correct(x.size(), h, inverseMass, m_force.data(), m_next.data(), v.data());
      m_force.swap(m_next);
    }
    return true;
  }

private:
  Nodes m_next;
};

/// One stage: adds the weighted slopes to the sums and makes the next stage's state from the start.
BENCH_CLONES void stage(std::size_t count, double weight, double reach, const double* inverseMass,
                        const Vec4* force, const Vec4* x0, const Vec4* v0, Vec4* x, Vec4* v, Vec4* sumX,
                        Vec4* sumV)
{
  for (std::size_t i = 0; i < count; ++i) {
    const Vec4 a = force[i] * inverseMass[i], slope = v[i];
    sumX[i] += slope * weight;
    sumV[i] += a * weight;
    x[i] = x0[i] + slope * reach;
    v[i] = v0[i] + a * reach;
  }
}

class ClassicalRungeKutta final : public FixedStep {
public:
  bool frame(FastNet& net, double t0, double t1, bool, Nodes& x, Nodes& v) override
  {
    const double h = (t1 - t0) / m_steps;
    const double weight[4] = {h / 6, h / 3, h / 3, h / 6}, reach[4] = {h / 2, h / 2, h, 0};
    const double at[4] = {0, h / 2, h / 2, h};
    for (int step = 0; step < m_steps; ++step) {
      m_x0 = m_sumX = x;
      m_v0 = m_sumV = v;
      for (int s = 0; s < 4; ++s) {
        net.forces(t0 + step * h + at[s], x.data(), v.data(), m_force.data());
        stage(x.size(), weight[s], reach[s], net.inverseMass().data(), m_force.data(), m_x0.data(),
              m_v0.data(), x.data(), v.data(), m_sumX.data(), m_sumV.data());
      }
      x.swap(m_sumX);
      v.swap(m_sumV);
    }
    return true;
  }

private:
  Nodes m_x0, m_v0, m_sumX, m_sumV;
};

} // namespace

std::unique_ptr<Method> makeSymplecticEuler()
{
  return std::make_unique<SymplecticEuler>();
}

std::unique_ptr<Method> makeVelocityVerlet()
{
  return std::make_unique<VelocityVerlet>();
}

std::unique_ptr<Method> makeClassicalRungeKutta()
{
  return std::make_unique<ClassicalRungeKutta>();
}

} // namespace esm::bench
