// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/ply_roles.h"

#include "core/base/ascii_case.h"

#include <algorithm>

namespace esm {

namespace {

struct NamedShape {
  const char* name;
  PlyShape shape;
};

constexpr NamedShape kPlyNames[] = {{"face", PlyShape::Face},
                                    {"polygon", PlyShape::Face},
                                    {"poly", PlyShape::Face},
                                    {"triangle", PlyShape::Face},
                                    {"tri", PlyShape::Face},
                                    {"quad", PlyShape::Face},
                                    {"facet", PlyShape::Face},
                                    {"tristrip", PlyShape::Strip},
                                    {"triangle_strip", PlyShape::Strip},
                                    {"trianglestrip", PlyShape::Strip},
                                    {"strip", PlyShape::Strip},
                                    {"trifan", PlyShape::Fan},
                                    {"triangle_fan", PlyShape::Fan},
                                    {"trianglefan", PlyShape::Fan},
                                    {"fan", PlyShape::Fan},
                                    {"edge", PlyShape::Edge},
                                    {"line", PlyShape::Edge},
                                    {"segment", PlyShape::Edge},
                                    {"polyline", PlyShape::Edge},
                                    {"tet", PlyShape::Tetrahedron},
                                    {"tetra", PlyShape::Tetrahedron},
                                    {"tetrahedron", PlyShape::Tetrahedron},
                                    {"tetrahedra", PlyShape::Tetrahedron},
                                    {"voxel", PlyShape::Tetrahedron},
                                    {"cell", PlyShape::Tetrahedron}};
constexpr const char* kSureLists[] = {"vertex_indices", "vertex_index", "vertex_indexes", "vertexindices"};
constexpr const char* kEnds[][2] = {
  {"vertex1", "vertex2"}, {"v1", "v2"}, {"vertex_1", "vertex_2"}, {"start", "end"}, {"from", "to"},
  {"first", "second"},    {"a", "b"},   {"vertex0", "vertex1"},   {"v0", "v1"}};
constexpr const char* kVertices[] = {"vertex", "vertices", "vertexes", "vert", "verts", "point", "points"};

/// With or without an s at the end.
bool isNamed(const PlyElement& element, std::string_view name)
{
  const std::string_view own = element.name;
  return equalIgnoringCase(own, name) || (own.size() == name.size() + 1 && asciiLower(own.back()) == 's' &&
                                          equalIgnoringCase(own.substr(0, name.size()), name));
}

bool isIntegerList(const PlyProperty& property)
{
  return property.isList && property.type != PlyScalar::Float32 && property.type != PlyScalar::Float64;
}

int sureList(const PlyElement& element)
{
  for (const char* name : kSureLists)
    if (const int place = element.find(name);
        place >= 0 && element.properties[static_cast<std::size_t>(place)].isList)
      return place;
  return -1;
}

/// The list of that name, else the only one of integers.
int cornerList(const PlyElement& element)
{
  if (const int place = sureList(element); place >= 0) return place;
  const auto& all = element.properties;
  const auto only = std::find_if(all.begin(), all.end(), isIntegerList);
  if (std::count_if(all.begin(), all.end(), isIntegerList) != 1) return -1;
  return static_cast<int>(only - all.begin());
}

std::array<int, 2> edgeEnds(const PlyElement& element)
{
  const auto scalar = [&element](const char* name) {
    const int place = element.find(name);
    return place >= 0 && !element.properties[static_cast<std::size_t>(place)].isList ? place : -1;
  };
  for (const auto& names : kEnds)
    if (const std::array ends = {scalar(names[0]), scalar(names[1])}; ends[0] >= 0 && ends[1] >= 0)
      return ends;
  return {-1, -1};
}

const char* nounOf(PlyShape shape)
{
  switch (shape) {
  case PlyShape::Strip:
    return "strips of triangles";
  case PlyShape::Fan:
    return "fans of triangles";
  case PlyShape::Edge:
  case PlyShape::Polyline:
    return "lines";
  case PlyShape::Tetrahedron:
    return "tetrahedra";
  case PlyShape::Face:
  case PlyShape::None:
    break;
  }
  return "faces";
}

} // namespace

bool isPlyGrid(const PlyElement& element)
{
  return isNamed(element, "range_grid");
}

PlyRole plyRole(const PlyElement& element)
{
  PlyRole role;
  const auto named = std::find_if(std::begin(kPlyNames), std::end(kPlyNames),
                                  [&](const NamedShape& entry) { return isNamed(element, entry.name); });
  const bool isKnown = named != std::end(kPlyNames);
  role.list = isKnown ? cornerList(element) : sureList(element);
  role.ends = edgeEnds(element);
  if (isPlyGrid(element)) return {};
  if (isKnown)
    role.shape = named->shape;
  else if (role.list >= 0)
    role.shape = PlyShape::Face;
  if (role.shape == PlyShape::Edge && role.ends[0] < 0 && role.list >= 0) role.shape = PlyShape::Polyline;
  // The usual names without their properties are a fault, others were perhaps meant for something else.
  const bool isUsual = element.name == "face" || element.name == "edge";
  const bool canBeRead = role.shape == PlyShape::Edge ? role.ends[0] >= 0 : role.list >= 0;
  if (!canBeRead && !isUsual) role.shape = PlyShape::None;
  if (!isUsual && role.shape != PlyShape::None) role.note = nounOf(role.shape);
  return role;
}

const PlyElement* plyVertices(const PlyHeader& header)
{
  for (const char* name : kVertices)
    for (const PlyElement& element : header.elements)
      if (equalIgnoringCase(element.name, name) && !element.properties.empty()) return &element;
  return nullptr;
}

} // namespace esm
