// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/base/work_control.h"
#include "core/geometry/mesh.h"
#include "core/geometry/mesh_report.h"
#include "core/geometry/scene_frame.h"
#include "meshimport/worker_place.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace esm {

struct ImportOptions {
  bool weld = true;
  double weldTolerance = 0.0; ///< [file unit]; 0 = bit-equal positions only
};

/// A mesh in the file's own units and axes, with what is to be said about it.
struct ImportedMesh {
  StatedFrame stated;              ///< what the file says of them
  Mesh mesh;                       ///< welded if wished
  MeshReport report;               ///< of `mesh`
  EdgeList edges;                  ///< of `mesh`, for buildNet(); of no use once its topology changes
  std::string format;              ///< "OBJ", "STL (binary)", "PLY (ASCII)", ...
  std::vector<Index> vertexOfFile; ///< file vertex -> vertex of `mesh`
  std::uint64_t fingerprint = 0;   ///< fingerprintOf() the file's bytes
  std::vector<std::string> notes;  ///< what was passed over or repaired, one sentence each
  bool isPlaced = false;           ///< as FileStory has it
};

/// Reads by content, not by the file's ending: OBJ (with `l` lines), STL (both), PLY (all three encodings) by
/// own readers in double precision, everything else through assimp. Thread: any; no state. Errors (one
/// sentence with file, line or byte, cause, way out): FileUnreadable, BadFormat, Unsupported, EmptyResult (a
/// file without a triangle or line is an error, never a silent empty mesh), Cancelled.
Result<ImportedMesh> importMesh(const std::filesystem::path& path, const ImportOptions& options = {},
                                WorkControl* control = nullptr);

/// What is to be said of a file beside its mesh.
struct FileStory {
  std::string format;             ///< "OBJ", "STL (binary)", ...
  std::vector<std::string> notes; ///< what was passed over or repaired, one sentence each
  StatedFrame stated;             ///< unit and axes, as far as the file itself states them
  bool isPlaced = false;          ///< transforms have put parts into place, which rounds them apart
};

/// One mesh format. Adding one is one file and one line in readerTable().
struct MeshReader {
  const char* name;
  /// Whether the bytes look like this format (the ending is a hint where content leaves doubt).
  bool (*recognises)(std::string_view bytes, std::string_view endingLowerCase);
  /// `control` may be null; own readers answer Cancelled within 100 ms of its wish.
  Result<Mesh> (*read)(std::string_view bytes, const std::string& origin, FileStory& story,
                       WorkControl* control);
};
const std::vector<MeshReader>& readerTable();

} // namespace esm
