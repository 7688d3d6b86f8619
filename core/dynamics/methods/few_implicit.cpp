// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/methods/integrator.h"
#include "core/dynamics/methods/stiff_nodes.h"
#include "core/dynamics/methods/verlet_sweeps.h"

#include <algorithm>
#include <cmath>

namespace esm {
namespace {

/// Velocity Verlet for all nodes but a few, which take the trapezoidal rule: explicit and implicit nodes side by
/// side (Belytschko and Mullen 1978, Hughes and Liu 1978). The many go first, so that the few find their
/// neighbours' ends known, and their own is a system of three unknowns each. The step is bound by what the many
/// bear while the few are held; a hub of 1e5 springs bears a 180th of that. Newton's iteration takes a force pass
/// each time, mostly two in a step, one where the few go smoothly enough to be foretold.
class FewImplicit final : public Integrator {
public:
  void prepare(const System& system) override
  {
    for (NodeArray* array : {&m_a, &m_p, &m_x, &m_v, &m_force})
      array->assign(system.nodeCount(), Lanes{0, 0, 0, 0});
    m_few.prepare(system, StiffNodes::find(system));
    const std::size_t few = m_few.nodes().size();
    for (Eigen::VectorXd* vector : {&m_residual, &m_placeX, &m_placeV, &m_inertia})
      vector->resize(static_cast<Eigen::Index>(3 * few));
    for (auto* array : {&m_startX, &m_startV, &m_startA}) array->resize(few);
    m_step = m_few.step();
    restart();
  }
  void restart() noexcept override
  {
    m_started = false;
    m_pastCount = 0;
    m_pastStep = 0.0;
  }
  void constraintsChanged(const System& system) override { prepare(system); }
  int order() const noexcept override { return 2; }
  void setSolveTolerance(double tolerance, bool /*rough*/) noexcept override { m_tolerance = tolerance; }
  double stableStep(const FastestMode&) const noexcept override { return m_step / 0.95; }
  double stepCost(const System& system, double /*h*/) override
  {
    return m_meanPasses * system.forces().passCost() + static_cast<double>(system.nodeCount());
  }

  StepResult run(System& system, MotionState& state, double end, std::int64_t steps,
                 StepReport& report) override
  {
    const double begin = state.time, h = (end - begin) / static_cast<double>(steps);
    for (std::int64_t i = 1; i <= steps; ++i) {
      if (system.isExhausted()) return StepResult::NotConverged;
      const StepResult result =
        step(system, state, h, i == steps ? end : begin + static_cast<double>(i) * h, report);
      if (result != StepResult::Done) return result;
    }
    return StepResult::Done;
  }

  StepResult step(System& system, MotionState& state, double h, double end, StepReport& report) override
  {
    if (!m_started) start(system, state);
    if (m_sinceLook++ >= kBetweenLooks || m_factoredStep != h) {
      m_few.look(system, state.x, state.v);
      m_sinceLook = m_pastCount = 0;
      m_step = m_few.step();
      m_factoredStep = m_few.prepareAnswer(system, h) ? h : 0.0;
      if (m_factoredStep == 0.0 || h > kTooLong * m_step) return fail();
    }
    ++report.steps;
    m_x = state.x; // same size: no allocation
    m_v = state.v;
    const Prediction how{h, carryFor(h)};
    system.sweepNodes([&](std::size_t f, std::size_t n) noexcept {
      predictNodes(how, n, m_a.data() + f, m_x.data() + f, m_v.data() + f, m_p.data() + f);
    });
    Rates rates;
    if (!solve(system, state, h, end, rates)) return fail();
    const double* inverseMass = system.inverseMass().data();
    system.sweepNodes([&](std::size_t f, std::size_t n) noexcept {
      correctNodes(h, n, inverseMass + f, m_force.data() + f, m_a.data() + f, m_v.data() + f);
    });
    endFew(h);
    if (!allFinite(m_x, m_v)) return restart(), StepResult::NonFinite;
    system.place(end, m_x, m_v);
    const double work = 0.5 * h * (m_rates.work + rates.work), heat = 0.5 * h * (m_rates.heat + rates.heat);
    m_rates = rates;
    state.advanceTo(end, m_x, m_v, work, heat);
    return StepResult::Done;
  }

private:
  static constexpr int kBetweenLooks = 64, kMostPasses = 8;
  static constexpr double kTooLong = 1.1; ///< a step that was stable at the last look

  StepResult fail() noexcept { return restart(), StepResult::NotConverged; }

  double carryFor(double h) const noexcept { return leastCarry(m_few.stiffness(), m_few.damping(), h); }

  void start(System& system, MotionState& state) noexcept
  {
    m_rates = system.evaluate(state.time, state.x, state.v, m_a);
    m_p = state.v; // same size: no allocation
    system.toAccelerations(m_a);
    m_started = true;
    m_sinceLook = kBetweenLooks;
  }

  /// Where the few will be. Their own swing is fast, so no curve through their places tells; but what they swing
  /// about moves as their neighbours do: the force g = K x + D v + M a of a straight spring to that goal goes by a
  /// parabola, and the rule's own end under it is found without a pass.
  void foretell(const System& system, const MotionState& state, double h)
  {
    if (m_pastStep != h) m_pastCount = 0;
    m_pastStep = h;
    for (std::size_t k = 0; k < m_few.nodes().size(); ++k) {
      const std::size_t i = at(m_few.nodes()[k]);
      m_startX[k] = m_x[i] = state.x[i];
      m_startV[k] = m_p[i] = state.v[i];
      m_startA[k] = m_a[i];
    }
    m_pull = pull(system);
    for (std::size_t k = 0; k < m_few.nodes().size(); ++k) setEnd(k, h);
    if (m_pastCount >= 2) {
      m_change = 3.0 * (m_pull - m_pastPull[0]) + m_pastPull[1] - pull(system);
      m_few.answer(m_change);
      move(h);
    }
    m_pastPull[1].swap(m_pastPull[0]);
    m_pastPull[0] = m_pull; // same size: no allocation
    m_pastCount = std::min(m_pastCount + 1, 2);
  }

  /// g from m_x, m_p and m_a.
  Eigen::VectorXd pull(const System& system)
  {
    for (std::size_t k = 0; k < m_few.nodes().size(); ++k) {
      const std::size_t i = at(m_few.nodes()[k]);
      const auto place = static_cast<Eigen::Index>(3 * k);
      m_placeX.segment<3>(place) = toVector(m_x[i]);
      m_placeV.segment<3>(place) = toVector(m_p[i]);
      m_inertia.segment<3>(place) = system.mass()[i] * toVector(m_a[i]);
    }
    return m_few.hold(m_placeX, m_placeV) + m_inertia;
  }

  /// The ends of the few by m_change.
  void move(double h) noexcept
  {
    for (std::size_t k = 0; k < m_few.nodes().size(); ++k) {
      m_x[at(m_few.nodes()[k])] += toLanes(m_change.segment<3>(static_cast<Eigen::Index>(3 * k)));
      setEnd(k, h);
    }
  }

  /// Velocity and acceleration by the trapezoidal rule from the place at hand.
  void setEnd(std::size_t k, double h) noexcept
  {
    const std::size_t i = at(m_few.nodes()[k]);
    m_p[i] = (m_x[i] - m_startX[k]) * (2.0 / h) - m_startV[k];
    m_a[i] = (m_p[i] - m_startV[k]) * (2.0 / h) - m_startA[k];
  }

  /// The ends of the few, and all forces there.
  bool solve(System& system, const MotionState& state, double h, double end, Rates& rates)
  {
    foretell(system, state, h);
    const double enough =
      m_tolerance * m_tolerance * static_cast<double>(system.nodeCount()); // sum over the nodes
    for (int pass = 1; pass <= kMostPasses; ++pass) {
      rates = system.evaluate(end, m_x, m_p, m_force);
      for (std::size_t k = 0; k < m_few.nodes().size(); ++k) {
        const std::size_t i = at(m_few.nodes()[k]);
        m_residual.segment<3>(static_cast<Eigen::Index>(3 * k)) =
          toVector(m_force[i] - m_a[i] * system.mass()[i]);
      }
      if (pass > 1) m_few.learn(m_change, m_before - m_residual);
      m_before = m_change = m_residual; // same size: no allocation
      m_few.answer(m_change);
      move(h);
      const double square = m_change.squaredNorm();
      if (!std::isfinite(square)) return false;
      if (square > enough) continue;
      m_meanPasses += 0.05 * (pass - m_meanPasses);
      return true;
    }
    return false;
  }

  /// What the sweeps over all nodes have made of the few is put right.
  void endFew(double h) noexcept
  {
    for (std::size_t k = 0; k < m_few.nodes().size(); ++k) {
      const std::size_t i = at(m_few.nodes()[k]);
      setEnd(k, h);
      m_v[i] = m_p[i];
    }
  }

  StiffNodes m_few;
  NodeArray m_a, m_p; ///< acceleration and predicted velocity at the state
  NodeArray m_x, m_v, m_force;
  NodeArray m_startX, m_startV, m_startA;         ///< of the few
  Eigen::VectorXd m_residual, m_before, m_change; ///< of the few, three each
  Eigen::VectorXd m_pull, m_pastPull[2], m_placeX, m_placeV, m_inertia;
  Rates m_rates;
  double m_step = 0.0, m_factoredStep = 0.0, m_pastStep = 0.0; ///< [s]
  double m_tolerance = 0.0;                                    ///< [m], root of the mean over all nodes
  double m_meanPasses = 2.0;                                   ///< of a step
  int m_sinceLook = 0, m_pastCount = 0;
  bool m_started = false;
};

} // namespace

std::unique_ptr<Integrator> makeFewImplicit()
{
  return std::make_unique<FewImplicit>();
}

} // namespace esm
