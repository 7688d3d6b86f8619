// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/scene_frame.h"

#include <Eigen/Core>

#include <assimp/matrix4x4.h>

#include <string_view>

struct aiScene;

namespace esm {

Eigen::Matrix4d matrixOf(const aiMatrix4x4& m);

/// The unit and axes of a scene, and the first transform on the way to them.
struct SceneStart {
  StatedFrame stated;
  Eigen::Matrix4d root; ///< in place of that of the scene's root node
};

/// The library puts the unit and axes of some formats onto the root node and forgets those of others. Here
/// they are told apart, so that each is used once: COLLADA keeps its own numbers; IFC comes in metres; what
/// the library laid down (3DS, Quake's models, ...) is told to have y up, as glTF has.
/// @param bytes of the file; the text of a COLLADA or a model part if the file is an archive
/// @param notes get what is to be said of a unit that cannot be used
SceneStart startOf(const aiScene& scene, std::string_view bytes, std::string_view ending,
                   std::vector<std::string>& notes);

} // namespace esm
