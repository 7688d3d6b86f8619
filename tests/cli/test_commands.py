#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
"""The commands of `esm`: exit codes, the JSON line, one line per fault, and what the arguments do."""
import json
import math
import os
import signal
import subprocess
import sys
import time
import unittest

from program import PROGRAM, SOURCE, ProgramTest

INSPECT_KEYS = ("nodes springs triangles components isolated_vertices boundary_edges nonmanifold_edges "
                "degenerate_faces duplicate_faces nonfinite_vertices bbox_min bbox_max finite sum_rest_length").split()
REPORT_KEYS = ("integration_seconds steps rejected_steps springs_evaluated factorizations nodes_awake "
               "mean_nodes_awake tolerance_given_up solver reason energy largest_force finite").split()


class Usage(ProgramTest):
    def test_help_and_version_are_done(self):
        self.assertRegex(self.run_program("--version").stdout, r"^esm \d+\.\d+\.\d+\n$")
        self.assertIn("Examples:", self.run_program("--help").stdout)
        for command in "inspect import info validate apply explain simulate export solvers".split():
            self.assertIn("Usage", self.run_program(command, "--help").stdout)

    def test_wrong_usage_is_2_and_one_line(self):
        for arguments in (["dance"], [], ["inspect"], ["inspect", "tet.obj", "--frobnicate"],
                          ["inspect", "tet.obj", "--weld-tolerance", "-1"],
                          ["inspect", "tet.obj", "--weld-tolerance", "0,5"], ["import", "tet.obj"],
                          ["import", "tet.obj", "-o", "p.esm", "--unit", "mile"],
                          ["simulate", "osc.json", "--duration", "1,5"],
                          ["simulate", "osc.json", "--frames", "0"], ["simulate", "osc.json", "--solver", "magic"],
                          ["simulate", "osc.json", "--threads", "1.5"],
                          ["apply", "osc.json", "-o", "q.esm", "--set", "hardness"],
                          ["apply", "osc.json", "-o", "q.esm", "--region", "0,0,0,1,1"],
                          ["apply", "osc.json", "-o", "q.esm", "--region", "0,0,0,1,1,0"]):
            with self.subTest(arguments):
                self.refused(*arguments, exit_code=2)
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["osc.json", "tet.obj"])


class Inspect(ProgramTest):
    def test_report_is_in_the_units_of_the_file(self):
        report = self.json_of("inspect", "tet.obj")
        self.assertLessEqual(set(INSPECT_KEYS), set(report))
        self.assertEqual((report["nodes"], report["springs"], report["triangles"]), (5, 8, 4))
        self.assertEqual(report["components"], 1)
        self.assertEqual(report["bbox_max"], [10, 10, 10])
        edges = 3 * 10 + 3 * math.sqrt(200) + math.sqrt(27) + math.sqrt(49 + 9 + 9)
        self.assertAlmostEqual(report["sum_rest_length"], edges, places=12)
        self.assertIs(report["finite"], True)

    def test_quality_says_whether_the_net_carries_load(self):
        # A tetrahedron is rigid; four struts around one node in a plane are not.
        self.write("rigid.obj", "v 0 0 0\nv 10 0 0\nv 0 10 0\nv 0 0 10\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n")
        self.write("flat.obj", "v 0 0 0\nv 10 0 0\nv 10 10 0\nv 0 10 0\nf 1 2 3\nf 1 3 4\n")
        rigid = self.json_of("inspect", "rigid.obj", "--quality")
        self.assertEqual((rigid["nodes"], rigid["springs"], rigid["mechanisms"]), (4, 6, 0))
        self.assertGreater(rigid["stable_step"], 0)
        flat = self.json_of("inspect", "flat.obj", "--quality")
        self.assertIs(flat["carries_load"], False)
        self.assertEqual(flat["mechanisms"], 1)  # it folds along its diagonal
        kinds = {finding["kind"]: finding for finding in flat["findings"]}
        self.assertEqual(sorted(kinds["flat_nodes"]["nodes"]), ["0", "1", "2", "3"])
        self.assertIn("Add interior struts", kinds["nothing_inside"]["text"])
        self.run_program("import", "rigid.obj", "-o", "rigid.esm")
        self.assertIn("findings", self.json_of("inspect", "rigid.esm", "--quality"))

    def test_bad_meshes_are_named_in_one_line(self):
        self.write("empty.obj", "")
        self.write("short.stl", b"\0" * 90)
        for name in ("empty.obj", "short.stl", "absent.obj"):
            self.assertIn(name, self.refused("inspect", name))


class Import(ProgramTest):
    def test_units_axes_and_recipe(self):
        self.run_program("import", "tet.obj", "-o", "p.esm", "--unit", "mm", "--up", "y")
        project = self.read_json("p.esm")
        self.assertRegex(project["source"].pop("fingerprint"), "^[0-9a-f]{1,16}$")
        self.assertEqual(project["source"], {"file": "tet.obj", "unit": "mm", "up": "y", "weld_tolerance": 0})
        position = project["geometry"]["position"]
        for got, wanted in zip(position[6:12], [0, 0, 0.01, 0, -0.01, 0]):  # (x, y, z) -> (x, -z, y)
            self.assertAlmostEqual(got, wanted, places=15)
        self.assertEqual(project["net"]["springs"]["lines"], [6, 7])
        self.assertTrue(project["tissue"]["parameters_from_tissue"])

    def test_several_meshes_are_joined_where_they_touch(self):
        self.write("strut.obj", "v 3 3 3\nv 0 10 0\nl 1 2\n")
        made = self.json_of("import", "tet.obj", "strut.obj", "-o", "p.esm")
        self.assertEqual((made["nodes"], made["springs"]), (5, 9))

    def test_plain_net_is_known_by_content_and_keeps_its_numbers(self):
        (self.folder / "osc.json").rename(self.folder / "net.obj")
        made = self.json_of("import", "net.obj", "-o", "p.esm")
        self.assertIs(made["parameters_from_tissue"], False)
        self.assertEqual(self.read_json("p.esm")["net"]["springs"]["stiffness"], 100)

    def test_rules_from_text_and_from_a_project(self):
        self.write("rules.txt", "# all the same\nIF hardness IS soft OR NOT hardness IS soft "
                                "THEN youngs_modulus IS high\n")
        self.run_program("import", "tet.obj", "-o", "a.esm", "--rules", "rules.txt")
        self.run_program("import", "tet.obj", "-o", "b.esm", "--rules", "a.esm")
        self.assertEqual(len(self.read_json("a.esm")["rule_base"]["rules"]), 1)
        self.assertEqual(self.read_json("a.esm")["rule_base"], self.read_json("b.esm")["rule_base"])
        self.write("wrong.txt", "\nIF hardness IS mellow THEN youngs_modulus IS high\n")
        line = self.refused("import", "tet.obj", "-o", "c.esm", "--rules", "wrong.txt")
        self.assertIn("wrong.txt:2: ", line)
        self.assertIn("mellow", line)

    def test_cbor_holds_the_same(self):
        self.run_program("import", "tet.obj", "-o", "p.esm")
        self.run_program("export", "p.esm", "-o", "p.esmb")
        self.run_program("export", "p.esmb", "-o", "q.esm")
        self.assertEqual((self.folder / "p.esm").read_bytes(), (self.folder / "q.esm").read_bytes())


class Apply(ProgramTest):
    def setUp(self):
        super().setUp()
        self.run_program("import", "tet.obj", "-o", "p.esm", "--unit", "cm")

    def apply(self, *arguments):
        self.run_program("apply", "p.esm", "-o", "q.esm", *arguments)
        return self.read_json("q.esm")

    def test_harder_input_makes_stiffer_springs(self):
        soft = self.apply("--set", "hardness=0.2")["net"]["springs"]["stiffness"]
        hard = self.apply("--set", "hardness=0.8")["net"]["springs"]["stiffness"]
        word = self.apply("--set", "HÄRTE=sehr hart")
        self.assertTrue(all(a < b for a, b in zip(soft, hard)))
        self.assertEqual(word["inputs"]["hardness"], {"term": "hard", "hedges": ["very"]})

    def test_whose_value_a_set_gives(self):
        near, far = "0,0,0,0.02,0.02,0.02", "1,1,1,0.1,0.1,0.1"
        project = self.apply("--set", "hardness=0.7", "--region", near, "--set", "hardness=0.1", "--region", far,
                             "--set", "elasticity=0.9")
        self.assertEqual(project["inputs"]["hardness"], 0.7)
        first, second = project["regions"]
        self.assertEqual(first["inputs"], project["inputs"] | {"hardness": 0.1})
        self.assertEqual(second["inputs"], project["inputs"] | {"elasticity": 0.9})

        project = self.apply("--set", "hardness=0.1", "--region", near)  # nothing of its own after it
        self.assertEqual(project["inputs"]["hardness"], 0.5)
        self.assertEqual(project["regions"][0]["inputs"]["hardness"], 0.1)

    def test_region_geometry_and_falloff(self):
        region = self.apply("--falloff", "0.5", "--region", "-0.001,2e-3,0,0.01,0.02,0.03", "--set", "hardness=1",
                            "--region", "0,0,0,1,1,1", "--falloff", "0")["regions"]
        self.assertEqual(region[0]["centre"], [-0.001, 0.002, 0])
        self.assertEqual(region[0]["semi_axes"], [0.01, 0.02, 0.03])
        self.assertEqual((region[0]["falloff"], region[1]["falloff"]), (0.5, 0))

    def test_rule_is_added(self):
        rules = self.apply("--rule", "WENN Härte IST hart DANN Steifigkeit IST hoch")["rule_base"]["rules"]
        self.assertEqual(rules[-1]["if"], [{"variable": "hardness", "term": "hard"}])
        self.assertIn("mellow", self.refused("apply", "p.esm", "-o", "x.esm", "--rule",
                                             "IF hardness IS mellow THEN youngs_modulus IS high"))

    def test_loads(self):
        project = self.apply("--fix-box", "-1,-1,-1,1,1,0.001", "--poke", "0,0,0.1,0,0,-2,0.09,0.5",
                             "--gravity", "0,0,-9.81")
        self.assertEqual(project["net"]["nodes"]["fixed"], [0, 1, 2])
        force, = project["loads"]["forces"]
        self.assertEqual(force["nodes"], [3, 4])
        self.assertEqual(max(abs(f[2]) for f in force["force"]), 1)  # 2 N shared by two nodes
        self.assertEqual((force["force"][0], force["force"][-1]), ([0, 0, 0], [0, 0, 0]))
        self.assertAlmostEqual(force["time"][-1], 0.6)
        self.assertEqual(project["loads"]["gravity"], [0, 0, -9.81])
        self.run_program("apply", "q.esm", "-o", "r.esm", "--clear-loads")
        self.assertEqual(self.read_json("r.esm")["loads"], {"gravity": [0, 0, 0], "forces": [], "motions": []})
        self.assertIn("nearest is", self.refused("apply", "p.esm", "-o", "x.esm", "--poke", "9,9,9,0,0,1,0.1"))

    def test_own_numbers_stay_until_somebody_speaks_of_tissue(self):
        self.run_program("apply", "osc.json", "-o", "q.esm", "--gravity", "0,0,-1")
        project = self.read_json("q.esm")
        self.assertFalse(project["tissue"]["parameters_from_tissue"])
        self.assertEqual(project["net"]["springs"]["stiffness"], 100)

    def test_unknown_input_is_named(self):
        line = self.refused("apply", "p.esm", "-o", "x.esm", "--set", "colour=red")
        self.assertIn('"colour"', line)
        self.assertIn("hardness", line)


class Simulate(ProgramTest):
    def test_report_and_closed_form(self):
        made = self.json_of("simulate", "osc.json", "--duration", "2", "--frames", "25", "--tolerance", "1e-4", "-o",
                            "m.csv", "--report", "r.json")
        self.assertEqual(made, self.read_json("r.json"))
        self.assertLessEqual(set(REPORT_KEYS), set(made))
        self.assertEqual(made["frames"], 51)
        self.assertIs(made["finite"], True)
        self.assertGreater(made["integration_seconds"], 0)
        turn = 10 * 2 / made["steps"]  # radians per step: velocity Verlet's energy swings by a quarter of its square
        self.assertAlmostEqual(made["energy"], 0.5, delta=1e-4 + 0.5 * turn**2 / 4)  # k/2 x^2
        exact = self.json_of("simulate", "osc.json", "--duration", "2", "--frames", "25", "--tolerance", "1e-5")
        self.assertAlmostEqual(exact["energy"], 0.5, delta=1e-4)
        lines = (self.folder / "m.csv").read_text().splitlines()
        self.assertEqual(lines[:3], ["t,id,x,y,z", "0,0,0,0,0", "0,1,1.1,0,0"])
        self.assertEqual(len(lines), 1 + 51 * 2)
        for line in lines[1:]:
            time, node, x = [float(word) for word in line.split(",")[:3]]
            if node == 1:  # the amplitude is 0.1 m; ten times the tolerance, for one frame is no average
                self.assertAlmostEqual(x, 1 + 0.1 * math.cos(10 * time), delta=1e-4)

    def test_defaults_are_those_of_the_file(self):
        self.assertEqual(self.json_of("simulate", "osc.json")["frames"], 51)
        self.assertEqual(self.json_of("simulate", "osc.json", "--duration", "0")["frames"], 1)

    def test_every_solver_is_taken(self):
        solvers = self.json_of("solvers")
        self.assertLessEqual(set("leapfrog chebyshev stoermer3 verlet stoermer rk4 dopri5 implicit lie multirate wavefront relax".split()),
                             set(solvers))
        listed = self.run_program("solvers").stdout.splitlines()
        self.assertEqual([line.split(maxsplit=1) for line in listed], [list(pair) for pair in solvers.items()])
        for solver in solvers:
            self.assertEqual(self.json_of("simulate", "osc.json", "--duration", "0.1", "--accept-rough", "--solver",
                                          solver)["solver"],
                             solver)

    def test_failed_numerics_are_3_and_what_was_computed_is_written(self):
        # 1e308 N/m on 1 kg overflows in the first force.
        self.write("stiff.json", (self.folder / "osc.json").read_text().replace("100.0", "1e308")
                   .replace("1.1,", "1e10,"))
        done = self.run_program("simulate", "stiff.json", "-o", "m.f64", "--report", "r.json", exit_code=3)
        self.assertEqual(len(done.stderr.splitlines()), 1)
        self.assertIn("stiff.json: stopped", done.stderr)
        self.assertEqual((self.folder / "m.f64").stat().st_size % 48, 0)
        self.assertGreater((self.folder / "m.f64").stat().st_size, 0)
        self.assertIs(self.read_json("r.json")["good"], False)

    def test_what_rests_is_skipped_unless_asked_for(self):
        self.run_program("import", "tet.obj", "-o", "p.esm")  # no loads: nothing ever moves
        skipped, full = self.json_of("simulate", "p.esm"), self.json_of("simulate", "p.esm", "--no-skip")
        self.assertEqual((skipped["nodes_awake"], full["nodes_awake"]), (0, 5))
        self.assertLess(skipped["mean_nodes_awake"], 1)
        self.assertEqual(full["mean_nodes_awake"], 5)
        self.assertEqual(skipped["springs_evaluated"], 0)
        self.assertGreater(full["springs_evaluated"], 0)

        # The wish travels with the project, and is not written where it is nothing special.
        project = self.read_json("p.esm")
        self.assertNotIn("skip_resting", project["simulation"])
        project["simulation"]["skip_resting"] = False
        self.write("p.esm", json.dumps(project))
        self.run_program("export", "p.esm", "-o", "q.esm")
        self.assertIs(self.read_json("q.esm")["simulation"]["skip_resting"], False)
        self.assertEqual(self.json_of("simulate", "q.esm")["nodes_awake"], 5)
        self.assertEqual(self.json_of("simulate", "q.esm", "--skip-resting")["nodes_awake"], 0)
        project["simulation"]["skip_resting"] = "no"
        self.write("p.esm", json.dumps(project))
        self.assertIn("/simulation/skip_resting", self.refused("validate", "p.esm"))

    def test_a_tolerance_that_is_kept_is_not_given_up(self):
        self.assertIs(self.json_of("simulate", "osc.json")["tolerance_given_up"], False)

    def test_bad_outputs_are_found_before_computing(self):
        self.assertIn("absent/m.csv", self.refused("simulate", "osc.json", "-o", "absent/m.csv"))
        self.assertIn(".pvd", self.refused("simulate", "osc.json", "-o", "m.avi"))
        self.assertIn("none.esm", self.refused("simulate", "none.esm"))

    def test_force_curve(self):
        net = self.read_json("osc.json")
        net["forces"] = [{"nodes": [1], "time": [0, 1], "force": [[0, 0, 0], [3, 0, 0]]}]
        self.write("pulled.json", repr(net).replace("'", '"'))
        self.run_program("simulate", "pulled.json", "--force-curve", "f.csv", "--mesh", "end.ply")
        lines = (self.folder / "f.csv").read_text().splitlines()
        self.assertEqual(lines[0], "t,applied_force,reaction_force,displacement")
        self.assertEqual([float(w) for w in lines[-1].split(",")[:2]], [1, 3])
        self.assertAlmostEqual(float(lines[1].split(",")[2]), 10, places=9)  # 100 N/m, 0.1 m at the start
        self.assertTrue((self.folder / "end.ply").exists())


class Interrupt(ProgramTest):
    """Ctrl-C in the midst of a run, even of a frame that takes hours: no half of a motion stays behind."""

    def start(self, output, **popen):
        command = [PROGRAM, "simulate", "osc.json", "--step", "1e-13", "--duration", "1000", "-o", output]
        running = subprocess.Popen(command, cwd=self.folder, stderr=subprocess.PIPE, **popen)
        self.addCleanup(running.stderr.close)
        self.addCleanup(running.wait)
        self.addCleanup(running.kill)
        while not any(name.startswith(output + ".") for name in os.listdir(self.folder)):
            self.assertIsNone(running.poll())
            time.sleep(0.01)
        return running

    def test_it_leaves_nothing_behind(self):
        for wanted, output in ((signal.SIGINT, "m.csv"), (signal.SIGTERM, "m.f64"), (signal.SIGHUP, "m.pvd")):
            with self.subTest(output):
                running = self.start(output)
                running.send_signal(wanted)
                self.assertEqual(running.wait(timeout=60), -wanted)  # as of any program that a signal ends
                self.assertEqual(sorted(os.listdir(self.folder)), ["osc.json", "tet.obj"])

    def test_an_older_file_stays(self):
        self.write("m.csv", "older")
        running = self.start("m.csv")
        running.send_signal(signal.SIGINT)
        running.wait(timeout=60)
        self.assertEqual((self.folder / "m.csv").read_text(), "older")
        self.assertEqual(sorted(os.listdir(self.folder)), ["m.csv", "osc.json", "tet.obj"])

    def test_what_the_caller_ignores_stays_ignored(self):
        running = self.start("m.csv", preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_IGN))
        running.send_signal(signal.SIGINT)
        time.sleep(0.1)
        running.send_signal(signal.SIGTERM)
        self.assertEqual(running.wait(timeout=60), -signal.SIGTERM)

    def test_a_run_that_ends_is_as_ever(self):
        self.run_program("simulate", "osc.json", "-o", "m.csv")
        self.assertTrue((self.folder / "m.csv").exists())


class Locale(ProgramTest):
    """Numbers have a point in every locale (under de_DE, C's own functions use a comma)."""

    def german(self):
        folder = self.folder / "locales"
        folder.mkdir()
        try:
            subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8", str(folder / "de_DE.UTF-8")], check=True,
                           capture_output=True)
        except (OSError, subprocess.CalledProcessError):
            self.skipTest("no localedef with de_DE here")
        return {"LOCPATH": str(folder), "LC_ALL": "de_DE.UTF-8"}

    def test_same_numbers_under_de_DE(self):
        german = self.german()
        here, there = self.json_of("inspect", "tet.obj"), self.json_of("inspect", "tet.obj", environment=german)
        self.assertEqual(here, there)
        for environment, name in ((None, "a"), (german, "b")):
            self.run_program("import", "tet.obj", "-o", "p.esm", environment=environment)
            self.run_program("apply", "p.esm", "-o", name + ".esm", "--set", "hardness=0.25", "--region",
                             "0.5,0,0,1.5,1,1", environment=environment)
        self.assertEqual((self.folder / "a.esm").read_bytes(), (self.folder / "b.esm").read_bytes())


class ProjectCommands(ProgramTest):
    def test_info_and_validate(self):
        self.run_program("import", "tet.obj", "-o", "p.esm")
        info = self.json_of("info", "p.esm")
        self.assertEqual((info["nodes"], info["springs"], info["regions"]), (5, 8, 0))
        self.assertIn("hardness = 0.5", self.run_program("info", "p.esm").stdout)
        self.assertIs(self.json_of("validate", "p.esm")["valid"], True)
        self.write("p.esm", (self.folder / "p.esm").read_text().replace('"up": "z"', '"up": "w"'))
        self.assertEqual(self.refused("validate", "p.esm"),
                         'esm: p.esm: /source/up is "w", it must be one of y, z')

    def test_written_projects_fit_the_schema(self):
        self.run_program("import", "tet.obj", "-o", "a.esm")
        self.run_program("import", "osc.json", "-o", "b.esm")
        self.run_program("apply", "a.esm", "-o", "c.esm", "--region", "0,0,0,1,1,1", "--set", "hardness=very hard",
                         "--poke", "0,0,0,1,2,3,5", "--rule", "IF hardness IS hard THEN youngs_modulus IS high")
        checker = SOURCE / "tests/core/project/check_schema.py"
        done = subprocess.run([sys.executable, checker, SOURCE / "docs/project.schema.json", "a.esm", "b.esm", "c.esm"],
                              cwd=self.folder, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_internal_samples_import(self):
        counts = SOURCE / "resources/samples/counts.json"
        if not counts.exists():
            self.skipTest("no samples in this tree")
        for mesh in sorted(p for p in counts.parent.iterdir() if p.suffix in (".obj", ".stl", ".ply")):
            self.run_program("import", mesh, "-o", "p.esm", "--unit", "mm")
            self.run_program("validate", "p.esm")


if __name__ == "__main__":
    unittest.main()
