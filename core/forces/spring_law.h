// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/forces/node_array.h"
#include "core/net/spring_net.h"

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <span>
#include <vector>

namespace esm {

/// A spring shorter than this [m] (a hundredth of an atom) has no direction: it gives no force, neither
/// elastic nor viscous, and is counted.
inline constexpr double kMinSpringLength = 1e-12;

/// Rows of SpringBatch::record that hold what a law needs.
constexpr std::size_t lawRows(SpringLaw law) noexcept
{
  return law == SpringLaw::Linear ? 1 : 2;
}

/// A ForceTable as the lines that it consists of: g = force + slope (strain - strain of the line). The first
/// one holds below its strain, too.
struct TableLines {
  std::vector<double> strain, force, slope;
  std::vector<double> integral; ///< of g from the first strain to that of the line [1]

  explicit TableLines(const ForceTable& table);
  std::size_t count() const noexcept { return strain.size(); }
};
using SharedTables = std::shared_ptr<const std::vector<TableLines>>;

/// Whether springs of a law may be alike, see SpringBatch. What the others take from a table or a power of
/// their length differs even then.
constexpr bool canBeAlike(SpringLaw law) noexcept
{
  return law == SpringLaw::Linear || law == SpringLaw::Cubic;
}

/// Rows of SpringBatch::record of a group of springs.
constexpr std::size_t recordRows(SpringLaw law, bool damped, bool alike) noexcept
{
  const std::size_t shared = alike ? (damped ? 2 : 1) : 0;
  return 2 + lawRows(law) + (damped ? 1 : 0) - shared;
}

/// The springs of one law, with or without dampers, tension-only or not: one call serves them all. One array
/// per property, padded to whole groups of four by springs from the first one's end to itself, which are too
/// short to pull.
struct SpringBatch {
  SpringLaw law = SpringLaw::Linear;
  bool damped = false;
  bool tensionOnly = false;
  /// All have the same k and c, as those of nets do that nobody has given tissue yet: these are not read
  /// spring by spring then. Of 100,000 nodes, which no cache holds, a pass takes a sixth less.
  bool alike = false;
  std::size_t count = 0;                                ///< without the padding
  std::vector<Index> a, b;                              ///< ends
  std::vector<double> restLength, stiffness, viscosity; ///< [m] [N/m] [N s/m]
  std::vector<double> parameter;                        ///< a, b of the law, or the index of the table [1]
  /// What a force pass reads, by finish(): recordRows() rows of four for each group of four springs. Side by
  /// side, since as many arrays need more registers than there are for their addresses.
  ///
  ///     0     ends a, then ends b, as places in a NodeArray [bytes], eight std::uint32_t
  ///     1     rest length L [m]
  ///     2 ..  lawRows() of the law: linear k; cubic k, a/L^2; exponential k L/b, b/L; table k L, 1/L
  ///     last  viscosity c, if damped [N s/m]
  ///
  /// Where springs are alike neither k nor c is among them.
  NodeArray record;
  NodeArray shared;                  ///< if alike: k, c and sqrt(c), each in all lanes
  NodeArray ends;                    ///< the rows 0 alone, if damped: what addDamping() reads of a spring
  std::vector<double> rootViscosity; ///< sqrt(c)
  std::vector<Index> spring;         ///< place in the SpringNet, `count` entries
  SharedTables tables;               ///< all of the net's, for the table law only
  /// That of all springs, if they have the same one. By finish().
  const TableLines* table = nullptr;

  std::size_t paddedCount() const noexcept { return a.size(); }
  std::size_t recordRows() const noexcept { return esm::recordRows(law, damped, alike); }
  void append(const SpringNet& net, Index s);
  /// After the last append(): puts the springs into the order of conflictFreeOrder(), pads and derives.
  void finish(std::size_t nodeCount);
  /// The same in the order given, for few springs that are looked at once.
  void finishAsGiven();
  /// Other numbers for the spring at a place, of the same kind: law, table, damped or not. Then changed().
  void set(std::size_t place, double newStiffness, double newViscosity, double newParameter);
  /// After the last set(). The batch is then to the bit what finish() makes of these numbers.
  /// @return springs looked at besides: none but where they are, or become, or might have become alike.
  std::size_t changed();

private:
  std::size_t findAlike();
  void findTable();
  void fillRecord();
  void putRecord(std::size_t i) noexcept;

  std::size_t m_unlike = 0; ///< a spring with another k or c than the first one; 0: not known
};

/// The damping of a batch at one instant, kept by addForces(): for each group of four springs the x, y and z
/// of q = sqrt(c) u. Between two ends a and b it is the force q (q.w) on a and its opposite on b.
using DamperArray = NodeArray;
inline std::size_t damperSize(const SpringBatch& batch) noexcept
{
  return batch.damped ? batch.paddedCount() / 4 * 3 : 0;
}
/// Adds the forces of the kept dampers at velocities v (N) to `force` (N): less than half of a full pass.
void addDamping(const SpringBatch& batch, const Lanes* damper, const Lanes* v, Lanes* force) noexcept;

/// For methods whose velocities are older than the places that they have led to: the power of dampers with these
/// velocities where the places were then. A spring turns by little meanwhile, so what that makes may be asked for now
/// and then, for some passes at once.
struct Lateness {
  double time = 0.0;   ///< [s], 0: none
  double passes = 1.0; ///< for which one pass brings what it makes
};

/// A spring's answer to one extension.
struct SpringResponse {
  double tension = 0.0; ///< f(e) [N]
  double tangent = 0.0; ///< df/de [N/m]
};

/// How much of each part of a spring's tangent goes into a matrix: of a step of length h, h and h^2.
struct TangentShares {
  double viscosity, stiffness;
};
/// Rows of four springs' blocks in a SpringMatrix: x, y and z of the direction u, axial - lateral, lateral.
inline constexpr std::size_t kTangentRows = 5;

/// One elastic law. Implementations are stateless and live for ever; see springLawKernel() for the table.
class SpringLawKernel {
public:
  virtual ~SpringLawKernel() = default;

  /// Adds the forces of a whole batch to `force`. With d = x[b] - x[a], l = |d|, e = l - L, w = v[b] - v[a]:
  ///
  ///     T = f(e) + c (w.d)/l,   force[a] += T d/l,   force[b] -= T d/l
  ///
  /// @param x, v, force  N entries each; contributions are added, the caller clears `force`.
  /// @param damper  damperSize() entries that receive the damping, or null.
  /// @param late  for the power alone, with `damper`; costs a seventh.
  /// @return the power that the dampers turn into heat [W].
  /// @note Any thread. Never throws or allocates. Springs are summed in array order and each lane computes
  ///       what a single spring would, so equal input gives equal bits with and without AVX2.
  virtual double addForces(const SpringBatch& batch, const Lanes* x, const Lanes* v, Lanes* force,
                           Lanes* damper, const Lateness& late) const noexcept = 0;

  /// The energy of a whole batch, the integrals of f from 0 to e [J]; equal bits, as above.
  virtual double energy(const SpringBatch& batch, const Lanes* x) const noexcept = 0;

  /// The tensions of a batch, dampers included [N], each at its spring's place in `tension` unless that is
  /// null. @return the largest absolute one.
  virtual double tensions(const SpringBatch& batch, const Lanes* x, const Lanes* v,
                          double* tension) const noexcept = 0;

  /// The convex part of the tangents of a batch, kTangentRows rows for each group of four springs:
  ///
  ///     axial = stiffness max(f', 0) + viscosity c,   lateral = stiffness max(T/l, 0);
  ///
  /// 0 for springs that are slack, too short, or only fill up. Equal bits, as above.
  virtual void tangents(const SpringBatch& batch, const Lanes* x, const Lanes* v, const TangentShares& shares,
                        Lanes* rows) const noexcept = 0;

  /// One spring at extension e [m], without damper and tension-only flag: the slow door, for tangents and
  /// tests.
  virtual SpringResponse respond(const SpringBatch& batch, std::size_t i, double e) const noexcept = 0;

  /// df/d(parameter) at extension e [N], for learning: exact, also where the parameter is 0. A table has no
  /// such slope: 0.
  /// @param stiffness, restLength, parameter  of the spring [N/m] [m] [1].
  virtual double parameterSlope(double stiffness, double restLength, double parameter,
                                double e) const noexcept = 0;
};

/// What the tension of a spring hangs on at one distance l = L + e of its ends.
struct SpringSlopes {
  double byStiffness = 0.0;  ///< df/dk [m]
  double byParameter = 0.0;  ///< df/da or df/db [N]
  double byRestLength = 0.0; ///< df/dL [N/m]
};
/// Of the spring at a place of a batch; all 0 where it is slack.
SpringSlopes springSlopes(const SpringNet& net, const SpringBatch& batch, std::size_t i, double e) noexcept;

const SpringLawKernel& springLawKernel(SpringLaw law) noexcept;

/// The order in which a pass goes over springs or triangles: as given, but two that share a node stand at
/// least a dozen places apart where that is possible. A processor that must add to a force which it has just
/// stored waits for the store; in the order of a mesh that costs a third of the pass.
/// @param nodes  one list per end or corner, all of one length, of nodes below nodeCount
/// @return places in them
std::vector<std::size_t> conflictFreeOrder(std::size_t nodeCount,
                                           std::initializer_list<std::span<const Index>> nodes);

// The implementations, one file each.
const SpringLawKernel& linearLaw() noexcept;
const SpringLawKernel& cubicLaw() noexcept;
const SpringLawKernel& exponentialLaw() noexcept;
const SpringLawKernel& tableLaw() noexcept;

} // namespace esm
