// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/learning/learn.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace esm::learning {
namespace {

/// The net with the tissue's own numbers, nothing learned.
Result<SpringNet> untaught(TissueModel tissue, SpringNet net)
{
  tissue.learned = {};
  if (const auto applied = applyTissue(tissue, net); !applied) return applied.error();
  return net;
}

Result<std::vector<Parameter>> parametersFor(const std::vector<std::string>& what, const BlockSource& source)
{
  std::vector<Parameter> all;
  for (const std::string& id : what) {
    const ParameterBlock* block = findBlock(id);
    if (block == nullptr) {
      std::string known;
      for (const ParameterBlock& one : parameterBlocks())
        known.append(known.empty() ? "" : ", ").append(one.id);
      return invalidValue(
        std::string("\"").append(id).append("\" cannot be learned; there are ").append(known));
    }
    auto parameters = block->make(source);
    if (!parameters) return parameters.error();
    for (Parameter& parameter : *parameters) all.push_back(std::move(parameter));
  }
  return all;
}

Result<std::vector<Experiment>> experimentsOf(const SpringNet& net, const std::vector<Recording>& recordings)
{
  std::vector<Experiment> experiments;
  for (const Recording& recording : recordings) {
    auto experiment = Experiment::create(net, recording);
    if (!experiment) return experiment.error();
    experiments.push_back(std::move(*experiment));
  }
  return experiments;
}

double errorThatDecides(const FitReport& report)
{
  return report.validationBefore > 0.0 ? report.validationAfter : report.trainingAfter;
}

void addNotes(const FitReport& report, const ParameterSet& set, std::vector<std::string>& notes)
{
  for (const Ambiguity& ambiguity : report.ambiguities) notes.push_back(textOf(ambiguity, set));
  for (const FitCase& one : report.cases)
    if (!one.isUsed)
      notes.push_back(one.name +
                      " was set aside: the net snaps under its load at the start, even eight times stiffer");
}

/// One stage; empty notes for what nobody asked about.
Result<FitReport> stage(const SpringNet& net, const ParameterSet& set, std::vector<Experiment>& training,
                        std::vector<Experiment>& validation, const FitSettings& settings)
{
  for (Experiment& experiment : training) experiment.restart();
  for (Experiment& experiment : validation) experiment.restart();
  return fit(net, set, training, validation, settings);
}

} // namespace

Result<LearnResult> learn(const TissueModel& tissue, const SpringNet& given,
                          const std::vector<Recording>& training, const std::vector<Recording>& validation,
                          const LearnSettings& settings)
{
  const auto net = untaught(tissue, given);
  if (!net) return net.error();
  const BlockSource source{*net, tissue, settings.questions};
  auto parameters = parametersFor(settings.what, source);
  if (!parameters) return parameters.error();
  auto lessons = experimentsOf(*net, training), exams = experimentsOf(*net, validation);
  if (!lessons) return lessons.error();
  if (!exams) return exams.error();

  LearnResult result;
  const auto common =
    std::count_if(parameters->begin(), parameters->end(), std::mem_fn(&Parameter::isCommonStiffness));
  const auto all = static_cast<std::ptrdiff_t>(parameters->size());
  double factor = 0.0;
  std::vector<Parameter> global;
  if (common > 1 || (common == 1 && all > 1)) { // otherwise the one stage is that
    global = std::move(*parametersFor({"global"}, source));
    auto first = stage(*net, ParameterSet(*net, global), *lessons, *exams, settings.fit);
    if (!first) return first.error();
    result.first = std::move(*first);
    if (result.first.hasHelped) factor = result.first.theta[0];
  }
  for (Parameter& parameter : *parameters)
    if (parameter.isCommonStiffness()) parameter.centre = factor;
  const ParameterSet set(*net, std::move(*parameters));
  auto last = stage(*net, set, *lessons, *exams, settings.fit);
  if (!last) return last.error();
  result.last = std::move(*last);

  const bool hasFirst = !result.first.rounds.empty();
  const FitReport& start = hasFirst ? result.first : result.last;
  result.trainingBefore = start.trainingBefore;
  result.validationBefore = start.validationBefore;
  const bool lastHelps = !hasFirst || errorThatDecides(result.last) < errorThatDecides(result.first);
  const FitReport& kept = lastHelps ? result.last : result.first;
  result.layer = lastHelps ? layerOf(set, settings.questions, kept.theta, kept.deviations, kept.isSeen)
                           : layerOf(ParameterSet(*net, global), settings.questions, kept.theta,
                                     kept.deviations, kept.isSeen);
  result.layer.recordings = static_cast<int>(training.size());
  result.trainingAfter = kept.trainingAfter;
  result.validationAfter = kept.validationAfter;
  result.hasHelped = validation.empty() ? result.trainingAfter < result.trainingBefore * (1.0 - 1e-6)
                                        : result.validationAfter < result.validationBefore * (1.0 - 1e-6);
  for (const Parameter& parameter : set.parameters()) result.names.push_back(parameter.name);
  addNotes(result.last, set, result.notes);
  if (!lastHelps)
    result.notes.push_back(
      "one factor for all springs does better than what was asked for: only that is kept");
  return result;
}

double GradientCheck::relativeError() const noexcept
{
  const double size = std::max(std::abs(exact), std::abs(measured));
  return size > 0.0 ? std::abs(exact - measured) / size : 0.0;
}

namespace {

/// Half of the sum of squares of the errors of the cases; their gradient is added to `gradient` unless that is null.
std::optional<double> lossAt(const SpringNet& net, std::vector<Experiment>& cases, NetGradient* gradient)
{
  double loss = 0.0;
  for (Experiment& experiment : cases) {
    const Experiment::Trial trial = experiment.respond(net);
    if (!trial.isBalanced()) return {};
    loss += 0.5 * trial.error * trial.error;
    if (gradient == nullptr) continue;
    experiment.accept(); // differences begin there
    experiment.addGradient(net, *gradient);
  }
  return loss;
}

} // namespace

Result<std::vector<GradientCheck>> checkGradient(const TissueModel& tissue, const SpringNet& given,
                                                 const std::vector<Recording>& training,
                                                 const LearnSettings& settings)
{
  const auto net = untaught(tissue, given);
  if (!net) return net.error();
  auto cases = experimentsOf(*net, training);
  if (!cases) return cases.error();
  std::erase_if(*cases, [&](Experiment& experiment) {
    const bool isBalanced = experiment.respond(*net).isBalanced();
    experiment.restart();
    return !isBalanced;
  });
  if (cases->empty())
    return Error{ErrorCode::EmptyResult,
                 "the net snaps under every recording's load, so that no gradient can be checked"};
  std::vector<GradientCheck> checks;
  for (const std::string& id : settings.what) {
    auto parameters = parametersFor({id}, {*net, tissue, settings.questions});
    if (!parameters) return parameters.error();
    const ParameterSet set(*net, std::move(*parameters));
    const std::vector<double> start = set.centres();
    SpringNet tried = *net;
    set.apply(start, tried);
    NetGradient gradient(tried);
    if (!lossAt(tried, *cases, &gradient)) continue;
    std::vector<double> slope(start.size(), 0.0);
    set.pullBack(tried, gradient, slope);
    GradientCheck check;
    check.block = id;
    for (std::size_t j = 0; j < slope.size(); ++j) check.exact += slope[j] * (j % 2 == 0 ? 1.0 : 0.5);
    double table[4][4];
    double h = id == "law" ? 0.2 : 0.02; // exponents are of the order of ten, logs of factors of one
    for (int row = 0; row < 4; ++row, h *= 0.5) {
      double ends[2];
      for (const int side : {0, 1}) {
        std::vector<double> theta = start;
        for (std::size_t j = 0; j < theta.size(); ++j)
          theta[j] += (side == 1 ? h : -h) * (j % 2 == 0 ? 1.0 : 0.5);
        set.apply(theta, tried);
        const auto loss = lossAt(tried, *cases, nullptr);
        if (!loss)
          return Error{ErrorCode::Numerics, "the net snaps beside the place where its gradient is checked"};
        ends[side] = *loss;
      }
      table[row][0] = (ends[1] - ends[0]) / (2.0 * h);
      double factor = 4.0;
      for (int k = 1; k <= row; ++k, factor *= 4.0)
        table[row][k] = table[row][k - 1] + (table[row][k - 1] - table[row - 1][k - 1]) / (factor - 1.0);
    }
    check.measured = table[3][3];
    checks.push_back(std::move(check));
  }
  return checks;
}

} // namespace esm::learning
