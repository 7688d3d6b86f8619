// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/project/xsp_format.h"

#include "core/base/text_number.h"
#include "core/net/net_builder.h"

#include <cmath>
#include <limits>
#include <optional>

namespace esm {

namespace {

constexpr std::string_view kBlanks = " \t\r\v\f";

struct Mass {
  Eigen::Vector3d position, velocity;
  double mass = 1.0;
  bool fixed = false;
};

struct Spring {
  Index a, b;
  double stiffness, viscosity, length;
};

/// Goes through the file line by line; the first fault stays.
class XspReader {
public:
  XspReader(std::string_view bytes, const std::string& origin) : m_rest(bytes), m_origin(origin) {}

  Result<Project> read(std::vector<std::string>* notes)
  {
    readHead();
    while (!m_fault && nextLine()) readCommand();
    if (!m_fault) checkCounts();
    if (m_fault) return *m_fault;
    if (notes) *notes = std::move(m_notes);
    return project();
  }

private:
  bool nextLine()
  {
    if (m_rest.empty()) return false;
    const std::size_t end = std::min(m_rest.find('\n'), m_rest.size());
    m_lineRest = m_rest.substr(0, end);
    m_rest.remove_prefix(std::min(end + 1, m_rest.size()));
    ++m_line;
    return true;
  }
  std::string_view word()
  {
    m_lineRest.remove_prefix(std::min(m_lineRest.find_first_not_of(kBlanks), m_lineRest.size()));
    const std::string_view found = m_lineRest.substr(0, m_lineRest.find_first_of(kBlanks));
    m_lineRest.remove_prefix(found.size());
    return found;
  }
  void fail(const std::string& what, ErrorCode code = ErrorCode::BadFormat)
  {
    if (!m_fault) m_fault = Error{code, m_origin + ": line " + std::to_string(m_line) + ": " + what};
  }
  double number(const char* what)
  {
    const std::string_view text = word();
    const std::optional<double> value = parseDouble(text);
    if (value && std::isfinite(*value)) return *value;
    fail(std::string("the ") + what + (text.empty() ? " is missing" : " is no finite number"));
    return 0.0;
  }
  long long integer(const char* what, long long least, long long most)
  {
    const std::optional<long long> value = parseInteger(word());
    if (value && *value >= least && *value <= most) return *value;
    fail(std::string("the ") + what + " must be a whole number from " + std::to_string(least) + " to " +
         std::to_string(most));
    return least;
  }
  Eigen::Vector3d vector(const char* what)
  {
    const double x = number(what), y = number(what), z = number(what);
    return {x, y, z};
  }

  void readHead()
  {
    nextLine();
    word(); // "Xsp", see looksLikeXsp()
    const std::optional<double> version = parseDouble(word());
    if (!version || *version != 3.0)
      fail(
        "this is not version 3.0 of the Xsp format, the only one that can be read; write the net as Xsp 3.0",
        ErrorCode::Unsupported);
  }
  void readCommand()
  {
    const std::string_view command = word();
    if (command.empty() || command[0] == '#') return;
    if (command == "numm")
      m_massCount = integer("number of masses", 0, kMost);
    else if (command == "nums")
      m_springCount = integer("number of springs", 0, kMost);
    else if (command == "grav")
      m_gravity = vector("gravity");
    else if (command == "mass")
      readMass();
    else if (command == "lspg")
      readSpring();
    else if (command == "visc")
      readViscosity();
    else if (command == "step" || command == "frce")
      return; // of the program that wrote it
    else
      fail("\"" + std::string(command.substr(0, 30)) + "\" is no word of the format");
    if (const std::string_view more = word(); !m_fault && !more.empty() && more[0] != '#')
      fail("there is more on the line than belongs to it");
  }
  void readMass()
  {
    integer("number of the mass", 0, kMost); // its place counts
    const std::string_view place = word();
    if (place != "s" && place != "v") fail("the place of a mass must be s or v");
    Mass mass;
    mass.position = vector("position");
    mass.velocity = vector("velocity");
    const double value = number("mass");
    number("elasticity");
    mass.fixed = std::signbit(value);
    mass.mass = std::abs(value);
    if (!m_fault && !(mass.mass > 0.0)) fail("a mass must not be 0", ErrorCode::InvalidValue);
    if (m_masses.size() >= static_cast<std::size_t>(kMost)) fail("there are too many masses");
    m_masses.push_back(mass);
  }
  void readSpring()
  {
    integer("number of the spring", 0, kMost);
    const auto count = static_cast<long long>(m_masses.size());
    if (count < 2) return fail("a spring needs two masses before it");
    Spring spring{};
    spring.a = static_cast<Index>(integer("first mass of the spring", 1, count) - 1);
    spring.b = static_cast<Index>(integer("second mass of the spring", 1, count) - 1);
    spring.stiffness = number("stiffness");
    spring.viscosity = number("damping");
    spring.length = number("rest length");
    if (m_fault) return;
    if (spring.a == spring.b) return fail("a spring must join two masses, not one", ErrorCode::InvalidValue);
    if (spring.length == -1.0) takeDistance(spring);
    if (spring.stiffness < 0.0 || spring.viscosity < 0.0 || spring.length < 0.0)
      fail("stiffness, damping and rest length must not be negative", ErrorCode::InvalidValue);
    m_springs.push_back(spring);
  }
  /// A length of -1: the distance of the masses, and stiffness and damping are of a unit of length.
  void takeDistance(Spring& spring)
  {
    spring.length = (m_masses[static_cast<std::size_t>(spring.a)].position -
                     m_masses[static_cast<std::size_t>(spring.b)].position)
                      .stableNorm();
    if (!(spring.length > 0.0) || !std::isfinite(spring.length))
      return fail("a spring whose length is the distance of its masses needs two apart from each other",
                  ErrorCode::InvalidValue);
    spring.stiffness /= spring.length;
    spring.viscosity /= spring.length;
  }
  void readViscosity()
  {
    if (number("viscosity") != 0.0)
      m_notes.push_back("The viscosity of the surroundings (visc) was passed over: its unit is not defined.");
  }
  void checkCounts()
  {
    const auto check = [&](const std::optional<long long>& promised, std::size_t found, const char* what) {
      if (promised && *promised != static_cast<long long>(found))
        m_notes.push_back("The file promises " + std::to_string(*promised) + " " + what + " and holds " +
                          std::to_string(found) + ".");
    };
    check(m_massCount, m_masses.size(), "masses");
    check(m_springCount, m_springs.size(), "springs");
    if (m_springs.empty()) m_fault = Error{ErrorCode::EmptyResult, m_origin + ": there is no spring in it"};
  }

  Result<Project> project() const
  {
    Project project;
    project.parametersFromTissue = false;
    project.tissue = defaultTissue();
    project.loads.gravity = m_gravity;
    SpringNet& net = project.net;
    resizeNet(net, static_cast<Index>(m_masses.size()), static_cast<Index>(m_springs.size()));
    bool moves = false;
    for (const Mass& mass : m_masses) moves |= !mass.velocity.isZero(0.0);
    if (moves) net.initialVelocity.resize(3, net.nodeCount());
    for (std::size_t i = 0; i < m_masses.size(); ++i) {
      const auto node = static_cast<Eigen::Index>(i);
      net.restPosition.col(node) = m_masses[i].position;
      if (moves) net.initialVelocity.col(node) = m_masses[i].velocity;
      net.mass[node] = m_masses[i].mass;
      net.fixed[i] = m_masses[i].fixed;
    }
    for (std::size_t s = 0; s < m_springs.size(); ++s) {
      const auto spring = static_cast<Eigen::Index>(s);
      net.ends.col(spring) << m_springs[s].a, m_springs[s].b;
      net.restLength[spring] = m_springs[s].length;
      net.stiffness[spring] = m_springs[s].stiffness;
      net.viscosity[spring] = m_springs[s].viscosity;
      net.kind[s] = SpringKind::Line;
    }
    if (const Status status = checkNet(net); !status)
      return Error{status.error().code, m_origin + ": " + status.error().detail};
    return project;
  }

  static constexpr long long kMost = 500'000'000;

  std::string_view m_rest, m_lineRest;
  const std::string& m_origin;
  long m_line = 0;
  std::optional<Error> m_fault;
  std::vector<std::string> m_notes;
  std::optional<long long> m_massCount, m_springCount;
  Eigen::Vector3d m_gravity = Eigen::Vector3d::Zero();
  std::vector<Mass> m_masses;
  std::vector<Spring> m_springs;
};

} // namespace

bool looksLikeXsp(std::string_view bytes) noexcept
{
  return bytes.substr(0, 4) == "Xsp " || bytes.substr(0, 4) == "Xsp\t";
}

Result<Project> parseXsp(std::string_view bytes, const std::string& origin, std::vector<std::string>* notes)
{
  if (!looksLikeXsp(bytes)) return Error{ErrorCode::BadFormat, origin + ": does not begin with \"Xsp\""};
  return XspReader(bytes, origin).read(notes);
}

} // namespace esm
