// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/rules/rule_table_model.h"

#include "fuzzyeditor/panel_colors.h"

#include <QBrush>
#include <QGuiApplication>
#include <QPalette>
#include <QPoint>

#include <algorithm>
#include <cmath>

namespace esm {

RuleTableModel::RuleTableModel(FuzzyEvaluation* evaluation, QObject* parent)
  : QAbstractTableModel(parent),
    m_evaluation(evaluation),
    m_document(evaluation->document()),
    m_rules(m_document->ruleBase().rules),
    m_parts(m_rules.size())
{
  connect(m_document, &FuzzyDocument::ruleBaseChanged, this, &RuleTableModel::followDocument);
  connect(m_document, &FuzzyDocument::ruleLanguageChanged, this, &RuleTableModel::retranslate);
  connect(m_document, &FuzzyDocument::ruleDraftReplaced, this,
          [this] { // its rules follow by ruleBaseChanged()
            if (std::exchange(m_mistake, {})) emit mistakeChanged();
            m_restoring = m_document->ruleDraft().row >= 0;
          });
  connect(evaluation, &FuzzyEvaluation::changed, this, [this] {
    if (!m_rules.empty()) emit dataChanged(index(0, Degree), index(rowCount() - 1, Degree));
  });
}

int RuleTableModel::rowCount(const QModelIndex& parent) const
{
  return parent.isValid() ? 0 : toInt(m_rules.size());
}

int RuleTableModel::columnCount(const QModelIndex& parent) const
{
  return parent.isValid() ? 0 : kColumnCount;
}

const RuleParts& RuleTableModel::parts(int row) const
{
  std::optional<RuleParts>& parts = m_parts[static_cast<std::size_t>(row)];
  if (!parts)
    parts = RuleDisplay::parts(m_rules[static_cast<std::size_t>(row)], m_document->ruleBase(),
                               m_document->ruleLanguage());
  return *parts;
}

QVariant RuleTableModel::displayData(int row, Column column) const
{
  if (m_mistake && m_mistake->row == row && m_mistake->column == column) return m_mistake->text;
  const fuzzy::Rule& rule = m_rules[static_cast<std::size_t>(row)];
  switch (column) {
  case Condition:
    return parts(row).condition;
  case Conclusion:
    return parts(row).conclusion;
  case Weight:
    return m_locale.toString(rule.weight, 'f', 2);
  case Degree:
    return rule.enabled ? m_locale.toString(m_evaluation->degree(row), 'f', 2) : tr("off");
  case Note:
    return toQt(rule.note);
  default:
    return {};
  }
}

QVariant RuleTableModel::data(const QModelIndex& index, int role) const
{
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
  const int row = index.row();
  const auto column = static_cast<Column>(index.column());
  const fuzzy::Rule& rule = m_rules[static_cast<std::size_t>(row)];
  const bool wrong = m_mistake && m_mistake->row == row && m_mistake->column == column;
  switch (role) {
  case Qt::DisplayRole:
    return displayData(row, column);
  case Qt::EditRole:
    return column == Weight ? QVariant(rule.weight) : displayData(row, column);
  case Qt::CheckStateRole:
    if (column == On) return rule.enabled ? Qt::Checked : Qt::Unchecked;
    return {};
  case Qt::ForegroundRole:
    if (!rule.enabled) return QBrush(panel_colors::off(QGuiApplication::palette()));
    return {};
  case Qt::TextAlignmentRole:
    return column == Weight ? QVariant(int(Qt::AlignRight | Qt::AlignVCenter)) : QVariant();
  case Qt::ToolTipRole:
    if (wrong) return mistakeSentence();
    return column == Condition || column == Conclusion || column == Note ? displayData(row, column)
                                                                         : QVariant();
  case Qt::AccessibleTextRole:
    if (column == On)
      return rule.enabled ? tr("Rule %1 is on.").arg(row + 1) : tr("Rule %1 is off.").arg(row + 1);
    return displayData(row, column);
  case DegreeRole:
    return rule.enabled ? m_evaluation->degree(row) : 0.0;
  case MistakeRangeRole:
    return wrong ? QPoint(m_mistake->range.start, m_mistake->range.length) : QVariant();
  default:
    return {};
  }
}

QVariant RuleTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
  if (orientation == Qt::Vertical) return role == Qt::DisplayRole ? QVariant(section + 1) : QVariant();
  const Language language = m_document->ruleLanguage();
  if (role == Qt::DisplayRole) {
    switch (section) {
    case On:
      return tr("On");
    case Condition:
      return RuleDisplay::keyword(RuleDisplay::If, language);
    case Conclusion:
      return RuleDisplay::keyword(RuleDisplay::Then, language);
    case Weight:
      return tr("Weight");
    case Degree:
      return tr("Fires");
    case Note:
      return tr("Note");
    default:
      return {};
    }
  }
  if (role == Qt::ToolTipRole && section == Degree)
    return tr("How strongly the rule fires for the current inputs, from 0 to 1.");
  if (role == Qt::ToolTipRole && section == Weight) return tr("How much the rule counts, from 0 to 1.");
  return {};
}

Qt::ItemFlags RuleTableModel::flags(const QModelIndex& index) const
{
  if (!index.isValid()) return Qt::ItemIsDropEnabled; // rules are dropped between rules
  Qt::ItemFlags flags =
    Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsDragEnabled | Qt::ItemNeverHasChildren;
  if (index.column() == On)
    flags |= Qt::ItemIsUserCheckable;
  else if (index.column() != Degree)
    flags |= Qt::ItemIsEditable;
  return flags;
}

bool RuleTableModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return false;
  const int row = index.row();
  if (role == Qt::CheckStateRole && index.column() == On) {
    setRulesEnabled({row}, value.toInt() == Qt::Checked);
    return true;
  }
  if (role != Qt::EditRole) return false;
  switch (index.column()) {
  case Condition:
  case Conclusion:
    return setRuleText(row, static_cast<Column>(index.column()), value.toString());
  case Weight: {
    const double weight = value.toDouble();
    if (!(weight >= 0.0 && weight <= 1.0)) return false;
    return editRule(row, tr("Change the weight of rule %1").arg(row + 1),
                    [&](fuzzy::Rule& rule) { rule.weight = weight; });
  }
  case Note:
    return editRule(row, tr("Change the note of rule %1").arg(row + 1),
                    [&](fuzzy::Rule& rule) { rule.note = value.toString().toStdString(); });
  default:
    return false;
  }
}

/// What a cell's text says, or why it is no rule.
RuleTableModel::Reading RuleTableModel::read(int row, Column column, const QString& text) const
{
  const Language language = m_document->ruleLanguage();
  const RuleParts& old = parts(row);
  const QString start = RuleDisplay::keyword(RuleDisplay::If, language) + ' ';
  const QString middle = ' ' + RuleDisplay::keyword(RuleDisplay::Then, language) + ' ';
  const QString before = column == Condition ? start : start + old.condition + middle;
  const QString whole = before + text + (column == Condition ? middle + old.conclusion : QString());

  Reading reading;
  const fuzzy::RuleBase& rules = m_document->ruleBase();
  auto parsed = fuzzy::parseRule(toUtf8(text), rules); // a whole rule may be pasted into a cell
  reading.isWhole = std::holds_alternative<fuzzy::Rule>(parsed);
  const std::string utf8 = toUtf8(whole);
  if (!reading.isWhole) parsed = fuzzy::parseRule(utf8, rules);

  if (const auto* error = std::get_if<fuzzy::RuleTextError>(&parsed)) {
    Mistake mistake{row, column, text, RuleDisplay::mistakeRange(utf8, *error), *error, {}};
    mistake.word = RuleDisplay::offendingWord(utf8, *error);
    // A mistake of the cell can show beyond it (a parenthesis left open): then the cell's end is marked.
    const int length = static_cast<int>(text.size());
    mistake.range.start = std::clamp(mistake.range.start - static_cast<int>(before.size()), 0, length);
    mistake.range.length = std::min(mistake.range.length, length - mistake.range.start);
    reading.mistake = mistake;
  } else {
    reading.rule = std::get<fuzzy::Rule>(parsed);
  }
  return reading;
}

bool RuleTableModel::setRuleText(int row, Column column, const QString& text)
{
  const Reading reading = read(row, column, text);
  setMistake(reading.mistake);
  if (reading.mistake) return false;
  return editRule(row, tr("Change rule %1").arg(row + 1), [&](fuzzy::Rule& changed) {
    if (reading.isWhole || column == Condition) changed.condition = reading.rule.condition;
    if (reading.isWhole || column == Conclusion) changed.consequents = reading.rule.consequents;
    if (reading.isWhole || reading.rule.weight != 1.0) changed.weight = reading.rule.weight;
  });
}

bool RuleTableModel::editRule(int row, const QString& undoText,
                              const std::function<void(fuzzy::Rule&)>& change)
{
  std::vector<fuzzy::Rule> rules = m_rules;
  change(rules[static_cast<std::size_t>(row)]);
  if (rules != m_rules) push(std::move(rules), undoText);
  return true;
}

void RuleTableModel::push(std::vector<fuzzy::Rule> rules, const QString& undoText)
{
  fuzzy::RuleBase base = m_document->ruleBase();
  base.rules = std::move(rules);
  m_document->setRuleBase(std::move(base), undoText);
}

void RuleTableModel::setMistake(std::optional<Mistake> mistake)
{
  const auto refresh = [this] {
    if (!m_mistake) return;
    const QModelIndex cell = index(m_mistake->row, m_mistake->column);
    emit dataChanged(cell, cell);
  };
  if (!m_mistake && !mistake) return;
  const std::optional<Mistake> old = std::exchange(m_mistake, std::move(mistake));
  if (old && old->row < rowCount())
    emit dataChanged(index(old->row, old->column), index(old->row, old->column));
  refresh();
  tellMistake();
  emit mistakeChanged();
}

/// To the document: it is unsaved work.
void RuleTableModel::tellMistake()
{
  if (m_mistake)
    m_document->setDraftCell(m_mistake->row, m_mistake->column, toUtf8(m_mistake->text));
  else
    m_document->setDraftCell(-1, 0, {});
}

void RuleTableModel::restoreMistake()
{
  m_restoring = false;
  const RuleDraft draft = m_document->ruleDraft();
  const bool isText = draft.column == Condition || draft.column == Conclusion;
  if (!isText || draft.row >= rowCount()) return tellMistake();
  setMistake(read(draft.row, static_cast<Column>(draft.column), toQt(draft.cell)).mistake);
  tellMistake();
}

void RuleTableModel::cureMistake()
{
  if (!m_mistake || m_mistake->error.suggestion.empty()) return;
  const Mistake mistake = *m_mistake;
  QString text = mistake.text;
  text.replace(mistake.range.start, mistake.range.length, toQt(mistake.error.suggestion));
  setRuleText(mistake.row, mistake.column, text);
}

QString RuleTableModel::mistakeSentence() const
{
  return m_mistake
           ? RuleDisplay::mistakeSentence(m_mistake->error, m_mistake->word, m_document->ruleLanguage())
           : QString();
}

void RuleTableModel::discardMistake()
{
  setMistake({});
}

/// Tells the view the smallest change that leads from the rules shown to those of the document: what is equal
/// at the start and at the end stays, so that selection and scrolling do too.
void RuleTableModel::followDocument()
{
  const std::vector<fuzzy::Rule>& now = m_document->ruleBase().rules;
  const std::vector<fuzzy::Rule> old = m_rules;
  const std::size_t shorter = std::min(old.size(), now.size());
  std::size_t head = 0, tail = 0;
  while (head < shorter && old[head] == now[head]) ++head;
  while (tail < shorter - head && old[old.size() - 1 - tail] == now[now.size() - 1 - tail]) ++tail;

  if (m_mistake) { // it stays with its rule as long as that is the same
    const auto row = static_cast<std::size_t>(m_mistake->row);
    if (row >= old.size() - tail)
      m_mistake->row += toInt(now.size()) - toInt(old.size());
    else if (row >= head)
      setMistake({});
    tellMistake();
  }
  // First what changes in place, then the rows that come or go behind it.
  const std::size_t common = shorter - tail;
  for (std::size_t row = head; row < common; ++row) m_rules[row] = now[row];
  forgetTexts(); // of all rows: a variable or term may have got another name
  if (now.size() > old.size()) {
    beginInsertRows({}, toInt(common), toInt(now.size() - tail) - 1);
    m_rules = now;
    m_parts.assign(now.size(), std::nullopt);
    endInsertRows();
  } else if (now.size() < old.size()) {
    beginRemoveRows({}, toInt(common), toInt(old.size() - tail) - 1);
    m_rules = now;
    m_parts.assign(now.size(), std::nullopt);
    endRemoveRows();
  }
  if (m_restoring) restoreMistake();
}

void RuleTableModel::forgetTexts()
{
  m_parts.assign(m_rules.size(), std::nullopt);
  if (!m_rules.empty()) emit dataChanged(index(0, 0), index(rowCount() - 1, kColumnCount - 1));
}

void RuleTableModel::setLocale(const QLocale& locale)
{
  m_locale = locale;
  retranslate();
}

void RuleTableModel::retranslate()
{
  forgetTexts();
  emit headerDataChanged(Qt::Horizontal, 0, kColumnCount - 1);
  if (m_mistake) emit mistakeChanged();
}

} // namespace esm
