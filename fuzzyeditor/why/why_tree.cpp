// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/why/why_tree.h"

#include "core/tissue/explain_text.h"
#include "core/tissue/tissue_units.h"
#include "fuzzyeditor/rules/rule_display.h"

#include <QLocale>
#include <QTreeWidget>

#include <algorithm>

namespace esm {
namespace {

constexpr int kKeyRole = Qt::UserRole + 3;

/// "E h A / L^2" as it is read.
QString formula(const char* text)
{
  return QString::fromUtf8(text)
    .replace(QLatin1String("^2"), QStringLiteral("²"))
    .replace(QLatin1String("tau"), QStringLiteral("τ"))
    .replace(QLatin1String("rho"), QStringLiteral("ρ"))
    .replace(QLatin1String("sum of "), QStringLiteral("Σ "));
}

QString key(const char* part, int number)
{
  return QLatin1String(part) + QString::number(number);
}

WhyRow inputRow(const LayerReason& layer, int input, const TissueModel& model, Language language)
{
  const fuzzy::Variable& variable = model.rules.inputs[static_cast<std::size_t>(input)];
  WhyRow row;
  row.key = key("input", input);
  row.what = toQt(variable.name.in(language)) + QStringLiteral(": ") +
             toQt(inputText(layer.inputs[static_cast<std::size_t>(input)], variable, language));
  row.help = row.what;
  return row;
}

QString keyOf(const QTreeWidgetItem* item)
{
  return item->data(0, kKeyRole).toString();
}

/// Of an item and all below it, those that are unfolded: a tree forgets it of items that are taken out.
void collectUnfolded(QTreeWidgetItem* item, std::vector<QTreeWidgetItem*>& unfolded)
{
  if (item->isExpanded()) unfolded.push_back(item);
  for (int i = 0; i < item->childCount(); ++i) collectUnfolded(item->child(i), unfolded);
}

void moveChild(QTreeWidgetItem* parent, int from, int to)
{
  std::vector<QTreeWidgetItem*> unfolded;
  collectUnfolded(parent->child(from), unfolded);
  parent->insertChild(to, parent->takeChild(from));
  for (QTreeWidgetItem* item : unfolded) item->setExpanded(true);
}

void fill(QTreeWidgetItem* item, const WhyRow& row)
{
  item->setData(0, kKeyRole, row.key);
  item->setText(WhyTree::What, row.what);
  item->setToolTip(WhyTree::What, row.help);
  item->setText(WhyTree::Value, row.value);
  item->setData(WhyTree::What, WhyTree::kRuleRole, row.rule);
  item->setData(WhyTree::Share, WhyTree::kShareRole, row.share ? QVariant(*row.share) : QVariant());
  item->setText(WhyTree::Share, row.share ? QLocale().toString(*row.share, 'f', 2) : QString());
}

/// Makes the rows the children of an item, or of the tree's root.
void put(const std::vector<WhyRow>& rows, QTreeWidgetItem* parent)
{
  for (int i = parent->childCount(); i-- > 0;)
    if (std::none_of(rows.begin(), rows.end(),
                     [&](const WhyRow& row) { return row.key == keyOf(parent->child(i)); }))
      delete parent->takeChild(i);
  for (int i = 0; i < static_cast<int>(rows.size()); ++i) {
    const WhyRow& row = rows[static_cast<std::size_t>(i)];
    int found = i;
    while (found < parent->childCount() && keyOf(parent->child(found)) != row.key) ++found;
    const bool isNew = found == parent->childCount();
    if (isNew)
      parent->insertChild(i, new QTreeWidgetItem);
    else if (found != i)
      moveChild(parent, found, i);
    fill(parent->child(i), row);
    put(row.children, parent->child(i));
    if (isNew) parent->child(i)->setExpanded(row.open);
  }
}

} // namespace

/// The numbers of the spring or node, and what the sentence is about first.
std::vector<WhyRow> WhyTree::valueRows(const TissueExplanation& why, Language language)
{
  std::vector<WhyRow> rows;
  if (why.thing.kind != ExplainedThing::Kind::Spring) {
    WhyRow& row = rows.emplace_back();
    row.key = QStringLiteral("main");
    row.what = tr("stiffness of the tissue, E");
    row.value = toQt(shownNumber(why.main(), language));
  }
  for (const ExplainedValue& value : why.values) {
    WhyRow& row = rows.emplace_back();
    row.key = QLatin1String(value.kind->id);
    row.what = toQt(value.kind->name.in(language)) + QStringLiteral(" = ") + formula(value.kind->formula);
    row.value = toQt(shownNumber(value, language));
    row.help = row.what;
    if (value.value == value.fromTissue) continue;
    ExplainedValue other = value;
    other.value = value.fromTissue;
    row.help += QLatin1Char('\n') + tr("By the tissue: %1").arg(toQt(shownNumber(other, language)));
  }
  return rows;
}

/// What the formulas take: geometry, and those parameters of the tissue that count here.
WhyRow WhyTree::placeRow(const TissueExplanation& why, Language language)
{
  WhyRow place;
  place.key = QStringLiteral("geometry");
  place.what = why.thing.kind == ExplainedThing::Kind::Tissue ? tr("Tissue") : tr("Geometry and tissue here");
  for (const ExplainedGeometry& fact : why.geometry) {
    WhyRow& row = place.children.emplace_back();
    row.key = QLatin1String(fact.id);
    row.what = QStringLiteral("%1 = %2").arg(QLatin1String(fact.symbol), toQt(fact.name.in(language)));
    row.value = toQt(shownNumber(fact, language));
  }
  for (const OutputReason& output : why.layers.front().outputs) {
    const ExplainedValue& value = why.parameters[static_cast<std::size_t>(output.parameter)];
    WhyRow& row = place.children.emplace_back();
    row.key = key("parameter", output.parameter);
    const QString symbol = formula(value.kind->formula), name = toQt(value.kind->name.in(language));
    row.what = symbol.isEmpty() ? name : QStringLiteral("%1 = %2").arg(symbol, name);
    row.value = toQt(shownNumber(value, language));
  }
  return place;
}

WhyRow WhyTree::outputRow(const LayerReason& layer, const OutputReason& output, const TissueModel& model,
                          Language language, bool open)
{
  const auto parameter = kTissueOutputs[static_cast<std::size_t>(output.parameter)].value;
  WhyRow row;
  row.key = key("output", output.parameter);
  row.what = toQt(shownName(parameter, language));
  row.value = toQt(shownValue(output.value, parameter, language));
  if (!output.fromRules) row.help = tr("No rule fires for it: this is the default.");
  row.open = open;
  for (const RuleReason& rule : output.rules) {
    const fuzzy::Rule& text = model.rules.rules[static_cast<std::size_t>(rule.rule)];
    WhyRow& reason = row.children.emplace_back();
    reason.key = key("rule", rule.rule);
    reason.what =
      tr("Rule %1: %2").arg(rule.rule + 1).arg(RuleDisplay::sentence(text, model.rules, language));
    reason.help = reason.what + QLatin1Char('\n') +
                  tr("Without this rule: %1").arg(toQt(shownValue(rule.without, parameter, language)));
    reason.share = rule.degree;
    reason.rule = rule.rule;
    reason.open = open && &rule == &output.rules.front();
    for (const int input : rule.inputs) reason.children.push_back(inputRow(layer, input, model, language));
  }
  return row;
}

std::vector<WhyRow> WhyTree::rows(const TissueExplanation& why, const TissueModel& model, Language language)
{
  std::vector<WhyRow> rows = valueRows(why, language);
  rows.push_back(placeRow(why, language));
  std::vector<const LayerReason*> layers;
  for (const LayerReason& layer : why.layers) layers.push_back(&layer);
  std::stable_sort(layers.begin(), layers.end(), [](const LayerReason* a, const LayerReason* b) {
    return a->layer.share > b->layer.share;
  });
  for (const LayerReason* layer : layers) {
    WhyRow& row = rows.emplace_back();
    row.key = key("layer", layer->layer.region);
    row.what = toQt(tissueName(layer->layer.region, model, language));
    row.what[0] = row.what[0].toUpper();
    row.value = toQt(shareText(layer->layer.share));
    row.share = layer->layer.share;
    row.open = layer == layers.front();
    for (const OutputReason& output : layer->outputs)
      row.children.push_back(
        outputRow(*layer, output, model, language, row.open && &output == &layer->outputs.front()));
  }
  return rows;
}

void WhyTree::show(const std::vector<WhyRow>& rows, QTreeWidget* tree)
{
  put(rows, tree->invisibleRootItem());
  tree->viewport()->update(); // Qt 6.4 leaves the old picture where rows have been exchanged
}

} // namespace esm
