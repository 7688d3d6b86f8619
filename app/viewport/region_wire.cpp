// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/viewport/region_wire.h"

#include <cmath>
#include <numbers>

namespace esm {

namespace {

constexpr int kSegments = 64;

/// Appends places of the unit ball as they lie in an ellipsoid.
class WireWriter {
public:
  WireWriter(const Ellipsoid& ellipsoid, const Eigen::Vector3d& origin, std::vector<float>& lines)
    : m_ellipsoid(ellipsoid), m_origin(origin), m_lines(lines)
  {}
  bool usable() const
  {
    return m_ellipsoid.centre.allFinite() && m_ellipsoid.semiAxes.allFinite() &&
           m_ellipsoid.rotation.coeffs().allFinite();
  }
  void point(const Eigen::Vector3d& unit)
  {
    const Eigen::Vector3d world =
      m_ellipsoid.centre + m_ellipsoid.rotation * m_ellipsoid.semiAxes.cwiseProduct(unit) - m_origin;
    for (int c = 0; c < 3; ++c) m_lines.push_back(static_cast<float>(world(c)));
  }
  /// centre + cos(t) u + sin(t) v. @param every how many segments one is drawn.
  void circle(const Eigen::Vector3d& centre, const Eigen::Vector3d& u, const Eigen::Vector3d& v,
              int every = 1)
  {
    const auto at = [&](int i) -> Eigen::Vector3d {
      const double t = 2.0 * std::numbers::pi * i / kSegments;
      return centre + std::cos(t) * u + std::sin(t) * v;
    };
    for (int i = 0; i < kSegments; i += every) {
      point(at(i));
      point(at(i + 1));
    }
  }

private:
  const Ellipsoid& m_ellipsoid;
  const Eigen::Vector3d& m_origin;
  std::vector<float>& m_lines;
};

const Eigen::Vector3d kX = Eigen::Vector3d::UnitX(), kY = Eigen::Vector3d::UnitY(),
                      kZ = Eigen::Vector3d::UnitZ(), kMiddle = Eigen::Vector3d::Zero();

} // namespace

void appendRegionWire(const Ellipsoid& ellipsoid, const Eigen::Vector3d& origin, std::vector<float>& lines)
{
  WireWriter wire(ellipsoid, origin, lines);
  if (!wire.usable()) return;
  wire.circle(kMiddle, kX, kY);
  wire.circle(kMiddle, kX, kZ);
  wire.circle(kMiddle, kY, kZ);
  const double half = std::sqrt(0.5);
  wire.circle(kMiddle, half * (kX + kY), kZ);
  wire.circle(kMiddle, half * (kX - kY), kZ);
  wire.circle(half * kZ, half * kX, half * kY);
  wire.circle(-half * kZ, half * kX, half * kY);
}

void appendRegionShell(const Ellipsoid& ellipsoid, const Eigen::Vector3d& origin, std::vector<float>& lines)
{
  WireWriter wire(ellipsoid, origin, lines);
  if (!wire.usable()) return;
  wire.circle(kMiddle, kX, kY, 2);
  wire.circle(kMiddle, kX, kZ, 2);
  wire.circle(kMiddle, kY, kZ, 2);
}

void appendRegionSpines(const Ellipsoid& ellipsoid, const Eigen::Vector3d& origin, std::vector<float>& lines)
{
  WireWriter wire(ellipsoid, origin, lines);
  if (!wire.usable()) return;
  constexpr int kSpines = 32;
  constexpr double kLength = 0.12; // of the radius
  const Eigen::Vector3d planes[][2] = {{kX, kY}, {kX, kZ}, {kY, kZ}};
  for (const auto& [u, v] : planes)
    for (int i = 0; i < kSpines; ++i) {
      const double t = 2.0 * std::numbers::pi * i / kSpines;
      const Eigen::Vector3d unit = std::cos(t) * u + std::sin(t) * v;
      wire.point(unit);
      wire.point((1.0 + kLength) * unit);
    }
}

} // namespace esm
