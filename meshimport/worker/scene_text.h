// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "meshimport/worker/model_folder.h"

#include <string>
#include <string_view>

namespace esm {

/// Texts as the assimp library bears them. Empty where nothing has to be changed.
/// X3D: it reads a url only where it is no list; of an Inline it gets the first part that is there, pictures
/// and sounds go. What is lost is told to the folder.
/// @param isPart whether another scene has named it; its own parts stay away then, so that no scene is a part
/// of itself
std::string plainX3d(std::string_view text, ModelFolder& folder, bool isPart);

/// COLLADA: it refuses a file that takes parts from another one; they go, and are told to the folder.
std::string plainCollada(std::string_view text, ModelFolder& folder);

/// The first coordinate or corner of an AMF or of the model of a 3MF that is no number, which the library reads as 0:
/// a sentence with its line; empty if there is none.
std::string wrongNumber(std::string_view text, std::string_view ending);

/// AMF: of the volumes of a mesh it reads the first one; their triangles come into that. What a volume is made
/// of goes with colours and names, for an absent material or a second colour makes it refuse the file.
std::string plainAmf(std::string_view text);

/// The first glTF extension that a file calls required and that this program, or the library, cannot read.
/// By the standard such a file must not be read; its numbers are packed or placed in another way.
std::string unreadableExtension(std::string_view bytes);

} // namespace esm
