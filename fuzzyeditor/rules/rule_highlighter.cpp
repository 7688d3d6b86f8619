// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/rules/rule_highlighter.h"

#include "fuzzyeditor/panel_colors.h"

#include <QSet>
#include <QTextBlock>
#include <QTextDocument>

#include <algorithm>

namespace esm {
namespace {

/// (a|b|c) of names, longer ones first so that "very soft" wins over "very"; matches nothing if empty.
QString alternatives(const QSet<QString>& names)
{
  QStringList list;
  for (const QString& name : names)
    if (!name.isEmpty()) list << QRegularExpression::escape(name);
  std::sort(list.begin(), list.end(), [](const QString& a, const QString& b) {
    return a.size() != b.size() ? a.size() > b.size() : a < b;
  });
  return list.isEmpty() ? QStringLiteral("((?!))") : '(' + list.join('|') + ')';
}

} // namespace

RuleHighlighter::RuleHighlighter(QTextDocument* document) : QSyntaxHighlighter(document) {}

void RuleHighlighter::setVocabulary(const fuzzy::RuleBase& rules)
{
  QSet<QString> keywords, hedges, variables, terms;
  for (const Language language : {Language::English, Language::German}) {
    const fuzzy::Vocabulary words = fuzzy::vocabulary(language);
    for (const std::string& word : words.keywords) keywords << toQt(word);
    for (const std::string& word : words.hedges) hedges << toQt(word);
  }
  for (const auto* list : {&rules.inputs, &rules.outputs})
    for (const fuzzy::Variable& variable : *list) {
      variables << toQt(variable.name.english) << toQt(variable.name.german) << toQt(variable.id);
      for (const fuzzy::Term& term : variable.terms)
        terms << toQt(term.name.english) << toQt(term.name.german) << toQt(term.id);
    }
  const QString pattern =
    QStringLiteral("(?<![\\w])(?:%1|%2|%3|%4)(?![\\w])")
      .arg(alternatives(keywords), alternatives(hedges), alternatives(variables), alternatives(terms));
  if (pattern == m_words.pattern()) return;
  m_words = QRegularExpression(pattern, QRegularExpression::CaseInsensitiveOption |
                                          QRegularExpression::UseUnicodePropertiesOption);
  rehighlight();
}

void RuleHighlighter::setPalette(const QPalette& palette)
{
  m_palette = palette;
  rehighlight();
}

void RuleHighlighter::setMarks(std::vector<LineMarks> marks)
{
  const std::vector<LineMarks> old = std::exchange(m_marks, std::move(marks));
  if (old.size() != m_marks.size()) { // lines moved, so the old marks do not tell how they look now
    rehighlight();
    return;
  }
  const LineMarks none;
  for (QTextBlock block = document()->begin(); block.isValid(); block = block.next()) {
    const auto line = static_cast<std::size_t>(block.blockNumber());
    const LineMarks& before = line < old.size() ? old[line] : none;
    const LineMarks& after = line < m_marks.size() ? m_marks[line] : none;
    if (before != after) rehighlightBlock(block);
  }
}

QTextCharFormat RuleHighlighter::format(int group) const
{
  QTextCharFormat format;
  switch (group) {
  case 1:
    format.setForeground(panel_colors::keyword(m_palette));
    format.setFontWeight(QFont::DemiBold);
    break;
  case 2:
    format.setForeground(panel_colors::hedge(m_palette));
    format.setFontItalic(true);
    break;
  case 3:
    format.setForeground(panel_colors::variable(m_palette));
    break;
  default:
    format.setForeground(panel_colors::term(m_palette));
    break;
  }
  return format;
}

void RuleHighlighter::highlightBlock(const QString& text)
{
  const auto line = static_cast<std::size_t>(currentBlock().blockNumber());
  const LineMarks marks = line < m_marks.size() ? m_marks[line] : LineMarks();
  if (marks.off || text.trimmed().startsWith('#')) {
    QTextCharFormat grey;
    grey.setForeground(panel_colors::off(m_palette));
    grey.setFontItalic(true);
    setFormat(0, static_cast<int>(text.size()), grey);
  } else if (!m_words.pattern().isEmpty()) {
    for (auto matches = m_words.globalMatch(text); matches.hasNext();) {
      const QRegularExpressionMatch match = matches.next();
      setFormat(static_cast<int>(match.capturedStart()), static_cast<int>(match.capturedLength()),
                format(match.lastCapturedIndex()));
    }
  }
  if (!marks.mistake) return;
  for (int i = marks.mistake->start; i < marks.mistake->start + marks.mistake->length; ++i) {
    QTextCharFormat wave = QSyntaxHighlighter::format(i);
    wave.setUnderlineStyle(QTextCharFormat::WaveUnderline);
    wave.setUnderlineColor(panel_colors::mistake(m_palette));
    setFormat(i, 1, wave);
  }
}

} // namespace esm
