// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/content.h"

#include "core/base/text_encoding.h"

#include <algorithm>

namespace esm {

namespace {

struct Magic {
  std::string_view start;
  std::string_view meaning;
};

using namespace std::string_view_literals;

constexpr Magic kMeshes[] = {
  {"glTF"sv, "glb"},   {"Kaydara FBX Binary"sv, "fbx"},
  {"; FBX "sv, "fbx"}, {"BLENDER"sv, "blend"},
  {"AC3D"sv, "ac"},    {"IDP2"sv, "md2"},
  {"IDP3"sv, "md3"},   {"MD5Version"sv, "md5mesh"},
  {"3DSA"sv, "ase"},   {"*3DSMAX_ASCIIEXPORT"sv, "ase"},
  {"xof 0"sv, "x"},
};

constexpr std::size_t kLook = 4096;

bool contains(std::string_view bytes, std::string_view part)
{
  return bytes.substr(0, kLook).find(part) != std::string_view::npos;
}

} // namespace

bool looksLikeText(std::string_view bytes)
{
  const std::string_view start = bytes.substr(0, kLook);
  const auto isOdd = [](char c) {
    const auto code = static_cast<unsigned char>(c);
    return (code < 32 && !(code >= 9 && code <= 13)) || code == 127;
  };
  const auto odd = std::count_if(start.begin(), start.end(), isOdd);
  return start.find('\0') == std::string_view::npos && static_cast<std::size_t>(odd) * 100 <= start.size();
}

std::string_view withoutPadding(std::string_view bytes)
{
  const std::string_view text = bytes.substr(0, bytes.find_last_not_of("\0\x1A"sv) + 1);
  const bool hasLines = text.find_first_of("\r\n") != std::string_view::npos; // more than a binary header
  return hasLines && looksLikeText(text) ? text : bytes;
}

bool isBlankContent(std::string_view bytes)
{
  bytes = withoutByteOrderMark(bytes);
  return bytes.find_first_not_of(" \t\r\n\v\f\0"sv) == std::string_view::npos;
}

std::string_view betrayedEnding(std::string_view bytes)
{
  for (const Magic& magic : kMeshes)
    if (bytes.substr(0, magic.start.size()) == magic.start) return magic.meaning;
  if (!looksLikeText(bytes)) return {};
  if (contains(bytes, "<COLLADA")) return "dae";
  if (contains(bytes, "<X3D")) return "x3d";
  if (contains(bytes, "<amf")) return "amf";
  if (contains(bytes, "<mesh") && (contains(bytes, "<sharedgeometry") || contains(bytes, "<submeshes")))
    return "mesh.xml"; // of Ogre
  if (bytes.substr(0, 12) == "ISO-10303-21" && contains(bytes, "'IFC")) return "ifc";
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  if (first != std::string_view::npos && bytes[first] == '{' && bytes.find("\"asset\"") != bytes.npos &&
      bytes.find("\"meshes\"") != bytes.npos)
    return "gltf";
  const std::size_t section = bytes.substr(0, kLook).find("SECTION");
  if (first != std::string_view::npos && bytes[first] == '0' && section < first + 16) return "dxf";
  return {};
}

} // namespace esm
