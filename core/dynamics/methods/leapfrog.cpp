// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/methods/chebyshev_damping.h"
#include "core/dynamics/methods/integrator.h"
#include "core/dynamics/methods/past_forces.h"
#include "core/dynamics/methods/staged_kick.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace esm {
namespace {

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
///
/// Leapfrog waves run fast by h^2 w^2/24. With the second difference of the forces, u' = u + h (F + (F - 2 F'
/// + F'')/12)/m for the velocities u between the steps, that is Stoermer's rule of third order (Hairer,
/// Noersett, Wanner, Solving Ordinary Differential Equations I, III.10) and they keep in phase: on tissue,
/// whose slow modes are hardly damped, a twentieth of the error for two more reads per node. The forces hold
/// the viscous ones, and go through the same stages. Where the step changes, the past ones are interpolated;
/// velocities at the steps are v = u + h (1/2 - nabla/6 - nabla^2/24) F/m.
class Leapfrog final : public Integrator {
public:
  /// @param order  of the damping
  /// @param inPhase  with Stoermer's difference
  explicit Leapfrog(int order, bool inPhase = false) : m_order(order), m_inPhase(inPhase)
  {
    for (int stages = order; stages <= ChebyshevDamping::kMostStages; ++stages)
      m_damping.emplace_back(stages, order, inPhase);
  }

  void prepare(const System& system) override
  {
    for (NodeArray* array : {&m_x, &m_v, &m_half, &m_force, &m_a, &m_d, &m_before})
      array->assign(system.nodeCount(), Lanes{0, 0, 0, 0});
    m_damper.assign(system.forces().damperSize(), Lanes{0, 0, 0, 0});
    const std::size_t remembered = m_inPhase ? system.nodeCount() : 0;
    for (NodeArray* array : {&m_past.past, &m_past.older, &m_mark.past, &m_mark.older, &m_mark.half})
      array->assign(remembered, Lanes{0, 0, 0, 0});
    restart();
  }
  void restart() noexcept override
  {
    m_lastStep = 0.0;
    m_past.known = 0;
    m_mark.lastStep = 0.0;
  }
  void mark(double time) override
  {
    if (!m_inPhase) return;
    m_mark.time = time;
    m_mark.lastStep = m_lastStep;
    if (!(m_lastStep > 0.0)) return;
    static_cast<Past&>(m_mark) = m_past; // same sizes: no allocation
    m_mark.half = m_half;
  }
  void rewind(double time) noexcept override
  {
    if (!(m_mark.lastStep > 0.0) || m_mark.time != time) return restart();
    m_past = m_mark;
    m_half = m_mark.half;
    m_lastStep = m_mark.lastStep;
  }
  /// The new force comes half a step too early: less than the frame by which a hand is late anyway.
  void toolsMoved() noexcept override {}
  int order() const noexcept override { return m_inPhase ? 3 : m_order; }

  void tune(const System& system, const FastestMode& mode) noexcept override
  {
    const auto springs = static_cast<double>(system.forces().activeSprings());
    const double sweeps = system.sweepCost(0.6, 0.6) + (m_inPhase ? system.sweepCost(0.5, 1.0) : 0.0);
    m_plainCost = std::max(system.forces().passCost() + sweeps, 1.0);
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
    if (m_inPhase && h > kFurthest * m_lastStep) restart();
    const double opening = 0.5 * (m_lastStep + h);
    const ChebyshevDamping &damping = m_damping[placeFor(h)],
                           &opener = m_damping[placeFor(std::max(opening, h))];
    const RunInstants instants{begin, end, h, steps, m_inPhase && !(m_lastStep > 0.0) ? kStart : 0};
    m_x = state.x; // same size: no allocation
    m_v = m_lastStep > 0.0 ? m_half : state.v;
    double work = 0.0, heat = 0.0, step = m_lastStep, lastTime = begin;
    Rates before;
    Kick kick;
    for (std::int64_t i = 0; i <= instants.last(); ++i) {
      const double t = instants.time(i);
      const auto closeLast = [&](std::size_t f, std::size_t n) noexcept { close(system, kick, f, n); };
      const ChebyshevDamping& used = i == 0 ? opener : damping;
      const Rates rates =
        system.evaluate(t, m_x, m_v, m_force, used.stages() > 1 ? m_damper.data() : nullptr,
                        i > 0 ? NodeSweep(closeLast) : NodeSweep{}, latenessOf(i, instants));
      // Over a step the velocity is that of its middle: the forces before and after meet the same one.
      if (i > 0) {
        const double share = step / h;
        work += 0.5 * share * (before.work - before.loads + system.loadPower(lastTime, m_v) + rates.work);
        heat += share * rates.heat;
      }
      before = rates;
      lastTime = t;
      if (i == instants.last()) m_half = m_v;
      const double next = instants.stepAfter(i);
      kick = {&used, 0.5 * (step + next), next, {}, {}};
      if (m_inPhase) weighPast(kick, step, next);
      step = next;
      open(system, kick);
      if (m_inPhase && next > 0.0) {
        m_past.past.swap(m_past.older);
        m_past.known = std::min(m_past.known + 1, 2);
      }
    }
    system.sweepNodes([&](std::size_t f, std::size_t n) noexcept { close(system, kick, f, n); });
    report.steps += steps;
    m_lastStep = 0.0;
    if (!allFinite(m_x, m_v)) {
      for (NodeArray* array : {&m_past.past, &m_past.older}) std::fill(array->begin(), array->end(), Lanes{});
      restart();
      return StepResult::NonFinite;
    }
    state.advanceTo(end, m_x, m_v, h * work, h * heat);
    m_lastStep = instants.stepBefore(instants.last());
    return StepResult::Done;
  }

private:
  /// The velocities of step i are those of its middle, its places those of its end: while dampers turn meanwhile,
  /// their heat would be of first order. Once in eight steps the pass is asked what that makes, for all of them.
  static Lateness latenessOf(std::int64_t i, const RunInstants& instants) noexcept
  {
    constexpr std::int64_t kTogether = 8;
    if (i == 0) return {};
    const std::int64_t first = (i - 1) / kTogether * kTogether,
                       last = std::min(first + kTogether, instants.last());
    if (i != (first + last + 1) / 2) return {};
    const double step = instants.stepBefore(i);
    return {0.5 * step, (instants.time(last) - instants.time(first)) / step};
  }

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
    PastWeights push, next; ///< see StagedKick
  };

  /// Of a kick from the middle of a step of length `before` to that of a step of length `after` [s]; 0: from
  /// the step's end, or to it. With a'' and a' at the present instant,
  /// u' - u = (before + after)/2 a + (after^2 - before^2)/6 a' + (after^3 + before^3)/24 a''.
  void weighPast(Kick& kick, double before, double after) const noexcept
  {
    kick.next = {0.0, 1.0, 0.0};
    if (m_past.known < 2) return;
    kick.push = PastWeights::series((after - before) / 3.0,
                                    (after * after - after * before + before * before) / 12.0, before);
    if (after > 0.0 && after != before) kick.next = PastWeights::interpolated(after / before);
  }

  StagedKick staged(const System& system, const Kick& kick, std::size_t first, std::size_t nodes) noexcept
  {
    const auto& viscosity = system.forces().nodeViscosity();
    return {nodes,
            kick.length,
            system.inverseMass().data() + first,
            viscosity.empty() ? nullptr : viscosity.data() + first,
            m_force.data() + first,
            m_a.data() + first,
            m_inPhase ? m_past.past.data() + first : nullptr,
            m_inPhase ? m_past.older.data() + first : nullptr,
            kick.push,
            kick.next,
            kick.drift > 0.0};
  }

  /// The stages but for the last sweep over the nodes: that goes with the next pass over the springs.
  void open(System& system, const Kick& kick) noexcept
  {
    const int last = kick.damping->stages();
    if (last == 1) return;
    system.addDamping(m_damper.data(), m_a, m_force,
                      [&](std::size_t f, std::size_t n) noexcept { firstStage(staged(system, kick, f, n)); });
    for (int j = 2; j < last; ++j) {
      system.addDamping(m_damper.data(), m_before, m_force, [&](std::size_t f, std::size_t n) noexcept {
        middleStage(staged(system, kick, f, n), kick.damping->stage(j), j, m_d.data() + f,
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
      lastStage(staged(system, kick, first, nodes), kick.damping->stage(last), last, kick.drift,
                m_d.data() + first, m_before.data() + first, m_v.data() + first, m_x.data() + first);
  }

  /// Forces one and two steps before the present instant [N].
  struct Past {
    NodeArray past, older;
    int known = 0;
  };
  struct Mark : Past {
    NodeArray half; ///< see m_half
    double time = 0.0, lastStep = 0.0;
  };
  /// With Stoermer's difference a start, which knows no past, errs by the square of its first part: halvings
  /// of the step.
  static constexpr int kStart = 2;
  static constexpr double kFurthest = 6.0; ///< in steps, that what is known of the past reaches back

  int m_order;                             ///< of the damping
  bool m_inPhase;                          ///< with Stoermer's difference
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
  Past m_past;
  Mark m_mark;
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

std::unique_ptr<Integrator> makeStoermer3()
{
  return std::make_unique<Leapfrog>(2, true);
}

} // namespace esm
