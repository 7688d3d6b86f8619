// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/why_tree.h"

#include "core/tissue/explain_text.h"
#include "core/tissue/tissue_units.h"
#include "fuzzyeditor/rule_display.h"

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
    .replace(QLatin1String("tau"), QStringLiteral("τ"));
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

/// Puts the children of an item, or of the tree's root, in order.
void put(const std::vector<WhyRow>& rows, QTreeWidgetItem* parent)
{
  for (int i = 0; i < static_cast<int>(rows.size()); ++i) {
    const WhyRow& row = rows[static_cast<std::size_t>(i)];
    int found = i;
    while (found < parent->childCount() && parent->child(found)->data(0, kKeyRole).toString() != row.key)
      ++found;
    const bool isNew = found == parent->childCount();
    if (isNew)
      parent->insertChild(i, new QTreeWidgetItem);
    else if (found != i) {
      QTreeWidgetItem* moved = parent->takeChild(found);
      parent->insertChild(i, moved);
    }
    QTreeWidgetItem* item = parent->child(i);
    item->setData(0, kKeyRole, row.key);
    item->setText(WhyTree::What, row.what);
    item->setToolTip(WhyTree::What, row.help);
    item->setText(WhyTree::Value, row.value);
    item->setData(WhyTree::What, WhyTree::kRuleRole, row.rule);
    item->setData(WhyTree::Share, WhyTree::kShareRole, row.share ? QVariant(*row.share) : QVariant());
    item->setText(WhyTree::Share, row.share ? QLocale().toString(*row.share, 'f', 2) : QString());
    put(row.children, item);
    if (isNew) item->setExpanded(row.open);
  }
  while (parent->childCount() > static_cast<int>(rows.size()))
    delete parent->takeChild(parent->childCount() - 1);
}

} // namespace

std::vector<WhyRow> WhyTree::rows(const TissueExplanation& why, const TissueModel& model, Language language)
{
  std::vector<WhyRow> rows;
  if (why.thing.kind != ExplainedThing::Kind::Spring) { // what the sentence is about stands first
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
    if (value.value != value.fromTissue) {
      ExplainedValue other = value;
      other.value = value.fromTissue;
      row.help += QLatin1Char('\n') + tr("By the tissue: %1").arg(toQt(shownNumber(other, language)));
    }
  }
  WhyRow place;
  place.key = QStringLiteral("geometry");
  place.what = why.thing.kind == ExplainedThing::Kind::Tissue ? tr("Tissue") : tr("Geometry and tissue here");
  for (const ExplainedGeometry& fact : why.geometry) {
    WhyRow& row = place.children.emplace_back();
    row.key = QLatin1String(fact.id);
    row.what = QStringLiteral("%1 = %2").arg(QLatin1String(fact.symbol), toQt(fact.name.in(language)));
    row.value = toQt(shownNumber(fact, language));
  }
  for (std::size_t i = 0; i < why.parameters.size(); ++i) {
    const ExplainedValue& value = why.parameters[i];
    const auto isUsed = [&](const OutputReason& output) { return output.parameter == static_cast<int>(i); };
    const auto& used = why.layers.front().outputs;
    if (std::none_of(used.begin(), used.end(), isUsed)) continue;
    WhyRow& row = place.children.emplace_back();
    row.key = key("parameter", static_cast<int>(i));
    const QString symbol = formula(value.kind->formula), name = toQt(value.kind->name.in(language));
    row.what = symbol.size() > 2 || symbol.isEmpty() ? name : symbol + QStringLiteral(" = ") + name;
    row.value = toQt(shownNumber(value, language));
  }
  rows.push_back(std::move(place));

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
    for (const OutputReason& output : layer->outputs) {
      const auto parameter = kTissueOutputs[static_cast<std::size_t>(output.parameter)].value;
      WhyRow& result = row.children.emplace_back();
      result.key = key("output", output.parameter);
      result.what = toQt(shownName(parameter, language));
      result.value = toQt(shownValue(output.value, parameter, language));
      if (!output.fromRules) result.help = tr("No rule fires for it: this is the default.");
      result.open = &output == &layer->outputs.front() && row.open;
      for (const RuleReason& rule : output.rules) {
        WhyRow& reason = result.children.emplace_back();
        reason.key = key("rule", rule.rule);
        reason.what = tr("Rule %1: %2")
                        .arg(rule.rule + 1)
                        .arg(RuleDisplay::sentence(model.rules.rules[static_cast<std::size_t>(rule.rule)],
                                                   model.rules, language));
        reason.help = reason.what + QLatin1Char('\n') +
                      tr("Without this rule: %1").arg(toQt(shownValue(rule.without, parameter, language)));
        reason.share = rule.degree;
        reason.rule = rule.rule;
        reason.open = &rule == &output.rules.front() && result.open;
        for (const int input : rule.inputs)
          reason.children.push_back(inputRow(*layer, input, model, language));
      }
    }
  }
  return rows;
}

void WhyTree::show(const std::vector<WhyRow>& rows, QTreeWidget* tree)
{
  put(rows, tree->invisibleRootItem());
}

} // namespace esm
