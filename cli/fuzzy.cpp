// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "cli/fuzzy.h"

#include "cli/arguments.h"
#include "cli/commands.h"
#include "core/base/file_io.h"
#include "core/base/json_line.h"
#include "core/base/text_number.h"
#include "core/fuzzy/fis/checks.h"
#include "core/fuzzy/fis/files.h"

namespace esm::cli {

namespace {

constexpr const char* kFormats = "FILE.fll (fuzzylite), .fcl (IEC 61131-7) or .fis (MATLAB)";

Result<fis::Format> formatOf(const std::string& file)
{
  if (const auto format = fis::formatOf(file)) return *format;
  return Error{ErrorCode::Unsupported, file + ": the name must end in .fll, .fcl or .fis"};
}

Exit convert(const std::string& from, const std::string& to)
{
  const Result<fis::Format> format = formatOf(to);
  if (!format) return fail(format.error());
  const Result<fis::System> system = readFuzzySystem(from);
  if (!system) return fail(system.error());
  const fis::Written written = fis::writeSystem(*format, *system);
  for (const std::string& loss : written.losses) say(to + " cannot hold: " + loss);
  if (const Status status = writeFileAtomically(to, written.text); !status) return fail(status.error());
  return Exit::Done;
}

JsonLine jsonOf(const fis::Finding& finding, const fis::System& system)
{
  JsonLine line;
  line.add("kind", fis::nameOf(finding.kind));
  line.add("message", finding.message);
  const auto addRule = [&](const std::string& name, fis::RulePlace place) {
    if (place.rule < 0) return;
    line.add(name + "_block", place.block + 1);
    line.add(name, place.rule + 1);
  };
  addRule("rule", finding.rule);
  addRule("other_rule", finding.otherRule);
  if (finding.variable >= 0) {
    const auto place = static_cast<std::size_t>(finding.variable);
    line.add("variable", finding.onOutput ? system.outputs[place].name : system.inputs[place].name);
  }
  if (!finding.witness.empty()) {
    JsonLine witness;
    for (std::size_t i = 0; i < finding.witness.size(); ++i)
      witness.add(system.inputs[i].name, finding.witness[i]);
    line.add("witness", witness);
  }
  return line;
}

Exit check(const std::string& file, bool json)
{
  const Result<fis::System> system = readFuzzySystem(file);
  if (!system) return fail(system.error());
  const auto findings = fis::checkRules(*system);
  if (!json) {
    for (const fis::Finding& finding : findings)
      print(std::string(fis::nameOf(finding.kind)) + ": " + finding.message);
    print(file + ": " + std::string(fis::nameOf(fis::kindOf(*system))) + ", " +
          std::to_string(findings.size()) + " findings");
    return Exit::Done;
  }
  JsonLine line;
  line.add("file", file);
  line.add("kind", fis::nameOf(fis::kindOf(*system)));
  line.add("inputs", system->inputs.size());
  line.add("outputs", system->outputs.size());
  std::size_t rules = 0;
  for (const fis::RuleBlock& block : system->blocks) rules += block.rules.size();
  line.add("rules", rules);
  std::vector<JsonLine> list;
  for (const fis::Finding& finding : findings) list.push_back(jsonOf(finding, *system));
  line.add("findings", list);
  print(line.text());
  return Exit::Done;
}

void addEval(CLI::App& fuzzy, Work& work)
{
  auto options = std::make_shared<FuzzyEvalOptions>();
  CLI::App* command = fuzzy.add_subcommand("eval", "Compute the outputs of a table of inputs");
  command->add_option("FILE", options->file, kFormats)->required();
  command
    ->add_option("--in", options->input,
                 "CSV with the header in:NAME,...; cells are numbers (nan: not given), intervals low..high "
                 "or words (\"very hot\")")
    ->required();
  command->add_option("-o,--output", options->output,
                      "CSV to write: the table with out:NAME columns; else stdout");
  command
    ->add_option("--resolution", options->resolution,
                 "exact (default) areas, or N samples as other programs take")
    ->check([](const std::string& text) {
      const auto number = parseInteger(text);
      const bool good = text == "exact" || (number && *number >= 1 && *number <= 1000000);
      return good ? std::string()
                  : "--resolution takes 'exact' or a whole number from 1 to 1000000, not '" + text + "'";
    });
  command->callback([options, &work] { work = [options] { return evaluateFuzzy(*options); }; });
}

} // namespace

Result<fis::System> readFuzzySystem(const std::string& file)
{
  const Result<fis::Format> format = formatOf(file);
  if (!format) return format.error();
  const Result<std::string> text = readFile(file);
  if (!text) return text.error();
  return fis::readSystem(*format, *text, file);
}

void addFuzzy(CLI::App& program, Work& work)
{
  CLI::App* fuzzy =
    program.add_subcommand("fuzzy", "Evaluate, convert and check fuzzy systems (FLL, FCL, FIS)");
  fuzzy->require_subcommand(1);
  addEval(*fuzzy, work);

  auto names = std::make_shared<std::pair<std::string, std::string>>();
  CLI::App* conversion =
    fuzzy->add_subcommand("convert", "Write a system in another format; says first what that cannot hold");
  conversion->add_option("FROM", names->first, kFormats)->required();
  conversion->add_option("TO", names->second, "the file to write, of the format of its name")->required();
  conversion->callback([names, &work] { work = [names] { return convert(names->first, names->second); }; });

  auto file = std::make_shared<std::string>();
  auto json = std::make_shared<bool>(false);
  CLI::App* checks = fuzzy->add_subcommand(
    "check", "List uncovered inputs, rules that contradict, repeat or never count, and odd terms");
  checks->add_option("FILE", *file, kFormats)->required();
  addJsonFlag(*checks, *json);
  checks->callback([file, json, &work] { work = [file, json] { return check(*file, *json); }; });
}

} // namespace esm::cli
