// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/tissue/explain_text.h"

#include "core/base/text_number.h"
#include "core/fuzzy/axis.h"
#include "core/fuzzy/words.h"
#include "core/tissue/tissue_units.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace esm {

namespace {

std::string say(Language language, const char* english, const char* german)
{
  return language == Language::German ? german : english;
}

/// "%1", "%2" ... replaced by the arguments.
std::string filled(std::string text, const std::vector<std::string>& arguments)
{
  for (std::size_t i = arguments.size(); i-- > 0;) {
    const std::string mark = "%" + std::to_string(i + 1);
    if (const std::size_t at = text.find(mark); at != std::string::npos)
      text.replace(at, mark.size(), arguments[i]);
  }
  return text;
}

std::string withMark(std::string number, Language language)
{
  if (language == Language::German) std::replace(number.begin(), number.end(), '.', ',');
  return number;
}

std::string degreeText(double degree, Language language)
{
  char buffer[64];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, degree, std::chars_format::fixed, 2);
  return withMark(std::string(buffer, end.ptr), language);
}

std::string numberText(double number, Language language)
{
  return withMark(formatDouble(number, 4), language);
}

/// "rule 3: IF ... THEN ..., fires 0.70"
std::string ruleText(const OutputReason& output, const TissueModel& model, Language language)
{
  if (output.rules.empty())
    return say(language, "no rule fires for it: the default", "keine Regel feuert dafür: die Voreinstellung");
  const RuleReason& strongest = output.rules.front();
  const fuzzy::Rule& rule = model.rules.rules[static_cast<std::size_t>(strongest.rule)];
  return filled(say(language, "rule %1: %2, fires %3", "Regel %1: %2, feuert mit %3"),
                {std::to_string(strongest.rule + 1), formatRule(rule, model.rules, language),
                 degreeText(strongest.degree, language)});
}

/// The layers, the largest share first, that one with its rule.
std::string causeText(const TissueExplanation& why, const TissueModel& model, Language language)
{
  std::vector<const LayerReason*> layers;
  for (const LayerReason& layer : why.layers) layers.push_back(&layer);
  std::stable_sort(layers.begin(), layers.end(), [](const LayerReason* a, const LayerReason* b) {
    return a->layer.share > b->layer.share;
  });
  if (why.thing.kind == ExplainedThing::Kind::Tissue)
    return ruleText(layers.front()->outputs.front(), model, language);
  std::string text;
  for (const LayerReason* layer : layers) {
    if (!text.empty()) text += ", ";
    text += shareText(layer->layer.share) + ' ' + tissueName(layer->layer.region, model, language);
    if (layer == layers.front()) text += " (" + ruleText(layer->outputs.front(), model, language) + ')';
  }
  return text;
}

std::string headText(const TissueExplanation& why, const TissueModel& model, Language language)
{
  const ExplainedValue& main = why.main();
  const std::string thing = thingName(why, model, language), number = shownNumber(main, language);
  if (why.thing.kind == ExplainedThing::Kind::Node)
    return filled(say(language, "%1 lies in tissue of %2", "%1 liegt in Gewebe von %2"), {thing, number});
  if (why.thing.kind == ExplainedThing::Kind::Spring && main.value != main.fromTissue) {
    ExplainedValue wouldBe = main;
    wouldBe.value = main.fromTissue;
    return filled(why.followsTissue ? say(language, "%1 has %2, while its tissue now gives %3",
                                          "%1 hat %2, während ihr Gewebe jetzt %3 ergibt")
                                    : say(language, "%1 keeps %2 from its file, while its tissue gives %3",
                                          "%1 behält %2 aus ihrer Datei, während ihr Gewebe %3 ergibt"),
                  {thing, number, shownNumber(wouldBe, language)});
  }
  return filled(say(language, "%1 has %2", "%1 hat %2"), {thing, number});
}

std::string tailText(const TissueExplanation& why, Language language)
{
  std::string text;
  const auto add = [&](const std::string& name, const std::string& number) {
    text += (text.empty() ? "; " : ", ") + name + ' ' + number;
  };
  for (const ExplainedGeometry& fact : why.geometry)
    if (const std::string_view id = fact.id; id != "thickness" && !id.starts_with("learned"))
      add(fact.name.in(language), shownNumber(fact, language));
  if (why.thing.kind == ExplainedThing::Kind::Node)
    add(why.values.front().kind->name.in(language), shownNumber(why.values.front(), language));
  return text;
}

/// "; x 1.83 learned (12 recordings; edges, 0-30 degrees to the surface's normal, +- 8 %)"
std::string learnedText(const TissueExplanation& why, const TissueModel& model, Language language)
{
  if (why.learned.reasons.empty()) return {};
  const LearnedLayer& layer = model.learned;
  std::string reasons;
  for (const LearnedReason& reason : why.learned.reasons) {
    if (reason.factor < 0) {
      reasons += say(language, "; this spring alone", "; diese Feder allein");
      continue;
    }
    const LearnedFactor& factor = layer.factors[static_cast<std::size_t>(reason.factor)];
    const bool isBed = factor.quantity == LearnedQuantity::Anchor;
    reasons += "; " + (!factor.region.empty() ? say(language, "region ", "Region ") + factor.region
                       : isBed                ? say(language, "the bed", "das Bett")
                                              : classText(factor.of, layer.questions, language));
    if (factor.quantity == LearnedQuantity::LawParameter) {
      reasons +=
        ", b " + std::string(reason.value < 0.0 ? "- " : "+ ") + numberText(std::abs(reason.value), language);
      if (factor.isSeen) reasons += " ± " + withMark(formatDouble(factor.deviation, 2), language);
    } else if (factor.isSeen && factor.deviation > 0.0) {
      reasons +=
        ", ± " + withMark(formatDouble(100.0 * std::expm1(factor.deviation), 2), language) + "\u00a0%";
    }
    if (!factor.isSeen) reasons += say(language, ", not seen in the data", ", in den Daten nicht gesehen");
  }
  const std::string count = std::to_string(layer.recordings);
  return filled(layer.recordings == 1
                  ? say(language, "; × %1 learned (1 recording%2)", "; × %1 gelernt (1 Aufnahme%2)")
                  : say(language, "; × %1 learned (%3 recordings%2)", "; × %1 gelernt (%3 Aufnahmen%2)"),
                {withMark(formatDouble(why.learned.factor, 3), language), reasons, count});
}

} // namespace

std::string sentenceOf(const TissueExplanation& why, const TissueModel& model, Language language)
{
  std::string text = headText(why, model, language) + ": " + causeText(why, model, language) +
                     tailText(why, language) + learnedText(why, model, language) + '.';
  text[0] = static_cast<char>(text[0] >= 'a' && text[0] <= 'z' ? text[0] - 'a' + 'A' : text[0]);
  return text;
}

std::string thingName(const TissueExplanation& why, const TissueModel& model, Language language)
{
  switch (why.thing.kind) {
  case ExplainedThing::Kind::Spring:
    return filled(say(language, "Spring %1", "Feder %1"), {std::to_string(why.id)});
  case ExplainedThing::Kind::Node:
    return filled(say(language, "Node %1", "Knoten %1"), {std::to_string(why.id)});
  case ExplainedThing::Kind::Tissue:
    break;
  }
  return tissueName(why.thing.index, model, language);
}

std::string tissueName(int region, const TissueModel& model, Language language)
{
  if (region < 0) return say(language, "base tissue", "Grundgewebe");
  const std::string& name = model.regions[static_cast<std::size_t>(region)].name;
  const std::string kind = say(language, "region", "Region");
  if (name.empty()) return kind + ' ' + std::to_string(region + 1);
  return fuzzy::foldCase(name).starts_with("region") ? name : kind + ' ' + name;
}

std::string shareText(double share)
{
  const double percent = std::round(100.0 * share);
  const std::string number = share > 0.0 && percent < 1.0    ? "<1"
                             : share < 1.0 && percent > 99.0 ? ">99"
                                                             : std::to_string(static_cast<int>(percent));
  return number + "\u00a0%";
}

std::string shownNumber(const ExplainedValue& value, Language language)
{
  return shownNumber(value.value, {value.kind->perShown, value.kind->shownUnit}, language);
}

std::string shownNumber(const ExplainedGeometry& fact, Language language)
{
  return shownNumber(fact.value, {fact.perShown, fact.shownUnit}, language);
}

std::string inputText(const fuzzy::InputValue& value, const fuzzy::Variable& variable, Language language)
{
  const double* number = std::get_if<double>(&value);
  if (!number) return formatInput(value, variable, language);
  std::vector<std::pair<double, const fuzzy::Term*>> words;
  for (const fuzzy::Term& term : variable.terms)
    if (const double degree = membership(term, toAxis(variable, *number)); degree >= 0.005)
      words.emplace_back(degree, &term);
  std::stable_sort(words.begin(), words.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::string text;
  for (const auto& [degree, term] : words)
    text += (text.empty() ? " (" : ", ") + term->name.in(language) + ' ' + degreeText(degree, language);
  return numberText(*number, language) + text + (text.empty() ? "" : ")");
}

std::string changeText(const InputChange& change, const TissueModel& model, Language language)
{
  const fuzzy::Variable& variable = model.rules.inputs[static_cast<std::size_t>(change.input)];
  const double* number = std::get_if<double>(&change.from);
  const std::string from =
    number ? numberText(*number, language) : "“" + formatInput(change.from, variable, language) + "”";
  const std::string to = withMark(formatDouble(change.to, 6), language);
  const std::string head = filled(say(language, "%1 of %2", "%1 (%2)"),
                                  {variable.name.in(language), tissueName(change.region, model, language)});
  if (change.reached) return head + ": " + from + " → " + to;
  if (number && *number == change.to)
    return head + say(language, ": cannot do it, here it only moves the other way",
                      ": kann es nicht, es führt von hier nur in die andere Richtung");
  return head + filled(say(language, ": cannot do it alone; %1 → %2 gives × %3",
                           ": kann es allein nicht; %1 → %2 gibt × %3"),
                       {from, to, withMark(formatDouble(change.factor, 3), language)});
}

} // namespace esm
