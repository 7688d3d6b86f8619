// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/viewport/camera.h"
#include "core/geometry/ellipsoid.h"

#include <optional>
#include <vector>

namespace esm {

/// A part of the gizmo that the mouse can take.
///
///     Move      the centre: in the plane through it that is parallel to the screen
///     Slide     an arrow beyond the end of an axis: along that axis
///     Turn      a ring around the ellipsoid: about one of its axes
///     Stretch   the end of an axis: that semi-axis, or all of them; the centre stays
///     Falloff   a point of the inner shell, where the weight begins to fall
///
/// Axes are the ellipsoid's own.
struct GizmoHandle {
  enum class Kind { None, Move, Slide, Turn, Stretch, Falloff };
  Kind kind = Kind::None;
  int axis = 0; ///< 0 to 2, of Slide, Turn and Stretch
  int side = 1; ///< 1 or -1: which end of the axis, of Stretch
  bool operator==(const GizmoHandle&) const = default;
  explicit operator bool() const noexcept { return kind != Kind::None; }
};

/// What the gizmo changes of a region.
struct GizmoShape {
  Ellipsoid ellipsoid;
  double falloff = 0.0; ///< [0, 1]
};

/// Where the handles are on the screen [logical pixels]. An axis that points at the eye has neither arrow nor
/// ends: a drag along it could not be told from none. Empty for what lies behind the eye.
struct GizmoLayout {
  struct Spot {
    GizmoHandle handle;
    Eigen::Vector2d pixel;
  };
  struct Arrow {
    GizmoHandle handle;
    Eigen::Vector2d from, to;
  };
  struct Ring {
    GizmoHandle handle;
    std::vector<Eigen::Vector2d> pixels; ///< closed: the first point comes again at the end
    std::vector<bool> front;             ///< per point: nearer to the eye than the centre
  };
  std::vector<Spot> spots; ///< in the order in which they are preferred
  std::vector<Arrow> arrows;
  std::vector<Ring> rings;
};
GizmoLayout layoutGizmo(const Camera& camera, const GizmoShape& shape);

/// What lies under the mouse: the nearest spot, else an arrow, else a ring; None beside all of them.
GizmoHandle handleAt(const GizmoLayout& layout, const Eigen::Vector2d& pixel);

/// One drag of a handle. Every shape is made from the one at the start, so that no error adds up. What was
/// taken stays under the mouse, as far as the handle can go. GUI thread.
class GizmoDrag {
public:
  static constexpr double kLeastSemiAxis = 1e-4, kLargestSemiAxis = 5.0; ///< [m]

  /// @param pixel where the handle was taken.
  GizmoDrag(const Camera& camera, const GizmoHandle& handle, const GizmoShape& start,
            const Eigen::Vector2d& pixel);

  /// The shape with the mouse there; finite, with semi-axes within the limits. Where the mouse says nothing
  /// (beyond the horizon of an axis) the last one stays.
  /// @param uniform Stretch scales all semi-axes alike.
  const GizmoShape& to(const Eigen::Vector2d& pixel, bool uniform = false);

  const GizmoHandle& handle() const noexcept { return m_handle; }
  const GizmoShape& start() const noexcept { return m_start; }
  const GizmoShape& shape() const noexcept { return m_shape; }
  double angle() const noexcept { return m_angle; } ///< of Turn, so far [rad], in (-pi, pi]

private:
  void move(const Eigen::Vector2d& pixel);
  void slide(const Eigen::Vector2d& pixel);
  void turn(const Eigen::Vector2d& pixel);
  void stretch(const Eigen::Vector2d& pixel, bool uniform);
  void fade(const Eigen::Vector2d& pixel);
  std::optional<double> wayAlong(const Eigen::Vector2d& pixel) const; ///< from where it was taken [m]
  std::optional<double> angleAt(const Eigen::Vector2d& pixel) const;

  Camera m_camera;
  GizmoHandle m_handle;
  GizmoShape m_start, m_shape;
  Eigen::Vector3d m_origin = Eigen::Vector3d::Zero(),
                  m_along = Eigen::Vector3d::UnitX(); ///< line of the drag
  double m_taken = 0.0;                               ///< place on that line at the start [m]
  Eigen::Vector3d m_arm = Eigen::Vector3d::UnitX();   ///< of Turn: from the centre to where it was taken [m]
  Eigen::Vector2d m_grabOffset = Eigen::Vector2d::Zero(); ///< of Move: from the mouse to the centre [pixels]
  bool m_edgeOn = false; ///< the ring is seen as a line: drag along its tangent
  double m_angle = 0.0;
};

/// The place on a line that is seen nearest to a pixel, as way from `origin` along `direction` (unit) [m];
/// nothing if the line points at the eye or the pixel lies beyond its horizon.
std::optional<double> wayOnLine(const Camera& camera, const Eigen::Vector2d& pixel,
                                const Eigen::Vector3d& origin, const Eigen::Vector3d& direction);

} // namespace esm
