// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QStringList>

#include <vector>

class QStatusBar;

namespace esm {

/// A text of the status bar in several wordings, the whole one first. Where room is short a shorter one stands in
/// its place, and the whole one is in the tool tip: a wording is shown as a whole or not at all.
class StatusField : public QLabel {
  Q_OBJECT
public:
  explicit StatusField(const char* name, QWidget* parent = nullptr);

  /// @param wordings the whole one first; an empty one: may be left out. None: there is nothing to say.
  void say(const QStringList& wordings);
  void setMark(const QString& mark, const QColor& colour); ///< before every wording; with the next say()
  void explain(const QString& tip);                        ///< what the tool tip says besides

  bool hasSomethingToSay() const { return !m_wordings.isEmpty(); }
  const QString& whole() const { return m_whole; }
  int room(int wording) const; ///< that a wording takes [pixel]; of one too far: the last one's
  void choose(int wording);    ///< this one, or the last one there is

private:
  const QString& wording(int i) const;
  void refresh();
  QStringList m_wordings;
  QString m_whole, m_mark, m_colour, m_tip;
  int m_chosen = 0;
};

/// Cuts a text to fit by whole words: half a number would be another number.
QString elidedAtWord(const QString& text, const QFontMetrics& metrics, int room);

/// Shares the room of a status bar among its fields, the hint at its left and the message in the hint's place. They
/// give way one step after the other, the least important first; a step is only taken back with some room to
/// spare, so that changing digits make no field come and go. The bar's messages are drawn here, cut by words.
class StatusRoom : public QObject {
  Q_OBJECT
public:
  /// A field says this wording from here on.
  struct Step {
    StatusField* field;
    int wording;
  };
  /// @param hint a widget of the bar that takes what is left over.
  /// @param hintGives, messageGives so many steps are taken before the hint, or a message, is cut.
  StatusRoom(QStatusBar* bar, QLabel* hint, std::vector<StatusField*> fields, std::vector<Step> steps,
             std::size_t hintGives, std::size_t messageGives);

  void setHint(const QString& hint);
  void share();

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  int wordingOf(const StatusField* field, std::size_t taken) const;
  int roomOf(const StatusField* field, std::size_t taken) const;
  int needed(std::size_t taken) const;
  std::size_t stepsToTake() const;
  void paintMessage();

  QStatusBar* m_bar;
  QLabel* m_hint;
  QString m_wholeHint;
  std::vector<StatusField*> m_fields;
  std::vector<Step> m_steps;
  std::size_t m_hintGives, m_messageGives;
  std::size_t m_taken = 0;
};

} // namespace esm
