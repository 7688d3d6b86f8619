// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/rules/rule_completion.h"

#include "fuzzyeditor/rules/rule_display.h"

#include <array>

namespace esm {
namespace {

using Keyword = RuleDisplay::Keyword;

constexpr std::array kKeywords{RuleDisplay::If, RuleDisplay::Then, RuleDisplay::Is,  RuleDisplay::And,
                               RuleDisplay::Or, RuleDisplay::Not,  RuleDisplay::With};

int keywordOf(const QString& word)
{
  for (const Language language : {Language::English, Language::German})
    for (const Keyword keyword : kKeywords)
      if (word.compare(RuleDisplay::keyword(keyword, language), Qt::CaseInsensitive) == 0) return keyword;
  return -1;
}

bool isHedge(const QString& word)
{
  for (const Language language : {Language::English, Language::German})
    for (const std::string& hedge : fuzzy::vocabulary(language).hedges)
      if (word.compare(toQt(hedge), Qt::CaseInsensitive) == 0) return true;
  return false;
}

bool isNamed(const fuzzy::Variable& variable, const QString& text)
{
  for (const std::string& name : {variable.name.english, variable.name.german, variable.id})
    if (text.compare(toQt(name), Qt::CaseInsensitive) == 0) return true;
  return false;
}

/// The line up to the cursor, cut at its keywords.
struct Parts {
  int keyword = -1;    ///< the last one, -1 if there is none
  bool then = false;   ///< past THEN
  QString name, after; ///< between the last two keywords; after the last keyword and hedges
};

Parts cut(const QString& before)
{
  Parts parts;
  QString spaced = before;
  spaced.replace('(', QStringLiteral(" ( ")).replace(')', QStringLiteral(" ) "));
  QStringList words = spaced.split(' ', Qt::SkipEmptyParts);
  const bool open = !before.isEmpty() && !before.back().isSpace() && before.back() != '(';
  const QString last = open && !words.isEmpty() ? words.takeLast() : QString();
  for (const QString& word : words) {
    if (const int keyword = keywordOf(word); keyword >= 0) {
      if (!parts.after.isEmpty()) parts.name = parts.after;
      parts.after.clear();
      parts.keyword = keyword;
      parts.then = parts.then || keyword == RuleDisplay::Then;
    } else if (word != "(" && !(parts.after.isEmpty() && isHedge(word))) {
      parts.after += parts.after.isEmpty() ? word : ' ' + word;
    }
  }
  if (!last.isEmpty())
    parts.after += parts.after.isEmpty() ? last : ' ' + last;
  else if (!parts.after.isEmpty())
    parts.after += ' ';
  return parts;
}

bool anyStartsWith(const QStringList& names, const QString& prefix)
{
  for (const QString& name : names)
    if (name.startsWith(prefix, Qt::CaseInsensitive)) return true;
  return false;
}

} // namespace

RuleCompletion completeRule(const QString& before, const fuzzy::RuleBase& rules, Language language)
{
  const Parts parts = cut(before);
  const auto word = [&](Keyword keyword) { return RuleDisplay::keyword(keyword, language); };
  QStringList names, next;
  if (parts.keyword < 0) {
    names << word(RuleDisplay::If);
  } else if (parts.keyword == RuleDisplay::With) {
    return {};
  } else if (parts.keyword == RuleDisplay::Is) {
    for (const auto* list : {&rules.inputs, &rules.outputs})
      for (const fuzzy::Variable& variable : *list)
        if (isNamed(variable, parts.name))
          for (const fuzzy::Term& term : variable.terms) names << toQt(term.name.in(language));
    for (const std::string& hedge : fuzzy::vocabulary(language).hedges) names << toQt(hedge);
    next << word(RuleDisplay::And);
    if (parts.then)
      next << word(RuleDisplay::With);
    else
      next << word(RuleDisplay::Or) << word(RuleDisplay::Then);
  } else {
    for (const fuzzy::Variable& variable : parts.then ? rules.outputs : rules.inputs)
      names << RuleDisplay::name(variable, language);
    if (!parts.then) names << word(RuleDisplay::Not);
    next << word(RuleDisplay::Is);
  }
  // A name may hold blanks, so a blank ends it only when no name goes on that way.
  if (anyStartsWith(names, parts.after)) return {parts.after, names};
  const qsizetype blank = parts.after.lastIndexOf(' ');
  if (blank < 0) return {parts.after, {}};
  return {parts.after.mid(blank + 1), next};
}

} // namespace esm
