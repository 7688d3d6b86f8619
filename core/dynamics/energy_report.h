// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

namespace esm {

struct Energies {
  double kinetic = 0.0; ///< [J]
  double elastic = 0.0; ///< springs, anchors and tool springs [J]
  double gravity = 0.0; ///< - sum m g.p, zero at the origin [J]
  double total() const noexcept { return kinetic + elastic + gravity; }
  Energies& operator+=(const Energies& other) noexcept
  {
    kinetic += other.kinetic;
    elastic += other.elastic;
    gravity += other.gravity;
    return *this;
  }
};

/// Where the energy of a motion has gone since t = 0 [J]:
///
///     at start + work + restored = heat + loss + at end + residual
///
/// All but the residual are known by themselves, so it tells what nobody accounts for.
struct EnergyReport {
  Energies atStart, atEnd;
  double work = 0.0;     ///< done by nodal forces, prescribed motions and tools
  double heat = 0.0;     ///< made by viscosity and mass damping, and where motion ends in rest
  double loss = 0.0;     ///< taken away by the method, by its own estimate; negative where it adds
  double restored = 0.0; ///< given to bodies that nothing holds, with the momentum that steps had taken

  EnergyReport& operator+=(const EnergyReport& other) noexcept
  {
    atStart += other.atStart;
    atEnd += other.atEnd;
    work += other.work;
    heat += other.heat;
    loss += other.loss;
    restored += other.restored;
    return *this;
  }

  double residual() const noexcept;
  double largestTerm() const noexcept;
  double appeared() const noexcept; ///< that nobody has put in, less what has become heat [J]
  /// Whether the method itself has added energy, or booked heat that nothing had to give: more than twice this
  /// share of the largest of all other terms, beyond half of the heat; or whether there is more in the end than
  /// was put in, by more than this share of the largest term.
  bool hasAdded(double tolerance) const noexcept;
  /// Whether the method itself has taken away more than half of the largest of all other terms. Vibrations have died then
  /// that nothing damps; no check of steps sees it where the coarser and the finer ones have both lost them.
  bool hasLost() const noexcept;
  /// Whether the residual is at most this share of the largest term, or rounding, and the method has not added.
  bool isKept(double tolerance) const noexcept;
};

} // namespace esm
