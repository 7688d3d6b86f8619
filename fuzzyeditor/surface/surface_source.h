// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/fuzzy/control_surface.h"

#include <QObject>
#include <QTimer>

#include <optional>
#include <vector>

namespace esm {

class FuzzyEvaluation;

/// The control surface for map and table: computed when one of them asks, once for both, and only anew when
/// rules or one of the other inputs changed. What does not fit into a frame (bells take longer than
/// triangles) is shown coarsely first and refined while nothing else is to be done. GUI thread.
class SurfaceSource : public QObject {
  Q_OBJECT
public:
  /// @param evaluation not owned, outlives this.
  explicit SurfaceSource(FuzzyEvaluation* evaluation, QObject* parent = nullptr);

  FuzzyEvaluation* evaluation() const { return m_evaluation; }
  void setQuestion(int output, int x, int y); ///< what the rule base has not is left out: see variables
  const fuzzy::SurfaceQuestion& question() const { return m_question; }
  const fuzzy::Variable* output() const; ///< null if there is none
  const fuzzy::Variable* inputX() const;
  const fuzzy::Variable* inputY() const;

  /// Null where there is no such surface.
  const fuzzy::ControlSurface* surface() const;
  bool isRefining() const { return m_sweep.has_value(); }
  int computations() const { return m_computations; } ///< so that a test can prove the laziness

signals:
  void changed(); ///< surface, variables or present inputs; once per turn of the event loop

private:
  void compute() const;
  void refine();
  std::vector<fuzzy::InputValue> otherInputs() const;

  FuzzyEvaluation* m_evaluation;
  fuzzy::SurfaceQuestion m_question;
  mutable QTimer m_idle;
  mutable bool m_stale = true;
  mutable int m_computations = 0;
  mutable std::vector<fuzzy::InputValue> m_others; ///< at which the surface was computed
  mutable std::optional<fuzzy::ControlSurface> m_surface;
  mutable std::optional<fuzzy::SurfaceSweep> m_sweep; ///< the fine one, unfinished
};

} // namespace esm
