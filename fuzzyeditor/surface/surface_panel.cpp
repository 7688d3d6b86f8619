// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/surface/surface_panel.h"

#include "fuzzyeditor/fuzzy_evaluation.h"
#include "fuzzyeditor/rules/rule_display.h"
#include "fuzzyeditor/surface/surface_plot.h"
#include "fuzzyeditor/surface/surface_source.h"
#include "fuzzyeditor/surface/surface_table.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QTabBar>
#include <QTabWidget>

#include <algorithm>

namespace esm {

SurfacePanel::SurfacePanel(FuzzyEvaluation* evaluation, QWidget* parent)
  : QWidget(parent),
    m_evaluation(evaluation),
    m_source(new SurfaceSource(evaluation, this)),
    m_output(new QComboBox),
    m_x(new QComboBox),
    m_y(new QComboBox),
    m_over(new QLabel),
    m_and(new QLabel),
    m_plot(new SurfacePlot(m_source)),
    m_tabs(new QTabWidget)
{
  setObjectName("surfacePanel");
  m_output->setObjectName("surfaceOutput");
  m_x->setObjectName("surfaceX");
  m_y->setObjectName("surfaceY");
  m_tabs->setObjectName("surfaceTabs");
  m_tabs->setDocumentMode(true);
  m_tabs->addTab(m_plot, QString());
  m_tabs->addTab(new SurfaceTable(m_source), QString());
  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  for (QWidget* widget : std::initializer_list<QWidget*>{m_output, m_over, m_x, m_and, m_y})
    row->addWidget(widget);
  for (QComboBox* box : {m_output, m_x, m_y}) {
    box->setMinimumContentsLength(5);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    row->setStretchFactor(box, 1);
    connect(box, &QComboBox::currentIndexChanged, this, [this, box] { choose(box); });
  }
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 4, 4, 4);
  layout->setSpacing(4);
  layout->addLayout(row);
  layout->addWidget(m_tabs, 1);
  connect(evaluation->document(), &FuzzyDocument::ruleBaseChanged, this, &SurfacePanel::fillChoices);
  connect(evaluation->document(), &FuzzyDocument::ruleLanguageChanged, this, &SurfacePanel::fillChoices);
  retranslate();
}

/// Renews the names only if one changed, since every edit of a rule comes here too.
void SurfacePanel::fillChoices()
{
  const fuzzy::RuleBase& rules = m_evaluation->document()->ruleBase();
  const Language language = m_evaluation->document()->ruleLanguage();
  const auto fill = [&](QComboBox* box, const std::vector<fuzzy::Variable>& variables, int fallback) {
    QStringList names, old;
    for (const fuzzy::Variable& variable : variables) names << RuleDisplay::title(variable, language);
    for (int i = 0; i < box->count(); ++i) old << box->itemText(i);
    if (names == old) return;
    const int kept = box->currentIndex() >= 0 ? box->currentIndex() : fallback;
    const QSignalBlocker quiet(box);
    box->clear();
    box->addItems(names);
    box->setCurrentIndex(std::min(kept, box->count() - 1));
  };
  fill(m_output, rules.outputs, 0);
  fill(m_x, rules.inputs, 0);
  fill(m_y, rules.inputs, 1);
  if (m_x->currentIndex() == m_y->currentIndex() && m_x->count() > 1) { // fewer inputs than before
    const QSignalBlocker quiet(m_x);
    m_x->setCurrentIndex(m_y->currentIndex() == 0 ? 1 : 0);
  }
  ask();
}

/// The same input on both axes is no surface: the other axis takes what this one had.
void SurfacePanel::choose(QComboBox* changed)
{
  if (m_x->currentIndex() == m_y->currentIndex() && m_x->count() > 1) {
    QComboBox* other = changed == m_x ? m_y : m_x;
    const int had = changed == m_x ? m_source->question().x : m_source->question().y;
    const QSignalBlocker quiet(other);
    other->setCurrentIndex(had);
  }
  ask();
}

void SurfacePanel::ask()
{
  m_source->setQuestion(m_output->currentIndex(), m_x->currentIndex(), m_y->currentIndex());
}

void SurfacePanel::retranslate()
{
  m_output->setAccessibleName(tr("Result that the map shows"));
  m_x->setAccessibleName(tr("Input along the lower axis"));
  m_y->setAccessibleName(tr("Input along the upright axis"));
  m_over->setText(tr("over"));
  m_and->setText(tr("and"));
  m_tabs->setTabText(0, tr("Map"));
  m_tabs->setTabText(1, tr("Table"));
  m_tabs->tabBar()->setAccessibleName(tr("Map or table"));
  m_tabs->setAccessibleName(tr("Map or table"));
  fillChoices();
}

void SurfacePanel::changeEvent(QEvent* event)
{
  QWidget::changeEvent(event);
  // The program's numbers change with its language; widgets keep the locale that they were born with.
  if (event->type() == QEvent::LanguageChange) setLocale(QLocale());
  if (event->type() == QEvent::LanguageChange) retranslate();
}

} // namespace esm
