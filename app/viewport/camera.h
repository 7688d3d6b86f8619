// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace esm {

/// A point on the screen and how far it lies in front of the eye.
struct ScreenPoint {
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero(); ///< y down, origin at the top left; NaN behind the eye
  double depth = 0.0;                              ///< along the view axis [m]
};

struct Ray {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();     ///< [m]
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ(); ///< unit
};

/// Camera::project() for many points: the angles' sines are taken once.
class Projector {
public:
  ScreenPoint operator()(const Eigen::Vector3d& point) const;

private:
  friend class Camera;
  Eigen::Vector3d m_eye, m_right, m_up, m_backward;
  double m_pixelsPerMetre = 0.0; ///< at depth 1, or at any depth if parallel
  Eigen::Vector2d m_middle = Eigen::Vector2d::Zero();
  bool m_parallel = false;
};

/// A turntable camera around a target, z up. All in double: matrices become float only at the GPU, after
/// the scene's centre has been subtracted.
///
///     z |   . eye = target + distance * backward(azimuth, elevation)
///       |  /
///       | / elevation              azimuth 0 looks along +y (from the front), growing azimuth moves the
///       |/_______ y                eye towards +x; elevation pi/2 looks down with +y up on the screen
///      target
class Camera {
public:
  static constexpr double kFieldOfView = 0.61; ///< vertical opening angle [rad], 35 degrees

  // === Pose
  const Eigen::Vector3d& target() const noexcept { return m_target; }
  double distance() const noexcept { return m_distance; }
  double azimuth() const noexcept { return m_azimuth; }
  double elevation() const noexcept { return m_elevation; }
  bool orthographic() const noexcept { return m_orthographic; }
  /// Non-finite values are ignored, distance is kept > 0, elevation in [-pi/2, pi/2].
  void setPose(const Eigen::Vector3d& target, double distance, double azimuth, double elevation);
  void setDirection(double azimuth, double elevation);
  void setOrthographic(bool on) noexcept { m_orthographic = on; }

  /// Size of the picture in logical pixels; at least 1 x 1.
  void setViewport(double width, double height);
  double width() const noexcept { return m_width; }
  double height() const noexcept { return m_height; }
  /// What lies over the picture's right edge [pixels]: the target is in the middle of the rest, and fit()
  /// fills that. At most two fifths of the picture count.
  void setCovered(double right);
  double covered() const noexcept { return m_covered; }
  Eigen::Vector2d middle() const; ///< where the target is [pixels]
  /// The ball that near and far plane must hold and that limits zooming.
  void setScene(const Eigen::Vector3d& centre, double radius);

  // === Moves, in pixels of mouse motion
  void orbit(double dx, double dy); ///< half a turn over the height of the picture
  void pan(double dx, double dy);   ///< the target's plane follows the mouse
  /// Scales the distance by `factor`; what lies under `pixel` stays under it.
  void zoomAt(const Eigen::Vector2d& pixel, double factor);
  /// Turns to the middle of the points' box, at the smallest distance that shows all of them with a margin.
  /// Keeps the direction; does nothing without a finite point.
  void fit(const Eigen::Matrix3Xd& points);

  // === Geometry
  Eigen::Vector3d backward() const; ///< unit, from the target to the eye
  Eigen::Vector3d right() const;
  Eigen::Vector3d up() const;
  Eigen::Vector3d eye() const { return m_target + m_distance * backward(); }
  Eigen::Matrix4d view() const;
  Eigen::Matrix4d projection() const; ///< OpenGL clip space
  Projector projector() const;
  ScreenPoint project(const Eigen::Vector3d& point) const { return projector()(point); }
  Ray rayThrough(const Eigen::Vector2d& pixel) const;
  /// Where the ray through `pixel` meets the plane through `through` that is parallel to the screen.
  Eigen::Vector3d onPlane(const Eigen::Vector2d& pixel, const Eigen::Vector3d& through) const;
  double metresPerPixel(const Eigen::Vector3d& at) const; ///< size of a pixel at that depth [m]

private:
  double halfHeight() const; ///< of the picture at distance 1 [1]
  double clearWidth() const; ///< of what is not covered [pixels]
  void clampDistance();

  Eigen::Vector3d m_target = Eigen::Vector3d::Zero();
  double m_distance = 0.5, m_azimuth = 0.6, m_elevation = 0.4;
  bool m_orthographic = false;
  double m_width = 640.0, m_height = 480.0, m_covered = 0.0;
  Eigen::Vector3d m_sceneCentre = Eigen::Vector3d::Zero();
  double m_sceneRadius = 0.1;
};

} // namespace esm
