// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/fuzzy/inference.h"
#include "core/fuzzy/rule_base.h"
#include "core/fuzzy/rule_draft.h"

#include <QObject>
#include <QString>

#include <utility>
#include <vector>

namespace esm {

/// What the fuzzy panels see of the document. The application implements it: every set...() pushes an undo
/// command and the signals follow when it is executed, undone or redone. GUI thread.
/// The inputs belong to a target, the base tissue or one region; which one is the application's affair.
class FuzzyDocument : public QObject {
  Q_OBJECT
public:
  using QObject::QObject;
  virtual const fuzzy::RuleBase& ruleBase() const = 0;
  virtual const std::vector<fuzzy::InputValue>& inputs() const = 0; ///< of the current target
  virtual QString inputTargetName() const = 0;                      ///< "Base tissue", or the region's name
  virtual Language ruleLanguage() const = 0;                        ///< follows the window's language
  /// As it was when the document was opened or last saved.
  virtual const fuzzy::RuleBase& savedRuleBase() const = 0;

  /// @param undoText translated, for the undo menu. The rule base must pass checkRuleBase().
  /// @param gesture rule bases with the same gesture > 0 are one undo step (one drag of a term); a gesture
  ///        that ends where it began is none.
  virtual void setRuleBase(fuzzy::RuleBase ruleBase, const QString& undoText, int gesture = 0) = 0;
  /// @param gesture values with the same gesture > 0 and input are one undo step (one slider drag).
  virtual void setInput(int input, fuzzy::InputValue value, int gesture) = 0;
  /// All inputs of the target at once, as one undo step: a preset, a place that a list points at.
  /// @param values one per input of the rule base.
  /// @param gesture values with the same gesture > 0 are one undo step (one drag over a surface).
  virtual void setInputs(std::vector<fuzzy::InputValue> values, const QString& undoText, int gesture = 0) = 0;

  /// What is typed into the rules and no rule yet: not saved, and not to be lost unasked.
  const RuleDraft& ruleDraft() const noexcept { return m_draft; }
  void setDraftText(std::string text)
  {
    if (std::exchange(m_draft.text, std::move(text)) != m_draft.text) emit ruleDraftChanged();
  }
  void setDraftCell(int row, int column, std::string cell)
  {
    const RuleDraft before = m_draft;
    m_draft.row = row, m_draft.column = column, m_draft.cell = std::move(cell);
    if (m_draft != before) emit ruleDraftChanged();
  }

signals:
  void ruleBaseChanged();
  void ruleBaseSaved(); ///< savedRuleBase() is another one now; follows an opening's ruleBaseChanged() too
  void inputsChanged(); ///< values or target
  void ruleLanguageChanged();
  void ruleDraftChanged();
  void ruleDraftReplaced(); ///< by the document: what editors hold gives way to ruleDraft()
  void ruleTextWanted();    ///< what is typed and right is to be applied now, not after a pause

protected:
  void replaceDraft(RuleDraft draft)
  {
    m_draft = std::move(draft);
    emit ruleDraftReplaced();
    emit ruleDraftChanged();
  }

private:
  RuleDraft m_draft;
};

} // namespace esm
