#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
"""`esm import` with every choice of a recipe, recipes as files, and `esm import --update`."""
import json
import os
import unittest

from program import ProgramTest

# A unit cube of six squares: 8 nodes; 12 edges, and 6 cuts through the squares.
CUBE = """v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 0 0 1
v 1 0 1
v 1 1 1
v 0 1 1
f 1 4 3 2
f 5 6 7 8
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 4 1 5 8
"""


def points_of(project):
    flat = project["geometry"]["position"]
    return [tuple(flat[i:i + 3]) for i in range(0, len(flat), 3)]


class Recipes(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("cube.obj", CUBE)

    def test_polygons_as_edges_only(self):
        self.assertEqual(self.json_of("import", "cube.obj", "-o", "a.esm")["springs"], 18)
        made = self.json_of("import", "cube.obj", "-o", "b.esm", "--polygons", "edges")
        self.assertEqual((made["nodes"], made["springs"], made["triangles"]), (8, 12, 12))
        self.assertNotIn("id", self.read_json("b.esm")["net"]["springs"])
        # A line along a cut is a spring all the same.
        self.write("strut.obj", CUBE + "l 1 3\nl 2 4\n")
        made = self.json_of("import", "strut.obj", "-o", "c.esm", "--polygons", "edges")
        self.assertEqual(made["springs"], 14)

    def test_polygons_of_foreign_formats_as_edges_only(self):
        # COLLADA keeps polygons, and goes through the worker.
        lines = CUBE.splitlines()
        places = " ".join(" ".join(line.split()[1:]) for line in lines if line.startswith("v"))
        corners = " ".join(str(int(c) - 1) for line in lines if line.startswith("f") for c in line.split()[1:])
        self.write("cube.dae", f"""<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset><up_axis>Z_UP</up_axis></asset>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="a" count="24">{places}</float_array><technique_common>
<accessor source="#a" count="8" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor>
</technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<polylist count="6"><input semantic="VERTEX" source="#v" offset="0"/><vcount>4 4 4 4 4 4</vcount><p>{corners}</p></polylist>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node><instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>
""")
        self.assertEqual(self.json_of("import", "cube.dae", "-o", "a.esm")["springs"], 18)
        made = self.json_of("import", "cube.dae", "-o", "b.esm", "--polygons", "edges")
        self.assertEqual((made["nodes"], made["springs"], made["triangles"]), (8, 12, 12))

    def test_inspect_shows_what_an_import_would_make(self):
        choices = ["cube.obj", "--unit", "cm", "--edge-length", "0.002", "--interior", "struts", "--body", "solid",
                   "--youngs-modulus", "20e3"]
        made = self.json_of("import", *choices, "-o", "a.esm")
        seen = self.json_of("inspect", *choices)
        for key in ("nodes", "springs", "triangles", "before", "after", "material", "cost", "notes"):
            self.assertEqual(seen[key], made[key], key)
        judged = self.json_of("inspect", *choices, "--quality")
        self.assertEqual(judged["springs"], made["springs"])
        self.assertEqual(self.json_of("inspect", "cube.obj", "--quality")["springs"], 18)
        self.assertIn("shortest", self.run_program("inspect", *choices).stdout)
        # Without choices it speaks of the file, in its own unit.
        self.assertEqual(self.json_of("inspect", "cube.obj")["bbox_max"], [1, 1, 1])

    def test_pressure_is_saved_and_kept_apart(self):
        self.run_program("import", "cube.obj", "--unit", "cm", "-o", "a.esm")
        self.assertNotIn("pressure", self.read_json("a.esm")["net"])
        self.run_program("import", "cube.obj", "--unit", "cm", "--bulk-modulus", "50e3", "-o", "b.esm")
        project = self.read_json("b.esm")
        body, = project["net"]["pressure"]
        self.assertEqual((body["bulk_modulus"], len(body["triangles"])), (50000, 36))
        self.assertEqual(project["source"]["support"], {"bulk_modulus": 50000})
        for name in ("net.xsp", "net.scn", "net.json"):
            self.assertIn("volume", self.run_program("export", "b.esm", "-o", name).stderr)
        self.run_program("import", "--update", "b.esm", "--bulk-modulus", "0")
        self.assertNotIn("pressure", self.read_json("b.esm")["net"])
        self.write("open.obj", "\n".join(CUBE.splitlines()[:-1]) + "\n")
        self.assertIn("closed", self.refused("import", "open.obj", "--bulk-modulus", "5e4", "-o", "c.esm"))

    def test_triangles_through_others_are_listed(self):
        self.write("cross.obj", "v 0 0 0\nv 2 0 0\nv 0 2 0\nv .5 .5 -1\nv .5 .5 1\nv 3 3 .2\nf 1 2 3\nf 4 5 6\n")
        for more in ([], ["--intersections"]):
            defects = self.json_of("inspect", "cross.obj", "--defects", *more)["defects"]
            self.assertEqual([pair["triangles"] for pair in defects["self_intersections"]], [[0, 1]])
            self.assertTrue(defects["self_intersections_complete"])
        self.assertIn("run through others: 1", self.run_program("inspect", "cross.obj", "--defects").stdout)

    def test_patient_axes_turn_and_do_not_mirror(self):
        self.run_program("import", "tet.obj", "-o", "ras.esm", "--patient-axes", "ras", "--unit", "mm")
        self.run_program("import", "tet.obj", "-o", "lps.esm", "--patient-axes", "lps", "--unit", "mm")
        ras, lps = (points_of(self.read_json(name)) for name in ("ras.esm", "lps.esm"))
        self.assertEqual(lps, [(-x if x else x, -y if y else y, z) for x, y, z in ras])

    def test_repair_and_remesh(self):
        self.write("broken.obj", CUBE + "v 9 9 9\nf 1 1 2\n")
        made = self.json_of("import", "broken.obj", "-o", "a.esm", "--remove-useless")
        self.assertEqual((made["before"]["isolated_vertices"], made["before"]["degenerate_faces"]), (1, 1))
        self.assertEqual(made["after"]["degenerate_faces"], 0)
        self.assertEqual(made["after"]["isolated_vertices"], 0)
        made = self.json_of("import", "cube.obj", "-o", "b.esm", "--edge-length", "0.2")
        self.assertGreater(made["after"]["triangles"], 100)

    def test_struts_are_added_and_cost_is_told(self):
        plain = self.json_of("import", "cube.obj", "-o", "p.esm", "--edge-length", "0.25")["cost"]
        held = self.json_of("import", "cube.obj", "-o", "q.esm", "--edge-length", "0.25", "--interior", "struts")["cost"]
        self.assertGreater(held["springs"], plain["springs"])
        self.assertGreater(plain["stable_step"], 0)
        self.assertGreater(plain["shortest_spring"], 0)

    # A cube of 1 cm with a wall of 2 mm has a cube of 6 mm inside; the choice is kept, and so is what was made.
    def test_a_wall_is_made_told_and_kept(self):
        made = self.run_program("import", "cube.obj", "--unit", "cm", "--edge-length", "0.0025", "--interior", "wall",
                                "--wall-thickness", "0.002", "--density", "1000", "-o", "w.esm")
        self.assertIn("The wall is 2 mm thick, of 1 layer of cells", made.stderr)
        project = self.read_json("w.esm")
        self.assertEqual(project["source"]["support"], {"interior": "wall", "wall_thickness": 0.002})
        mass = sum(project["net"]["nodes"]["mass"])
        self.assertAlmostEqual(mass / (1000 * (1e-6 - 0.6 ** 3 * 1e-6)), 1, delta=0.06)  # thinner in the corners
        springs = project["net"]["springs"]
        for kind in ("wall_edges", "wall_across", "wall_braces"):
            self.assertGreater(len(springs[kind]), 50, kind)
        self.run_program("import", "--update", "w.esm", "--wall-layers", "2")
        again = self.read_json("w.esm")
        self.assertGreater(len(again["net"]["springs"]["wall_across"]), 1.9 * len(springs["wall_across"]))
        self.assertIn("no room", self.refused("import", "cube.obj", "--unit", "cm", "--edge-length", "0.0025",
                                              "--interior", "wall", "--wall-thickness", "0.02", "-o", "x.esm"))

    def test_material_in_numbers(self):
        block = ["import", "cube.obj", "--unit", "cm", "--edge-length", "0.002", "--interior", "struts"]
        self.run_program(*block, "-o", "plain.esm")
        made = self.json_of(*block, "-o", "block.esm", "--body", "solid", "--density", "1020",
                            "--youngs-modulus", "20e3")
        self.assertNotEqual(made["material"]["modulus_scale"], 1)
        project = self.read_json("block.esm")
        self.assertEqual(project["source"]["material"], {"body": "solid", "density": 1020, "youngs_modulus": 20000})
        self.assertEqual(project["net"]["material"]["modulus_scale"], made["material"]["modulus_scale"])
        # A cube of 1 cm: the rules' inputs give the density within 1 %.
        self.assertAlmostEqual(sum(project["net"]["nodes"]["mass"]) / (1020 * made["material"]["volume"]), 1, delta=0.01)
        self.assertAlmostEqual(made["material"]["volume"], 1e-6, delta=1e-9)
        why = self.json_of("explain", "block.esm", "--region", "0")
        modulus = why["parameters"]["youngs_modulus"]
        self.assertAlmostEqual(modulus / 20e3, 1, delta=0.01)
        # Edits of the tissue after the import outlive an update, which asks for the fit again.
        inputs = self.read_json("block.esm")["inputs"]
        self.assertNotEqual(inputs, self.read_json("plain.esm")["inputs"])
        self.run_program("import", "--update", "block.esm", "--thickness", "0.001")
        updated = self.read_json("block.esm")
        self.assertEqual((updated["tissue"]["thickness"], updated["inputs"]), (0.001, inputs))
        self.assertIn("nearest", self.refused(*block, "-o", "steel.esm", "--youngs-modulus", "2e11"))

    def test_recipe_file_gives_the_same_project(self):
        choices = ["--unit", "inch", "--up", "y", "--weld-tolerance", "0.01", "--polygons", "edges",
                   "--unify-orientation", "--drop-parts-share", "0.5", "--anchors", "part", "--anchor-part",
                   "0,0,0,0.02,0.02,0.02"]
        self.run_program("import", "cube.obj", "-o", "a.esm", *choices, "--save-recipe", "r.json")
        self.run_program("import", "cube.obj", "-o", "b.esm", "--recipe", "r.json")
        self.run_program("import", "cube.obj", "-o", "c.esm", "--recipe", "a.esm", "--name", "cube")
        first = (self.folder / "a.esm").read_bytes()
        self.assertEqual((self.folder / "b.esm").read_bytes(), first)
        self.assertEqual((self.folder / "c.esm").read_bytes(), first)
        recipe = self.read_json("r.json")
        self.assertEqual(recipe["format"], "esm-recipe-1")
        self.assertEqual((recipe["unit"], recipe["polygons"]), ("inch", "edges"))
        self.assertNotIn("file", recipe)
        # A flag goes over the recipe.
        self.run_program("import", "cube.obj", "-o", "d.esm", "--recipe", "r.json", "--unit", "mm")
        self.assertEqual(self.read_json("d.esm")["source"]["unit"], "mm")

    def test_names_are_relative_to_the_project(self):
        (self.folder / "meshes").mkdir()
        (self.folder / "out" / "deep").mkdir(parents=True)
        self.write("meshes/cube.obj", CUBE)
        self.run_program("import", "meshes/cube.obj", "-o", "out/p.esm")
        self.assertEqual(self.read_json("out/p.esm")["source"]["file"], "../meshes/cube.obj")
        self.run_program("apply", "out/p.esm", "-o", "out/deep/q.esm", "--set", "hardness=0.7")
        self.assertEqual(self.read_json("out/deep/q.esm")["source"]["file"], "../../meshes/cube.obj")

    def test_wrong_choices_are_one_line(self):
        self.write("r.json", json.dumps({"format": "esm-recipe-1", "unit": "mile"}))
        self.assertIn("/unit", self.refused("import", "cube.obj", "-o", "p.esm", "--recipe", "r.json"))
        self.write("r.json", json.dumps({"format": "esm-recipe-1", "repair": {"polish": True}}))
        self.assertIn("polish", self.refused("import", "cube.obj", "-o", "p.esm", "--recipe", "r.json"))
        self.assertIn("absent.json", self.refused("import", "cube.obj", "-o", "p.esm", "--recipe", "absent.json"))
        self.assertIn("not for both", self.refused("import", "cube.obj", "-o", "p.esm", "--triangles", "100",
                                                   "--edge-length", "0.1"))
        for wrong in (["--triangles", "-3"], ["--triangles", "many"], ["--interior", "wool"],
                      ["--anchor-part", "0,0,0,1,1,0"], ["--edge-length", "0,1"], ["--unit", "mile"]):
            self.refused("import", "cube.obj", "-o", "p.esm", *wrong, exit_code=2)
        self.assertFalse((self.folder / "p.esm").exists())


class Updates(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("cube.obj", CUBE)
        self.run_program("import", "cube.obj", "-o", "p.esm", "--unit", "cm")
        self.run_program("apply", "p.esm", "-o", "p.esm", "--set", "hardness=0.7", "--fix-box",
                         "-1,-1,-0.001,1,1,0.001", "--poke", "0,0,0.01,0,0,-0.5,0.001",
                         "--region", "0,0,0,0.01,0.01,0.01", "--set", "hardness=0.2")

    def test_unchanged_files_change_nothing(self):
        before = (self.folder / "p.esm").read_bytes()
        told = self.json_of("import", "--update", "p.esm")
        self.assertEqual((told["changed"], told["unchanged_nodes"]), (False, 8))
        self.assertEqual((self.folder / "p.esm").read_bytes(), before)

    def test_a_moved_vertex_keeps_all(self):
        old = self.read_json("p.esm")
        self.write("cube.obj", CUBE.replace("v 1 1 1\n", "v 1 1 1.5\n"))
        told = self.json_of("import", "--update", "p.esm")
        self.assertEqual((told["unchanged_nodes"], told["new_nodes"], told["gone_nodes"]), (8, 0, 0))
        self.assertEqual(told["notes"], [])
        new = self.read_json("p.esm")
        for block in ("rule_base", "inputs", "regions", "tissue", "loads", "simulation", "view"):
            self.assertEqual(new[block], old[block], block)
        self.assertEqual(new["net"]["nodes"]["fixed"], old["net"]["nodes"]["fixed"])
        self.assertEqual(points_of(new)[6], (0.01, 0.01, 0.015))
        self.assertNotEqual(new["source"]["fingerprint"], old["source"]["fingerprint"])
        self.assertEqual(self.json_of("import", "--update", "p.esm")["changed"], False)

    def test_new_and_gone_vertices_are_told(self):
        # The poked corner (vertex 5) is cut away, a new one comes first in the file: all numbers move.
        changed = "v 0.5 0.5 2\n" + CUBE.replace("v 0 0 1\n", "v 0.1 0.1 1.1\n")
        changed = "\n".join(" ".join([line[0]] + [str(int(n) + 1) for n in line.split()[1:]])
                            if line.startswith("f") else line for line in changed.splitlines())
        self.write("cube.obj", changed + "\nf 7 8 1\n")
        told = self.json_of("import", "--update", "p.esm")
        self.assertEqual((told["unchanged_nodes"], told["new_nodes"], told["gone_nodes"]), (7, 2, 1))
        self.assertEqual(told["notes"], ["force 1 is left out: none of its nodes is there any more"])
        project = self.read_json("p.esm")
        points, fixed = points_of(project), project["net"]["nodes"]["fixed"]
        self.assertEqual({points[node] for node in fixed},
                         {(0, 0, 0), (0.01, 0, 0), (0.01, 0.01, 0), (0, 0.01, 0)})
        ids = project["net"]["nodes"]["id"]
        self.assertEqual(ids[1:5], [0, 1, 2, 3])
        self.assertEqual(sorted(ids)[-2:], [8, 9])
        self.assertEqual(project["loads"]["forces"], [])
        self.run_program("validate", "p.esm")

    def test_failure_leaves_the_project(self):
        before = (self.folder / "p.esm").read_bytes()
        self.write("cube.obj", CUBE.replace("f 5 6 7 8", "f 5 6 7 88"))
        self.assertIn("cube.obj", self.refused("import", "--update", "p.esm"))
        os.remove(self.folder / "cube.obj")
        self.assertIn("cube.obj", self.refused("import", "--update", "p.esm"))
        self.assertEqual((self.folder / "p.esm").read_bytes(), before)

    def test_choices_change_the_recipe(self):
        told = self.json_of("import", "--update", "p.esm", "--polygons", "edges", "-o", "q.esm")
        self.assertEqual((told["springs"], told["unchanged_nodes"]), (12, 8))
        self.assertEqual(self.read_json("q.esm")["source"]["polygons"], "edges")
        self.assertEqual(len(self.read_json("p.esm")["net"]["springs"]["ends"]), 36)

    def test_another_file_in_its_place(self):
        self.write("next.obj", CUBE.replace("v 1 1 1\n", "v 1 1 2\n"))
        self.run_program("import", "next.obj", "--update", "p.esm")
        self.assertEqual(self.read_json("p.esm")["source"]["file"], "next.obj")

    def test_nets_of_their_own_have_no_recipe(self):
        self.run_program("import", "osc.json", "-o", "osc.esm")
        self.assertIn("did not come from mesh files", self.refused("import", "--update", "osc.esm"))

    def test_usage(self):
        self.refused("import", "-o", "x.esm", exit_code=2)
        self.refused("import", "cube.obj", exit_code=2)
        self.refused("import", "--update", "p.esm", "--name", "x", exit_code=2)


class Xsp(ProgramTest):
    def test_both_ways(self):
        self.run_program("import", "tet.obj", "-o", "p.esm", "--unit", "cm")
        self.run_program("apply", "p.esm", "-o", "p.esm", "--fix-box", "-1,-1,-1,1,1,0.001", "--gravity", "0,0,-9.81")
        done = self.run_program("export", "p.esm", "-o", "net.xsp")
        self.assertIn("anchors", done.stderr)
        self.run_program("import", "net.xsp", "-o", "q.esm")
        before, after = self.read_json("p.esm"), self.read_json("q.esm")
        self.assertEqual(after["geometry"]["position"], before["geometry"]["position"])
        for key in ("ends", "rest_length", "stiffness", "viscosity"):
            self.assertEqual(after["net"]["springs"][key], before["net"]["springs"][key], key)
        for key in ("mass", "fixed"):
            self.assertEqual(after["net"]["nodes"][key], before["net"]["nodes"][key], key)
        self.assertEqual(after["loads"]["gravity"], [0, 0, -9.81])
        self.assertFalse(after["tissue"]["parameters_from_tissue"])
        # It is known by its content, and the bytes of a second way out are the same.
        os.rename(self.folder / "net.xsp", self.folder / "net.txt")
        self.run_program("export", "net.txt", "-o", "again.xsp")
        self.assertEqual((self.folder / "again.xsp").read_text().replace(" v ", " s "),
                         (self.folder / "net.txt").read_text().replace(" v ", " s "))

    def test_as_others_write_it(self):
        self.write("chain.xsp", "Xsp 3.0\n# a chain\nnumm 3\nnums 2\ngrav 0 -9.81 0\nvisc 0.5\n"
                                "mass 1 v 0 0 0 0 0 0 -1 0\nmass 2 v 2 0 0 0 1 0 0.5 0\nmass 3 s 4 0 0 0 0 0 1 0\n"
                                "lspg 1 1 2 100 1 -1\nlspg 2 2 3 10 0.1 1.5\nstep 0.01\n")
        done = self.run_program("import", "chain.xsp", "-o", "p.esm")
        self.assertIn("visc", done.stderr)
        net = self.read_json("p.esm")["net"]
        self.assertEqual(net["springs"]["stiffness"], [50, 10])
        self.assertEqual(net["springs"]["viscosity"], [0.5, 0.1])
        self.assertEqual(net["springs"]["rest_length"], [2, 1.5])
        self.assertEqual((net["nodes"]["fixed"], net["nodes"]["mass"]), ([0], [1, 0.5, 1]))
        self.assertEqual(net["nodes"]["velocity"][3:6], [0, 1, 0])

    def test_bad_files_are_one_line(self):
        head = "Xsp 3.0\nmass 1 v 0 0 0 0 0 0 1 0\nmass 2 v 1 0 0 0 0 0 1 0\n"
        for text, words in (("Xsp 4.0\n", "version 3.0"), (head + "lspg 1 1 9 1 0 1\n", "line 4"),
                            (head + "lspg 1 1 1 1 0 1\n", "line 4"), (head + "spring 1 2\n", "line 4"),
                            (head + "lspg 1 1 2 nan 0 1\n", "line 4"), (head, "no spring"),
                            ("Xsp 3.0\nmass 1 v 0 0 0 0 0 0 0 0\n", "line 2"), ("Xsp 3.0\nmass 1 v 0", "line 2")):
            self.write("bad.xsp", text)
            self.assertIn(words, self.refused("import", "bad.xsp", "-o", "p.esm"))


if __name__ == "__main__":
    unittest.main()
