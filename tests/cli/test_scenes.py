# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
"""Scenes that foreign libraries read: their parts in other files, what is no mesh, what crashes these libraries."""
import json
import os
import shutil
import struct
import unittest
import zlib

from program import SOURCE, ProgramTest
from test_units import obj, three_mf

QUAD = """#Inventor V2.1 ascii
Separator {{
  Separator {{ Coordinate3 {{ point [0 0 0, 10 0 0, 10 10 0, 0 10 0] }} IndexedFaceSet {{ coordIndex [0, 1, 2, 3, -1] }} }}
  {}
}}
"""
PART = """#Inventor V2.1 ascii
Separator {{
  Coordinate3 {{ point [20 {0} 0, 30 {0} 0, 30 1{0} 0, 20 1{0} 0] }} IndexedLineSet {{ coordIndex [0, 1, 2, 3, 0, -1] }}
  {1}
}}
"""
VRML2 = """#VRML V2.0 utf8
Shape {{ geometry IndexedFaceSet {{ coord Coordinate {{ point [0 0 0, 10 0 0, 10 10 0] }} coordIndex [0 1 2 -1] }} }}
{}
"""
VRML1 = """#VRML V1.0 ascii
Separator {{
  Coordinate3 {{ point [ 0 0 0, 10 0 0, 10 10 0, 0 10 0 ] }} IndexedFaceSet {{ coordIndex [ 0,1,2,-1, 0,2,3,-1 ] }}
  {}
}}
"""

BVH = """HIERARCHY
ROOT Hips
{
	OFFSET 0.0 0.0 0.0
	CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
	JOINT Leg
	{
		OFFSET 0.0 -10.0 0.0
		CHANNELS 3 Zrotation Xrotation Yrotation
		End Site
		{
			OFFSET 0.0 -5.0 0.0
		}
	}
}
MOTION
Frames: 1
Frame Time: 0.033333
0 0 0 0 0 0 0 0 0
"""

DAE_OF_BONES = """<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset><up_axis>Z_UP</up_axis></asset>
<library_visual_scenes><visual_scene id="s"><node id="hip" type="JOINT"><translate>0 0 1</translate>
<node id="knee" type="JOINT"><translate>0 0 5</translate></node></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>
"""

SMD_OF_BONES = """version 1
nodes
0 "root" -1
1 "child" 0
end
skeleton
time 0
0 0 0 0 0 0 0
1 0 0 5 0 0 0
time 1
0 0 0 0 0 0 0
1 0 0 6 0 0 0
end
"""


def png():
    def chunk(kind, content):
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))
    rows = zlib.compress(b"\0\xff\0\0" * 1)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 1, 1, 8, 2, 0, 0, 0)) + chunk(b"IDAT", rows) +
            chunk(b"IEND", b""))


class ScenesTest(ProgramTest):
    def setUp(self):
        super().setUp()
        (self.folder / "scene" / "deep").mkdir(parents=True)

    def inspect(self, name):
        """Counts "nodes/springs" and the notes in one text."""
        seen = self.json_of("inspect", name)
        return f"{seen['nodes']}/{seen['springs']}", " ".join(seen["notes"])

    def check(self, name, content, counts, *says):
        self.write(name, content)
        got, notes = self.inspect(name)
        self.assertEqual(got, counts, notes)
        for words in says:
            self.assertIn(words, notes)
        if not says:
            self.assertNotIn("missing", notes)

    # === Bones are no net

    def test_what_holds_only_bones_is_refused(self):
        for name, content in (("a.bvh", BVH), ("a.dae", DAE_OF_BONES), ("a.smd", SMD_OF_BONES)):
            self.write(name, content)
            for command in (("inspect", name), ("import", name, "-o", "a.esm")):
                said = self.refused(*command)
                self.assertNotIn("crashed", said)
        self.write("a.bvh", BVH)
        self.assertIn("neither a face nor a line", self.refused("inspect", "a.bvh"))

    # === Parts in other files

    def test_parts_are_looked_for_beside_the_scene_not_where_one_stands(self):
        self.write("scene/part.iv", PART.format(0, ""))
        self.write("part.iv", PART.format(5, ""))  # in the working directory, and another one
        self.check("scene/a.iv", QUAD.format('File { name "part.iv" }'), "8/9")
        self.assertEqual(self.json_of("inspect", "scene/a.iv")["bbox_max"], [30, 10, 0])
        self.write("scene/deep/inner.iv", PART.format(0, ""))
        self.write("scene/deep/outer.iv", PART.format(7, 'File { name "inner.iv" }'))  # beside that part
        self.check("scene/b.iv", QUAD.format('File { name "deep/outer.iv" }'), "12/13")
        self.check("scene/c.iv", QUAD.format('File { name "deep\\\\outer.iv" }'), "12/13")
        self.write("scene/part.wrl", VRML2.format("").replace("10", "30"))
        self.check("scene/d.wrl", VRML2.format('Inline { url "part.wrl" }'), "5/6")
        self.write("scene/part one.wrl", VRML2.format("").replace("10", "30"))
        self.check("scene/e.wrl", VRML2.format('Inline { url "part%20one.wrl" }'), "5/6")
        self.write("scene/part1.wrl", VRML1.format("").replace("10", "30"))
        self.check("scene/f.wrl", VRML1.format('WWWInline { name "part1.wrl" }'), "7/10")

    def test_lost_parts_are_named(self):
        absent = "there is no such file in the model's folder"
        self.check("a.iv", QUAD.format('File { name "gone.iv" }'), "4/5", f"part 'gone.iv' is missing here: {absent}")
        self.check("b.wrl", VRML2.format('Inline { url "gone.wrl" }'), "3/3", "'gone.wrl'", absent)
        self.check("c.wrl", VRML1.format('WWWInline { name "missing.wrl" }'), "4/5", "'missing.wrl'", absent)
        self.check("d.wrl", VRML2.format('Inline { url "http://example.org/a.wrl" }'), "3/3", "nothing is fetched")
        self.check("e.iv", QUAD.format('File { name "one.iv" } File { name "two.iv" }'), "4/5", "'one.iv'", "'two.iv'")
        # A scene without anything of its own is refused, and it is said why.
        self.write("f.iv", '#Inventor V2.1 ascii\nFile { name "gone.iv" }\n')
        self.assertIn("'gone.iv' is missing here", self.refused("inspect", "f.iv"))

    def test_lost_objects_of_a_lightwave_scene_are_named(self):
        self.write("a.lws", "LWSC\n3\n\nLoadObject chair.lwo\n\nLoadObject Objects\\table.lwo\n\nAddNullObject n\n")
        said = self.refused("inspect", "a.lws")
        for name in ("chair.lwo", "table.lwo"):
            self.assertIn(name, said)

    def test_lost_buffers_are_named(self):
        document = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
                    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
                    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                                   "min": [0, 0, 0], "max": [1, 1, 0]}],
                    "bufferViews": [{"buffer": 0, "byteLength": 36}],
                    "buffers": [{"byteLength": 36, "uri": "gone.bin"}]}
        self.write("a.gltf", json.dumps(document))
        said = self.refused("inspect", "a.gltf")
        self.assertIn("its part 'gone.bin' is missing here: there is no such file", said)
        self.assertIn("put its parts beside it", said)
        self.assertNotIn("library cannot read", said)
        (self.folder / "outside.bin").write_bytes(struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0))
        document["buffers"][0]["uri"] = "../outside.bin"
        self.write("scene/a.gltf", json.dumps(document))
        self.assertIn("'../outside.bin' is missing here: it lies outside", self.refused("inspect", "scene/a.gltf"))

    def test_a_scene_is_no_part_of_itself(self):
        self.check("a.iv", QUAD.format('File { name "a.iv" }'), "4/5", "would be a part of itself")
        self.write("b.iv", PART.format(0, 'File { name "c.iv" }'))
        self.check("c.iv", QUAD.format('File { name "b.iv" }'), "8/9", "would be a part of itself")
        self.check("d.wrl", VRML2.format('Inline { url "d.wrl" }'), "3/3", "would be a part of itself")
        self.check("e.wrl", VRML1.format('WWWInline { name "e.wrl" }'), "4/5", "would be a part of itself")

    def test_prototypes_in_other_files(self):
        self.write("things.wrl", "#VRML V2.0 utf8\nPROTO Thing [ ] { Shape { geometry IndexedFaceSet { coord Coordinate "
                   "{ point [0 0 5, 10 0 5, 10 10 5] } coordIndex [0 1 2 -1] } } }\n")
        use = 'EXTERNPROTO Thing [ ] "{}#Thing"\nThing {{ }}\n'
        self.check("scene/../a.wrl", VRML2.format(use.format("things.wrl")), "6/6")
        self.write("scene/a.wrl", VRML2.format(use.format("../things.wrl")))
        self.assertIn("'../things.wrl' is missing here: it lies outside", self.refused("inspect", "scene/a.wrl"))

    # === What lies outside stays closed

    def test_what_lies_outside_the_folder_stays_closed(self):
        outside = self.write("outside.iv", PART.format(0, ""))
        self.write("outside.wrl", VRML2.format("").replace("10", "30"))
        os.symlink(outside, self.folder / "scene" / "link.iv")
        os.symlink(self.folder, self.folder / "scene" / "up")
        os.mkfifo(self.folder / "scene" / "pipe.iv")
        for name in ("../outside.iv", str(outside), "link.iv", "up/outside.iv", "scene/../../outside.iv", "/dev/zero",
                     "/dev/stdin", "/proc/self/environ", "file://" + str(outside)):
            self.check("scene/a.iv", QUAD.format(f'File {{ name "{name}" }}'), "4/5", "stays closed", name)
            self.check("scene/a.wrl", VRML2.format(f'Inline {{ url "{name}" }}'), "3/3", "stays closed", name)
            self.check("scene/b.wrl", VRML1.format(f'WWWInline {{ name "{name}" }}'), "4/5", "stays closed", name)
        self.check("scene/a.iv", QUAD.format('File { name "pipe.iv" }'), "4/5", "it is no regular file and stays closed")
        self.check("scene/a.wrl", VRML2.format('Inline { url "pipe.iv" }'), "3/3", "no regular file")

    def test_pictures_are_not_opened(self):
        os.mkfifo(self.folder / "pipe.png")  # who opened it would wait for ever
        self.check("a.iv", QUAD.format('Texture2 { filename "pipe.png" }'), "4/5")
        self.check("b.wrl", VRML2.format(
            'Shape { appearance Appearance { texture ImageTexture { url "pipe.png" } } geometry IndexedLineSet '
            '{ coord Coordinate { point [0 0 5, 1 0 5] } coordIndex [0 1 -1] } }'), "5/4")

    def test_a_name_that_changes_after_the_reading_opens_nothing(self):
        outside = self.write("outside.iv", PART.format(0, ""))
        self.write("scene/a.iv", QUAD.format(
            f'File {{ name "x" = SelectOne {{ type "MFString" index 0 input [ "{outside}" ] }} . output }}'))
        self.assertEqual(self.inspect("scene/a.iv")[0], "4/5")

    # === What crashed the libraries

    def test_bindings_without_indices(self):
        faces = "Coordinate3 {{ point [ 0 0 0, 10 0 0, 10 10 0, 0 10 0, 20 0 0, 20 10 0 ] }} {} IndexedFaceSet {{ coordIndex [0, 1, 2, 3, -1, 1, 4, 5, 2, -1] {} }}"
        colours = "Material { diffuseColor [ 1 0 0, 0 1 0 ] } "
        for binding in ("PER_FACE_INDEXED", "PER_VERTEX_INDEXED", "PER_FACE", "PER_VERTEX", "PER_PART_INDEXED"):
            for looks, own in ((colours + f"MaterialBinding {{ value {binding} }}", ""),
                               (f"Normal {{ vector [0 0 1] }} NormalBinding {{ value {binding} }}", ""),
                               (colours + f"MaterialBinding {{ value {binding} }}", "materialIndex [0]"),
                               (f"VertexProperty {{ materialBinding {binding} orderedRGBA [0xff] }}", "")):
                self.check("a.iv", f"#Inventor V2.1 ascii\nSeparator {{ {faces.format(looks, own)} }}\n", "6/9")
        self.check("b.wrl", "#VRML V2.0 utf8\nShape { geometry IndexedFaceSet { coord Coordinate { point [0 0 0, 10 0 0, "
                   "10 10 0, 0 10 0, 20 0 0, 20 10 0] } coordIndex [0 1 2 3 -1 1 4 5 2 -1] colorPerVertex FALSE "
                   "color Color { color [1 0 0] } normalPerVertex FALSE normal Normal { vector [0 0 1] } "
                   "texCoord TextureCoordinate { point [0 0] } } }\n", "6/9")

    def test_a_3mf_with_pictures(self):
        for name in ("Metadata/thumbnail.png", "Metadata/plate.jpg", "3D/Textures/skin.PNG", "Metadata/notes.txt"):
            self.check("a.3mf", three_mf(' unit="millimeter"', [(name, png())]), "8/18")

    def test_what_is_broken_in_a_3mf_is_named(self):
        """The library crashes on most of these, or finds nothing in them."""
        def changed(old, new):
            return three_mf("", change=lambda name, content: content.replace(old, new))

        torn = bytearray(three_mf(""))
        place = torn.index(b"3D/3dmodel.model") + 60
        torn[place:place + 20] = bytes(byte ^ 255 for byte in torn[place:place + 20])
        packed = bytearray(three_mf(""))
        packed[packed.rindex(b"PK\1\2") + 10] = 12
        model = "its part '3D/3dmodel.model'"
        for content, said in (
                (three_mf("")[:-30], "its ZIP archive is damaged; fetch it again"),
                (three_mf("", without=("_rels/.rels",)), "its part '_rels/.rels' is missing here: the archive does not hold it"),
                (three_mf("", without=("3D/3dmodel.model",)), model + " is missing here"),
                (changed("/3D/3dmodel", "/3D/other"), "its part '3D/other.model' is missing here"),
                (three_mf("", change=lambda name, content: "" if name.endswith("del") else content), model + " is empty"),
                (bytes(torn), model + " cannot be unpacked"),
                (bytes(packed), model + " is packed by method 12, which is not read"),
                (changed("</mesh>", "</mash>"), model + ": line 3: </mash> stands where </mesh> should"),
                (changed('<item objectid="1"/>', ""), "its <build> places none of its objects"),
                (changed('x="10"', 'x="1,5"'), model + ": line 3: 'x' of vertex holds something else than it should"),
                (changed('v3="', 'w3="'), model + ": line 3: 'v3' of triangle holds something else than it should"),
                (changed('objectid="1"', 'objectid="7"'), "its <build> places none of its objects")):
            self.write("a.3mf", content)
            refusal = self.refused("inspect", "a.3mf")
            self.assertIn("a.3mf: " + said, refusal)
            self.assertIn("save it as OBJ, PLY or STL", refusal)

    def test_words_for_numbers_of_an_amf_are_refused(self):
        """The library reads them as 0."""
        def amf(x, v3):
            corners = "".join(f"<vertex><coordinates>\n<x>{a}</x><y>{b}</y><z>0</z></coordinates></vertex>"
                              for a, b in ((0, 0), (x, 0), (0, " 1e1\n")))
            return f"<amf><object id='0'><mesh><vertices>{corners}</vertices><volume>\n<triangle><v1>0</v1><v2>1</v2><v3>{v3}</v3>" \
                   "</triangle></volume></mesh></object></amf>"
        self.check("a.amf", amf("+10.5", 2), "3/3")
        self.write("a.amf", amf("one", 2))
        self.assertIn("a.amf: line 3: 'one' stands where a number should be; mend it", self.refused("inspect", "a.amf"))
        self.write("a.amf", amf("1", ""))
        self.assertIn("a.amf: line 6: '' stands where a number should be", self.refused("inspect", "a.amf"))

    def test_a_crash_is_the_readers(self):
        bad = self.write("worker.sh", "#!/bin/sh\nkill -SEGV $$\n")
        bad.chmod(0o755)
        self.write("a.bvh", BVH)
        done = self.run_program("inspect", "a.bvh", exit_code=1, environment={"ESM_IMPORT_WORKER": str(bad)})
        self.assertIn("the reader for this format failed", done.stderr)

    # === What is not used, and what nearly meets

    def test_inspect_and_import_agree_on_unused_points(self):
        self.write("a.obj", "v 0 0 0\nv 10 0 0\nv 0 10 0\nv 50 50 50\nv 60 60 60\nf 1 2 3\n")
        self.write("b.ply", "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                   "element face 1\nproperty list uchar int vertex_indices\nend_header\n9 9 9\n0 0 0\n1 0 0\n0 1 0\n3 1 2 3\n")
        self.write("c.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n9 9 9\n3 0 1 2\n")
        for name in ("a.obj", "b.ply", "c.off"):
            seen, made = self.json_of("inspect", name), self.json_of("import", name, "-o", "a.esm")
            self.assertEqual((seen["nodes"], seen["springs"]), (made["nodes"], made["springs"]), name)
            self.assertEqual((seen["nodes"], made["before"]["nodes"], seen["bbox_max"][2]), (3, 3, 0), name)
            self.assertGreater(seen["isolated_vertices"], 0)
            for notes in (seen["notes"], made["notes"]):
                self.assertIn("become no nodes", " ".join(notes))

    def test_a_seam_between_placed_copies_is_told(self):
        shutil.copy(SOURCE / "tests/data/meshes/seam_of_instances.glb", self.folder / "a.glb")
        counts, notes = self.inspect("a.glb")
        self.assertEqual(counts, "8/10")
        self.assertIn("2 vertices nearly meet others", notes)
        tolerance = notes.split("--weld-tolerance ")[1].split()[0]
        seen = self.json_of("inspect", "a.glb", "--weld-tolerance", tolerance)
        self.assertEqual((seen["nodes"], seen["springs"], seen["components"]), (6, 9, 1))
        self.assertNotIn("nearly meet", " ".join(seen["notes"]))
        # What is small on purpose is none: a fine sheet far away from the origin, in double precision.
        points = [(5e6 + 0.01 * i, 0.01 * j, 0) for i in range(4) for j in range(4)]
        faces = [(4 * i + j + 1, 4 * i + j + 5, 4 * i + j + 6, 4 * i + j + 2) for i in range(3) for j in range(3)]
        self.write("far.obj", "".join("v {!r} {!r} {!r}\n".format(*p) for p in points) +
                   "".join("f {} {} {} {}\n".format(*f) for f in faces))
        counts, notes = self.inspect("far.obj")
        self.assertEqual(counts, "16/33")
        self.assertNotIn("nearly", notes)
        self.write("box.obj", obj(""))
        self.assertEqual(self.json_of("inspect", "box.obj")["notes"], [])


if __name__ == "__main__":
    unittest.main()
