// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// Files that are no meshes, or meshes that are not read: each is called what it is, with a way to a mesh.
#include "tests/meshimport/import_bytes.h"

#include <gmock/gmock.h>

namespace {

using namespace esm;
using namespace esm::test;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

struct Foreign {
  const char* test;
  const char* name;
  std::string bytes;
  const char* what;
  const char* wayOut;
};
void PrintTo(const Foreign& file, std::ostream* out)
{
  *out << file.test;
}

/// Bytes behind so many zeros.
std::string at(std::size_t place, const std::string& bytes)
{
  return std::string(place, '\0') + bytes + std::string(40, '\0');
}
std::string columns(std::string line, const std::string& end)
{
  line.resize(72, ' ');
  return line + end + "\n";
}

const std::string kStepHead = "ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('CONFIG_CONTROL_DESIGN'));\nENDSEC;\n";
const Foreign kForeign[] = {
  // finite elements
  {"abaqusPart", "a.inp", "** made by hand\n**\n*Part, name=x\n*Node\n1, 0, 0, 0\n",
   "an Abaqus or CalculiX deck", "VTU or Gmsh"},
  {"calculix", "mesh.dat", "*NODE, NSET=Nall\n1,0,0,0\n*ELEMENT, TYPE=S3\n1,1,2,3\n",
   "an Abaqus or CalculiX deck", "meshio"},
  {"dyna", "a.k", "$# LS-PrePost\n*KEYWORD\n*NODE\n       1     0.0     0.0     0.0\n*ELEMENT_SHELL\n",
   "an LS-DYNA deck", "VTU"},
  {"dynaInclude", "a.key", "*NODE\n1,0,0,0\n*ELEMENT_SOLID\n1,1\n", "an LS-DYNA deck", "VTU"},
  {"nastran", "a.bdf", "$ by hand\nSOL 101\nCEND\nBEGIN BULK\nGRID,1,,0.,0.,0.\n", "a Nastran deck", "VTU"},
  {"nastranBulkOnly", "a.nas",
   "GRID           1       0     0.0     0.0     0.0\nCTRIA3         1       1       1       2       3\n",
   "a Nastran deck", "VTU"},
  {"ansys", "a.cdb", "/COM,ANSYS RELEASE 19\n/PREP7\nNBLOCK,6,SOLID\n", "an Ansys deck", "VTU"},
  {"universal", "a.unv", "    -1\n  2411\n         1         1\n", "a universal (UNV) deck", "VTU"},
  {"universalWindows", "a.unv", "    -1\r\n  2411\r\n         1         1\r\n", "a universal (UNV) deck",
   "VTU"},
  {"medit", "a.mesh", "MeshVersionFormatted 1\nDimension 3\nVertices 0\n", "a Medit mesh", "Gmsh"},
  {"netgen", "a.vol", "mesh3d\ndimension\n3\n", "a Netgen mesh", "VTU"},
  {"febio", "a.feb", "<?xml version=\"1.0\"?>\n<febio_spec version=\"3.0\">", "an FEBio model", "VTU"},
  {"xdmf", "a.xdmf",
   "<?xml version=\"1.0\" ?>\n<!DOCTYPE Xdmf SYSTEM \"Xdmf.dtd\" []>\n<Xdmf Version=\"3.0\">", "an XDMF file",
   "VTU"},
  {"hdf5", "a.cgns", "\x89HDF\r\n\x1a\n" + std::string(50, '\0'), "HDF5", "VTU"},
  {"radioss", "a_0000.rad", "#RADIOSS STARTER\n/BEGIN\n", "a Radioss deck", "VTU"},
  {"gid", "a.msh", "MESH dimension 3 ElemType Triangle Nnode 3\nCoordinates\n", "a GiD mesh", "VTU"},
  {"fluent", "a.msh", "(0 \"by hand\")\n(2 3)\n", "a Fluent mesh", "VTU"},
  {"tecplot", "a.dat", "TITLE = \"x\"\nVARIABLES = \"X\" \"Y\" \"Z\"\n", "a Tecplot file", "VTU"},
  {"gambit", "a.neu", "        CONTROL INFO 2.4.6\n** GAMBIT NEUTRAL FILE\n", "a Gambit mesh", "VTU"},
  {"tetgen", "a.node", "4 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n", "a TetGen file", "tetgen -k"},
  {"gmshGeometry", "a.geo", "Point(1) = {0, 0, 0, 1};\n", "a Gmsh geometry", "mesh it in Gmsh"},
  // CAD
  {"stepOfAnotherSchema", "a.stp", kStepHead, "a STEP file, which holds surfaces",
   "mesh it in the CAD program and save that as STL or OBJ"},
  {"stepUnderAnyName", "a.obj", kStepHead, "a STEP file", "mesh it"},
  {"iges", "a.igs", columns("by hand", "S      1") + columns("1H,,1H;", "G      1"),
   "an IGES file, which holds surfaces", "mesh it in the CAD program"},
  {"igesWithZeros", "a.iges", columns("", "S0000001") + columns("1H,,1H;", "G0000001"), "an IGES file",
   "STL or OBJ"},
  {"solidWorks", "a.SLDPRT", "\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1" + std::string(50, '\0'), "a SolidWorks part",
   "CAD program"},
  {"inventorPart", "a.ipt", "\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1" + std::string(50, '\0'),
   "an Autodesk Inventor part", "CAD program"},
  {"compoundFile", "a", "\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1" + std::string(50, '\0'),
   "SolidWorks, Inventor or Solid Edge", "CAD program"},
  {"newSolidWorks", "a.sldprt", std::string("\1\2\3\0\0\4\5\6", 8), "a SolidWorks part", "CAD program"},
  {"catia", "a.CATPart", std::string("V5_CFV2\0\0\0", 10), "a CATIA part", "CAD program"},
  {"parasolid", "a.x_t", "**ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz****\n", "a Parasolid part",
   "CAD program"},
  {"acis", "a.sat", "400 0 1 0\n9 by hand 8 ACIS 4.0 24 x\n", "an ACIS part", "CAD program"},
  {"brep", "a.brep", "DBRep_DrawableShape\n\nCASCADE Topology V1\n", "an OpenCASCADE part", "CAD program"},
  {"freecad", "a.FCStd",
   std::string("PK\x03\x04\x14\0\0\0\0\0", 10) + std::string(16, '\0') + std::string("\x0C\0\0\0", 4) +
     "Document.xml<?xml",
   "a FreeCAD document", "CAD program"},
  {"dwg", "a.dwg", std::string("AC1015\0\0\0\0", 10), "a DWG drawing", "save it as DXF"},
  {"rhino", "a.3dm", "3D Geometry File Format        4" + std::string(20, '\0'), "a Rhino model",
   "STL or OBJ"},
  {"sketchUp", "a.skp", std::string("\xFF\xFE\xFF\x0ES\0k\0e\0t\0c\0h\0", 16), "a SketchUp model",
   "STL or OBJ"},
  {"openScad", "a.scad", "cube(10);\n", "an OpenSCAD script", "render it"},
  // images of the body
  {"dicom", "IM0001", at(128, "DICM"), "a DICOM image", "segment the organ"},
  {"dicomNamedAsMesh", "a.stl", at(128, "DICM"), "a DICOM image", "segment the organ"},
  {"nifti", "a.nii", at(344, std::string("n+1\0", 4)), "a NIfTI image", "3D Slicer"},
  {"nrrd", "a.nrrd", "NRRD0004\ntype: short\n", "an NRRD image", "save its surface"},
  {"metaImage", "a.mha", "ObjectType = Image\nNDims = 3\n", "a MetaImage", "save its surface"},
  // pictures and documents
  {"bitmap", "a.bmp", std::string("BM\x3A\x10\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0\x10\0\0\0", 22),
   "a BMP picture", "choose the mesh file"},
  {"webp", "a.obj", std::string("RIFF\x10\0\0\0WEBPVP8 ", 16), "a WebP picture", "choose the mesh file"},
  {"svg", "a.svg", "<?xml version=\"1.0\"?>\n<!-- by hand -->\n<svg xmlns=\"x\">", "an SVG picture",
   "choose the mesh file"},
  {"pdf", "a.stl", "%PDF-1.4\n", "a PDF document", "choose a mesh file"},
  {"webPage", "a.stl", "<!DOCTYPE HTML>\n<html>", "a web page", "choose a mesh file"},
  // archives
  {"zip", "a.obj", "PK\x03\x04 something", "a ZIP archive", "unpack it"},
  {"bzip2", "a.ply.bz2", "BZh91AY&SY", "a bzip2 archive", "unpack it"},
  {"tar", "a.tar", "mesh.obj" + std::string(249, '\0') + "ustar" + std::string(200, '\0'), "a tar archive",
   "unpack it"},
  {"zstd", "a.zst", "\x28\xB5\x2F\xFD and more", "a zstd archive", "unpack it"},
  // others
  {"lfsPointer", "a.stl", "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 1\n",
   "a pointer of Git LFS", "git lfs pull"},
  {"pointCloud", "a.pcd", "# .PCD v0.7 - Point Cloud Data file format\n", "a PCD point cloud",
   "make a surface"},
  {"points", "a.xyz", "0 0 0\n1 0 0\n0 1 0\n", "a table of numbers, perhaps points", "make a surface"},
  {"usd", "a.usda", "#usda 1.0\n", "a USD scene", "save it as OBJ"},
  {"xgl", "a.xgl", "<WORLD>\n<OBJECT>\n</OBJECT></WORLD>\n", "an XGL scene", "save it as OBJ"},
  {"xglPacked", "a.zgl", std::string("\x78\x9C\0\1\2\3", 6), "a packed XGL scene", "save it as OBJ"},
  {"irrlicht", "a.irr", "<?xml version=\"1.0\"?>\n<irr_scene>\n</irr_scene>\n", "an Irrlicht scene",
   "save it as OBJ"},
  {"irrlichtMesh", "a.irrmesh",
   "<?xml version=\"1.0\"?>\n<mesh xmlns=\"http://irrlicht.sourceforge.net/IRRMESH_09_2007\">\n</mesh>\n",
   "an Irrlicht mesh", "save it as OBJ"},
  {"x3dClassic", "a.x3dv", "#X3D V3.3 utf8\nPROFILE Interchange\n", "an X3D scene in the encoding of VRML",
   "save it as .x3d"},
  {"materials", "a.mtl", "newmtl skin\nKd 1 0 0\n", "a list of an OBJ's materials", "choose the .obj"},
  {"gcode", "a.txt", "; generated by PrusaSlicer\nG28\nG1 X0 Y0\n", "a program for a 3D printer",
   "choose a mesh file"},
  {"binaryOff", "a.off", std::string("OFF BINARY\n\0\0\0\3\0\0\0\1", 19), "a binary OFF", "save it as text"},
  {"project", "a.json", "{\n  \"format\": \"esm-project\",\n  \"schema_version\": 1\n}\n",
   "a project of this program", "open it"},
  {"net", "a.txt", "{\"name\": \"n\", \"format\":\"esm-net-1\"}", "a net with numbers of its own",
   "esm import"},
  {"sofaScene", "a.scn", "<?xml version=\"1.0\"?>\n<Node name=\"root\">\n</Node>", "a SOFA scene",
   "choose the mesh file that it names"},
};

class ForeignFile : public ::testing::TestWithParam<Foreign> {};

TEST_P(ForeignFile, isCalledWhatItIsWithAWayToAMesh)
{
  const auto imported = importBytes(GetParam().name, GetParam().bytes);
  ASSERT_FALSE(imported);
  EXPECT_EQ(imported.error().code, ErrorCode::Unsupported);
  EXPECT_THAT(imported.error().detail,
              AllOf(HasSubstr(std::string(GetParam().name) + ": this is "), HasSubstr(GetParam().what),
                    HasSubstr(GetParam().wayOut), Not(HasSubstr("cut short"))));
}
INSTANTIATE_TEST_SUITE_P(Files, ForeignFile, ::testing::ValuesIn(kForeign),
                         [](const auto& file) { return std::string(file.param.test); });

TEST(ForeignKinds, theFilesOfTheDataFolderAreNamed)
{
  const auto deck = importMesh(kMeshData / "abaqus.inp"), step = importMesh(kMeshData / "plate.step");
  ASSERT_FALSE(deck);
  EXPECT_THAT(deck.error().detail,
              AllOf(HasSubstr("this is an Abaqus or CalculiX deck; convert it to VTU or Gmsh .msh")));
  ASSERT_FALSE(step);
  EXPECT_THAT(step.error().detail, HasSubstr("this is a STEP file, which holds surfaces and no mesh; mesh it "
                                             "in the CAD program and save that as STL or OBJ"));
}

// === What the library reads all the same

const std::string kOgre = R"(<?xml version="1.0"?>
<mesh><submeshes><submesh material="m" usesharedvertices="false" use32bitindexes="false" operationtype="triangle_list">
<faces count="1"><face v1="0" v2="1" v3="2"/></faces>
<geometry vertexcount="3"><vertexbuffer positions="true">
<vertex><position x="0" y="0" z="0"/></vertex><vertex><position x="1" y="0" z="0"/></vertex>
<vertex><position x="0" y="1" z="0"/></vertex>
</vertexbuffer></geometry></submesh></submeshes></mesh>
)";
TEST(ForeignKinds, ogreGoesToTheLibraryWhateverItsName)
{
  for (const char* name : {"a.mesh.xml", "a.xml", "a"})
    EXPECT_EQ(summary(importBytes(name, kOgre)), "3/3/1") << name;
}

TEST(ForeignKinds, aStepFileOfBuildingsIsNoStepPart)
{
  // the name of the schema may stand far behind the start
  const std::string head =
    "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION(('" + std::string(5000, 'x') + "'),'2;1');\n";
  EXPECT_THAT(refusalOf("a.ifc", head + "FILE_SCHEMA(('IFC2X3'));\nENDSEC;\n"),
              Not(HasSubstr("STEP file, which holds surfaces")));
  EXPECT_THAT(refusalOf("a.ifc", head + "FILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\n"),
              HasSubstr("STEP file, which holds surfaces"));
  const auto imported = importBytes(
    "a.ifc",
    "ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('IFC2X3'));\nENDSEC;\nDATA;\nENDSEC;\nEND-ISO-10303-21;\n");
  ASSERT_FALSE(imported); // it is empty
  EXPECT_THAT(imported.error().detail, Not(HasSubstr("STEP file, which holds surfaces")));
}

TEST(ForeignKinds, aFormatOfTheLibraryNamedAsObjIsWhatItIs)
{
  EXPECT_EQ(summary(importBytes("a.obj", kOgre)), "3/3/1");
}

/// What a mesh may have in common with other files does not make it foreign.
TEST(ForeignKinds, meshesThatResembleOthersAreRead)
{
  EXPECT_EQ(summary(importBytes("a.obj", "# grid, by hand\ng grid\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")),
            "3/3/1");
  std::string bytes = binaryStl(kTwoFacets, 2, "AC1015 ftyp");
  bytes.replace(96 + 36 - 4, 4, "DICM"); // a large coordinate
  EXPECT_EQ(importBytes("a.stl", bytes)->report.triangles, 2);
}

} // namespace
