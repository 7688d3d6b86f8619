// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/contact_law.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr double kBlendShare = 0.25;     ///< of the time between two models
constexpr double kLeastInterval = 0.001; ///< [s]
constexpr double kTickSmoothing = 1.0;   ///< [s]
constexpr double kUnevenShare = 2.0;     ///< of the ticks' deviation counts as tick
constexpr double kSlack = 1.0;           ///< [N/m]; a softer spring stores nothing

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
         isPlausible(model.viscosity) && isPlausible(model.normal) && std::abs(model.friction) < kImplausible;
}

/// The symmetric part of a matrix in its own axes, with its eigenvalues moved into [0, most].
struct CappedMatrix {
  CappedMatrix(const Eigen::Matrix3d& matrix, double most) noexcept
  {
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen;
    eigen.computeDirect(0.5 * (matrix + matrix.transpose()));
    axes = eigen.eigenvectors();
    values = eigen.eigenvalues().cwiseMax(0.0).cwiseMin(most);
  }
  Eigen::Matrix3d matrix() const noexcept { return axes * values.asDiagonal() * axes.transpose(); }
  Eigen::Matrix3d inverse() const noexcept
  {
    const Eigen::Vector3d inverses = (values.array() > kSlack).select(values.cwiseInverse(), 0.0);
    return axes * inverses.asDiagonal() * axes.transpose();
  }
  Eigen::Matrix3d axes;
  Eigen::Vector3d values;
};

/// A touched surface pushes along its normal, and drags no more than its friction allows.
Eigen::Vector3d touching(const Eigen::Vector3d& force, const Eigen::Vector3d& normal,
                         double friction) noexcept
{
  if (normal.isZero(0.0)) return force;
  const double push = force.dot(normal);
  if (push <= 0.0) return Eigen::Vector3d::Zero();
  const Eigen::Vector3d drag = force - push * normal;
  const double size = drag.norm(), most = friction * push;
  return size > most ? Eigen::Vector3d(push * normal + drag * (most / size)) : force;
}

} // namespace

ContactLaw::ContactLaw(const DeviceProfile& profile) noexcept
  : m_maxStiffness(profile.maxStiffness),
    m_maxDamping(profile.maxDamping),
    m_ownDamping(profile.ownDamping),
    m_leastDelay(profile.delay),
    m_delay(profile.delay),
    m_tick(profile.period)
{}

double ContactLaw::stiffnessCap(double damping) const noexcept
{
  const double tick = m_tick + kUnevenShare * m_unevenness;
  const double limit = 2.0 * (m_ownDamping + damping) / (tick + 2.0 * m_delay);
  return std::min(m_maxStiffness, kStabilityShare * limit);
}

ContactLaw::Plane ContactLaw::planeOf(const ContactModel& model, double scale) const noexcept
{
  Plane plane;
  const CappedMatrix viscosity(scale * model.viscosity, m_maxDamping);
  plane.viscosity = viscosity.matrix();
  const CappedMatrix stiffness(scale * model.stiffness, stiffnessCap(viscosity.values.minCoeff()));
  plane.stiffness = stiffness.matrix();
  plane.compliance = stiffness.inverse();
  plane.place = model.position;
  plane.constant = scale * model.force + plane.stiffness * model.position;
  if (const double length = model.normal.norm(); length > 0.0) plane.normal = model.normal / length;
  plane.friction = std::max(model.friction, 0.0);
  return plane;
}

bool ContactLaw::take(const ContactModel& model, double now, double scale) noexcept
{
  if (model.sequence == m_sequence) return true;
  if (!isPlausible(model)) {
    m_sequence = model.sequence;
    return false;
  }
  hear(model, now);
  if (m_stale) return true; // the next ones will be asked
  const bool goesOn = model.scene == m_scene;
  const bool fades = m_presence > 0.0;
  m_sceneLeaves = fades && model.scene != m_scene;
  m_leaves = m_sceneLeaves || (fades && model.active && !m_active);
  if (m_leaves) return true; // asked again with the next tick
  if (goesOn) {
    m_interval += 0.2 * (std::clamp(m_gap, kLeastInterval, kLongestHold) - m_interval);
    if (model.edition != m_edition || scale != m_scale) m_editLeft = kEditTime;
  }
  m_sequence = model.sequence;
  m_scene = model.scene;
  m_edition = model.edition;
  m_scale = scale;
  m_active = model.active;
  if (!model.active) return true; // the old plane fades out
  m_plane = planeOf(model, scale);
  m_isNew = true;
  return true;
}

/// Counts answers that came in time. Another scene owes none: it begins anew.
void ContactLaw::hear(const ContactModel& model, double now) noexcept
{
  if (model.sequence == m_heard) return;
  m_heard = model.sequence;
  m_gap = now - m_arrival;
  m_arrival = now;
  if (model.scene != m_scene)
    m_timely = kTimelyAnswers;
  else
    m_timely = m_gap <= kLateAfter ? std::min(m_timely + 1, kTimelyAnswers) : 0;
  m_stale = m_stale && m_timely < kTimelyAnswers;
}

/// Whether a plane that is late may go on. @param force  that it would be felt with, without presence [N].
void ContactLaw::hold(double now, const Eigen::Vector3d& position, const Eigen::Vector3d& force) noexcept
{
  const double silence = now - m_arrival;
  m_holds = m_scene != 0 && silence > kLateAfter && !m_stale;
  if (!m_holds) return;
  const bool isTrusted = !m_plane.compliance.isZero(0.0) && (position - m_plane.place).norm() <= kTrustedWay;
  const bool ends = m_active && !isTrusted && !force.isZero(0.0);
  m_stale = silence > kLongestHold || (ends && m_size > 0.0);
  m_holds = !m_stale;
  if (!ends || m_stale) return;
  m_active = false; // nothing of it was felt: it does not begin
  m_presence = 0.0;
}

void ContactLaw::forget() noexcept
{
  m_active = false;
  m_presence = m_stored = m_size = 0.0;
}

/// Mean and mean deviation of the ticks; the age rises at once and falls slowly.
void ContactLaw::measure(double dt, double age) noexcept
{
  const double weight = 1.0 - std::exp(-dt / kTickSmoothing);
  m_tick += weight * (dt - m_tick);
  m_unevenness += weight * (std::abs(dt - m_tick) - m_unevenness);
  const double delay = std::max(age, m_leastDelay);
  m_delay = std::max(delay, m_delay + weight * (delay - m_delay));
}

Eigen::Vector3d ContactLaw::force(double now, double dt, const Eigen::Vector3d& position,
                                  const Eigen::Vector3d& velocity, double age) noexcept
{
  measure(dt, age);
  const Eigen::Vector3d full =
    touching(m_plane.constant - m_plane.stiffness * position - m_plane.viscosity * velocity, m_plane.normal,
             m_plane.friction);
  hold(now, position, full);
  const bool wasAbsent = m_presence == 0.0;
  m_presence = std::clamp(m_presence + (present() ? dt : -dt) / kFadeTime, 0.0, 1.0);
  m_begins = wasAbsent && m_presence > 0.0;
  m_stored = m_size = 0.0;
  if (m_presence == 0.0) return Eigen::Vector3d::Zero();

  const Eigen::Vector3d elastic =
    touching(m_plane.constant - m_plane.stiffness * position, m_plane.normal, m_plane.friction);
  m_stored = 0.5 * elastic.dot(m_plane.compliance * elastic);
  if (m_isNew) {
    // Nothing is felt yet that could jump while a contact only begins.
    m_jump = wasAbsent ? Eigen::Vector3d(Eigen::Vector3d::Zero()) : Eigen::Vector3d(m_shown - full);
    m_blendLeft = std::max(kBlendShare * m_interval, m_editLeft);
    m_isNew = false;
  }
  m_jump *= m_blendLeft > dt ? 1.0 - dt / m_blendLeft : 0.0; // on a straight line to nothing
  m_blendLeft -= dt;
  m_editLeft = std::max(0.0, m_editLeft - dt);
  m_shown = full + m_jump;
  if (!m_plane.normal.isZero(0.0))
    if (const double push = m_shown.dot(m_plane.normal); push < 0.0) m_shown -= push * m_plane.normal;
  m_size = m_shown.stableNorm();
  if (!present() && m_size == 0.0) m_presence = 0.0; // nothing is felt that would have to fade
  return m_presence * m_shown;
}

} // namespace esm
