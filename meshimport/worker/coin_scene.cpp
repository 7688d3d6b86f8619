// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/worker/coin_scene.h"

#include "meshimport/library_words.h"
#include "meshimport/raw_mesh.h"
#include "meshimport/worker/coin_parts.h"

#include <Inventor/SoDB.h>
#include <Inventor/SoPrimitiveVertex.h>
#include <Inventor/VRMLnodes/SoVRMLAppearance.h>
#include <Inventor/actions/SoCallbackAction.h>
#include <Inventor/errors/SoDebugError.h>
#include <Inventor/errors/SoReadError.h>
#include <Inventor/nodes/SoBaseColor.h>
#include <Inventor/nodes/SoIndexedShape.h>
#include <Inventor/nodes/SoMaterial.h>
#include <Inventor/nodes/SoMaterialBinding.h>
#include <Inventor/nodes/SoNormal.h>
#include <Inventor/nodes/SoNormalBinding.h>
#include <Inventor/nodes/SoPackedColor.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoTexture.h>
#include <Inventor/nodes/SoTextureCoordinate2.h>
#include <Inventor/nodes/SoTextureCoordinateBinding.h>
#include <Inventor/nodes/SoUnits.h>
#include <Inventor/nodes/SoVertexProperty.h>

#include <algorithm>
#include <cstdint>
#include <string>

namespace esm {

namespace {

struct Collected {
  RawMesh raw;
  std::size_t points = 0;
  bool hasUnits = false;
  std::string wrongIndex; ///< the first shape that uses vertices which it does not have

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
  if (!text.empty()) return;
  text = error->getDebugString().getString();
}

/// What only looks is not asked for, so it can neither crash nor matter.
SoCallbackAction::Response passOver(void*, SoCallbackAction*, const SoNode*)
{
  return SoCallbackAction::PRUNE;
}

void reset(SoMFInt32& indices)
{
  indices.setValue(-1); // "as the corners say"
}

void stripLooks(SoVertexProperty* property)
{
  property->materialBinding.setValue(SoMaterialBinding::OVERALL);
  property->normalBinding.setValue(SoNormalBinding::OVERALL);
  property->normal.setNum(0);
  property->orderedRGBA.setNum(0);
  property->texCoord.setNum(0);
}

/// Colours and normals that a shape has in itself.
void stripLooks(SoNode* node)
{
  if (node->isOfType(SoIndexedShape::getClassTypeId())) {
    auto* shape = static_cast<SoIndexedShape*>(node);
    reset(shape->materialIndex);
    reset(shape->normalIndex);
    reset(shape->textureCoordIndex);
  }
  if (node->isOfType(SoVertexShape::getClassTypeId()))
    if (SoNode* const property = static_cast<SoVertexShape*>(node)->vertexProperty.getValue())
      stripLooks(static_cast<SoVertexProperty*>(property));
  for (const char* const name : {"color", "normal", "texCoord"}) // of VRML97
    if (SoField* const field = node->getField(name); field && field->isOfType(SoSFNode::getClassTypeId()))
      static_cast<SoSFNode*>(field)->setValue(nullptr);
  for (const char* const name : {"colorIndex", "normalIndex", "texCoordIndex"})
    if (SoField* const field = node->getField(name); field && field->isOfType(SoMFInt32::getClassTypeId()))
      static_cast<SoMFInt32*>(field)->setNum(0);
}

template <typename Field>
const Field* fieldOf(const SoNode* node, const char* name)
{
  const SoField* const field = node->getField(name);
  return field && field->isOfType(Field::getClassTypeId()) ? static_cast<const Field*>(field) : nullptr;
}

std::int64_t wholeNumber(const SoNode* node, const char* name)
{
  const auto* const field = fieldOf<SoSFInt32>(node, name);
  return field ? field->getValue() : 0;
}

/// How many vertices a shape's numbers reach for; 0 where it has none.
std::int64_t verticesUsed(const SoNode* node)
{
  std::int64_t used = 0;
  if (const auto* const indices = fieldOf<SoMFInt32>(node, "coordIndex")) {
    for (int i = 0; indices->getNum() > 1 && i < indices->getNum(); ++i)
      used = std::max<std::int64_t>(used, (*indices)[i] + std::int64_t{1});
  } else if (const auto* const counts = fieldOf<SoMFInt32>(node, "numVertices")) {
    for (int i = 0; i < counts->getNum(); ++i)
      used += std::max<std::int64_t>((*counts)[i], 0); // -1: all others
    used += wholeNumber(node, "startIndex");
  } else {
    used = wholeNumber(node, "verticesPerRow") * wholeNumber(node, "verticesPerColumn");
  }
  return used;
}

std::int64_t verticesThere(SoCallbackAction* action, const SoNode* node)
{
  if (const auto* const coord = fieldOf<SoSFNode>(node, "coord")) { // of VRML97
    const auto* const points = coord->getValue() ? fieldOf<SoMFVec3f>(coord->getValue(), "point") : nullptr;
    return points ? points->getNum() : 0;
  }
  if (const auto* const own = fieldOf<SoSFNode>(node, "vertexProperty"); own && own->getValue())
    if (const auto* const points = fieldOf<SoMFVec3f>(own->getValue(), "vertex");
        points && points->getNum() > 0)
      return points->getNum();
  return action->getNumCoordinates();
}

// The scene is ours, only the action takes its nodes as const.

SoCallbackAction::Response beforeShape(void* to, SoCallbackAction* action, const SoNode* node)
{
  auto& collected = *static_cast<Collected*>(to);
  const std::int64_t used = verticesUsed(node), there = verticesThere(action, node);
  if (used > there) { // the library would read what lies behind them in memory
    if (collected.wrongIndex.empty())
      collected.wrongIndex = "a shape uses vertex " + std::to_string(used - 1) +
                             ", counted from 0, but it has " + std::to_string(there) +
                             "; mend it in the program it comes from";
    return SoCallbackAction::PRUNE;
  }
  stripLooks(const_cast<SoNode*>(node));
  return SoCallbackAction::CONTINUE;
}

SoCallbackAction::Response beforeProperty(void*, SoCallbackAction*, const SoNode* node)
{
  stripLooks(static_cast<SoVertexProperty*>(const_cast<SoNode*>(node)));
  return SoCallbackAction::CONTINUE;
}

SoCallbackAction::Response onUnits(void* to, SoCallbackAction*, const SoNode*)
{
  static_cast<Collected*>(to)->hasUnits = true;
  return SoCallbackAction::CONTINUE;
}

void collect(SoNode* scene, Collected& collected)
{
  SoCallbackAction action;
  for (const SoType looks :
       {SoMaterial::getClassTypeId(), SoMaterialBinding::getClassTypeId(), SoBaseColor::getClassTypeId(),
        SoPackedColor::getClassTypeId(), SoNormal::getClassTypeId(), SoNormalBinding::getClassTypeId(),
        SoTexture::getClassTypeId(), SoTextureCoordinate2::getClassTypeId(),
        SoTextureCoordinateBinding::getClassTypeId(), SoVRMLAppearance::getClassTypeId()})
    action.addPreCallback(looks, passOver, nullptr);
  action.addPreCallback(SoShape::getClassTypeId(), beforeShape, &collected);
  action.addPreCallback(SoVertexProperty::getClassTypeId(), beforeProperty, nullptr);
  action.addPreCallback(SoUnits::getClassTypeId(), onUnits, &collected);
  action.addTriangleCallback(SoShape::getClassTypeId(), onTriangle, &collected);
  action.addLineSegmentCallback(SoShape::getClassTypeId(), onLine, &collected);
  action.addPointCallback(SoShape::getClassTypeId(), onPoint, &collected);
  action.apply(scene);
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
  CoinParts parts(origin);
  readInlinesFrom(parts);
  PartInput input(parts);
  input.setBuffer(bytes.data(), bytes.size());
  SoSeparator* const scene =
    SoDB::readAll(&input); // never released: this process ends when the reply is sent
  if (scene) {
    scene->ref();
    readOtherPlaces(parts, scene);
  }
  WorkerReply reply;
  reply.notes = parts.folder.lostParts();
  if (!scene) {
    reply.refusal = libraryRefusal(complaint, bytes, "", origin);
    reply.refusal->detail += withSemicolons(reply.notes);
    return reply;
  }

  Collected collected;
  collect(scene, collected);
  if (!collected.wrongIndex.empty()) return refused(ErrorCode::InvalidValue, origin, collected.wrongIndex);
  if (collected.raw.isEmpty())
    return refused(ErrorCode::EmptyResult, origin,
                   "it was read, but it holds neither a face nor a line" + withSemicolons(reply.notes));

  reply.format = bytes.substr(0, 5) == "#VRML" ? "VRML (Coin)" : "Open Inventor (Coin)";
  if (collected.hasUnits) reply.stated.metres = 1.0; // the library has come to them by its Units nodes
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
