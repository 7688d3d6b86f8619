// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/rule_table_model.h"

#include <QBrush>
#include <QGuiApplication>
#include <QMimeData>
#include <QPalette>
#include <QPoint>

#include <algorithm>
#include <cmath>
#include <set>

namespace esm {
namespace {

constexpr const char* kRowsMime = "application/x-esm-rule-rows";

int toInt(std::size_t value)
{
  return static_cast<int>(value);
}

bool contains(const std::vector<int>& rows, int row)
{
  return std::find(rows.begin(), rows.end(), row) != rows.end();
}

/// The word that describes `value` best; the first one where none does.
std::string fittingTerm(const fuzzy::Variable& variable, double value)
{
  const fuzzy::NamedDegree best = fuzzy::bestTerm(variable, value);
  return variable.terms[static_cast<std::size_t>(std::max(best.term, 0))].id;
}

/// What the strongest rule concludes about `output`: a centroid always lies further inside than the word
/// meant.
std::string presentConclusion(const fuzzy::RuleBase& base, const fuzzy::Inference& inference,
                              const fuzzy::Variable& output)
{
  std::string term = fittingTerm(output, output.defaultValue);
  double strongest = 0.0;
  for (const fuzzy::RuleFiring& firing : inference.firings)
    for (const auto& consequent : base.rules[static_cast<std::size_t>(firing.rule)].consequents)
      if (consequent.variable == output.id && firing.degree > strongest) {
        strongest = firing.degree;
        term = consequent.term;
      }
  return term;
}

} // namespace

RuleTableModel::RuleTableModel(FuzzyEvaluation* evaluation, QObject* parent)
  : QAbstractTableModel(parent),
    m_evaluation(evaluation),
    m_document(evaluation->document()),
    m_rules(m_document->ruleBase().rules),
    m_parts(m_rules.size())
{
  connect(m_document, &FuzzyDocument::ruleBaseChanged, this, &RuleTableModel::followDocument);
  connect(m_document, &FuzzyDocument::ruleLanguageChanged, this, &RuleTableModel::retranslate);
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
    if (!rule.enabled) return QBrush(QGuiApplication::palette().color(QPalette::Disabled, QPalette::Text));
    return {};
  case Qt::TextAlignmentRole:
    return column == Weight ? QVariant(int(Qt::AlignRight | Qt::AlignVCenter)) : QVariant();
  case Qt::ToolTipRole:
    if (wrong) return m_mistake->sentence;
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

bool RuleTableModel::setRuleText(int row, Column column, const QString& text)
{
  const Language language = m_document->ruleLanguage();
  const RuleParts& old = parts(row);
  const QString start = RuleDisplay::keyword(RuleDisplay::If, language) + ' ';
  const QString middle = ' ' + RuleDisplay::keyword(RuleDisplay::Then, language) + ' ';
  const QString before = column == Condition ? start : start + old.condition + middle;
  const QString whole = before + text + (column == Condition ? middle + old.conclusion : QString());

  const fuzzy::RuleBase& rules = m_document->ruleBase();
  auto parsed = fuzzy::parseRule(toUtf8(text), rules); // a whole rule may be pasted into a cell
  const bool pasted = std::holds_alternative<fuzzy::Rule>(parsed);
  const std::string utf8 = toUtf8(whole);
  if (!pasted) parsed = fuzzy::parseRule(utf8, rules);

  if (const auto* error = std::get_if<fuzzy::RuleTextError>(&parsed)) {
    Mistake mistake{row, column, text, RuleDisplay::mistakeRange(utf8, *error), {}, {}};
    // A mistake of the cell can show beyond it (a parenthesis left open): then the cell's end is marked.
    const int length = static_cast<int>(text.size());
    mistake.range.start = std::clamp(mistake.range.start - static_cast<int>(before.size()), 0, length);
    mistake.range.length = std::min(mistake.range.length, length - mistake.range.start);
    mistake.sentence =
      RuleDisplay::mistakeSentence(*error, RuleDisplay::offendingWord(utf8, *error), language);
    mistake.suggestion = toQt(error->suggestion);
    setMistake(mistake);
    return false;
  }
  const fuzzy::Rule& rule = std::get<fuzzy::Rule>(parsed);
  setMistake({});
  return editRule(row, tr("Change rule %1").arg(row + 1), [&](fuzzy::Rule& changed) {
    if (pasted || column == Condition) changed.condition = rule.condition;
    if (pasted || column == Conclusion) changed.consequents = rule.consequents;
    if (pasted || rule.weight != 1.0) changed.weight = rule.weight;
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
  emit mistakeChanged();
}

void RuleTableModel::cureMistake()
{
  if (!m_mistake || m_mistake->suggestion.isEmpty()) return;
  const Mistake mistake = *m_mistake;
  QString text = mistake.text;
  text.replace(mistake.range.start, mistake.range.length, mistake.suggestion);
  setRuleText(mistake.row, mistake.column, text);
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
}

int RuleTableModel::addRule(int row)
{
  const fuzzy::RuleBase& base = m_document->ruleBase();
  if (base.inputs.empty() || base.outputs.empty()) return -1;
  if (base.inputs.front().terms.empty() || base.outputs.front().terms.empty()) return -1;
  const fuzzy::Variable& input = base.inputs.front();
  const fuzzy::Variable& output = base.outputs.front();

  fuzzy::Proposition condition{input.id, {}, {}};
  const fuzzy::InputValue& value = m_document->inputs().front();
  if (const double* crisp = std::get_if<double>(&value))
    condition.term = fittingTerm(input, *crisp);
  else
    condition.term = std::get<fuzzy::Word>(value).term;

  fuzzy::Rule rule;
  rule.condition.nodes.push_back({fuzzy::Condition::Kind::Proposition, condition, {}});
  rule.consequents.push_back({output.id, presentConclusion(base, m_evaluation->inference(), output), {}});
  std::vector<fuzzy::Rule> rules = m_rules;
  const int place = std::clamp(row + 1, 0, rowCount());
  rules.insert(rules.begin() + place, rule);
  push(std::move(rules), tr("Add a rule"));
  return place;
}

int RuleTableModel::duplicateRules(const std::vector<int>& rows)
{
  if (rows.empty()) return -1;
  std::vector<fuzzy::Rule> copies;
  for (int row = 0; row < rowCount(); ++row)
    if (contains(rows, row)) copies.push_back(m_rules[static_cast<std::size_t>(row)]);
  const int place = *std::max_element(rows.begin(), rows.end()) + 1;
  std::vector<fuzzy::Rule> rules = m_rules;
  rules.insert(rules.begin() + place, copies.begin(), copies.end());
  push(std::move(rules),
       copies.size() == 1 ? tr("Duplicate a rule") : tr("Duplicate %1 rules").arg(copies.size()));
  return place;
}

void RuleTableModel::removeRules(const std::vector<int>& rows)
{
  if (rows.empty()) return;
  std::vector<fuzzy::Rule> rules;
  for (int row = 0; row < rowCount(); ++row)
    if (!contains(rows, row)) rules.push_back(m_rules[static_cast<std::size_t>(row)]);
  push(std::move(rules), rows.size() == 1 ? tr("Delete a rule") : tr("Delete %1 rules").arg(rows.size()));
}

int RuleTableModel::moveRules(const std::vector<int>& rows, int target)
{
  std::vector<fuzzy::Rule> before, moved, after;
  for (int row = 0; row < rowCount(); ++row) {
    const fuzzy::Rule& rule = m_rules[static_cast<std::size_t>(row)];
    (contains(rows, row) ? moved : row < target ? before : after).push_back(rule);
  }
  const int place = toInt(before.size());
  std::vector<fuzzy::Rule> rules = std::move(before);
  rules.insert(rules.end(), moved.begin(), moved.end());
  rules.insert(rules.end(), after.begin(), after.end());
  if (rules != m_rules)
    push(std::move(rules), moved.size() == 1 ? tr("Move a rule") : tr("Move %1 rules").arg(moved.size()));
  return place;
}

void RuleTableModel::setRulesEnabled(const std::vector<int>& rows, bool enabled)
{
  std::vector<fuzzy::Rule> rules = m_rules;
  for (const int row : rows) rules[static_cast<std::size_t>(row)].enabled = enabled;
  if (rules == m_rules) return;
  const std::size_t count = rows.size();
  if (enabled)
    push(std::move(rules), count == 1 ? tr("Switch a rule on") : tr("Switch %1 rules on").arg(count));
  else
    push(std::move(rules), count == 1 ? tr("Switch a rule off") : tr("Switch %1 rules off").arg(count));
}

QStringList RuleTableModel::mimeTypes() const
{
  return {QString::fromLatin1(kRowsMime)};
}

QMimeData* RuleTableModel::mimeData(const QModelIndexList& indexes) const
{
  std::set<int> rows;
  for (const QModelIndex& index : indexes) rows.insert(index.row());
  QByteArray bytes;
  for (const int row : rows) bytes += QByteArray::number(row) + ' ';
  auto* data = new QMimeData; // owned by the caller
  data->setData(QString::fromLatin1(kRowsMime), bytes);
  return data;
}

bool RuleTableModel::dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int,
                                  const QModelIndex& parent)
{
  if (action != Qt::MoveAction || !data->hasFormat(QString::fromLatin1(kRowsMime))) return false;
  std::vector<int> rows;
  for (const QByteArray& number : data->data(QString::fromLatin1(kRowsMime)).simplified().split(' '))
    if (const int moved = number.toInt(); moved < rowCount()) rows.push_back(moved);
  const int target = row >= 0 ? row : parent.isValid() ? parent.row() : rowCount();
  moveRules(rows, target);
  return false; // done by the document; true would make the view delete the dragged rows
}

} // namespace esm
