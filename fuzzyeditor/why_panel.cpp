// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/why_panel.h"

#include "fuzzyeditor/fuzzy_evaluation.h"
#include "fuzzyeditor/rule_delegates.h"
#include "fuzzyeditor/rule_display.h"

#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace esm {
namespace {

enum Column { Number, Degree, Text };
constexpr int kRuleRole = Qt::UserRole + 1;
constexpr int kDegreeRole = Qt::UserRole + 2;

bool concerns(const fuzzy::Rule& rule, const std::string& output)
{
  return std::any_of(rule.consequents.begin(), rule.consequents.end(),
                     [&](const fuzzy::Proposition& consequent) { return consequent.variable == output; });
}

} // namespace

WhyPanel::WhyPanel(FuzzyEvaluation* evaluation, QWidget* parent)
  : QWidget(parent),
    m_evaluation(evaluation),
    m_place(new QLabel),
    m_sentences(new QLabel),
    m_rules(new QTreeWidget),
    m_silent(new QLabel)
{
  setObjectName("whyPanel");
  m_place->setObjectName("whyPlace");
  m_sentences->setObjectName("whySentences");
  m_rules->setObjectName("whyRules");
  QFont bold = font();
  bold.setBold(true);
  m_place->setFont(bold);
  for (QLabel* label : {m_place, m_sentences, m_silent}) {
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
  }
  m_sentences->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_rules->setColumnCount(3);
  m_rules->setRootIsDecorated(false);
  m_rules->setUniformRowHeights(true);
  m_rules->setAlternatingRowColors(true);
  m_rules->setItemDelegateForColumn(Degree, new DegreeDelegate(kDegreeRole, m_rules));
  m_rules->header()->setStretchLastSection(true);
  m_rules->header()->setSectionResizeMode(Number, QHeaderView::ResizeToContents);
  m_rules->header()->resizeSection(Degree, 92);

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 8, 8, 8);
  layout->setSpacing(6);
  layout->addWidget(m_place);
  layout->addWidget(m_sentences);
  layout->addWidget(m_rules, 1);
  layout->addWidget(m_silent);
  connect(evaluation, &FuzzyEvaluation::changed, this, &WhyPanel::refresh);
  connect(evaluation->document(), &FuzzyDocument::ruleLanguageChanged, this, &WhyPanel::refresh);
  connect(evaluation->document(), &FuzzyDocument::ruleBaseChanged, this, [this] { m_ofPlace.reset(); });
  connect(m_rules, &QTreeWidget::itemActivated, this,
          [this](QTreeWidgetItem* item) { emit ruleActivated(item->data(Number, kRuleRole).toInt()); });
}

void WhyPanel::showInference(const QString& place, fuzzy::Inference inference)
{
  m_placeName = place;
  m_ofPlace = std::move(inference);
  refresh();
}

void WhyPanel::showCurrentInputs()
{
  m_ofPlace.reset();
  refresh();
}

QString WhyPanel::sentence(const fuzzy::Inference& inference, int output) const
{
  const fuzzy::RuleBase& rules = m_evaluation->document()->ruleBase();
  const Language language = m_evaluation->document()->ruleLanguage();
  const fuzzy::Variable& variable = rules.outputs[static_cast<std::size_t>(output)];
  const fuzzy::OutputValue& value = inference.outputs[static_cast<std::size_t>(output)];
  const QString name = RuleDisplay::title(variable, language);
  const QString number = RuleDisplay::quantity(value.value, variable.unit, locale());

  const fuzzy::RuleFiring* main = nullptr;
  for (const fuzzy::RuleFiring& firing : inference.firings)
    if (concerns(rules.rules[static_cast<std::size_t>(firing.rule)], variable.id) &&
        (!main || firing.degree > main->degree))
      main = &firing;
  if (!value.fromRules || !main || main->degree <= 0)
    return tr("%1 is %2, the default, because no rule fired for it.").arg(name, number);
  const QString text =
    RuleDisplay::sentence(rules.rules[static_cast<std::size_t>(main->rule)], rules, language);
  return tr("%1 is %2, mainly because of rule %3: %4 (%5).")
    .arg(name, number)
    .arg(main->rule + 1)
    .arg(text, locale().toString(main->degree, 'f', 2));
}

void WhyPanel::fillRules(const fuzzy::Inference& inference)
{
  const fuzzy::RuleBase& rules = m_evaluation->document()->ruleBase();
  const Language language = m_evaluation->document()->ruleLanguage();
  std::vector<fuzzy::RuleFiring> fired;
  std::copy_if(inference.firings.begin(), inference.firings.end(), std::back_inserter(fired),
               [](const fuzzy::RuleFiring& firing) { return firing.degree > 0; });
  std::stable_sort(fired.begin(), fired.end(),
                   [](const auto& a, const auto& b) { return a.degree > b.degree; });
  // Items are reused: a slider drag comes here sixty times a second.
  while (m_rules->topLevelItemCount() > static_cast<int>(fired.size()))
    delete m_rules->takeTopLevelItem(m_rules->topLevelItemCount() - 1);
  while (m_rules->topLevelItemCount() < static_cast<int>(fired.size())) new QTreeWidgetItem(m_rules);
  for (int i = 0; i < static_cast<int>(fired.size()); ++i) {
    const fuzzy::RuleFiring& firing = fired[static_cast<std::size_t>(i)];
    const QString text =
      RuleDisplay::sentence(rules.rules[static_cast<std::size_t>(firing.rule)], rules, language);
    QTreeWidgetItem* item = m_rules->topLevelItem(i);
    item->setText(Number, QString::number(firing.rule + 1));
    item->setData(Number, kRuleRole, firing.rule);
    item->setText(Degree, locale().toString(firing.degree, 'f', 2));
    item->setData(Degree, kDegreeRole, firing.degree);
    item->setText(Text, text);
    item->setToolTip(Text, text);
  }
  const std::size_t silent = inference.firings.size() - fired.size();
  m_silent->setText(silent == 1 ? tr("One further rule did not fire.")
                                : tr("%1 further rules did not fire.").arg(silent));
  m_silent->setVisible(silent > 0);
}

void WhyPanel::refresh()
{
  if (!isVisible()) return;
  const fuzzy::Inference& inference = m_ofPlace ? *m_ofPlace : m_evaluation->inference();
  m_place->setText(m_ofPlace ? m_placeName
                             : tr("Tissue: %1").arg(m_evaluation->document()->inputTargetName()));
  QStringList sentences;
  for (int i = 0; i < static_cast<int>(inference.outputs.size()); ++i) sentences << sentence(inference, i);
  m_sentences->setText(sentences.join('\n'));
  m_rules->setHeaderLabels({tr("Rule"), tr("Fires"), tr("Text")});
  m_rules->setAccessibleName(tr("Rules that fired, the strongest first"));
  fillRules(inference);
}

void WhyPanel::changeEvent(QEvent* event)
{
  QWidget::changeEvent(event);
  // The program's numbers change with its language; widgets keep the locale that they were born with.
  if (event->type() == QEvent::LanguageChange) setLocale(QLocale());
  if (event->type() == QEvent::LanguageChange || event->type() == QEvent::LocaleChange) refresh();
}

void WhyPanel::showEvent(QShowEvent* event)
{
  QWidget::showEvent(event);
  refresh();
}

} // namespace esm
