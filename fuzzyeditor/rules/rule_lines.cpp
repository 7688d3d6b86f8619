// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/rules/rule_lines.h"

#include "fuzzyeditor/rules/rule_display.h"

#include <algorithm>

namespace esm {

std::vector<RuleLine> RuleLineReader::read(const QStringList& text, const fuzzy::RuleBase& rules)
{
  if (m_known.size() > 4 * text.size() + 1000) m_known.clear(); // every state while typing is remembered
  if (text == QStringList(QString())) return {};                // an empty editor has one empty line
  std::vector<RuleLine> lines;
  lines.reserve(static_cast<std::size_t>(text.size()));
  for (const QString& line : text) {
    RuleLine& entry = lines.emplace_back();
    entry.text = line;
    const QString trimmed = line.trimmed();
    if (trimmed.isEmpty() || trimmed.startsWith('#')) continue;
    auto known = m_known.find(line);
    if (known == m_known.end()) known = m_known.insert(line, fuzzy::parseRule(toUtf8(line), rules));
    if (const auto* rule = std::get_if<fuzzy::Rule>(&*known)) {
      entry.kind = RuleLine::Kind::Rule;
      entry.rule = *rule;
    } else {
      entry.kind = RuleLine::Kind::Mistake;
      entry.error = std::get<fuzzy::RuleTextError>(*known);
    }
  }
  return lines;
}

bool sameStatement(const fuzzy::Rule& a, const fuzzy::Rule& b)
{
  return a.weight == b.weight && a.condition == b.condition && a.consequents == b.consequents;
}

namespace {

using RulePointers = std::vector<const fuzzy::Rule*>;

/// Longest common subsequence of equal statements between now[from, nowEnd) and before[from, beforeEnd).
void matchInOrder(const RulePointers& now, const std::vector<fuzzy::Rule>& before, std::size_t from,
                  std::size_t nowEnd, std::size_t beforeEnd, std::vector<int>& match)
{
  const std::size_t n = nowEnd - from, m = beforeEnd - from;
  if (n == 0 || m == 0 || n * m > 4'000'000) return; // beyond: equal statements are still found one by one
  std::vector<int> table((n + 1) * (m + 1), 0);
  std::vector<char> equal(n * m, 0);
  for (std::size_t i = n; i-- > 0;)
    for (std::size_t j = m; j-- > 0;) {
      equal[i * m + j] = now[from + i] && sameStatement(*now[from + i], before[from + j]);
      table[i * (m + 1) + j] = equal[i * m + j]
                                 ? table[(i + 1) * (m + 1) + j + 1] + 1
                                 : std::max(table[(i + 1) * (m + 1) + j], table[i * (m + 1) + j + 1]);
    }
  for (std::size_t i = 0, j = 0; i < n && j < m;) {
    if (equal[i * m + j])
      match[from + i++] = static_cast<int>(from + j++);
    else if (table[(i + 1) * (m + 1) + j] >= table[i * (m + 1) + j + 1])
      ++i;
    else
      ++j;
  }
}

/// Lines between two settled neighbours that stand where as many rules stood: those rules, changed.
/// With unequal counts only what kept its condition or its conclusion.
void matchGap(const RulePointers& now, const std::vector<fuzzy::Rule>& before,
              const std::vector<std::size_t>& nows, const std::vector<std::size_t>& befores,
              std::vector<int>& match)
{
  if (nows.size() == befores.size()) {
    for (std::size_t k = 0; k < nows.size(); ++k) match[nows[k]] = static_cast<int>(befores[k]);
    return;
  }
  std::size_t next = 0;
  for (const std::size_t i : nows)
    for (std::size_t k = next; now[i] && k < befores.size(); ++k) {
      const fuzzy::Rule& candidate = before[befores[k]];
      if (now[i]->condition != candidate.condition && now[i]->consequents != candidate.consequents) continue;
      match[i] = static_cast<int>(befores[k]);
      next = k + 1;
      break;
    }
}

} // namespace

std::vector<int> matchRules(const RulePointers& now, const std::vector<fuzzy::Rule>& before)
{
  std::vector<int> match(now.size(), -1);
  const std::size_t shorter = std::min(now.size(), before.size());
  const auto equal = [&](std::size_t i, std::size_t j) {
    return now[i] && sameStatement(*now[i], before[j]);
  };
  std::size_t head = 0, tail = 0;
  for (; head < shorter && equal(head, head); ++head) match[head] = static_cast<int>(head);
  for (; tail < shorter - head && equal(now.size() - 1 - tail, before.size() - 1 - tail); ++tail)
    match[now.size() - 1 - tail] = static_cast<int>(before.size() - 1 - tail);
  matchInOrder(now, before, head, now.size() - tail, before.size() - tail, match);

  std::vector<char> used(before.size(), 0);
  const std::vector<int> settled = match; // in order; moved ones are no landmarks
  for (const int j : match)
    if (j >= 0) used[static_cast<std::size_t>(j)] = 1;
  for (std::size_t i = head; i < now.size(); ++i)
    for (std::size_t j = 0; match[i] < 0 && j < before.size(); ++j)
      if (!used[j] && equal(i, j)) {
        match[i] = static_cast<int>(j);
        used[j] = 1;
      }

  std::vector<std::size_t> nows, befores;
  std::size_t j = 0;
  for (std::size_t i = 0; i <= now.size(); ++i) {
    const bool landmark = i == now.size() || settled[i] >= 0;
    if (!landmark) {
      if (match[i] < 0) nows.push_back(i);
      continue;
    }
    const std::size_t end = i == now.size() ? before.size() : static_cast<std::size_t>(settled[i]);
    for (; j < end; ++j)
      if (!used[j]) befores.push_back(j);
    matchGap(now, before, nows, befores, match);
    nows.clear();
    befores.clear();
    j = end + 1;
  }
  return match;
}

void findSources(std::vector<RuleLine>& lines, const std::vector<fuzzy::Rule>& before)
{
  RulePointers rules;
  for (const RuleLine& line : lines)
    if (line.kind != RuleLine::Kind::Blank)
      rules.push_back(line.kind == RuleLine::Kind::Rule ? &line.rule : nullptr);
  const std::vector<int> match = matchRules(rules, before);
  std::size_t k = 0;
  for (RuleLine& line : lines) line.source = line.kind == RuleLine::Kind::Blank ? -1 : match[k++];
}

std::vector<fuzzy::Rule> rulesOf(const std::vector<RuleLine>& lines, const std::vector<fuzzy::Rule>& before)
{
  std::vector<fuzzy::Rule> rules;
  for (const RuleLine& line : lines) {
    if (line.kind != RuleLine::Kind::Rule) continue;
    fuzzy::Rule& rule = rules.emplace_back(line.rule);
    if (line.source < 0) continue;
    const fuzzy::Rule& source = before[static_cast<std::size_t>(line.source)];
    rule.enabled = source.enabled;
    rule.note = source.note;
  }
  return rules;
}

QStringList mergedText(const std::vector<RuleLine>& lines, const std::vector<fuzzy::Rule>& before,
                       const fuzzy::RuleBase& now, Language language)
{
  // What the user typed and the rules do not say: either it replaces the rule that it stands for, or it
  // stays before the rule that follows it.
  std::vector<const RuleLine*> replacing(before.size(), nullptr);
  std::vector<std::vector<const RuleLine*>> leading(before.size() + 1);
  std::vector<const RuleLine*> waiting;
  std::vector<char> kept(before.size(), 0);
  const auto settle = [&](std::size_t place) {
    leading[place].insert(leading[place].end(), waiting.begin(), waiting.end());
    waiting.clear();
  };
  for (const RuleLine& line : lines) {
    if (line.source < 0) {
      waiting.push_back(&line);
      continue;
    }
    const auto source = static_cast<std::size_t>(line.source);
    settle(source);
    kept[source] = 1;
    if (line.kind == RuleLine::Kind::Mistake || !sameStatement(line.rule, before[source]))
      replacing[source] = &line;
  }
  settle(before.size());

  RulePointers nowRules;
  for (const fuzzy::Rule& rule : now.rules) nowRules.push_back(&rule);
  const std::vector<int> match = matchRules(nowRules, before);
  std::vector<char> present(before.size(), 0);
  for (const int j : match)
    if (j >= 0) present[static_cast<std::size_t>(j)] = 1;

  QStringList text;
  std::size_t written = 0; // `leading` of the places before this one is out
  const auto write = [&](std::size_t upTo) {
    for (; written <= upTo; ++written) {
      for (const RuleLine* line : leading[written]) text << line->text;
      if (written < before.size() && replacing[written] && !present[written])
        text << replacing[written]->text; // its rule has gone, the text typed has not
    }
  };
  for (std::size_t i = 0; i < now.rules.size(); ++i) {
    const RuleLine* typed = nullptr;
    if (match[i] >= 0) {
      const auto source = static_cast<std::size_t>(match[i]);
      write(source);
      if (!kept[source]) continue; // its line was deleted, which is not applied yet
      typed = replacing[source];
    }
    text << (typed ? typed->text : RuleDisplay::sentence(now.rules[i], now, language));
  }
  write(before.size());
  return text;
}

} // namespace esm
