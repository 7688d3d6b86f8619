// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/worker/coin_scene.h"

#include "meshimport/raw_mesh.h"

#include <Inventor/SoDB.h>
#include <Inventor/SoInput.h>
#include <Inventor/SoPrimitiveVertex.h>
#include <Inventor/actions/SoCallbackAction.h>
#include <Inventor/errors/SoDebugError.h>
#include <Inventor/errors/SoReadError.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoShape.h>

namespace esm {

namespace {

struct Collected {
  RawMesh raw;
  std::size_t points = 0;

  Index add(SoCallbackAction* action, const SoPrimitiveVertex* vertex)
  {
    SbVec3f p;
    action->getModelMatrix().multVecMatrix(vertex->getPoint(), p);
    raw.addVertex(double{p[0]}, double{p[1]}, double{p[2]}, 0);
    return raw.vertexCount() - 1;
  }
};

void onTriangle(void* to, SoCallbackAction* action, const SoPrimitiveVertex* a, const SoPrimitiveVertex* b,
                const SoPrimitiveVertex* c)
{
  auto& collected = *static_cast<Collected*>(to);
  const Index first = collected.add(action, a), second = collected.add(action, b),
              third = collected.add(action, c);
  collected.raw.addFace({first, second, third});
}

void onLine(void* to, SoCallbackAction* action, const SoPrimitiveVertex* a, const SoPrimitiveVertex* b)
{
  auto& collected = *static_cast<Collected*>(to);
  const Index first = collected.add(action, a), second = collected.add(action, b);
  collected.raw.addPolyline({first, second});
}

void onPoint(void* to, SoCallbackAction*, const SoPrimitiveVertex*)
{
  ++static_cast<Collected*>(to)->points;
}

/// Keeps the first complaint.
void onError(const SoError* error, void* to)
{
  auto& text = *static_cast<std::string*>(to);
  if (text.empty()) text = error->getDebugString().getString();
}

WorkerReply refused(ErrorCode code, const std::string& origin, const std::string& text)
{
  WorkerReply reply;
  reply.refusal = fault(code, origin, 0, text);
  return reply;
}

} // namespace

WorkerReply readWithCoin(std::string_view bytes, const std::string& origin, const std::string&)
{
  SoDB::init();
  std::string complaint;
  SoReadError::setHandlerCallback(onError, &complaint);
  SoDebugError::setHandlerCallback(onError, &complaint);
  SoInput input;
  input.setBuffer(bytes.data(), bytes.size());
  SoSeparator* const scene =
    SoDB::readAll(&input); // never released: this process ends when the reply is sent
  if (!scene)
    return refused(ErrorCode::BadFormat, origin,
                   "the Coin library cannot read it (" + complaint + "); save it as OBJ, PLY or STL");
  scene->ref();

  Collected collected;
  SoCallbackAction action;
  action.addTriangleCallback(SoShape::getClassTypeId(), onTriangle, &collected);
  action.addLineSegmentCallback(SoShape::getClassTypeId(), onLine, &collected);
  action.addPointCallback(SoShape::getClassTypeId(), onPoint, &collected);
  action.apply(scene);
  if (collected.raw.isEmpty())
    return refused(ErrorCode::EmptyResult, origin, "it was read, but it holds neither a face nor a line");

  WorkerReply reply;
  reply.format = bytes.substr(0, 5) == "#VRML" ? "VRML (Coin)" : "Open Inventor (Coin)";
  if (collected.points > 0)
    reply.notes.push_back(std::to_string(collected.points) + " single points were passed over.");
  Result<Mesh> mesh = finishMesh(std::move(collected.raw), origin, reply.notes);
  if (mesh)
    reply.mesh = std::move(*mesh);
  else
    reply.refusal = mesh.error();
  return reply;
}

} // namespace esm
