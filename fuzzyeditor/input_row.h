// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/fuzzy/rule_text.h"
#include "fuzzyeditor/fuzzy_document.h"
#include "fuzzyeditor/gesture.h"

#include <QWidget>

class QComboBox;
class QLabel;
class QSlider;
class QToolButton;

namespace esm {

class NumberSpinBox;

/// One input: its name, a slider and a number for crisp values, a field for words ("sehr hart"), and back to
/// the default. Every edit goes to the document and comes back by show(); a drag is one gesture, so is a
/// quick run of arrow keys or wheel steps.
class InputRow : public QWidget {
  Q_OBJECT
public:
  InputRow(FuzzyDocument* document, int input, QWidget* parent = nullptr);

  void showValue();   ///< of the document
  void retranslate(); ///< language of the rules or of the window, locale

signals:
  void focused(int input); ///< one of its fields has got the focus

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  const fuzzy::Variable& variable() const;
  fuzzy::InputValue value() const;
  double toSlider(double value) const; ///< 0..1; logarithmic where the variable is
  double fromSlider(double position) const;
  double crispOf(const fuzzy::InputValue& value) const;
  void layOut();
  void connectFields();
  void setCrisp(double value, int gestureNumber);
  void takeWord(const QString& text);
  void showMistake(const QString& sentence);
  void fillWords();
  QString valueInWords(const fuzzy::InputValue& value) const;

  FuzzyDocument* m_document;
  int m_input;
  QLabel* m_name;
  QSlider* m_slider;
  NumberSpinBox* m_spin;
  QComboBox* m_word;
  QToolButton* m_reset;
  QLabel* m_mistake;
  int m_drag = 0; ///< gesture of the present drag of the slider
  KeyRun m_keys;
  bool m_stepping = false;
  bool m_showing = false; ///< the fields change by us
  bool m_wordTyped = false;
};

} // namespace esm
