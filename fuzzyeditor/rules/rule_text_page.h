// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fuzzyeditor/rules/rule_lines.h"

#include <QTimer>
#include <QWidget>

namespace esm {

class FuzzyEvaluation;
class FuzzyDocument;
class MistakeBar;
class RuleHighlighter;
class RuleTextEditor;

/// The rules as text, one per line. The document stays as it was while any line is no rule; a whole valid
/// text goes to it as one undo step after a pause, on Ctrl+Return or when the editor is left. What was typed
/// is never thrown away: changes from elsewhere are merged into the text (see mergedText()).
class RuleTextPage : public QWidget {
  Q_OBJECT
public:
  explicit RuleTextPage(FuzzyDocument* document, QWidget* parent = nullptr);

  bool hasMistakes() const { return m_mistakes > 0; }
  void setApplyDelay(int milliseconds) { m_pause.setInterval(milliseconds); }
  void applyText(); ///< if every line is a rule

signals:
  void mistakesChanged();

protected:
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;

private:
  void readText();
  void replaceText();
  void followDocument();
  void showMarks();
  void showMistake();
  void cure();
  const RuleLine* shownMistake(int* lineNumber) const;

  FuzzyDocument* m_document;
  RuleTextEditor* m_editor;
  RuleHighlighter* m_highlighter;
  MistakeBar* m_bar;
  QTimer m_pause;
  RuleLineReader m_reader;
  std::vector<RuleLine> m_lines;
  std::vector<fuzzy::Rule> m_before; ///< the document's rules that the text was made from
  int m_mistakes = 0;
  bool m_stale = true;     ///< the document changed while the page was hidden
  bool m_applying = false; ///< the document changes by us
  bool m_writing = false;  ///< the text changes by us, not by the user
};

} // namespace esm
