// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/tissue/learned_layer.h"

#include "core/base/grouped.h"
#include "core/base/text_number.h"
#include "core/tissue/tissue_model.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <queue>

namespace esm {
namespace {

/// How much longer a body must be than it is wide (variances of its nodes) to have an axis.
constexpr double kClearAxis = 1.2;

int answerTo(const std::vector<double>& borders, double value)
{
  if (borders.empty()) return -1;
  return static_cast<int>(std::upper_bound(borders.begin(), borders.end(), value) - borders.begin());
}

/// The longest principal axis of the nodes; zero where there is none.
Eigen::Vector3d longestAxis(const SpringNet& net)
{
  if (net.nodeCount() < 2) return Eigen::Vector3d::Zero();
  const Eigen::Matrix3Xd around = net.restPosition.colwise() - net.restPosition.rowwise().mean();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(around * around.transpose());
  const Eigen::Vector3d& spread = solver.eigenvalues(); // rising
  return spread[2] > kClearAxis * spread[1] ? Eigen::Vector3d(solver.eigenvectors().col(2))
                                            : Eigen::Vector3d::Zero();
}

/// Unit normals of the surface's nodes, by the area of their triangles; zero off the surface.
Eigen::Matrix3Xd nodeNormals(const SpringNet& net)
{
  Eigen::Matrix3Xd normal = Eigen::Matrix3Xd::Zero(3, net.nodeCount());
  for (Index t = 0; t < net.triangleCount(); ++t) {
    const auto corner = [&](int k) -> Eigen::Vector3d { return net.restPosition.col(net.triangles(k, t)); };
    const Eigen::Vector3d area = (corner(1) - corner(0)).cross(corner(2) - corner(0));
    for (int k = 0; k < 3; ++k) normal.col(net.triangles(k, t)) += area;
  }
  for (Index i = 0; i < net.nodeCount(); ++i)
    if (const double size = normal.col(i).norm(); size > 0.0) normal.col(i) /= size;
  return normal;
}

/// For each node the surface's node that is nearest along the springs, kNoIndex if none can be reached.
std::vector<Index> nearestOnSurface(const SpringNet& net, const Eigen::Matrix3Xd& normal)
{
  Grouped<Index> springsOf;
  springsOf.build(at(net.nodeCount()), [&](const auto& add) {
    for (Index s = 0; s < net.springCount(); ++s)
      for (int end = 0; end < 2; ++end) add(net.ends(end, s), s);
  });
  using Entry = std::pair<double, Index>; // equal ways: the lower node goes first
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
  std::vector<double> way(at(net.nodeCount()), std::numeric_limits<double>::infinity());
  std::vector<Index> nearest(at(net.nodeCount()), kNoIndex);
  for (Index i = 0; i < net.nodeCount(); ++i)
    if (!normal.col(i).isZero(0.0)) {
      way[at(i)] = 0.0;
      nearest[at(i)] = i;
      front.emplace(0.0, i);
    }
  while (!front.empty()) {
    const auto [length, node] = front.top();
    front.pop();
    if (length > way[at(node)]) continue;
    for (const Index s : springsOf[at(node)]) {
      const Index other = net.ends(0, s) == node ? net.ends(1, s) : net.ends(0, s);
      const double next = length + net.restLength[s];
      if (!(next < way[at(other)])) continue;
      way[at(other)] = next;
      nearest[at(other)] = nearest[at(node)];
      front.emplace(next, other);
    }
  }
  return nearest;
}

double lengthOf(const SpringNet& net)
{
  const double median = medianRestLength(net);
  return median > 0.0 ? median : 1.0;
}

/// What angles and depths are measured by.
struct Surroundings {
  double length;
  Eigen::Vector3d axis;
  Eigen::Matrix3Xd normal;
  std::vector<Index> nearest;

  explicit Surroundings(const SpringNet& net)
    : length(lengthOf(net)),
      axis(longestAxis(net)),
      normal(nodeNormals(net)),
      nearest(nearestOnSurface(net, normal))
  {}
};

double degreesOf(double cosine)
{
  return std::acos(std::min(std::abs(cosine), 1.0)) * 180.0 / std::numbers::pi;
}

SpringClass answers(const SpringQuestions& ask, const SpringNet& net, Index s, const Surroundings& body)
{
  const Index ends[2] = {net.ends(0, s), net.ends(1, s)};
  const Eigen::Vector3d along = (net.restPosition.col(ends[1]) - net.restPosition.col(ends[0])).normalized();
  SpringClass answer;
  if (ask.byKind) answer.kind = static_cast<int>(net.kind[at(s)]);
  answer.length = answerTo(ask.lengthBorders, net.restLength[s] / body.length);
  answer.axis = answerTo(ask.axisBorders, degreesOf(along.dot(body.axis)));
  double cosine = 0.0, depth = 0.0; // means over the ends
  for (const Index end : ends) {
    const Index over = body.nearest[at(end)];
    if (over == kNoIndex) continue;
    cosine += 0.5 * std::abs(along.dot(body.normal.col(over)));
    depth += 0.5 * (net.restPosition.col(end) - net.restPosition.col(over)).norm();
  }
  answer.normal = answerTo(ask.normalBorders, degreesOf(cosine));
  answer.depth = answerTo(ask.depthBorders, depth / body.length);
  return answer;
}

bool regionIsOn(const Region& region, const std::string& name)
{
  return region.enabled && region.name == name;
}

/// The weight of a factor at a place.
class Weights {
public:
  Weights(const TissueModel& model, const LearnedLayer& layer)
  {
    for (const LearnedFactor& factor : layer.factors) {
      m_shape.emplace_back();
      m_everywhere.push_back(factor.region.empty());
      for (const Region& region : model.regions)
        if (!factor.region.empty() && !m_shape.back() && regionIsOn(region, factor.region))
          m_shape.back().emplace(region);
    }
  }
  double at(std::size_t factor, const Eigen::Vector3d& place) const
  {
    if (m_everywhere[factor]) return 1.0;
    return m_shape[factor] ? m_shape[factor]->weight(place) : 0.0;
  }

private:
  std::vector<std::optional<RegionShape>> m_shape;
  std::vector<bool> m_everywhere;
};

/// "30 to 60 degrees"
std::string between(const std::vector<double>& borders, int place, double least, double most)
{
  const auto i = static_cast<std::size_t>(place);
  const double low = i == 0 ? least : borders[i - 1], high = i < borders.size() ? borders[i] : most;
  const std::string from = formatDouble(low, 3), to = formatDouble(high, 3);
  if (!std::isfinite(high)) return "> " + from;
  return i == 0 && least == 0.0 && most > 90.0 ? "< " + to : from + "\u2013" + to;
}

} // namespace

SpringQuestions usualQuestions()
{
  return {true, {1.2}, {30.0, 60.0}, {30.0, 60.0}, {0.5}};
}

bool SpringClass::contains(const SpringClass& spring) const noexcept
{
  const auto fits = [](int wanted, int is) { return wanted < 0 || wanted == is; };
  return fits(kind, spring.kind) && fits(length, spring.length) && fits(normal, spring.normal) &&
         fits(axis, spring.axis) && fits(depth, spring.depth);
}

Status checkLearned(const LearnedLayer& layer)
{
  const SpringQuestions& ask = layer.questions;
  for (const auto* borders : {&ask.lengthBorders, &ask.normalBorders, &ask.axisBorders, &ask.depthBorders})
    if (std::adjacent_find(borders->begin(), borders->end(), std::greater_equal<>()) != borders->end() ||
        !std::all_of(borders->begin(), borders->end(), [](double b) { return std::isfinite(b); }))
      return invalidValue("the borders of learned classes do not rise");
  for (std::size_t i = 0; i < layer.factors.size(); ++i) {
    const LearnedFactor& factor = layer.factors[i];
    const auto fits = [](int answer, const std::vector<double>& borders) {
      return answer >= -1 && answer <= static_cast<int>(borders.size()) && (answer < 0 || !borders.empty());
    };
    const SpringClass& of = factor.of;
    if (of.kind < -1 || of.kind >= kSpringKindCount || !fits(of.length, ask.lengthBorders) ||
        !fits(of.normal, ask.normalBorders) || !fits(of.axis, ask.axisBorders) ||
        !fits(of.depth, ask.depthBorders))
      return invalidValue("learned factor " + std::to_string(i) +
                          " is of a class that its questions do not know");
    if (!(std::abs(factor.value) <= 100.0) || !(factor.deviation >= 0.0) || !std::isfinite(factor.deviation))
      return invalidValue("learned factor " + std::to_string(i) +
                          " must lie between -100 and 100, its deviation at 0 or above");
  }
  for (std::size_t i = 0; i < layer.springs.size(); ++i)
    if (!(std::abs(layer.springs[i].log) <= 100.0) ||
        (i > 0 && layer.springs[i].spring <= layer.springs[i - 1].spring))
      return invalidValue(
        "the learned factors of single springs must come by rising id, between -100 and 100");
  return {};
}

std::vector<SpringClass> answersOf(const SpringQuestions& questions, const SpringNet& net)
{
  std::vector<SpringClass> all(at(net.springCount()));
  if (questions == SpringQuestions{}) return all;
  const Surroundings body(net);
  for (Index s = 0; s < net.springCount(); ++s) all[at(s)] = answers(questions, net, s, body);
  return all;
}

std::string classText(const SpringClass& springs, const SpringQuestions& questions, Language language)
{
  constexpr double kAny = std::numeric_limits<double>::infinity();
  const bool german = language == Language::German;
  constexpr const char* kKinds[2][kSpringKindCount] = {
    {"edges", "lines", "struts", "edges of the wall", "diagonals of the wall", "springs across the wall",
     "braces of the wall"},
    {"Kanten", "Linien", "Streben", "Kanten der Wand", "Diagonalen der Wand", "Federn quer zur Wand",
     "Schrägen der Wand"}};
  std::string text = springs.kind >= 0 ? kKinds[german][springs.kind]
                     : german          ? "alle Federn"
                                       : "all springs";
  const auto add = [&](const std::string& more) { text += ", " + more; };
  if (springs.length >= 0)
    add((german ? "Länge " : "length ") + between(questions.lengthBorders, springs.length, 0.0, kAny) +
        (german ? " × Median" : " × median"));
  if (springs.normal >= 0)
    add(between(questions.normalBorders, springs.normal, 0.0, 90.0) +
        (german ? "° zur Flächennormalen" : "° to the surface's normal"));
  if (springs.axis >= 0)
    add(between(questions.axisBorders, springs.axis, 0.0, 90.0) +
        (german ? "° zur Längsachse" : "° to the long axis"));
  if (springs.depth >= 0)
    add((german ? "Tiefe " : "depth ") + between(questions.depthBorders, springs.depth, 0.0, kAny) +
        (german ? " × Median" : " × median"));
  return text;
}

LearnedNumbers learnedNumbers(const TissueModel& model, const SpringNet& net)
{
  const LearnedLayer& layer = model.learned;
  LearnedNumbers numbers;
  if (layer.isEmpty()) return numbers;
  const auto has = [&](LearnedQuantity quantity) {
    return std::any_of(layer.factors.begin(), layer.factors.end(),
                       [&](const LearnedFactor& f) { return f.quantity == quantity; });
  };
  Eigen::ArrayXd logs = Eigen::ArrayXd::Zero(net.springCount());
  if (has(LearnedQuantity::LawParameter)) numbers.lawShift = logs;
  if (has(LearnedQuantity::Anchor)) numbers.nodeFactor = Eigen::ArrayXd::Zero(net.nodeCount());
  const std::vector<SpringClass> classes = answersOf(layer.questions, net);
  const Weights weights(model, layer);
  for (std::size_t f = 0; f < layer.factors.size(); ++f) {
    const LearnedFactor& factor = layer.factors[f];
    if (factor.quantity == LearnedQuantity::Anchor) {
      for (Index i = 0; i < net.nodeCount(); ++i)
        numbers.nodeFactor[i] += factor.value * weights.at(f, net.restPosition.col(i));
      continue;
    }
    Eigen::ArrayXd& to = factor.quantity == LearnedQuantity::Stiffness ? logs : numbers.lawShift;
    for (Index s = 0; s < net.springCount(); ++s)
      if (factor.of.contains(classes[at(s)])) to[s] += factor.value * weights.at(f, net.middleOf(s));
  }
  if (!layer.springs.empty()) {
    std::vector<std::pair<SpringId, Index>> byId(at(net.springCount()));
    for (Index s = 0; s < net.springCount(); ++s) byId[at(s)] = {net.springId[at(s)], s};
    std::sort(byId.begin(), byId.end());
    auto place = byId.begin();
    for (const LearnedLayer::OneSpring& one : layer.springs) {
      place = std::lower_bound(place, byId.end(), std::pair(one.spring, Index{0}));
      if (place != byId.end() && place->first == one.spring) logs[place->second] += one.log;
    }
  }
  const auto exponential = [](double log) { return std::exp(log); }; // Eigen's own has other bits
  numbers.springFactor = logs.unaryExpr(exponential);
  if (numbers.nodeFactor.size() > 0) numbers.nodeFactor = numbers.nodeFactor.unaryExpr(exponential).eval();
  return numbers;
}

LearnedReasons learnedOfSpring(const TissueModel& model, const SpringNet& net, Index spring)
{
  const LearnedLayer& layer = model.learned;
  LearnedReasons all;
  if (layer.isEmpty()) return all;
  const SpringClass answer = layer.questions == SpringQuestions{}
                               ? SpringClass{}
                               : answers(layer.questions, net, spring, Surroundings(net));
  const Weights weights(model, layer);
  double log = 0.0;
  const auto add = [&](int factor, double weight, double value, double& to) {
    to += value;
    all.reasons.push_back({factor, weight, value});
  };
  for (std::size_t f = 0; f < layer.factors.size(); ++f) {
    const LearnedFactor& factor = layer.factors[f];
    if (factor.quantity == LearnedQuantity::Anchor || !factor.of.contains(answer)) continue;
    const double weight = weights.at(f, net.middleOf(spring));
    if (weight > 0.0)
      add(static_cast<int>(f), weight, factor.value * weight,
          factor.quantity == LearnedQuantity::Stiffness ? log : all.lawShift);
  }
  for (const LearnedLayer::OneSpring& one : layer.springs)
    if (one.spring == net.springId[at(spring)]) add(-1, 1.0, one.log, log);
  all.factor = std::exp(log);
  return all;
}

LearnedReasons learnedOfNode(const TissueModel& model, const SpringNet& net, Index node)
{
  const LearnedLayer& layer = model.learned;
  LearnedReasons all;
  if (layer.isEmpty()) return all;
  const Weights weights(model, layer);
  double log = 0.0;
  for (std::size_t f = 0; f < layer.factors.size(); ++f) {
    const LearnedFactor& factor = layer.factors[f];
    const double weight = weights.at(f, net.restPosition.col(node));
    if (factor.quantity != LearnedQuantity::Anchor || !(weight > 0.0)) continue;
    log += factor.value * weight;
    all.reasons.push_back({static_cast<int>(f), weight, factor.value * weight});
  }
  all.factor = std::exp(log);
  return all;
}

} // namespace esm
