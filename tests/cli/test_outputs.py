#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
"""What `esm` writes for other programs, read back by independent readers (readers.py)."""
import base64
import json
import struct
import unittest
import xml.etree.ElementTree as xml

from program import OSCILLATOR, ProgramTest
from readers import read_csv, read_f64, read_glb, read_ply, read_pvd, read_vtu


class Exports(ProgramTest):
    def setUp(self):
        super().setUp()
        self.run_program("import", "tet.obj", "-o", "p.esm", "--unit", "cm")
        self.project = self.read_json("p.esm")
        flat = self.project["geometry"]["position"]
        self.points = [tuple(flat[i:i + 3]) for i in range(0, len(flat), 3)]
        ends = self.project["net"]["springs"]["ends"]
        self.ends = [(ends[i], ends[i + 1]) for i in range(0, len(ends), 2)]
        self.stiffness = self.project["net"]["springs"]["stiffness"]

    def export(self, name):
        self.run_program("export", "p.esm", "-o", name)
        return self.folder / name

    def check_vtu(self, grid):
        self.assertEqual((grid["point_count"], grid["cell_count"]), (len(grid["points"]), len(grid["cells"])))
        self.assertEqual((len(grid["points"]), len(grid["cells"])), (5, 12))
        for name in ("stiffness", "damping", "rest_length", "strain", "force"):
            self.assertEqual(len(grid["cell_data"][name]), 12, name)
        for name in ("displacement", "velocity", "mass", "fixed"):
            self.assertEqual(len(grid["point_data"][name]), 5, name)

    def test_vtu(self):
        grid = read_vtu(self.export("x.vtu"))
        self.check_vtu(grid)
        self.assertEqual(grid["points"], self.points)
        self.assertEqual([tuple(n) for kind, n in grid["cells"] if kind == 3], self.ends)
        self.assertEqual([n for kind, n in grid["cells"] if kind == 5], [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])
        self.assertEqual(grid["cell_data"]["stiffness"][:8], self.stiffness)

    def test_ply_holds_springs_with_their_parameters(self):
        tables = read_ply(self.export("x.ply"))
        self.assertEqual([(v["x"], v["y"], v["z"]) for v in tables["vertex"]], self.points)
        self.assertEqual([(e["vertex1"], e["vertex2"]) for e in tables["edge"]], self.ends)
        self.assertEqual([e["stiffness"] for e in tables["edge"]], self.stiffness)
        self.assertEqual(len(tables["face"]), 4)

    def test_sofa_scene(self):
        """As SOFA's own XML reader sees it: every number, by the standard library."""
        self.run_program("apply", "p.esm", "-o", "p.esm", "--fix-box", "-1,-1,-1,1,1,0.001", "--gravity", "0,0,-9.81")
        self.project = self.read_json("p.esm")
        done = self.run_program("export", "p.esm", "-o", "x.scn")
        for lost in ("anchors", "nonlinear spring laws"):
            self.assertIn(lost, done.stderr)
        root = xml.parse(self.folder / "x.scn").getroot()
        self.assertEqual((root.tag, root.attrib["gravity"]), ("Node", "0 0 -9.81"))
        plugins = {element.attrib["name"] for element in root.iter("RequiredPlugin")}
        self.assertTrue(all(name.startswith("Sofa.Component.") for name in plugins))
        net = root.find("Node")
        self.assertEqual([element.tag for element in net],
                         ["EulerImplicitSolver", "CGLinearSolver", "MeshTopology", "MechanicalObject", "DiagonalMass",
                          "FixedProjectiveConstraint", "SpringForceField"])

        def numbers(element, attribute, kind=float):
            return [kind(word) for word in net.find(element).attrib[attribute].split()]

        springs, stored = numbers("SpringForceField", "spring"), self.project["net"]["springs"]
        self.assertEqual(len(springs), 5 * len(self.ends))
        self.assertEqual([(int(a), int(b)) for a, b in zip(springs[0::5], springs[1::5])], self.ends)
        for column, key in ((2, "stiffness"), (3, "viscosity"), (4, "rest_length")):
            self.assertEqual(springs[column::5], stored[key], key)
        for element in ("MeshTopology", "MechanicalObject"):
            self.assertEqual(numbers(element, "position"), self.project["geometry"]["position"])
        self.assertEqual(numbers("MeshTopology", "edges", int), stored["ends"])
        self.assertEqual(numbers("MeshTopology", "triangles", int), self.project["geometry"]["triangles"])
        self.assertEqual(numbers("DiagonalMass", "vertexMass"), self.project["net"]["nodes"]["mass"])
        self.assertEqual(numbers("FixedProjectiveConstraint", "indices", int), self.project["net"]["nodes"]["fixed"])

    def test_gltf_is_the_glb_as_text(self):
        document, values = read_glb(self.export("x.glb"))
        text = json.loads(self.export("x.gltf").read_text())
        start = "data:application/octet-stream;base64,"
        uri = text["buffers"][0].pop("uri")
        self.assertTrue(uri.startswith(start))
        self.assertEqual(text, document)
        data = base64.b64decode(uri[len(start):], validate=True)
        self.assertEqual(len(data), text["buffers"][0]["byteLength"])
        accessor = text["accessors"][text["meshes"][0]["primitives"][0]["attributes"]["POSITION"]]
        view = text["bufferViews"][accessor["bufferView"]]
        begin = view["byteOffset"]
        points = list(struct.iter_unpack("<3f", data[begin:begin + view["byteLength"]]))
        self.assertEqual(points, values[0])

    def test_both_gltf_forms_come_back(self):
        for name in ("x.glb", "x.gltf"):
            self.export(name)
            back = self.json_of("inspect", name)
            self.assertEqual((back["nodes"], back["springs"], back["triangles"]), (5, 8, 4), name)
            self.assertAlmostEqual(back["bbox_max"][1], 0.1, places=6)  # glTF is y up

    def test_glb(self):
        document, values = read_glb(self.export("x.glb"))
        primitives = {p["mode"]: p for p in document["meshes"][0]["primitives"]}
        position = primitives[4]["attributes"]["POSITION"]
        accessor = document["accessors"][position]
        for axis in range(3):
            column = [p[axis] for p in values[position]]
            self.assertEqual((accessor["min"][axis], accessor["max"][axis]), (min(column), max(column)))
        single = [struct.unpack("<3f", struct.pack("<3f", *p)) for p in self.points]
        self.assertEqual(values[position], single)
        self.assertEqual(len(values[primitives[4]["indices"]]), 12)
        self.assertEqual(values[primitives[1]["indices"]], [node for ends in self.ends for node in ends])

    def test_csv(self):
        nodes, springs = read_csv(self.export("x.csv")), read_csv(self.folder / "x_springs.csv")
        self.assertEqual([(float(r["x"]), float(r["y"]), float(r["z"])) for r in nodes], self.points)
        self.assertEqual([float(r["stiffness"]) for r in springs], self.stiffness)
        self.assertEqual([(int(r["a"]), int(r["b"])) for r in springs], self.ends)

    def test_reimport_gives_the_same_shape(self):
        before = self.json_of("inspect", "tet.obj")
        for name in ("x.obj", "x.ply"):
            after = self.json_of("inspect", self.export(name))
            for key in ("nodes", "springs", "triangles", "components", "boundary_edges"):
                self.assertEqual(after[key], before[key], (name, key))
            self.assertEqual(after["bbox_max"], [0.1, 0.1, 0.1])

    def test_plain_net_round_trip(self):
        self.run_program("import", "osc.json", "-o", "o.esm")
        self.run_program("export", "o.esm", "-o", "back.json")
        back = self.read_json("back.json")
        self.assertEqual({key: back[key] for key in OSCILLATOR}, OSCILLATOR)
        self.run_program("import", "back.json", "-o", "again.esm")
        self.assertEqual((self.folder / "o.esm").read_bytes(), (self.folder / "again.esm").read_bytes())

    def test_paraview_series(self):
        self.run_program("apply", "p.esm", "-o", "q.esm", "--poke", "0,0,0.1,0,0,-0.05,0.05")
        self.run_program("simulate", "q.esm", "--duration", "0.2", "--frames", "20", "-o", "m.pvd")
        frames = read_pvd(self.folder / "m.pvd")
        self.assertEqual([time for time, _ in frames], [k / 20 for k in range(5)])
        for time, path in frames:
            grid = read_vtu(path)
            self.check_vtu(grid)
            self.assertEqual(grid["time"], time)
            for point, start, moved in zip(grid["points"], self.points, grid["point_data"]["displacement"]):
                for axis in range(3):  # one rounding
                    self.assertAlmostEqual(point[axis], start[axis] + moved[axis], delta=1e-15)
        self.assertLess(grid["point_data"]["displacement"][3][2], 0)
        self.assertEqual(len(list((self.folder / "m_frames").iterdir())), 5)

    def test_an_empty_name_is_refused_by_every_output(self):
        for command, options in (("import tet.obj", "-o --save-recipe"), ("export p.esm", "-o"), ("apply p.esm", "-o"),
                                 ("simulate p.esm", "-o --report --force-curve --mesh --log"),
                                 ("learn p.esm", "-o --report"), ("replay-log r.esmlog", "--project"),
                                 ("fuzzy eval p.esm", "-o"), ("haptics record", "-o")):
            for option in options.split():
                self.assertIn("an empty text is given", self.refused(*command.split(), option, "", exit_code=2), (command, option))
        self.assertIn("an empty text is given", self.refused("inspect", "", exit_code=2))

    def test_raw_and_csv_hold_the_same_numbers(self):
        self.run_program("simulate", "osc.json", "-o", "m.f64")
        self.run_program("simulate", "osc.json", "-o", "m.csv")
        frames, rows = read_f64(self.folder / "m.f64", 2), read_csv(self.folder / "m.csv")
        self.assertEqual(len(frames), 51)
        self.assertEqual(frames[0], [(0, 0, 0), (1.1, 0, 0)])
        self.assertEqual([point for frame in frames for point in frame],
                         [(float(r["x"]), float(r["y"]), float(r["z"])) for r in rows])
        self.assertNotIn(b"\r", (self.folder / "m.csv").read_bytes())


if __name__ == "__main__":
    unittest.main()
