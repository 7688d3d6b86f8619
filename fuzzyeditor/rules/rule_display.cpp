// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/rules/rule_display.h"

#include "core/tissue/tissue_units.h"

#include <QStringList>

#include <algorithm>
#include <cmath>

namespace esm {

QString RuleDisplay::sentence(const fuzzy::Rule& rule, const fuzzy::RuleBase& rules, Language language)
{
  return toQt(fuzzy::formatRule(rule, rules, language));
}

QString RuleDisplay::keyword(Keyword keyword, Language language)
{
  const std::vector<std::string> words = fuzzy::vocabulary(language).keywords;
  const auto index = static_cast<std::size_t>(keyword);
  return index < words.size() ? toQt(words[index]) : QString();
}

RuleParts RuleDisplay::parts(const fuzzy::Rule& rule, const fuzzy::RuleBase& rules, Language language)
{
  fuzzy::Rule unweighted = rule;
  unweighted.weight = 1.0;
  const QString text = sentence(unweighted, rules, language);
  const QString then = ' ' + keyword(Then, language) + ' ';
  const qsizetype cut = text.indexOf(then);
  if (cut < 0) return {text, {}};
  RuleParts parts{text.left(cut), text.mid(cut + then.size())};
  const QString start = keyword(If, language) + ' ';
  if (parts.condition.startsWith(start)) parts.condition.remove(0, start.size());
  if (const qsizetype weight = parts.conclusion.lastIndexOf(' ' + keyword(With, language) + ' '); weight >= 0)
    parts.conclusion.truncate(weight);
  return parts;
}

TextRange RuleDisplay::mistakeRange(const std::string& utf8, const fuzzy::RuleTextError& error)
{
  const std::size_t offset = std::min(error.offset, utf8.size());
  const std::size_t length = std::min(error.length, utf8.size() - offset);
  const QString before = toQt(std::string_view(utf8).substr(0, offset));
  if (length > 0)
    return {static_cast<int>(before.size()),
            static_cast<int>(toQt(std::string_view(utf8).substr(offset, length)).size())};
  qsizetype end = before.size();
  while (end > 0 && before[end - 1].isSpace()) --end;
  qsizetype start = end;
  while (start > 0 && !before[start - 1].isSpace()) --start;
  return {static_cast<int>(start), static_cast<int>(end - start)};
}

QString RuleDisplay::offendingWord(const std::string& utf8, const fuzzy::RuleTextError& error)
{
  const std::size_t offset = std::min(error.offset, utf8.size());
  return toQt(std::string_view(utf8).substr(offset, error.length));
}

QString RuleDisplay::mistakeSentence(const fuzzy::RuleTextError& error, const QString& word,
                                     Language language)
{
  using Kind = fuzzy::RuleTextError::Kind;
  const auto expected = [&](Keyword missing) {
    const QString keywordText = keyword(missing, language);
    return word.isEmpty() ? tr("The word ‘%1’ is missing here.").arg(keywordText)
                          : tr("The word ‘%1’ is expected before ‘%2’.").arg(keywordText, word);
  };
  switch (error.kind) {
  case Kind::ExpectedIf:
    return tr("A rule begins with ‘%1’.").arg(keyword(If, language));
  case Kind::ExpectedThen:
    return expected(Then);
  case Kind::ExpectedIs:
    return expected(Is);
  case Kind::ExpectedVariable:
    return word.isEmpty() ? tr("The name of a variable is missing here.")
                          : tr("‘%1’ stands where the name of a variable is expected.").arg(word);
  case Kind::ExpectedTerm:
    return word.isEmpty() ? tr("A word that describes the variable is missing here.")
                          : tr("‘%1’ stands where a word for the variable is expected.").arg(word);
  case Kind::UnknownVariable:
    return tr("There is no variable named ‘%1’.").arg(word);
  case Kind::UnknownTerm:
    return tr("‘%1’ is not a word of this variable.").arg(word);
  case Kind::OutputInCondition:
    return tr("‘%1’ is a result and cannot stand in the condition.").arg(word);
  case Kind::InputInConclusion:
    return tr("‘%1’ is an input and cannot stand in the conclusion.").arg(word);
  case Kind::ExpectedWeight:
    return tr("A weight between 0 and 1 is expected here.");
  case Kind::UnbalancedParenthesis:
    return tr("A parenthesis lacks its partner.");
  case Kind::UnexpectedText:
    return tr("‘%1’ does not belong here.").arg(word);
  case Kind::Empty:
    return tr("The text is empty.");
  }
  return toQt(error.message);
}

QString RuleDisplay::name(const fuzzy::Variable& variable, Language language)
{
  return toQt(variable.name.in(language));
}

QString RuleDisplay::title(const fuzzy::Variable& variable, Language language)
{
  QString text = name(variable, language);
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text;
}

DisplayUnit RuleDisplay::displayUnit(const std::string& unit)
{
  if (unit == "Pa") return {1e3, QStringLiteral("kPa")};
  if (unit == "s") return {1e-3, QStringLiteral("ms")};
  if (unit == "Pa/m") return {1e6, QStringLiteral("kPa/mm")};
  if (unit == "kg/m^3") return {1e3, QStringLiteral("g/cm³")};
  return {1.0, toQt(unit)};
}

QString RuleDisplay::number(double value, const QLocale& locale, int significant)
{
  if (!std::isfinite(value)) return QStringLiteral("–");
  QLocale plain = locale;
  plain.setNumberOptions(QLocale::OmitGroupSeparator);
  const int magnitude = value == 0.0 ? 0 : static_cast<int>(std::floor(std::log10(std::abs(value))));
  return plain.toString(value, 'f', std::clamp(significant - 1 - magnitude, 0, 9));
}

QString RuleDisplay::quantity(double value, const std::string& unit, const QLocale& locale)
{
  const DisplayUnit shown = displayUnit(unit);
  const double number = value / shown.factor;
  if (!shown.symbol.isEmpty()) return RuleDisplay::number(number, locale) + QChar(0x00a0) + shown.symbol;
  // Findings between 0 and 1: two decimals say all that a hand can tell.
  return std::abs(number) < 10 ? locale.toString(number, 'f', 2) : RuleDisplay::number(number, locale);
}

QString RuleDisplay::quantity(double value, const fuzzy::Variable& variable, const QLocale& locale)
{
  const Language language = locale.language() == QLocale::German ? Language::German : Language::English;
  for (const TissueOutput& output : kTissueOutputs)
    if (variable.id == output.id) return toQt(shownValue(value, output.value, language));
  return quantity(value, variable.unit, locale);
}

QString RuleDisplay::inputs(const std::vector<fuzzy::InputValue>& values, const fuzzy::RuleBase& rules,
                            Language language, const QLocale& locale)
{
  QStringList list;
  for (std::size_t i = 0; i < std::min(values.size(), rules.inputs.size()); ++i) {
    const fuzzy::Variable& variable = rules.inputs[i];
    const double* crisp = std::get_if<double>(&values[i]);
    list << name(variable, language) + ' ' +
              (crisp ? quantity(*crisp, variable.unit, locale)
                     : toQt(fuzzy::formatInput(values[i], variable, language)));
  }
  return list.join(QStringLiteral(", "));
}

} // namespace esm
