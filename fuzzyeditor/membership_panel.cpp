// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/membership_panel.h"

#include "fuzzyeditor/fuzzy_evaluation.h"
#include "fuzzyeditor/membership_plot.h"
#include "fuzzyeditor/rule_display.h"

#include <QComboBox>
#include <QEvent>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>

namespace esm {

MembershipPanel::MembershipPanel(FuzzyEvaluation* evaluation, QWidget* parent)
  : QWidget(parent), m_evaluation(evaluation), m_choice(new QComboBox), m_plot(new MembershipPlot(evaluation))
{
  setObjectName("membershipPanel");
  m_choice->setObjectName("mfVariable");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 4, 4, 4);
  layout->addWidget(m_choice);
  layout->addWidget(m_plot, 1);
  connect(m_choice, &QComboBox::currentIndexChanged, this, [this](int row) {
    const int inputs = static_cast<int>(m_evaluation->document()->ruleBase().inputs.size());
    m_plot->setVariable(row >= inputs, row >= inputs ? row - inputs : row);
  });
  connect(evaluation->document(), &FuzzyDocument::ruleBaseChanged, this, &MembershipPanel::fillChoice);
  connect(evaluation->document(), &FuzzyDocument::ruleLanguageChanged, this, &MembershipPanel::fillChoice);
  fillChoice();
}

void MembershipPanel::showInput(int input)
{
  m_choice->setCurrentIndex(input);
}

/// Renews the names only if one changed, since every edit of a rule comes here too.
void MembershipPanel::fillChoice()
{
  const fuzzy::RuleBase& rules = m_evaluation->document()->ruleBase();
  const Language language = m_evaluation->document()->ruleLanguage();
  QStringList names, old;
  for (const fuzzy::Variable& variable : rules.inputs)
    names << tr("Input: %1").arg(RuleDisplay::title(variable, language));
  for (const fuzzy::Variable& variable : rules.outputs)
    names << tr("Result: %1").arg(RuleDisplay::title(variable, language));
  for (int i = 0; i < m_choice->count(); ++i) old << m_choice->itemText(i);
  m_choice->setAccessibleName(tr("Variable that the plot shows"));
  if (names == old) return;
  const int row = std::max(m_choice->currentIndex(), 0);
  {
    const QSignalBlocker quiet(m_choice);
    m_choice->clear();
    m_choice->addItems(names);
    m_choice->setCurrentIndex(-1);
  }
  m_choice->setCurrentIndex(std::min(row, m_choice->count() - 1));
}

void MembershipPanel::changeEvent(QEvent* event)
{
  QWidget::changeEvent(event);
  // The program's numbers change with its language; widgets keep the locale that they were born with.
  if (event->type() == QEvent::LanguageChange) setLocale(QLocale());
  if (event->type() == QEvent::LanguageChange) fillChoice();
}

} // namespace esm
