// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/fuzzy/rule_base.h"

#include <QString>
#include <QStringList>

namespace esm {

/// What may follow in a rule that is being written.
struct RuleCompletion {
  QString prefix;        ///< what stands of the word already, before the cursor
  QStringList proposals; ///< whole words or names, in the order of the rule base
};

/// @param before the line's text before the cursor. Names of variables follow IF, AND, OR, NOT and THEN,
/// words of the variable and hedges follow IS, keywords follow the rest.
RuleCompletion completeRule(const QString& before, const fuzzy::RuleBase& rules, Language language);

} // namespace esm
