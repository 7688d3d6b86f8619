// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QLabel;
class QPushButton;

namespace esm {

/// One line that says what is wrong with a text and offers to mend it; hidden while all is well.
class MistakeBar : public QWidget {
  Q_OBJECT
public:
  /// @param name prefix of the object names: <name>Message, <name>Cure, <name>Discard.
  MistakeBar(const QString& name, QWidget* parent = nullptr);

  /// An empty sentence hides the bar, an empty suggestion the button.
  void setMistake(const QString& sentence, const QString& suggestion);
  void setDiscardVisible(bool visible);

signals:
  void cureRequested();
  void discardRequested();

protected:
  void changeEvent(QEvent* event) override;

private:
  void showTexts();

  QLabel* m_message;
  QPushButton* m_cure;
  QPushButton* m_discard;
  QString m_sentence, m_suggestion;
};

} // namespace esm
