// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/axis.h"
#include "core/fuzzy/control_surface.h"
#include "tests/core/fuzzy/small_rules.h"

#include <cmath>

namespace esm::fuzzy {
namespace {

/// Two inputs and a third that the surface leaves alone; two outputs, one logarithmic, rules about both.
RuleBase surfaceRules()
{
  RuleBase base = smallRules();
  base.outputs[0].logarithmic = true;
  base.outputs[0].minimum = 1.0;
  base.outputs[0].maximum = 1000.0;
  base.outputs[0].defaultValue = 10.0;
  base.outputs[0].terms = {makeTerm("low", Shape::Triangle, {0, 1, 2}),
                           makeTerm("high", Shape::Trapezoid, {1, 2, 2.5, 3})};
  base.rules.clear();
  const std::string first = base.outputs[0].id, second = base.outputs[1].id;
  const auto is = [](const std::string& variable, const std::string& term) {
    Condition condition;
    condition.nodes.push_back({Condition::Kind::Proposition, {variable, term, {}}, {}});
    return condition;
  };
  const auto termOf = [&](const Variable& variable, std::size_t i) { return variable.terms[i].id; };
  const Variable &x = base.inputs[0], &y = base.inputs[1], &z = base.inputs[2];
  base.rules.push_back(
    {is(x.id, termOf(x, 0)), {{first, "low", {}}, {second, termOf(base.outputs[1], 0), {}}}, 1.0, true, ""});
  base.rules.push_back({is(y.id, termOf(y, 1)), {{first, "high", {}}}, 0.7, true, ""});
  base.rules.push_back({is(z.id, termOf(z, 0)), {{first, "high", {Hedge::Very}}}, 0.5, true, ""});
  base.rules.push_back({is(x.id, termOf(x, 1)), {{first, "low", {}}}, 1.0, false, ""});
  return base;
}

TEST(ControlSurface, EqualsTheEngineAtEveryGridPlace)
{
  const RuleBase base = surfaceRules();
  const auto engine = Engine::create(base);
  ASSERT_TRUE(engine);
  for (const int output : {0, 1}) {
    std::vector<InputValue> inputs{0.1, 0.2, Word{base.inputs[2].terms[1].id, {}}};
    const auto surface = controlSurface(base, {output, 1, 0, 7, 5}, inputs);
    ASSERT_TRUE(surface);
    ASSERT_EQ(surface->columns(), 7U);
    ASSERT_EQ(surface->rows(), 5U);
    EXPECT_EQ(surface->x.front(), base.inputs[1].minimum);
    EXPECT_EQ(surface->x.back(), base.inputs[1].maximum);
    for (std::size_t row = 0; row < 5; ++row)
      for (std::size_t column = 0; column < 7; ++column) {
        inputs[1] = surface->x[column];
        inputs[0] = surface->y[row];
        const OutputValue expected = engine->evaluate(inputs).outputs[static_cast<std::size_t>(output)];
        EXPECT_EQ(surface->at(row, column), expected.value);
        EXPECT_EQ(surface->firedAt(row, column), expected.fromRules);
      }
  }
}

TEST(ControlSurface, SaysWhereNoRuleFires)
{
  RuleBase base = surfaceRules();
  base.rules.resize(1); // only where x is at all its first term, which falls to 0 at the right end
  const auto surface = controlSurface(base, {0, 0, 1, 11, 3}, {});
  ASSERT_TRUE(surface);
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 11; ++column) {
      EXPECT_EQ(surface->firedAt(row, column), column < 10);
      if (column == 10) {
        EXPECT_EQ(surface->at(row, column), base.outputs[0].defaultValue);
      }
    }
}

TEST(ControlSurface, RefusesWhatIsNoSurface)
{
  const RuleBase base = surfaceRules();
  for (const SurfaceQuestion& question :
       {SurfaceQuestion{0, 1, 1, 5, 5}, SurfaceQuestion{2, 0, 1, 5, 5}, SurfaceQuestion{0, -1, 1, 5, 5},
        SurfaceQuestion{0, 0, 3, 5, 5}, SurfaceQuestion{0, 0, 1, 1, 5}})
    EXPECT_FALSE(controlSurface(base, question, {}));
}

ControlSurface made(std::size_t columns, std::size_t rows, double (*height)(double, double))
{
  ControlSurface surface;
  surface.x.resize(columns);
  surface.y.resize(rows);
  for (std::size_t r = 0; r < rows; ++r)
    for (std::size_t c = 0; c < columns; ++c)
      surface.value.push_back(height(static_cast<double>(c), static_cast<double>(r)));
  surface.fired.assign(surface.value.size(), 1);
  return surface;
}

Variable plainOutput(double minimum, double maximum, bool logarithmic)
{
  return {"o", {"o", "o"}, "", minimum, maximum, minimum, logarithmic, {}};
}

TEST(ContourLines, OfAPlaneAreStraightAndWhole)
{
  const ControlSurface plane = made(6, 5, [](double x, double y) { return x + 2.0 * y; });
  const auto lines = contourLines(plane, plainOutput(0, 20, false), 4.5);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_GE(lines[0].size(), 6U);
  for (const auto& [x, y] : lines[0]) EXPECT_NEAR(x + 2.0 * y, 4.5, 1e-12);
  const auto& a = lines[0].front();
  const auto& b = lines[0].back();
  for (const auto& end : {a, b}) EXPECT_TRUE(end[0] == 0 || end[0] == 5 || end[1] == 0 || end[1] == 4);
}

TEST(ContourLines, OnALogScaleLieAtTheLogarithm)
{
  const ControlSurface rising = made(5, 3, [](double x, double) { return std::pow(10.0, x); });
  const auto lines = contourLines(rising, plainOutput(1, 1e4, true), 300.0);
  ASSERT_EQ(lines.size(), 1U);
  for (const auto& point : lines[0]) EXPECT_NEAR(point[0], std::log10(300.0), 1e-12);
}

TEST(ContourLines, AroundAHillAreClosed)
{
  const ControlSurface hill =
    made(9, 9, [](double x, double y) { return 10.0 - std::hypot(x - 4.0, y - 4.0); });
  const auto lines = contourLines(hill, plainOutput(0, 20, false), 7.6);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].front(), lines[0].back());
  for (const auto& [x, y] : lines[0])
    EXPECT_NEAR(std::hypot(x - 4, y - 4), 2.4, 0.15); // cells are flat: sagitta
}

TEST(ContourLines, OfASaddleDoNotCross)
{
  const ControlSurface saddle = made(2, 2, [](double x, double y) { return x == y ? 1.0 : 0.0; });
  for (const double level : {0.3, 0.7}) {
    const auto lines = contourLines(saddle, plainOutput(0, 1, false), level);
    ASSERT_EQ(lines.size(), 2U);
    for (const ContourLine& line : lines) EXPECT_EQ(line.size(), 2U);
  }
}

TEST(ContourLines, DoNotEnterCellsWithoutRules)
{
  ControlSurface plane = made(6, 3, [](double x, double) { return x; });
  plane.fired[3] = 0;
  EXPECT_TRUE(contourLines(plane, plainOutput(0, 5, false), 3.5)[0].size() == 2); // only the upper cell
}

TEST(ContourLevels, AreRoundAndWithin)
{
  EXPECT_EQ(contourLevels(0.0, 1.0, false, 5), (std::vector<double>{0.2, 0.4, 0.6000000000000001, 0.8}));
  EXPECT_EQ(contourLevels(1e3, 1e5, true, 6), (std::vector<double>{2e3, 5e3, 1e4, 2e4, 5e4}));
  EXPECT_EQ(contourLevels(1e2, 1e8, true, 6), (std::vector<double>{1e3, 1e4, 1e5, 1e6, 1e7}));
  EXPECT_TRUE(contourLevels(3.0, 3.0, false, 6).empty());
  for (const bool logarithmic : {false, true})
    for (int most = 1; most < 9; ++most)
      for (const double span : {1.001, 1.3, 7.0, 1e3, 1e9}) {
        const std::vector<double> levels = contourLevels(2.0, 2.0 * span, logarithmic, most);
        EXPECT_LE(levels.size(), static_cast<std::size_t>(most));
        for (const double level : levels) EXPECT_TRUE(level > 2.0 && level < 2.0 * span);
      }
}

} // namespace
} // namespace esm::fuzzy
