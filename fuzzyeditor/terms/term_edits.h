// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/fuzzy/term_editing.h"
#include "fuzzyeditor/fuzzy_document.h"
#include "fuzzyeditor/gesture.h"

#include <QObject>

namespace esm {

/// What plot and fields of the terms have in common: the variable that is shown, the term that is chosen, and
/// the edits, each of which goes to the document and comes back as changed(). A drag is one undo step, so is
/// a run of key presses on one handle; both start from the terms as they were at their beginning, so that the
/// way back is the way there. GUI thread.
class TermEdits : public QObject {
  Q_OBJECT
public:
  /// @param document not owned, outlives this.
  explicit TermEdits(FuzzyDocument* document, QObject* parent = nullptr);

  FuzzyDocument* document() const { return m_document; }
  void setVariable(bool output, int index);
  bool isOutput() const { return m_output; }
  const fuzzy::Variable* variable() const;      ///< null if there is none
  const fuzzy::Variable* savedVariable() const; ///< as last saved or opened; null if it is new
  int term() const { return m_term; }           ///< the chosen one, -1 if there is none
  const fuzzy::Term* chosenTerm() const;
  void chooseTerm(int term);

  /// Whether neighbours' feet follow, so that memberships go on to sum to 1. At first where they do.
  bool keepsPartition() const;
  bool canKeepPartition() const; ///< they sum to 1, or moving feet makes them
  void setKeepsPartition(bool keep);

  // === Handles; places are on the variable's axis
  fuzzy::Limits limits(int term, fuzzy::Handle handle) const;
  void beginDrag();
  void drag(int term, fuzzy::Handle handle, double place);
  void endDrag() { m_dragging = false; }
  void cancelDrag(); ///< everything as at its beginning, and no undo step
  bool isDragging() const { return m_dragging; }
  void step(int term, fuzzy::Handle handle, double place); ///< by key: steps soon after each other are one
  void place(int term, fuzzy::Handle handle, double place);

  // === Terms
  void rename(int term, const fuzzy::Names& names);
  void setForm(int term, fuzzy::Form form);
  void addTerm();
  void removeTerm(int term);    ///< refused while rules speak of it
  void spreadEvenly(int count); ///< keeps words as far as there are any; refused if a rule needs one too many

signals:
  void changed();                        ///< variable, terms, saved terms, choice or partition
  void refused(const QString& sentence); ///< why an edit was not done; empty: nothing is wrong any more

private:
  void move(const fuzzy::Variable& from, int term, fuzzy::Handle handle, double place, int gesture);
  bool put(std::vector<fuzzy::Term> terms, const QString& undoText, int gesture = 0);
  QString nameOf(int term) const;
  QString rulesOf(const std::vector<int>& rules) const;
  fuzzy::Term newWord(const std::vector<fuzzy::Term>& beside) const;
  void refresh();

  FuzzyDocument* m_document;
  bool m_output = false;
  int m_index = 0, m_term = 0;
  QStringList m_free; ///< ids of variables whose partition need not be kept
  bool m_dragging = false;
  int m_gesture = 0;       ///< of the drag
  fuzzy::Variable m_start; ///< at the beginning of the drag or run of keys
  KeyRun m_keys;
  int m_steppedTerm = -1;
  fuzzy::Handle m_steppedHandle = fuzzy::Handle::Curve;
};

} // namespace esm
