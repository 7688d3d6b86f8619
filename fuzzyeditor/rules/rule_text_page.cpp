// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/rules/rule_text_page.h"

#include "fuzzyeditor/fuzzy_document.h"
#include "fuzzyeditor/rules/mistake_bar.h"
#include "fuzzyeditor/rules/rule_display.h"
#include "fuzzyeditor/rules/rule_highlighter.h"
#include "fuzzyeditor/rules/rule_text_editor.h"

#include <QEvent>
#include <QTextBlock>
#include <QVBoxLayout>

namespace esm {

RuleTextPage::RuleTextPage(FuzzyDocument* document, QWidget* parent)
  : QWidget(parent),
    m_document(document),
    m_editor(new RuleTextEditor(document)),
    m_highlighter(new RuleHighlighter(m_editor->document())),
    m_bar(new MistakeBar("rulesText"))
{
  m_editor->setObjectName("rulesText");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  layout->addWidget(m_editor, 1);
  layout->addWidget(m_bar);

  m_pause.setSingleShot(true);
  m_pause.setInterval(800); // long enough to think of the next word, short enough to see the effect
  connect(&m_pause, &QTimer::timeout, this, &RuleTextPage::applyText);
  connect(m_editor, &RuleTextEditor::applyRequested, this, &RuleTextPage::applyText);
  connect(m_editor, &QPlainTextEdit::textChanged, this, [this] {
    if (m_writing) return;
    readText();
    m_pause.start();
  });
  connect(m_editor, &QPlainTextEdit::cursorPositionChanged, this, &RuleTextPage::showMistake);
  connect(m_bar, &MistakeBar::cureRequested, this, &RuleTextPage::cure);
  const auto follow = [this] {
    m_reader.forget(); // names may have changed
    m_stale =
      true; // what is typed and not applied follows even unseen: it is to be recovered as it should be
    if (isVisible() || !m_document->ruleDraft().text.empty()) followDocument();
  };
  connect(document, &FuzzyDocument::ruleBaseChanged, this, follow);
  connect(document, &FuzzyDocument::ruleLanguageChanged, this, follow);
  connect(document, &FuzzyDocument::ruleDraftReplaced, this, &RuleTextPage::replaceText);
  connect(document, &FuzzyDocument::ruleTextWanted, this, &RuleTextPage::applyText);

  m_highlighter->setPalette(m_editor->palette());
  QEvent translate(QEvent::LanguageChange);
  changeEvent(&translate);
}

void RuleTextPage::readText()
{
  m_lines = m_reader.read(m_editor->lines(), m_document->ruleBase());
  findSources(m_lines, m_before);
  showMarks();
  const bool isApplied = m_mistakes == 0 && rulesOf(m_lines, m_before) == m_before;
  m_document->setDraftText(isApplied ? std::string() : toUtf8(m_editor->lines().join('\n')));
}

/// Another project: what was typed here goes with the former one, what was recovered with it comes.
void RuleTextPage::replaceText()
{
  m_pause.stop();
  m_reader.forget();
  const QString text = toQt(m_document->ruleDraft().text);
  m_before = text.isEmpty() ? std::vector<fuzzy::Rule>() : m_document->ruleBase().rules;
  m_writing = true;
  m_editor->setLines(text.split('\n'));
  m_writing = false;
  readText();
}

void RuleTextPage::showMarks()
{
  std::vector<RuleHighlighter::LineMarks> marks;
  int mistakes = 0;
  for (const RuleLine& line : m_lines) {
    RuleHighlighter::LineMarks& mark = marks.emplace_back();
    mark.off = line.source >= 0 && !m_before[static_cast<std::size_t>(line.source)].enabled;
    if (line.kind != RuleLine::Kind::Mistake) continue;
    mark.mistake = RuleDisplay::mistakeRange(toUtf8(line.text), line.error);
    ++mistakes;
  }
  m_writing = true; // formats count as changes of the text document
  m_highlighter->setMarks(std::move(marks));
  m_writing = false;
  showMistake();
  if (std::exchange(m_mistakes, mistakes) != mistakes) emit mistakesChanged();
}

/// The mistake in the cursor's line, else the first one.
const RuleLine* RuleTextPage::shownMistake(int* lineNumber) const
{
  const auto cursorLine = static_cast<std::size_t>(m_editor->textCursor().blockNumber());
  for (std::size_t i = 0, n = m_lines.size(); i <= n; ++i) {
    const std::size_t line = i == 0 ? cursorLine : i - 1;
    if (line >= n || m_lines[line].kind != RuleLine::Kind::Mistake) continue;
    *lineNumber = static_cast<int>(line);
    return &m_lines[line];
  }
  return nullptr;
}

void RuleTextPage::showMistake()
{
  int number = 0;
  const RuleLine* line = shownMistake(&number);
  if (!line) {
    m_bar->setMistake({}, {});
    return;
  }
  const QString word = RuleDisplay::offendingWord(toUtf8(line->text), line->error);
  const QString why = RuleDisplay::mistakeSentence(line->error, word, m_document->ruleLanguage());
  m_bar->setMistake(
    tr("Line %1: %2 The rules stay as they were until this is mended.").arg(number + 1).arg(why),
    toQt(line->error.suggestion));
}

void RuleTextPage::cure()
{
  int number = 0;
  const RuleLine* line = shownMistake(&number);
  if (!line || line->error.suggestion.empty()) return;
  const TextRange range = RuleDisplay::mistakeRange(toUtf8(line->text), line->error);
  const QString suggestion = toQt(line->error.suggestion);
  const bool missing = line->error.length == 0;
  QTextCursor cursor(m_editor->document()->findBlockByNumber(number));
  const int start = cursor.position() + range.start;
  cursor.setPosition(missing ? start + range.length : start);
  cursor.setPosition(start + range.length, QTextCursor::KeepAnchor);
  cursor.insertText(missing ? ' ' + suggestion : suggestion);
  m_editor->setTextCursor(cursor);
  m_editor->setFocus();
  applyText();
}

void RuleTextPage::applyText()
{
  m_pause.stop();
  if (m_stale || m_mistakes > 0) return;
  std::vector<fuzzy::Rule> rules = rulesOf(m_lines, m_before);
  if (rules == m_before) return;
  fuzzy::RuleBase base = m_document->ruleBase();
  base.rules = std::move(rules);
  if (const Status status = fuzzy::checkRuleBase(base); !status) {
    m_bar->setMistake(tr("The rules cannot be used: %1.").arg(toQt(status.error().detail)), {});
    return;
  }
  m_applying = true;
  m_document->setRuleBase(std::move(base), tr("Edit the rules as text"));
  m_applying = false;
}

/// After our own edit the text stays as it was typed; any other change is merged into it.
void RuleTextPage::followDocument()
{
  m_stale = false;
  const fuzzy::RuleBase& now = m_document->ruleBase();
  m_writing = true;
  m_highlighter->setVocabulary(now);
  if (!m_applying || rulesOf(m_lines, m_before) != now.rules)
    m_editor->setLines(mergedText(m_lines, m_before, now, m_document->ruleLanguage()));
  m_before = now.rules;
  m_writing = false;
  readText();
  if (m_mistakes > 0) return;
  if (rulesOf(m_lines, m_before) == m_before)
    m_editor->document()->setModified(false);
  else
    m_pause.start(); // something typed before is still to be applied
}

void RuleTextPage::changeEvent(QEvent* event)
{
  QWidget::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) {
    m_editor->setAccessibleName(tr("Rules as text, one per line"));
    m_editor->setPlaceholderText(tr("Write one rule per line. Ctrl+Space proposes words."));
    showMistake();
  } else if (event->type() == QEvent::PaletteChange) {
    m_writing = true;
    m_highlighter->setPalette(palette()); // the editor gets it only after us
    m_writing = false;
  }
}

void RuleTextPage::showEvent(QShowEvent* event)
{
  QWidget::showEvent(event);
  if (m_stale) followDocument();
}

} // namespace esm
