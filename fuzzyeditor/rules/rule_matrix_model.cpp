// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/rules/rule_matrix_model.h"

#include <algorithm>

namespace esm {
namespace {

using NodeKind = fuzzy::Condition::Kind;

template <class Named>
int placeOf(const std::vector<Named>& things, const std::string& id)
{
  const auto found =
    std::find_if(things.begin(), things.end(), [&](const Named& thing) { return thing.id == id; });
  return found == things.end() ? -1 : toInt(static_cast<std::size_t>(found - things.begin()));
}

bool isPlain(const fuzzy::Proposition& proposition, const std::string& variable, const std::string& term)
{
  return proposition.variable == variable && proposition.term == term && proposition.hedges.empty();
}

/// Whether a condition about two inputs holds where one word of each is wholly true and the others are not.
class Words {
public:
  Words(const fuzzy::Proposition& first, const fuzzy::Proposition& second) : m_first(first), m_second(second)
  {}
  bool satisfy(const fuzzy::Condition& condition, std::size_t node = 0) const
  {
    const fuzzy::Condition::Node& n = condition.nodes[node];
    const auto holds = [&](int child) { return satisfy(condition, static_cast<std::size_t>(child)); };
    switch (n.kind) {
    case NodeKind::And:
      return std::all_of(n.children.begin(), n.children.end(), holds);
    case NodeKind::Or:
      return std::any_of(n.children.begin(), n.children.end(), holds);
    case NodeKind::Not:
      return !holds(n.children.front());
    case NodeKind::Proposition:
      break;
    }
    const auto nots = std::count(n.proposition.hedges.begin(), n.proposition.hedges.end(), fuzzy::Hedge::Not);
    const fuzzy::Proposition& word = n.proposition.variable == m_first.variable ? m_first : m_second;
    return (n.proposition.term == word.term) == (nots % 2 == 0);
  }

private:
  const fuzzy::Proposition &m_first, &m_second;
};

/// The word that a rule concludes on an output, null if it does not.
const fuzzy::Proposition* conclusionOf(const fuzzy::Rule& rule, const std::string& output)
{
  const auto found = std::find_if(rule.consequents.begin(), rule.consequents.end(),
                                  [&](const fuzzy::Proposition& p) { return p.variable == output; });
  return found == rule.consequents.end() ? nullptr : &*found;
}

} // namespace

RuleMatrixModel::RuleMatrixModel(FuzzyEvaluation* evaluation, QObject* parent)
  : QAbstractTableModel(parent), m_evaluation(evaluation), m_document(evaluation->document())
{
  chooseAxes();
  findPlaces();
  connect(m_document, &FuzzyDocument::ruleBaseChanged, this, &RuleMatrixModel::followDocument);
  connect(m_document, &FuzzyDocument::ruleLanguageChanged, this, &RuleMatrixModel::retranslate);
  connect(evaluation, &FuzzyEvaluation::changed, this, &RuleMatrixModel::announce);
}

/// The first rule of the very form that cells have shows where a matrix is worth looking at.
void RuleMatrixModel::chooseAxes()
{
  const fuzzy::RuleBase& base = rules();
  if (base.inputs.size() < 2 || base.outputs.empty()) return;
  m_ids = {base.inputs[0].id, base.inputs[1].id, base.outputs[0].id};
  for (const fuzzy::Rule& rule : base.rules) {
    const auto& nodes = rule.condition.nodes;
    if (nodes.size() != 3 || nodes[0].kind != NodeKind::And) continue;
    const fuzzy::Proposition &first = nodes[1].proposition, &second = nodes[2].proposition;
    if (first.variable == second.variable || !first.hedges.empty() || !second.hedges.empty()) continue;
    m_ids = {first.variable, second.variable, rule.consequents.front().variable};
    return;
  }
}

void RuleMatrixModel::findPlaces()
{
  const fuzzy::RuleBase& base = rules();
  m_row = placeOf(base.inputs, m_ids.row);
  m_column = placeOf(base.inputs, m_ids.column);
  m_output = placeOf(base.outputs, m_ids.output);
  if (m_row < 0 || m_column < 0 || m_output < 0) m_row = m_column = m_output = -1;
  m_rows = hasAxes() ? toInt(variable(m_row).terms.size()) : 0;
  m_columns = hasAxes() ? toInt(variable(m_column).terms.size()) : 0;
}

void RuleMatrixModel::setAxes(int rowInput, int columnInput, int output)
{
  const fuzzy::RuleBase& base = rules();
  const auto isPlace = [](int place, const auto& list) { return place >= 0 && place < toInt(list.size()); };
  if (!isPlace(rowInput, base.inputs) || !isPlace(columnInput, base.inputs) ||
      !isPlace(output, base.outputs) || rowInput == columnInput)
    return;
  beginResetModel();
  m_ids = {variable(rowInput).id, variable(columnInput).id,
           base.outputs[static_cast<std::size_t>(output)].id};
  m_stale = true;
  findPlaces();
  endResetModel();
  emit axesChanged();
}

/// As long as the grid keeps its size, so do the selection and the place of the view.
void RuleMatrixModel::followDocument()
{
  m_stale = true;
  const fuzzy::RuleBase& base = rules();
  const auto size = [&](const std::string& id) {
    const fuzzy::Variable* input = base.findInput(id);
    return input ? toInt(input->terms.size()) : -1;
  };
  if (hasAxes() && size(m_ids.row) == m_rows && size(m_ids.column) == m_columns &&
      base.findOutput(m_ids.output)) {
    findPlaces();
    announce();
    emit headerDataChanged(Qt::Horizontal, 0, m_columns - 1);
    emit headerDataChanged(Qt::Vertical, 0, m_rows - 1);
  } else {
    beginResetModel();
    findPlaces();
    if (!hasAxes()) {
      chooseAxes();
      findPlaces();
    }
    endResetModel();
  }
  emit axesChanged(); // names may be others
}

void RuleMatrixModel::announce()
{
  if (m_rows > 0 && m_columns > 0) emit dataChanged(index(0, 0), index(m_rows - 1, m_columns - 1));
}

int RuleMatrixModel::rowCount(const QModelIndex& parent) const
{
  return parent.isValid() ? 0 : m_rows;
}

int RuleMatrixModel::columnCount(const QModelIndex& parent) const
{
  return parent.isValid() ? 0 : m_columns;
}

bool RuleMatrixModel::isOwn(const fuzzy::Rule& rule, int row, int column) const
{
  const auto& nodes = rule.condition.nodes;
  if (nodes.size() != 3 || nodes[0].kind != NodeKind::And) return false;
  const std::string& rowTerm = variable(m_row).terms[static_cast<std::size_t>(row)].id;
  const std::string& columnTerm = variable(m_column).terms[static_cast<std::size_t>(column)].id;
  for (const auto& [a, b] : {std::pair(1, 2), std::pair(2, 1)})
    if (isPlain(nodes[static_cast<std::size_t>(a)].proposition, m_ids.row, rowTerm) &&
        isPlain(nodes[static_cast<std::size_t>(b)].proposition, m_ids.column, columnTerm))
      return true;
  return false;
}

const RuleMatrixModel::Cells& RuleMatrixModel::cells() const
{
  if (!m_stale) return m_cells;
  m_stale = false;
  m_unshown = 0;
  m_cells.assign(static_cast<std::size_t>(m_rows) * static_cast<std::size_t>(m_columns), {});
  for (std::size_t r = 0; r < rules().rules.size() && hasAxes(); ++r)
    if (conclusionOf(rules().rules[r], m_ids.output)) sortIn(toInt(r), m_cells);
  // Own rules first: they are what is edited.
  for (std::vector<Entry>& cell : m_cells)
    std::stable_partition(cell.begin(), cell.end(), [](const Entry& entry) { return entry.own; });
  return m_cells;
}

void RuleMatrixModel::sortIn(int rule, Cells& cells) const
{
  const fuzzy::Condition& condition = rules().rules[static_cast<std::size_t>(rule)].condition;
  for (const fuzzy::Condition::Node& node : condition.nodes)
    if (node.kind == NodeKind::Proposition && node.proposition.variable != m_ids.row &&
        node.proposition.variable != m_ids.column) {
      ++m_unshown;
      return;
    }
  fuzzy::Proposition row{m_ids.row, {}, {}}, column{m_ids.column, {}, {}};
  const Words words(row, column);
  for (int r = 0; r < m_rows; ++r)
    for (int c = 0; c < m_columns; ++c) {
      row.term = variable(m_row).terms[static_cast<std::size_t>(r)].id;
      column.term = variable(m_column).terms[static_cast<std::size_t>(c)].id;
      if (!words.satisfy(condition)) continue;
      const bool own = isOwn(rules().rules[static_cast<std::size_t>(rule)], r, c);
      cells[static_cast<std::size_t>(r * m_columns + c)].push_back({rule, own});
    }
}

const std::vector<RuleMatrixModel::Entry>& RuleMatrixModel::entries(const QModelIndex& index) const
{
  return cells()[static_cast<std::size_t>(index.row() * m_columns + index.column())];
}

int RuleMatrixModel::unshownRules() const
{
  cells();
  return m_unshown;
}

/// "high", "very high × 0.8", "(medium)", "high, off".
QString RuleMatrixModel::entryText(const Entry& entry) const
{
  const fuzzy::Rule& rule = rules().rules[static_cast<std::size_t>(entry.rule)];
  const fuzzy::Variable& output = rules().outputs[static_cast<std::size_t>(m_output)];
  const fuzzy::Proposition& conclusion = *conclusionOf(rule, m_ids.output);
  QString text = toQt(
    fuzzy::formatInput(fuzzy::Word{conclusion.term, conclusion.hedges}, output, m_document->ruleLanguage()));
  if (rule.weight != 1.0)
    text += QStringLiteral("\u00a0×\u00a0") + m_locale.toString(rule.weight, 'g', 3); // breaks nowhere
  if (!rule.enabled) text = tr("%1, off").arg(text);
  return entry.own ? text : '(' + text + ')';
}

double RuleMatrixModel::degree(const QModelIndex& index, bool own) const
{
  double strongest = 0.0;
  for (const Entry& entry : entries(index))
    if (entry.own == own) strongest = std::max(strongest, m_evaluation->degree(entry.rule));
  return strongest;
}

/// "hardness soft, wall solid: volume stiffness high × 0.8. Fires 0.35."
QString RuleMatrixModel::accessibleText(const QModelIndex& index) const
{
  const Language language = m_document->ruleLanguage();
  const auto word = [&](int input, int term) {
    const fuzzy::Variable& v = variable(input);
    return RuleDisplay::name(v, language) + ' ' +
           toQt(v.terms[static_cast<std::size_t>(term)].name.in(language));
  };
  const QString where = word(m_row, index.row()) + ", " + word(m_column, index.column());
  const QString output = RuleDisplay::name(rules().outputs[static_cast<std::size_t>(m_output)], language);
  if (entries(index).empty()) return tr("%1: no rule for %2.").arg(where, output);
  const double strongest = std::max(degree(index, true), degree(index, false));
  return tr("%1: %2 %3. Fires %4.")
    .arg(where, output, index.data().toString(), m_locale.toString(strongest, 'f', 2));
}

QVariant RuleMatrixModel::data(const QModelIndex& index, int role) const
{
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
  const Language language = m_document->ruleLanguage();
  switch (role) {
  case Qt::DisplayRole: {
    QStringList texts;
    for (const Entry& entry : entries(index)) texts << entryText(entry);
    return texts.join(QStringLiteral(" · "));
  }
  case Qt::EditRole: {
    if (!data(index, HasOwnRole).toBool()) return -1;
    const fuzzy::Rule& rule = rules().rules[static_cast<std::size_t>(entries(index).front().rule)];
    return placeOf(rules().outputs[static_cast<std::size_t>(m_output)].terms,
                   conclusionOf(rule, m_ids.output)->term);
  }
  case Qt::ToolTipRole: {
    QStringList sentences;
    for (const Entry& entry : entries(index))
      sentences << tr("Rule %1: %2")
                     .arg(entry.rule + 1)
                     .arg(RuleDisplay::sentence(rules().rules[static_cast<std::size_t>(entry.rule)], rules(),
                                                language));
    return sentences.isEmpty() ? tr("No rule speaks here. Return or a double click makes one.")
                               : sentences.join('\n');
  }
  case Qt::AccessibleTextRole:
    return accessibleText(index);
  case ChoicesRole: {
    QStringList words;
    for (const fuzzy::Term& term : rules().outputs[static_cast<std::size_t>(m_output)].terms)
      words << toQt(term.name.in(language));
    return words;
  }
  case OwnDegreeRole:
    return degree(index, true);
  case CoverDegreeRole:
    return degree(index, false);
  case HasOwnRole:
    return !entries(index).empty() && entries(index).front().own;
  case IsEmptyRole:
    return entries(index).empty();
  default:
    return {};
  }
}

QVariant RuleMatrixModel::headerData(int section, Qt::Orientation orientation, int role) const
{
  if (role != Qt::DisplayRole || !hasAxes()) return {};
  const fuzzy::Variable& input = variable(orientation == Qt::Horizontal ? m_column : m_row);
  if (section < 0 || section >= toInt(input.terms.size())) return {};
  return toQt(input.terms[static_cast<std::size_t>(section)].name.in(m_document->ruleLanguage()));
}

Qt::ItemFlags RuleMatrixModel::flags(const QModelIndex& index) const
{
  if (!index.isValid()) return {};
  return Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable | Qt::ItemNeverHasChildren;
}

bool RuleMatrixModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
  bool isNumber = false;
  const int term = value.toInt(&isNumber);
  if (!checkIndex(index, CheckIndexOption::IndexIsValid) || role != Qt::EditRole || !isNumber) return false;
  setCells({index}, term);
  return true;
}

fuzzy::Rule RuleMatrixModel::newRule(int row, int column, int term) const
{
  fuzzy::Rule rule;
  const auto is = [&](int input, int word) {
    const fuzzy::Variable& v = variable(input);
    return fuzzy::Condition::Node{
      NodeKind::Proposition, {v.id, v.terms[static_cast<std::size_t>(word)].id, {}}, {}};
  };
  rule.condition.nodes = {{NodeKind::And, {}, {1, 2}}, is(m_row, row), is(m_column, column)};
  const fuzzy::Variable& output = rules().outputs[static_cast<std::size_t>(m_output)];
  rule.consequents = {{output.id, output.terms[static_cast<std::size_t>(term)].id, {}}};
  return rule;
}

void RuleMatrixModel::setCells(const QModelIndexList& places, int term)
{
  if (!hasAxes()) return;
  const fuzzy::Variable& output = rules().outputs[static_cast<std::size_t>(m_output)];
  if (term >= toInt(output.terms.size())) return;
  fuzzy::RuleBase base = rules();
  const auto isAboutOutput = [&](const fuzzy::Proposition& p) { return p.variable == output.id; };
  std::vector<int> emptied;
  for (const QModelIndex& index : places) {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) continue;
    bool said = term < 0;
    for (const Entry& entry : entries(index)) {
      if (!entry.own) continue;
      fuzzy::Rule& rule = base.rules[static_cast<std::size_t>(entry.rule)];
      const auto conclusion = std::find_if(rule.consequents.begin(), rule.consequents.end(), isAboutOutput);
      if (!said) {
        *conclusion = {output.id, output.terms[static_cast<std::size_t>(term)].id, {}};
        rule.enabled = said = true;
      } else {
        std::erase_if(rule.consequents, isAboutOutput);
        if (rule.consequents.empty()) emptied.push_back(entry.rule);
      }
    }
    if (!said) base.rules.push_back(newRule(index.row(), index.column(), term));
  }
  std::sort(emptied.rbegin(), emptied.rend());
  for (const int rule : emptied) base.rules.erase(base.rules.begin() + rule);
  if (base.rules == rules().rules) return;
  m_document->setRuleBase(std::move(base), term < 0 ? tr("Clear a cell of the rule matrix")
                                                    : tr("Set a cell of the rule matrix"));
}

void RuleMatrixModel::setLocale(const QLocale& locale)
{
  m_locale = locale;
  retranslate();
}

void RuleMatrixModel::retranslate()
{
  announce();
  if (!hasAxes()) return;
  emit headerDataChanged(Qt::Horizontal, 0, m_columns - 1);
  emit headerDataChanged(Qt::Vertical, 0, m_rows - 1);
  emit axesChanged();
}

} // namespace esm
