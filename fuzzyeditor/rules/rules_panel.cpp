// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/rules/rules_panel.h"

#include "fuzzyeditor/badge_label.h"
#include "fuzzyeditor/fuzzy_evaluation.h"
#include "fuzzyeditor/rules/mistake_bar.h"
#include "fuzzyeditor/rules/problems_view.h"
#include "fuzzyeditor/rules/rule_delegates.h"
#include "fuzzyeditor/rules/rule_display.h"
#include "fuzzyeditor/rules/rule_matrix_page.h"
#include "fuzzyeditor/rules/rule_table_model.h"
#include "fuzzyeditor/rules/rule_text_page.h"

#include <QAction>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QItemSelection>
#include <QSplitter>
#include <QTabWidget>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace esm {

RulesPanel::RulesPanel(FuzzyEvaluation* evaluation, QWidget* parent)
  : QWidget(parent),
    m_evaluation(evaluation),
    m_model(new RuleTableModel(evaluation, this)),
    m_tabs(new QTabWidget),
    m_textPage(new RuleTextPage(evaluation->document())),
    m_matrixPage(new RuleMatrixPage(evaluation)),
    m_problemsView(new ProblemsView(evaluation->document())),
    m_silence(new BadgeLabel)
{
  setObjectName("rulesPanel");
  m_tabs->setObjectName("rulesTabs");
  m_tabs->setDocumentMode(true);
  m_silence->setObjectName("rulesProblems");
  m_add = createAction("actRuleAdd", Qt::Key_Insert);
  m_duplicate = createAction("actRuleDuplicate", Qt::CTRL | Qt::Key_D);
  m_remove = createAction("actRuleRemove", QKeySequence::Delete);
  m_up = createAction("actRuleUp", Qt::ALT | Qt::Key_Up);
  m_down = createAction("actRuleDown", Qt::ALT | Qt::Key_Down);
  m_switch = createAction("actRuleSwitch", Qt::CTRL | Qt::Key_Space);

  m_tabs->addTab(createTablePage(), QString());
  m_tabs->addTab(m_textPage, QString());
  m_tabs->addTab(m_matrixPage, QString());
  m_tabs->setCornerWidget(m_problemsView->noneLabel());
  auto* sides = new QSplitter(Qt::Horizontal);
  sides->setObjectName("rulesSides");
  sides->addWidget(m_tabs);
  sides->addWidget(m_problemsView);
  sides->setCollapsible(0, false);
  sides->setStretchFactor(0, 1);
  sides->setSizes({700, 240});
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 4, 4, 4);
  layout->setSpacing(4);
  layout->addWidget(sides, 1);
  layout->addWidget(m_silence);

  connectActions();
  connect(m_model, &RuleTableModel::mistakeChanged, this, &RulesPanel::showTableMistake);
  connect(m_tableMistake, &MistakeBar::cureRequested, m_model, &RuleTableModel::cureMistake);
  connect(m_tableMistake, &MistakeBar::discardRequested, m_model, &RuleTableModel::discardMistake);
  connect(m_textPage, &RuleTextPage::mistakesChanged, this, &RulesPanel::retranslate);
  connect(m_problemsView, &ProblemsView::rulesRequested, this, &RulesPanel::showRules);
  connect(m_problemsView, &ProblemsView::variableRequested, this, &RulesPanel::variableRequested);
  connect(evaluation, &FuzzyEvaluation::changed, this, &RulesPanel::showSilence);
  connect(evaluation->document(), &FuzzyDocument::ruleLanguageChanged, this, &RulesPanel::showSilence);
  m_model->setLocale(locale());
  retranslate();
}

QAction* RulesPanel::createAction(const QString& name, const QKeySequence& keys)
{
  auto* action = new QAction(this);
  action->setObjectName(name);
  action->setShortcut(keys);
  action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
  return action;
}

QWidget* RulesPanel::createTablePage()
{
  auto* page = new QWidget;
  m_table = new QTableView;
  m_table->setObjectName("rulesTable");
  m_table->setModel(m_model);
  m_table->setItemDelegateForColumn(RuleTableModel::Condition, new RuleTextDelegate(m_table));
  m_table->setItemDelegateForColumn(RuleTableModel::Conclusion, new RuleTextDelegate(m_table));
  m_table->setItemDelegateForColumn(RuleTableModel::Weight, new WeightDelegate(m_table));
  m_table->setItemDelegateForColumn(RuleTableModel::Degree,
                                    new DegreeDelegate(RuleTableModel::DegreeRole, m_table));
  m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
  m_table->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
  m_table->setAlternatingRowColors(true);
  m_table->setShowGrid(false);
  m_table->setWordWrap(false);
  m_table->setTabKeyNavigation(false); // Tab must leave
  m_table->setDragDropMode(QAbstractItemView::InternalMove);
  m_table->setDragDropOverwriteMode(false);
  QHeaderView* header = m_table->horizontalHeader();
  header->setHighlightSections(false);
  header->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  header->setSectionResizeMode(QHeaderView::ResizeToContents);
  header->setResizeContentsPrecision(0); // of the visible rows: hundreds of rules cost nothing
  header->setSectionResizeMode(RuleTableModel::Condition, QHeaderView::Stretch);
  header->setSectionResizeMode(RuleTableModel::Conclusion, QHeaderView::Stretch);
  header->setSectionResizeMode(RuleTableModel::Degree, QHeaderView::Fixed);
  header->resizeSection(RuleTableModel::Degree, 92);
  header->setSectionResizeMode(RuleTableModel::Note, QHeaderView::Interactive);
  header->resizeSection(RuleTableModel::Note, 70);
  m_table->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 10);
  m_table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);

  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(4);
  for (QAction* action : {m_add, m_duplicate, m_remove, m_up, m_down, m_switch}) {
    m_table->addAction(action); // shortcuts hold while the table has the focus
    auto* button = new QToolButton;
    button->setObjectName(action->objectName() + "Button");
    button->setDefaultAction(action);
    button->setFocusPolicy(Qt::TabFocus);
    buttons->addWidget(button);
  }
  buttons->addStretch(1);
  m_table->setContextMenuPolicy(Qt::ActionsContextMenu);

  m_tableMistake = new MistakeBar("rulesTable");
  m_tableMistake->setDiscardVisible(true);
  auto* layout = new QVBoxLayout(page);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  layout->addWidget(m_table, 1);
  layout->addWidget(m_tableMistake);
  layout->addLayout(buttons);
  return page;
}

void RulesPanel::connectActions()
{
  connect(m_add, &QAction::triggered, this, [this] {
    const int current = m_table->currentIndex().row();
    const int row = m_model->addRule(current >= 0 ? current : m_model->rowCount() - 1);
    if (row < 0) return;
    selectRows(row, 1);
    const QModelIndex cell = m_model->index(row, RuleTableModel::Condition);
    m_table->setCurrentIndex(cell);
    m_table->edit(cell);
  });
  connect(m_duplicate, &QAction::triggered, this, [this] {
    const std::vector<int> rows = selectedRows();
    selectRows(m_model->duplicateRules(rows), static_cast<int>(rows.size()));
  });
  connect(m_remove, &QAction::triggered, this, [this] {
    const std::vector<int> rows = selectedRows();
    if (rows.empty()) return;
    m_model->removeRules(rows);
    selectRows(std::min(rows.front(), m_model->rowCount() - 1), 1);
  });
  connect(m_up, &QAction::triggered, this, [this] {
    const std::vector<int> rows = selectedRows();
    if (!rows.empty() && rows.front() > 0)
      selectRows(m_model->moveRules(rows, rows.front() - 1), static_cast<int>(rows.size()));
  });
  connect(m_down, &QAction::triggered, this, [this] {
    const std::vector<int> rows = selectedRows();
    if (!rows.empty() && rows.back() + 1 < m_model->rowCount())
      selectRows(m_model->moveRules(rows, rows.back() + 2), static_cast<int>(rows.size()));
  });
  connect(m_switch, &QAction::triggered, this, [this] {
    const std::vector<int> rows = selectedRows();
    if (rows.empty()) return;
    const QModelIndex first = m_model->index(rows.front(), RuleTableModel::On);
    m_model->setRulesEnabled(rows, first.data(Qt::CheckStateRole).toInt() != Qt::Checked);
  });
  connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this,
          &RulesPanel::updateActions);
  connect(m_model, &QAbstractItemModel::rowsInserted, this, &RulesPanel::updateActions);
  connect(m_model, &QAbstractItemModel::rowsRemoved, this, &RulesPanel::updateActions);
  updateActions();
}

void RulesPanel::updateActions()
{
  const std::vector<int> rows = selectedRows();
  for (QAction* action : {m_duplicate, m_remove, m_switch}) action->setEnabled(!rows.empty());
  m_up->setEnabled(!rows.empty() && rows.front() > 0);
  m_down->setEnabled(!rows.empty() && rows.back() + 1 < m_model->rowCount());
}

std::vector<int> RulesPanel::selectedRows() const
{
  std::vector<int> rows;
  for (const QModelIndex& index : m_table->selectionModel()->selectedRows()) rows.push_back(index.row());
  std::sort(rows.begin(), rows.end());
  return rows;
}

void RulesPanel::selectRows(int first, int count)
{
  if (first < 0 || count < 1 || first + count > m_model->rowCount()) return;
  const int column = std::max(m_table->currentIndex().column(), 0);
  m_table->selectionModel()->setCurrentIndex(m_model->index(first, column), QItemSelectionModel::NoUpdate);
  const QItemSelection rows(m_model->index(first, 0),
                            m_model->index(first + count - 1, RuleTableModel::kColumnCount - 1));
  m_table->selectionModel()->select(rows, QItemSelectionModel::ClearAndSelect);
}

void RulesPanel::showRule(int rule)
{
  m_tabs->setCurrentIndex(0);
  selectRows(rule, 1);
  m_table->setFocus();
}

void RulesPanel::showRules(int rule, int otherRule)
{
  showRule(rule);
  if (otherRule < 0 || otherRule >= m_model->rowCount()) return;
  const QItemSelection other(m_model->index(otherRule, 0),
                             m_model->index(otherRule, RuleTableModel::kColumnCount - 1));
  m_table->selectionModel()->select(other, QItemSelectionModel::Select);
}

void RulesPanel::showTableMistake()
{
  const auto& mistake = m_model->mistake();
  m_problemsView->setTextHasMistakes(m_textPage->hasMistakes() || mistake);
  if (!mistake) {
    m_tableMistake->setMistake({}, {});
    return;
  }
  m_tableMistake->setMistake(tr("Rule %1: %2 The rule stays as it was until this is mended.")
                               .arg(mistake->row + 1)
                               .arg(m_model->mistakeSentence()),
                             toQt(mistake->error.suggestion));
}

/// One yellow line per output that no rule speaks about for these inputs.
void RulesPanel::showSilence()
{
  if (!isVisible()) return;
  const FuzzyDocument* document = m_evaluation->document();
  const fuzzy::RuleBase& rules = document->ruleBase();
  const Language language = document->ruleLanguage();
  const std::vector<fuzzy::OutputValue>& outputs = m_evaluation->inference().outputs;
  QStringList problems;
  for (std::size_t i = 0; i < std::min(outputs.size(), rules.outputs.size()); ++i) {
    if (outputs[i].fromRules) continue;
    const fuzzy::Variable& output = rules.outputs[i];
    problems << tr("No rule fired for %1 (%2); it takes its default %3.")
                  .arg(RuleDisplay::name(output, language),
                       RuleDisplay::inputs(document->inputs(), rules, language, locale()),
                       RuleDisplay::quantity(outputs[i].value, output, locale()));
  }
  m_silence->setText(problems.join('\n'));
  m_silence->setVisible(!problems.isEmpty());
}

void RulesPanel::retranslate()
{
  const auto name = [](QAction* action, const QString& text, const QString& tip) {
    action->setText(text);
    action->setToolTip(
      QStringLiteral("%1 (%2)").arg(tip, action->shortcut().toString(QKeySequence::NativeText)));
  };
  name(m_add, tr("Add"), tr("Add a rule that says what holds now"));
  name(m_duplicate, tr("Duplicate"), tr("Duplicate the selected rules"));
  name(m_remove, tr("Delete"), tr("Delete the selected rules"));
  name(m_up, tr("Up"), tr("Move the selected rules up"));
  name(m_down, tr("Down"), tr("Move the selected rules down"));
  name(m_switch, tr("On/off"), tr("Switch the selected rules on or off"));
  for (QToolButton* button : findChildren<QToolButton*>())
    if (button->defaultAction()) button->setAccessibleName(button->defaultAction()->toolTip());
  m_tabs->setTabText(0, tr("Table"));
  m_tabs->setTabText(1, m_textPage->hasMistakes() ? tr("Text (with mistakes)") : tr("Text"));
  m_tabs->setTabText(2, tr("Matrix"));
  m_tabs->setAccessibleName(tr("Ways to show the rules"));
  if (auto* bar = m_tabs->findChild<QWidget*>("qt_tabwidget_tabbar"))
    bar->setAccessibleName(tr("Ways to show the rules"));
  m_table->setAccessibleName(tr("Rules as table"));
  m_silence->setAccessibleName(tr("Gaps in the rules"));
  showTableMistake();
  showSilence();
}

void RulesPanel::changeEvent(QEvent* event)
{
  QWidget::changeEvent(event);
  // The program's numbers change with its language; widgets keep the locale that they were born with.
  if (event->type() == QEvent::LanguageChange) setLocale(QLocale());
  if (event->type() == QEvent::LanguageChange) {
    m_model->retranslate();
    retranslate();
  } else if (event->type() == QEvent::LocaleChange) {
    m_model->setLocale(locale());
    showSilence();
  }
}

void RulesPanel::showEvent(QShowEvent* event)
{
  QWidget::showEvent(event);
  m_problemsView->finder()->setOn(true);
  showSilence();
}

void RulesPanel::hideEvent(QHideEvent* event)
{
  QWidget::hideEvent(event);
  m_problemsView->finder()->setOn(false); // hidden panels cost nothing
}

} // namespace esm
