// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/csv_reader.h"
#include "core/base/json_line.h"
#include "core/base/text_number.h"
#include "core/tissue/explain_text.h"

namespace esm {

namespace {

const char* kindName(ExplainedThing::Kind kind)
{
  switch (kind) {
  case ExplainedThing::Kind::Spring:
    return "spring";
  case ExplainedThing::Kind::Node:
    return "node";
  case ExplainedThing::Kind::Tissue:
    break;
  }
  return "tissue";
}

const fuzzy::Variable& inputOf(const TissueModel& model, int input)
{
  return model.rules.inputs[static_cast<std::size_t>(input)];
}

std::string ruleTextOf(int rule, const TissueModel& model, Language language)
{
  return formatRule(model.rules.rules[static_cast<std::size_t>(rule)], model.rules, language);
}

void addInput(JsonLine& line, std::string_view key, const fuzzy::InputValue& value,
              const fuzzy::Variable& variable, Language language)
{
  if (const double* number = std::get_if<double>(&value))
    line.add(key, *number);
  else
    line.add(key, formatInput(value, variable, language));
}

JsonLine jsonOf(const ExplainedValue& value)
{
  JsonLine line;
  line.add("value", value.value);
  line.add("from_tissue", value.fromTissue);
  line.add("unit", value.kind->unit);
  line.add("formula", value.kind->formula);
  return line;
}

JsonLine jsonOf(const OutputReason& output, const TissueModel& model, Language language)
{
  JsonLine line;
  line.add("id", kTissueOutputs[static_cast<std::size_t>(output.parameter)].id);
  line.add("value", output.value);
  line.add("from_rules", output.fromRules);
  std::vector<JsonLine> rules;
  for (const RuleReason& rule : output.rules) {
    JsonLine& entry = rules.emplace_back();
    entry.add("rule", rule.rule + 1);
    entry.add("degree", rule.degree);
    entry.add("without", rule.without);
    std::vector<std::string> inputs;
    for (const int input : rule.inputs) inputs.push_back(inputOf(model, input).id);
    entry.add("inputs", inputs);
    entry.add("text", ruleTextOf(rule.rule, model, language));
  }
  line.add("rules", rules);
  return line;
}

JsonLine jsonOf(const LayerReason& layer, const TissueModel& model, Language language)
{
  JsonLine line, inputs;
  line.add("region", layer.layer.region + 1);
  line.add("name", tissueName(layer.layer.region, model, language));
  line.add("share", layer.layer.share);
  line.add("weight", layer.layer.weight);
  for (std::size_t i = 0; i < layer.inputs.size(); ++i) {
    const fuzzy::Variable& variable = inputOf(model, static_cast<int>(i));
    addInput(inputs, variable.id, layer.inputs[i], variable, language);
  }
  line.add("inputs", inputs);
  std::vector<JsonLine> outputs;
  for (const OutputReason& output : layer.outputs) outputs.push_back(jsonOf(output, model, language));
  line.add("outputs", outputs);
  return line;
}

JsonLine jsonOf(const ChangeList& list, const TissueModel& model, Language language)
{
  JsonLine line;
  line.add("of", list.of);
  line.add("factor", list.factor);
  std::vector<JsonLine> inputs;
  for (const InputChange& change : list.changes) {
    const fuzzy::Variable& variable = inputOf(model, change.input);
    JsonLine& entry = inputs.emplace_back();
    entry.add("region", change.region + 1);
    entry.add("input", variable.id);
    addInput(entry, "from", change.from, variable, language);
    entry.add("to", change.to);
    entry.add("reached", change.reached);
    entry.add("factor", change.factor);
    if (change.slope) entry.add("slope", *change.slope);
    entry.add("text", changeText(change, model, language));
  }
  line.add("inputs", inputs);
  return line;
}

/// Rows of the table; see explanationCsv().
class Table {
public:
  struct Row {
    std::string part, region, name, value, other, unit, text;
  };
  void add(const Row& row)
  {
    const std::string* cells[] = {&row.part,  &row.region, &row.name, &row.value,
                                  &row.other, &row.unit,   &row.text};
    for (const std::string* cell : cells) {
      if (cell != cells[0]) m_text += ',';
      m_text += csvCell(*cell, ',');
    }
    m_text += "\r\n";
  }
  const std::string& text() const noexcept { return m_text; }

private:
  std::string m_text = "part,region,name,value,other,unit,text\r\n";
};

std::string inputCell(const fuzzy::InputValue& value, const fuzzy::Variable& variable, Language language)
{
  return formatInput(value, variable, language); // numbers in their exact form, with a point
}

void addLayer(Table& table, const LayerReason& layer, const TissueModel& model, Language language)
{
  const std::string region = std::to_string(layer.layer.region + 1);
  table.add({"layer", region, "share", formatDouble(layer.layer.share), formatDouble(layer.layer.weight), "",
             tissueName(layer.layer.region, model, language)});
  for (const OutputReason& output : layer.outputs) {
    const fuzzy::Variable& variable = model.rules.outputs[static_cast<std::size_t>(output.output)];
    const char* id = kTissueOutputs[static_cast<std::size_t>(output.parameter)].id;
    table.add({"output", region, id, formatDouble(output.value), "", variable.unit,
               output.fromRules ? variable.name.in(language) : "default"});
    for (const RuleReason& rule : output.rules)
      table.add({"rule", region, std::to_string(rule.rule + 1), formatDouble(rule.degree),
                 formatDouble(rule.without), variable.unit, ruleTextOf(rule.rule, model, language)});
  }
  for (std::size_t i = 0; i < layer.inputs.size(); ++i) {
    const fuzzy::Variable& variable = inputOf(model, static_cast<int>(i));
    table.add({"input", region, variable.id, inputCell(layer.inputs[i], variable, language), "", "",
               inputText(layer.inputs[i], variable, language)});
  }
}

} // namespace

std::string explanationJson(const TissueExplanation& why, const TissueModel& model, const ChangeList* changes,
                            Language language)
{
  JsonLine line;
  line.add("format", "esm-explain-1");
  line.add("kind", kindName(why.thing.kind));
  if (why.thing.kind != ExplainedThing::Kind::Tissue) {
    line.add("id", why.id);
    line.add("place", why.place);
    line.add("follows_tissue", why.followsTissue);
  } else {
    line.add("region", why.thing.index + 1);
  }
  if (why.thing.kind == ExplainedThing::Kind::Spring) {
    JsonLine ends;
    ends.add("a", why.nodes[0]);
    ends.add("b", why.nodes[1]);
    line.add("nodes", ends);
  }
  if (why.thing.kind == ExplainedThing::Kind::Node) line.add("fixed", why.isFixed);
  line.add("sentence", sentenceOf(why, model, language));
  line.add("main", why.main().kind->id);
  JsonLine values, parameters, geometry;
  for (const ExplainedValue& value : why.values) values.add(value.kind->id, jsonOf(value));
  for (const ExplainedValue& value : why.parameters) parameters.add(value.kind->id, value.value);
  for (const ExplainedGeometry& fact : why.geometry) geometry.add(fact.id, fact.value);
  line.add("values", values);
  line.add("geometry", geometry);
  line.add("parameters", parameters);
  std::vector<JsonLine> layers;
  for (const LayerReason& layer : why.layers) layers.push_back(jsonOf(layer, model, language));
  line.add("layers", layers);
  if (changes) line.add("change", jsonOf(*changes, model, language));
  return line.text();
}

std::string explanationCsv(const TissueExplanation& why, const TissueModel& model, const ChangeList* changes,
                           Language language)
{
  Table table;
  table.add({"thing", "", kindName(why.thing.kind),
             why.thing.kind == ExplainedThing::Kind::Tissue ? "" : std::to_string(why.id), "", "",
             sentenceOf(why, model, language)});
  for (const ExplainedValue& value : why.values)
    table.add({"value", "", value.kind->id, formatDouble(value.value), formatDouble(value.fromTissue),
               value.kind->unit, value.kind->formula});
  for (const ExplainedGeometry& fact : why.geometry)
    table.add({"geometry", "", fact.id, formatDouble(fact.value), "", fact.unit, fact.symbol});
  for (const ExplainedValue& value : why.parameters)
    table.add({"parameter", "", value.kind->id, formatDouble(value.value), "", value.kind->unit,
               value.kind->name.in(language)});
  for (const LayerReason& layer : why.layers) addLayer(table, layer, model, language);
  if (changes)
    for (const InputChange& change : changes->changes) {
      const fuzzy::Variable& variable = inputOf(model, change.input);
      table.add({"change", std::to_string(change.region + 1), variable.id,
                 inputCell(change.from, variable, language), formatDouble(change.to), "",
                 changeText(change, model, language)});
    }
  return table.text();
}

} // namespace esm
