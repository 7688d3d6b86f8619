// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/terms/membership_panel.h"

#include "fuzzyeditor/fuzzy_evaluation.h"
#include "fuzzyeditor/rules/mistake_bar.h"
#include "fuzzyeditor/rules/rule_display.h"
#include "fuzzyeditor/terms/term_edits.h"
#include "fuzzyeditor/terms/term_fields.h"
#include "fuzzyeditor/terms/term_plot.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QInputDialog>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace esm {

namespace {

constexpr int kMostWords = 15; ///< that can be spread at once; more cannot be told apart

} // namespace

MembershipPanel::MembershipPanel(FuzzyEvaluation* evaluation, QWidget* parent)
  : QWidget(parent),
    m_evaluation(evaluation),
    m_edits(new TermEdits(evaluation->document(), this)),
    m_choice(new QComboBox),
    m_lock(new QCheckBox),
    m_spread(new QToolButton),
    m_plot(new TermPlot(evaluation, m_edits)),
    m_fields(new TermFields(m_edits)),
    m_message(new MistakeBar("terms"))
{
  setObjectName("membershipPanel");
  m_choice->setObjectName("mfVariable");
  m_choice->setMinimumContentsLength(10);
  m_choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  m_lock->setObjectName("mfLock");
  m_spread->setObjectName("mfSpread");
  auto* top = new QHBoxLayout;
  top->addWidget(m_choice, 1);
  top->addWidget(m_lock);
  top->addWidget(m_spread);
  m_body = new QBoxLayout(QBoxLayout::TopToBottom);
  m_body->addWidget(m_plot, 1);
  m_body->addWidget(m_fields);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 4, 4, 4);
  layout->setSpacing(4);
  layout->addLayout(top);
  layout->addWidget(m_message);
  layout->addLayout(m_body, 1);
  connect(m_choice, &QComboBox::currentIndexChanged, this, [this](int row) {
    const int inputs = static_cast<int>(m_evaluation->document()->ruleBase().inputs.size());
    const bool output = row >= inputs;
    m_edits->setVariable(output, output ? row - inputs : row);
    m_plot->setVariable(output, output ? row - inputs : row);
  });
  connect(m_lock, &QCheckBox::clicked, m_edits, &TermEdits::setKeepsPartition);
  connect(m_spread, &QToolButton::clicked, this, &MembershipPanel::askForSpread);
  connect(m_edits, &TermEdits::changed, this, &MembershipPanel::refresh);
  connect(m_edits, &TermEdits::refused, this,
          [this](const QString& sentence) { m_message->setMistake(sentence, QString()); });
  connect(evaluation->document(), &FuzzyDocument::ruleBaseChanged, this, &MembershipPanel::fillChoice);
  connect(evaluation->document(), &FuzzyDocument::ruleLanguageChanged, this, &MembershipPanel::fillChoice);
  m_message->setMistake(QString(), QString());
  retranslate();
}

void MembershipPanel::showInput(int input)
{
  showVariable(false, input);
}

void MembershipPanel::showVariable(bool isOutput, int variable)
{
  const int inputs = static_cast<int>(m_evaluation->document()->ruleBase().inputs.size());
  m_choice->setCurrentIndex(isOutput ? inputs + variable : variable);
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

void MembershipPanel::refresh()
{
  m_lock->setChecked(m_edits->keepsPartition());
  m_lock->setEnabled(m_edits->keepsPartition() || m_edits->canKeepPartition());
  m_spread->setEnabled(m_edits->variable() != nullptr);
}

void MembershipPanel::askForSpread()
{
  const fuzzy::Variable* v = m_edits->variable();
  if (!v) return;
  QInputDialog dialog(this);
  dialog.setObjectName("dlgSpread");
  dialog.setWindowTitle(tr("Spread words evenly"));
  dialog.setLabelText(tr("How many words shall lie evenly over the range of %1?")
                        .arg(RuleDisplay::name(*v, m_evaluation->document()->ruleLanguage())));
  dialog.setInputMode(QInputDialog::IntInput);
  dialog.setIntRange(1, kMostWords);
  dialog.setIntValue(std::clamp(static_cast<int>(v->terms.size()), 2, kMostWords));
  if (auto* number = dialog.findChild<QSpinBox*>()) {
    number->setObjectName("spreadCount");
    number->setAccessibleName(tr("Number of words"));
  }
  if (dialog.exec() == QDialog::Accepted) m_edits->spreadEvenly(dialog.intValue());
}

void MembershipPanel::retranslate()
{
  m_choice->setAccessibleName(tr("Variable that the plot shows"));
  m_lock->setText(tr("Sum 1"));
  m_lock->setAccessibleName(tr("Memberships go on to sum to 1"));
  m_lock->setToolTip(
    tr("Neighbouring words follow a dragged point, so that the memberships of every value go on to "
       "sum to 1. Not possible with a bell or where peaks coincide."));
  m_spread->setText(tr("Spread…"));
  m_spread->setAccessibleName(tr("Spread words evenly"));
  m_spread->setToolTip(tr("Several words at once, evenly over the range"));
  fillChoice();
  refresh();
}

void MembershipPanel::resizeEvent(QResizeEvent* event)
{
  QWidget::resizeEvent(event);
  const bool wide = width() > 560 && width() > 1.6 * height();
  m_body->setDirection(wide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
}

void MembershipPanel::changeEvent(QEvent* event)
{
  QWidget::changeEvent(event);
  // The program's numbers change with its language; widgets keep the locale that they were born with.
  if (event->type() == QEvent::LanguageChange) setLocale(QLocale());
  if (event->type() == QEvent::LanguageChange) retranslate();
}

} // namespace esm
