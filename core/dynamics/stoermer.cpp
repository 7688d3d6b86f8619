// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/integrator.h"
#include "core/dynamics/runge_kutta.h"
#include "core/dynamics/stoermer_limits.h"
#include "core/forces/spring_pass.h"

#include <array>
#include <cmath>

namespace esm {
namespace {

/// StoermerWeights of the accelerations at the last instants, the latest first.
using StoermerWeights = std::array<double, StoermerLimits::kDepth>;

/// x'' by the differences of a up to the third: (1 + nabla^2/12 + nabla^3/12) a_n
constexpr StoermerWeights kKick = {14.0 / 12, -5.0 / 12, 4.0 / 12, -1.0 / 12};
/// The integral of s a(t_n + s h) over a step for v = (x - x_before)/h + h sum w_i a_i at the step's end:
/// through a_n and the two before, through a_n and the one before, and with the end's own acceleration first.
constexpr StoermerWeights kAhead = {27.0 / 24, -22.0 / 24, 7.0 / 24, 0.0};
constexpr StoermerWeights kRoughlyAhead = {20.0 / 24, -8.0 / 24, 0.0, 0.0};
constexpr StoermerWeights kHere = {7.0 / 24, 6.0 / 24, -1.0 / 24, 0.0};
constexpr StoermerWeights kAtEnd = {97.0 / 360, 114.0 / 360, -39.0 / 360, 8.0 / 360};

/// Where the sweeps find things.
struct StoermerSweep {
  double h;
  const double* inverseMass;
  std::array<const Lanes*, StoermerLimits::kDepth> force; ///< the latest first [N]

  ESM_INLINE Lanes sum(const StoermerWeights& weight, std::size_t terms, std::size_t i) const noexcept
  {
    Lanes total = force[0][i] * weight[0];
    for (std::size_t j = 1; j < terms; ++j) total += force[j][i] * weight[j];
    return total * (h * inverseMass[i]);
  }
};

/// u += h x''; x += h u; p' = u + h ahead + carry (p - v)
ESM_CPU_CLONES void advanceAlone(const StoermerSweep& sweep, std::size_t count, Lanes* x, Lanes* u,
                                 Lanes* p) noexcept
{
  for (std::size_t i = 0; i < count; ++i) {
    const Lanes v = u[i] + sweep.sum(kHere, 3, i), missed = p[i] - v;
    u[i] += sweep.sum(kKick, 4, i);
    x[i] += u[i] * sweep.h;
    p[i] = u[i] + sweep.sum(kAhead, 3, i) + missed * StoermerLimits::kCarry;
  }
}

/// u += h x''; x += h u; p' = u + h ahead
ESM_CPU_CLONES void advanceCorrected(const StoermerSweep& sweep, std::size_t count, Lanes* x, Lanes* u,
                                     Lanes* p) noexcept
{
  for (std::size_t i = 0; i < count; ++i) {
    u[i] += sweep.sum(kKick, 4, i);
    x[i] += u[i] * sweep.h;
    p[i] = u[i] + sweep.sum(kRoughlyAhead, 2, i);
  }
}

/// missed = v - p of what is free
ESM_CPU_CLONES void correctVelocity(const StoermerSweep& sweep, std::size_t count, const Lanes* u,
                                    const Lanes* p, Lanes* missed) noexcept
{
  for (std::size_t i = 0; i < count; ++i)
    missed[i] = (u[i] + sweep.sum(kHere, 3, i) - p[i]) * (sweep.inverseMass[i] > 0.0 ? 1.0 : 0.0);
}

/// force -= c missed
ESM_CPU_CLONES void dragMissed(std::size_t count, const double* viscosity, const Lanes* missed,
                               Lanes* force) noexcept
{
  for (std::size_t i = 0; i < count; ++i) force[i] -= missed[i] * viscosity[i];
}

/// v = u + h sum
ESM_CPU_CLONES void closeVelocity(const StoermerSweep& sweep, std::size_t count, const Lanes* u,
                                  Lanes* v) noexcept
{
  for (std::size_t i = 0; i < count; ++i) v[i] = u[i] + sweep.sum(kAtEnd, 4, i);
}

/// u = v - h sum, the other way round
ESM_CPU_CLONES void meanVelocity(const StoermerSweep& sweep, std::size_t count, const Lanes* v,
                                 Lanes* u) noexcept
{
  for (std::size_t i = 0; i < count; ++i) u[i] = v[i] - sweep.sum(kAtEnd, 4, i);
}

/// Stoermer's explicit multistep method of fourth order (Stoermer 1907; Hairer, Noersett, Wanner, Solving
/// Ordinary Differential Equations I, III.10), with u the mean velocity of a step:
///
///     u' = u + h (14 a_n - 5 a_{n-1} + 4 a_{n-2} - a_{n-3})/12,     x' = x + h u'
///
/// One force pass per step, and stable up to h w = 1.4: per pass twice as far as the classical Runge-Kutta
/// method, whose error at equal work is fifty times larger (h^4 w^4/25 of a mode's phase against 2 h^4 w^4).
///
/// It is made for x'' = f(x). Viscous forces need the velocity at the step's end: it is foretold from what
/// came before, p = u' + h (27 a_n - 22 a_{n-1} + 7 a_{n-2})/24 + c (p - v), where the last term carries over
/// a share of what was foretold wrongly, as in Verlet. That bears h g < 0.4. Where dampers ask for more, the
/// velocity is foretold roughly and corrected once the forces are known, v = u' + h (7 a_{n+1} + 6 a_n -
/// a_{n-1})/24, and the viscous forces are repeated for the difference, with the springs' directions held:
/// for half a force pass more it bears h g < 2.6. See StoermerLimits.
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
    const auto nodes = static_cast<double>(system.nodeCount());
    const auto springs = static_cast<double>(system.forces().activeSprings());
    m_aloneCost = system.forces().passCost() + 1.4 * nodes; // measured
    m_correctedCost = m_aloneCost + 0.6 * springs + 1.2 * nodes;
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

  StepResult step(System& system, MotionState& state, double h, double end, StepReport& report) override
  {
    static_cast<void>(h);
    return run(system, state, end, 1, report);
  }

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
      m_p = state.v; // same size: no allocation
      system.sweepNodes([&](std::size_t f, std::size_t n) noexcept {
        meanVelocity(sweepFrom(system, f), n, state.v.data() + f, m_u.data() + f);
      });
    }
    m_isOpen = false; // until it is known to have gone well
    m_x = state.x;
    double work = 0.0, heat = 0.0;
    report.steps += steps - done;
    while (done < steps) {
      advance(system, withCorrection);
      const Rates rates = evaluate(system, timeOf(++done), withCorrection);
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

  bool corrects(double h) const noexcept
  {
    constexpr double kRoom = 0.88; // as in leapfrog.cpp
    return m_corrects && h > kRoom * m_limits.alone;
  }
  StoermerSweep sweepFrom(const System& system, std::size_t first) const noexcept
  {
    StoermerSweep sweep{m_h, system.inverseMass().data() + first, {}};
    for (std::size_t j = 0; j < m_force.size(); ++j) sweep.force[j] = m_force[j].data() + first;
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

  void advance(const System& system, bool withCorrection) noexcept
  {
    system.sweepNodes([&](std::size_t f, std::size_t n) noexcept {
      const auto sweep = sweepFrom(system, f);
      const auto move = withCorrection ? advanceCorrected : advanceAlone;
      move(sweep, n, m_x.data() + f, m_u.data() + f, m_p.data() + f);
    });
    turn();
  }

  /// Forces at t into the front of the ring.
  Rates evaluate(System& system, double t, bool withCorrection) noexcept
  {
    NodeArray& force = m_force.front();
    if (!withCorrection) return system.evaluate(t, m_x, m_p, force);
    const Rates rates = system.evaluate(t, m_x, m_p, force, m_damper.data());
    system.sweepNodes([&](std::size_t f, std::size_t n) noexcept {
      correctVelocity(sweepFrom(system, f), n, m_u.data() + f, m_p.data() + f, m_missed.data() + f);
    });
    system.addDamping(m_damper.data(), m_missed, force);
    if (const auto& viscosity = system.forces().nodeViscosity(); !viscosity.empty())
      system.sweepNodes([&](std::size_t f, std::size_t n) noexcept {
        dragMissed(n, viscosity.data() + f, m_missed.data() + f, force.data() + f);
      });
    return rates;
  }

  StepResult finish(System& system, MotionState& state, double end, double work, double heat) noexcept
  {
    NodeArray& v = m_missed;
    system.sweepNodes([&](std::size_t f, std::size_t n) noexcept {
      closeVelocity(sweepFrom(system, f), n, m_u.data() + f, v.data() + f);
    });
    system.place(end, m_x, v);
    if (!allFinite(m_x, v)) return StepResult::NonFinite;
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
