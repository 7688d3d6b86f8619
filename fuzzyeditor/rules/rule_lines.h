// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/fuzzy/rule_base.h"
#include "core/fuzzy/rule_text.h"

#include <QHash>
#include <QString>
#include <QStringList>

#include <variant>
#include <vector>

namespace esm {

/// One line of the rule text.
struct RuleLine {
  enum class Kind {
    Blank, ///< empty, or a remark that starts with '#'
    Rule,
    Mistake
  };
  Kind kind = Kind::Blank;
  QString text;
  fuzzy::Rule rule;           ///< of Kind::Rule
  fuzzy::RuleTextError error; ///< of Kind::Mistake
  int source = -1;            ///< the rule that this line stands for, index into the rules the text came from
};

/// Reads lines and remembers them: while one line of 200 is typed, only that one is parsed.
class RuleLineReader {
public:
  std::vector<RuleLine> read(const QStringList& text, const fuzzy::RuleBase& rules);
  void forget() { m_known.clear(); } ///< the variables or terms changed

private:
  QHash<QString, std::variant<fuzzy::Rule, fuzzy::RuleTextError>> m_known;
};

/// Equal in all that the text can say: everything but on/off and note.
bool sameStatement(const fuzzy::Rule& a, const fuzzy::Rule& b);

/// For each of `now` the rule of `before` that it continues, -1 for a new one. Equal statements belong
/// together, moved ones too; what was changed in place is told by its neighbours. A null entry (a line that
/// is no rule yet) can only be told by its neighbours. Each rule of `before` is continued once at most.
std::vector<int> matchRules(const std::vector<const fuzzy::Rule*>& now,
                            const std::vector<fuzzy::Rule>& before);

/// Sets RuleLine::source of all lines.
void findSources(std::vector<RuleLine>& lines, const std::vector<fuzzy::Rule>& before);

/// The rules that the lines say, with on/off and note of those they continue.
/// @pre findSources() was called with `before`; mistakes are left out.
std::vector<fuzzy::Rule> rulesOf(const std::vector<RuleLine>& lines, const std::vector<fuzzy::Rule>& before);

/// The text after the rules changed elsewhere (or the language did) from `before` to now: rules appear as
/// they are now, while remarks, mistakes and lines changed but not yet applied stay as they were typed.
QStringList mergedText(const std::vector<RuleLine>& lines, const std::vector<fuzzy::Rule>& before,
                       const fuzzy::RuleBase& now, Language language);

} // namespace esm
