// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/status_field.h"

#include <QEvent>
#include <QPainter>
#include <QStatusBar>
#include <QStyle>
#include <QStyleOption>

#include <algorithm>

namespace esm {

namespace {

constexpr int kGap = 8;          ///< about what the bar leaves around a field [pixel]
constexpr int kReturnAfter = 40; ///< so much more room before a step is taken back [pixel]
constexpr int kLeastHint = 60;   ///< a hint that is cut further says nothing [pixel]

} // namespace

StatusField::StatusField(const char* name, QWidget* parent) : QLabel(parent)
{
  setObjectName(QLatin1String(name));
  setContentsMargins(6, 0, 6, 0);
  setTextFormat(Qt::PlainText);
}

void StatusField::say(const QStringList& wordings)
{
  m_wordings = wordings;
  m_whole = wordings.value(0);
  refresh();
}

void StatusField::setMark(const QString& mark, const QColor& colour)
{
  m_mark = mark;
  m_colour = colour.name();
  setTextFormat(Qt::RichText);
}

void StatusField::explain(const QString& tip)
{
  m_tip = tip;
  refresh();
}

const QString& StatusField::wording(int i) const
{
  static const QString kNone;
  return m_wordings.isEmpty() ? kNone : m_wordings[std::clamp(i, 0, static_cast<int>(m_wordings.size()) - 1)];
}

int StatusField::room(int i) const
{
  const QString& words = wording(i);
  if (words.isEmpty()) return 0;
  const QMargins margins = contentsMargins();
  const int mark = m_mark.isEmpty() ? 0 : fontMetrics().horizontalAdvance(m_mark + QLatin1Char(' ')) + 2;
  return mark + fontMetrics().horizontalAdvance(words) + margins.left() + margins.right();
}

void StatusField::choose(int wording)
{
  if (wording == m_chosen) return;
  m_chosen = wording;
  refresh();
}

void StatusField::refresh()
{
  const QString& words = wording(m_chosen);
  setText(
    m_mark.isEmpty() || words.isEmpty()
      ? words
      : QStringLiteral("<span style='color:%1'>%2</span> %3").arg(m_colour, m_mark, words.toHtmlEscaped()));
  setAccessibleName(m_whole);
  setToolTip(words == m_whole || m_tip.startsWith(m_whole) ? m_tip : m_whole + QLatin1Char('\n') + m_tip);
  if (parentWidget() != nullptr && isHidden() != words.isEmpty()) setVisible(!words.isEmpty());
}

QString elidedAtWord(const QString& text, const QFontMetrics& metrics, int room)
{
  if (metrics.horizontalAdvance(text) <= room) return text;
  const QString dots(QChar(0x2026));
  qsizetype end = text.size();
  while ((end = text.lastIndexOf(QLatin1Char(' '), end - 1)) > 0)
    if (QString cut = text.left(end).trimmed() + QLatin1Char(' ') + dots;
        metrics.horizontalAdvance(cut) <= room)
      return cut;
  return metrics.horizontalAdvance(dots) <= room ? dots : QString();
}

StatusRoom::StatusRoom(QStatusBar* bar, QLabel* hint, std::vector<StatusField*> fields,
                       std::vector<Step> steps, std::size_t hintGives, std::size_t messageGives)
  : QObject(bar),
    m_bar(bar),
    m_hint(hint),
    m_fields(std::move(fields)),
    m_steps(std::move(steps)),
    m_hintGives(hintGives),
    m_messageGives(messageGives)
{
  bar->setMinimumWidth(1); // or what it says now would keep the window from being made smaller
  hint->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  bar->installEventFilter(this);
  connect(bar, &QStatusBar::messageChanged, this, [this](const QString& message) {
    m_bar->setToolTip(message); // the whole one
    share();
  });
}

void StatusRoom::setHint(const QString& hint)
{
  m_wholeHint = hint;
  m_hint->setToolTip(hint);
  m_hint->setAccessibleName(hint);
  share();
}

int StatusRoom::wordingOf(const StatusField* field, std::size_t taken) const
{
  int wording = 0;
  for (std::size_t i = 0; i < taken; ++i)
    if (m_steps[i].field == field) wording = m_steps[i].wording;
  return wording;
}

int StatusRoom::roomOf(const StatusField* field, std::size_t taken) const
{
  const int room = field->room(wordingOf(field, taken));
  return room > 0 ? room + kGap : 0;
}

int StatusRoom::needed(std::size_t taken) const
{
  const QString message = m_bar->currentMessage();
  const bool isCut = taken > (message.isEmpty() ? m_hintGives : m_messageGives);
  const int whole = m_bar->fontMetrics().horizontalAdvance(message.isEmpty() ? m_wholeHint : message);
  int sum = 2 * kGap + (isCut ? std::min(whole, kLeastHint) : whole);
  for (const StatusField* field : m_fields) sum += roomOf(field, taken);
  return sum;
}

std::size_t StatusRoom::stepsToTake() const
{
  const auto least = [this](int room) {
    std::size_t taken = 0;
    while (taken < m_steps.size() && needed(taken) > room) ++taken;
    return taken;
  };
  const std::size_t steps = least(m_bar->width());
  return steps >= m_taken ? steps : std::min(m_taken, least(m_bar->width() - kReturnAfter));
}

void StatusRoom::share()
{
  m_taken = stepsToTake();
  for (StatusField* field : m_fields) field->choose(wordingOf(field, m_taken));
  int left = m_bar->width() - 2 * kGap;
  for (const StatusField* field : m_fields) left -= roomOf(field, m_taken);
  m_hint->setText(elidedAtWord(m_wholeHint, m_hint->fontMetrics(), left));
  m_bar->update();
}

bool StatusRoom::eventFilter(QObject*, QEvent* event)
{
  if (event->type() == QEvent::Resize || event->type() == QEvent::FontChange || event->type() == QEvent::Show)
    share();
  if (event->type() != QEvent::Paint || m_bar->currentMessage().isEmpty()) return false;
  paintMessage();
  return true;
}

/// As the bar itself would, but for the cut.
void StatusRoom::paintMessage()
{
  QPainter painter(m_bar);
  QStyleOption option;
  option.initFrom(m_bar);
  m_bar->style()->drawPrimitive(QStyle::PE_PanelStatusBar, &option, &painter, m_bar);
  int end = m_bar->width();
  for (const StatusField* field : m_fields)
    if (field->isVisible()) end = std::min(end, field->x());
  const QRect place(6, 0, end - 2 * kGap, m_bar->height());
  painter.setPen(m_bar->palette().windowText().color());
  painter.drawText(place, Qt::AlignLeading | Qt::AlignVCenter | Qt::TextSingleLine,
                   elidedAtWord(m_bar->currentMessage(), m_bar->fontMetrics(), place.width()));
}

} // namespace esm
