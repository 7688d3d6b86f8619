// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tissue/explain.h"

#include <QObject>

namespace esm {

/// What the panel Why asks the application: what is selected, and the tissue that explains it. GUI thread.
class WhySource : public QObject {
  Q_OBJECT
public:
  using QObject::QObject;
  virtual const TissueField* field() const = 0;      ///< as it holds now; null: the rules cannot be evaluated
  virtual TissueExplanation explanation() const = 0; ///< @pre field()
  virtual Language language() const = 0;
  virtual void apply(const InputChange& change) = 0; ///< one undo step

signals:
  void changed(); ///< something else is selected, or it has other reasons
};

} // namespace esm
