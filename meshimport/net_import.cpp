// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/net_import.h"

#include "core/base/file_io.h"
#include "core/base/hash.h"
#include "core/base/text_number.h"
#include "core/geometry/weld.h"
#include "core/net/net_builder.h"
#include "meshimport/polygon_springs.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace esm {

namespace {

template <class Corners>
void appendCorners(Corners& all, const Corners& more, Index offset)
{
  const Eigen::Index old = all.cols();
  all.conservativeResize(Eigen::NoChange, old + more.cols());
  all.rightCols(more.cols()) = (more.array() + offset).matrix();
}

void append(Mesh& mesh, const Mesh& more)
{
  const Index offset = mesh.vertexCount();
  mesh.position.conservativeResize(Eigen::NoChange, offset + more.vertexCount());
  mesh.position.rightCols(more.vertexCount()) = more.position;
  appendCorners(mesh.triangles, more.triangles, offset);
  appendCorners(mesh.segments, more.segments, offset);
  appendCorners(mesh.tetrahedra, more.tetrahedra, offset);
  appendCorners(mesh.diagonals, more.diagonals, offset);
}

/// `map` led on through `next`: kNoIndex stays kNoIndex.
void follow(std::vector<Index>& map, const std::vector<Index>& next)
{
  for (Index& place : map)
    if (place != kNoIndex) place = next[static_cast<std::size_t>(place)];
}

/// A report in metres from one in the file's unit and axes: only the box changes.
MeshReport inScene(MeshReport report, const FileFrame& frame)
{
  Mesh corners;
  corners.position.resize(3, 2);
  corners.position << report.boxMin, report.boxMax;
  toScene(corners, frame);
  report.boxMin = corners.position.rowwise().minCoeff();
  report.boxMax = corners.position.rowwise().maxCoeff();
  return report;
}

/// Brings what has been read so far into the scene, since the next file has another frame.
void bringIntoScene(MeshSource& source)
{
  if (source.isInScene) return;
  toScene(source.mesh, frameOf(source.recipe, source.stated));
  source.isInScene = true;
}

/// Appends a file to those that were read before it.
void join(MeshSource& source, ImportedMesh& imported)
{
  if (imported.stated != source.stated || source.isInScene) {
    bringIntoScene(source);
    toScene(imported.mesh, frameOf(source.recipe, imported.stated));
  }
  append(source.mesh, imported.mesh);
}

Status addFile(MeshSource& source, SourceFile& file, const std::filesystem::path& path, bool several,
               WorkControl* control)
{
  ImportOptions options;
  options.weld = source.recipe.weldTolerance >= 0.0;
  options.weldTolerance = std::max(source.recipe.weldTolerance, 0.0);
  Result<ImportedMesh> imported = importMesh(path, options, control);
  if (!imported) return imported.error();
  for (std::string& note : imported->notes)
    source.notes.push_back(several ? file.name + ": " + note : std::move(note));
  file.fingerprint = imported->fingerprint;

  ReadFile read{file.name, std::move(imported->format), imported->stated, std::move(imported->vertexOfFile)};
  if (source.files.empty()) {
    source.mesh = std::move(imported->mesh);
    source.report = imported->report;
    source.edges = std::move(imported->edges);
    source.stated = imported->stated;
  } else {
    const Index offset = source.mesh.vertexCount();
    for (Index& vertex : read.vertexOfFile) vertex += offset;
    join(source, *imported);
  }
  source.files.push_back(std::move(read));
  return {};
}

/// Several files are joined where they touch.
Status weldFiles(MeshSource& source, WorkControl* control)
{
  if (source.recipe.weldTolerance >= 0.0) {
    const double unit = source.isInScene ? frameOf(source.recipe, source.files.front().stated).metres : 1.0;
    const std::vector<Index> newOf = weldVertices(source.mesh, source.recipe.weldTolerance * unit, control);
    if (stopWanted(control)) return cancelledError();
    for (ReadFile& file : source.files) follow(file.vertexOfFile, newOf);
  }
  source.edges = listEdges(source.mesh, control);
  if (stopWanted(control)) return cancelledError();
  source.report = examine(source.mesh, source.edges, control);
  if (stopWanted(control)) return cancelledError();
  return {};
}

/// Masses and stiffness of the net as the recipe's material says.
Status addMaterial(ImportedNet& made, const MaterialOptions& options, double thickness, WorkControl* control)
{
  Result<MaterialReport> report = setMaterial(made.net, options, thickness, control);
  if (!report) return report.error();
  made.material = *report;
  if (report->measured > 0.0)
    made.notes.push_back("Pulled along its longest axis the net was " + formatDouble(report->measured, 3) +
                         " times as stiff as the body; its springs are scaled by " +
                         formatDouble(report->scale, 3) + ".");
  return {};
}

/// Adds what is to be said of the frames, of alike files once.
void addFrameNotes(std::vector<std::string>& notes, const std::vector<ReadFile>& files,
                   const ImportRecipe& recipe)
{
  const bool alike = std::all_of(files.begin(), files.end(),
                                 [&](const ReadFile& file) { return file.stated == files.front().stated; });
  for (const ReadFile& file : files) {
    const std::string note = frameNote(file.stated, recipe);
    if (!note.empty()) notes.push_back(alike ? note : file.name + ": " + note);
    if (alike) break;
  }
}

} // namespace

bool MeshSource::serves(const ImportRecipe& other) const
{
  return !isInScene || (other.unit == recipe.unit && other.up == recipe.up &&
                        other.patientAxes == recipe.patientAxes && other.ignoreStated == recipe.ignoreStated);
}

FileFrame MeshSource::frame(const ImportRecipe& other) const
{
  return isInScene ? FileFrame{} : frameOf(other, stated);
}

std::string frameNote(const StatedFrame& stated, const ImportRecipe& recipe)
{
  if (stated.isEmpty()) return {};
  const std::string states = "The file states " + inWords(stated);
  if (recipe.ignoreStated) return states + "; as wished, the choices hold and not that.";
  const FileFrame used = frameOf(recipe, stated), chosen = frameOf(recipe, {});
  const ImportRecipe usual;
  std::string against;
  if (recipe.unit != usual.unit && used.metres != chosen.metres)
    against = "unit " + lengthUnitName(recipe.unit);
  if ((recipe.up != usual.up && used.up != chosen.up) || used.patientAxes != chosen.patientAxes)
    if (recipe.up != usual.up || recipe.patientAxes != usual.patientAxes)
      against += against.empty() ? "the chosen axes" : " and the chosen axes";
  if (against.empty()) return states + ", which is used (--ignore-stated uses the choices).";
  return states + ", which is used and not " + against + " (--ignore-stated uses the choices).";
}

Result<MeshSource> readMeshes(const ImportRecipe& recipe, const std::filesystem::path& folder,
                              WorkControl* control)
{
  if (const Status status = checkRecipe(recipe); !status) return status.error();
  if (recipe.files.empty()) return Error{ErrorCode::InvalidValue, "the recipe names no mesh file"};
  MeshSource source;
  source.recipe = recipe;
  const bool several = recipe.files.size() > 1;
  for (SourceFile& file : source.recipe.files)
    if (const Status status = addFile(source, file, folder / file.name, several, control); !status)
      return status.error();
  if (several)
    if (const Status status = weldFiles(source, control); !status) return status.error();
  return source;
}

Result<ImportedNet> makeNet(MeshSource source, const ImportRecipe& recipe, double thickness,
                            WorkControl* control)
{
  const auto inFile = [&](Error error) {
    if (error.code != ErrorCode::Cancelled) error.detail = source.files.front().name + ": " + error.detail;
    return error;
  };
  ImportedNet made;
  made.recipe = recipe;
  made.recipe.files = source.recipe.files;
  made.recipe.weldTolerance = source.recipe.weldTolerance;
  made.files = source.files;
  made.notes = source.notes;
  addFrameNotes(made.notes, source.files, recipe);

  const bool isAsRead = recipe.repair.doesNothing();
  Mesh mesh = isAsRead ? std::move(source.mesh) : source.mesh;
  toScene(mesh, source.frame(recipe));
  made.before = made.after = inScene(source.report, source.frame(recipe));
  if (stopWanted(control)) return cancelledError();

  std::vector<Index> nodeOfVertex;
  if (!isAsRead) {
    if (const Status status = repairMesh(mesh, recipe.repair, made.repair, control); !status)
      return inFile(status.error());
    made.notes.insert(made.notes.end(), made.repair.notes.begin(), made.repair.notes.end());
    made.after = examine(mesh, control);
    followDiagonals(mesh, source.mesh, made.repair.vertexOf);
  }
  const bool dropsDiagonals = recipe.polygons == PolygonSprings::EdgesOnly;
  Result<SpringNet> net = buildNet(dropsDiagonals ? mesh : std::move(mesh), &nodeOfVertex, control,
                                   isAsRead ? std::optional(std::move(source.edges)) : std::nullopt);
  if (!net) return inFile(net.error());
  made.net = std::move(*net);
  if (dropsDiagonals) {
    if (recipe.repair.triangles > 0 || recipe.repair.edgeLength > 0.0)
      made.notes.push_back("Polygons' edges are gone with the remeshing, all triangle edges are springs.");
    else
      dropDiagonals(made.net, mesh, nodeOfVertex);
  }
  if (!recipe.support.isNone()) {
    SupportOptions options = recipe.support;
    if (options.interior == SupportOptions::Interior::Wall && options.wallThickness == 0.0)
      options.wallThickness = thickness;
    Result<SupportReport> support = addSupport(made.net, options, control);
    if (!support) return inFile(support.error());
    made.support = std::move(*support);
    made.notes.insert(made.notes.end(), made.support.notes.begin(), made.support.notes.end());
  }
  if (recipe.material.concernsNet())
    if (const Status status = addMaterial(made, recipe.material, thickness, control); !status)
      return inFile(status.error());
  for (const ReadFile& file : made.files) {
    std::vector<Index> nodeOf = file.vertexOfFile;
    if (!isAsRead) follow(nodeOf, made.repair.vertexOf);
    follow(nodeOf, nodeOfVertex);
    made.nodeOfFile.push_back(std::move(nodeOf));
  }
  return made;
}

Result<ImportedNet> importNet(const ImportRecipe& recipe, const std::filesystem::path& folder,
                              double thickness, WorkControl* control)
{
  Result<MeshSource> source = readMeshes(recipe, folder, control);
  if (!source) return source.error();
  return makeNet(std::move(*source), recipe, thickness, control);
}

Result<std::vector<std::string>> changedFiles(const ImportRecipe& recipe, const std::filesystem::path& folder)
{
  std::vector<std::string> changed;
  for (const SourceFile& file : recipe.files) {
    const Result<std::string> bytes = readFile(folder / file.name);
    if (!bytes) return bytes.error();
    if (fingerprintOf(*bytes) != file.fingerprint) changed.push_back(file.name);
  }
  return changed;
}

} // namespace esm
