// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// What foreign libraries say of damaged files arrives as sentences of our own: file, place, what is wrong, a way out.
#include "meshimport/library_words.h"
#include "tests/meshimport/foreign_files.h"

#include <gmock/gmock.h>

namespace {

using namespace esm;
using namespace esm::test;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string kMend = "; mend it, or save it as OBJ, PLY or STL in the program it comes from";
const std::string kFetch =
  "; fetch it again, it may be cut short, or save it as OBJ, PLY or STL in the program it comes from";

std::string saidOf(std::string_view complaint, std::string_view bytes = "", std::string_view ending = "")
{
  return libraryRefusal(complaint, bytes, ending, "a").detail;
}

/// An FBX of one triangle; the library goes on without a geometry that it cannot read.
std::string fbxTriangle(const std::string& corners)
{
  return "; FBX 7.4.0 project file\nFBXHeaderExtension:  {\n\tFBXVersion: 7400\n}\nDefinitions:  {\n\tCount: "
         "2\n}\n"
         "Objects:  {\n\tGeometry: 100, \"Geometry::\", \"Mesh\" {\n\t\tVertices: *9 {\n\t\t\ta: "
         "0,0,0,1,0,0,0,1,0\n\t\t}\n"
         "\t\tPolygonVertexIndex: *3 {\n\t\t\ta: " +
         corners +
         "\n\t\t}\n\t}\n\tModel: 200, \"Model::m\", \"Mesh\" {\n\t\tVersion: 232\n\t}\n}\nConnections:  "
         "{\n\tC: "
         "\"OO\",100,200\n\tC: \"OO\",200,0\n}\n";
}

TEST(LibraryWords, knownOnesBecomeSentencesWithTheirPlace)
{
  EXPECT_EQ(saidOf("FBX-Tokenize (offset 0x1ef) block offset is out of range"),
            "a: byte 495: it ends too early, or a length in it is wrong" + kFetch);
  EXPECT_EQ(saidOf("FBX-Parser (TOK_DATA, line 21, col 4) unexpected token, expected TOK_KEY"),
            "a: line 21: something else stands there than the format asks for" + kMend);
  EXPECT_EQ(saidOf("FBX-DOM no Objects dictionary found"), "a: its section 'Objects' is missing" + kMend);
  EXPECT_EQ(saidOf("GLTF: Missing section \"buffers\""), "a: its section 'buffers' is missing" + kMend);
  EXPECT_EQ(saidOf("Line 7: Encountered unexpected EOL while parsing a *MESH chunk (Level 2)"),
            "a: line 7: it ends too early, or a length in it is wrong" + kFetch);
  EXPECT_EQ(saidOf("GLTF: Accessor with offset/length (0/96) is out of range."),
            "a: it points to data that it does not hold" + kMend);
  EXPECT_EQ(saidOf("AC3D: No meshes have been loaded"), "a: it holds no mesh that can be read" + kMend);
  EXPECT_EQ(saidOf("std::bad_alloc"), "a: there is not enough memory to read it; the file may be damaged");
  EXPECT_EQ(
    saidOf("Coin read error: Unknown field \"coordIx\" in \"IndexedFaceSet\"\n\tOccurred at line    4 in x"),
    "a: line 4: 'coordIx' is no word of this format" + kMend);
  EXPECT_EQ(saidOf("Member \"count\" was not of type \"uint\" when reading accessors[0] (accessors[0])"),
            "a: 'count' of accessors[0] holds something else than it should" + kMend);
  EXPECT_EQ(saidOf("Member \"scenes\" was not of type \"array\" when reading the document"),
            "a: 'scenes' holds something else than it should" + kMend);
  EXPECT_EQ(saidOf("GLTF: Array index 9 is out of bounds (2) for \"bufferViews\""),
            "a: it names bufferViews[9], but holds 2 of these" + kMend);
  EXPECT_EQ(saidOf("GLTF: Unsupported Component Type 99"), "a: '99' is no word of this format" + kMend);
  EXPECT_EQ(saidOf("GLTF: Object at index 0 in array \"nodes\" has recursive reference to itself"),
            "a: something in it is a part of itself" + kMend);
  EXPECT_EQ(saidOf("FBX-Parser (TOK_KEY, line 2, col 19) did not find required element \"FBXVersion\""),
            "a: line 2: its section 'FBXVersion' is missing" + kMend);
  const char* const old =
    "FBX-DOM unsupported, old format version, supported are only FBX 2011, FBX 2012 and FBX 2013";
  const std::string oldWords =
    "a: its FBX version, 6100, is not read, those from 7100 (FBX 2011) on are; save it as OBJ, "
    "PLY or STL in the program it comes from";
  EXPECT_EQ(saidOf(old, "; FBX 6.1.0\nFBXHeaderExtension: {\n FBXVersion: 6100\n}\n"), oldWords);
  EXPECT_EQ(saidOf(old, std::string("Kaydara FBX Binary  \0\x1a\0", 23) + bytesOf(std::uint32_t{6100})),
            oldWords);
  EXPECT_EQ(libraryRefusal("LWO: No meshes loaded", "", "lwo", "a").code, ErrorCode::EmptyResult);
}

TEST(LibraryWords, unknownOnesAreQuotedAsTheirs)
{
  EXPECT_EQ(saidOf("XYZ: something odd\nand more"), "a: the file cannot be read; save it as OBJ, PLY or STL "
                                                    "in the program it comes from; the reading library "
                                                    "says: XYZ: something odd");
  EXPECT_LT(saidOf(std::string(100'000, 'x')).size(), 400u);
}

/// Of XML, JSON and numbers the libraries do not say where they are damaged.
TEST(LibraryWords, thePlaceIsFoundWhereTheLibraryDoesNotSayIt)
{
  const char* const xml = "Failed to create XML reader for file a.amf.";
  EXPECT_EQ(saidOf(xml, "<amf>\n<mesh>\n<v>1</v>\n</mash>\n</amf>", "amf"),
            "a: line 4: </mash> stands where </mesh> should, begun in line 2" + kMend);
  EXPECT_EQ(saidOf(xml, "<amf>\n<mesh>\n<v>1</v>\n", "amf"),
            "a: it ends within <mesh>, begun in line 2" + kFetch);
  EXPECT_EQ(saidOf(xml, "<amf>\n<mesh>\n<v>1</v>\n</me", "amf"),
            "a: line 4: a tag begins here and does not end" + kFetch);
  EXPECT_EQ(saidOf(xml, "</amf>", "amf"), "a: line 1: </amf> ends what nothing has begun" + kMend);
  EXPECT_EQ(saidOf(xml, "<amf a=b></amf>", "amf"), "a: its XML is damaged" + kMend);
  const char* const json = "No suitable reader found for the file format of file \"a.gltf\".";
  EXPECT_EQ(saidOf(json, "{\"a\": [1, 2],\n \"b\": \"]", "gltf"),
            "a: it ends too early, or a length in it is wrong" + kFetch);
  EXPECT_EQ(saidOf(json, "{\"a\": \"\\\"]\",\n \"b\": [1}}", "gltf"),
            "a: line 2: something else stands there than the format asks for" + kMend);
  EXPECT_EQ(
    saidOf("Cannot parse string \"0..5 1\" as a real number: does not start with digit or decimal point "
           "followed by digit.",
           "p 3\n0 0 0\n0..5 1 0\n", "nff"),
    "a: line 3: '0..5' stands where a number should be" + kMend);
}

/// Whole files through the library, each damaged in another way.
TEST(LibraryWords, noDamagedFileIsToldInTheLibrarysWords)
{
  const std::string glb = glbSheet(2), x3d =
                                         "<X3D><Scene><Shape>\n<IndexedFaceSet coordIndex='0 1 2 -1'>"
                                         "<Coordinate point='0 0 0 1 0 0 0 1 0'/></IndexedFaceSet></Shape>";
  for (const auto& [name, bytes, said] :
       {std::tuple<const char*, std::string, std::string>{"x.glb", glb.substr(0, glb.size() - 40),
                                                          "its header promises"},
        {"x.amf", "<amf>\n<object>\n</amf>", "line 3: </amf> stands where"},
        {"x.dae", "<?xml version=\"1.0\"?><COLLADA", "does not end"},
        {"x.x3d", x3d.substr(0, 60), "does not end"},
        {"x.3mf", "PK\3\4 no archive", "its ZIP archive is damaged"},
        {"x.lwo", "FARM", "it ends too early"},
        {"x.nff", "p 3\n0 0 0\n1 a 0\n0 1 0\n", "'a' stands where a number"},
        {"x.3ds", "no 3DS at all", "its beginning is damaged"},
        {"x.fbx", "; FBX 7.3.0 project file\nObjects:  {\n", "cut short"},
        {"index.fbx", fbxTriangle("0,1,-33"), "line 13: it points to data"},
        {"letter.fbx", fbxTriangle("0,x,-3"), "line 14: something else stands where a number"},
        {"asset.gltf", "{\"meshes\": []}", "its section 'asset' is missing"},
        {"version.gltf", "{\"asset\": {\"version\": \"3.0\"}}", "its glTF version is not read"}}) {
    const std::string refusal = refusalOf(name, bytes);
    EXPECT_THAT(refusal, HasSubstr(std::string(name) + ": ")) << name;
    EXPECT_THAT(refusal, HasSubstr(said)) << name;
    EXPECT_THAT(refusal, HasSubstr("OBJ, PLY or STL")) << name;
    EXPECT_THAT(refusal, Not(HasSubstr("assimp"))) << name;
    EXPECT_THAT(refusal, Not(HasSubstr("library"))) << name;
  }
}

} // namespace
