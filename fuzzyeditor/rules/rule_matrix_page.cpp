// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/rules/rule_matrix_page.h"

#include "fuzzyeditor/panel_colors.h"
#include "fuzzyeditor/rules/rule_matrix_model.h"

#include <QAction>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPainter>
#include <QTableView>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>

namespace esm {

void RuleMatrixDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                               const QModelIndex& index) const
{
  QStyleOptionViewItem item = option;
  initStyleOption(&item, index);
  const QPalette& colors = option.palette;
  const bool selected = option.state & QStyle::State_Selected;
  // What only covers the cell tints it half as much as a rule of its own.
  const double tint = std::max(index.data(RuleMatrixModel::OwnDegreeRole).toDouble(),
                               0.5 * index.data(RuleMatrixModel::CoverDegreeRole).toDouble());
  painter->save();
  painter->fillRect(option.rect,
                    panel_colors::mix(colors.color(QPalette::Base), panel_colors::bar(colors), tint));
  if (index.data(RuleMatrixModel::IsEmptyRole).toBool())
    painter->fillRect(option.rect, QBrush(panel_colors::faint(colors), Qt::BDiagPattern));
  if (selected) {
    painter->setPen(QPen(colors.color(QPalette::Highlight), 2));
    painter->drawRect(option.rect.adjusted(1, 1, -2, -2));
  }
  const bool own = index.data(RuleMatrixModel::HasOwnRole).toBool();
  QFont font = item.font;
  font.setItalic(!own);
  painter->setFont(font);
  painter->setPen(own ? colors.color(QPalette::Text) : panel_colors::quiet(colors));
  const QRect place = option.rect.adjusted(6, 0, -6, 0);
  painter->drawText(place, Qt::AlignCenter,
                    QFontMetrics(font).elidedText(item.text, Qt::ElideRight, place.width()));
  painter->restore();
}

QWidget* RuleMatrixDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&,
                                          const QModelIndex& index) const
{
  auto* choice = new QComboBox(parent);
  choice->setObjectName("matrixCell");
  choice->setAccessibleName(index.data(Qt::AccessibleTextRole).toString());
  choice->addItem(tr("no rule"));
  choice->addItems(index.data(RuleMatrixModel::ChoicesRole).toStringList());
  auto* self = const_cast<RuleMatrixDelegate*>(this);
  connect(choice, &QComboBox::activated, self, [self, choice] {
    emit self->commitData(choice);
    emit self->closeEditor(choice);
  });
  QTimer::singleShot(0, choice, &QComboBox::showPopup); // a list at once: arrows choose, Return takes
  return choice;
}

void RuleMatrixDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const
{
  qobject_cast<QComboBox*>(editor)->setCurrentIndex(index.data(Qt::EditRole).toInt() + 1);
}

void RuleMatrixDelegate::setModelData(QWidget* editor, QAbstractItemModel* model,
                                      const QModelIndex& index) const
{
  const int term = qobject_cast<QComboBox*>(editor)->currentIndex() - 1;
  if (term != index.data(Qt::EditRole).toInt()) model->setData(index, term);
}

RuleMatrixPage::RuleMatrixPage(FuzzyEvaluation* evaluation, QWidget* parent)
  : QWidget(parent),
    m_evaluation(evaluation),
    m_model(new RuleMatrixModel(evaluation, this)),
    m_table(new QTableView),
    m_rowsLabel(new QLabel),
    m_columnsLabel(new QLabel),
    m_outputLabel(new QLabel),
    m_rows(new QComboBox),
    m_columns(new QComboBox),
    m_output(new QComboBox),
    m_clear(new QAction(this)),
    m_note(new QLabel)
{
  m_rows->setObjectName("matrixRows");
  m_columns->setObjectName("matrixColumns");
  m_output->setObjectName("matrixOutput");
  m_note->setObjectName("matrixNote");
  m_note->setWordWrap(true);
  m_table->setObjectName("rulesMatrix");
  m_table->setModel(m_model);
  m_table->setItemDelegate(new RuleMatrixDelegate(m_table));
  m_table->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
  m_table->setTabKeyNavigation(false); // Tab must leave
  m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  m_table->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 12);
  m_table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  m_clear->setObjectName("actMatrixClear");
  m_clear->setShortcut(QKeySequence::Delete);
  m_clear->setShortcutContext(Qt::WidgetShortcut);
  m_table->addAction(m_clear);
  m_table->setContextMenuPolicy(Qt::ActionsContextMenu);

  auto* choices = new QHBoxLayout;
  for (const auto& [label, box] : {std::pair(m_rowsLabel, m_rows), std::pair(m_columnsLabel, m_columns),
                                   std::pair(m_outputLabel, m_output)}) {
    label->setBuddy(box);
    box->setSizeAdjustPolicy(QComboBox::AdjustToContents); // names change with the language
    box->setMinimumWidth(50); // rather cut off than a window wider than a small screen
    choices->addWidget(label);
    choices->addWidget(box);
    connect(box, &QComboBox::activated, this, [this, box = box] { takeChoice(box); });
  }
  choices->addStretch(1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 2, 0, 0);
  layout->setSpacing(2);
  layout->addLayout(choices);
  layout->addWidget(m_table, 1);
  layout->addWidget(m_note);

  // Return opens a cell; where a style activates by F2 or a double click, the cell is open already.
  connect(m_table, &QTableView::activated, this, [this](const QModelIndex& cell) {
    if (!m_table->findChild<QComboBox*>("matrixCell")) m_table->edit(cell);
  });
  connect(m_clear, &QAction::triggered, this,
          [this] { m_model->setCells(m_table->selectionModel()->selectedIndexes(), -1); });
  connect(m_model, &RuleMatrixModel::axesChanged, this, &RuleMatrixPage::retranslate);
  m_model->setLocale(locale());
  retranslate();
}

void RuleMatrixPage::fillChoices()
{
  const fuzzy::RuleBase& rules = m_evaluation->document()->ruleBase();
  const Language language = m_evaluation->document()->ruleLanguage();
  const auto fill = [&](QComboBox* box, const std::vector<fuzzy::Variable>& variables, int current) {
    QStringList names;
    for (const fuzzy::Variable& variable : variables) names << RuleDisplay::title(variable, language);
    QStringList shown;
    for (int i = 0; i < box->count(); ++i) shown << box->itemText(i);
    if (names != shown) {
      box->clear();
      box->addItems(names);
    }
    box->setCurrentIndex(current);
  };
  fill(m_rows, rules.inputs, m_model->rowInput());
  fill(m_columns, rules.inputs, m_model->columnInput());
  fill(m_output, rules.outputs, m_model->output());
}

/// An input cannot span rows and columns both: chosen twice, the two change places.
void RuleMatrixPage::takeChoice(const QComboBox* changed)
{
  int row = m_rows->currentIndex(), column = m_columns->currentIndex();
  if (row == column)
    (changed == m_rows ? column : row) = changed == m_rows ? m_model->rowInput() : m_model->columnInput();
  m_model->setAxes(row, column, m_output->currentIndex());
}

void RuleMatrixPage::retranslate()
{
  m_rowsLabel->setText(tr("Rows:"));
  m_columnsLabel->setText(tr("Columns:"));
  m_outputLabel->setText(tr("Result:"));
  m_rows->setAccessibleName(tr("Input that spans the rows"));
  m_columns->setAccessibleName(tr("Input that spans the columns"));
  m_output->setAccessibleName(tr("Result that the cells show"));
  m_table->setAccessibleName(tr("Rules as matrix"));
  m_clear->setText(tr("Delete the rules of the selected cells"));
  fillChoices();
  int widest = fontMetrics().horizontalAdvance(QStringLiteral("medium × 0.8")); // a cell's usual content
  for (int column = 0; column < m_model->columnCount(); ++column)
    widest = std::max(
      widest, fontMetrics().horizontalAdvance(m_model->headerData(column, Qt::Horizontal).toString()));
  m_table->horizontalHeader()->setMinimumSectionSize(widest + 16);
  const int unshown = m_model->unshownRules();
  m_note->setText(
    m_model->rowCount() == 0 ? tr("A matrix needs two inputs and a result.")
    : unshown > 0
      ? tr("%n rule(s) for this result also ask about other inputs and are not shown here.", "", unshown)
      : QString());
  m_note->setVisible(!m_note->text().isEmpty());
}

void RuleMatrixPage::changeEvent(QEvent* event)
{
  QWidget::changeEvent(event);
  // The program's numbers change with its language; widgets keep the locale that they were born with.
  if (event->type() == QEvent::LanguageChange) setLocale(QLocale());
  if (event->type() == QEvent::LanguageChange) retranslate();
  if (event->type() == QEvent::LanguageChange || event->type() == QEvent::LocaleChange)
    m_model->setLocale(locale());
}

} // namespace esm
