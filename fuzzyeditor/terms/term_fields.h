// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/fuzzy/term_editing.h"

#include <QWidget>

#include <array>

class QComboBox;
class QLabel;
class QLineEdit;
class QToolButton;

namespace esm {

class NumberSpinBox;
class TermEdits;

/// The chosen term in fields: which one, its form, add and remove, its name in both languages, and its places
/// as numbers with the unit. GUI thread.
class TermFields : public QWidget {
  Q_OBJECT
public:
  /// @param edits not owned, outlives this.
  explicit TermFields(TermEdits* edits, QWidget* parent = nullptr);

protected:
  void changeEvent(QEvent* event) override;

private:
  /// A number with its name; of a Gaussian, RightFlank stands for the deviation.
  struct Field {
    QLabel* label = nullptr;
    NumberSpinBox* box = nullptr;
    fuzzy::Handle handle = fuzzy::Handle::Peak;
    bool stepped = false; ///< the next value comes from an arrow
  };

  void refresh();
  void retranslate();
  void showTerms();
  void showNames();
  void showPlaces();
  bool isDeviation(const Field& field) const;
  double shownValue(const Field& field) const;
  void takeValue(const Field& field, double shown, bool stepped);
  void takeNames();

  TermEdits* m_edits;
  QComboBox *m_term, *m_form;
  QToolButton *m_add, *m_remove;
  QLineEdit *m_english, *m_german;
  QLabel *m_englishLabel, *m_germanLabel;
  std::array<Field, 4> m_fields;
};

} // namespace esm
