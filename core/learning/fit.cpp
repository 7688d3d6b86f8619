// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/learning/fit.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>

namespace esm::learning {
namespace {

constexpr double kFirstDamping = 1e-3, kLeastDamping = 1e-9, kMostDamping = 1e8;
constexpr double kLongestLog = 1.5;        ///< that the logarithm of a factor may change in one step
constexpr double kIndependentNumbers = 30; ///< that a case tells at most
constexpr double kLeastError = 1e-5;       ///< of a case, for the prior's weight
constexpr double kExact = 1e-8;            ///< training error at which nothing is left to learn
constexpr double kStillSeen = 0.9;         ///< of the prior's deviation
constexpr int kStiffStarts = 4;            ///< factors 1, 2, 4, 8
/// The middle one of the lengths of normally distributed vectors, over the deviation of their components; and how many
/// of these deviations a length may have before it counts linearly: 3 of its own.
constexpr double kMiddleLength = 1.538, kFarOff = 3.0 * 1.732;

/// Weight of each marker's square in Huber's sum, and the cost itself.
double huber(const Eigen::VectorXd& residual, double border, Eigen::VectorXd* weight)
{
  double cost = 0.0;
  for (Eigen::Index m = 0; m < residual.size(); m += 3) {
    const double length = residual.segment<3>(m).norm();
    const bool isFar = length > border;
    cost += isFar ? border * (2.0 * length - border) : length * length;
    if (weight != nullptr) weight->segment<3>(m).setConstant(isFar ? border / length : 1.0);
  }
  return cost;
}

double rootMeanSquare(const std::vector<double>& errors)
{
  double sum = 0.0;
  for (const double error : errors) sum += error * error;
  return errors.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(errors.size()));
}

class Fit {
public:
  Fit(const SpringNet& net, const ParameterSet& set, std::span<Experiment> training,
      std::span<Experiment> validation, const FitSettings& settings)
    : m_set(set), m_validation(validation), m_settings(settings), m_net(net), m_theta(set.centres())
  {
    for (Experiment& experiment : training) m_all.push_back(&experiment);
  }

  Result<FitReport> run()
  {
    if (m_all.empty()) return Error{ErrorCode::EmptyResult, "there is no recording to learn from"};
    if (m_set.count() > kMostParameters)
      return invalidValue("there are " + std::to_string(m_set.count()) + " parameters, more than " +
                          std::to_string(kMostParameters) + "; learn classes or regions instead");
    if (!begin())
      return Error{ErrorCode::EmptyResult,
                   "the net snaps under the loads of every recording, even eight times stiffer; "
                   "check the units of the loads, or begin with smaller ones"};
    descend();
    if (m_settings.robust && !stopWanted(m_settings.control)) goOnRobustly();
    finish();
    return std::move(m_report);
  }

private:
  struct Normal {
    Eigen::MatrixXd square;   ///< J^T W J
    Eigen::VectorXd gradient; ///< J^T W r
  };

  template <class Task>
  void forEachCase(std::size_t count, const Task& task) const
  {
    forEachPart(m_settings.workers, count, [&](std::size_t i) noexcept { task(i); });
  }

  /// Answers of the training cases at theta. @return whether all are in balance.
  bool respond(std::span<const double> theta, std::span<const double> step,
               std::vector<Experiment::Trial>& trials)
  {
    m_set.apply(theta, m_net);
    trials.assign(m_used.size(), {});
    forEachCase(m_used.size(), [&](std::size_t i) { trials[i] = m_used[i]->respond(m_net, step); });
    return std::all_of(trials.begin(), trials.end(), [](const auto& trial) { return trial.isBalanced(); });
  }

  std::vector<double> validationErrors()
  {
    std::vector<double> errors(m_validation.size(), 1.0);
    forEachCase(m_validation.size(), [&](std::size_t i) {
      const Experiment::Trial trial = m_validation[i].respond(m_net);
      if (trial.isBalanced()) m_validation[i].accept();
      errors[i] = trial.error;
    });
    return errors;
  }

  bool begin()
  {
    std::vector<double> before = m_theta;
    std::vector<Experiment::Trial> trials;
    std::size_t most = 0;
    int stiffest = 0;
    m_used = m_all;
    for (int doubled = 0; doubled < kStiffStarts; ++doubled) {
      std::vector<double> theta = before;
      for (std::size_t j = 0; j < theta.size(); ++j)
        if (m_set.parameters()[j].isCommonStiffness()) theta[j] += doubled * std::log(2.0);
      for (Experiment* experiment : m_used) experiment->restart();
      respond(theta, {}, trials);
      if (doubled == 0) noteBefore(trials);
      const auto balanced = static_cast<std::size_t>(
        std::count_if(trials.begin(), trials.end(), [](const auto& trial) { return trial.isBalanced(); }));
      if (balanced > most || (doubled == 0)) {
        most = balanced;
        stiffest = doubled;
        m_theta = theta;
      }
      if (balanced == m_all.size()) break;
    }
    if (most == 0) return false;
    if (stiffest != kStiffStarts - 1) {
      for (Experiment* experiment : m_used) experiment->restart();
      respond(m_theta, {}, trials);
    }
    setAside(trials);
    noteRound(0, 0.0);
    return true;
  }

  /// What the errors are before anything is learned; the validation cases' as well.
  void noteBefore(const std::vector<Experiment::Trial>& trials)
  {
    std::vector<double> errors;
    for (std::size_t i = 0; i < m_all.size(); ++i) {
      m_report.cases.push_back({m_all[i]->name(), false, true, trials[i].error, trials[i].error});
      errors.push_back(trials[i].error);
    }
    m_report.trainingBefore = rootMeanSquare(errors);
    for (Experiment& experiment : m_validation) experiment.restart();
    const std::vector<double> others = validationErrors();
    for (std::size_t i = 0; i < m_validation.size(); ++i)
      m_report.cases.push_back({m_validation[i].name(), true, true, others[i], others[i]});
    m_report.validationBefore = rootMeanSquare(others);
  }

  void setAside(const std::vector<Experiment::Trial>& trials)
  {
    std::vector<Experiment*> used;
    m_errors.clear();
    for (std::size_t i = 0; i < m_all.size(); ++i) {
      m_report.cases[i].isUsed = trials[i].isBalanced();
      if (!trials[i].isBalanced()) continue;
      m_all[i]->accept();
      used.push_back(m_all[i]);
      m_errors.push_back(trials[i].error);
    }
    m_used = std::move(used);
  }

  /// m_net must be that of m_theta.
  void noteRound(int rejected, double change)
  {
    const double validation = rootMeanSquare(validationErrors());
    FitRound round{static_cast<int>(m_report.rounds.size()), rootMeanSquare(m_errors), validation, rejected,
                   change};
    m_report.rounds.push_back(round);
    const double judged = m_validation.empty() ? lossOfCases() : validation;
    if (judged < m_best) {
      m_best = judged;
      m_bestTheta = m_theta;
      m_sinceBest = 0;
    } else {
      ++m_sinceBest;
    }
    if (m_settings.onRound) m_settings.onRound(round);
  }

  double numbersOfCase() const
  {
    double least = kIndependentNumbers;
    for (const Experiment* experiment : m_used)
      least = std::min(least, static_cast<double>(experiment->residual().size()));
    return least;
  }

  void weighPrior()
  {
    const double error = std::max(rootMeanSquare(m_errors), kLeastError);
    m_spread = error * error / numbersOfCase();
  }

  double lossOfCases() const
  {
    double loss = 0.0;
    for (const Experiment* experiment : m_used) loss += huber(experiment->residual(), m_border, nullptr);
    return loss;
  }

  double costOf(std::span<const double> theta) const
  {
    double cost = lossOfCases();
    for (std::size_t j = 0; j < theta.size(); ++j) {
      const double off = (theta[j] - m_set.parameters()[j].centre) / m_set.parameters()[j].deviation;
      cost += m_spread * off * off;
    }
    return cost;
  }

  /// Sums over the cases at their accepted places, in the cases' order.
  Normal normal()
  {
    std::vector<Normal> each(m_used.size());
    forEachCase(m_used.size(), [&](std::size_t i) {
      Experiment& experiment = *m_used[i];
      experiment.findSlopes(m_net, m_set);
      Eigen::VectorXd weight(experiment.residual().size());
      huber(experiment.residual(), m_border, &weight);
      const Eigen::MatrixXd weighted = weight.asDiagonal() * experiment.slopes();
      each[i].square.noalias() = experiment.slopes().transpose() * weighted;
      each[i].gradient.noalias() = weighted.transpose() * experiment.residual();
    });
    Normal sum = std::move(each.front());
    for (std::size_t i = 1; i < each.size(); ++i) {
      sum.square += each[i].square;
      sum.gradient += each[i].gradient;
    }
    return sum;
  }

  void addPrior(Normal& sum) const
  {
    for (Eigen::Index j = 0; j < sum.gradient.size(); ++j) {
      const Parameter& parameter = m_set.parameters()[static_cast<std::size_t>(j)];
      const double strength = m_spread / (parameter.deviation * parameter.deviation);
      sum.square(j, j) += strength;
      sum.gradient[j] += strength * (m_theta[static_cast<std::size_t>(j)] - parameter.centre);
    }
  }

  std::vector<double> stepFor(const Normal& sum, double damping) const
  {
    Eigen::MatrixXd damped = sum.square;
    damped.diagonal() *= 1.0 + damping;
    const Eigen::VectorXd step = damped.ldlt().solve(-sum.gradient);
    double scale = 1.0;
    for (Eigen::Index j = 0; j < step.size(); ++j) {
      const Parameter& parameter = m_set.parameters()[static_cast<std::size_t>(j)];
      const bool isAdded = parameter.factor.quantity == LearnedQuantity::LawParameter;
      const double longest = isAdded ? parameter.deviation : kLongestLog;
      if (std::abs(step[j]) > longest * scale) scale = longest / std::abs(step[j]);
    }
    std::vector<double> scaled(static_cast<std::size_t>(step.size()));
    for (Eigen::Index j = 0; j < step.size(); ++j) scaled[static_cast<std::size_t>(j)] = scale * step[j];
    return scaled;
  }

  bool mayGoOn(int round)
  {
    if (stopWanted(m_settings.control)) return end("stopped");
    if (round == m_settings.mostRounds) return end("as many rounds as were allowed");
    if (rootMeanSquare(m_errors) <= kExact) return end("the recordings are met exactly");
    if (!m_validation.empty() && m_sinceBest >= m_settings.patience)
      return end("the validation cases gain no more");
    return true;
  }
  bool end(const char* why)
  {
    m_report.end = why;
    return false;
  }

  void descend()
  {
    double damping = kFirstDamping;
    int small = 0;
    for (int round = 0; mayGoOn(round); ++round) {
      Normal sum = normal();
      if (m_report.rounds.size() == 1 && m_report.ambiguities.empty())
        m_report.ambiguities = ambiguitiesOf(sum.square, m_set, m_used.size());
      weighPrior();
      addPrior(sum);
      const double before = costOf(m_theta);
      const double after = tryStep(sum, before, damping);
      if (!(after < before)) {
        end("no step lowers the error");
        return;
      }
      small = before - after < m_settings.leastGain * before ? small + 1 : 0;
      if (small == 2) {
        end("steps lower the error no more");
        return;
      }
      tellDone(m_settings.control, static_cast<double>(round + 1) / m_settings.mostRounds);
    }
  }

  /// Steps from long to short until one lowers the cost. @return the cost then; `before` if none does.
  double tryStep(const Normal& sum, double before, double& damping)
  {
    std::vector<Experiment::Trial> trials;
    for (int rejected = 0; damping <= kMostDamping && !stopWanted(m_settings.control); ++rejected) {
      const std::vector<double> step = stepFor(sum, damping);
      std::vector<double> theta = m_theta;
      for (std::size_t j = 0; j < theta.size(); ++j) theta[j] += step[j];
      double largest = 0.0;
      for (const double change : step) largest = std::max(largest, std::abs(change));
      if (!(largest > 1e-12)) break;
      if (const bool isBalanced = respond(theta, step, trials); isBalanced) {
        if (const double cost = costOf(theta); cost < before) {
          m_theta = theta;
          for (Experiment* experiment : m_used) experiment->accept();
          for (std::size_t i = 0; i < trials.size(); ++i) m_errors[i] = trials[i].error;
          damping = std::max(0.2 * damping, kLeastDamping);
          noteRound(rejected, largest);
          return cost;
        }
      }
      damping *= 8.0;
    }
    return before;
  }

  /// Markers that lie far off count linearly from now on.
  void goOnRobustly()
  {
    restoreBest();
    std::vector<double> lengths;
    for (const Experiment* experiment : m_used)
      for (Eigen::Index m = 0; m < experiment->residual().size(); m += 3)
        lengths.push_back(experiment->residual().segment<3>(m).norm());
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    const double border = kFarOff * *middle / kMiddleLength;
    if (rootMeanSquare(m_errors) <= kLeastError ||
        *std::max_element(lengths.begin(), lengths.end()) <= border)
      return;
    m_border = border;
    m_sinceBest = 0;
    if (m_validation.empty())
      m_best = std::numeric_limits<double>::infinity(); // outliers would be the judges
    descend();
  }

  /// The cases at the best theta, as a fresh run from their last balance finds them.
  bool restoreBest()
  {
    std::vector<Experiment::Trial> trials;
    m_theta = m_bestTheta;
    if (!respond(m_theta, {}, trials)) {
      for (Experiment* experiment : m_used) experiment->restart();
      if (!respond(m_theta, {}, trials)) return false;
    }
    for (Experiment* experiment : m_used) experiment->accept();
    for (std::size_t i = 0; i < trials.size(); ++i) m_errors[i] = trials[i].error;
    return true;
  }

  void finish()
  {
    const bool isThere = restoreBest();
    m_report.theta = m_theta;
    m_report.deviations.assign(m_theta.size(), 0.0);
    m_report.isSeen.assign(m_theta.size(), 0);
    if (isThere) findDeviations();
    std::size_t next = 0;
    std::vector<double> errors;
    for (std::size_t i = 0; i < m_all.size(); ++i) {
      FitCase& one = m_report.cases[i];
      one.after = one.isUsed ? m_errors[next++] : 1.0;
      errors.push_back(one.after);
    }
    m_report.trainingAfter = rootMeanSquare(errors);
    const std::vector<double> others = validationErrors();
    for (std::size_t i = 0; i < others.size(); ++i) m_report.cases[m_all.size() + i].after = others[i];
    m_report.validationAfter = rootMeanSquare(others);
    const bool judges = !m_validation.empty();
    m_report.hasHelped = judges ? m_report.validationAfter < m_report.validationBefore * (1.0 - 1e-6)
                                : m_report.trainingAfter < m_report.trainingBefore * (1.0 - 1e-6);
    const auto count = [&](const Experiment& experiment) {
      m_report.forwards += experiment.forwards();
      m_report.cost += experiment.cost();
    };
    for (const Experiment* experiment : m_all) count(*experiment);
    for (const Experiment& experiment : m_validation) count(experiment);
  }

  /// From the inverse of J^T J / s^2 + prior.
  void findDeviations()
  {
    Normal sum = normal();
    weighPrior();
    addPrior(sum);
    const Eigen::Index count = sum.gradient.size();
    const Eigen::MatrixXd inverse = sum.square.ldlt().solve(Eigen::MatrixXd::Identity(count, count));
    for (Eigen::Index j = 0; j < count; ++j) {
      const auto i = static_cast<std::size_t>(j);
      const double prior = m_set.parameters()[i].deviation;
      m_report.deviations[i] = std::min(std::sqrt(std::max(m_spread * inverse(j, j), 0.0)), prior);
      m_report.isSeen[i] = m_report.deviations[i] < kStillSeen * prior;
    }
  }

  const ParameterSet& m_set;
  std::vector<Experiment*> m_all, m_used; ///< training; those in balance at the start
  std::span<Experiment> m_validation;
  const FitSettings& m_settings;
  SpringNet m_net; ///< with the numbers tried last
  std::vector<double> m_theta, m_bestTheta;
  std::vector<double> m_errors; ///< of m_used at m_theta
  double m_best = std::numeric_limits<double>::infinity();
  int m_sinceBest = 0;
  double m_spread = 0.0;                                     ///< s^2
  double m_border = std::numeric_limits<double>::infinity(); ///< of Huber's sum
  FitReport m_report;
};

} // namespace

Result<FitReport> fit(const SpringNet& net, const ParameterSet& set, std::span<Experiment> training,
                      std::span<Experiment> validation, const FitSettings& settings)
{
  return Fit(net, set, training, validation, settings).run();
}

} // namespace esm::learning
