// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/assimp_reader.h"

#include "core/base/ascii_case.h"
#include "meshimport/content.h"
#include "meshimport/foreign_kinds.h"
#include "meshimport/import_endings.h"
#include "meshimport/raw_mesh.h"
#include "meshimport/worker/worker_process.h"

#include <algorithm>
#include <filesystem>

namespace esm {

namespace {

constexpr std::size_t kLargestFile = std::size_t{1} << 30; ///< assimp takes up to forty times as much memory

/// What assimp reads beside the formats of our own, sorted. Left out: mere textures, motions and cameras, and
/// "xml" and "prj", which mean too many things, those of our own, XGL, which the library places and reads
/// wrongly, and Irrlicht's, of which it finds nothing.
constexpr std::string_view kEndings[] = {
  "3d",    "3ds",    "3mf",  "ac",  "ac3d", "acc",  "amf",  "ase", "ask",     "assbin", "b3d",
  "blend", "bsp",    "bvh",  "cob", "csm",  "dae",  "enff", "fbx", "glb",     "gltf",   "hmp",
  "ifc",   "ifczip", "iqm",  "lwo", "lws",  "lxo",  "md2",  "md3", "md5mesh", "mdc",    "mdl",
  "mesh",  "mot",    "ms3d", "ndo", "nff",  "ogex", "pk3",  "pmx", "q3o",     "q3s",    "scn",
  "sib",   "smd",    "step", "stp", "ter",  "uc",   "vta",  "x",   "x3d",     "x3db",   "zae"};
static_assert(std::is_sorted(std::begin(kEndings), std::end(kEndings)));

std::string endingOf(const std::string& origin)
{
  std::string ending = asciiLower(std::filesystem::path(origin).extension().string());
  if (!ending.empty()) ending.erase(0, 1);
  return ending;
}

Result<Mesh> readAssimp(std::string_view bytes, const std::string& origin, FileStory& story,
                        WorkControl* control)
{

  if (bytes.size() > kLargestFile)
    return fault(ErrorCode::Unsupported, origin, 0,
                 "it is larger than 1 GB, which only OBJ, STL, PLY and OFF may be; convert it");
  const std::string_view betrayed = betrayedEnding(bytes);
  if (betrayed == "x3d" && bytes.find("<IndexedLineSet") != bytes.npos)
    return fault(
      ErrorCode::Unsupported, origin, 0,
      "X3D line sets are not read (the library would make polygons of them); save it as VRML, OBJ or PLY");
  WorkerTask task;
  task.library = "assimp";
  task.ending = betrayed.empty() ? endingOf(origin) : std::string(betrayed);
  task.file = origin;
  Result<WorkerReply> reply = readInWorker(task, control);
  if (!reply) return reply.error();
  story.format = std::move(reply->format);
  story.stated = reply->stated;
  story.isPlaced = true;
  story.notes.insert(story.notes.end(), reply->notes.begin(), reply->notes.end());
  return std::move(reply->mesh);
}

bool recognisesAssimp(std::string_view bytes, std::string_view ending)
{
  if (!betrayedEnding(bytes).empty()) return true;
  const bool mayBeZip =
    ending == "3mf" || ending == "zae" || ending == "ifczip" || ending == "pk3"; // by design
  if (foreignKind(bytes) && !(mayBeZip && bytes.substr(0, 2) == "PK")) return false;
  return std::binary_search(std::begin(kEndings), std::end(kEndings), ending);
}

} // namespace

std::span<const std::string_view> ownEndings() noexcept
{
  static constexpr std::string_view kOwn[] = {"obj", "stl", "ply", "off", "dxf", "vtk",
                                              "vtu", "vtp", "msh", "raw", "iv",  "wrl"};
  return kOwn;
}

std::span<const std::string_view> foreignEndings() noexcept
{
  return kEndings;
}

MeshReader assimpReader()
{
  return {"assimp", recognisesAssimp, readAssimp};
}

} // namespace esm
