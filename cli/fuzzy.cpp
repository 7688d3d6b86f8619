// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "cli/fuzzy.h"

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/output_files.h"
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

Exit convert(const FuzzySource& from, const std::string& to)
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

Exit check(const FuzzySource& source, bool json)
{
  std::vector<std::string> notes;
  const Result<fis::System> system = readFuzzySystem(source, notes);
  if (!system) return fail(system.error());
  for (const std::string& note : notes) say(note);
  const auto findings = fis::checkRules(*system);
  if (!json) {
    for (const fis::Finding& finding : findings)
      print(std::string(fis::nameOf(finding.kind)) + ": " + finding.message);
    print(source.file + ": " + std::string(fis::nameOf(fis::kindOf(*system))) + ", " +
          std::to_string(findings.size()) + " findings");
    return Exit::Done;
  }
  JsonLine line;
  line.add("file", source.file);
  line.add("kind", fis::nameOf(fis::kindOf(*system)));
  line.add("inputs", system->inputs.size());
  line.add("outputs", system->outputs.size());
  std::size_t rules = 0;
  for (const fis::RuleBlock& block : system->blocks) rules += block.rules.size();
  line.add("rules", rules);
  std::vector<JsonLine> list;
  for (const fis::Finding& finding : findings) list.push_back(jsonOf(finding, *system));
  line.add("findings", list);
  line.add("notes", notes);
  print(line.text());
  return Exit::Done;
}

void addSource(CLI::App& command, const std::string& name, FuzzySource& source)
{
  command.add_option(name, source.file, kFormats)->required();
  command.add_option("--block", source.block,
                     "name or number of the function block to read, where an FCL file holds several");
}

void addEval(CLI::App& fuzzy, Work& work)
{
  auto options = std::make_shared<FuzzyEvalOptions>();
  CLI::App* command = fuzzy.add_subcommand("eval", "Compute the outputs of a table of inputs");
  addSource(*command, "FILE", options->source);
  command
    ->add_option(
      "--in", options->input,
      "table with the header in:NAME,...; cells are numbers (nan: not given), intervals low..high or "
      "words (\"very hot\"); commas, semicolons or tabs between cells")
    ->required();
  command->add_option("-o,--output", options->output,
                      "the table to write, with out:NAME columns and in the style of --in; else stdout");
  command
    ->add_option(
      "--resolution", options->resolution,
      "exact (default) areas; N samples as other programs take; file: as many as the file says for each "
      "output, 100 where it says nothing")
    ->check([](const std::string& text) {
      const auto number = parseInteger(text);
      const bool good = text == "exact" || text == "file" || (number && *number >= 1 && *number <= 1000000);
      return good
               ? std::string()
               : "--resolution takes 'exact', 'file' or a whole number from 1 to 1000000, not '" + text + "'";
    });
  command->callback([options, &work] {
    keepFilesApart({options->source.file, options->input}, {options->output});
    work = [options] { return evaluateFuzzy(*options); };
  });
}

} // namespace

Result<fis::System> readFuzzySystem(const FuzzySource& source, std::vector<std::string>& notes)
{
  const Result<fis::Format> format = formatOf(source.file);
  if (!format) return format.error();
  const Result<std::string> text = readFile(source.file);
  if (!text) return text.error();
  return fis::readSystem(*format, *text, source.file, {&notes, source.block});
}

Result<fis::System> readFuzzySystem(const FuzzySource& source)
{
  std::vector<std::string> notes;
  Result<fis::System> system = readFuzzySystem(source, notes);
  if (system)
    for (const std::string& note : notes) say(note);
  return system;
}

void addFuzzy(CLI::App& program, Work& work)
{
  CLI::App* fuzzy =
    program.add_subcommand("fuzzy", "Evaluate, convert and check fuzzy systems (FLL, FCL, FIS)");
  fuzzy->require_subcommand(1);
  addEval(*fuzzy, work);

  auto from = std::make_shared<FuzzySource>();
  auto to = std::make_shared<std::string>();
  CLI::App* conversion =
    fuzzy->add_subcommand("convert", "Write a system in another format; says first what that cannot hold");
  addSource(*conversion, "FROM", *from);
  conversion->add_option("TO", *to, "the file to write, of the format of its name")->required();
  conversion->callback([from, to, &work] {
    keepFilesApart({from->file}, {*to});
    work = [from, to] { return convert(*from, *to); };
  });

  auto source = std::make_shared<FuzzySource>();
  auto json = std::make_shared<bool>(false);
  CLI::App* checks = fuzzy->add_subcommand(
    "check", "List uncovered inputs, rules that contradict, repeat or never count, and odd terms");
  addSource(*checks, "FILE", *source);
  addJsonFlag(*checks, *json);
  checks->callback([source, json, &work] { work = [source, json] { return check(*source, *json); }; });
}

} // namespace esm::cli
