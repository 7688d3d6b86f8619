// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/bounds/stoermer_limits.h"
#include "core/dynamics/methods/integrator.h"
#include "core/dynamics/methods/runge_kutta.h"
#include "core/forces/spring_pass.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace esm {
namespace {

/// Where the sweeps find things.
struct StoermerSweep {
  double h;
  const double* inverseMass;
  std::array<const Lanes*, StoermerLimits::kDepth> force; ///< the latest first [N]
};

/// The forces at a node at the present instant and at those before it. The differences of the formulas are
/// written out as weights of these: two thirds of the additions.
struct StoermerForces {
  Lanes now, one, two, three;

  ESM_INLINE StoermerForces(const StoermerSweep& sweep, std::size_t i) noexcept
  {
    now = sweep.force[0][i];
    one = sweep.force[1][i];
    two = sweep.force[2][i];
    three = sweep.force[3][i];
  }
};

/// u += h (1 + nabla^2/12 + nabla^3/12) a, x += h u
ESM_INLINE void move(const StoermerForces& force, double s, double h, Lanes& x, Lanes& u) noexcept
{
  u += ((force.now * (14.0 / 12) - force.one * (5.0 / 12)) +
        (force.two * (4.0 / 12) - force.three * (1.0 / 12))) *
       s;
  x += u * h;
}

/// And p' = u + h (1/2 + nabla/3 + 7/24 nabla^2) a + c (p - v)
ESM_CPU_CLONES void advanceAlone(const StoermerSweep& given, std::size_t count, Lanes* x, Lanes* u, Lanes* p,
                                 Lanes* missed) noexcept
{
  const StoermerSweep sweep = given; // as ESM_CPU_CLONES says, here and below
  for (std::size_t i = 0; i < count; ++i) {
    const StoermerForces force(sweep, i);
    const double s = sweep.h * sweep.inverseMass[i];
    move(force, s, sweep.h, x[i], u[i]);
    const Lanes third = (force.now - force.three) + (force.two - force.one) * 3.0;
    missed[i] = missed[i] * StoermerLimits::kCarry - third * (7.0 / 24 * s);
    p[i] = u[i] + (force.now * (27.0 / 24) - force.one * (22.0 / 24) + force.two * (7.0 / 24)) * s +
           missed[i] * StoermerLimits::kCarry;
  }
}

/// And p' = u + h (1/2 + nabla/3) a
ESM_CPU_CLONES void advanceCorrected(const StoermerSweep& given, std::size_t count, Lanes* x, Lanes* u,
                                     Lanes* p) noexcept
{
  const StoermerSweep sweep = given;
  for (std::size_t i = 0; i < count; ++i) {
    const StoermerForces force(sweep, i);
    const double s = sweep.h * sweep.inverseMass[i];
    move(force, s, sweep.h, x[i], u[i]);
    p[i] = u[i] + (force.now * (5.0 / 6) - force.one * (2.0 / 6)) * s;
  }
}

template <bool bedded>
ESM_INLINE void missedVelocityAs(const StoermerSweep& sweep, std::size_t count, const double* viscosity,
                                 Lanes* missed, Lanes* force) noexcept
{
  for (std::size_t i = 0; i < count; ++i) {
    const Lanes now = force[i];
    const Lanes here =
      (now - sweep.force[1][i] * 2.0 + sweep.force[2][i]) * (7.0 / 24 * sweep.h * sweep.inverseMass[i]);
    missed[i] = here;
    if constexpr (bedded) force[i] = now - here * viscosity[i];
  }
}

/// missed = v - p = 7/24 h nabla^2 a, with the forces at the step's end; then those of the nodes' own dampers
/// follow it.
/// @param viscosity  of single nodes, or null
ESM_CPU_CLONES void missedVelocity(const StoermerSweep& given, std::size_t count, const double* viscosity,
                                   Lanes* missed, Lanes* force) noexcept
{
  const StoermerSweep sweep = given;
  viscosity ? missedVelocityAs<true>(sweep, count, viscosity, missed, force)
            : missedVelocityAs<false>(sweep, count, nullptr, missed, force);
}

/// From the mean velocity of a step to that at its end, with the forces there, or back:
/// to = from + sign h (1/2 - nabla/6 - nabla^2/24 - nabla^3/45) a
ESM_CPU_CLONES void addHalfStep(const StoermerSweep& given, double sign, std::size_t count, const Lanes* from,
                                Lanes* to) noexcept
{
  const StoermerSweep sweep = given;
  for (std::size_t i = 0; i < count; ++i) {
    const StoermerForces force(sweep, i);
    to[i] = from[i] + ((force.now * 97.0 + force.three * 8.0) + (force.one * 114.0 - force.two * 39.0)) *
                        (sign / 360 * sweep.h * sweep.inverseMass[i]);
  }
}

/// Stoermer's explicit multistep method of fourth order (Stoermer 1907; Hairer, Noersett, Wanner, Solving
/// Ordinary Differential Equations I, III.10), with u the mean velocity of a step:
///
///     u' = u + h (1 + nabla^2/12 + nabla^3/12) a,     x' = x + h u',     nabla a = a_n - a_{n-1}
///
/// One force pass per step, and stable up to h w = 1.4: per pass twice as far as the classical Runge-Kutta
/// method, whose error at equal work is fifty times larger (h^4 w^4/25 of a mode's phase against 2 h^4 w^4).
///
/// It is made for x'' = f(x). Viscous forces need the velocity at the step's end: it is foretold from what
/// came before, p = u' + h (1/2 + nabla/3 + 7/24 nabla^2) a + c (p - v), where the last term carries over a
/// share of what was foretold wrongly, as in Verlet. That bears h g < 0.4. Where dampers ask for more, the
/// velocity is foretold without the second difference and corrected once the forces are known: the
/// difference, 7/24 h nabla^2 a with these, goes through the dampers once more, with the springs' directions
/// held. For half a force pass more that bears h g < 2.6. See StoermerLimits.
///
/// Three steps by Runge-Kutta make the past that it needs, after each change of the step's length too.
class Stoermer final : public Integrator {
public:
  void prepare(const System& system) override
  {
    for (NodeArray* array : {&m_x, &m_p, &m_u, &m_missed})
      array->assign(system.nodeCount(), Lanes{0, 0, 0, 0});
    for (NodeArray& array : m_force) array.assign(system.nodeCount(), Lanes{0, 0, 0, 0});
    m_damper.assign(system.forces().damperSize(), Lanes{0, 0, 0, 0});
    m_start.prepare(system);
    restart();
  }
  void restart() noexcept override
  {
    forget();
    m_keepsWay = true;
  }
  int order() const noexcept override { return 4; }
  void tune(const System& system, const FastestMode& mode) noexcept override
  {
    const auto springs = static_cast<double>(system.forces().activeSprings());
    m_aloneCost = system.forces().passCost() + system.sweepCost(1.4, 3.3);
    m_correctedCost = m_aloneCost + 0.6 * springs + system.sweepCost(0.8, 0.8);
    m_limits = StoermerLimits(mode);
    // Steps must be that much longer to be worth a correction.
    m_corrects = m_limits.corrected * m_aloneCost > m_limits.alone * m_correctedCost;
    m_tuned = mode;
  }
  double stableStep(const FastestMode& mode) const noexcept override
  {
    if (mode.stiffness == m_tuned.stiffness && mode.damping == m_tuned.damping)
      return m_corrects ? m_limits.corrected : m_limits.alone;
    const StoermerLimits limits(mode);
    return m_corrects ? limits.corrected : limits.alone;
  }
  double stepCost(const System&, double h) override { return corrects(h) ? m_correctedCost : m_aloneCost; }

  StepResult run(System& system, MotionState& state, double end, std::int64_t steps,
                 StepReport& report) override
  {
    const double begin = state.time, h = (end - begin) / static_cast<double>(steps);
    // The second run of a check, with smaller steps, goes the way of the first: else their distance tells
    // little.
    const bool withCorrection = corrects(h) || (m_keepsWay && m_wasCorrected && corrects(1.6 * h));
    m_keepsWay = false;
    if (!(std::abs(h - m_h) <= 1e-9 * h) || withCorrection != m_wasCorrected) forget();
    m_h = h;
    m_wasCorrected = withCorrection;
    const auto timeOf = [&](std::int64_t i) { return i == steps ? end : begin + static_cast<double>(i) * h; };
    std::int64_t done = 0;
    for (; done < steps && m_known < kPast; ++done)
      if (const StepResult result = startStep(system, state, timeOf(done + 1), report);
          result != StepResult::Done)
        return result;
    if (done == steps) return StepResult::Done;
    if (!m_isOpen) {
      m_rates.front() = system.evaluate(state.time, state.x, state.v, m_force.front());
      std::fill(m_missed.begin(), m_missed.end(), Lanes{0, 0, 0, 0});
      halfStep(system, -1.0, state.v, m_u);
    }
    m_isOpen = false; // until it is known to have gone well
    m_x = state.x;
    double work = 0.0, heat = 0.0;
    report.steps += steps - done;
    while (done < steps) {
      turn();
      const Rates rates = advance(system, timeOf(++done), withCorrection);
      const auto mean = [&](double Rates::*rate) { // Adams and Moulton's quadrature
        return (9.0 * rates.*rate + 19.0 * m_rates[1].*rate - 5.0 * m_rates[2].*rate + m_rates[3].*rate) /
               24.0;
      };
      m_rates.front() = rates;
      work += mean(&Rates::work);
      heat += mean(&Rates::heat);
    }
    return finish(system, state, end, h * work, h * heat);
  }

private:
  void forget() noexcept
  {
    m_known = 0;
    m_isOpen = false;
    m_start.restart();
  }

  static constexpr std::size_t kPast = StoermerLimits::kDepth - 1; ///< forces before the present one

  bool corrects(double h) const noexcept { return m_corrects && h > kRoomForMotion * m_limits.alone; }
  /// @param latest  which forces count as the latest, those before it follow; the oldest may be at the front.
  StoermerSweep sweepFrom(const System& system, std::size_t first, std::size_t latest = 0) const noexcept
  {
    StoermerSweep sweep{m_h, system.inverseMass().data() + first, {}};
    for (std::size_t j = 0; j < m_force.size(); ++j)
      sweep.force[j] = m_force[(latest + j) % m_force.size()].data() + first;
    return sweep;
  }
  /// Room at the front.
  void turn() noexcept
  {
    for (std::size_t j = kPast; j > 0; --j) {
      m_force[j].swap(m_force[j - 1]);
      m_rates[j] = m_rates[j - 1];
    }
  }

  StepResult startStep(System& system, MotionState& state, double end, StepReport& report)
  {
    const StepResult result = m_start.step(system, state, m_h, end, report);
    if (result != StepResult::Done) return result;
    m_force.front().swap(m_start.firstForce());
    m_rates.front() = m_start.firstRates();
    turn();
    ++m_known;
    return StepResult::Done;
  }

  /// A step to t after turn(), and the forces there into the front of the ring: where the oldest ones are
  /// until the pass over the springs comes to their nodes.
  Rates advance(System& system, double t, bool withCorrection) noexcept
  {
    NodeArray& force = m_force.front();
    const auto move = [&](std::size_t f, std::size_t n) noexcept {
      const auto sweep = sweepFrom(system, f, 1);
      if (withCorrection)
        advanceCorrected(sweep, n, m_x.data() + f, m_u.data() + f, m_p.data() + f);
      else
        advanceAlone(sweep, n, m_x.data() + f, m_u.data() + f, m_p.data() + f, m_missed.data() + f);
    };
    const Rates rates = system.evaluate(t, m_x, m_p, force, withCorrection ? m_damper.data() : nullptr, move);
    if (!withCorrection) return rates;
    const auto& viscosity = system.forces().nodeViscosity();
    system.addDamping(m_damper.data(), m_missed, force, [&](std::size_t f, std::size_t n) noexcept {
      missedVelocity(sweepFrom(system, f), n, viscosity.empty() ? nullptr : viscosity.data() + f,
                     m_missed.data() + f, force.data() + f);
    });
    return rates;
  }

  void halfStep(const System& system, double sign, const NodeArray& from, NodeArray& to) const noexcept
  {
    system.sweepNodes([&](std::size_t f, std::size_t n) noexcept {
      addHalfStep(sweepFrom(system, f), sign, n, from.data() + f, to.data() + f);
    });
  }

  StepResult finish(System& system, MotionState& state, double end, double work, double heat) noexcept
  {
    NodeArray& v = m_p;
    halfStep(system, 1.0, m_u, v);
    system.place(end, m_x, v);
    if (!allFinite(m_x, v)) {
      forget();
      return StepResult::NonFinite;
    }
    state.advanceTo(end, m_x, v, work, heat);
    m_isOpen = true;
    return StepResult::Done;
  }

  RungeKutta m_start{kClassicalRungeKutta};
  StoermerLimits m_limits;
  FastestMode m_tuned;
  bool m_corrects = false;
  double m_aloneCost = 1.0, m_correctedCost = 1.5;       ///< of a step, in spring evaluations
  std::array<NodeArray, StoermerLimits::kDepth> m_force; ///< at the present instant and those before it [N]
  std::array<Rates, StoermerLimits::kDepth> m_rates{};   ///< then
  NodeArray m_x, m_p;                                    ///< positions, foretold velocities
  NodeArray m_u;                                         ///< mean velocity of the last step [m/s]
  NodeArray m_missed;                                    ///< of the foretold velocities [m/s]
  NodeArray m_damper;
  double m_h = 0.0;        ///< of the steps that made the past [s]
  std::size_t m_known = 0; ///< forces of the past
  bool m_isOpen = false;   ///< the present force is known, too
  bool m_wasCorrected = false;
  bool m_keepsWay = false; ///< the next run is a restart
};

} // namespace

std::unique_ptr<Integrator> makeStoermer()
{
  return std::make_unique<Stoermer>();
}

} // namespace esm
