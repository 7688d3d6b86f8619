// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Edits of whole rules: add, duplicate, remove, move by button or by dragging, switch on and off.
#include "fuzzyeditor/rules/rule_table_model.h"

#include <QMimeData>

#include <algorithm>
#include <set>

namespace esm {
namespace {

constexpr const char* kRowsMime = "application/x-esm-rule-rows";

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
