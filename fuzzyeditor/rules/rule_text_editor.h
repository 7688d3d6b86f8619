// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPlainTextEdit>

class QCompleter;
class QStringListModel;

namespace esm {

class FuzzyDocument;

/// The plain text of the rules with completion of names. Ctrl+Return and leaving the editor ask to apply.
/// While nothing is typed and not applied, undo and redo are the window's (of the document, not of the text).
class RuleTextEditor : public QPlainTextEdit {
  Q_OBJECT
public:
  explicit RuleTextEditor(FuzzyDocument* document, QWidget* parent = nullptr);

  /// Replaces the differing lines only, so that cursor and scrolling stay; forgets the text's own undo steps.
  void setLines(const QStringList& lines);
  QStringList lines() const;
  QCompleter* completer() const { return m_completer; }

signals:
  void applyRequested();

protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

private:
  void propose(bool evenWithoutPrefix);
  void insertProposal(const QString& proposal);

  FuzzyDocument* m_document;
  QCompleter* m_completer;
  QStringListModel* m_proposals;
};

} // namespace esm
