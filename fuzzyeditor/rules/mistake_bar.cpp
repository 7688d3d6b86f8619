// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/rules/mistake_bar.h"

#include "fuzzyeditor/panel_colors.h"

#include <QAccessible>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

namespace esm {

MistakeBar::MistakeBar(const QString& name, QWidget* parent)
  : QWidget(parent), m_message(new QLabel), m_cure(new QPushButton), m_discard(new QPushButton)
{
  m_message->setObjectName(name + "Message");
  m_cure->setObjectName(name + "Cure");
  m_discard->setObjectName(name + "Discard");
  m_message->setWordWrap(true);
  m_message->setTextFormat(Qt::PlainText);
  m_discard->hide();
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(4, 2, 4, 2);
  layout->addWidget(m_message, 1);
  layout->addWidget(m_cure);
  layout->addWidget(m_discard);
  connect(m_cure, &QPushButton::clicked, this, &MistakeBar::cureRequested);
  connect(m_discard, &QPushButton::clicked, this, &MistakeBar::discardRequested);
  showTexts();
}

void MistakeBar::setMistake(const QString& sentence, const QString& suggestion)
{
  const bool news = sentence != m_sentence;
  m_sentence = sentence;
  m_suggestion = suggestion;
  showTexts();
  if (!news || sentence.isEmpty() || !isVisible()) return;
  QAccessibleEvent alert(m_message, QAccessible::Alert); // screen readers say it
  QAccessible::updateAccessibility(&alert);
}

void MistakeBar::setDiscardVisible(bool visible)
{
  m_discard->setVisible(visible);
}

void MistakeBar::showTexts()
{
  m_message->setText(m_sentence);
  m_message->setAccessibleName(m_sentence);
  QPalette colours = palette();
  colours.setColor(QPalette::WindowText, panel_colors::mistake(palette()));
  m_message->setPalette(colours);
  m_cure->setText(tr("&Replace by ‘%1’").arg(m_suggestion));
  m_cure->setAccessibleName(tr("Replace the marked word by ‘%1’").arg(m_suggestion));
  m_cure->setVisible(!m_suggestion.isEmpty());
  m_discard->setText(tr("&Discard"));
  m_discard->setAccessibleName(tr("Discard the text that is no rule"));
  setVisible(!m_sentence.isEmpty());
}

void MistakeBar::changeEvent(QEvent* event)
{
  QWidget::changeEvent(event);
  if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange) showTexts();
}

} // namespace esm
