// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/foreign_kinds.h"

#include "core/base/ascii_case.h"
#include "core/base/text_encoding.h"
#include "core/base/text_number.h"
#include "meshimport/content.h"

#include <algorithm>
#include <array>

namespace esm {

namespace {

using namespace std::string_view_literals;

constexpr std::string_view kPictureOut = "a picture holds no mesh, choose the mesh file itself";
constexpr std::string_view kArchiveOut = "unpack it and choose the mesh in it";
constexpr std::string_view kScanOut =
  "segment the organ in an imaging program such as 3D Slicer, and save its surface as STL, OBJ or PLY";
constexpr std::string_view kCadOut = "mesh it in the CAD program and save that as STL or OBJ";
constexpr std::string_view kDeckOut =
  "convert it to VTU or Gmsh .msh, as meshio, Gmsh or the program it comes from can do";
constexpr std::string_view kPointsOut =
  "make a surface of its points, in MeshLab for example, and save that as PLY";
constexpr std::string_view kSceneOut = "save it as OBJ, PLY, STL or glTF in the program it comes from";
constexpr std::string_view kOtherOut = "choose a mesh file";
constexpr std::string_view kUnknownOut =
  "choose an OBJ, STL, PLY, OFF, DXF, VTK, Gmsh, glTF or other mesh file";

struct ByteSign {
  std::size_t at;
  std::string_view bytes;
  ForeignKind kind;
};

/// The longer ones first where one begins like another.
constexpr ByteSign kByteSigns[] = {
  {0, "\x89PNG\r\n\x1a\n"sv, {"a PNG picture", kPictureOut}},
  {0, "\xFF\xD8\xFF"sv, {"a JPEG picture", kPictureOut}},
  {0, "GIF87a"sv, {"a GIF picture", kPictureOut}},
  {0, "GIF89a"sv, {"a GIF picture", kPictureOut}},
  {0, "II*\0"sv, {"a TIFF picture", kPictureOut}},
  {0, "MM\0*"sv, {"a TIFF picture", kPictureOut}},
  {0, "II+\0"sv, {"a TIFF picture", kPictureOut}},
  {0, "8BPS\0\1"sv, {"a Photoshop picture", kPictureOut}},
  {0, "v/1\1"sv, {"an OpenEXR picture", kPictureOut}},
  {0, "#?RADIANCE"sv, {"a Radiance picture", kPictureOut}},
  {0, "DDS \x7C\0\0\0"sv, {"a DDS picture", kPictureOut}},
  {0, "\0\0\0\x0CjP  "sv, {"a JPEG 2000 picture", kPictureOut}},
  {0, "P4\n"sv, {"a PBM picture", kPictureOut}},
  {0, "P5\n"sv, {"a PGM picture", kPictureOut}},
  {0, "P6\n"sv, {"a PPM picture", kPictureOut}},
  {8, "WEBP"sv, {"a WebP picture", kPictureOut}},
  {4, "ftyp"sv, {"a film or HEIF picture", kPictureOut}},
  {0, "RIFF"sv, {"a sound, picture or film", kPictureOut}},
  {0, "%PDF"sv, {"a PDF document", kOtherOut}},
  {0, "%!PS"sv, {"a PostScript document", kOtherOut}},
  {0, "{\\rtf"sv, {"an RTF document", kOtherOut}},
  {0, "PK\x03\x04"sv, {"a ZIP archive", kArchiveOut}},
  {0, "PK\x05\x06"sv, {"an empty ZIP archive", kArchiveOut}},
  {0, "\x1F\x8B"sv, {"a gzip archive", kArchiveOut}},
  {0, "7z\xBC\xAF\x27\x1C"sv, {"a 7z archive", kArchiveOut}},
  {0, "Rar!\x1A\x07"sv, {"a RAR archive", kArchiveOut}},
  {0,
   "\xFD"
   "7zXZ\0"sv,
   {"an xz archive", kArchiveOut}},
  {0, "BZh"sv, {"a bzip2 archive", kArchiveOut}},
  {0, "\x28\xB5\x2F\xFD"sv, {"a zstd archive", kArchiveOut}},
  {0, "\x04\x22\x4D\x18"sv, {"an LZ4 archive", kArchiveOut}},
  {0, "MSCF\0\0\0\0"sv, {"a CAB archive", kArchiveOut}},
  {257, "ustar"sv, {"a tar archive", kArchiveOut}},
  {128, "DICM"sv, {"a DICOM image", kScanOut}},
  {344, "n+1\0"sv, {"a NIfTI image", kScanOut}},
  {344, "ni1\0"sv, {"a NIfTI image", kScanOut}},
  {4, "n+2\0\r\n"sv, {"a NIfTI image", kScanOut}},
  {0, "NRRD000"sv, {"an NRRD image", kScanOut}},
  {0, "ObjectType = Image"sv, {"a MetaImage", kScanOut}},
  {0, "\x89HDF\r\n\x1a\n"sv, {"an HDF5 file, as CGNS, MED, Exodus or MINC use it", kDeckOut}},
  {0, "CDF\x01"sv, {"a NetCDF file, as Exodus uses it", kDeckOut}},
  {0, "CDF\x02"sv, {"a NetCDF file, as Exodus uses it", kDeckOut}},
  {0, "MeshVersionFormatted"sv, {"a Medit mesh", kDeckOut}},
  {0, "mesh3d"sv, {"a Netgen mesh", kDeckOut}},
  {0, "# Created by COMSOL"sv, {"a COMSOL mesh", kDeckOut}},
  {0, "FoamFile"sv, {"an OpenFOAM file", kDeckOut}},
  {0, "AC10"sv, {"a DWG drawing", "save it as DXF in text (ASCII) or as STL"}},
  {0, "V5_CFV2"sv, {"a CATIA part", kCadOut}},
  {0, "#UGC:2"sv, {"a Creo part", kCadOut}},
  {0, "**ABCDEFGHIJKLMNOPQRSTUVWXYZ"sv, {"a Parasolid part", kCadOut}},
  {0, "PS\0\0\0"sv, {"a Parasolid part", kCadOut}},
  {0, "ACIS BinaryFile"sv, {"an ACIS part", kCadOut}},
  {0, "DBRep_DrawableShape"sv, {"an OpenCASCADE part", kCadOut}},
  {0, "CASCADE Topology"sv, {"an OpenCASCADE part", kCadOut}},
  {0, "3D Geometry File Format"sv, {"a Rhino model", kCadOut}},
  {0,
   "\xFF\xFE\xFF\x0E"
   "S\0k\0"sv,
   {"a SketchUp model", kCadOut}},
  {0,
   "\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1"sv,
   {"a part of SolidWorks, Inventor or Solid Edge, a 3ds Max scene or an old office document", kCadOut}},
  {0, "#usda"sv, {"a USD scene", kSceneOut}},
  {0, "PXR-USDC"sv, {"a USD scene", kSceneOut}},
  {0, "Ogawa"sv, {"an Alembic scene", kSceneOut}},
  {0, "LASF"sv, {"a LAS point cloud", kPointsOut}},
  {0, "ASTM-E57"sv, {"an E57 point cloud", kPointsOut}},
  {0, "OFF BINARY"sv, {"a binary OFF", "save it as text or as PLY"}},
  {0, "#X3D V"sv, {"an X3D scene in the encoding of VRML", "save it as .x3d in XML, or as VRML 97 (.wrl)"}},
  {0, "; generated by"sv, {"a program for a 3D printer", kOtherOut}},
  {0, ";FLAVOR:"sv, {"a program for a 3D printer", kOtherOut}},
  {0, "# .PCD v"sv, {"a PCD point cloud", kPointsOut}},
  {0,
   "version https://git-lfs"sv,
   {"a pointer of Git LFS to the file", "fetch the file itself with git lfs pull"}},
  {0,
   "\x7F"
   "ELF"sv,
   {"a program", kOtherOut}},
  {0, "MZ\x90\0"sv, {"a program", kOtherOut}},
  {0, "SQLite format 3"sv, {"a database", kOtherOut}},
  {0, "\xFF\xFE"sv, {"UTF-16 text", "save it as UTF-8"}},
  {0, "\xFE\xFF"sv, {"UTF-16 text", "save it as UTF-8"}},
};

constexpr ForeignKind kBitmap{"a BMP picture", kPictureOut};
constexpr ForeignKind kStep{"a STEP file, which holds surfaces and no mesh", kCadOut};
constexpr ForeignKind kIges{"an IGES file, which holds surfaces and no mesh", kCadOut};
constexpr ForeignKind kFreeCad{"a FreeCAD document", kCadOut};
constexpr ForeignKind kAcis{"an ACIS part", kCadOut};

/// Texts that say what they are somewhere in their first lines, at the beginning of a line, in any case.
/// Signs that say more stand before others.
struct LineSign {
  std::string_view start;
  ForeignKind kind;
};
constexpr ForeignKind kDyna{"an LS-DYNA deck", kDeckOut}, kAbaqus{"an Abaqus or CalculiX deck", kDeckOut},
  kNastran{"a Nastran deck", kDeckOut}, kAnsys{"an Ansys deck", kDeckOut};
constexpr LineSign kLineSigns[] = {
  {"*keyword", kDyna},
  {"*element_", kDyna},
  {"*heading", kAbaqus},
  {"*node", kAbaqus},
  {"*element,", kAbaqus},
  {"*part", kAbaqus},
  {"*include", kAbaqus},
  {"*preprint", kAbaqus},
  {"begin bulk", kNastran},
  {"cquad4", kNastran},
  {"ctria3", kNastran},
  {"ctetra", kNastran},
  {"chexa", kNastran},
  {"grid*", kNastran},
  {"grid,", kNastran},
  {"grid    ", kNastran},
  {"/com,ansys", kAnsys},
  {"/prep7", kAnsys},
  {"nblock,", kAnsys},
  {"eblock,", kAnsys},
  {"#radioss", {"a Radioss deck", kDeckOut}},
  {"coor_3d", {"a Code_Aster mesh", kDeckOut}},
  {"mesh dimension", {"a GiD mesh", kDeckOut}},
  {"control info", {"a Gambit mesh", kDeckOut}},
  {"(0 \"", {"a Fluent mesh", kDeckOut}},
  {"(2 3)", {"a Fluent mesh", kDeckOut}},
  {"variables =", {"a Tecplot file", kDeckOut}},
  {"variables=", {"a Tecplot file", kDeckOut}},
  {"ndime=", {"an SU2 mesh", kDeckOut}},
};

/// First tags of XML texts.
constexpr LineSign kTags[] = {
  {"<!doctype html", {"a web page", kOtherOut}},
  {"<html", {"a web page", kOtherOut}},
  {"<svg", {"an SVG picture", kPictureOut}},
  {"<febio_spec", {"an FEBio model", kDeckOut}},
  {"<xdmf", {"an XDMF file", kDeckOut}},
  {"<world", {"an XGL scene", kSceneOut}}, // the library loses its transforms and points
  {"<irr_scene", {"an Irrlicht scene", kSceneOut}},
  {"<mesh xmlns=\"http://irrlicht", {"an Irrlicht mesh", kSceneOut}},
  {"<node", {"a SOFA scene", "choose the mesh file that it names"}},
};

/// Where the bytes say nothing: what files of this name are.
struct EndingKind {
  std::string_view ending;
  ForeignKind kind;
};
constexpr EndingKind kNamedEndings[] = {
  {"sldprt", {"a SolidWorks part", kCadOut}},
  {"sldasm", {"a SolidWorks assembly", kCadOut}},
  {"ipt", {"an Autodesk Inventor part", kCadOut}},
  {"iam", {"an Autodesk Inventor assembly", kCadOut}},
  {"par", {"a Solid Edge part", kCadOut}},
  {"prt", {"a CAD part of NX or Creo", kCadOut}},
  {"max", {"a 3ds Max scene", kSceneOut}},
  {"zgl", {"a packed XGL scene", kSceneOut}},
  {"jt", {"a JT part", kCadOut}},
  {"x_t", {"a Parasolid part", kCadOut}},
  {"x_b", {"a Parasolid part", kCadOut}},
  {"irr", {"an Irrlicht scene", kSceneOut}},
  {"irrmesh", {"an Irrlicht mesh", kSceneOut}},
  {"mtl", {"a list of an OBJ's materials", "choose the .obj that it belongs to"}},
  {"gcode", {"a program for a 3D printer", kOtherOut}},
  {"scad", {"an OpenSCAD script", "render it in OpenSCAD and save that as STL or OFF"}},
  {"geo", {"a Gmsh geometry", "mesh it in Gmsh and save that as .msh"}},
  {"node", {"a TetGen file", "convert it with tetgen -k, which writes VTK"}},
  {"ele", {"a TetGen file", "convert it with tetgen -k, which writes VTK"}},
  {"smesh", {"a TetGen file", "convert it with tetgen -k, which writes VTK"}},
  {"poly", {"a TetGen file", "convert it with tetgen -k, which writes VTK"}},
};

constexpr std::size_t kForeignLook = 1 << 16; ///< bytes; some decks begin with pages of remarks

std::string_view takeLine(std::string_view& text)
{
  const std::size_t end = text.find_first_of("\r\n");
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return line;
}

std::string_view trimmed(std::string_view text)
{
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

bool startsWith(std::string_view text, std::string_view lowerCase)
{
  return equalIgnoringCase(text.substr(0, lowerCase.size()), lowerCase);
}

bool holdsAt(std::string_view bytes, std::size_t place, std::string_view part)
{
  return bytes.size() >= place + part.size() && bytes.substr(place, part.size()) == part;
}

bool isBitmap(std::string_view bytes)
{
  // "BM", size, two spare numbers, start of the pixels, size of the next header
  constexpr std::array<unsigned char, 5> kHeaderSizes{12, 40, 56, 108, 124};
  return bytes.size() > 18 && bytes.substr(0, 2) == "BM" && bytes.substr(6, 4) == "\0\0\0\0"sv &&
         std::find(kHeaderSizes.begin(), kHeaderSizes.end(), static_cast<unsigned char>(bytes[14])) !=
           kHeaderSizes.end();
}

/// An IGES line is 80 columns, the 73rd of the first is S, then comes its number.
bool isIges(std::string_view bytes)
{
  const std::string_view number =
    trimmed(bytes.substr(0, 80).substr(std::min<std::size_t>(73, bytes.size())));
  return bytes.size() > 80 && (bytes[72] == 'S' || bytes[72] == 'C') &&
         (number == "1" || number == "0000001");
}

/// Universal files begin with the lines "-1" and the number of what follows.
bool isUniversal(std::string_view text)
{
  if (trimmed(takeLine(text)) != "-1") return false;
  std::string_view number = trimmed(takeLine(text));
  if (number.empty()) number = trimmed(takeLine(text)); // CR LF
  return parseInteger(number).value_or(0) > 0;
}

/// Three to seven numbers in each of the first lines.
bool isTableOfNumbers(std::string_view text)
{
  int lines = 0;
  while (!text.empty() && lines < 8) {
    std::string_view line = trimmed(takeLine(text));
    if (line.empty()) continue;
    int numbers = 0;
    while (!line.empty()) {
      const std::size_t end = line.find_first_of(" \t,;");
      if (!parseForeignDouble(line.substr(0, end))) return false;
      ++numbers;
      line = end == std::string_view::npos ? std::string_view() : trimmed(line.substr(end + 1));
    }
    if (numbers < 3 || numbers > 7) return false;
    ++lines;
  }
  return lines > 0;
}

std::optional<ForeignKind> kindOfText(std::string_view text)
{
  const std::string_view start = trimmed(text.substr(0, kForeignLook));
  if (startsWith(start, "iso-10303-21") && start.find("'IFC") == std::string_view::npos) return kStep;
  if (isIges(text)) return kIges;
  if (isUniversal(start)) return ForeignKind{"a universal (UNV) deck", kDeckOut};
  if (start.substr(0, 4096).find(" ACIS ") != std::string_view::npos &&
      parseInteger(start.substr(0, start.find(' '))))
    return kAcis;
  const LineSign* sign = std::end(kLineSigns); // of all that are there the first, which says most
  for (std::string_view rest = start; !rest.empty();) {
    const std::string_view line = takeLine(rest);
    sign = std::find_if(std::begin(kLineSigns), sign,
                        [&](const LineSign& s) { return startsWith(line, s.start); });
  }
  if (sign != std::end(kLineSigns)) return sign->kind;
  return std::nullopt;
}

std::optional<ForeignKind> kindOfXml(std::string_view text)
{
  text = trimmed(text.substr(0, kForeignLook));
  while (startsWith(text, "<?") || startsWith(text, "<!--") || startsWith(text, "<!doctype xdmf")) {
    const std::string_view mark = startsWith(text, "<?")     ? "?>"sv
                                  : startsWith(text, "<!--") ? "-->"sv
                                                             : ">"sv;
    const std::size_t end = text.find(mark);
    text = end == std::string_view::npos ? std::string_view() : trimmed(text.substr(end + mark.size()));
  }
  for (const LineSign& tag : kTags)
    if (startsWith(text, tag.start)) return tag.kind;
  return std::nullopt;
}

/// Whether a JSON text names this format of ours.
bool isOurs(std::string_view text, std::string_view format)
{
  const std::size_t key = text.find("\"format\"");
  if (text.substr(0, 1) != "{" || key == std::string_view::npos) return false;
  const std::string_view value = trimmed(text.substr(key + 8, 64));
  return value.substr(0, 1) == ":" && trimmed(value.substr(1)).substr(0, format.size()) == format;
}

} // namespace

std::optional<ForeignKind> foreignKind(std::string_view bytes)
{
  bytes = withoutByteOrderMark(bytes);
  // A FreeCAD document is a ZIP archive whose first file has a name of its own.
  if (holdsAt(bytes, 0, "PK\x03\x04") && holdsAt(bytes, 30, "Document.xml")) return kFreeCad;
  for (const ByteSign& sign : kByteSigns)
    if (holdsAt(bytes, sign.at, sign.bytes)) return sign.kind;
  if (isBitmap(bytes)) return kBitmap;
  if (!looksLikeText(bytes)) return std::nullopt;
  if (const auto xml = kindOfXml(bytes)) return xml;
  return kindOfText(bytes);
}

std::string describeForeign(std::string_view bytes, std::string_view ending)
{
  const auto sentence = [](std::string_view what, std::string_view wayOut) {
    return "this is " + std::string(what) + "; " + std::string(wayOut);
  };
  const auto named = std::find_if(std::begin(kNamedEndings), std::end(kNamedEndings),
                                  [&](const EndingKind& kind) { return kind.ending == ending; });
  const bool isNamed = named != std::end(kNamedEndings);
  const auto kind = foreignKind(bytes);
  const bool isVague = !kind || kind->what.substr(0, 11) == "a part of S"; // one container for many programs
  if (isNamed && isVague) return sentence(named->kind.what, named->kind.wayOut);
  if (kind) return sentence(kind->what, kind->wayOut);
  if (!looksLikeText(bytes)) return sentence("binary data of an unknown kind", kUnknownOut);
  const std::string_view start = trimmed(bytes.substr(0, kForeignLook));
  if (isOurs(start, "\"esm-project"))
    return sentence("a project of this program", "open it, or ask esm info of it");
  if (isOurs(start, "\"esm-net"))
    return sentence("a net with numbers of its own", "open it, or make a project of it by esm import");
  if (!start.empty() && (start[0] == '{' || start[0] == '['))
    return sentence("JSON text, but no glTF", kUnknownOut);
  if (!start.empty() && start[0] == '<') return sentence("XML text of an unknown kind", kUnknownOut);
  if (isTableOfNumbers(start)) return sentence("a table of numbers, perhaps points", kPointsOut);
  return sentence("text of an unknown kind", kUnknownOut);
}

} // namespace esm
