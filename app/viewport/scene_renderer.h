// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/viewport/scene_model.h"

#include <QColor>
#include <QOpenGLFunctions_3_3_Core>
#include <QOpenGLShaderProgram>

#include <memory>
#include <vector>

namespace esm {

/// Colours and sizes of the drawing, taken from the palette.
struct Look {
  QColor top, bottom; ///< background gradient
  QColor tissue;      ///< surface without colouring
  QColor wire;        ///< springs without colouring
  QColor region, selectedRegion;
  QColor selectedNode;
  bool dark = false;
  double pixelRatio = 1.0; ///< device pixels per logical pixel
  bool springsToo = true;  ///< beside the surface; else it is only as dark as they would make it
  bool operator==(const Look&) const = default;
};

/// Draws a SceneModel with OpenGL 3.3 core into the bound framebuffer. Owns the GL objects: create() and
/// release() with the context current, draw() uploads only what is dirty. GUI thread.
class SceneRenderer : private QOpenGLFunctions_3_3_Core {
public:
  /// False with the driver's words in `why` if this context will not do.
  bool create(QString* why);
  void release(); ///< also fine if create() failed or was never called
  void draw(SceneModel& model, const Look& look);

private:
  struct RegionLines {
    int first = 0, count = 0; ///< vertices in m_regionBuffer
    bool selected = false;
    float strength = 1.0f; ///< of alpha: paler for what is off and for twins
  };
  /// How a set of lines looks.
  struct LineStyle {
    float width = 1.0f; ///< [logical pixels]
    float alpha = 1.0f;
    float brightness = 1.0f, lift = 0.0f; ///< towards black, towards white
    bool solid = false;                   ///< writes depth, hides what is behind
  };
  using Program = std::unique_ptr<QOpenGLShaderProgram>;

  Program build(const char* vertex, const char* geometry, const char* fragment, QString* why);
  void uploadTopology(const SceneModel& model);
  void uploadFrame(const SceneModel& model);
  void uploadRegions(const SceneModel& model);
  void uploadSelection(const SceneModel& model);
  void setMatrices(QOpenGLShaderProgram& program, const SceneModel& model);
  void bindLines(const SceneModel& model, const Look& look, bool mapped, float fog);
  /// Calls `draw` once, or twice for solid lines (core, then soft edge).
  template <class Draw>
  void drawLines(const LineStyle& style, float pixelRatio, Draw&& draw);

  void drawBackground(const Look& look);
  double darkeningOfEdges(const SceneModel& model) const;
  void drawSurface(const SceneModel& model, const Look& look);
  void drawSprings(const SceneModel& model, const Look& look);
  void drawNodes(const SceneModel& model, const Look& look);
  void drawRegions(const SceneModel& model, const Look& look);

  bool m_created = false;
  Program m_background, m_surface, m_line, m_point;
  GLuint m_emptyArray = 0, m_netArray = 0, m_regionArray = 0;
  GLuint m_nodeBuffer = 0, m_triangleIndices = 0, m_springIndices = 0, m_fixedIndices = 0, m_regionBuffer = 0;
  GLuint m_selectedIndices = 0;
  GLuint m_placeBuffer = 0, m_placeTexture = 0; ///< per spring, read by the line shader
  GLuint m_mapTexture = 0;
  int m_triangles = 0, m_edges = 0, m_lines = 0, m_struts = 0, m_fixed = 0, m_selected = 0;
  double m_meanEdge = 0.0;          ///< at rest [m]
  std::vector<Index> m_springOrder; ///< edges, lines, struts: a draw call each
  std::vector<RegionLines> m_regionLines;
};

} // namespace esm
