// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/worker/assimp_scene.h"

#include "core/base/ascii_case.h"
#include "meshimport/raw_mesh.h"
#include "meshimport/worker/folder_files.h"
#include "meshimport/worker/limits.h"

#include <Eigen/Geometry>

#include <assimp/Importer.hpp>
#include <assimp/scene.h>

#include <algorithm>
#include <span>
#include <string_view>

namespace esm {

namespace {

Eigen::Matrix4d toEigen(const aiMatrix4x4& m)
{
  Eigen::Matrix4d out;
  for (unsigned row = 0; row < 4; ++row)
    for (unsigned column = 0; column < 4; ++column) out(row, column) = double{m[row][column]};
  return out;
}

/// Gathers the meshes of a scene, each where its nodes put it.
class SceneCollector {
public:
  SceneCollector(const aiScene& scene, const std::string& origin) : m_scene(scene), m_origin(origin) {}

  Result<Mesh> run(std::vector<std::string>& notes)
  {
    struct Visit {
      const aiNode* node;
      Eigen::Matrix4d transform;
    };
    std::vector<Visit> open; // a stack of our own: scenes may be nested tens of thousands deep
    if (m_scene.mRootNode) open.push_back({m_scene.mRootNode, toEigen(m_scene.mRootNode->mTransformation)});
    while (!open.empty()) {
      const Visit visit = open.back();
      open.pop_back();
      for (const unsigned mesh : std::span(visit.node->mMeshes, visit.node->mNumMeshes))
        if (Status status = add(mesh, visit.transform); !status) return status.error();
      const std::span children(visit.node->mChildren, visit.node->mNumChildren);
      for (std::size_t i = children.size(); i-- > 0;)
        open.push_back({children[i], visit.transform * toEigen(children[i]->mTransformation)});
    }
    if (m_raw.isEmpty())
      return fault(ErrorCode::EmptyResult, m_origin, 0,
                   "it was read, but it holds neither a face nor a line");
    if (m_points > 0) notes.push_back(std::to_string(m_points) + " single points were passed over.");
    return finishMesh(std::move(m_raw), m_origin, notes);
  }

private:
  Status add(unsigned number, const Eigen::Matrix4d& transform)
  {
    if (number >= m_scene.mNumMeshes)
      return fault(ErrorCode::InvalidValue, m_origin, 0, "a node names a mesh that the file does not hold");
    const aiMesh& mesh = *m_scene.mMeshes[number];
    // A file of a few bytes can place one mesh millions of times.
    if (3 * static_cast<std::size_t>(m_raw.vertexCount()) + 3 * std::size_t{mesh.mNumVertices} >
        kMostItems / 4)
      return tooManyError(m_origin);
    const Index first = m_raw.vertexCount();
    for (const aiVector3D& vertex : std::span(mesh.mVertices, mesh.mVertices ? mesh.mNumVertices : 0)) {
      const Eigen::Vector4d p =
        transform * Eigen::Vector4d(double{vertex.x}, double{vertex.y}, double{vertex.z}, 1.0);
      m_raw.addVertex(p.x(), p.y(), p.z(), 0);
    }
    for (const aiFace& face : std::span(mesh.mFaces, mesh.mFaces ? mesh.mNumFaces : 0)) {
      m_corners.clear();
      for (const unsigned vertex : std::span(face.mIndices, face.mNumIndices)) {
        if (vertex >= mesh.mNumVertices)
          return fault(ErrorCode::InvalidValue, m_origin, 0,
                       "a face uses vertex " + std::to_string(vertex) + ", but its mesh has " +
                         std::to_string(mesh.mNumVertices));
        m_corners.push_back(first + static_cast<Index>(vertex));
      }
      if (m_corners.size() == 1) ++m_points;
      m_raw.addFace(m_corners);
    }
    if (m_raw.cornerCount() > kMostItems / 4) return tooManyError(m_origin);
    return {};
  }

  const aiScene& m_scene;
  const std::string& m_origin;
  RawMesh m_raw;
  std::vector<Index> m_corners;
  std::size_t m_points = 0;
};

/// Whether what the library complains of is an end that comes too early.
bool tellsOfTheEnd(std::string_view complaint)
{
  const std::string text = asciiLower(complaint);
  constexpr std::string_view kSigns[] = {"end of file",   "eof",       "unexpected end",
                                         "premature end", "too small", "truncated"};
  return std::any_of(std::begin(kSigns), std::end(kSigns),
                     [&](std::string_view sign) { return text.find(sign) != text.npos; });
}

} // namespace

WorkerReply readWithAssimp(std::string_view bytes, const std::string& origin, const std::string& ending)
{
  Assimp::Importer importer;
  auto* files = new FolderFiles(origin, bytes, ending, allowFor); // owned by the importer
  importer.SetIOHandler(files);
  WorkerReply reply;
  const aiScene* scene = importer.ReadFile(files->name(), 0);
  if (!scene) {
    const std::string complaint = importer.GetErrorString();
    reply.refusal = fault(ErrorCode::BadFormat, origin, 0,
                          "the assimp library cannot read it (" + complaint +
                            (tellsOfTheEnd(complaint) ? "); fetch it again, it may be cut short, or" : ");") +
                            " save it as OBJ, PLY or STL in the program it comes from");
    return reply;
  }
  reply.format = ending + " (assimp)";
  Result<Mesh> mesh = SceneCollector(*scene, origin).run(reply.notes);
  if (mesh)
    reply.mesh = std::move(*mesh);
  else
    reply.refusal = mesh.error();
  return reply;
}

std::string assimpFormats()
{
  std::string formats;
  Assimp::Importer().GetExtensionList(formats);
  return formats;
}

} // namespace esm
