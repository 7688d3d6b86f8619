// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/viewport/scene_renderer.h"

#include "app/viewport/region_wire.h"
#include "app/viewport/shaders.h"
#include "core/base/colour_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace esm {

namespace {

constexpr float kSpringBias = 2e-4f; ///< lifts lines off the surface they lie on
constexpr float kPointBias = 4e-4f;
constexpr float kQuietAlpha = 0.45f, kQuietBrightness = 0.45f; ///< of edges over the colours of the surface

QVector3D rgb(const QColor& colour)
{
  return {colour.redF(), colour.greenF(), colour.blueF()};
}

QMatrix4x4 toQMatrix(const Eigen::Matrix4d& matrix)
{
  const Eigen::Matrix<float, 4, 4, Eigen::RowMajor> rows = matrix.cast<float>();
  return QMatrix4x4(rows.data());
}

template <class T>
GLsizeiptr bytes(const std::vector<T>& data)
{
  return static_cast<GLsizeiptr>(data.size() * sizeof(T));
}

const void* offset(std::size_t count)
{
  // OpenGL's way to say "byte offset into the buffer".
  return reinterpret_cast<const void*>(count); // NOLINT(performance-no-int-to-ptr)
}

} // namespace

SceneRenderer::Program SceneRenderer::build(const char* vertex, const char* geometry, const char* fragment,
                                            QString* why)
{
  auto program = std::make_unique<QOpenGLShaderProgram>();
  bool good = program->addShaderFromSourceCode(QOpenGLShader::Vertex, vertex);
  if (geometry) good = good && program->addShaderFromSourceCode(QOpenGLShader::Geometry, geometry);
  good = good && program->addShaderFromSourceCode(QOpenGLShader::Fragment, fragment) && program->link();
  if (good) return program;
  *why = program->log();
  return nullptr;
}

bool SceneRenderer::create(QString* why)
{
  if (!initializeOpenGLFunctions()) {
    *why = QStringLiteral("no OpenGL 3.3 functions");
    return false;
  }
  m_created = true;
  m_background = build(shaders::kBackgroundVertex, nullptr, shaders::kBackgroundFragment, why);
  m_surface = build(shaders::kSurfaceVertex, nullptr, shaders::kSurfaceFragment, why);
  m_line = build(shaders::kLineVertex, shaders::kLineGeometry, shaders::kLineFragment, why);
  m_point = build(shaders::kPointVertex, nullptr, shaders::kPointFragment, why);
  if (!m_background || !m_surface || !m_line || !m_point) return false;

  for (GLuint* array : {&m_emptyArray, &m_netArray, &m_regionArray}) glGenVertexArrays(1, array);
  for (GLuint* buffer : {&m_nodeBuffer, &m_triangleIndices, &m_springIndices, &m_fixedIndices,
                         &m_selectedIndices, &m_regionBuffer, &m_placeBuffer})
    glGenBuffers(1, buffer);

  glBindVertexArray(m_netArray);
  glBindBuffer(GL_ARRAY_BUFFER, m_nodeBuffer);
  constexpr GLsizei stride = sizeof(NodeVertex);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, stride, offset(offsetof(NodeVertex, position)));
  glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, stride, offset(offsetof(NodeVertex, normal)));
  glVertexAttribPointer(2, 1, GL_FLOAT, GL_FALSE, stride, offset(offsetof(NodeVertex, value)));
  for (GLuint attribute : {0u, 1u, 2u}) glEnableVertexAttribArray(attribute);
  glBindVertexArray(m_regionArray);
  glBindBuffer(GL_ARRAY_BUFFER, m_regionBuffer);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 3 * sizeof(float), nullptr);
  glEnableVertexAttribArray(0);
  glBindVertexArray(0);

  glGenTextures(1, &m_placeTexture);
  glGenTextures(1, &m_mapTexture);
  glBindTexture(GL_TEXTURE_2D, m_mapTexture);
  const auto table = viridisTable();
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kColourMapSize, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, table.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glBindTexture(GL_TEXTURE_2D, 0);
  return true;
}

void SceneRenderer::release()
{
  if (!m_created) return;
  for (Program* program : {&m_background, &m_surface, &m_line, &m_point}) program->reset();
  for (GLuint* array : {&m_emptyArray, &m_netArray, &m_regionArray}) glDeleteVertexArrays(1, array);
  for (GLuint* buffer : {&m_nodeBuffer, &m_triangleIndices, &m_springIndices, &m_fixedIndices,
                         &m_selectedIndices, &m_regionBuffer, &m_placeBuffer})
    glDeleteBuffers(1, buffer);
  for (GLuint* texture : {&m_placeTexture, &m_mapTexture}) glDeleteTextures(1, texture);
  m_created = false;
}

void SceneRenderer::uploadTopology(const SceneModel& model)
{
  std::vector<GLuint> triangles, springs, fixed;
  m_springOrder.clear();
  m_edges = m_lines = m_struts = 0;
  if (const SpringNet* net = model.net()) {
    for (Eigen::Index i = 0; i < net->triangles.size(); ++i)
      triangles.push_back(static_cast<GLuint>(net->triangles.data()[i]));
    // What the support layer made counts as struts.
    const std::pair<SpringKind, int*> kinds[] = {
      {SpringKind::Edge, &m_edges}, {SpringKind::Line, &m_lines}, {SpringKind::Strut, &m_struts}};
    for (const auto& [kind, count] : kinds)
      for (Index s = 0; s < net->springCount(); ++s)
        if (std::min(net->kind[static_cast<std::size_t>(s)], SpringKind::Strut) == kind) {
          m_springOrder.push_back(s);
          ++*count;
        }
    for (const Index s : m_springOrder)
      for (int end = 0; end < 2; ++end) springs.push_back(static_cast<GLuint>(net->ends(end, s)));
    for (std::size_t i = 0; i < net->fixed.size(); ++i)
      if (net->fixed[i]) fixed.push_back(static_cast<GLuint>(i));
  }
  m_triangles = static_cast<int>(triangles.size() / 3);
  m_meanEdge = 0.0;
  for (int i = 0; i < m_edges; ++i)
    m_meanEdge += model.net()->restLength(m_springOrder[static_cast<std::size_t>(i)]) / m_edges;
  m_fixed = static_cast<int>(fixed.size());
  glBindVertexArray(0); // an index buffer bound now belongs to no array
  glBindBuffer(GL_ARRAY_BUFFER, m_triangleIndices);
  glBufferData(GL_ARRAY_BUFFER, bytes(triangles), triangles.data(), GL_STATIC_DRAW);
  glBindBuffer(GL_ARRAY_BUFFER, m_springIndices);
  glBufferData(GL_ARRAY_BUFFER, bytes(springs), springs.data(), GL_STATIC_DRAW);
  glBindBuffer(GL_ARRAY_BUFFER, m_fixedIndices);
  glBufferData(GL_ARRAY_BUFFER, bytes(fixed), fixed.data(), GL_STATIC_DRAW);
}

void SceneRenderer::uploadFrame(const SceneModel& model)
{
  const std::vector<NodeVertex> vertices = model.nodeVertices();
  glBindBuffer(GL_ARRAY_BUFFER, m_nodeBuffer);
  glBufferData(GL_ARRAY_BUFFER, bytes(vertices), vertices.data(), GL_STREAM_DRAW);

  const std::vector<float> shares = model.springShares();
  std::vector<float> ordered;
  ordered.reserve(m_springOrder.size());
  if (!shares.empty())
    for (const Index s : m_springOrder) ordered.push_back(shares[static_cast<std::size_t>(s)]);
  if (ordered.empty()) ordered.push_back(kNoValue); // a buffer texture needs storage
  glBindBuffer(GL_TEXTURE_BUFFER, m_placeBuffer);
  glBufferData(GL_TEXTURE_BUFFER, bytes(ordered), ordered.data(), GL_STREAM_DRAW);
  glBindTexture(GL_TEXTURE_BUFFER, m_placeTexture);
  glTexBuffer(GL_TEXTURE_BUFFER, GL_R32F, m_placeBuffer);
}

void SceneRenderer::uploadSelection(const SceneModel& model)
{
  std::vector<GLuint> nodes(model.selection().begin(), model.selection().end());
  m_selected = static_cast<int>(nodes.size());
  glBindVertexArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, m_selectedIndices);
  glBufferData(GL_ARRAY_BUFFER, bytes(nodes), nodes.data(), GL_STATIC_DRAW);
}

void SceneRenderer::uploadRegions(const SceneModel& model)
{
  constexpr float kOff = 0.35f, kTwin = 0.45f, kShell = 0.8f;
  std::vector<float> vertices;
  m_regionLines.clear();
  const auto add = [&](bool selected, float strength, const auto& append) {
    RegionLines lines;
    lines.first = static_cast<int>(vertices.size() / 3);
    append();
    lines.count = static_cast<int>(vertices.size() / 3) - lines.first;
    lines.selected = selected;
    lines.strength = strength;
    m_regionLines.push_back(lines);
  };
  for (std::size_t i = 0; i < model.regions().size(); ++i) {
    const Region& region = model.regions()[i];
    if (!region.visible) continue;
    const bool selected = static_cast<int>(i) == model.selectedRegion();
    const float strength = region.enabled ? 1.0f : kOff;
    const auto appendSolid = [&](const Ellipsoid& ellipsoid) {
      appendRegionWire(ellipsoid, model.origin(), vertices);
      if (region.insideOut) appendRegionSpines(ellipsoid, model.origin(), vertices);
    };
    add(selected, strength, [&] { appendSolid(region.ellipsoid); });
    if (region.mirror)
      add(selected, kTwin * strength, [&] { appendSolid(mirrored(region.ellipsoid, *region.mirror)); });
    if (!selected || region.falloff <= 0.0 || region.falloff >= 1.0) continue;
    Ellipsoid inner = region.ellipsoid;
    inner.semiAxes *= 1.0 - region.falloff;
    add(selected, kShell * strength, [&] { appendRegionShell(inner, model.origin(), vertices); });
  }
  glBindBuffer(GL_ARRAY_BUFFER, m_regionBuffer);
  glBufferData(GL_ARRAY_BUFFER, bytes(vertices), vertices.data(), GL_STATIC_DRAW);
}

void SceneRenderer::setMatrices(QOpenGLShaderProgram& program, const SceneModel& model)
{
  Eigen::Matrix4d fromOrigin = Eigen::Matrix4d::Identity();
  fromOrigin.topRightCorner<3, 1>() = model.origin();
  program.setUniformValue("toView", toQMatrix(model.camera.view() * fromOrigin));
  program.setUniformValue("toClip", toQMatrix(model.camera.projection()));
}

void SceneRenderer::draw(SceneModel& model, const Look& look)
{
  if (model.dirty.topology) uploadTopology(model);
  if (model.dirty.topology || model.dirty.frame) uploadFrame(model);
  if (model.dirty.topology || model.dirty.regions) uploadRegions(model);
  if (model.dirty.topology || model.dirty.selection) uploadSelection(model);
  model.dirty = {false, false, false, false};

  // The overlay's QPainter shares this context and leaves its own state behind: set all that is used.
  glDisable(GL_CULL_FACE);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_STENCIL_TEST);
  glEnable(GL_MULTISAMPLE);
  glEnable(GL_PROGRAM_POINT_SIZE);
  glDepthMask(GL_TRUE);
  glDepthFunc(GL_LEQUAL);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  glClearDepth(1.0);
  glClear(GL_DEPTH_BUFFER_BIT);
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_BUFFER, m_placeTexture);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, m_mapTexture);

  drawBackground(look);
  glEnable(GL_DEPTH_TEST);
  if (model.surfaceShown()) drawSurface(model, look);
  glEnable(GL_BLEND);
  drawSprings(model, look);
  drawNodes(model, look);
  drawRegions(model, look);

  glDepthMask(GL_TRUE);
  glDepthFunc(GL_LEQUAL);
  glDisable(GL_DEPTH_TEST);
  glBindVertexArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glUseProgram(0);
}

void SceneRenderer::drawBackground(const Look& look)
{
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  m_background->bind();
  m_background->setUniformValue("top", rgb(look.top));
  m_background->setUniformValue("bottom", rgb(look.bottom));
  glBindVertexArray(m_emptyArray);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

/// By how much the quiet net darkens the surface, as seen from where its strokes run together: so that nothing
/// flickers where it is left out for a while.
double SceneRenderer::darkeningOfEdges(const SceneModel& model) const
{
  if (!model.springsShown() || !(m_meanEdge > 0.0)) return 0.0;
  const double pixels = m_meanEdge / model.camera.metresPerPixel(model.camera.target());
  const double covered =
    std::min(1.0, 2.0 * std::sqrt(3.0) / pixels); // strokes of a pixel on equal triangles
  return covered * kQuietAlpha * (model.colouring() != Colouring::None ? 1.0 - kQuietBrightness : 0.4);
}

void SceneRenderer::drawSurface(const SceneModel& model, const Look& look)
{
  if (m_triangles == 0) return;
  glDisable(GL_BLEND);
  m_surface->bind();
  setMatrices(*m_surface, model);
  m_surface->setUniformValue("colourMap", 0);
  m_surface->setUniformValue("plain", rgb(look.tissue));
  m_surface->setUniformValue("mapped", model.colouring() != Colouring::None);
  m_surface->setUniformValue("brightness",
                             static_cast<float>(look.springsToo ? 1.0 : 1.0 - darkeningOfEdges(model)));
  m_surface->setUniformValue("parallel", model.camera.orthographic());
  glBindVertexArray(m_netArray);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, m_triangleIndices);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(1.0f, 1.0f);
  glDrawElements(GL_TRIANGLES, 3 * m_triangles, GL_UNSIGNED_INT, nullptr);
  glDisable(GL_POLYGON_OFFSET_FILL);
}

void SceneRenderer::bindLines(const SceneModel& model, const Look& look, bool mapped, float fog)
{
  const auto ratio = static_cast<float>(look.pixelRatio);
  const Camera& camera = model.camera;
  const double depth = (camera.eye() - model.origin()).dot(camera.backward());
  m_line->bind();
  setMatrices(*m_line, model);
  m_line->setUniformValue("colourMap", 0);
  m_line->setUniformValue("places", 1);
  m_line->setUniformValue("first", 0);
  m_line->setUniformValue("plain", rgb(look.wire));
  m_line->setUniformValue("mapped", mapped);
  m_line->setUniformValue("bias", kSpringBias);
  m_line->setUniformValue("fogColour", 0.5f * (rgb(look.top) + rgb(look.bottom)));
  m_line->setUniformValue("fog", static_cast<float>(depth - 0.5 * model.radius()),
                          static_cast<float>(depth + 0.8 * model.radius()), fog);
  m_line->setUniformValue("viewport", static_cast<float>(camera.width()) * ratio,
                          static_cast<float>(camera.height()) * ratio);
}

template <class Draw>
void SceneRenderer::drawLines(const LineStyle& style, float pixelRatio, Draw&& draw)
{
  m_line->setUniformValue("width", style.width * pixelRatio);
  m_line->setUniformValue("alpha", style.alpha);
  m_line->setUniformValue("brightness", style.brightness);
  m_line->setUniformValue("lift", style.lift);
  m_line->setUniformValue("edgeOnly", false);
  m_line->setUniformValue("coreOnly", style.solid);
  if (style.solid) {
    draw();
    m_line->setUniformValue("coreOnly", false);
    m_line->setUniformValue("edgeOnly", true);
  }
  glDepthMask(GL_FALSE);
  draw();
  glDepthMask(GL_TRUE);
}

void SceneRenderer::drawSprings(const SceneModel& model, const Look& look)
{
  const bool onSurface = model.surfaceShown() && m_triangles > 0;
  if (onSurface && !look.springsToo) return;
  const int edges = model.springsShown() ? m_edges : 0;
  // Lines and struts look alike, and follow each other.
  const int first = m_edges + (model.springsShown() ? 0 : m_lines);
  const int inside = (model.springsShown() ? m_lines : 0) + (model.strutsShown() ? m_struts : 0);
  if (edges + inside == 0) return;
  const bool mapped = model.colouring() != Colouring::None;
  const auto ratio = static_cast<float>(look.pixelRatio);
  bindLines(model, look, mapped, onSurface ? 0.0f : 0.75f);
  glBindVertexArray(m_netArray);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, m_springIndices);
  const auto lines = [&](int from, int count, const LineStyle& style) {
    if (count == 0) return;
    m_line->setUniformValue("first", from);
    const void* begin = offset(2 * sizeof(GLuint) * static_cast<std::size_t>(from));
    drawLines(style, ratio, [&] { glDrawElements(GL_LINES, 2 * count, GL_UNSIGNED_INT, begin); });
  };
  // On the surface the edges are a quiet net over its colours; bare, they carry the colours themselves.
  const LineStyle quiet{1.0f, kQuietAlpha, mapped ? kQuietBrightness : 1.0f};
  const LineStyle bold{1.6f, 1.0f, 1.0f, 0.0f, true};
  lines(0, edges, onSurface ? quiet : bold);
  lines(first, inside, {2.0f, 1.0f, 1.0f, 0.0f, true});
  if (!onSurface) return;
  glDepthFunc(GL_GREATER); // what is inside the organ shines through
  lines(first, inside, {1.6f, 0.6f, 1.0f, 0.35f});
  glDepthFunc(GL_LEQUAL);
}

void SceneRenderer::drawNodes(const SceneModel& model, const Look& look)
{
  if (m_fixed + m_selected == 0) return;
  m_point->bind();
  setMatrices(*m_point, model);
  m_point->setUniformValue("bias", kPointBias);
  m_point->setUniformValue("rim", rgb(look.dark ? QColor(0x20, 0x24, 0x28) : QColor(0xf4, 0xf6, 0xf8)));
  glBindVertexArray(m_netArray);
  const auto points = [&](GLuint indices, int count, const QColor& colour, double size) {
    if (count == 0) return;
    m_point->setUniformValue("size", static_cast<float>(size * look.pixelRatio));
    m_point->setUniformValue("plain", rgb(colour));
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices);
    glDrawElements(GL_POINTS, count, GL_UNSIGNED_INT, nullptr);
  };
  points(m_selectedIndices, m_selected, look.selectedNode, 9.0); // a ring of it stays around a fixed one
  points(m_fixedIndices, m_fixed, look.dark ? QColor(0xd8, 0xdd, 0xe3) : QColor(0x3b, 0x42, 0x4a), 6.0);
}

void SceneRenderer::drawRegions(const SceneModel& model, const Look& look)
{
  if (m_regionLines.empty()) return;
  bindLines(model, look, false, 0.0f);
  glBindVertexArray(m_regionArray);
  for (const bool inFront : {false, true}) { // faint where the organ hides the wire
    glDepthFunc(inFront ? GL_LEQUAL : GL_GREATER);
    for (const RegionLines& lines : m_regionLines) {
      const float strength = (inFront ? 1.0f : 0.3f) * lines.strength;
      m_line->setUniformValue("plain", rgb(lines.selected ? look.selectedRegion : look.region));
      const LineStyle style{lines.selected ? 1.8f : 1.1f, (lines.selected ? 1.0f : 0.65f) * strength};
      drawLines(style, static_cast<float>(look.pixelRatio),
                [&] { glDrawArrays(GL_LINES, lines.first, lines.count); });
    }
  }
  glDepthFunc(GL_LEQUAL);
}

} // namespace esm
