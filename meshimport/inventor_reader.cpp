// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/inventor_reader.h"

#include "meshimport/raw_mesh.h"
#include "meshimport/worker/worker_process.h"

namespace esm {

namespace {

#if defined(ESM_HAS_COIN)
constexpr bool kHasCoin = true;
#else
constexpr bool kHasCoin = false;
#endif

bool recognisesInventor(std::string_view bytes, std::string_view)
{
  return bytes.substr(0, 11) == "#Inventor V" || bytes.substr(0, 7) == "#VRML V";
}

Result<Mesh> readInventor(std::string_view, const std::string& origin, FileStory& story, WorkControl* control)
{

  if (!kHasCoin)
    return fault(
      ErrorCode::Unsupported, origin, 0,
      "this build was made without the Coin library, which reads Inventor and VRML; save it as OBJ or PLY");
  WorkerTask task;
  task.library = "coin";
  task.ending = "iv";
  task.file = origin;
  Result<WorkerReply> reply = readInWorker(task, control);
  if (!reply) return reply.error();
  story.format = std::move(reply->format);
  story.stated = reply->stated;
  story.isPlaced = true;
  story.notes.insert(story.notes.end(), reply->notes.begin(), reply->notes.end());
  return std::move(reply->mesh);
}

} // namespace

MeshReader inventorReader()
{
  return {"Inventor", recognisesInventor, readInventor};
}

} // namespace esm
