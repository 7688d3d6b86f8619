// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/viewport/region_gizmo.h"
#include "core/net/spring_net.h"
#include "core/project/project.h"
#include "core/runtime/sim_thread.h"

#include <QImage>
#include <QMap>
#include <QString>
#include <QWidget>

#include <Eigen/Geometry>

#include <memory>
#include <vector>

namespace esm {

enum class Colouring { None, Stiffness, Strain, Force, RegionWeight };
enum class Tool { Camera, Pull, Select, Region };

/// The hand of a haptic device in the scene.
struct Instrument {
  bool visible = false;
  Eigen::AlignedBox3d workspace; ///< what the hand reaches [m]
  Eigen::Vector3d hand = Eigen::Vector3d::Zero(),
                  tip = Eigen::Vector3d::Zero(); ///< tip: where the tissue lets it [m]
  double radius = 0.0;                           ///< of the tip [m]
  bool touches = false;
};

/// The 3D preview: the central widget. Holds a QOpenGLWidget where OpenGL 3.3 works, else a page that says
/// so; all calls are then accepted and do nothing. GUI thread.
class SceneView : public QWidget {
  Q_OBJECT
public:
  explicit SceneView(QWidget* parent = nullptr);
  ~SceneView() override;

  /// Whether this session can show OpenGL 3.3 core, tried on an off-screen surface before any QOpenGLWidget
  /// exists (creating one on a platform without GL ends the process). `why` gets the reason.
  static bool openGlUsable(QString* why);
  bool hasOpenGl() const;

  // === What is shown
  void setNet(std::shared_ptr<const SpringNet> net, std::uint64_t generation); ///< null: empty scene
  void setSnapshot(const SimSnapshot& snapshot); ///< ignored if of another generation; schedules a repaint
  void setParameters(std::shared_ptr<const SpringNet> net);          ///< same topology, new colours
  void setParameters(const ParameterPatch& patch);                   ///< for what it names
  void setRegions(const std::vector<Region>& regions, int selected); ///< wireframes; -1 = none selected
  void setColouring(Colouring colouring);                            ///< legend with unit follows
  void setShown(bool surface, bool springs, bool struts);
  void setToolForce(const Eigen::Vector3d& force); ///< arrow at the grabbed node [N]
  void setGripRadius(double metres);               ///< of the pull tool: its rim is shown
  void showNothingHeld();                          ///< until a snapshot holds something, no arrow either
  void setInstrument(const Instrument& instrument);
  const Instrument& instrument() const;
  void setMarks(const Eigen::Matrix3Xd& places); ///< rings over the picture that stay; 3 x K [m]

  // === Camera and tools
  void setTool(Tool tool);
  void letGo(); ///< of the node that the mouse pulls, if there is one
  Tool tool() const;
  void fit();
  /// Glides within a moment to where the points fill the picture, but no nearer than `nearest` [m] wide.
  void flyTo(const Eigen::Matrix3Xd& places, double nearest);
  ViewSettings viewSettings() const;
  void setViewSettings(const ViewSettings& settings);
  QImage picture(); ///< what is on the screen, overlays included

  /// The pixel (widget coordinates) where a point of the scene [m] appears, for tests and tours.
  QPointF project(const Eigen::Vector3d& point) const;
  /// The front-most node within 12 pixels, or kNoIndex.
  Index nodeAt(const QPointF& pixel) const;
  /// The front-most spring whose middle is nearer to the pixel than any such node, or kNoIndex.
  Index springAt(const QPointF& pixel) const;
  /// The handles of the chosen region's gizmo by name ("move", "falloff", "stretch x+", "slide x", "turn x");
  /// empty unless the tool Region shows them.
  QMap<QString, QPointF> gizmoHandles() const;
  const Eigen::Matrix3Xd& marks() const;
  QString legendTitle() const; ///< empty while there is no legend

  /// The nodes that the tool Select has chosen, rising.
  const std::vector<Index>& selection() const;

signals:
  void pullStarted(int node, double x, double y, double z); ///< target [m]
  void pullMoved(double x, double y, double z);
  void pullEnded();
  void nodeSelected(int node);
  void springSelected(int spring);
  void selectionChanged();
  void regionDragStarted(); ///< of the selected region, by its gizmo
  void regionDragged(const esm::GizmoShape& shape);
  void viewChanged(); ///< camera moved by the user

protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

private:
  void showPlaceholder();
  void retranslate();
  void makeRoomForLegend();

  struct Impl;
  std::unique_ptr<Impl> m_impl;
};

} // namespace esm
