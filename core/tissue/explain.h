// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/tissue/derivation_places.h"
#include "core/tissue/tissue_model.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace esm {

/// "Why is it stiff?": the whole chain behind the numbers of a spring or a node,
///
///     numbers <- geometry, tissue at the place <- base tissue and regions by share <- rules <- inputs,
///
/// with the very numbers of applyTissue(), bit for bit: the formulas and the blend are the same code. The
/// other way round, what input would make a number larger or smaller by a factor (changesFor()).
/// Texts and files of all this: explain_text.h.

/// What is asked about.
struct ExplainedThing {
  enum class Kind : std::uint8_t { Spring, Node, Tissue } kind = Kind::Tissue;
  Index index = -1; ///< of Spring and Node into the net's arrays; of Tissue a region, -1 the base tissue
  bool operator==(const ExplainedThing&) const = default;
};

/// What kinds of numbers there are: those of springs and nodes, and the tissue's parameters. A number is a
/// product of powers of the tissue's parameters and of geometry.
struct ExplainedKind {
  const char* id;      ///< "stiffness"
  const char* unit;    ///< SI, "" for none
  const char* formula; ///< "E h A / L^2"; of a tissue parameter its symbol
  fuzzy::Names name;
  double perShown;                                    ///< SI units in one shown unit
  const char* shownUnit;                              ///< "N/m"
  std::array<std::int8_t, kTissueOutputCount> powers; ///< of the parameters in the order of kTissueOutputs
};

struct ExplainedValue {
  const ExplainedKind* kind = nullptr;
  double value = 0.0;      ///< what holds: the net's number; of a parameter what the tissue says
  double fromTissue = 0.0; ///< what the tissue gives; another one where the net keeps its own
};

/// "A": the area that the formula takes.
struct ExplainedGeometry {
  const char *id, *symbol, *unit;
  fuzzy::Names name;
  double value = 0.0;
  double perShown = 1.0;
  const char* shownUnit = "";
};

/// One rule and what hangs on it.
struct RuleReason {
  int rule = -1;           ///< into RuleBase::rules
  double degree = 0.0;     ///< with which it fires, weight included
  double without = 0.0;    ///< the output's value if this rule were off
  std::vector<int> inputs; ///< that its condition speaks of, ascending
};
/// One output of one layer.
struct OutputReason {
  int parameter = -1; ///< into kTissueOutputs
  int output = -1;    ///< into RuleBase::outputs
  double value = 0.0;
  bool fromRules = false;        ///< false: no rule fired, it is the default
  std::vector<RuleReason> rules; ///< that fired for it, the strongest first
};
struct LayerReason {
  TissueLayer layer;
  std::string name; ///< of the region, empty for the base tissue
  bool locked = false;
  std::vector<fuzzy::InputValue> inputs;
  std::vector<OutputReason> outputs; ///< those that the thing's numbers hang on
};

struct TissueExplanation {
  ExplainedThing thing;
  Index id = -1;                          ///< of the spring or node
  std::vector<Index> nodes;               ///< ids of a spring's ends
  bool isFixed = false;                   ///< of a node
  bool isOnSurface = true;                ///< false: its mass is that of its lines
  Eigen::Vector3d place{0, 0, 0};         ///< at rest [m]
  bool followsTissue = true;              ///< false: the net keeps the numbers of its file
  std::vector<ExplainedValue> values;     ///< of the spring or node, the main one first; none of Tissue
  std::vector<ExplainedValue> parameters; ///< of the tissue at the place, in the order of kTissueOutputs
  std::vector<ExplainedGeometry> geometry;
  std::vector<LayerReason> layers; ///< bottom first; their shares sum to 1
  LearnedReasons learned;          ///< the last factor; none of Tissue

  /// A spring's stiffness; of others the tissue's, Young's modulus.
  const ExplainedValue& main() const noexcept;
  const ExplainedValue* find(std::string_view kindId) const noexcept; ///< null if it has no such number
};

/// Explains springs and nodes of one net. Remembers the net's geometry, as TissueDerivation does. Any thread.
class TissueExplainer {
public:
  explicit TissueExplainer(const SpringNet& net) : m_places(net) {}
  /// @param net the one of the constructor; its parameters may have changed, topology and rest shape not.
  /// @param followsTissue Project::parametersFromTissue.
  /// @pre the thing is there
  TissueExplanation explain(const TissueField& field, const SpringNet& net, ExplainedThing thing,
                            bool followsTissue = true) const;

private:
  void explainSpring(const TissueField& field, const SpringNet& net, TissueExplanation& why) const;
  void explainNode(const TissueField& field, const SpringNet& net, TissueExplanation& why) const;
  double massOff(const TissueField& field, const SpringNet& net, Index node) const;

  DerivationPlaces m_places;
};

/// The tissue alone, without a net. @param region -1 for the base tissue; it may be off.
TissueExplanation explainTissue(const TissueField& field, int region);

/// What one input of one layer would have to be.
struct InputChange {
  int region = -1; ///< -1: the base tissue
  int input = -1;  ///< into RuleBase::inputs
  fuzzy::InputValue from;
  double to = 0.0;      ///< does it, or comes nearest
  bool reached = false; ///< `factor` is the wanted one within 1 %
  double factor = 1.0;  ///< what `to` makes of the number
  /// d ln(number)/d(input) at `from`, exact; at a kink (a word's peak, say) that of the side of `to`, taken
  /// 1e-4 of the range beside it. Empty for a word and outside the range.
  std::optional<double> slope;
  bool locked = false; ///< the region is
};

/// For each input of each layer that the number hangs on: the value, next to the present one, that changes
/// the number by `factor`. Found by bisection on the whole chain (inference, blend, formula), between places
/// 1/64 of the range apart, and given with as few digits as keep the factor within 0.5 %. Those that reach
/// the factor come first, the smallest change first; then the others, the nearest first.
/// Empty if the number is 0 or does not come from the rules.
std::vector<InputChange> changesFor(const TissueField& field, const TissueExplanation& why,
                                    const ExplainedValue& value, double factor);

} // namespace esm
