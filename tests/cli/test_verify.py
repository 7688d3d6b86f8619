#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
"""esm simulate --verify: finer runs measure the error, and are the result where the tolerance is not kept."""
import json
import math
import os
import signal
import subprocess
import time
import unittest

from program import OSCILLATOR, PROGRAM, SOURCE, ProgramTest
from readers import read_f64


def thrown_node(more):
    """A node between two supports, thrown at the place where both springs are shortest with `more` times the
    energy that it takes to get there."""
    length = math.hypot(1.0, 0.5)
    speed = math.sqrt(2.0 * 100.0 * (length - 1.0) ** 2 * more)
    net = json.loads(json.dumps(OSCILLATOR))
    net.update(name="snap", duration=4.0)
    net["nodes"] = {"position": [-1, 0, 0, 0, 0.5, 0, 1, 0, 0], "mass": 1.0, "fixed": [0, 2],
                    "velocity": [0, 0, 0, 0, -speed, 0, 0, 0, 0]}
    net["springs"].update(i=[0, 1], j=[1, 2], rest_length=length)
    return json.dumps(net)


class Verify(ProgramTest):
    def bytes_of(self, name):
        return (self.folder / name).read_bytes()

    def test_a_motion_that_keeps_its_tolerance_is_as_without(self):
        plain = self.json_of("simulate", "osc.json", "-o", "plain.csv")
        done = self.json_of("simulate", "osc.json", "--verify", "-o", "m.csv", "--force-curve", "f.csv")
        self.assertIs(done["tolerance_kept"], True)
        self.assertLessEqual(done["measured_error"], 1e-3)
        self.assertEqual(done["tolerance_used"], 1e-3)
        self.assertEqual(done["springs_evaluated"], plain["springs_evaluated"])  # of the motion that is written
        self.assertNotIn("measured_error", plain)
        self.assertEqual(self.bytes_of("m.csv"), self.bytes_of("plain.csv"))
        self.assertEqual(sorted(os.listdir(self.folder)), ["f.csv", "m.csv", "osc.json", "plain.csv", "tet.obj"])

    def test_finer_steps_are_taken_where_a_motion_multiplies_errors(self):
        for more, over in ((1 + 1e-5, True), (1 - 1e-5, False)):  # energy says whether it gets over
            self.write("snap.json", thrown_node(more))
            done = self.json_of("simulate", "snap.json", "--tolerance", "1e-2", "--verify", "-o", "m.f64", "--report",
                                "r.json")
            self.assertIs(done["tolerance_kept"], True)
            self.assertLess(done["tolerance_used"], 1e-2)
            self.assertGreater(done["verification_seconds"], 0)
            self.assertEqual(self.read_json("r.json"), done)
            lowest = min(frame[1][1] for frame in read_f64(self.folder / "m.f64", 3))
            self.assertEqual(lowest < -0.1, over)

    def test_what_no_steps_can_do_is_said(self):
        self.write("snap.json", thrown_node(1.0))
        done = self.run_program("simulate", "snap.json", "--tolerance", "1e-6", "--duration", "8", "--verify", "--report",
                                "r.json", "-o", "m.f64", exit_code=3)
        self.assertIn("snap.json: the tolerance of 1e-06 is not kept", done.stderr.splitlines()[-1])
        report = self.read_json("r.json")
        self.assertEqual((report["tolerance_kept"], report["good"]), (False, True))
        self.assertGreater(report["measured_error"], 1e-6)
        self.assertTrue((self.folder / "m.f64").exists())

    def test_a_step_of_the_users_own_is_measured(self):
        # Verlet's phase runs ahead by (w h)^2 / 24: over 10 rad, relative to sqrt(1.5) swings, a third of that.
        done = self.json_of("simulate", "osc.json", "--solver", "verlet", "--step", "0.01", "--tolerance", "1e-4",
                            "--verify", exit_code=3)
        self.assertEqual((done["solver"], done["tolerance_used"]), ("verlet", 1e-4))
        expected = (10 * 0.01) ** 2 / 24 * 10 / 3
        self.assertAlmostEqual(done["measured_error"], expected, delta=0.15 * expected)
        self.json_of("simulate", "osc.json", "--solver", "verlet", "--step", "0.01", "--tolerance", "1e-2", "--verify")

    def test_another_solver_judges(self):
        done = self.json_of("simulate", "osc.json", "--solver", "relax", "--verify", exit_code=3)  # it knows no inertia
        self.assertGreater(done["measured_error"], 0.5)
        self.assertIn("away from a run with a tolerance of 0.0001", done["verification"])

    def test_a_motion_beyond_the_memory_is_refused(self):
        tube = SOURCE / "resources/samples/fallopian_tube.esm"
        why = self.refused("simulate", tube, "--verify", "--duration", "1e3", "--frames", "1e6", "-o", "m.csv")
        self.assertIn("use less --frames or --duration", why)
        self.assertFalse((self.folder / "m.csv").exists())

    def test_a_signal_removes_what_both_runs_have_begun(self):
        command = [PROGRAM, "simulate", "osc.json", "--solver", "lie", "--step", "1000", "--tolerance", "1e-9",
                   "--duration", "1e6", "--frames", "1e-3", "--verify", "-o", "m.csv"]
        with subprocess.Popen(command, cwd=self.folder, stderr=subprocess.DEVNULL) as running:
            self.addCleanup(running.kill)
            while sum(name.startswith("m.csv.") for name in os.listdir(self.folder)) < 2:
                self.assertIsNone(running.poll())
                time.sleep(0.01)
            running.send_signal(signal.SIGINT)
            self.assertEqual(running.wait(timeout=60), -signal.SIGINT)
        self.assertEqual(sorted(os.listdir(self.folder)), ["osc.json", "tet.obj"])


if __name__ == "__main__":
    unittest.main()
