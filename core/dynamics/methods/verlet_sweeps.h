// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/forces/node_array.h"

#include <cstddef>

namespace esm {

// What methods with velocity Verlet's steps do with the nodes between two force passes.

/// How a step predicts: its length [s], and what it carries over of the former prediction's error.
struct Prediction {
  double h, carry;
};

inline constexpr double kMostCarry = 2.0 / 3.0; ///< see Verlet

/// The least carry that is stable with steps of h under this stiffness [1/s^2] and damping [1/s], kMostCarry at
/// most.
double leastCarry(double stiffness, double damping, double h) noexcept;

/// half = v + h/2 a, x' = x + h half, p' = v + h a + carry (p - v); `half` comes as v.
void predictNodes(const Prediction& how, std::size_t count, const Lanes* a, Lanes* x, Lanes* half,
                  Lanes* p) noexcept;

/// The end of a step and the prediction of the next one in one sweep: a = F/m, v = half + h/2 a.
void correctAndPredictNodes(const Prediction& how, std::size_t count, const double* inverseMass,
                            const Lanes* force, Lanes* x, Lanes* half, Lanes* p) noexcept;

/// a = F/m, v = half + h/2 a
void correctNodes(double h, std::size_t count, const double* inverseMass, const Lanes* force, Lanes* a,
                  Lanes* half) noexcept;

} // namespace esm
