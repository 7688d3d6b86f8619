// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/methods/integrator.h"
#include "core/dynamics/methods/multirate_layout.h"
#include "core/dynamics/methods/stiff_nodes.h"
#include "core/forces/spring_pass.h"

#include <bit>
#include <cmath>
#include <utility>

namespace esm {
namespace {

/// Time per spring, with nodes, ticks and looks, relative to a plain pass over all springs: measured 2.9
/// to 3.4 on nets of 400 and 1,600 nodes with stiffness over six decades.
constexpr double kSpringCost = 3.0;

/// What a class remembers: its share of the nodes' accelerations.
struct ClassMotion {
  NodeArray mean; ///< running mean, for the prediction
  NodeArray last; ///< at the end of the base step
};

/// x += h v and p = v + h/2 mean of the nodes that no faster class moves; p += h/2 mean of the others.
ESM_CPU_CLONES void driftAndPredict(const RateClass& rate, double h, const Lanes* mean, const Lanes* v,
                                    Lanes* x, Lanes* p) noexcept
{
  const double half = 0.5 * h;
  for (std::size_t k = 0; k < rate.own; ++k) {
    const auto i = static_cast<std::size_t>(rate.nodes[k]);
    x[i] += v[i] * h;
    p[i] = v[i] + mean[k] * half;
  }
  for (std::size_t k = rate.own; k < rate.nodes.size(); ++k)
    p[static_cast<std::size_t>(rate.nodes[k])] += mean[k] * half;
}

/// v += h F/m, the mean takes a third of F/m, F = 0.
ESM_CPU_CLONES void kick(const RateClass& rate, double h, const double* inverseMass, Lanes* force,
                         Lanes* mean, Lanes* v) noexcept
{
  for (std::size_t k = 0; k < rate.nodes.size(); ++k) {
    const auto i = static_cast<std::size_t>(rate.nodes[k]);
    const Lanes a = force[i] * inverseMass[i];
    force[i] = Lanes{0, 0, 0, 0};
    v[i] += a * h;
    mean[k] += (a - mean[k]) * (1.0 / 3.0);
  }
}

/// The same at the end of the base step, where a is kept.
ESM_CPU_CLONES void lastKick(const RateClass& rate, double h, const double* inverseMass, Lanes* force,
                             Lanes* mean, Lanes* last, Lanes* v) noexcept
{
  for (std::size_t k = 0; k < rate.nodes.size(); ++k) {
    const auto i = static_cast<std::size_t>(rate.nodes[k]);
    last[k] = force[i] * inverseMass[i];
    force[i] = Lanes{0, 0, 0, 0};
    v[i] += last[k] * (0.5 * h);
    mean[k] += (last[k] - mean[k]) * (1.0 / 3.0);
  }
}

/// Multirate velocity Verlet: each spring acts at its own rate, a power of two of the base step (impulse
/// r-RESPA, Tuckerman, Berne and Martyna 1992; per element as in asynchronous variational integrators, Lew,
/// Marsden, Ortiz and West 2003). With F_c the forces of the springs of class c, due every h_c = h / 2^c:
///
///     at each tick of a class:  x += h_c v,   p = v + h_c/2 mean_c,   v += h_c F_c(x, p)/m
///
/// with half kicks at both ends of the base step. A node drifts at the rate of its fastest spring and rests
/// between. As in Verlet the viscous force takes a predicted velocity p; the mean of former accelerations in
/// it, one third new, widens the viscous limit from h g < 1 to 5/3. All due classes see the same p before
/// any of them changes v, else the viscous error were of first order.
///
/// Where all springs need about the same rate, and where pressure joins all of them, it is plain Verlet; where a
/// few nodes ask for a rate that all springs would have to follow, as a hub does, these few are implicit
/// (few_implicit.cpp).
///
/// All rates scale with the base step, so that halving it quarters the whole error.
class Multirate final : public Integrator {
public:
  void prepare(const System& system) override
  {
    m_plan = MultirateLayout::plan(system);
    m_plan.pays = m_plan.pays && system.forces().pressure().isEmpty();
    m_built = m_started = false;
    for (NodeArray* array : {&m_x, &m_v, &m_p, &m_force})
      array->assign(m_plan.pays ? system.nodeCount() : 0, Lanes{0, 0, 0, 0});
    if (m_plan.pays) return;
    m_uniform = StiffNodes::find(system).empty() ? makeIntegrator("verlet") : makeFewImplicit();
    m_uniform->prepare(system);
  }
  void restart() noexcept override
  {
    m_uniform->restart();
    m_started = false;
    m_untilLook = 0;
    m_patience = 1;
  }
  void constraintsChanged(const System& system) override { prepare(system); }
  void tune(const System& system, const FastestMode& mode) noexcept override
  {
    m_uniform->tune(system, mode);
  }
  int order() const noexcept override { return 2; }
  void setSolveTolerance(double tolerance, bool rough) noexcept override
  {
    m_uniform->setSolveTolerance(tolerance, rough);
  }

  /// Stable at any step up to the number of classes; beyond the plan's step little is to be gained.
  double stableStep(const FastestMode& mode) const noexcept override
  {
    return m_plan.pays ? m_plan.step / 0.95 : m_uniform->stableStep(mode);
  }
  double stepCost(const System& system, double h) override
  {
    return m_plan.pays ? kSpringCost * m_plan.cost : m_uniform->stepCost(system, h);
  }

  StepResult step(System& system, MotionState& state, double h, double end, StepReport& report) override
  {
    if (!m_plan.pays) return m_uniform->step(system, state, h, end, report);
    m_x = state.x; // same size: no allocation
    m_v = state.v;
    arrange(system, state, h);
    if (!m_started) start(system, state.time);
    m_work = m_heat = 0.0;
    ++report.steps;
    sweep(system, state.time, h, end);
    if (!allFinite(m_x, m_v)) {
      restart();
      return StepResult::NonFinite;
    }
    if (energyAppeared(system, state.work + m_work)) {
      restart();
      return StepResult::NotConverged;
    }
    system.place(end, m_x, m_v);
    state.advanceTo(end, m_x, m_v, m_work, m_heat);
    return StepResult::Done;
  }

private:
  /// Looks at energy and stiffness, at first often, then less and less; sorts the springs anew if the step is
  /// longer than ever, or if some have stiffened.
  void arrange(const System& system, const MotionState& state, double h)
  {
    constexpr int kMostPatience = 64; // base steps between two looks
    const bool looks = !m_built || --m_untilLook <= 0;
    if (looks) {
      m_untilLook = m_patience;
      m_patience = std::min(2 * m_patience, kMostPatience);
      m_kinetic = system.kineticEnergy(m_v);
      m_elastic = system.elasticEnergy(m_x);
      m_gravity = system.forces().gravityEnergy(m_x.data());
      m_workThen = state.work;
    }
    if (m_built && h <= m_layout.step() && !(looks && m_layout.isOutgrown(system, m_x, m_v))) return;
    m_layout.build(system, m_x, m_v, std::max(h, m_plan.step));
    m_motion.resize(m_layout.classes().size());
    m_plan.cost = 0.0;
    for (std::size_t c = 0; c < m_motion.size(); ++c) {
      const RateClass& rate = m_layout.classes()[c];
      m_motion[c].mean.assign(rate.nodes.size(), Lanes{0, 0, 0, 0});
      m_motion[c].last = m_motion[c].mean;
      m_plan.cost += std::ldexp(static_cast<double>(rate.springs), static_cast<int>(c));
    }
    m_plan.cost *= m_plan.step / m_layout.step();
    m_built = true;
    m_started = false;
  }

  /// Whether there is more energy than at the last look, with what work and weight have added. Half more is
  /// what Verlet's swings by at its limit. Between two looks the kinetic part alone, which costs little.
  bool energyAppeared(const System& system, double work) const noexcept
  {
    const double fall = m_gravity - system.forces().gravityEnergy(m_x.data());
    const double known = m_kinetic + m_elastic + std::abs(work - m_workThen) + std::abs(fall);
    const double elastic = m_untilLook <= 1 ? system.elasticEnergy(m_x) : 0.0;
    return !(system.kineticEnergy(m_v) + elastic <= 1.5 * known);
  }

  /// Forces of one class at x and the velocities p. @return their powers [W].
  Rates evaluate(System& system, const RateClass& rate, double t) noexcept
  {
    Rates rates;
    for (const SpringBatch& batch : rate.batches)
      rates.heat +=
        springLawKernel(batch.law).addForces(batch, m_x.data(), m_p.data(), m_force.data(), nullptr, {});
    system.springsEvaluated += rate.springs;
    Lanes heat = {0, 0, 0, 0};
    for (const Anchor& anchor : rate.anchors) {
      const auto i = static_cast<std::size_t>(anchor.node);
      const Lanes drag = m_p[i] * anchor.viscosity;
      m_force[i] -= (m_x[i] - anchor.point) * anchor.stiffness + drag;
      heat += drag * m_p[i];
    }
    rates.heat += sumLanes(heat);
    for (const std::size_t place : rate.tools) {
      const ToolSpring& tool = system.tools()[place];
      const auto i = static_cast<std::size_t>(tool.node);
      const Eigen::Vector3d slip = tool.targetVelocity - toVector(m_p[i]);
      m_force[i] += toLanes(system.toolForce(place, m_x, m_p));
      rates.heat += tool.viscosity * slip.squaredNorm();
      rates.work += tool.viscosity * slip.dot(tool.targetVelocity);
    }
    if (&rate == &m_layout.classes().front()) {
      for (std::size_t i = 0; i < m_force.size(); ++i) m_force[i] += system.forces().weight(i);
      rates.work += system.addLoads(t, m_p, m_force);
    }
    for (const Index node : rate.driven) {
      const auto i = static_cast<std::size_t>(node);
      rates.work -= dot(m_force[i], m_p[i]);
    }
    return rates;
  }

  /// Accelerations at the start of the base step.
  void start(System& system, double t) noexcept
  {
    m_p = m_v;
    std::fill(m_force.begin(), m_force.end(), Lanes{0, 0, 0, 0});
    m_ends.assign(m_motion.size(), Rates{});
    for (std::size_t c = 0; c < m_motion.size(); ++c) {
      const RateClass& rate = m_layout.classes()[c];
      m_ends[c] = evaluate(system, rate, t);
      for (std::size_t k = 0; k < rate.nodes.size(); ++k) {
        const auto i = static_cast<std::size_t>(rate.nodes[k]);
        m_motion[c].mean[k] = m_motion[c].last[k] = m_force[i] * system.inverseMass()[i];
        m_force[i] = Lanes{0, 0, 0, 0};
      }
    }
    m_started = true;
  }

  void count(const Rates& rates, double h) noexcept
  {
    m_work += h * rates.work;
    m_heat += h * rates.heat;
  }

  void sweep(System& system, double begin, double h, double end) noexcept
  {
    const std::vector<RateClass>& classes = m_layout.classes();
    const double* inverseMass = system.inverseMass().data();
    const std::size_t top = classes.size() - 1;
    const std::size_t ticks = std::size_t{1} << top;
    for (std::size_t i = 0; i < m_v.size(); ++i)
      if (!system.isFree(i)) m_p[i] = m_v[i];
    for (std::size_t c = 0; c <= top; ++c) {
      const double half = 0.5 * std::ldexp(h, -static_cast<int>(c));
      const RateClass& rate = classes[c];
      for (std::size_t k = 0; k < rate.nodes.size(); ++k)
        m_v[static_cast<std::size_t>(rate.nodes[k])] += m_motion[c].last[k] * half;
      count(m_ends[c], half);
    }
    for (std::size_t tick = 1; tick <= ticks; ++tick) {
      const std::size_t lowest = top - static_cast<std::size_t>(std::countr_zero(tick));
      const double t =
        tick == ticks ? end : begin + std::ldexp(h, -static_cast<int>(top)) * static_cast<double>(tick);
      for (std::size_t c = top + 1; c-- > lowest;)
        driftAndPredict(classes[c], std::ldexp(h, -static_cast<int>(c)), m_motion[c].mean.data(), m_v.data(),
                        m_x.data(), m_p.data());
      for (std::size_t c = top + 1; c-- > lowest;) {
        const double step = std::ldexp(h, -static_cast<int>(c));
        const Rates rates = evaluate(system, classes[c], t);
        count(rates, tick == ticks ? 0.5 * step : step);
        if (tick == ticks) {
          m_ends[c] = rates;
          lastKick(classes[c], step, inverseMass, m_force.data(), m_motion[c].mean.data(),
                   m_motion[c].last.data(), m_v.data());
        } else {
          kick(classes[c], step, inverseMass, m_force.data(), m_motion[c].mean.data(), m_v.data());
        }
      }
    }
  }

  /// Where one rate for all springs is cheaper.
  std::unique_ptr<Integrator> m_uniform = makeIntegrator("verlet");
  MultirateLayout::Plan m_plan;
  MultirateLayout m_layout;
  std::vector<ClassMotion> m_motion; ///< by class
  std::vector<Rates> m_ends;         ///< by class, at the last end
  NodeArray m_x, m_v, m_p, m_force;
  double m_work = 0.0, m_heat = 0.0;
  double m_kinetic = 0.0, m_elastic = 0.0, m_gravity = 0.0, m_workThen = 0.0; ///< at the last look [J]
  int m_untilLook = 0, m_patience = 1;                                        ///< base steps
  bool m_built = false, m_started = false;
};

} // namespace

std::unique_ptr<Integrator> makeMultirate()
{
  return std::make_unique<Multirate>();
}

} // namespace esm
