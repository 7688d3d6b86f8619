#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
"""`esm learn`: what is learned is in the project, explained, helps on unseen loads; faults are one line, exit codes hold."""
import csv
import json
import unittest

from program import SOURCE, ProgramTest

FACTOR = 1.6  # of the springs that make the recordings, over those of the project


def ids_of(project):
    nodes = project["net"]["nodes"]
    return nodes.get("id", range(len(nodes["mass"])))  # without a list: the places


class Learn(ProgramTest):
    """Recordings are made by `esm simulate --solver relax` of a net with stiffer springs."""

    def setUp(self):
        super().setUp()
        self.run_program("import", SOURCE / "resources/samples/fallopian_tube.obj", "-o", "tube.esm", "--unit", "mm",
                         "--interior", "struts", "--fit-modulus")
        self.project = self.read_json("tube.esm")

    def record(self, name, where, force, factor=FACTOR, twice=()):
        """A table of where a net with springs stiffer by the factor, and twice that of these kinds, rests under a poke."""
        poke = ",".join(map(str, [*where, *force, 0.006]))
        self.run_program("apply", "tube.esm", "-o", "poked.esm", "--poke", poke)
        project = self.read_json("poked.esm")
        springs = project["net"]["springs"]
        stiffer = {spring for kind in twice for spring in springs[kind]}
        springs["stiffness"] = [factor * (1 + (i in stiffer)) * k for i, k in enumerate(springs["stiffness"])]
        project["tissue"]["parameters_from_tissue"] = False
        self.write("truth.esm", json.dumps(project))
        self.run_program("simulate", "truth.esm", "--solver", "relax", "--duration", "0.2", "--frames", "10",
                         "--tolerance", "1e-9", "-o", "motion.csv")
        rows = ["what,node,vx,vy,vz"]
        ids = ids_of(project)
        for load in project["loads"]["forces"]:
            rows += ["force,%d,%r,%r,%r" % (ids[node], *load["force"][-1]) for node in load["nodes"]]
        with open(self.folder / "motion.csv", encoding="utf-8", newline="") as table:
            last = {row["id"]: row for row in csv.DictReader(table)}  # later frames cover earlier ones
        rows += ["marker,%s,%s,%s,%s" % (i, row["x"], row["y"], row["z"]) for i, row in last.items()]
        self.write(name, "\n".join(rows) + "\n")

    def record_all(self, **how):
        position = self.project["geometry"]["position"]
        points = [position[i:i + 3] for i in range(0, len(position), 3)]
        points.sort()
        for name, share, force in (("a.csv", 0.3, (0, 0.004, 0)), ("b.csv", 0.5, (0, 0, -0.004)),
                                   ("c.csv", 0.7, (0.002, -0.003, 0))):
            self.record(name, points[int(share * len(points))], force, **how)

    def test_what_is_learned_is_kept_explained_and_helps(self):
        self.record_all()
        done = self.run_program("learn", "tube.esm", "-r", "a.csv", "b.csv", "--validate", "c.csv", "--what", "global",
                                "-o", "taught.esm", "--report", "fit.json")
        self.assertIn("round 1", done.stderr)
        report = self.read_json("fit.json")
        self.assertTrue(report["helped"])
        self.assertLess(report["validation_after"], 0.2 * report["validation_before"])
        taught = self.read_json("taught.esm")
        self.assertEqual(taught["tissue"]["learned"]["recordings"], 2)
        before = self.project["net"]["springs"]["stiffness"]
        after = taught["net"]["springs"]["stiffness"]
        for spring in range(0, len(before), 97):
            self.assertAlmostEqual(after[spring] / before[spring], FACTOR, delta=0.02)
            why = self.json_of("explain", "taught.esm", "--spring", spring)
            self.assertEqual(why["values"]["stiffness"]["from_tissue"], after[spring])
            self.assertIn("learned (2 recordings", why["sentence"])
        self.run_program("validate", "taught.esm")
        self.run_program("apply", "taught.esm", "-o", "again.esm")  # the layer stays on top of the words
        self.assertEqual(self.read_json("again.esm")["net"]["springs"]["stiffness"], after)

    def test_where_nothing_helps_no_project_is_written(self):
        self.record_all()
        position = self.project["geometry"]["position"]
        highest = max((position[i:i + 3] for i in range(0, len(position), 3)), key=lambda point: point[2])
        self.record("own.csv", highest, (0, 0, -0.004), 1.02)  # nearly the project's own net
        done = self.run_program("learn", "tube.esm", "-r", "a.csv", "b.csv", "--validate", "own.csv", "--what", "global",
                                "-o", "taught.esm", exit_code=3)
        self.assertIn("nothing that was learned helps", done.stderr)
        self.assertFalse((self.folder / "taught.esm").exists())

    def test_a_wall_learns_by_its_kinds_of_springs(self):
        self.run_program("import", SOURCE / "resources/samples/fallopian_tube.obj", "-o", "tube.esm", "--unit", "mm",
                         "--interior", "wall", "--wall-thickness", "0.002")
        self.project = self.read_json("tube.esm")
        self.record_all(twice=("wall_edges", "wall_across"))
        self.run_program("learn", "tube.esm", "-r", "a.csv", "b.csv", "--what", "classes", "-o", "taught.esm")
        kinds = {factor.get("kind") for factor in self.read_json("taught.esm")["tissue"]["learned"]["factors"]}
        self.assertTrue({"edge", "wall_edge", "wall_across", "wall_brace"} <= kinds, kinds)
        self.run_program("validate", "taught.esm")

    def test_slopes_are_those_of_differences(self):
        self.record_all()
        done = self.run_program("learn", "tube.esm", "-r", "a.csv", "--what", "global,anchors", "--check-gradient")
        self.assertEqual(len(done.stdout.splitlines()), 2)

    def test_faults_are_one_line(self):
        self.record_all()
        rows = (self.folder / "a.csv").read_text(encoding="utf-8").splitlines()
        in_mm = rows[:1]
        for row in rows[1:]:
            kind, node, *value = row.split(",")
            scale = 1e3 if kind == "marker" else 1
            in_mm.append(",".join([kind, node, *(str(scale * float(v)) for v in value)]))
        self.write("mm.csv", "\n".join(in_mm) + "\n")
        self.assertIn("--length-unit mm", self.refused("learn", "tube.esm", "-r", "mm.csv", "-o", "q.esm"))
        self.assertIn("absent.csv", self.refused("learn", "tube.esm", "-r", "absent.csv", "-o", "q.esm"))
        self.refused("learn", "tube.esm", "-r", "a.csv", exit_code=2)
        self.refused("learn", "tube.esm", "-r", "a.csv", "--what", "colour", "-o", "q.esm", exit_code=2)
        self.refused("learn", "tube.esm", "-r", "a.csv", "-o", "a.csv", exit_code=2)


if __name__ == "__main__":
    unittest.main()
