// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// esm_bench fuzzy: evaluations per second of two rule bases, exact and sampled, beside fuzzylite in the same
// run where its package is installed. CSV: rules, mode, evaluations per second (median), ratio to fuzzylite.
#include "bench/sub_benches.h"
#include "core/fuzzy/fis/evaluator.h"
#include "core/fuzzy/fis/files.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <memory>

#if defined(ESM_BENCH_FUZZYLITE)
#include <fl/Headers.h>
#endif

namespace esm::bench {

namespace {

/// `perInput` triangles on each input, a rule for each combination, 5 triangles on the output: Mamdani,
/// minimum and maximum, centroid of 100 samples.
fis::System gridSystem(int inputs, int perInput, int rules)
{
  fis::System system;
  system.name = "grid";
  const auto partition = [](int count) {
    std::vector<fis::Term> terms;
    for (int i = 0; i < count; ++i) {
      const double step = 1.0 / (count - 1), peak = i * step;
      terms.push_back(
        {"t" + std::to_string(i), fis::Shape::Triangle, {peak - step, peak, peak + step}, 1.0, {}});
    }
    return terms;
  };
  for (int i = 0; i < inputs; ++i) {
    fis::InputVariable input;
    input.name = "in" + std::to_string(i);
    input.minimum = 0.0;
    input.maximum = 1.0;
    input.terms = partition(perInput);
    system.inputs.push_back(std::move(input));
  }
  fis::OutputVariable output;
  output.name = "out";
  output.minimum = 0.0;
  output.maximum = 1.0;
  output.terms = partition(5);
  system.outputs.push_back(std::move(output));
  fis::RuleBlock block;
  block.name = "rules";
  for (int r = 0; r < rules; ++r) {
    fis::Rule rule;
    rule.antecedent.nodes.push_back({fis::Antecedent::Kind::And, {}, {}});
    for (int i = 0, rest = r, sum = 0; i < inputs; ++i, rest /= perInput) {
      rule.antecedent.nodes[0].children.push_back(i + 1);
      rule.antecedent.nodes.push_back(
        {fis::Antecedent::Kind::Proposition, {false, i, rest % perInput, {}}, {}});
      sum += rest % perInput;
      if (i + 1 == inputs) rule.consequents = {{true, 0, sum * 4 / (inputs * (perInput - 1)), {}}};
    }
    block.rules.push_back(std::move(rule));
  }
  system.blocks.push_back(std::move(block));
  return system;
}

/// Evaluations per second: the median of seven goes.
template <class Evaluate>
double rate(int evaluations, const Evaluate& evaluate)
{
  std::array<double, 7> rates{};
  for (double& one : rates) {
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < evaluations; ++i) evaluate(i);
    one = evaluations / std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
  std::nth_element(rates.begin(), rates.begin() + 3, rates.end());
  return rates[3];
}

double place(int evaluation, int input)
{
  const double x = (evaluation % 1009) * (0.6180339887498949 + 0.1 * input);
  return x - static_cast<int>(x);
}

double ourRate(const fis::System& system, fis::Options options, int evaluations, double& sum)
{
  const auto evaluator = fis::Evaluator::create(system, options);
  if (!evaluator) return 0.0;
  fis::Workspace workspace = evaluator->makeWorkspace();
  std::vector<double> row(system.inputs.size());
  return rate(evaluations, [&](int n) {
    for (std::size_t i = 0; i < row.size(); ++i) row[i] = place(n, static_cast<int>(i));
    evaluator->evaluate(row, workspace);
    sum += workspace.outputs()[0].value;
  });
}

double fuzzyliteRate([[maybe_unused]] const fis::System& system, [[maybe_unused]] int evaluations,
                     [[maybe_unused]] double& sum)
{
#if defined(ESM_BENCH_FUZZYLITE)
  const std::unique_ptr<fl::Engine> engine(fl::FllImporter().fromString(fis::writeFll(system).text));
  return rate(evaluations, [&](int n) {
    for (std::size_t i = 0; i < system.inputs.size(); ++i)
      engine->getInputVariable(i)->setValue(place(n, static_cast<int>(i)));
    engine->process();
    sum += engine->getOutputVariable(0)->getValue();
  });
#else
  return 0.0;
#endif
}

void measure(const fis::System& system, int evaluations)
{
  const std::size_t rules = system.blocks[0].rules.size();
  double sum = 0.0, sampledSum = 0.0, theirSum = 0.0;
  const double theirs = fuzzyliteRate(system, std::max(evaluations / 50, 20), theirSum);
  const auto line = [&](const char* mode, double ours) {
    std::printf("%zu,%s,%.0f", rules, mode, ours);
    if (theirs > 0.0) std::printf(",%.1f", ours / theirs);
    std::printf("\n");
  };
  line("sampled 100", ourRate(system, {fis::Options::Area::Sampled, 100}, evaluations, sampledSum));
  line("exact", ourRate(system, {}, evaluations, sum));
  if (theirs > 0.0) line("fuzzylite 100", theirs);
}

} // namespace

int runFuzzy(const std::vector<std::string>& words)
{
  const int share = isQuick(words) ? 10 : 1;
  std::printf("rules,mode,evaluations_per_second,times_fuzzylite\n");
  measure(gridSystem(2, 6, 30), 20000 / share);
  measure(gridSystem(3, 10, 1000), 2000 / share);
  return 0;
}

} // namespace esm::bench
