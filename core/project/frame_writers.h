// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/project/export.h"

#include <bit>
#include <string>
#include <vector>

/// The writers behind exportFrame(), one file each. Internal to core/project.
namespace esm {

/// One format. Adding one is adding one file and one line in the table of export.cpp.
struct FrameFormat {
  const char* ending; ///< with the point
  /// @pre frame.net and frame.position are set, of one size and finite.
  Status (*write)(const Frame& frame, const std::filesystem::path& path);
};

Status writeObj(const Frame& frame, const std::filesystem::path& path);
Status writePly(const Frame& frame, const std::filesystem::path& path);
Status writeStl(const Frame& frame, const std::filesystem::path& path);
Status writeGlb(const Frame& frame, const std::filesystem::path& path);
Status writeGltf(const Frame& frame, const std::filesystem::path& path);
Status writeVtu(const Frame& frame, const std::filesystem::path& path);
Status writeCsv(const Frame& frame, const std::filesystem::path& path);
Status writeSofa(const Frame& frame, const std::filesystem::path& path);
Status writeXsp(const Frame& frame, const std::filesystem::path& path);

std::string encodeVtu(const Frame& frame); ///< also one frame of a ParaView series

// === What several formats need

/// Shapes and finite numbers of a frame. Errors: Numerics, naming the node.
Status checkFrame(const Frame& frame, const std::filesystem::path& path);
/// (l - L) / L of every spring [1]; 0 where L = 0.
Eigen::ArrayXd springStrains(const Frame& frame);
bool isUniform(const Eigen::ArrayXd& values);
/// Springs that are no edge of a triangle: the struts, which a file of triangles must name apart.
std::vector<Index> springsWithoutTriangle(const SpringNet& net);

static_assert(std::endian::native == std::endian::little, "the binary writers copy numbers as they are");

template <class T>
void appendRaw(std::string& out, const T* values, std::size_t count)
{
  out.append(reinterpret_cast<const char*>(values), count * sizeof(T));
}
template <class T>
void appendRaw(std::string& out, T value)
{
  appendRaw(out, &value, 1);
}

} // namespace esm
