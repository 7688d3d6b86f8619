// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "cli/fuzzy.h"

#include "core/base/csv_reader.h"
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
  const std::size_t from = text.find_first_not_of(' ');
  if (from == std::string_view::npos) return {};
  return text.substr(from, text.find_last_not_of(' ') - from + 1);
}

/// A table of inputs turned into one of inputs and outputs, in the same style: separator, decimal sign.
class Table {
public:
  Table(const fis::Evaluator& evaluator, CsvReader reader)
    : m_evaluator(evaluator),
      m_workspace(evaluator.makeWorkspace()),
      m_reader(std::move(reader)),
      m_inputs(evaluator.system().inputs.size()),
      m_hedges(m_inputs.size()),
      m_column(m_inputs.size(), kMissing)
  {}

  Result<std::string> fill()
  {
    if (const Status status = findColumns(); !status) return status.error();
    for (;;) {
      CsvRow row;
      const Result<bool> more = m_reader.next(row);
      if (!more) return more.error();
      if (!*more) return text();
      if (const Status status = evaluate(row); !status) return status.error();
      m_rows.push_back(std::move(row.cells));
    }
  }

private:
  static constexpr std::size_t kMissing = static_cast<std::size_t>(-1);

  Status findColumns()
  {
    const auto& inputs = m_evaluator.system().inputs;
    const CsvRow& header = m_reader.header();
    for (std::size_t c = 0; c < header.cells.size(); ++c) {
      const std::string_view cell = header.cells[c];
      if (!cell.starts_with("in:")) continue; // other columns are carried along
      const std::string_view name = trimmed(cell.substr(3));
      const auto input =
        std::find_if(inputs.begin(), inputs.end(), [&](const auto& i) { return i.name == name; });
      if (input == inputs.end())
        return m_reader.error(header, c, "the system has no input '" + std::string(name) + "'");
      std::size_t& column = m_column[static_cast<std::size_t>(input - inputs.begin())];
      if (column != kMissing) return m_reader.error(header, c, "the input occurs twice");
      column = c;
    }
    for (std::size_t i = 0; i < inputs.size(); ++i)
      if (m_column[i] == kMissing)
        return m_reader.error(header, header.cells.size(), "the column in:" + inputs[i].name + " is missing");
    return {};
  }

  Status evaluate(const CsvRow& row)
  {
    for (std::size_t i = 0; i < m_inputs.size(); ++i) {
      const std::string& cell = row.cells[m_column[i]];
      std::string why;
      if (readCell(cell, i, why)) continue;
      if (why.empty())
        why = "'" + cell.substr(0, 60) + "' is no number, no interval low..high and no term of '" +
              m_evaluator.system().inputs[i].name + "'";
      return m_reader.error(row, m_column[i], why);
    }
    m_workspace.restart(); // each row by itself
    m_evaluator.evaluate(std::span<const fis::Input>(m_inputs), m_workspace);
    for (const fis::OutputResult& result : m_workspace.outputs()) m_results.push_back(result.value);
    return {};
  }

  /// Only at the end is the decimal sign known: "5" may stand before "2,5".
  std::string text() const
  {
    const char separator = m_reader.separatorToWrite();
    const auto& outputs = m_evaluator.system().outputs;
    std::string text;
    const auto add = [&](const std::vector<std::string>& cells) {
      for (std::size_t i = 0; i < cells.size(); ++i)
        text += (i == 0 ? "" : std::string(1, separator)) + csvCell(cells[i], separator);
    };
    add(m_reader.header().cells);
    for (const auto& output : outputs) text += separator + csvCell("out:" + output.name, separator);
    text += '\n';
    for (std::size_t r = 0; r < m_rows.size(); ++r) {
      add(m_rows[r]);
      for (std::size_t o = 0; o < outputs.size(); ++o)
        text += separator + csvCell(numberText(m_results[r * outputs.size() + o]), separator);
      text += '\n';
    }
    return text;
  }

  std::string numberText(double value) const
  {
    std::string text = std::isnan(value) ? "nan" : formatDouble(value, 17);
    if (m_reader.decimalComma()) std::replace(text.begin(), text.end(), '.', ',');
    return text;
  }

  /// "0.5", "0.2..0.4" or "very hot". @param why is set where it is clear what is wrong
  bool readCell(std::string_view cell, std::size_t input, std::string& why)
  {
    using Kind = CsvNumber::Kind;
    const std::size_t dots = cell.find("..");
    const CsvNumber low = m_reader.number(trimmed(cell.substr(0, dots)));
    why = low.why;
    if (low.kind == Kind::Unclear) return false;
    if (dots == std::string_view::npos) {
      if (low.kind == Kind::Text) return readWord(cell, input);
      m_inputs[input] = fis::Input::number(low.value);
      return true;
    }
    const CsvNumber high = m_reader.number(trimmed(cell.substr(dots + 2)));
    why = high.why;
    if (low.kind != Kind::Number || high.kind != Kind::Number || !(low.value <= high.value)) return false;
    m_inputs[input] = fis::Input::interval(low.value, high.value);
    return true;
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
  CsvReader m_reader;
  std::vector<fis::Input> m_inputs;
  std::vector<std::vector<fis::Hedge>> m_hedges;
  std::vector<std::size_t> m_column; ///< per input
  std::vector<std::vector<std::string>> m_rows;
  std::vector<double> m_results; ///< row by row, one per output
};

Result<std::string> evaluated(const fis::Evaluator& evaluator, const std::string& file)
{
  const Result<std::string> bytes = readFile(file);
  if (!bytes) return bytes.error();
  Result<CsvReader> reader = CsvReader::open(*bytes, file);
  if (!reader) return reader.error();
  return Table(evaluator, std::move(*reader)).fill();
}

} // namespace

Exit evaluateFuzzy(const FuzzyEvalOptions& options)
{
  fis::Options mode;
  if (options.resolution != "exact") mode.area = fis::Options::Area::Sampled;
  if (const auto samples = parseInteger(options.resolution)) mode.resolution = static_cast<int>(*samples);
  Result<fis::System> system = readFuzzySystem(options.source);
  if (!system) return fail(system.error());
  const auto evaluator = fis::Evaluator::create(std::move(*system), mode);
  if (!evaluator) return fail(evaluator.error());
  const Result<std::string> table = evaluated(*evaluator, options.input);
  if (!table) return fail(table.error());
  if (options.output.empty()) {
    std::fwrite(table->data(), 1, table->size(), stdout);
    return Exit::Done;
  }
  if (const Status status = writeFileAtomically(options.output, *table); !status) return fail(status.error());
  return Exit::Done;
}

} // namespace esm::cli
