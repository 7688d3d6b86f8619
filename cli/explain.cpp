// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "cli/arguments.h"
#include "cli/commands.h"
#include "core/base/text_number.h"
#include "core/project/project_io.h"
#include "core/tissue/explain_text.h"
#include "core/tissue/tissue_units.h"

#include <algorithm>
#include <iostream>

namespace esm::cli {

namespace {

struct ExplainOptions {
  std::string file;
  std::optional<int> spring, node, region; ///< the first two by id, the region from 1, 0 the base tissue
  std::optional<double> change;
  std::string of, language = "en";
  bool json = false, csv = false;
};

/// "springs have the ids 0 to 1199", or how many there are between the ends where some are missing.
template <class Id>
std::string whichExist(const char* what, const std::vector<Id>& ids)
{
  if (ids.empty()) return std::string("it has no ") + what;
  const auto [least, most] = std::minmax_element(ids.begin(), ids.end());
  const auto first = static_cast<long long>(*least), last = static_cast<long long>(*most);
  const auto count = static_cast<long long>(ids.size());
  return std::string("its ") + what + " have the ids " + std::to_string(first) + " to " +
         std::to_string(last) + (count == last - first + 1 ? "" : " (" + std::to_string(count) + " of them)");
}

template <class Id>
Result<Index> placeOf(int id, const char* one, const char* many, const std::vector<Id>& ids,
                      const std::string& file)
{
  const auto found = std::find(ids.begin(), ids.end(), static_cast<Id>(id));
  if (found != ids.end()) return static_cast<Index>(found - ids.begin());
  return Error{ErrorCode::InvalidValue,
               file + ": there is no " + one + " " + std::to_string(id) + "; " + whichExist(many, ids)};
}

Result<ExplainedThing> thingOf(const ExplainOptions& options, const Project& project)
{
  using Kind = ExplainedThing::Kind;
  if (options.region) {
    const int regions = static_cast<int>(project.tissue.regions.size());
    if (*options.region > regions)
      return Error{ErrorCode::InvalidValue, options.file + ": there is no region " +
                                              std::to_string(*options.region) + "; it has " +
                                              std::to_string(regions) + ", and 0 is the base tissue"};
    return ExplainedThing{Kind::Tissue, static_cast<Index>(*options.region - 1)};
  }
  const Result<Index> place =
    options.spring ? placeOf(*options.spring, "spring", "springs", project.net.springId, options.file)
                   : placeOf(*options.node, "node", "nodes", project.net.nodeId, options.file);
  if (!place) return place.error();
  return ExplainedThing{options.spring ? Kind::Spring : Kind::Node, *place};
}

/// Which number --change is about.
Result<const ExplainedValue*> wantedValue(const ExplainOptions& options, const TissueExplanation& why)
{
  if (options.of.empty()) return &why.main();
  if (const ExplainedValue* value = why.find(options.of)) return value;
  std::string known;
  for (const auto* list : {&why.values, &why.parameters})
    for (const ExplainedValue& value : *list)
      if (known.find(value.kind->id) == std::string::npos)
        known += (known.empty() ? "" : ", ") + std::string(value.kind->id);
  return Error{ErrorCode::InvalidValue, "there is no number \"" + options.of + "\" here; there are " + known};
}

void printChain(const TissueExplanation& why, const TissueModel& model, const ChangeList* changes,
                Language language)
{
  print(sentenceOf(why, model, language));
  for (const ExplainedValue& value : why.values) {
    const std::string unit = *value.kind->unit ? std::string(" ") + value.kind->unit : "";
    print(
      "  " + value.kind->name.in(language) + " = " + value.kind->formula + " = " + formatDouble(value.value) +
      unit +
      (value.value == value.fromTissue ? "" : "   (by the tissue " + formatDouble(value.fromTissue) + ")"));
  }
  for (const ExplainedGeometry& fact : why.geometry)
    print("  " + std::string(fact.symbol) + " = " + formatDouble(fact.value) + " " + fact.unit + "   " +
          fact.name.in(language));
  for (const LayerReason& layer : why.layers) {
    print(shareText(layer.layer.share) + " " + tissueName(layer.layer.region, model, language));
    for (const OutputReason& output : layer.outputs) {
      const auto parameter = kTissueOutputs[static_cast<std::size_t>(output.parameter)].value;
      print("  " + shownName(parameter, language) + " " + shownValue(output.value, parameter, language) +
            (output.fromRules ? "" : "   (default)"));
      for (const RuleReason& rule : output.rules) {
        print("    " + formatDouble(rule.degree, 3) + "  " + std::to_string(rule.rule + 1) + ": " +
              formatRule(model.rules.rules[static_cast<std::size_t>(rule.rule)], model.rules, language));
        for (const int input : rule.inputs) {
          const fuzzy::Variable& variable = model.rules.inputs[static_cast<std::size_t>(input)];
          print("          " + variable.name.in(language) + " " +
                inputText(layer.inputs[static_cast<std::size_t>(input)], variable, language));
        }
      }
    }
  }
  if (!changes) return;
  print(changes->of + " x " + formatDouble(changes->factor));
  for (const InputChange& change : changes->changes) print("  " + changeText(change, model, language));
  if (changes->changes.empty()) print("  no input changes it");
}

Exit explain(const ExplainOptions& options)
{
  const Result<Project> project = loadProject(options.file);
  if (!project) return fail(project.error());
  const Result<ExplainedThing> thing = thingOf(options, *project);
  if (!thing) return fail(thing.error());
  const Result<TissueField> field = TissueField::create(project->tissue);
  if (!field) return fail(field.error());
  const TissueExplanation why =
    TissueExplainer(project->net).explain(*field, project->net, *thing, project->parametersFromTissue);
  std::optional<ChangeList> changes;
  const Result<const ExplainedValue*> value = wantedValue(options, why);
  if (!value) return fail(value.error());
  if (options.change)
    changes = {(*value)->kind->id, *options.change, changesFor(*field, why, **value, *options.change)};
  const ChangeList* list = changes ? &*changes : nullptr;
  const Language language = options.language == "de" ? Language::German : Language::English;
  if (options.json)
    print(explanationJson(why, project->tissue, list, language));
  else if (options.csv)
    std::cout << explanationCsv(why, project->tissue, list, language) << std::flush;
  else
    printChain(why, project->tissue, list, language);
  return Exit::Done;
}

} // namespace

void addExplain(CLI::App& program, Work& work)
{
  auto options = std::make_shared<ExplainOptions>();
  CLI::App* command = program.add_subcommand(
    "explain", "Say why a spring or a node has its numbers: geometry, regions, rules, inputs");
  command->add_option("PROJECT", options->file, ".esm, .esmb or net.json")->required();
  CLI::Option_group* thing = command->add_option_group("what");
  addInteger(*thing, "--spring", options->spring, "the spring of this id", 0,
             std::numeric_limits<int>::max());
  addInteger(*thing, "--node", options->node, "the node of this id", 0, std::numeric_limits<int>::max());
  addInteger(*thing, "--region", options->region, "a region's tissue, from 1; 0 is the base tissue", 0,
             std::numeric_limits<int>::max());
  thing->require_option(1);
  addNumber(*command, "--change", options->change,
            "also say which inputs would make it so many times as large (0.8: 20 % softer)",
            NumberRange::Positive);
  command->add_option("--of", options->of,
                      "which number --change is about, by id (default: stiffness of a spring, youngs_modulus "
                      "of a node)");
  command->add_option("--lang", options->language, "en or de, of names and texts")
    ->check(CLI::IsMember({"en", "de"}));
  CLI::Option* json = addJsonFlag(*command, options->json);
  command->add_flag("--csv", options->csv, "print a table (RFC 4180)")->excludes(json);
  command->footer("Example:\n  esm explain uterus.esm --spring 812 --change 0.8\n\n"
                  "The object of --json: docs/explain.schema.json; the table of --csv: docs/TISSUE.md.");
  command->callback([options, &work] { work = [options] { return explain(*options); }; });
}

} // namespace esm::cli
