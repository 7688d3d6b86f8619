#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
"""Nets that no tissue is like: what falls and flies does so, work has a limit, and what was given up is said."""
import csv
import json
import math
import unittest

from program import SOURCE, ProgramTest

NETS = SOURCE / "tests" / "data" / "nets"
TRIANGLE = {
    "format": "esm-net-1", "name": "triangle", "duration": 0.5, "frame_rate": 60, "gravity": [0, 0, -9.81],
    "nodes": {"position": [0, 0, 0, 0.1, 0, 0, 0, 0.1, 0], "mass": 0.001, "fixed": []},
    "springs": {"i": [0, 1, 0], "j": [1, 2, 2], "stiffness": 1e12, "viscosity": 0,
                "rest_length": [0.1, math.sqrt(0.02), 0.1], "law": "linear", "law_parameter": 0},
}


class Extremes(ProgramTest):
    def take(self, name):
        self.write(name, (NETS / name).read_bytes())
        return name

    def centres(self, name, masses):
        """Centre of mass of each frame of a CSV, and the largest displacement of a node."""
        frames = {}
        with open(self.folder / name, encoding="utf-8", newline="") as file:
            for row in csv.DictReader(file):
                frames.setdefault(float(row["t"]), []).append([float(row[axis]) for axis in "xyz"])
        first = next(iter(frames.values()))
        motion = max(math.dist(a, b) for frame in frames.values() for a, b in zip(frame, first))
        whole = math.fsum(masses)
        return {t: [math.fsum(m * p[k] for m, p in zip(masses, frame)) / whole for k in range(3)]
                for t, frame in frames.items()}, motion

    def check_flight(self, name, exit_code):
        """By v0 t + g t^2 / 2, to a thousandth of a millionth of the motion."""
        net = self.read_json(name)
        masses = net["nodes"]["mass"]
        self.run_program("simulate", name, "-o", "out.csv", exit_code=exit_code)
        centres, motion = self.centres("out.csv", masses)
        self.assertGreater(len(centres), 1)
        flat = net["nodes"].get("velocity", [0.0] * (3 * len(masses)))
        start = [math.fsum(m * v for m, v in zip(masses, flat[k::3])) / math.fsum(masses) for k in range(3)]
        gravity = net.get("gravity", [0, 0, 0])
        for t, centre in centres.items():
            for k in range(3):
                due = centres[0.0][k] + start[k] * t + gravity[k] * t * t / 2
                self.assertAlmostEqual(centre[k], due, delta=1e-9 * motion, msg=f"{name} at {t} s")

    def test_a_cloud_falls_though_its_tolerance_is_given_up(self):
        self.check_flight(self.take("rough_cloud.json"), 3)

    def test_a_star_without_forces_keeps_its_centre(self):
        self.check_flight(self.take("flying_star.json"), 3)

    def test_a_triangle_of_the_stiffest_springs_falls(self):
        self.write("triangle.json", json.dumps({**TRIANGLE, "nodes": {**TRIANGLE["nodes"], "mass": [1e-3] * 3}}))
        self.check_flight("triangle.json", 0)

    def test_the_work_of_attempts_that_were_thrown_away_is_not_counted(self):
        """A node leaps by 100 m within a picosecond; on the way to steps that hold, attempts did 1e57 J."""
        self.run_anyhow("simulate", self.take("discarded_attempts.json"), "--duration", "0.5", "--report", "r.json")
        report = self.read_json("r.json")
        self.assertLess(abs(report["external_work"]), 1.0)

    def test_a_leap_that_no_step_follows_is_named(self):
        """What happened, when and where, and the way out."""
        self.take("discarded_attempts.json")
        done = self.run_anyhow("simulate", "discarded_attempts.json", "--duration", "0.5")
        self.assertEqual(done.returncode, 3)
        self.assertIn("is moved by 100 m within 1e-12 s", done.stderr)
        self.assertIn("spread that motion over more time", done.stderr)

    def test_every_run_has_its_work_limit(self):
        """Of 2e5 force passes a sixtieth of a second, whatever the net; what was reached is said and kept."""
        seconds = 0.5
        for name in ("stiff_pair.json", "stiff_star.json", "stiff_organ.esm"):
            self.take(name)
            done = self.run_anyhow("simulate", name, "--duration", seconds, "--report", "r.json")
            report = self.read_json("r.json")
            passes = report["springs_evaluated"] / report["springs"]
            self.assertLess(passes, 1.2 * 2e5 * 60 * seconds, name)
            self.assertLess(report["steps"], 1.2 * 2e5 * 60 * seconds, name)
            is_kept = report["good"] and not report["tolerance_given_up"]
            self.assertEqual(done.returncode, 0 if is_kept else 3, done.stderr)

    def test_descent_by_name_does_not_claim_a_tolerance(self):
        """It errs by a tenth on one mass on a spring; nobody has measured that."""
        done = self.run_program("simulate", "osc.json", "--solver", "descent", "--report", "r.json", exit_code=3)
        self.assertIn("was given up", done.stderr)
        self.assertIs(self.read_json("r.json")["good"], False)
        self.run_program("simulate", "osc.json", "--solver", "descent", "--accept-rough")

    def test_a_run_ends_at_a_work_limit_of_the_users(self):
        done = self.run_program("simulate", "osc.json", "--step", "1e-5", "--work", "100", "-o", "out.csv",
                                "--report", "r.json", exit_code=3)
        self.assertIn("the work limit of 100 force passes", done.stderr)
        report = self.read_json("r.json")
        self.assertFalse(report["good"])
        self.assertLessEqual(report["steps"], 6000)
        self.assertGreater(report["simulated_time"], 0.05)
        self.assertIn("frames, at 0.0", done.stderr)
        centres, _ = self.centres("out.csv", [1.0, 1.0])
        self.assertIn(max(centres), (0.04, 0.06))


if __name__ == "__main__":
    unittest.main()
