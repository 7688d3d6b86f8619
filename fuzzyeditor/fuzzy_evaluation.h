// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/fuzzy/inference.h"
#include "fuzzyeditor/fuzzy_document.h"

#include <QObject>
#include <QTimer>

#include <optional>
#include <vector>

namespace esm {

/// What the rules make of the current inputs, computed once for all panels and only when one of them asks:
/// hidden panels cost nothing. changed() comes once per turn of the event loop, however often a slider
/// moved meanwhile. GUI thread.
class FuzzyEvaluation : public QObject {
  Q_OBJECT
public:
  /// @param document not owned, outlives this.
  explicit FuzzyEvaluation(FuzzyDocument* document, QObject* parent = nullptr);

  FuzzyDocument* document() const { return m_document; }
  /// Empty outputs and firings if the rule base cannot be evaluated.
  const fuzzy::Inference& inference() const;
  /// How strongly a rule fires, 0 for one that is off.
  double degree(int rule) const;

  int computations() const { return m_computations; } ///< so that a test can prove the laziness

signals:
  void changed();

private:
  FuzzyDocument* m_document;
  QTimer m_announce;
  mutable bool m_stale = true;
  mutable int m_computations = 0;
  mutable std::optional<fuzzy::Engine> m_engine; ///< empty: the rules changed since it was compiled
  mutable fuzzy::Inference m_inference;
  mutable std::vector<double> m_degrees; ///< one per rule
};

} // namespace esm
