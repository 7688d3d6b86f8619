// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/chebyshev_damping.h"
#include "core/dynamics/integrator.h"
#include "core/forces/spring_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace esm {
namespace {

// The sweeps over nodes, as wide as the processor allows. Held nodes have inverse mass 0: no kick.

/// v += s F/m, x += h v
ESM_CPU_CLONES void kickAndDrift(std::size_t count, double s, double h, const Lanes* force,
                                 const double* inverseMass, Lanes* v, Lanes* x) noexcept
{
  for (std::size_t i = 0; i < count; ++i) {
    v[i] += force[i] * (s * inverseMass[i]);
    x[i] += v[i] * h;
  }
}

/// The arrays of a staged kick, N entries each; `viscosity` of single nodes, or null.
struct Sweep {
  std::size_t count;
  double s; ///< length of the kick [s]
  const double *inverseMass, *viscosity;
  Lanes* force; ///< F(x, v), then the viscous forces at the stage
  Lanes* a;     ///< s F/m
};

/// The viscous forces of single nodes open the next pass over the springs.
template <bool bedded>
ESM_INLINE void setDrag(const Sweep& sweep, std::size_t i, const Lanes& d) noexcept
{
  const Lanes zero = {0, 0, 0, 0};
  if constexpr (bedded)
    sweep.force[i] = d * -sweep.viscosity[i];
  else
    sweep.force[i] = zero;
}

template <bool bedded>
ESM_INLINE void firstSweep(const Sweep& sweep) noexcept
{
  for (std::size_t i = 0; i < sweep.count; ++i) {
    sweep.a[i] = sweep.force[i] * (sweep.s * sweep.inverseMass[i]);
    setDrag<bedded>(sweep, i, sweep.a[i]);
  }
}

/// d_j at a node; `known` of the differences before it are in d and before: none for stage 2, d_2 for
/// stage 3.
template <int known>
ESM_INLINE void stageAt(const Sweep& sweep, const ChebyshevDamping::Stage& stage, std::size_t i,
                        const Lanes* d, const Lanes* before, Lanes& next) noexcept
{
  next = sweep.a[i] * stage.push + sweep.force[i] * (stage.kick * sweep.s * sweep.inverseMass[i]);
  if constexpr (known > 0) next += d[i] * stage.mu;
  if constexpr (known > 1) next += before[i] * stage.nu;
}

template <int known, bool bedded>
ESM_INLINE void middleSweep(const Sweep& sweep, const ChebyshevDamping::Stage& stage, const Lanes* d,
                            Lanes* before) noexcept
{
  for (std::size_t i = 0; i < sweep.count; ++i) {
    Lanes next;
    stageAt<known>(sweep, stage, i, d, before, next);
    before[i] = next;
    setDrag<bedded>(sweep, i, next);
  }
}

template <int known>
ESM_INLINE void lastSweep(const Sweep& sweep, const ChebyshevDamping::Stage& stage, double h, const Lanes* d,
                          const Lanes* before, Lanes* v, Lanes* x) noexcept
{
  for (std::size_t i = 0; i < sweep.count; ++i) {
    Lanes next;
    stageAt<known>(sweep, stage, i, d, before, next);
    v[i] += next;
    x[i] += v[i] * h;
  }
}

/// d_1 = a
ESM_CPU_CLONES void firstStage(const Sweep& sweep) noexcept
{
  sweep.viscosity ? firstSweep<true>(sweep) : firstSweep<false>(sweep);
}

/// d_{j-2} <- d_j
template <int known>
ESM_INLINE void middleOf(const Sweep& sweep, const ChebyshevDamping::Stage& stage, const Lanes* d,
                         Lanes* before) noexcept
{
  sweep.viscosity ? middleSweep<known, true>(sweep, stage, d, before)
                  : middleSweep<known, false>(sweep, stage, d, before);
}

ESM_CPU_CLONES void middleStage(const Sweep& sweep, const ChebyshevDamping::Stage& stage, int j,
                                const Lanes* d, Lanes* before) noexcept
{
  if (j == 2)
    middleOf<0>(sweep, stage, d, before);
  else if (j == 3)
    middleOf<1>(sweep, stage, d, before);
  else
    middleOf<2>(sweep, stage, d, before);
}

/// v += d_j, x += h v
ESM_CPU_CLONES void lastStage(const Sweep& sweep, const ChebyshevDamping::Stage& stage, int j, double h,
                              const Lanes* d, const Lanes* before, Lanes* v, Lanes* x) noexcept
{
  if (j == 2)
    lastSweep<0>(sweep, stage, h, d, before, v, x);
  else if (j == 3)
    lastSweep<1>(sweep, stage, h, d, before, v, x);
  else
    lastSweep<2>(sweep, stage, h, d, before, v, x);
}

/// Leapfrog: positions at the steps, velocities half way between, one force pass per step. It is symplectic
/// Euler with the velocities where they belong, and so of second order; a run opens and closes with half a
/// kick, which brings both to the same instant.
///
/// Stiffness limits the step to 2/w, and nothing explicit does better. In tissue viscosity would limit it
/// more (2/g): so where a step asks for it, the kick takes Chebyshev stages (ChebyshevDamping), each of which
/// only repeats the viscous forces with the springs' directions held, for less than half of a force pass.
///
/// A run goes on from the half-step velocities of the one before, with a whole kick. Two halves are another
/// kick, P(z/2)^2 for P(z), which may vanish where steps beyond 2 c/k need it above (h - 2 c/k)/(h + 2 c/k):
/// closed and opened again every 14 steps, a prestretched tube grew by 2.5 in energy each time, at four
/// fifths of the limit.
class Leapfrog final : public Integrator {
public:
  explicit Leapfrog(int order) : m_order(order)
  {
    for (int stages = order; stages <= ChebyshevDamping::kMostStages; ++stages)
      m_damping.emplace_back(stages, order);
  }

  void prepare(const System& system) override
  {
    for (NodeArray* array : {&m_x, &m_v, &m_half, &m_force, &m_a, &m_d, &m_before})
      array->assign(system.nodeCount(), Lanes{0, 0, 0, 0});
    m_damper.assign(system.forces().damperSize(), Lanes{0, 0, 0, 0});
    restart();
  }
  void restart() noexcept override { m_lastStep = 0.0; }
  /// The new force comes half a step too early: less than the frame by which a hand is late anyway.
  void toolsMoved() noexcept override {}
  int order() const noexcept override { return m_order; }

  void tune(const System& system, const FastestMode& mode) noexcept override
  {
    const auto springs = static_cast<double>(system.forces().activeSprings());
    m_plainCost = std::max(system.forces().passCost() + system.sweepCost(0.6, 0.6), 1.0);
    m_stageCost = (0.6 * springs + system.sweepCost(1.7, 2.4)) / m_plainCost; // measured
    m_best = limitsAt(mode, m_limit);
    m_tuned = mode;
  }
  double stableStep(const FastestMode& mode) const noexcept override
  {
    if (mode.stiffness == m_tuned.stiffness && mode.damping == m_tuned.damping) return m_limit[m_best];
    Limits limit{};
    return limit[limitsAt(mode, limit)];
  }
  double stepCost(const System&, double h) override { return costOf(placeFor(h)) * m_plainCost; }

  StepResult run(System& system, MotionState& state, double end, std::int64_t steps,
                 StepReport& report) override
  {
    const double begin = state.time, h = (end - begin) / static_cast<double>(steps);
    const double opening = 0.5 * (m_lastStep + h);
    const ChebyshevDamping &damping = m_damping[placeFor(h)],
                           &opener = m_damping[placeFor(std::max(opening, h))];
    m_x = state.x; // same size: no allocation
    m_v = m_lastStep > 0.0 ? m_half : state.v;
    double work = 0.0, heat = 0.0, lastTime = begin;
    Rates before;
    Kick kick;
    for (std::int64_t i = 0; i <= steps; ++i) {
      const double t = i == steps ? end : begin + static_cast<double>(i) * h;
      const auto closeLast = [&](std::size_t f, std::size_t n) noexcept { close(system, kick, f, n); };
      const ChebyshevDamping& used = i == 0 ? opener : damping;
      const Rates rates = system.evaluate(t, m_x, m_v, m_force, used.stages() > 1 ? m_damper.data() : nullptr,
                                          i > 0 ? NodeSweep(closeLast) : NodeSweep{});
      // Over a step the velocity is that of its middle: the forces before and after meet the same one.
      if (i > 0) {
        work += 0.5 * (before.work - before.loads + system.loadPower(lastTime, m_v) + rates.work);
        heat += rates.heat;
      }
      before = rates;
      lastTime = t;
      if (i == steps) m_half = m_v;
      kick = {&used, i == 0 ? opening : i == steps ? 0.5 * h : h, i == steps ? 0.0 : h};
      open(system, kick);
    }
    system.sweepNodes([&](std::size_t f, std::size_t n) noexcept { close(system, kick, f, n); });
    report.steps += steps;
    m_lastStep = 0.0;
    if (!allFinite(m_x, m_v)) return StepResult::NonFinite;
    state.advanceTo(end, m_x, m_v, h * work, h * heat);
    m_lastStep = h;
    return StepResult::Done;
  }

private:
  /// In plain steps.
  double costOf(std::size_t place) const noexcept
  {
    return 1.0 + m_stageCost * (m_damping[place].stages() - 1);
  }

  using Limits = std::array<double, ChebyshevDamping::kMostStages>;

  /// The largest step of each choice [s]. @return the choice that moves fastest; later ones are not set.
  std::size_t limitsAt(const FastestMode& mode, Limits& limit) const noexcept
  {
    std::size_t best = 0;
    for (std::size_t i = 0; i < m_damping.size(); ++i) {
      // Stages that cannot gain need no closer look.
      if (i > 0 && costOf(i) / m_damping[i].viscousLimit(mode.damping) >= costOf(best) / limit[best])
        continue;
      limit[i] = m_damping[i].stableStep(mode);
      if (i > 0 && limit[i] <= limit[i - 1]) break; // it is the undamped that limit
      if (costOf(i) / limit[i] < costOf(best) / limit[best]) best = i;
    }
    return best;
  }

  /// The fewest stages that are stable at h, with room for what the net's motion does to the limits until the
  /// next look.
  std::size_t placeFor(double h) const noexcept
  {
    for (std::size_t i = 0; i < m_best; ++i)
      if (h <= kRoomForMotion * m_limit[i]) return i;
    return m_best;
  }

  /// Velocities `length` further with the forces in m_force, then positions `drift` further [s].
  struct Kick {
    const ChebyshevDamping* damping = nullptr;
    double length = 0.0, drift = 0.0;
  };

  Sweep sweepOf(const System& system, const Kick& kick, std::size_t first, std::size_t nodes) noexcept
  {
    const auto& viscosity = system.forces().nodeViscosity();
    return {nodes,
            kick.length,
            system.inverseMass().data() + first,
            viscosity.empty() ? nullptr : viscosity.data() + first,
            m_force.data() + first,
            m_a.data() + first};
  }

  /// The stages but for the last sweep over the nodes: that goes with the next pass over the springs.
  void open(System& system, const Kick& kick) noexcept
  {
    const int last = kick.damping->stages();
    if (last == 1) return;
    system.addDamping(m_damper.data(), m_a, m_force, [&](std::size_t f, std::size_t n) noexcept {
      firstStage(sweepOf(system, kick, f, n));
    });
    for (int j = 2; j < last; ++j) {
      system.addDamping(m_damper.data(), m_before, m_force, [&](std::size_t f, std::size_t n) noexcept {
        middleStage(sweepOf(system, kick, f, n), kick.damping->stage(j), j, m_d.data() + f,
                    m_before.data() + f);
      });
      std::swap(m_d, m_before);
    }
  }

  void close(const System& system, const Kick& kick, std::size_t first, std::size_t nodes) noexcept
  {
    const int last = kick.damping->stages();
    if (last == 1)
      kickAndDrift(nodes, kick.length, kick.drift, m_force.data() + first,
                   system.inverseMass().data() + first, m_v.data() + first, m_x.data() + first);
    else
      lastStage(sweepOf(system, kick, first, nodes), kick.damping->stage(last), last, kick.drift,
                m_d.data() + first, m_before.data() + first, m_v.data() + first, m_x.data() + first);
  }

  int m_order;                             ///< of the damping
  std::vector<ChebyshevDamping> m_damping; ///< by rising stages
  Limits m_limit{};                        ///< largest step of each [s]
  std::size_t m_best = 0;
  FastestMode m_tuned;
  double m_plainCost = 1.0; ///< of a step with one stage, see ForceModel::passCost()
  double m_stageCost = 0.8; ///< of a further stage, in plain steps
  NodeArray m_x, m_v, m_force;
  NodeArray m_half;             ///< velocities half a step before the end of the last run [m/s]
  double m_lastStep = 0.0;      ///< of that run [s]; 0: none goes on from it
  NodeArray m_a, m_d, m_before; ///< see ChebyshevDamping
  NodeArray m_damper;
};

} // namespace

std::unique_ptr<Integrator> makeLeapfrog()
{
  return std::make_unique<Leapfrog>(1);
}

std::unique_ptr<Integrator> makeChebyshev()
{
  return std::make_unique<Leapfrog>(2);
}

} // namespace esm
