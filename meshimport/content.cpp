// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/content.h"

#include <algorithm>

namespace esm {

namespace {

struct Magic {
  std::string_view start;
  std::string_view meaning;
};

using namespace std::string_view_literals;

constexpr Magic kForeign[] = {
  {"\x89PNG\r\n\x1a\n"sv, "a PNG picture"},
  {"\xFF\xD8\xFF"sv, "a JPEG picture"},
  {"GIF87a"sv, "a GIF picture"},
  {"GIF89a"sv, "a GIF picture"},
  {"II*\0"sv, "a TIFF picture"},
  {"MM\0*"sv, "a TIFF picture"},
  {"BM\0"sv, "a BMP picture"},
  {"%PDF"sv, "a PDF document"},
  {"PK\x03\x04"sv, "a ZIP archive"},
  {"\x1F\x8B"sv, "a gzip archive"},
  {"7z\xBC\xAF\x27\x1C"sv, "a 7z archive"},
  {"Rar!\x1A\x07"sv, "a RAR archive"},
  {"\xFD"
   "7zXZ\0"sv,
   "an xz archive"},
  {"\x7F"
   "ELF"sv,
   "a program"},
  {"MZ\x90\0"sv, "a program"},
  {"RIFF"sv, "a sound, picture or film"},
  {"\xFF\xFE"sv, "UTF-16 text (save it as UTF-8)"},
  {"\xFE\xFF"sv, "UTF-16 text (save it as UTF-8)"},
  {"<!DOCTYPE html"sv, "a web page"},
  {"<html"sv, "a web page"},
  {"{\\rtf"sv, "an RTF document"},
};

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

bool isBlankContent(std::string_view bytes)
{
  if (bytes.substr(0, 3) == "\xEF\xBB\xBF") bytes.remove_prefix(3);
  return bytes.find_first_not_of(" \t\r\n\v\f\0"sv) == std::string_view::npos;
}

std::string describeForeign(std::string_view bytes)
{
  for (const Magic& magic : kForeign)
    if (bytes.substr(0, magic.start.size()) == magic.start) return std::string(magic.meaning);
  return {};
}

std::string describeContent(std::string_view bytes)
{
  if (std::string foreign = describeForeign(bytes); !foreign.empty()) return foreign;
  if (!looksLikeText(bytes)) return "binary data of an unknown kind";
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  if (first != std::string_view::npos && (bytes[first] == '{' || bytes[first] == '[')) return "JSON text";
  if (first != std::string_view::npos && bytes[first] == '<') return "XML text";
  return "text of an unknown kind";
}

std::string_view betrayedEnding(std::string_view bytes)
{
  for (const Magic& magic : kMeshes)
    if (bytes.substr(0, magic.start.size()) == magic.start) return magic.meaning;
  if (!looksLikeText(bytes)) return {};
  if (contains(bytes, "<COLLADA")) return "dae";
  if (contains(bytes, "<X3D")) return "x3d";
  if (contains(bytes, "<amf")) return "amf";
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  if (first != std::string_view::npos && bytes[first] == '{' && bytes.find("\"asset\"") != bytes.npos &&
      bytes.find("\"meshes\"") != bytes.npos)
    return "gltf";
  const std::size_t section = bytes.substr(0, kLook).find("SECTION");
  if (first != std::string_view::npos && bytes[first] == '0' && section < first + 16) return "dxf";
  return {};
}

} // namespace esm
