// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "cli/fuzzy.h"

#include "core/base/file_io.h"
#include "core/base/text_number.h"
#include "core/fuzzy/fis/evaluator.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace esm::cli {

namespace {

std::string_view trimmed(std::string_view text)
{
  const std::size_t from = text.find_first_not_of(" \t\r");
  if (from == std::string_view::npos) return {};
  return text.substr(from, text.find_last_not_of(" \t\r") - from + 1);
}

std::vector<std::string_view> split(std::string_view line)
{
  std::vector<std::string_view> cells;
  for (std::size_t from = 0; from <= line.size();) {
    const std::size_t to = std::min(line.find(',', from), line.size());
    cells.push_back(trimmed(line.substr(from, to - from)));
    from = to + 1;
  }
  return cells;
}

/// A table of inputs turned into one of inputs and outputs, row by row.
class Table {
public:
  Table(const fis::Evaluator& evaluator, const std::string& file)
    : m_evaluator(evaluator),
      m_workspace(evaluator.makeWorkspace()),
      m_file(file),
      m_inputs(evaluator.system().inputs.size()),
      m_hedges(m_inputs.size()),
      m_column(m_inputs.size(), kMissing)
  {}

  Result<std::string> fill(std::string_view text)
  {
    if (text.substr(0, 3) == "\xEF\xBB\xBF") text.remove_prefix(3);
    int number = 0;
    for (std::size_t from = 0; from < text.size();) {
      const std::size_t to = std::min(text.find('\n', from), text.size());
      const std::string_view line = trimmed(text.substr(from, to - from));
      from = to + 1;
      ++number;
      if (line.empty()) continue;
      if (Status status = m_width == 0 ? readHeader(line, number) : readRow(line, number); !status)
        return status.error();
    }
    if (m_width == 0)
      return Error{ErrorCode::EmptyResult, m_file + ": holds no header such as in:" + firstName()};
    return std::move(m_text);
  }

private:
  static constexpr std::size_t kMissing = static_cast<std::size_t>(-1);

  std::string firstName() const
  {
    return m_inputs.empty() ? "name" : m_evaluator.system().inputs.front().name;
  }
  Error wrong(int line, std::size_t column, const std::string& what) const
  {
    return {ErrorCode::BadFormat,
            m_file + ':' + std::to_string(line) + ": column " + std::to_string(column + 1) + ": " + what};
  }

  Status readHeader(std::string_view line, int number)
  {
    const auto cells = split(line);
    const auto& inputs = m_evaluator.system().inputs;
    for (std::size_t c = 0; c < cells.size(); ++c) {
      if (cells[c].substr(0, 3) != "in:") continue; // other columns are carried along
      const auto input = std::find_if(inputs.begin(), inputs.end(),
                                      [&](const auto& i) { return i.name == cells[c].substr(3); });
      if (input == inputs.end())
        return wrong(number, c, "the system has no input '" + std::string(cells[c].substr(3)) + "'");
      std::size_t& column = m_column[static_cast<std::size_t>(input - inputs.begin())];
      if (column != kMissing) return wrong(number, c, "the input occurs twice");
      column = c;
    }
    for (std::size_t i = 0; i < inputs.size(); ++i)
      if (m_column[i] == kMissing)
        return wrong(number, cells.size(), "the column in:" + inputs[i].name + " is missing");
    m_width = cells.size();
    m_text = line;
    for (const auto& output : m_evaluator.system().outputs) m_text += ",out:" + output.name;
    m_text += '\n';
    return {};
  }

  Status readRow(std::string_view line, int number)
  {
    const auto cells = split(line);
    if (cells.size() != m_width)
      return wrong(number, std::min(cells.size(), m_width),
                   "the row has " + std::to_string(cells.size()) + " cells, the header " +
                     std::to_string(m_width));
    for (std::size_t i = 0; i < m_inputs.size(); ++i)
      if (!readCell(cells[m_column[i]], i))
        return wrong(number, m_column[i],
                     "'" + std::string(cells[m_column[i]].substr(0, 60)) +
                       "' is no number, no interval low..high and no term of '" +
                       m_evaluator.system().inputs[i].name + "'");
    m_workspace.restart(); // each row by itself
    m_evaluator.evaluate(std::span<const fis::Input>(m_inputs), m_workspace);
    m_text += line;
    for (const fis::OutputResult& result : m_workspace.outputs())
      m_text += ',' + (std::isnan(result.value) ? "nan" : formatDouble(result.value, 17));
    m_text += '\n';
    return {};
  }

  /// "0.5", "0.2..0.4" or "very hot".
  bool readCell(std::string_view cell, std::size_t input)
  {
    if (const auto number = parseDouble(cell)) {
      m_inputs[input] = fis::Input::number(*number);
      return true;
    }
    if (const std::size_t dots = cell.find(".."); dots != std::string_view::npos) {
      const auto low = parseDouble(trimmed(cell.substr(0, dots))),
                 high = parseDouble(trimmed(cell.substr(dots + 2)));
      if (!low || !high || !(*low <= *high)) return false;
      m_inputs[input] = fis::Input::interval(*low, *high);
      return true;
    }
    return readWord(cell, input);
  }

  bool readWord(std::string_view cell, std::size_t input)
  {
    m_hedges[input].clear();
    for (;;) {
      const std::size_t end = std::min(cell.find(' '), cell.size());
      const std::string_view word = cell.substr(0, end);
      cell = trimmed(cell.substr(end));
      if (const auto hedge = fis::hedgeNamed(word)) {
        m_hedges[input].push_back(*hedge);
        continue;
      }
      for (const fis::Term& term : m_evaluator.system().inputs[input].terms) {
        if (term.name != word || !cell.empty() || fis::isNumber(term.shape)) continue;
        m_inputs[input] = fis::Input::word(term, m_hedges[input]);
        return true;
      }
      return false;
    }
  }

  const fis::Evaluator& m_evaluator;
  fis::Workspace m_workspace;
  std::string m_file;
  std::vector<fis::Input> m_inputs;
  std::vector<std::vector<fis::Hedge>> m_hedges;
  std::vector<std::size_t> m_column; ///< per input
  std::size_t m_width = 0;
  std::string m_text;
};

} // namespace

Exit evaluateFuzzy(const FuzzyEvalOptions& options)
{
  fis::Options mode;
  if (options.resolution != "exact") {
    mode.area = fis::Options::Area::Sampled;
    mode.resolution = static_cast<int>(*parseInteger(options.resolution)); // checked by the parser
  }
  Result<fis::System> system = readFuzzySystem(options.file);
  if (!system) return fail(system.error());
  const auto evaluator = fis::Evaluator::create(std::move(*system), mode);
  if (!evaluator) return fail(evaluator.error());
  const Result<std::string> rows = readFile(options.input);
  if (!rows) return fail(rows.error());
  const Result<std::string> table = Table(*evaluator, options.input).fill(*rows);
  if (!table) return fail(table.error());
  if (options.output.empty()) {
    std::fwrite(table->data(), 1, table->size(), stdout);
    return Exit::Done;
  }
  if (const Status status = writeFileAtomically(options.output, *table); !status) return fail(status.error());
  return Exit::Done;
}

} // namespace esm::cli
