// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/fuzzy/rule_base.h"
#include "fuzzyeditor/rules/rule_display.h"

#include <QPalette>
#include <QRegularExpression>
#include <QSyntaxHighlighter>

#include <optional>
#include <vector>

namespace esm {

/// Colours rule text: keywords, hedges, variables and terms of both languages; rules that are off are greyed,
/// an offending word gets a wave line.
class RuleHighlighter : public QSyntaxHighlighter {
  Q_OBJECT
public:
  struct LineMarks {
    bool off = false;
    std::optional<TextRange> mistake;
    bool operator==(const LineMarks&) const = default;
  };

  explicit RuleHighlighter(QTextDocument* document);

  void setVocabulary(const fuzzy::RuleBase& rules); ///< colours all lines anew
  void setPalette(const QPalette& palette);
  /// One per line; only lines whose marks changed are coloured anew.
  void setMarks(std::vector<LineMarks> marks);

protected:
  void highlightBlock(const QString& text) override;

private:
  QTextCharFormat format(int group) const;

  QRegularExpression m_words; ///< groups 1 keywords, 2 hedges, 3 variables, 4 terms
  QPalette m_palette;
  std::vector<LineMarks> m_marks;
};

} // namespace esm
