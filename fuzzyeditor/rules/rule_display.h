// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/fuzzy/inference.h"
#include "core/fuzzy/rule_base.h"
#include "core/fuzzy/rule_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <QString>

namespace esm {

/// A count, as Qt's models want it.
inline int toInt(std::size_t value)
{
  return static_cast<int>(value);
}

/// Core speaks UTF-8, Qt UTF-16.
inline QString toQt(std::string_view text)
{
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}
inline std::string toUtf8(QStringView text)
{
  return text.toString().toStdString();
}

/// A stretch of a QString, in UTF-16 units: what Qt's text classes count in.
struct TextRange {
  int start = 0, length = 0;
  bool operator==(const TextRange&) const = default;
};

/// A rule cut at its THEN, without IF, THEN and weight: what the two text columns of the table show.
struct RuleParts {
  QString condition, conclusion;
};

/// The unit in which physicians read a quantity: shown value = SI value / factor.
struct DisplayUnit {
  double factor = 1.0;
  QString symbol; ///< empty for a number without unit
};

/// How rules, numbers and mistakes are said to people, in one place for all fuzzy panels.
class RuleDisplay {
  Q_DECLARE_TR_FUNCTIONS(RuleDisplay)
public:
  static QString sentence(const fuzzy::Rule& rule, const fuzzy::RuleBase& rules, Language language);
  static RuleParts parts(const fuzzy::Rule& rule, const fuzzy::RuleBase& rules, Language language);

  /// Keyword number i of Vocabulary::keywords (IF THEN IS AND OR NOT WITH).
  enum Keyword { If, Then, Is, And, Or, Not, With };
  static QString keyword(Keyword keyword, Language language);

  /// The error's byte range in `utf8` as UTF-16 range. An empty range (something is missing) is moved to the
  /// last word before it, so that there is something to underline.
  static TextRange mistakeRange(const std::string& utf8, const fuzzy::RuleTextError& error);
  /// The mistake as a translated sentence; `word` is the offending text, empty if something is missing.
  static QString mistakeSentence(const fuzzy::RuleTextError& error, const QString& word, Language language);
  static QString offendingWord(const std::string& utf8, const fuzzy::RuleTextError& error);

  static QString name(const fuzzy::Variable& variable, Language language);
  /// The name with a capital, for labels and the start of a sentence.
  static QString title(const fuzzy::Variable& variable, Language language);
  static DisplayUnit displayUnit(const std::string& unit);
  /// A number with so many significant digits, no exponent, no group separators.
  static QString number(double value, const QLocale& locale, int significant = 3);
  /// "48 kPa": an SI value in its display unit.
  static QString quantity(double value, const std::string& unit, const QLocale& locale);
  /// The same for a variable; what tissue knows (core/tissue/tissue_units.h) as physicians read it: "55 %".
  static QString quantity(double value, const fuzzy::Variable& variable, const QLocale& locale);
  /// "hardness 0.50, elasticity low": the present inputs, for messages.
  static QString inputs(const std::vector<fuzzy::InputValue>& values, const fuzzy::RuleBase& rules,
                        Language language, const QLocale& locale);
};

} // namespace esm
