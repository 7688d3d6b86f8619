// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/mesh_importer.h"

#include "core/base/ascii_case.h"
#include "core/base/text_number.h"
#include "core/geometry/near_vertices.h"
#include "core/geometry/weld.h"
#include "meshimport/assimp_reader.h"
#include "meshimport/content.h"
#include "meshimport/dxf_reader.h"
#include "meshimport/file_bytes.h"
#include "meshimport/foreign_kinds.h"
#include "meshimport/inventor_reader.h"
#include "meshimport/msh_reader.h"
#include "meshimport/obj_reader.h"
#include "meshimport/off_reader.h"
#include "meshimport/ply_reader.h"
#include "meshimport/raw_mesh.h"
#include "meshimport/raw_reader.h"
#include "meshimport/stated_frame.h"
#include "meshimport/stl_reader.h"
#include "meshimport/vtk_reader.h"
#include "meshimport/vtu_reader.h"

#include <algorithm>
#include <new>
#include <numeric>

namespace esm {

namespace {

/// File names and words out of files may hold line breaks; a message is one line.
Error onOneLine(Error error)
{
  const auto isControl = [](char c) { return static_cast<unsigned char>(c) < 32 || c == 127; };
  std::replace_if(error.detail.begin(), error.detail.end(), isControl, '?');
  return error;
}

std::string endingOf(const std::filesystem::path& path)
{
  const std::string ending = asciiLower(path.extension().string());
  return ending.empty() ? ending : ending.substr(1);
}

/// A file with something in it.
Result<FileBytes> readMeshFile(const std::filesystem::path& path, WorkControl* control)
{
  Result<FileBytes> bytes = FileBytes::read(path, control);
  if (!bytes) return bytes;
  const std::string_view view = bytes->view();
  if (view.empty()) return fault(ErrorCode::EmptyResult, path.string(), 0, "the file is empty (0 bytes)");
  if (isBlankContent(view))
    return fault(ErrorCode::EmptyResult, path.string(), 0,
                 "the file holds nothing but blanks (" + std::to_string(view.size()) + " bytes)");
  return bytes;
}

/// "scan.stl" with an OBJ inside is read as what it is, and that is said.
void noteWrongName(const MeshReader& reader, const std::string& ending, std::vector<std::string>& notes)
{
  const std::string usual = asciiLower(reader.name);
  const std::string_view known[] = {"obj", "stl", "ply", "off"};
  const bool claims = std::find(std::begin(known), std::end(known), ending) != std::end(known);
  if (claims && usual != ending)
    notes.push_back("The file is named ." + ending + ", but its content is " + reader.name +
                    "; it was read as that.");
}

/// The mesh as the first reader that knows the content finds it, with format and notes. The bytes of the file
/// are given back before the mesh is worked on.
Result<ImportedMesh> readMesh(const std::filesystem::path& path, WorkControl* control)
{
  const Result<FileBytes> file = readMeshFile(path, control);
  if (!file) return file.error();
  const std::string_view bytes = withoutPadding(file->view());
  const std::string ending = endingOf(path), origin = path.string();
  const std::vector<MeshReader>& readers = readerTable();
  const auto reader = std::find_if(readers.begin(), readers.end(),
                                   [&](const MeshReader& r) { return r.recognises(bytes, ending); });
  if (reader == readers.end())
    return fault(ErrorCode::Unsupported, origin, 0, describeForeign(bytes, ending));

  ImportedMesh imported;
  imported.fingerprint = file->fingerprint();
  FileStory story;
  noteWrongName(*reader, ending, story.notes);
  story.stated = statedInText(bytes, reader->name);
  Result<Mesh> mesh = reader->read(bytes, origin, story, control);
  if (!mesh) return mesh.error();
  imported.stated = story.stated;
  imported.isPlaced = story.isPlaced;
  imported.format = std::move(story.format);
  imported.notes = std::move(story.notes);
  imported.mesh = std::move(*mesh);
  return imported;
}

void tellUnused(ImportedMesh& imported)
{
  if (const Index unused = imported.report.isolatedVertices; unused > 0)
    imported.notes.push_back(std::to_string(unused) + " points that no face or line uses become no nodes.");
}

void tellNearVertices(ImportedMesh& imported, WorkControl* control)
{
  const NearVertices near = findNearVertices(
    imported.mesh, imported.edges, imported.isPlaced ? NearWhere::Everywhere : NearWhere::Open, control);
  if (near.count == 0) return;
  const std::string tolerance = formatDouble(near.tolerance, 2);
  imported.notes.push_back(std::to_string(near.count) + " vertices nearly meet others, within " + tolerance +
                           "; --weld-tolerance " + tolerance + " joins them.");
}

Result<ImportedMesh> importChecked(const std::filesystem::path& path, const ImportOptions& options,
                                   WorkControl* control)
{
  Result<ImportedMesh> read = readMesh(path, control);
  if (!read) return read;
  ImportedMesh& imported = *read;
  const Index before = imported.mesh.vertexCount();
  if (options.weld) {
    imported.vertexOfFile = weldVertices(imported.mesh, options.weldTolerance, control);
    if (stopWanted(control)) return cancelledError();
    if (const Index joined = before - imported.mesh.vertexCount(); joined > 0)
      imported.notes.push_back(std::to_string(joined) +
                               " vertices were joined with others at the same place.");
  } else {
    imported.vertexOfFile.resize(static_cast<std::size_t>(before));
    std::iota(imported.vertexOfFile.begin(), imported.vertexOfFile.end(), 0);
  }
  imported.edges = listEdges(imported.mesh, control);
  if (stopWanted(control)) return cancelledError();
  imported.report = examine(imported.mesh, imported.edges, control);
  if (stopWanted(control)) return cancelledError();
  if (imported.report.springs > 0) tellUnused(imported);
  if (options.weld) tellNearVertices(imported, control);
  if (imported.report.springs == 0)
    return fault(ErrorCode::EmptyResult, path.string(), 0,
                 "no face or line in it has two corners apart from each other, so no spring comes out");
  return read;
}

} // namespace

Result<ImportedMesh> importMesh(const std::filesystem::path& path, const ImportOptions& options,
                                WorkControl* control)
{
  try {
    Result<ImportedMesh> imported = importChecked(path, options, control);
    if (!imported) return onOneLine(imported.error());
    return imported;
  } catch (const std::bad_alloc&) {
    return onOneLine(fault(ErrorCode::Unsupported, path.string(), 0,
                           "there is not enough memory to read it; simplify the mesh first"));
  } catch (const std::exception& error) {
    return onOneLine(fault(ErrorCode::Internal, path.string(), 0, error.what()));
  }
}

const std::vector<MeshReader>& readerTable()
{
  // The surest signs first; assimp takes what is left.
  static const std::vector<MeshReader> table{plyReader(), offReader(), vtkReader(),      vtuReader(),
                                             mshReader(), dxfReader(), inventorReader(), stlReader(),
                                             rawReader(), objReader(), assimpReader()};
  return table;
}

} // namespace esm
