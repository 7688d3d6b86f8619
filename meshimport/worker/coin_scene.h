// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "meshimport/worker/reply.h"

#include <string>
#include <string_view>

namespace esm {

/// Reads Open Inventor (.iv) and VRML 1 and 97 (.wrl) by the Coin library; for the worker process only.
/// Triangles and lines arrive where their transforms put them; polygons as Coin cuts them. Coordinates are
/// float32 by nature.
/// @note May throw and crash as the library does.
WorkerReply readWithCoin(std::string_view bytes, const std::string& origin, const std::string& ending);

} // namespace esm
