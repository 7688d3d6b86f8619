// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/viewport/camera.h"
#include "app/viewport/grip_mark.h"
#include "app/viewport/legend_range.h"
#include "app/viewport/scene_view.h"

#include <memory>
#include <vector>

namespace esm {

/// One node as the GPU takes it. Positions are relative to SceneModel::origin(), so that a float is enough.
struct NodeVertex {
  float position[3]; ///< [m]
  float normal[3];   ///< unit; 0 where the node has no triangle
  float value;       ///< [0, 1] along the colour map, or kNoValue
};

/// Marks what has no value: so far below 0 that the GPU's interpolation with a value stays below 0.
inline constexpr float kNoValue = -1000.0f;

/// What the preview shows, without any OpenGL: net, motion, colours, regions, camera, tool. It also answers
/// where a point appears and which node is under the mouse, so this works (and is tested) without a screen.
/// Numbers for the GPU are computed when they are asked for: a hidden view costs nothing. GUI thread.
class SceneModel {
public:
  /// What has changed since the renderer last took it.
  struct Dirty {
    bool topology = true; ///< other net: index buffers
    bool frame = true;    ///< positions, normals, values
    bool regions = true;
    bool selection = true;
  };

  // === What is shown (see SceneView). Each returns whether the picture changes.
  bool setNet(std::shared_ptr<const SpringNet> net, std::uint64_t generation);
  bool setSnapshot(const SimSnapshot& snapshot);
  bool setParameters(std::shared_ptr<const SpringNet> net);
  bool setParameters(const ParameterPatch& patch);
  bool setRegions(const std::vector<Region>& regions, int selected);
  bool setColouring(Colouring colouring);
  bool setShown(bool surface, bool springs, bool struts);
  bool setMarks(const Eigen::Matrix3Xd& places); ///< 3 x K [m]
  bool setInstrument(const Instrument& instrument);
  bool letGo(); ///< of what the last snapshot held
  bool setGripRadius(double metres) { return m_grip.setRadius(metres); }

  /// For topology and rest shape: of its parameters patches have changed some, see springValues().
  const SpringNet* net() const noexcept { return m_net.get(); }
  const Eigen::Matrix3Xd& position() const noexcept { return m_position; }
  const std::vector<Region>& regions() const noexcept { return m_regions; }
  int selectedRegion() const noexcept { return m_selectedRegion; }
  const Region* chosenRegion() const noexcept; ///< the selected one, or null
  /// The selected one if it is visible and not locked, or null: what the gizmo changes.
  const Region* gizmoRegion() const noexcept;
  Colouring colouring() const noexcept { return m_colouring; }
  bool surfaceShown() const noexcept { return m_surface; }
  bool springsShown() const noexcept { return m_springs; } ///< but for struts
  bool strutsShown() const noexcept { return m_struts; }
  Index grabbedNode() const noexcept { return m_grabbed; }
  /// What a hand holds besides.
  const std::vector<Index>& heldNodes() const noexcept { return m_grip.heldNodes(); }
  const GripMark& grip() const noexcept { return m_grip; }
  const Eigen::Matrix3Xd& marks() const noexcept { return m_marks; }
  const Instrument& instrument() const noexcept { return m_instrument; }

  // === Selected nodes, rising; another net has none
  const std::vector<Index>& selection() const noexcept { return m_selection; }
  bool setSelection(std::vector<Index> nodes); ///< in any order; returns whether it changes

  // === Camera
  Camera camera;
  void setViewport(double width, double height); ///< [logical pixels]; refits while nobody moved the camera
  bool setCovered(double right);                 ///< see Camera; refits likewise; returns whether it changes
  void fit();
  void cameraMoved() { m_autoFit = false; } ///< the user took over
  /// distance is 0 while the view still fits itself, so an untouched project saves as it was loaded.
  ViewSettings viewSettings() const;
  void setViewSettings(const ViewSettings& settings);

  // === Colours
  ValueRange valueRange() const;       ///< in SI units of the present colouring
  Eigen::ArrayXd springValues() const; ///< S, in SI units; empty for Colouring::None
  const Eigen::Vector3d& origin() const noexcept { return m_origin; } ///< [m], centre of the rest box
  double radius() const noexcept { return m_radius; }                 ///< of the ball around the net [m]

  // === For the renderer
  Dirty dirty;
  std::vector<NodeVertex> nodeVertices() const; ///< N
  std::vector<float> springShares() const;      ///< S, [0, 1] along the colour map, or kNoValue

  /// The front-most node within 12 pixels that the shown surface does not hide, or kNoIndex.
  Index nodeAt(const Eigen::Vector2d& pixel) const;
  /// The front-most spring whose middle is nearer to the pixel than any such node, or kNoIndex.
  Index springAt(const Eigen::Vector2d& pixel) const;
  Eigen::Vector3d middleOf(Index spring) const; ///< where it is now [m]
  /// The nodes in a box of the screen that the shown surface does not hide, rising.
  std::vector<Index> nodesIn(const Eigen::AlignedBox2d& pixels) const;

private:
  void takeStiffness();
  void weighSprings();
  bool isShown(Index spring) const;
  void updateBounds();
  SteadyRange* movingRange() noexcept;
  Eigen::Matrix3Xd nodeNormals() const;

  std::shared_ptr<const SpringNet> m_net;
  std::uint64_t m_generation = 0;
  std::uint64_t m_sequence = 0, m_revision = 0; ///< of the snapshot
  Eigen::Matrix3Xd m_position;                  ///< 3 x N [m]
  Eigen::ArrayXd m_tension;                     ///< S [N]
  Eigen::ArrayXd m_stiffness;                   ///< S, the net's with all patches since [N/m]
  double m_time = 0.0;                          ///< of the snapshot [s]
  Index m_grabbed = kNoIndex;
  GripMark m_grip;
  std::vector<Region> m_regions;
  int m_selectedRegion = -1;
  std::vector<Index> m_selection;
  Eigen::Matrix3Xd m_marks{3, 0};
  Instrument m_instrument;
  Colouring m_colouring = Colouring::Stiffness;
  bool m_surface = true, m_springs = true, m_struts = false;
  bool m_autoFit = true;

  Eigen::Vector3d m_origin = Eigen::Vector3d::Zero();
  double m_radius = 0.1;
  ValueRange m_stiffnessRange{1.0, 10.0, true};
  Eigen::ArrayXd m_weight;         ///< S, of the selected region, for Colouring::RegionWeight [1]
  SteadyRange m_strainRange{0.01}; ///< 1 %: below that a colour would show noise
  SteadyRange m_forceRange{1e-3};  ///< 1 mN
  double m_largest = 0.0;          ///< that the present one of the two was given last
};

/// The names that ViewSettings::colouring uses; an unknown name means None.
QString colouringName(Colouring colouring);
Colouring colouringFromName(const std::string& name);

} // namespace esm
