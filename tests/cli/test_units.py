# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
"""Unit and axes that a mesh file states itself: used once, whatever the flags say, and said."""
import base64
import io
import itertools
import json
import struct
import unittest
import zipfile
import zlib

from program import ProgramTest

# Where a box of 10 x 20 x 40 units lies: no side is like another, so that each turn shows.
CORNERS = list(itertools.product((0, 10), (0, 20), (0, 40)))
QUADS = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
TRIANGLES = [t for a, b, c, d in QUADS for t in ((a, b, c), (a, c, d))]
TEXT = " ".join(f"{x} {y} {z}" for x, y, z in CORNERS)


def collada(asset):
    corners = " ".join(str(i) for t in TRIANGLES for i in t)
    return f"""<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">{asset}
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="a" count="24">{TEXT}</float_array><technique_common>
<accessor source="#a" count="8" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor>
</technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="12"><input semantic="VERTEX" source="#v" offset="0"/><p>{corners}</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node><instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>
"""


def amf(unit):
    vertices = "".join(f"<vertex><coordinates><x>{x}</x><y>{y}</y><z>{z}</z></coordinates></vertex>" for x, y, z in CORNERS)
    faces = "".join(f"<triangle><v1>{a}</v1><v2>{b}</v2><v3>{c}</v3></triangle>" for a, b, c in TRIANGLES)
    return f"""<?xml version="1.0"?><amf{unit}><object id="1"><mesh><vertices>{vertices}</vertices>
<volume>{faces}</volume></mesh></object></amf>"""


def three_mf(unit, others=(), without=(), change=lambda name, content: content):
    vertices = "".join(f'<vertex x="{x}" y="{y}" z="{z}"/>' for x, y, z in CORNERS)
    faces = "".join(f'<triangle v1="{a}" v2="{b}" v3="{c}"/>' for a, b, c in TRIANGLES)
    model = f"""<?xml version="1.0" encoding="UTF-8"?><model{unit} xml:lang="en-US"
xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources><object id="1" type="model"><mesh>
<vertices>{vertices}</vertices><triangles>{faces}</triangles></mesh></object></resources>
<build><item objectid="1"/></build></model>"""
    relation = ('<Relationship Target="/3D/3dmodel.model" Id="r" '
                'Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>')
    parts = {"[Content_Types].xml": '<?xml version="1.0"?><Types xmlns="http://schemas.openxmlformats.org/package/2006/'
                                    'content-types"><Default Extension="rels" ContentType="application/vnd.openxmlformats-package.'
                                    'relationships+xml"/><Default Extension="model" ContentType="application/vnd.ms-package.'
                                    '3dmanufacturing-3dmodel+xml"/></Types>',
             "_rels/.rels": '<?xml version="1.0"?><Relationships xmlns="http://schemas.openxmlformats.org/package/2006/'
                            f'relationships">{relation}</Relationships>',
             "3D/3dmodel.model": model}
    archive = io.BytesIO()
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED) as out:
        for name, content in [*parts.items(), *others]:
            if name not in without:
                out.writestr(name, change(name, content))
    return archive.getvalue()


def dxf(units):
    header = f"  9\n$ACADVER\n  1\nAC1015\n  9\n$INSUNITS\n 70\n{units}\n" if units is not None else "  9\n$ACADVER\n  1\nAC1015\n"
    faces = "".join("  0\n3DFACE\n  8\n0\n" + "".join(
        f" {10 + k}\n{CORNERS[i][0]}\n {20 + k}\n{CORNERS[i][1]}\n {30 + k}\n{CORNERS[i][2]}\n"
        for k, i in enumerate(quad)) for quad in QUADS)
    return f"  0\nSECTION\n  2\nHEADER\n{header}  0\nENDSEC\n  0\nSECTION\n  2\nENTITIES\n{faces}  0\nENDSEC\n  0\nEOF\n"


def binary_stl(header):
    facets = b"".join(struct.pack("<12fH", 0, 0, 0, *(x for i in t for x in CORNERS[i]), 0) for t in TRIANGLES)
    return header.encode().ljust(80) + struct.pack("<I", len(TRIANGLES)) + facets


def ascii_stl(name):
    facets = "".join("facet normal 0 0 0\nouter loop\n" + "".join("vertex {} {} {}\n".format(*CORNERS[i]) for i in t) +
                     "endloop\nendfacet\n" for t in TRIANGLES)
    return f"solid {name}\n{facets}endsolid\n"


def ply(comment):
    return (f"ply\nformat ascii 1.0\n{comment}element vertex 8\nproperty float x\nproperty float y\nproperty float z\n"
            "element face 12\nproperty list uchar int vertex_indices\nend_header\n" +
            "".join("{} {} {}\n".format(*p) for p in CORNERS) + "".join("3 {} {} {}\n".format(*t) for t in TRIANGLES))


def obj(comment):
    return (comment + "".join("v {} {} {}\n".format(*p) for p in CORNERS) +
            "".join("f {} {} {}\n".format(*(i + 1 for i in t)) for t in TRIANGLES))


def vtk(title):
    return (f"# vtk DataFile Version 4.2\n{title}\nASCII\nDATASET POLYDATA\nPOINTS 8 float\n{TEXT}\n"
            f"POLYGONS 12 48\n" + "".join("3 {} {} {}\n".format(*t) for t in TRIANGLES))


def vtp_of_bytes(field, encoding="base64", how="", appended=b""):
    """As vtp(), with the given array of field data and bytes in the appended part."""
    tail = b'<AppendedData encoding="' + encoding.encode() + b'">_' + appended + b"</AppendedData>" if appended else b""
    text = vtp("").replace('<Array type="String" Name="SPACE" NumberOfTuples="1" format="ascii"> 0</Array>', field)
    text = text.replace(' byte_order="LittleEndian"', ' byte_order="LittleEndian" ' + how)
    return text.encode().replace(b"</VTKFile>", tail + b"</VTKFile>")


def spaces_of_vtk(space):
    """The ways in which VTK writes a string into the field data: name, content, whether it can be read."""
    text = space.encode() + b"\0"
    plain = struct.pack("<I", 4) + text
    packed = zlib.compress(text)
    # The sizes of zipped blocks and the blocks are two base64 texts.
    zipped = base64.b64encode(struct.pack("<4I", 1, 4, 0, len(packed))) + base64.b64encode(packed)
    zlib_says = 'compressor="vtkZLibDataCompressor"'
    tag = '<Array type="String" Name="SPACE" NumberOfTuples="1" format="{}"{}>{}</Array>'
    binary = lambda content: tag.format("binary", "", content.decode())
    appended = tag.format("appended", ' offset="0"', "")
    codes = " ".join(str(c) for c in text[:3])
    box = vtk("by hand").split("POINTS", 1)
    ascii_vtk = lambda field: (box[0] + "FIELD FieldData 1\n" + field + "\nPOINTS" + box[1]).encode()
    string = bytes([0xC0 | 3]) + space.encode()
    points = struct.pack(">24f", *(x for corner in CORNERS for x in corner))
    cells = b"".join(struct.pack(">4i", 3, *t) for t in TRIANGLES)
    big = lambda field: (b"# vtk DataFile Version 4.2\nby hand\nBINARY\nDATASET POLYDATA\nFIELD FieldData 1\n" + field +
                         b"\nPOINTS 8 float\n" + points + b"\nPOLYGONS 12 48\n" + cells + b"\n")
    return [("binary.vtp", vtp_of_bytes(binary(base64.b64encode(plain))), True),
            ("zipped.vtp", vtp_of_bytes(binary(zipped), how=zlib_says), True),
            ("appended.vtp", vtp_of_bytes(appended, appended=base64.b64encode(plain)), True),
            ("raw.vtp", vtp_of_bytes(appended, encoding="raw", appended=plain), True),
            ("raw_zip.vtp", vtp_of_bytes(appended, encoding="raw", how=zlib_says,
                                         appended=struct.pack("<4I", 1, 4, 0, len(packed)) + packed), True),
            ("bytes.vtp", vtp_of_bytes(f'<DataArray type="Int8" Name="SPACE" format="ascii">{codes}</DataArray>'), True),
            ("long.vtp", vtp_of_bytes(binary(base64.b64encode(struct.pack("<Q", 4) + text)), how='header_type="UInt64"'), True),
            ("cut.vtp", vtp_of_bytes(binary(base64.b64encode(plain[:6]))), False),
            ("field.vtk", ascii_vtk("SPACE 1 1 string\n" + space), True),
            ("letters.vtk", ascii_vtk("SPACE 1 3 char\n" + codes), True),
            ("field_big.vtk", big(b"SPACE 1 1 string\n" + string), True),
            ("letters_big.vtk", big(b"SPACE 1 3 unsigned_char\n" + text[:3]), True),
            ("variant.vtk", ascii_vtk("SPACE 1 1 variant\n13 " + space), False)]


def vtp(space):
    letters = " ".join(str(ord(c)) for c in space) + " 0"
    corners = " ".join(str(i) for t in TRIANGLES for i in t)
    return f"""<?xml version="1.0"?>
<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian"><PolyData>
<FieldData><Array type="String" Name="SPACE" NumberOfTuples="1" format="ascii">{letters}</Array></FieldData>
<Piece NumberOfPoints="8" NumberOfPolys="12"><Points>
<DataArray type="Float32" Name="p" NumberOfComponents="3" format="ascii">{TEXT}</DataArray></Points>
<Polys><DataArray type="Int64" Name="connectivity" format="ascii">{corners}</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">{" ".join(str(3 * i + 3) for i in range(12))}</DataArray></Polys>
</Piece></PolyData></VTKFile>
"""


def fbx(settings):
    """`settings`: name -> whole number of each axis and sign, and the unit in cm."""
    lines = "".join(f'P: "{name}", "int", "Integer", "",{value}\n' if name != "UnitScaleFactor" else
                    f'P: "{name}", "double", "Number", "",{value}\n' for name, value in settings.items())
    corners = ",".join(f"{a},{b},{-c - 1}" for a, b, c in TRIANGLES)
    return f"""; FBX 7.3.0 project file
FBXHeaderExtension:  {{
FBXHeaderVersion: 1003
FBXVersion: 7300
}}
GlobalSettings:  {{
Version: 1000
Properties70:  {{
{lines}}}
}}
Objects:  {{
Geometry: 100, "Geometry::a", "Mesh" {{
Vertices: *24 {{
a: {TEXT.replace(" ", ",")}
}}
PolygonVertexIndex: *36 {{
a: {corners}
}}
GeometryVersion: 124
}}
Model: 200, "Model::a", "Mesh" {{
Version: 232
Properties70:  {{
}}
}}
}}
Connections:  {{
C: "OO",200,0
C: "OO",100,200
}}
"""


def fbx_axes(right, up, front, unit):
    """Axes as signed numbers from 1."""
    settings = {}
    for name, axis in (("UpAxis", up), ("FrontAxis", front), ("CoordAxis", right)):
        settings[name] = abs(axis) - 1
        settings[name + "Sign"] = 1 if axis > 0 else -1
    return fbx({**settings, "UnitScaleFactor": unit})


def x3d(head):
    corners = " ".join(f"{a} {b} {c} -1" for a, b, c in TRIANGLES)
    return f"""<?xml version="1.0" encoding="UTF-8"?><X3D profile="Interchange" version="3.3">{head}<Scene><Shape>
<IndexedFaceSet coordIndex="{corners}"><Coordinate point="{TEXT}"/></IndexedFaceSet></Shape></Scene></X3D>
"""


def inventor(units):
    faces = ", ".join(f"{a}, {b}, {c}, -1" for a, b, c in TRIANGLES)
    points = ", ".join("{} {} {}".format(*p) for p in CORNERS)
    return f"""#Inventor V2.1 ascii
Separator {{ {units} Coordinate3 {{ point [ {points} ] }} IndexedFaceSet {{ coordIndex [ {faces} ] }} }}
"""


MM, CM, INCH, METRE = 1.0, 10.0, 25.4, 1000.0
FLAT, UPRIGHT = (10, 20, 40), (10, 40, 20)  # as the numbers stand; y up became z up


class UnitsTest(ProgramTest):
    def size(self, name, *flags):
        """Size in mm of what becomes of a file, and what is said on the way."""
        done = self.run_program("import", name, "-o", "made.esm", *flags, "--json")
        return json.loads(done.stdout.splitlines()[-1])["size_mm"], done.stderr

    def check(self, name, content, side, unit, flags=(), says=""):
        self.write(name, content)
        size, said = self.size(name, *flags)
        for got, want in zip(size, side):
            # float32 in foreign formats: 1e-6 of the size
            self.assertAlmostEqual(got, want * unit, delta=2e-6 * max(side) * unit, msg=f"{name} {flags} {said}")
        self.assertIn(says, said)
        return said

    def test_stated_units_are_used_once(self):
        asset = '<asset><unit name="u" meter="{}"/><up_axis>{}</up_axis></asset>'
        files = [
            ("mm_z.dae", collada(asset.format(0.001, "Z_UP")), FLAT, MM, "millimetres and z up"),
            ("inch_y.dae", collada(asset.format(0.0254, "Y_UP")), UPRIGHT, INCH, "inches and y up"),
            ("cm_x.dae", collada(asset.format(0.01, "X_UP")), (20, 40, 10), CM, "centimetres and x up"),
            ("micron.amf", amf(' unit="micron"'), FLAT, 1e-3, "micrometres"),
            ("inch.amf", amf(' unit="inch"'), FLAT, INCH, "inches"),
            ("none.amf", amf(""), FLAT, MM, "millimetres"),
            ("inch.3mf", three_mf(' unit="inch"'), FLAT, INCH, "inches"),
            ("none.3mf", three_mf(""), FLAT, MM, "millimetres"),
            ("mm.dxf", dxf(4), FLAT, MM, "millimetres"),
            ("cm.dxf", dxf(5), FLAT, CM, "centimetres"),
            ("inch.dxf", dxf(1), FLAT, INCH, "inches"),
            ("mm_z.fbx", fbx_axes(1, 3, -2, 0.1), FLAT, MM, "millimetres and z up"),
            ("inch_y.fbx", fbx_axes(1, 2, 3, 2.54), UPRIGHT, INCH, "inches and y up"),
            ("cm_x.fbx", fbx_axes(-2, 1, 3, 1), (20, 40, 10), CM, "centimetres and y up"),
            ("none.fbx", fbx({}), UPRIGHT, CM, "centimetres and y up"),
            ("mm.x3d", x3d('<head><unit category="length" conversionFactor="0.001" name="mm"/></head>'), FLAT, MM,
             "millimetres"),
            ("mm.iv", inventor("Units { units MILLIMETERS }"), FLAT, MM, "metres"),
        ]
        for name, content, side, unit, stated in files:
            for flags in ((), ("--unit", "mm"), ("--unit", "inch", "--up", "y")):
                if "--up" in flags and "up" not in stated:
                    continue  # the choice holds where the file is silent
                self.check(name, content, side, unit, flags, f"The file states {stated}")

    def test_a_flag_against_the_file_is_told_and_can_win(self):
        asset = '<asset><unit meter="0.01"/><up_axis>Y_UP</up_axis></asset>'
        said = self.check("a.dae", collada(asset), UPRIGHT, CM, ("--unit", "mm"))
        self.assertIn("which is used and not unit mm", said)
        self.assertIn("--ignore-stated", said)
        said = self.check("a.dae", collada(asset), FLAT, MM, ("--unit", "mm", "--ignore-stated"))
        self.assertIn("the choices hold and not that", said)
        self.assertEqual(self.read_json("made.esm")["source"]["ignore_stated"], True)

    def test_files_that_state_nothing_follow_the_flags(self):
        for name, content in (("a.obj", obj("# 8 points\n")), ("a.dxf", dxf(None)), ("unitless.dxf", dxf(0)),
                              ("a.ply", ply("comment by hand\n")), ("a.stl", binary_stl("by hand")),
                              ("a.iv", inventor("")), ("a.x3d", x3d(""))):
            said = self.check(name, content, UPRIGHT, MM, ("--unit", "mm", "--up", "y"))
            self.assertNotIn("states", said)
            self.assertNotIn("warning", said)

    def test_axes_of_patients_are_used(self):
        # 3D Slicer writes them where each format has room for a word; -x, -y, z.
        files = [("s.stl", None), ("a.stl", ascii_stl("3D Slicer output. SPACE={}")),
                 ("s.ply", ply("comment 3D Slicer output. SPACE={}\n")), ("s.obj", obj("# 3D Slicer output. SPACE={}\n")),
                 ("s.vtk", vtk("3D Slicer output. SPACE={}")), ("s.vtp", None)]
        for name, content in files:
            for space, low in (("LPS", [-0.01, -0.02, 0]), ("RAS", [0, 0, 0])):
                if name == "s.vtp":
                    self.write(name, vtp(space))
                elif name == "s.stl":
                    self.write(name, binary_stl("Visualization Toolkit generated SLA File. SPACE=" + space))
                else:
                    self.write(name, content.format(space))
                made = self.json_of("import", name, "-o", "a.esm", "--unit", "mm")
                for got, want in zip(made["after"]["bbox_min"], low):
                    self.assertAlmostEqual(got, want, delta=1e-8, msg=name)
                self.assertIn(f"The file states a patient's axes ({space}), which is used", " ".join(made["notes"]))

    def test_axes_in_field_data_are_used_or_asked_for(self):
        for space, low in (("LPS", [-0.01, -0.02, 0]), ("RAS", [0, 0, 0])):
            for name, content, is_read in spaces_of_vtk(space):
                self.write(name, content)
                made = self.json_of("import", name, "-o", "a.esm", "--unit", "mm")
                notes = " ".join(made["notes"])
                self.assertEqual(f"The file states a patient's axes ({space}), which is used" in notes, is_read, name + notes)
                self.assertEqual("(SPACE) are not read: " in notes and "--patient-axes lps or ras" in notes, not is_read, name + notes)
                for got, want in zip(made["after"]["bbox_min"], low if is_read else (0, 0, 0)):
                    self.assertAlmostEqual(got, want, delta=1e-8, msg=name)

    def test_units_that_are_no_length_are_told(self):
        for unit in ("0,001", "0", "-1", "inf", "mm"):
            for name, content in (("a.dae", collada(f'<asset><unit meter="{unit}"/><up_axis>Z_UP</up_axis></asset>')),
                                  ("a.3mf", three_mf(f' unit="{unit}"')),
                                  ("a.x3d", x3d(f'<head><unit category="length" name="u" conversionFactor="{unit}"/></head>'))):
                self.write(name, content)
                for flags, metre in (((), 1.0), (("--unit", "mm"), 0.001)):
                    made = self.json_of("import", name, "-o", "a.esm", *flags)
                    self.assertIn(f"The unit that the file states, '{unit}', is no length and is not used; --unit states it.",
                                  " ".join(made["notes"]), name)
                    self.assertAlmostEqual(max(made["size_mm"]) / 1000, 40 * metre, delta=1e-4 * metre, msg=name)

    def test_the_organ_of_80_mm(self):
        size = [80, 40, 40]
        points = [(40 * x, 20 * y, 20 * z) for x, y, z in itertools.product((-1, 1), repeat=3)]
        content = collada('<asset><unit meter="0.001"/><up_axis>Z_UP</up_axis></asset>')
        content = content.replace(TEXT, " ".join(f"{x} {y} {z}" for x, y, z in points))
        self.write("organ.dae", content)
        for flags in ((), ("--unit", "mm"), ("--up", "y")):
            got, said = self.size("organ.dae", *flags)
            for a, b in zip(got, size):
                self.assertAlmostEqual(a, b, delta=1e-4)
            self.assertIn("80 x 40 x 40 mm", said)
            self.assertNotIn("warning", said)

    def test_what_is_exported_comes_back_in_its_place(self):
        self.write("box.obj", obj(""))
        self.run_program("import", "box.obj", "--unit", "mm", "-o", "box.esm")
        for ending in ("obj", "ply", "stl", "glb", "gltf", "vtu"):
            self.run_program("export", "box.esm", "-o", "x." + ending)
            for flags in ((), ("--unit", "mm")) if ending in ("glb", "gltf") else ((),):
                made = self.json_of("import", "x." + ending, "-o", "back.esm", *flags)
                for got, want in zip(made["after"]["bbox_min"] + made["after"]["bbox_max"], (0, 0, 0, .01, .02, .04)):
                    self.assertAlmostEqual(got, want, delta=1e-8, msg=ending)

    def test_files_with_different_units_meet(self):
        # Two halves of one body: 10 units of mm, and 1 unit of cm.
        self.write("a.dxf", dxf(4))
        self.write("b.dxf", dxf(5).replace("\n10\n", "\n1\n").replace("\n20\n", "\n2\n").replace("\n40\n", "\n4\n"))
        made = self.json_of("import", "a.dxf", "b.dxf", "-o", "a.esm", "--weld-tolerance", "1e-9")
        self.assertEqual(made["nodes"], 8)
        self.assertIn("b.dxf: The file states centimetres", " ".join(made["notes"]))
        # What states nothing follows the flag, beside one that states.
        self.write("c.obj", obj(""))
        made = self.json_of("import", "c.obj", "a.dxf", "-o", "b.esm", "--unit", "mm", "--weld-tolerance", "1e-9")
        self.assertEqual(made["nodes"], 8)
        self.assertAlmostEqual(max(made["size_mm"]), 40)

    def test_sizes_that_no_organ_has_are_warned_of(self):
        self.write("box.obj", obj(""))
        for unit, warns in (("mm", False), ("cm", False), ("inch", False), ("m", True)):
            done = self.run_program("import", "box.obj", "--unit", unit, "-o", "a.esm")
            self.assertEqual("warning" in done.stderr, warns, done.stderr)
        self.assertIn("10000 x 20000 x 40000 mm", done.stderr)
        self.write("small.dxf", dxf(13))  # micrometres
        done = self.run_program("import", "small.dxf", "-o", "a.esm")
        self.assertIn("--ignore-stated", done.stderr.split("warning")[1])

    def test_inspect_says_what_is_stated(self):
        self.write("a.3mf", three_mf(' unit="inch"'))
        seen = self.json_of("inspect", "a.3mf")
        self.assertEqual((seen["bbox_max"], seen["stated"]), ([10, 20, 40], "inches"))
        self.assertAlmostEqual(seen["size_mm"][0], 254)
        self.assertIn("The file states inches", " ".join(seen["notes"]))

    def test_a_recipe_keeps_the_choice(self):
        self.write("a.dxf", dxf(1))
        self.run_program("import", "a.dxf", "--unit", "mm", "--ignore-stated", "-o", "a.esm", "--save-recipe", "r.json")
        made = self.json_of("import", "a.dxf", "--recipe", "r.json", "-o", "b.esm")
        self.assertAlmostEqual(max(made["size_mm"]), 40)


if __name__ == "__main__":
    unittest.main()
