// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "meshimport/worker/reply.h"

#include <string>
#include <string_view>

namespace esm {

/// Reads a model by the assimp library; for the worker process only. No post-processing of assimp's (its
/// joining has a tolerance of its own and its triangulation makes hubs): node transforms, polygons and ranges
/// are done here. Coordinates are float32 by nature of the library.
/// @param origin the path, for messages; companions (.bin, .mtl) come from its folder and nowhere else
/// @param ending of the format, without a point
/// @note May throw and crash as the library does.
WorkerReply readWithAssimp(std::string_view bytes, const std::string& origin, const std::string& ending);

/// "*.3ds;*.dae;...", as the library lists what it reads.
std::string assimpFormats();

} // namespace esm
