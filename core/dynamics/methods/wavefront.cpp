// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/methods/integrator.h"
#include "core/dynamics/methods/wavefront_order.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace esm {
namespace {

/// A force may change by this share of the net's greatest force within one propagation.
constexpr double kThreshold = 0.5;
/// How often a propagation starts over, each time with half the inner step.
constexpr int kMostRestarts = 4;

/// The second propagation of Radetzky, Nuernberger, Teistler and Pretschner, "Elastodynamic Shape Modeling in
/// Virtual Medicine" (1999), section 3.1, "Propagation". Taken from there:
///
/// - a propagation starts at the node with the greatest force and goes on, node layer by spring layer, until
///   all are computed; what comes later feels the new places of what came before;
/// - it notes the node with the greatest difference between its old and its newly computed force; where that
///   exceeds a threshold, the propagation starts over from that node;
/// - the inner step varies, since instability lasts only for short intervals, and keeps step with t_delta of
///   the display.
///
/// The paper leaves open, and here it is decided: when the front reaches a node, that moves, x += h v; then
/// each spring to a node that is still ahead is computed from the newest places, and its
/// impulse h T goes to both ends, to be moved by when the front comes next. So each spring acts once,
/// momentum is kept, and waves with and against the front neither grow nor fade. (Nodes that take their
/// forces one by one, each from the newest places of all others, amplify the waves that run with the front:
/// unstable far below the usual limit.) The threshold is half of the greatest force in the net; starting over
/// means from the state before the propagation, with half the inner step, at most four times, then what comes
/// is taken; after two calm propagations the inner step doubles again. The caller's step is t_delta or an
/// equal part of it that is stable by itself. The start node stays until a propagation starts over.
class Wavefront final : public Integrator {
public:
  void prepare(const System& system) override
  {
    const std::size_t nodes = system.nodeCount();
    for (NodeArray* array :
         {&m_x, &m_v, &m_kicked, &m_beforeX, &m_beforeV, &m_force, &m_beforeForce, &m_outside})
      array->assign(nodes, Lanes{0, 0, 0, 0});
    m_order.prepare(system);
    m_anchors.assign(nodes, {});
    for (const Anchor& anchor : system.forces().anchors())
      m_anchors[static_cast<std::size_t>(anchor.node)].push_back(anchor);
    restart();
  }
  void restart() noexcept override
  {
    m_started = false;
    m_isArmed = false;
  }
  int order() const noexcept override { return 1; }

  /// Springs are computed one by one.
  double stepCost(const System& system, double /*h*/) override
  {
    return 4.0 * static_cast<double>(system.forces().activeSprings());
  }

  /// A third of symplectic Euler's, h^2 w^2 / 4 + h g / 2 < 1: near the whole, undamped nets start over so
  /// often that changing the order stirs them up.
  double stableStep(const FastestMode& mode) const noexcept override
  {
    const double linear = 0.5 * mode.damping;
    return 0.3 * 2.0 / (linear + std::sqrt(linear * linear + mode.stiffness));
  }

  StepResult step(System& system, MotionState& state, double h, double end, StepReport& report) override
  {
    m_x = state.x; // same size: no allocation
    m_v = state.v;
    m_work = m_heat = 0.0;
    if (!m_started) start(system, state.time);
    double time = state.time, inner = h;
    int restarts = 0, calm = 0;
    while (time < end) {
      const double rest = end - time;
      const double tau = rest < 1.5 * inner ? rest : inner;
      const double work = m_work, heat = m_heat;
      m_beforeX = m_x;
      m_beforeV = m_v;
      m_beforeForce = m_force;
      ++report.steps;
      const bool tooMuch = propagate(system, time, tau);
      if (!allFinite(m_x, m_v)) {
        restart();
        return StepResult::NonFinite;
      }
      if (tooMuch && restarts < kMostRestarts) {
        ++report.rejectedSteps;
        ++restarts;
        inner = 0.5 * tau;
        calm = 0;
        m_x = m_beforeX;
        m_v = m_beforeV;
        m_force = m_beforeForce;
        m_isArmed = false;
        m_work = work;
        m_heat = heat;
        continue;
      }
      time = tau == rest ? end : time + tau;
      if (!tooMuch && ++calm == 2) {
        inner = std::min(2.0 * inner, h);
        restarts = std::max(restarts - 1, 0);
        calm = 0;
      }
    }
    system.place(end, m_x, m_v);
    state.advanceTo(end, m_x, m_v, m_work, m_heat);
    return StepResult::Done;
  }

private:
  /// The first propagation only looks: where is the greatest force?
  void start(System& system, double t) noexcept
  {
    m_beforeV = m_v;
    pass(system, t, 0.0);
    m_startNode = 0;
    m_greatest = 0.0;
    for (std::size_t i = 0; i < m_x.size(); ++i) {
      const double square = dot(m_force[i], m_force[i]);
      if (!system.isFree(i) || !(square > m_greatest)) continue;
      m_greatest = square;
      m_startNode = i;
    }
    m_greatest = std::sqrt(m_greatest);
    m_started = true;
  }

  /// All nodes and springs once, from m_startNode outward. Where forces changed too much, m_startNode
  /// becomes the node where they changed most.
  /// @return whether they did.
  bool propagate(System& system, double t, double tau) noexcept
  {
    pass(system, t, tau);
    double greatest = 0.0, change = 0.0;
    std::size_t changed = m_startNode;
    for (std::size_t i = 0; i < m_x.size(); ++i) {
      if (!system.isFree(i)) continue;
      greatest = std::max(greatest, dot(m_force[i], m_force[i]));
      const Lanes difference = m_force[i] - m_beforeForce[i];
      const double square = dot(difference, difference);
      if (square > change) {
        change = square;
        changed = i;
      }
    }
    const double before = m_greatest;
    m_greatest = std::sqrt(greatest);
    if (!(std::sqrt(change) > kThreshold * std::max(before, m_greatest))) return false;
    m_startNode = changed;
    m_isArmed = false;
    return true;
  }

  /// The front's way through the net; with tau = 0 only m_force is found.
  void pass(System& system, double t, double tau) noexcept
  {
    gatherOutside(system, t);
    m_work += tau * m_outsidePower;
    m_heat += tau * m_outsideHeat;
    m_order.startAt(m_startNode);
    if (!m_isArmed) arm(system, tau);
    m_isArmed = tau > 0.0;
    m_force = m_outside; // same size: no allocation
    for (const Index node : m_order.nodes()) {
      const auto i = static_cast<std::size_t>(node);
      addNodeForces(system, i, tau);
      if (tau > 0.0) m_v[i] = m_kicked[i];
      m_x[i] += m_v[i] * tau;
      forEachAhead(i, [&](const WavefrontOrder::Neighbour& neighbour) {
        const auto j = static_cast<std::size_t>(neighbour.node);
        const SpringPull pull = pullOf(system, i, neighbour);
        m_heat += tau * pull.heat;
        m_force[i] += pull.force;
        m_force[j] -= pull.force;
        m_kicked[i] += pull.force * (system.inverseMass()[i] * tau);
        m_kicked[j] -= pull.force * (system.inverseMass()[j] * tau);
      });
    }
    system.springsEvaluated += system.forces().activeSprings();
    for (const LoadSchedule::PrescribedNode& node : system.schedule().prescribedNodes())
      if (system.schedule().isActive(node)) {
        const auto i = static_cast<std::size_t>(node.node);
        m_work -= tau * dot(m_force[i], m_v[i]);
      }
  }

  /// m_kicked as the propagation before would have left it: the velocity and the impulses of the springs
  /// ahead. Needed at the start and where the order changes.
  void arm(System& system, double tau) noexcept
  {
    m_kicked = m_v; // same size: no allocation
    for (std::size_t i = 0; i < m_x.size(); ++i)
      forEachAhead(i, [&](const WavefrontOrder::Neighbour& neighbour) {
        m_kicked[i] += pullOf(system, i, neighbour).force * (system.inverseMass()[i] * tau);
      });
    system.springsEvaluated += system.forces().activeSprings();
  }

  template <class Visit>
  void forEachAhead(std::size_t i, const Visit& visit) const noexcept
  {
    for (const WavefrontOrder::Neighbour& neighbour : m_order.neighboursOf(i))
      if (m_order.isAhead(static_cast<std::size_t>(neighbour.node), i)) visit(neighbour);
  }

  /// Weight, pressure, nodal forces and tools, as they are at the start of a propagation.
  void gatherOutside(System& system, double t) noexcept
  {
    for (std::size_t i = 0; i < m_outside.size(); ++i) m_outside[i] = system.forces().weight(i);
    system.forces().pressure().addForces(m_x.data(), m_outside.data());
    m_outsidePower = system.addLoads(t, m_v, m_outside);
    m_outsideHeat = 0.0;
    for (std::size_t k = 0; k < system.tools().size(); ++k) {
      const ToolSpring& tool = system.tools()[k];
      const auto i = static_cast<std::size_t>(tool.node);
      const Eigen::Vector3d slip = tool.targetVelocity - toVector(m_v[i]);
      m_outside[i] += toLanes(system.toolForce(k, m_x, m_v));
      m_outsideHeat += tool.viscosity * slip.squaredNorm();
      m_outsidePower += tool.viscosity * slip.dot(tool.targetVelocity);
    }
  }

  /// What acts on one node alone: outside, anchors, mass damping.
  void addNodeForces(const System& system, std::size_t i, double tau) noexcept
  {
    Lanes force = {0, 0, 0, 0};
    for (const Anchor& anchor : m_anchors[i]) {
      const Lanes drag = m_v[i] * anchor.viscosity;
      force -= (m_x[i] - anchor.point) * anchor.stiffness + drag;
      m_heat += tau * dot(drag, m_v[i]);
    }
    if (!system.forces().massDrag().empty()) {
      const Lanes drag = m_v[i] * system.forces().massDrag()[i];
      force -= drag;
      m_heat += tau * dot(drag, m_v[i]);
    }
    m_force[i] += force;
    m_kicked[i] += (m_outside[i] + force) * (system.inverseMass()[i] * tau);
  }

  struct SpringPull {
    Lanes force = {0, 0, 0, 0}; ///< on node i [N]
    double heat = 0.0;          ///< [W]
  };
  /// A spring of node i, from the newest places. Its damper takes the velocities before the propagation:
  /// those of one node after and one before it would differ even where the net moves as a whole.
  SpringPull pullOf(const System& system, std::size_t i,
                    const WavefrontOrder::Neighbour& neighbour) const noexcept
  {
    const SpringBatch& batch = system.forces().batches()[neighbour.batch];
    const auto j = static_cast<std::size_t>(neighbour.node);
    const Lanes d = m_x[j] - m_x[i];
    const double length = std::sqrt(dot(d, d));
    const double e = length - batch.restLength[neighbour.place];
    if (length < kMinSpringLength || (batch.tensionOnly && e <= 0.0)) return {};
    const double rate = dot(m_beforeV[j] - m_beforeV[i], d) / length;
    const double drag = batch.viscosity[neighbour.place] * rate;
    const double tension = springLawKernel(batch.law).respond(batch, neighbour.place, e).tension + drag;
    return {d * (tension / length), drag * rate};
  }

  WavefrontOrder m_order;
  std::vector<std::vector<Anchor>> m_anchors; ///< by node
  NodeArray m_x, m_v;                         ///< v: by which the node moved last
  NodeArray m_kicked;                         ///< v and the impulses since then
  bool m_isArmed = false;                     ///< whether m_kicked holds impulses in the present order
  NodeArray m_beforeX, m_beforeV;
  NodeArray m_force, m_beforeForce; ///< in the last propagation and the one before [N]
  NodeArray m_outside;
  double m_outsidePower = 0.0, m_outsideHeat = 0.0, m_work = 0.0, m_heat = 0.0;
  std::size_t m_startNode = 0;
  double m_greatest = 0.0; ///< force on a free node in the last propagation [N]
  bool m_started = false;
};

} // namespace

std::unique_ptr<Integrator> makeWavefront()
{
  return std::make_unique<Wavefront>();
}

} // namespace esm
