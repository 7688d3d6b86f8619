// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/rules/rule_text_editor.h"

#include "fuzzyeditor/fuzzy_document.h"
#include "fuzzyeditor/rules/rule_completion.h"

#include <QAbstractItemView>
#include <QCompleter>
#include <QKeyEvent>
#include <QScrollBar>
#include <QStringListModel>
#include <QTextBlock>

namespace esm {

RuleTextEditor::RuleTextEditor(FuzzyDocument* document, QWidget* parent)
  : QPlainTextEdit(parent),
    m_document(document),
    m_completer(new QCompleter(this)),
    m_proposals(new QStringListModel(this))
{
  setLineWrapMode(QPlainTextEdit::NoWrap);
  setTabChangesFocus(true); // Tab must leave
  m_completer->setModel(m_proposals);
  m_completer->setWidget(this);
  m_completer->setCaseSensitivity(Qt::CaseInsensitive);
  m_completer->setCompletionMode(QCompleter::PopupCompletion);
  connect(m_completer, qOverload<const QString&>(&QCompleter::activated), this,
          &RuleTextEditor::insertProposal);
}

QStringList RuleTextEditor::lines() const
{
  return toPlainText().split('\n');
}

void RuleTextEditor::setLines(const QStringList& lines)
{
  const QStringList old = this->lines();
  const qsizetype shorter = qMin(old.size(), lines.size());
  qsizetype head = 0, tail = 0;
  while (head < shorter && old[head] == lines[head]) ++head;
  while (tail < shorter - head && old[old.size() - 1 - tail] == lines[lines.size() - 1 - tail]) ++tail;
  if (head + tail < old.size() || head + tail < lines.size()) {
    // The differing part with the line break at its end, or at its start where it reaches the last line.
    QTextCursor cursor(document());
    QString replacement = lines.mid(head, lines.size() - head - tail).join('\n');
    const bool removes = head + tail < old.size(), inserts = head + tail < lines.size();
    const int last = static_cast<int>(old.size() - tail);
    if (tail > 0) {
      cursor.setPosition(document()->findBlockByNumber(static_cast<int>(head)).position());
      cursor.setPosition(document()->findBlockByNumber(last).position(), QTextCursor::KeepAnchor);
      if (inserts) replacement += '\n';
    } else {
      const QTextBlock before = document()->findBlockByNumber(static_cast<int>(head) - 1);
      cursor.setPosition(before.isValid() ? before.position() + before.length() - 1 : 0);
      cursor.movePosition(QTextCursor::End, QTextCursor::KeepAnchor);
      if (inserts && before.isValid()) replacement.prepend('\n');
    }
    if (removes || inserts) cursor.insertText(replacement);
  }
  document()->clearUndoRedoStacks();
  document()->setModified(false);
}

namespace {

/// As users of other systems know it; Qt has but Ctrl+Shift+Z on this one.
bool isOtherRedo(const QKeyEvent& key)
{
  return key.key() == Qt::Key_Y && key.modifiers() == Qt::ControlModifier;
}

} // namespace

bool RuleTextEditor::event(QEvent* event)
{
  if (event->type() == QEvent::ShortcutOverride) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (!document()->isModified() &&
        (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo) || isOtherRedo(*key))) {
      event->ignore(); // for the window's undo action
      return false;
    }
    if (isOtherRedo(*key)) {
      event->accept();
      return true;
    }
  }
  return QPlainTextEdit::event(event);
}

void RuleTextEditor::keyPressEvent(QKeyEvent* event)
{
  const bool popup = m_completer->popup()->isVisible();
  if (popup && (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter ||
                event->key() == Qt::Key_Tab || event->key() == Qt::Key_Escape)) {
    event->ignore(); // the completer takes them
    return;
  }
  if ((event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) &&
      event->modifiers().testFlag(Qt::ControlModifier)) {
    emit applyRequested();
    return;
  }
  if (event->key() == Qt::Key_Space && event->modifiers().testFlag(Qt::ControlModifier)) {
    propose(true);
    return;
  }
  if (isOtherRedo(*event)) return redo();
  QPlainTextEdit::keyPressEvent(event);
  const QString typed = event->text();
  if (typed.isEmpty() || !typed.back().isPrint()) {
    if (popup) m_completer->popup()->hide();
    return;
  }
  propose(false);
}

void RuleTextEditor::propose(bool evenWithoutPrefix)
{
  const QString before = textCursor().block().text().left(textCursor().positionInBlock());
  const RuleCompletion completion = completeRule(before, m_document->ruleBase(), m_document->ruleLanguage());
  m_proposals->setStringList(completion.proposals);
  m_completer->setCompletionPrefix(completion.prefix);
  const bool whole = m_completer->completionCount() == 1 &&
                     m_completer->currentCompletion().compare(completion.prefix, Qt::CaseInsensitive) == 0;
  if (m_completer->completionCount() == 0 || whole || (completion.prefix.isEmpty() && !evenWithoutPrefix)) {
    m_completer->popup()->hide();
    return;
  }
  QRect place = cursorRect();
  place.setWidth(m_completer->popup()->sizeHintForColumn(0) +
                 m_completer->popup()->verticalScrollBar()->sizeHint().width());
  m_completer->complete(place);
}

void RuleTextEditor::insertProposal(const QString& proposal)
{
  QTextCursor cursor = textCursor();
  cursor.movePosition(QTextCursor::Left, QTextCursor::KeepAnchor,
                      static_cast<int>(m_completer->completionPrefix().size()));
  cursor.insertText(proposal + ' ');
  setTextCursor(cursor);
}

void RuleTextEditor::focusOutEvent(QFocusEvent* event)
{
  QPlainTextEdit::focusOutEvent(event);
  if (event->reason() != Qt::PopupFocusReason) emit applyRequested();
}

} // namespace esm
