// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "tests/core/project/random_project.h"

#include "core/net/net_builder.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <unistd.h>

namespace esm::test {

namespace {

class Dice {
public:
  explicit Dice(unsigned seed) : m_engine(seed) {}
  int below(int limit) { return static_cast<int>(m_engine() % static_cast<unsigned>(limit)); }
  bool coin() { return below(2) == 1; }
  double uniform(double low, double high)
  {
    return low + (high - low) * static_cast<double>(m_engine()) / 4294967295.0;
  }

  /// Any finite double; one in four is a number that files like to break.
  double any()
  {
    using Limits = std::numeric_limits<double>;
    constexpr double kTricky[] = {0.0,
                                  -0.0,
                                  Limits::denorm_min(),
                                  -Limits::min(),
                                  Limits::max(),
                                  Limits::lowest(),
                                  1.0 / 3.0,
                                  0.1,
                                  9007199254740993.0,
                                  -9223372036854775808.0,
                                  18446744073709551616.0,
                                  1e22,
                                  123456789012345680000.0,
                                  5e-324};
    if (below(4) == 0) return kTricky[below(static_cast<int>(std::size(kTricky)))];
    return uniform(-1.0, 1.0) * std::pow(10.0, below(40) - 20);
  }
  double positive()
  {
    const double value = std::abs(any());
    return value > 0.0 ? value : 1.0;
  }
  double notNegative() { return below(5) == 0 ? -0.0 : std::abs(any()); }

  template <class Number>
  Eigen::ArrayXd array(Index count, Number number) ///< sometimes all equal
  {
    const double first = number();
    const bool uniformArray = coin();
    return Eigen::ArrayXd::NullaryExpr(count, [&] { return uniformArray ? first : number(); });
  }
  Eigen::Matrix3Xd points(Index count)
  {
    return Eigen::Matrix3Xd::NullaryExpr(3, count, [&] { return any(); });
  }
  std::vector<Index> nodes(Index limit)
  {
    std::vector<Index> list;
    for (Index i = 0; i < limit; ++i)
      if (coin()) list.push_back(i);
    return list;
  }
  VectorCurve curve()
  {
    VectorCurve curve;
    double time = any();
    for (int i = below(4); i >= 0; --i) {
      curve.time.push_back(time);
      time = std::max(time, time + std::abs(uniform(0.0, 1.0)) * below(2)); // equal neighbours are a jump
    }
    curve.value = points(static_cast<Index>(curve.time.size()));
    return curve;
  }
  std::string text()
  {
    constexpr const char* kTexts[] = {
      "", "Gebärmutter", "a \"b\" \\ c", "line\nbreak\ttab", "\xF0\x9F\xAB\x80", "x/~y"};
    return kTexts[below(static_cast<int>(std::size(kTexts)))];
  }

private:
  std::mt19937 m_engine;
};

SpringNet randomNet(Dice& dice)
{
  SpringNet net;
  const Index nodes = 2 + dice.below(30), springs = dice.below(60);
  resizeNet(net, nodes, springs);
  net.restPosition = dice.points(nodes);
  net.mass = dice.array(nodes, [&] { return dice.positive(); });
  if (dice.coin()) net.initialVelocity = dice.points(nodes);
  if (dice.coin()) net.massDamping = dice.array(nodes, [&] { return dice.notNegative(); });
  for (auto& flag : net.fixed) flag = dice.coin();
  for (std::size_t i = 0; i < net.nodeId.size(); ++i)
    net.nodeId[i] = NodeId{static_cast<Index>(i) * 3 + dice.below(3)};

  net.tables = {{{-1.0, 0.0, 0.5}, {-1.0, -0.0, 7.25}}, {{0.0, 1e-300}, {0.0, 1.0}}};
  net.restLength = dice.array(springs, [&] { return dice.positive(); });
  net.stiffness = dice.array(springs, [&] { return dice.notNegative(); });
  net.viscosity = dice.array(springs, [&] { return dice.notNegative(); });
  const bool oneLaw = dice.coin();
  for (Index s = 0; s < springs; ++s) {
    const auto place = static_cast<std::size_t>(s);
    const Index a = dice.below(nodes);
    net.ends.col(s) << a, (a + 1 + dice.below(nodes - 1)) % nodes;
    net.law[place] = oneLaw ? SpringLaw::Cubic : SpringLaw(dice.below(4));
    net.lawParameter[s] = net.law[place] == SpringLaw::Table ? dice.below(2) : dice.any();
    net.tensionOnly[place] = dice.coin();
    net.kind[place] = SpringKind(dice.below(kSpringKindCount));
    if (dice.coin()) net.springId[place] = SpringId{1000 + s};
  }
  const auto anchored = dice.nodes(nodes);
  const auto anchors = static_cast<Index>(anchored.size());
  net.anchors = {anchored, dice.points(anchors), dice.array(anchors, [&] { return dice.notNegative(); }),
                 dice.array(anchors, [&] { return dice.notNegative(); })};
  if (dice.coin()) net.anchors.bandLength = dice.array(anchors, [&] { return dice.notNegative(); });
  if (dice.coin()) net.section = dice.array(springs, [&] { return dice.notNegative(); });
  if (dice.coin()) net.volume = dice.array(nodes, [&] { return dice.notNegative(); });
  if (dice.coin())
    for (Index i = 0; i < nodes; ++i) net.supportNode.push_back(dice.coin());
  if (dice.coin()) net.material = {EdgeFormula(dice.below(2)), dice.positive()};
  net.triangles = TriangleMatrix::NullaryExpr(3, dice.below(20), [&] { return dice.below(nodes); });
  if (dice.coin() && nodes >= 4) { // a tetrahedron, turned outwards
    const auto edge = [&net](Index node) {
      return Eigen::Vector3d(net.restPosition.col(node) - net.restPosition.col(0));
    };
    const double sixfold = edge(1).dot(edge(2).cross(edge(3)));
    TriangleMatrix faces(3, 4);
    faces << 0, 0, 0, 1, /* b */ 2, 1, 3, 2, /* c */ 1, 3, 2, 3;
    if (sixfold < 0.0) faces.row(1).swap(faces.row(2));
    if (std::isfinite(sixfold) && sixfold != 0.0) net.pressure = {{faces, dice.positive()}};
  }
  return net;
}

std::vector<fuzzy::InputValue> randomInputs(Dice& dice, const fuzzy::RuleBase& rules)
{
  std::vector<fuzzy::InputValue> inputs;
  for (const fuzzy::Variable& variable : rules.inputs) {
    if (dice.coin())
      inputs.emplace_back(dice.uniform(0.0, 1.0));
    else
      inputs.emplace_back(fuzzy::Word{variable.terms[static_cast<std::size_t>(dice.below(3))].id,
                                      dice.coin() ? std::vector{fuzzy::Hedge::Not, fuzzy::Hedge::Very}
                                                  : std::vector<fuzzy::Hedge>{}});
  }
  return inputs;
}

LearnedLayer randomLayer(Dice& dice)
{
  LearnedLayer layer;
  layer.questions = {dice.coin(), {1.2}, {dice.uniform(10, 40), dice.uniform(50, 80)}, {}, {0.5}};
  layer.recordings = dice.below(20);
  for (int i = dice.below(4); i >= 0; --i) {
    LearnedFactor factor;
    factor.quantity = LearnedQuantity(dice.below(3));
    factor.of = {dice.coin() ? -1 : dice.below(kSpringKindCount), dice.below(2), dice.below(3), -1,
                 dice.coin() ? -1 : 1};
    if (dice.coin()) factor.region = dice.text();
    factor.value = dice.uniform(-3, 3);
    factor.deviation = dice.uniform(0, 1);
    factor.isSeen = dice.coin();
    layer.factors.push_back(factor);
  }
  if (dice.coin()) layer.springs = {{SpringId{3}, dice.uniform(-1, 1)}, {SpringId{17}, dice.uniform(-1, 1)}};
  return layer;
}

TissueModel randomTissue(Dice& dice)
{
  TissueModel tissue = defaultTissue();
  const auto parsed =
    fuzzy::parseRules("IF hardness IS not very hard AND (elasticity IS medium OR NOT shiftability IS "
                      "free) THEN youngs_modulus IS very high AND viscosity IS low WITH 0.8\n",
                      tissue.rules);
  const auto* rules = std::get_if<std::vector<fuzzy::Rule>>(&parsed);
  EXPECT_TRUE(rules) << "the rule text of the test must be right";
  if (rules) tissue.rules.rules.push_back(rules->front());
  tissue.rules.rules.back().note = dice.text();
  tissue.rules.rules.front().enabled = dice.coin();
  tissue.rules.inputs[0].terms[1].shape = fuzzy::Shape::Gaussian;
  tissue.rules.inputs[0].terms[1].parameters = {0.25, 0.1};
  tissue.inputs = randomInputs(dice, tissue.rules);
  for (int i = dice.below(3); i > 0; --i) {
    Region region;
    region.name = dice.text();
    region.ellipsoid.centre = dice.points(1);
    region.ellipsoid.semiAxes = Eigen::Vector3d(dice.uniform(0.001, 1), dice.uniform(0.001, 1), 1e-9);
    region.ellipsoid.rotation =
      Eigen::Quaterniond(dice.uniform(-1, 1), dice.uniform(-1, 1), dice.uniform(-1, 1), 0.1).normalized();
    region.falloff = dice.uniform(0, 1);
    region.enabled = dice.coin();
    region.inputs = randomInputs(dice, tissue.rules);
    region.profile = FalloffProfile(dice.below(3));
    region.insideOut = dice.coin();
    if (dice.coin())
      region.mirror = MirrorPlane{dice.points(1), Eigen::Vector3d(dice.uniform(-3, 3), 1.0, -2.0)};
    region.locked = dice.coin();
    region.visible = dice.coin();
    tissue.regions.push_back(std::move(region));
  }
  tissue.thickness = dice.uniform(1e-4, 1e-2);
  tissue.law = SpringLaw(dice.below(3));
  tissue.lawParameter = dice.uniform(0, 5);
  if (dice.coin()) tissue.learned = randomLayer(dice);
  return tissue;
}

ImportRecipe randomRecipe(Dice& dice)
{
  ImportRecipe recipe;
  for (int i = dice.below(4); i > 0; --i)
    recipe.files.push_back({"a" + dice.text(), dice.coin() ? 0xfedcba9876543210u + unsigned(i) : 0});
  recipe.unit = LengthUnit(dice.below(4));
  recipe.up = UpAxis(dice.below(2));
  recipe.patientAxes = PatientAxes(dice.below(3));
  recipe.ignoreStated = dice.coin();
  recipe.weldTolerance = dice.any();
  recipe.polygons = PolygonSprings(dice.below(2));
  if (dice.coin()) {
    recipe.repair.removeUseless = dice.coin();
    recipe.repair.dropPartsShare = dice.uniform(0, 1);
    recipe.repair.fillHolesUpTo = dice.below(1000);
    recipe.repair.edgeLength = dice.notNegative();
    recipe.support.interior = SupportOptions::Interior(dice.below(5));
    recipe.support.program = dice.text();
    recipe.support.anchors = SupportOptions::Anchors::Part;
    recipe.support.anchorPart.centre = dice.points(1);
    recipe.support.anchorLength = dice.notNegative();
    recipe.support.bulkModulus = dice.notNegative();
    recipe.material.body = MaterialOptions::Body(dice.below(2));
    recipe.material.edges = EdgeFormula(dice.below(2));
    recipe.material.fitModulus = dice.coin();
    recipe.material.youngsModulus = dice.notNegative();
    recipe.material.density = dice.notNegative();
    recipe.material.thickness = dice.notNegative();
  }
  return recipe;
}

} // namespace

Project randomProject(unsigned seed)
{
  Dice dice(seed);
  Project project;
  project.name = dice.text();
  project.source = randomRecipe(dice);
  project.net = randomNet(dice);
  project.parametersFromTissue = dice.coin();
  project.tissue = randomTissue(dice);
  const Index nodes = project.net.nodeCount();
  project.loads.gravity = dice.points(1);
  for (int i = dice.below(3); i > 0; --i) project.loads.forces.push_back({dice.nodes(nodes), dice.curve()});
  for (int i = dice.below(3); i > 0; --i)
    project.loads.motions.push_back(
      {dice.nodes(nodes), dice.curve(), dice.coin() ? std::optional(dice.any()) : std::nullopt});
  project.simulation = {
    dice.uniform(0, 10), dice.uniform(1, 1000), {"implicit", 1e-5, dice.notNegative(), 1 + dice.below(8)}};
  project.view = {dice.points(1), dice.notNegative(), dice.any(),  dice.any(),
                  "strain",       dice.coin(),        dice.coin(), dice.coin()};
  return project;
}

Project smallProject()
{
  Mesh mesh;
  mesh.position.resize(3, 5);
  mesh.position << 0, 0.01, 0, 0, 0.003, /* y */ 0, 0, 0.01, 0, 0.003, /* z */ 0, 0, 0, 0.01, 0.003;
  mesh.triangles.resize(3, 4);
  mesh.triangles << 0, 0, 1, 0, /* b */ 2, 1, 2, 3, /* c */ 1, 3, 3, 2;
  mesh.segments.resize(2, 2);
  mesh.segments << 0, 1, 4, 4;
  Project project;
  project.name = "small";
  project.net = buildNet(mesh).value();
  project.tissue = defaultTissue();
  EXPECT_TRUE(applyTissue(project.tissue, project.net));
  return project;
}

Scratch::Scratch()
{
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  m_path = std::filesystem::temp_directory_path() / (std::string("esm_") + test->test_suite_name() + "_" +
                                                     test->name() + "_" + std::to_string(::getpid()));
  std::filesystem::remove_all(m_path);
  std::filesystem::create_directories(m_path);
}

Scratch::~Scratch()
{
  std::error_code ignored;
  std::filesystem::remove_all(m_path, ignored);
}

std::size_t Scratch::fileCount() const
{
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(m_path))
    count += entry.is_regular_file();
  return count;
}

} // namespace esm::test
