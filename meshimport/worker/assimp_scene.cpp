// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/worker/assimp_scene.h"

#include "core/base/ascii_case.h"
#include "meshimport/import_endings.h"
#include "meshimport/library_words.h"
#include "meshimport/raw_mesh.h"
#include "meshimport/worker/assimp_frame.h"
#include "meshimport/worker/folder_files.h"
#include "meshimport/worker/limits.h"
#include "meshimport/worker/opened_archive.h"
#include "meshimport/worker/scene_text.h"

#include <Eigen/Geometry>

#include <assimp/DefaultLogger.hpp>
#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/scene.h>

#include <algorithm>
#include <span>
#include <string_view>

namespace esm {

namespace {

/// Gathers the meshes of a scene, each where its nodes put it.
class SceneCollector {
public:
  SceneCollector(const aiScene& scene, const std::string& origin) : m_scene(scene), m_origin(origin) {}

  /// @param root in place of the transform of the root node
  Result<Mesh> run(const Eigen::Matrix4d& root, std::vector<std::string>& notes)
  {
    struct Visit {
      const aiNode* node;
      Eigen::Matrix4d transform;
    };
    std::vector<Visit> open; // a stack of our own: scenes may be nested tens of thousands deep
    if (m_scene.mRootNode && !isSkeleton()) open.push_back({m_scene.mRootNode, root});
    while (!open.empty()) {
      const Visit visit = open.back();
      open.pop_back();
      for (const unsigned mesh : std::span(visit.node->mMeshes, visit.node->mNumMeshes))
        if (Status status = add(mesh, visit.transform); !status) return status.error();
      const std::span children(visit.node->mChildren, visit.node->mNumChildren);
      for (std::size_t i = children.size(); i-- > 0;)
        open.push_back({children[i], visit.transform * matrixOf(children[i]->mTransformation)});
    }
    if (m_raw.isEmpty())
      return fault(ErrorCode::EmptyResult, m_origin, 0,
                   "it was read, but it holds neither a face nor a line" + withSemicolons(notes));
    if (m_points > 0) notes.push_back(std::to_string(m_points) + " single points were passed over.");
    return finishMesh(std::move(m_raw), m_origin, notes);
  }

private:
  /// Whether all there is are the octahedra that the library puts in the place of bones.
  bool isSkeleton() const
  {
    return m_scene.mNumMeshes == 1 && m_scene.mNumMaterials == 1 &&
           m_scene.mMaterials[0]->GetName() == aiString("SkeletonMaterial");
  }

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

/// Hears the errors that the library tells its log alone: it goes on without the part that has one.
class ErrorEar : public Assimp::Logger {
public:
  explicit ErrorEar(std::string_view ending) : m_ending(ending) {}
  const std::string& known() const { return m_known; } ///< the first of a kind that libraryFinding() knows
  const std::string& first() const { return m_known.empty() ? m_first : m_known; }

  bool attachStream(Assimp::LogStream*, unsigned) override { return false; }
  bool detachStream(Assimp::LogStream*, unsigned) override { return false; }
  void OnDebug(const char*) override {}
  void OnVerboseDebug(const char*) override {}
  void OnInfo(const char*) override {}
  void OnWarn(const char*) override {}
  void OnError(const char* message) override
  {
    if (m_first.empty()) m_first = message;
    if (m_known.empty() && !libraryFinding(message, {}, m_ending).empty()) m_known = message;
  }

private:
  std::string_view m_ending;
  std::string m_first, m_known;
};

/// A file whose parts are missing may well be sound itself.
Error lostPartsError(const std::vector<std::string>& lostParts, const std::string& origin)
{
  return fault(ErrorCode::FileUnreadable, origin, 0,
               withSemicolons(lostParts).substr(2) +
                 "; put its parts beside it, or save it as OBJ, PLY or STL in the program it comes from");
}

bool endsWithOneOf(std::string_view name, std::span<const std::string_view> endings)
{
  const std::size_t point = name.rfind('.');
  if (point == name.npos) return false;
  return std::find(endings.begin(), endings.end(), asciiLower(name.substr(point + 1))) != endings.end();
}

/// The parts that may hold a mesh; the library asks for materials and animations of many names, too.
bool isScene(std::string_view name)
{
  return endsWithOneOf(name, foreignEndings()) || endsWithOneOf(name, ownEndings());
}

/// The library guesses at further names for what a glTF names; only that counts, and no pictures.
bool isBuffer(std::string_view name, std::string_view gltf)
{
  constexpr std::string_view kPictures[] = {"png",  "jpg", "jpeg", "webp", "ktx",
                                            "ktx2", "dds", "gif",  "bmp",  "tga"};
  return gltf.find('"' + std::string(name) + '"') != gltf.npos && !endsWithOneOf(name, kPictures);
}

} // namespace

WorkerReply readWithAssimp(std::string_view bytes, const std::string& origin, const std::string& ending)
{
  const bool isGltf = ending == "gltf" || ending == "glb";
  WorkerReply reply;
  if (const std::string extension = isGltf ? unreadableExtension(bytes) : std::string(); !extension.empty()) {
    reply.refusal = fault(ErrorCode::Unsupported, origin, 0,
                          "it needs the glTF extension " + extension +
                            ", which is not read; save it without (gltfpack: with -noq and without -c)");
    return reply;
  }
  const OpenedArchive archive = openArchive(bytes, ending);
  const std::string fault = ending == "amf" ? wrongNumber(bytes, ending) : archive.fault;
  if (!fault.empty()) {
    reply.refusal = damagedFile(fault, false, origin);
    return reply;
  }
  auto* ear = new ErrorEar(ending); // owned by the library
  Assimp::DefaultLogger::set(ear);
  Assimp::Importer importer;
  importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
  auto* files = new FolderFiles(origin, archive.bytes(bytes), ending, allowFor); // owned by the importer
  importer.SetIOHandler(files);
  const aiScene* scene = importer.ReadFile(files->name(), 0);
  reply.notes = files->folder().lostParts(
    bytes, [&](std::string_view name) { return isGltf ? isBuffer(name, bytes) : isScene(name); });
  for (const std::string& path : archive.lost)
    reply.notes.push_back("Its part '" + path + "' is missing here: the archive does not hold it.");
  if (!scene) {
    reply.refusal = reply.notes.empty() ? libraryRefusal(importer.GetErrorString(), bytes, ending, origin)
                                        : lostPartsError(reply.notes, origin);
    return reply;
  }
  reply.format = ending + " (assimp)";
  const SceneStart start = startOf(*scene, archive.text.empty() ? bytes : archive.text, ending, reply.notes);
  reply.stated = start.stated;
  Result<Mesh> mesh = SceneCollector(*scene, origin).run(start.root, reply.notes);
  const bool isEmpty = !mesh && mesh.error().code == ErrorCode::EmptyResult;
  const std::optional<Error> broken = isEmpty ? emptyArchive(bytes, ending, origin) : std::nullopt;
  if (mesh && !ear->known().empty())
    reply.notes.push_back("The reading library went on after a fault, a part may be missing: " +
                          libraryFinding(ear->known(), bytes, ending) + ".");
  if (mesh)
    reply.mesh = std::move(*mesh);
  else if ((ending == "x3d" || ending == "dae" || ending == "amf") && hasTornTags(bytes))
    reply.refusal = libraryRefusal("malformed XML", bytes, ending, origin); // of x3d it says nothing
  else if (broken)
    reply.refusal = *broken;
  else if (isEmpty && reply.notes.empty() && !ear->first().empty())
    reply.refusal = libraryRefusal(ear->first(), bytes, ending, origin);
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
