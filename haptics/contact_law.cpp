// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/contact_law.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr double kBlendShare = 0.25;                          ///< of the time between two models
constexpr double kLeastInterval = 0.001, kMostInterval = 0.1; ///< [s]
constexpr double kTickSmoothing = 1.0;                        ///< [s]

constexpr double kImplausible = 1e9; ///< [m], [N], [N/m], [N s/m]; sums of such numbers stay finite

/// Whether all entries are numbers that a tissue can have (NaN compares false).
template <class Matrix>
bool isPlausible(const Matrix& matrix)
{
  return (matrix.array().abs() < kImplausible).all();
}

bool isPlausible(const ContactModel& model)
{
  return isPlausible(model.position) && isPlausible(model.force) && isPlausible(model.stiffness) &&
         isPlausible(model.viscosity);
}

/// The symmetric part with its eigenvalues moved into [0, most].
Eigen::Matrix3d capped(const Eigen::Matrix3d& matrix, double most, double& least) noexcept
{
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen;
  eigen.computeDirect(0.5 * (matrix + matrix.transpose()));
  const Eigen::Vector3d values = eigen.eigenvalues().cwiseMax(0.0).cwiseMin(most);
  least = values.minCoeff();
  return eigen.eigenvectors() * values.asDiagonal() * eigen.eigenvectors().transpose();
}

} // namespace

ContactLaw::ContactLaw(const DeviceProfile& profile) noexcept
  : m_maxStiffness(profile.maxStiffness),
    m_maxDamping(profile.maxDamping),
    m_ownDamping(profile.ownDamping),
    m_delay(profile.delay),
    m_tick(profile.period)
{}

double ContactLaw::stiffnessCap(double damping) const noexcept
{
  const double limit = 2.0 * (m_ownDamping + damping) / (m_tick + 2.0 * m_delay);
  return std::min(m_maxStiffness, kStabilityShare * limit);
}

ContactLaw::Plane ContactLaw::planeOf(const ContactModel& model) const noexcept
{
  Plane plane;
  double least = 0.0, ignored = 0.0;
  plane.viscosity = capped(model.viscosity, m_maxDamping, least);
  plane.stiffness = capped(model.stiffness, stiffnessCap(least), ignored);
  plane.constant = model.force + plane.stiffness * model.position;
  return plane;
}

ContactLaw::Plane ContactLaw::blended() const noexcept
{
  Plane plane;
  plane.constant = m_from.constant + m_blend * (m_to.constant - m_from.constant);
  plane.stiffness = m_from.stiffness + m_blend * (m_to.stiffness - m_from.stiffness);
  plane.viscosity = m_from.viscosity + m_blend * (m_to.viscosity - m_from.viscosity);
  return plane;
}

bool ContactLaw::take(const ContactModel& model, double now) noexcept
{
  if (model.sequence == m_sequence) return true;
  m_sequence = model.sequence;
  if (!isPlausible(model)) return false;
  const bool goesOn = present();
  m_active = model.active;
  if (!model.active) return true; // the old plane fades out
  if (goesOn) m_interval += 0.2 * (std::clamp(now - m_arrival, kLeastInterval, kMostInterval) - m_interval);
  m_arrival = now;
  m_stale = false;
  m_from = blended();
  m_to = planeOf(model);
  m_blend = 0.0;
  if (m_presence == 0.0) m_blend = 1.0; // nothing is felt yet that could jump
  return true;
}

void ContactLaw::forget() noexcept
{
  m_active = m_stale = false;
  m_presence = 0.0;
}

Eigen::Vector3d ContactLaw::force(double now, double dt, const Eigen::Vector3d& position,
                                  const Eigen::Vector3d& velocity) noexcept
{
  m_tick += (1.0 - std::exp(-dt / kTickSmoothing)) * (dt - m_tick);
  m_blend = std::min(1.0, m_blend + dt / (kBlendShare * m_interval));
  m_stale = m_active && now - m_arrival > kStaleAfter;
  m_presence = std::clamp(m_presence + (present() ? dt : -dt) / kFadeTime, 0.0, 1.0);
  if (m_presence == 0.0) return Eigen::Vector3d::Zero();
  const Plane plane = blended();
  return m_presence * (plane.constant - plane.stiffness * position - plane.viscosity * velocity);
}

} // namespace esm
