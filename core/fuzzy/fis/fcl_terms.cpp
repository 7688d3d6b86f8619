// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/fis/fcl_terms.h"

#include "core/base/text_number.h"
#include "core/fuzzy/fis/fcl_formula.h"

#include <algorithm>
#include <array>
#include <optional>

namespace esm::fis {

namespace {

/// A shape of jFuzzyLogic, and where its parameters stand there: ours[i] = theirs[order[i]].
struct ForeignShape {
  std::string_view name;
  Shape shape;
  std::array<std::size_t, 4> order = {0, 1, 2, 3};
};
constexpr std::array<ForeignShape, 8> kForeignShapes = {{{"TRIAN", Shape::Triangle},
                                                         {"TRAPE", Shape::Trapezoid},
                                                         {"GAUSS", Shape::Gaussian},
                                                         {"GAUSS2", Shape::GaussianProduct},
                                                         {"GBELL", Shape::Bell, {2, 0, 1, 3}},
                                                         {"SIGM", Shape::Sigmoid, {1, 0, 2, 3}},
                                                         {"DSIGM", Shape::SigmoidDifference, {1, 0, 2, 3}},
                                                         {"COSINE", Shape::Cosine, {1, 0, 2, 3}}}};

class TermReader {
public:
  TermReader(FclScanner& scan, const System& system, bool onOutput)
    : m_scan(scan), m_system(system), m_onOutput(onOutput)
  {}

  FclTerm read()
  {
    const std::string_view name = m_scan.take();
    m_term.name = usableName(name);
    m_scan.expect(":=");
    const std::string_view first = m_scan.word();
    if (m_scan.accept("SINGLETONS")) return readSingletons();
    if (m_scan.is("("))
      m_term.shape = Shape::Discrete, m_term.parameters = readPoints();
    else if (!readNamedShape(first))
      setNumber(number());
    if (m_term.shape != Shape::Function)
      if (const Status status = checkTerm(m_term); !status)
        throw Fault{first.data(), "term " + shown(name) + ": " + status.error().detail};
    return {{m_term}};
  }

private:
  double number()
  {
    refuseVariable(m_scan.word());
    return m_scan.number();
  }

  void refuseVariable(std::string_view word) const
  {
    for (const InputVariable& input : m_system.inputs)
      if (input.name == word)
        throw Fault{word.data(),
                    shown(word) +
                      " is a variable; curves that move with a variable are not read, write a number"};
  }

  void setNumber(double value)
  {
    m_term.shape = m_onOutput ? Shape::Constant : Shape::Rectangle;
    m_term.parameters.assign(m_onOutput ? 1 : 2, value);
  }

  /// (x, y) (x, y) ...
  std::vector<double> readPoints()
  {
    std::vector<double> points;
    while (m_scan.accept("(")) {
      points.push_back(number());
      m_scan.expect(",");
      points.push_back(number());
      m_scan.expect(")");
    }
    return points;
  }

  /// Heights at single places, 0 between them.
  FclTerm readSingletons()
  {
    const std::vector<double> points = readPoints();
    if (points.empty()) throw Fault{m_scan.word().data(), "here points (x, y) were expected"};
    FclTerm result;
    m_term.shape = Shape::Discrete;
    for (std::size_t i = 0; i < points.size(); i += 2) {
      const double x = points[i], height = points[i + 1];
      if (m_onOutput) {
        const std::string name = m_term.name + (i == 0 ? "" : '_' + std::to_string(i / 2 + 1));
        result.terms.push_back({name, Shape::Constant, {x}, 1.0, {}});
        result.heights.push_back(height);
      }
      m_term.parameters.insert(m_term.parameters.end(), {x, 0.0, x, height, x, 0.0});
    }
    if (!m_onOutput) result.terms.push_back(m_term);
    return result;
  }

  bool readNamedShape(std::string_view word)
  {
    if (const auto shape = shapeNamed(word)) {
      m_scan.take();
      readOwn(*shape);
      return true;
    }
    if (m_scan.accept("FUNCTION")) {
      m_term.shape = Shape::Function;
      m_term.formula = formulaOfFcl(m_scan.upTo(';'), m_system);
      return true;
    }
    if (m_scan.accept("SINGLETON")) {
      setNumber(number());
      return true;
    }
    for (const ForeignShape& foreign : kForeignShapes)
      if (m_scan.accept(foreign.name)) {
        readForeign(foreign);
        return true;
      }
    return false;
  }

  std::vector<double> readNumbers()
  {
    std::vector<double> numbers;
    std::string_view rest = m_scan.upTo(';');
    constexpr std::string_view kBetween = " \t\r\n,()";
    while (!(rest = rest.substr(std::min(rest.find_first_not_of(kBetween), rest.size()))).empty()) {
      const std::size_t end = std::min(rest.find_first_of(kBetween), rest.size());
      refuseVariable(rest.substr(0, end));
      numbers.push_back(readNumber(rest.substr(0, end)));
      rest.remove_prefix(end);
    }
    return numbers;
  }

  /// As fuzzylite writes it, with the height at the end where it is not 1.
  void readOwn(Shape shape)
  {
    m_term.shape = shape;
    if (shape == Shape::Function) {
      m_term.formula = std::string(m_scan.upTo(';'));
      return;
    }
    m_term.parameters = readNumbers();
    const std::size_t count = m_term.parameters.size();
    const int needed = parameterCount(shape);
    const bool surplus = shape == Shape::Discrete
                           ? count % 2 == 1
                           : needed >= 0 && count == static_cast<std::size_t>(needed) + 1;
    if (!surplus || isNumber(shape)) return;
    m_term.height = m_term.parameters.back();
    m_term.parameters.pop_back();
  }

  void readForeign(const ForeignShape& foreign)
  {
    const char* place = m_scan.word().data();
    const std::vector<double> numbers = readNumbers();
    const auto needed = static_cast<std::size_t>(parameterCount(foreign.shape));
    if (numbers.size() != needed)
      throw Fault{place, std::string(foreign.name) + " needs " + std::to_string(needed) +
                           " numbers, it has " + std::to_string(numbers.size())};
    m_term.shape = foreign.shape;
    for (std::size_t i = 0; i < needed; ++i) m_term.parameters.push_back(numbers[foreign.order[i]]);
    if (foreign.shape == Shape::Cosine) m_term.parameters[1] *= 2.0; // theirs is half of the wave
    if (foreign.shape == Shape::SigmoidDifference) cutBelowZero();
  }

  /// DSIGM is 0 where the difference is negative; the shape of that name takes its magnitude. Equal slopes
  /// never change the sign.
  void cutBelowZero()
  {
    const std::vector<double> p = m_term.parameters; // left rising falling right
    if (p[1] == p[2] && (p[3] - p[0]) * p[1] >= 0.0) return;
    const auto sigmoid = [](double inflection, double slope) {
      return "1 / (1 + exp((0 - (" + formatDouble(slope) + ")) * (x - (" + formatDouble(inflection) + "))))";
    };
    m_term = {m_term.name,
              Shape::Function,
              {},
              1.0,
              "max(0, " + sigmoid(p[0], p[1]) + " - " + sigmoid(p[3], p[2]) + ")"};
  }

  FclScanner& m_scan;
  const System& m_system;
  bool m_onOutput;
  Term m_term;
};

} // namespace

FclTerm readFclTerm(FclScanner& scan, const System& system, bool onOutput)
{
  return TermReader(scan, system, onOutput).read();
}

} // namespace esm::fis
