// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/rules/problems_view.h"

#include "fuzzyeditor/badge_label.h"
#include "fuzzyeditor/rules/rule_display.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QListView>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace esm {

using fis::FindingKind;

ProblemsModel::ProblemsModel(FuzzyDocument* document, ProblemFinder* finder, QObject* parent)
  : QAbstractListModel(parent), m_document(document), m_finder(finder)
{
  connect(finder, &ProblemFinder::found, this, &ProblemsModel::follow);
}

void ProblemsModel::follow()
{
  std::vector<fuzzy::RuleFinding> findings = m_finder->findings();
  if (findings.size() > kMostShown) findings.resize(kMostShown);
  QStringList sentences;
  for (const fuzzy::RuleFinding& finding : findings) sentences << sentence(finding);
  if (sentences == m_sentences && findings == m_findings) return; // keeps the current row
  beginResetModel();
  m_findings = std::move(findings);
  m_sentences = std::move(sentences);
  endResetModel();
}

int ProblemsModel::rowCount(const QModelIndex& parent) const
{
  return parent.isValid() ? 0 : static_cast<int>(m_findings.size());
}

QVariant ProblemsModel::data(const QModelIndex& index, int role) const
{
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
  if (role == Qt::DisplayRole || role == Qt::AccessibleTextRole) return m_sentences[index.row()];
  if (role == Qt::ToolTipRole) return m_sentences[index.row()] + '\n' + activationText(finding(index.row()));
  return {};
}

/// "hardness is about 0.42 and wall is about 0.10"
QString ProblemsModel::placeText(const fuzzy::RuleFinding& finding) const
{
  QStringList parts;
  for (const auto& [input, value] : finding.place) {
    const fuzzy::Variable& variable = m_document->ruleBase().inputs[static_cast<std::size_t>(input)];
    parts << tr("%1 is about %2")
               .arg(RuleDisplay::name(variable, m_document->ruleLanguage()),
                    RuleDisplay::quantity(value, variable.unit, m_locale));
  }
  return parts.join(tr(" and "));
}

QString ProblemsModel::sentence(const fuzzy::RuleFinding& f) const
{
  const fuzzy::RuleBase& rules = m_document->ruleBase();
  const Language language = m_document->ruleLanguage();
  const fuzzy::Variable* variable = nullptr;
  if (f.variable >= 0)
    variable = &(f.onOutput ? rules.outputs : rules.inputs)[static_cast<std::size_t>(f.variable)];
  const QString name = variable ? RuleDisplay::name(*variable, language) : QString();
  const auto word = [&](int term) {
    return variable ? toQt(variable->terms[static_cast<std::size_t>(term)].name.in(language)) : QString();
  };
  switch (f.kind) {
  case FindingKind::Uncovered:
    return f.place.empty() ? tr("Gap: No rule for %1 ever fires.").arg(name)
                           : tr("Gap: No rule speaks of %1 where %2.").arg(name, placeText(f));
  case FindingKind::Gap:
    return tr("Gap: No word of %1 fits where %2.").arg(name, placeText(f));
  case FindingKind::Contradiction:
    return tr("Contradiction: Rules %1 and %2 conclude differently on the same condition.")
      .arg(f.rule + 1)
      .arg(f.otherRule + 1);
  case FindingKind::Duplicate:
    return tr("Duplicate: Rules %1 and %2 say the same.").arg(f.rule + 1).arg(f.otherRule + 1);
  case FindingKind::Shadowed:
    return tr("Hidden: Rule %1 never counts, because rule %2 concludes the same on a weaker condition.")
      .arg(f.rule + 1)
      .arg(f.otherRule + 1);
  case FindingKind::NeverFires:
    return tr("Idle: The condition of rule %1 holds nowhere.").arg(f.rule + 1);
  case FindingKind::Overlap:
    return tr("Overlap: The words ‘%1’ and ‘%2’ of %3 share %4 % of their area, so that they hardly differ.")
      .arg(word(f.term), word(f.otherTerm), name)
      .arg(std::lround(100.0 * f.overlap));
  case FindingKind::OutputNeverSet:
    return tr("Unset: No rule concludes on %1.").arg(name);
  }
  return {};
}

QString ProblemsModel::activationText(const fuzzy::RuleFinding& finding) const
{
  if (!finding.place.empty()) return tr("Double click or Return sets the inputs to this place.");
  if (finding.rule >= 0) return tr("Double click or Return shows the rule.");
  return tr("Double click or Return shows the words.");
}

void ProblemsModel::retranslate(const QLocale& locale)
{
  m_locale = locale;
  if (m_finder->isCurrent()) follow(); // else the sentences come anew anyway
}

ProblemsView::ProblemsView(FuzzyDocument* document, QWidget* parent)
  : QWidget(parent),
    m_document(document),
    m_finder(new ProblemFinder(document, this)),
    m_model(new ProblemsModel(document, m_finder, this)),
    m_title(new QLabel),
    m_count(new BadgeLabel),
    m_list(new QListView),
    m_none(new QLabel)
{
  setObjectName("problemsView");
  m_count->setObjectName("problemsCount");
  m_count->setWordWrap(false);
  m_list->setObjectName("problemsList");
  m_list->setModel(m_model);
  m_list->setWordWrap(true);
  m_list->setSpacing(2);
  m_list->setResizeMode(QListView::Adjust);
  m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_list->setEditTriggers(QAbstractItemView::NoEditTriggers);
  m_list->setAlternatingRowColors(true);
  m_none->setObjectName("problemsNone");
  QFont bold = m_title->font();
  bold.setBold(true);
  m_title->setFont(bold);

  auto* head = new QHBoxLayout;
  head->addWidget(m_title);
  head->addWidget(m_count);
  head->addStretch(1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 2, 0, 0);
  layout->setSpacing(4);
  layout->addLayout(head);
  layout->addWidget(m_list, 1);

  connect(m_list, &QListView::activated, this, &ProblemsView::activate);
  connect(m_finder, &ProblemFinder::found, this, &ProblemsView::showCount);
  connect(document, &FuzzyDocument::ruleLanguageChanged, this, &ProblemsView::retranslate);
  retranslate();
}

void ProblemsView::activate(const QModelIndex& index)
{
  if (!index.isValid() || !m_finder->isCurrent()) return; // its numbers may be those of other rules by now
  const fuzzy::RuleFinding& finding = m_model->finding(index.row());
  if (!finding.place.empty()) {
    std::vector<fuzzy::InputValue> values = m_document->inputs();
    for (const auto& [input, value] : finding.place)
      if (static_cast<std::size_t>(input) < values.size()) values[static_cast<std::size_t>(input)] = value;
    m_document->setInputs(std::move(values), tr("Go to a gap in the rules"));
    emit variableRequested(false, finding.place.front().first);
  } else if (finding.rule >= 0) {
    emit rulesRequested(finding.rule, finding.otherRule);
  } else if (finding.variable >= 0) {
    emit variableRequested(finding.onOutput, finding.variable);
  }
}

void ProblemsView::setTextHasMistakes(bool has)
{
  if (has == m_textHasMistakes) return;
  m_textHasMistakes = has;
  showCount();
}

void ProblemsView::showCount()
{
  const int count = static_cast<int>(m_finder->findings().size()); // those beyond the list's end included
  m_count->setText(QString::number(count));
  m_count->setAccessibleName(tr("%n problem(s)", "", count));
  m_count->setVisible(count > 0);
  setVisible(count > 0); // else the rules may have the room
  const bool none = count == 0 && m_finder->isCurrent() && !m_textHasMistakes;
  m_none->setText(none ? tr("No problems") : QString());
  m_none->setToolTip(none ? tr("Every place has a rule, and every rule counts.") : QString());
}

void ProblemsView::retranslate()
{
  m_title->setText(tr("Problems"));
  m_list->setAccessibleName(tr("Problems of the rules"));
  m_model->retranslate(locale());
  showCount();
}

void ProblemsView::changeEvent(QEvent* event)
{
  QWidget::changeEvent(event);
  // The program's numbers change with its language; widgets keep the locale that they were born with.
  if (event->type() == QEvent::LanguageChange) setLocale(QLocale());
  if (event->type() == QEvent::LanguageChange || event->type() == QEvent::LocaleChange) retranslate();
}

} // namespace esm
