// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "cli/rules_file.h"

#include "core/base/file_io.h"
#include "core/project/project_io.h"

namespace esm::cli {

namespace {

std::string explain(const fuzzy::RuleTextError& error, std::string_view line)
{
  std::string text = error.message;
  if (error.length > 0 && error.offset + error.length <= line.size())
    text += " (at \"" + std::string(line.substr(error.offset, error.length)) + "\")";
  if (!error.suggestion.empty()) text += "; did you mean \"" + error.suggestion + "\"?";
  return text;
}

std::string_view lineOf(std::string_view text, int number)
{
  for (; number > 1 && !text.empty(); --number)
    text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
  return text.substr(0, text.find('\n'));
}

bool isProject(std::string_view bytes)
{
  const std::size_t start = bytes.find_first_not_of(" \t\r\n");
  return start != std::string_view::npos &&
         (bytes[start] == '{' || static_cast<unsigned char>(bytes[0]) >= 0x80) &&
         bytes.find("esm-project") != std::string_view::npos;
}

} // namespace

Status takeRules(const std::string& file, TissueModel& tissue)
{
  const Result<std::string> bytes = readFile(file);
  if (!bytes) return bytes.error();
  if (isProject(*bytes)) {
    const Result<Project> project = parseProject(*bytes, file);
    if (!project) return project.error();
    const bool sameInputs = project->tissue.rules.inputs == tissue.rules.inputs;
    tissue.rules = project->tissue.rules;
    if (!sameInputs) {
      tissue.inputs = project->tissue.inputs;
      for (Region& region : tissue.regions) region.inputs = tissue.inputs;
    }
    return {};
  }
  auto parsed = fuzzy::parseRules(*bytes, tissue.rules);
  if (const auto* fault = std::get_if<fuzzy::RuleLineError>(&parsed))
    return Error{ErrorCode::InvalidValue, file + ":" + std::to_string(fault->line) + ": " +
                                            explain(fault->error, lineOf(*bytes, fault->line))};
  tissue.rules.rules = std::move(std::get<0>(parsed));
  if (tissue.rules.rules.empty()) return Error{ErrorCode::EmptyResult, file + ": holds no rule"};
  return {};
}

Result<fuzzy::Rule> readRule(const std::string& text, const fuzzy::RuleBase& rules)
{
  auto parsed = fuzzy::parseRule(text, rules);
  if (const auto* fault = std::get_if<fuzzy::RuleTextError>(&parsed))
    return Error{ErrorCode::InvalidValue, "the rule \"" + text + "\": " + explain(*fault, text)};
  return std::get<fuzzy::Rule>(std::move(parsed));
}

} // namespace esm::cli
