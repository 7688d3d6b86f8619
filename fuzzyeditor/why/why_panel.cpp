// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/why/why_panel.h"

#include "core/base/file_io.h"
#include "fuzzyeditor/rules/rule_delegates.h"
#include "fuzzyeditor/rules/rule_display.h"
#include "fuzzyeditor/why/why_tree.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QEvent>
#include <QFileDialog>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QSpinBox>
#include <QToolButton>
#include <QTreeWidget>

#include <algorithm>

namespace esm {
namespace {

constexpr std::size_t kMostRows = 5; ///< of changes; more would push the tree out of the dock
enum Direction { Softer, Harder };

/// A bar where there is a share, else nothing.
class ShareDelegate : public DegreeDelegate {
public:
  using DegreeDelegate::DegreeDelegate;
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override
  {
    if (index.data(WhyTree::kShareRole).isValid())
      DegreeDelegate::paint(painter, option, index);
    else
      QStyledItemDelegate::paint(painter, option,
                                 index); // NOLINT(bugprone-parent-virtual-call): plain, no bar
  }
};

} // namespace

WhyPanel::WhyPanel(WhySource* source, QWidget* parent)
  : QWidget(parent),
    m_source(source),
    m_sentence(new QLabel),
    m_question(new QLabel),
    m_noChange(new QLabel),
    m_menu(new QToolButton),
    m_tree(new QTreeWidget),
    m_percent(new QSpinBox),
    m_direction(new QComboBox),
    m_rows(new QGridLayout)
{
  build();
  m_later.setSingleShot(true);
  m_later.setInterval(0);
  connect(&m_later, &QTimer::timeout, this, &WhyPanel::refresh);
  connect(source, &WhySource::changed, this, [this] {
    m_known = false;
    if (isVisible()) m_later.start();
  });
  connect(m_percent, &QSpinBox::valueChanged, this, &WhyPanel::refreshChanges);
  connect(m_direction, &QComboBox::currentIndexChanged, this, &WhyPanel::refreshChanges);
  connect(m_tree, &QTreeWidget::itemActivated, this, [this](QTreeWidgetItem* item) {
    const int rule = item->data(WhyTree::What, WhyTree::kRuleRole).toInt();
    if (rule >= 0) emit ruleActivated(rule);
  });
  retranslate();
}

void WhyPanel::build()
{
  setObjectName("whyPanel");
  m_sentence->setObjectName("whySentence");
  m_menu->setObjectName("whyMenu");
  m_tree->setObjectName("whyTree");
  m_percent->setObjectName("whyPercent");
  m_direction->setObjectName("whyDirection");
  m_noChange->setObjectName("whyNoChange");
  for (QLabel* label : {m_sentence, m_question, m_noChange}) label->setTextFormat(Qt::PlainText);
  m_sentence->setWordWrap(true);
  m_noChange->setWordWrap(true);
  m_sentence->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  m_sentence->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Minimum);

  auto* menu = new QMenu(m_menu);
  m_menu->setMenu(menu);
  m_menu->setPopupMode(QToolButton::InstantPopup);
  m_menu->setText(QStringLiteral("…"));
  m_copySentence = addExport("whyCopySentence", &WhyPanel::copySentence);
  m_copyCsv = addExport("whyCopyCsv", &WhyPanel::copyCsv);
  m_saveCsv = addExport("whySaveCsv", &WhyPanel::saveCsv);
  m_saveJson = addExport("whySaveJson", &WhyPanel::saveJson);

  m_tree->setColumnCount(3);
  m_tree->setUniformRowHeights(true);
  m_tree->setAlternatingRowColors(true);
  m_tree->setItemDelegateForColumn(WhyTree::Share, new ShareDelegate(WhyTree::kShareRole, m_tree));
  m_tree->header()->setStretchLastSection(false);
  m_tree->header()->setMinimumSectionSize(40);
  m_tree->header()->setSectionResizeMode(WhyTree::What, QHeaderView::Stretch);
  m_tree->header()->resizeSection(WhyTree::Share, 64);
  m_tree->header()->setSectionResizeMode(WhyTree::Value, QHeaderView::ResizeToContents);
  m_tree->setIndentation(14);

  m_percent->setRange(1, 95);
  m_percent->setValue(20);
  m_direction->addItems({QString(), QString()});

  auto* head = new QHBoxLayout;
  head->addWidget(m_sentence, 1);
  head->addWidget(m_menu, 0, Qt::AlignTop);
  auto* question = new QHBoxLayout;
  question->addWidget(m_question);
  question->addWidget(m_percent);
  question->addWidget(m_direction);
  question->addStretch(1);
  m_rows->setColumnStretch(0, 1);
  m_rows->setVerticalSpacing(2);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->setSpacing(4);
  layout->addLayout(head);
  layout->addWidget(m_tree, 1);
  layout->addLayout(question);
  layout->addWidget(m_noChange);
  layout->addLayout(m_rows);
}

QAction* WhyPanel::addExport(const char* name, void (WhyPanel::*slot)())
{
  QAction* action = m_menu->menu()->addAction(QString());
  action->setObjectName(QLatin1String(name));
  connect(action, &QAction::triggered, this, slot);
  return action;
}

double WhyPanel::factor() const
{
  const double part = 0.01 * m_percent->value();
  return m_direction->currentIndex() == Softer ? 1.0 - part : 1.0 + part;
}

void WhyPanel::refresh()
{
  if (!isVisible()) return;
  const TissueField* field = m_source->field();
  m_known = field != nullptr;
  m_tree->setEnabled(m_known);
  m_menu->setEnabled(m_known);
  if (!field) {
    m_sentence->setText(tr("The rules cannot be evaluated now, so nothing can be explained."));
    m_changes.changes.clear();
    showChanges();
    return;
  }
  ++m_explanations;
  m_why = m_source->explanation();
  m_sentence->setText(toQt(sentenceOf(m_why, field->model(), m_source->language())));
  WhyTree::show(WhyTree::rows(m_why, field->model(), m_source->language()), m_tree);
  refreshChanges();
}

void WhyPanel::refreshChanges()
{
  const TissueField* field = m_source->field();
  if (!isVisible() || !m_known || !field) return;
  m_changes = {m_why.main().kind->id, factor(), changesFor(*field, m_why, m_why.main(), factor())};
  showChanges();
}

WhyPanel::ChangeRow& WhyPanel::changeRow(std::size_t row)
{
  if (row < m_changeRows.size()) return m_changeRows[row];
  ChangeRow made{new QLabel, new QPushButton};
  made.text->setObjectName(QStringLiteral("whyChange%1").arg(row));
  made.text->setTextFormat(Qt::PlainText);
  made.text->setWordWrap(true);
  made.apply->setObjectName(QStringLiteral("whyApply%1").arg(row));
  connect(made.apply, &QPushButton::clicked, this, [this, row] {
    if (row < m_changes.changes.size()) m_source->apply(InputChange(m_changes.changes[row]));
  });
  m_rows->addWidget(made.text, static_cast<int>(row), 0);
  m_rows->addWidget(made.apply, static_cast<int>(row), 1);
  m_changeRows.push_back(made);
  return m_changeRows.back();
}

void WhyPanel::showChanges()
{
  const TissueField* field = m_source->field();
  const std::size_t count = std::min(m_changes.changes.size(), kMostRows);
  m_noChange->setVisible(count == 0);
  for (std::size_t i = 0; i < count; ++i) {
    const InputChange& change = m_changes.changes[i];
    ChangeRow& row = changeRow(i);
    const QString text = toQt(changeText(change, field->model(), m_source->language()));
    row.text->setText(text);
    row.apply->setText(tr("Apply"));
    row.apply->setAccessibleName(tr("Apply: %1").arg(text));
    const double* from = std::get_if<double>(&change.from);
    row.apply->setEnabled(!change.locked && !(from && *from == change.to));
    row.apply->setToolTip(change.locked ? tr("The region is locked.") : QString());
  }
  for (std::size_t i = 0; i < m_changeRows.size(); ++i) {
    m_changeRows[i].text->setVisible(i < count);
    m_changeRows[i].apply->setVisible(i < count);
  }
}

// === Out of the panel

void WhyPanel::copySentence()
{
  QApplication::clipboard()->setText(m_sentence->text());
}

void WhyPanel::copyCsv()
{
  if (const TissueField* field = m_source->field())
    QApplication::clipboard()->setText(
      toQt(explanationCsv(m_why, field->model(), &m_changes, m_source->language())));
}

void WhyPanel::saveCsv()
{
  if (const TissueField* field = m_source->field())
    save(tr("Table (*.csv)"), QStringLiteral("csv"),
         explanationCsv(m_why, field->model(), &m_changes, m_source->language()));
}

void WhyPanel::saveJson()
{
  if (const TissueField* field = m_source->field())
    save(tr("JSON (*.json)"), QStringLiteral("json"),
         explanationJson(m_why, field->model(), &m_changes, m_source->language()) + '\n');
}

void WhyPanel::save(const QString& filter, const QString& suffix, const std::string& bytes)
{
  QFileDialog dialog(this, tr("Save the explanation"), QString(), filter);
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix(suffix);
  if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return;
  const QString path = dialog.selectedFiles().constFirst();
  if (Status saved = writeFileAtomically(path.toStdString(), bytes); !saved)
    QMessageBox::warning(this, tr("Save the explanation"), toQt(saved.error().detail));
}

// === Texts

void WhyPanel::retranslate()
{
  m_sentence->setAccessibleName(tr("Explanation in one sentence"));
  m_menu->setAccessibleName(tr("Copy and save the explanation"));
  m_menu->setToolTip(m_menu->accessibleName());
  m_copySentence->setText(tr("Copy sentence"));
  m_copyCsv->setText(tr("Copy as CSV"));
  m_saveCsv->setText(tr("Save as CSV…"));
  m_saveJson->setText(tr("Save as JSON…"));
  m_tree->setHeaderLabels({tr("Reason"), tr("Share"), tr("Value")});
  m_tree->setAccessibleName(tr("Reasons: geometry, regions, rules and inputs, the strongest first"));
  m_question->setText(tr("What would make it"));
  m_percent->setSuffix(tr(" %"));
  m_percent->setAccessibleName(tr("By how many per cent"));
  m_direction->setItemText(Softer, tr("softer?"));
  m_direction->setItemText(Harder, tr("harder?"));
  m_direction->setAccessibleName(tr("Softer or harder"));
  m_noChange->setText(tr("No input changes it."));
  m_later.start();
}

void WhyPanel::changeEvent(QEvent* event)
{
  QWidget::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) {
    setLocale(QLocale()); // widgets keep the locale that they were born with
    retranslate();
  }
}

void WhyPanel::showEvent(QShowEvent* event)
{
  QWidget::showEvent(event);
  refresh();
}

} // namespace esm
