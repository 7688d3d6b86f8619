// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "cli/arguments.h"

#include "core/base/text_number.h"

#include <cmath>

namespace esm::cli {

namespace {

[[noreturn]] void refuse(const std::string& option, const std::string& text, const std::string& wanted)
{
  throw CLI::ValidationError(option, "\"" + text + "\" is not " + wanted);
}

std::string trimmed(const std::string& text)
{
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

} // namespace

double numberArgument(const std::string& option, const std::string& text, NumberRange range)
{
  const auto value = parseDouble(trimmed(text));
  if (!value || !std::isfinite(*value)) refuse(option, text, "a number (with a point, such as 0.25)");
  if (range == NumberRange::Positive && !(*value > 0.0)) refuse(option, text, "a number > 0");
  if (range == NumberRange::NotNegative && !(*value >= 0.0)) refuse(option, text, "a number >= 0");
  return *value;
}

int integerArgument(const std::string& option, const std::string& text, int least, int most)
{
  const auto number = parseInteger(text);
  if (!number || *number < least || *number > most)
    refuse(option, text, "an integer from " + std::to_string(least) + " to " + std::to_string(most));
  return static_cast<int>(*number);
}

std::vector<double> numbersArgument(const std::string& option, const std::string& text, std::size_t least,
                                    std::size_t most)
{
  std::vector<double> numbers;
  std::size_t start = 0;
  while (start <= text.size()) {
    const std::size_t end = std::min(text.find(',', start), text.size());
    numbers.push_back(numberArgument(option, text.substr(start, end - start)));
    start = end + 1;
  }
  const std::string wanted = std::to_string(least) + (most > least ? " to " + std::to_string(most) : "");
  if (numbers.size() < least || numbers.size() > most)
    refuse(option, text, "a list of " + wanted + " numbers with commas between them");
  return numbers;
}

CLI::Option* addNumber(CLI::App& command, const std::string& name, std::optional<double>& value,
                       const std::string& help, NumberRange range)
{
  return command
    .add_option_function<std::string>(
      name, [&value, name, range](const std::string& text) { value = numberArgument(name, text, range); },
      help)
    ->type_name("NUMBER");
}

CLI::Option* addInteger(CLI::App& command, const std::string& name, std::optional<int>& value,
                        const std::string& help, int least, int most)
{
  const auto read = [&value, name, least, most](const std::string& text) {
    value = integerArgument(name, text, least, most);
  };
  return command.add_option_function<std::string>(name, read, help)->type_name("INTEGER");
}

std::filesystem::path folderOf(const std::filesystem::path& file)
{
  return std::filesystem::absolute(file).parent_path();
}

CLI::Option* addJsonFlag(CLI::App& command, bool& json)
{
  return command.add_flag("--json", json, "print one JSON object as the last line on stdout, on errors too");
}

} // namespace esm::cli
