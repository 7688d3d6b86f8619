// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/net/spring_net.h"

#include <cstdint>
#include <string>
#include <vector>

namespace esm {

struct TissueModel;

/// What was learned about a net from recordings: the last factor on the one parameter path,
///
///     words -> rules -> tissue at the place -> geometry -> number x learned factor.
///
/// Springs are told apart by questions to geometry, not by lists: a class of springs survives another mesh of the same
/// body, a new import and cuts, and can be said in a sentence.
struct SpringQuestions {
  bool byKind = false;                    ///< see SpringKind
  std::vector<double> lengthBorders = {}; ///< of the rest length over the median of the net's springs [1]
  std::vector<double> normalBorders =
    {}; ///< of the angle to the normal of the nearest surface, 0 to 90 [degrees]
  std::vector<double> axisBorders = {};  ///< of the angle to the body's longest axis, 0 to 90 [degrees]
  std::vector<double> depthBorders = {}; ///< of the distance from the surface over the median length [1]
  bool operator==(const SpringQuestions&) const = default;
};
/// All of the questions, with borders that serve walls and solids.
SpringQuestions usualQuestions();

/// The answers of a spring, or of a class of springs: places between the borders, from 0; -1 for any.
struct SpringClass {
  int kind = -1; ///< SpringKind
  int length = -1, normal = -1, axis = -1, depth = -1;
  bool operator==(const SpringClass&) const = default;
  auto operator<=>(const SpringClass&) const = default;
  bool contains(const SpringClass& spring) const noexcept;
};

enum class LearnedQuantity : std::uint8_t {
  Stiffness,    ///< of springs: times exp(value)
  LawParameter, ///< of springs: plus value
  Anchor        ///< stiffness of tissue's own anchors: times exp(value); the class does not matter
};

struct LearnedFactor {
  LearnedQuantity quantity = LearnedQuantity::Stiffness;
  SpringClass of;          ///< all -1: every spring
  std::string region = {}; ///< name of the region whose weight it fades with; empty: everywhere
  double value = 0.0;      ///< natural logarithm of a factor, or an addition [1]
  double deviation = 0.0;  ///< standard deviation of `value` as the recordings leave it [1]
  bool isSeen = true;      ///< false: the recordings say nothing about it
  bool operator==(const LearnedFactor&) const = default;
};

/// Plain data, part of TissueModel. Empty costs nothing.
struct LearnedLayer {
  SpringQuestions questions;
  std::vector<LearnedFactor> factors;
  struct OneSpring {
    SpringId spring{};
    double log = 0.0; ///< over what its classes say [1]
    bool operator==(const OneSpring&) const = default;
  };
  std::vector<OneSpring> springs; ///< by rising id
  int recordings = 0;             ///< that it was learned from
  bool isEmpty() const noexcept { return factors.empty() && springs.empty(); }
  bool operator==(const LearnedLayer&) const = default;
};

/// Whether borders rise, numbers are finite and answers lie between the borders. The detail names the first culprit.
Status checkLearned(const LearnedLayer& layer);

/// The answers of every spring of a net, S. O(S log S). Deterministic.
std::vector<SpringClass> answersOf(const SpringQuestions& questions, const SpringNet& net);
/// "edges, 0 to 30 degrees to the surface's normal"; "all springs" if no question is answered.
std::string classText(const SpringClass& springs, const SpringQuestions& questions, Language language);

/// What a layer makes of the numbers of a net. Sizes 0: the layer says nothing of them.
struct LearnedNumbers {
  Eigen::ArrayXd springFactor; ///< S [1]
  Eigen::ArrayXd lawShift;     ///< S [1]
  Eigen::ArrayXd nodeFactor;   ///< N, of the anchor that tissue gives the node [1]
  double factorOf(Index spring) const noexcept
  {
    return springFactor.size() > 0 ? springFactor[spring] : 1.0;
  }
  double shiftOf(Index spring) const noexcept { return lawShift.size() > 0 ? lawShift[spring] : 0.0; }
  double nodeFactorOf(Index node) const noexcept { return nodeFactor.size() > 0 ? nodeFactor[node] : 1.0; }
};
/// @param model  for the weights of its enabled regions; a factor of a region that is not there is idle.
/// @param net  as answersOf(); its numbers do not matter.
LearnedNumbers learnedNumbers(const TissueModel& model, const SpringNet& net);

/// One factor that a spring or a node's anchor has, for "why?".
struct LearnedReason {
  int factor = -1;     ///< into LearnedLayer::factors; -1: the spring's own
  double weight = 1.0; ///< of its region there
  double value = 0.0;  ///< weight times the factor's value
};
struct LearnedReasons {
  std::vector<LearnedReason> reasons;  ///< none: nothing was learned about it
  double factor = 1.0, lawShift = 0.0; ///< what they make together, the bits of learnedNumbers()
};
LearnedReasons learnedOfSpring(const TissueModel& model, const SpringNet& net, Index spring);
LearnedReasons learnedOfNode(const TissueModel& model, const SpringNet& net, Index node);

} // namespace esm
