#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
"""esm simulate says where energy has gone, and what a motion makes of errors."""
import json
import unittest

from program import OSCILLATOR, SOURCE, ProgramTest

NETS = SOURCE / "tests" / "data" / "nets"


class Energy(ProgramTest):
    def balance(self, report):
        return report["initial_energy"] + report["external_work"] + report["restored_energy"] - \
            report["dissipated_energy"] - report["method_loss"] - report["energy"]

    def test_the_report_adds_up(self):
        net = json.loads(json.dumps(OSCILLATOR))
        net["springs"]["viscosity"] = 2.0
        net["forces"] = [{"nodes": [1], "time": [0.1, 0.4], "force": [[0, 0, 0], [5, 0, 0]]}]
        self.write("damped.json", json.dumps(net))
        for solver in ("auto", "leapfrog", "implicit", "stoermer"):
            report = self.json_of("simulate", "damped.json", "--solver", solver, "--tolerance", "1e-4")
            self.assertAlmostEqual(report["initial_energy"], 0.5 * 100 * 0.1**2, places=12)
            self.assertAlmostEqual(self.balance(report), report["energy_residual"], delta=1e-12)
            self.assertLessEqual(abs(report["energy_residual"]), 1e-4 * report["dissipated_energy"])
            self.assertIs(report["good"], True)

    def test_what_an_implicit_method_takes_falls_with_the_tolerance(self):
        lost = [abs(self.json_of("simulate", "osc.json", "--solver", "implicit", "--tolerance", t)["method_loss"])
                for t in ("1e-3", "1e-5")]  # undamped: all that is gone is the method's
        self.assertGreater(lost[1], 0.0)
        self.assertLessEqual(3 * 3 * lost[1], lost[0])

    def test_what_a_jump_stretches_and_gives_up_is_no_work(self):
        # A node is moved by 100 m in a picosecond: its springs would hold 1e57 J before the net follows.
        self.run_program("simulate", NETS / "jumping_grid.json", "--report", "r.json", "-o", "m.f64", exit_code=3)
        self.assertLess(abs(self.read_json("r.json")["external_work"]), 1.0)
        # Named, descent takes a step a frame; it does not get there in one, and says so.
        done = self.run_program("simulate", NETS / "jumping_grid.json", "--solver", "descent", "--report", "d.json",
                                exit_code=3)
        self.assertIn("was given up", done.stderr)
        self.assertEqual(len(done.stderr.splitlines()), 2)
        report = self.read_json("d.json")
        self.assertLessEqual(abs(report["energy_residual"]), 1e-9 * report["external_work"])

    def test_an_estimate_that_the_balance_refutes_is_not_repeated(self):
        # Damped steps, which gain nothing: 2.3e7 J become 2 J, while the method's estimate speaks of 1e10 J gained.
        done = self.run_program("simulate", NETS / "exploding_star.json", "--duration", "0.5", "--report", "r.json",
                                exit_code=3)
        report = self.read_json("r.json")
        self.assertLess(report["energy"], 1e-3 * report["initial_energy"])
        self.assertLess(report["method_loss"], -10 * report["initial_energy"])
        self.assertIn("energy is not accounted for", done.stderr)
        self.assertNotIn("has added", done.stderr)

    def test_energy_beyond_all_numbers_is_said_without_one(self):
        # A step of thirty times what is stable: places of 1e152 m are numbers, what springs of 1e6 N/m hold there is not.
        net = {"format": "esm-net-1", "name": "wild", "duration": 0.051, "frame_rate": 1000.0, "gravity": [0, 0, 0],
               "nodes": {"position": [0, 0, 0, 0.1, 0, 0], "mass": 1e-3, "fixed": [0]},
               "springs": {"i": [0], "j": [1], "stiffness": 1e6, "viscosity": 0, "rest_length": 0.101}}
        self.write("wild.json", json.dumps(net))
        done = self.run_program("simulate", "wild.json", "--solver", "leapfrog", "--step", "1e-3", "--report", "r.json",
                                exit_code=3)
        self.assertIn("beyond what numbers can hold", done.stderr)
        self.assertNotIn("nan", done.stderr)
        self.assertIs(self.read_json("r.json")["good"], False)

    def test_a_vibration_that_the_method_has_eaten_is_said(self):
        # Two free nodes, 4.5 million radians a second: nothing damps them, and steps of all lengths have lost them.
        net = {"format": "esm-net-1", "name": "fast", "duration": 0.1, "frame_rate": 60.0, "gravity": [0, 0, 0],
               "nodes": {"position": [0, 0, 0, 0.1, 0, 0], "mass": 1e-7, "fixed": []},
               "springs": {"i": [0], "j": [1], "stiffness": 1e6, "viscosity": 0, "rest_length": 0.101}}
        self.write("fast.json", json.dumps(net))
        done = self.run_program("simulate", "fast.json", "--report", "r.json", exit_code=3)
        self.assertIn("the method itself has taken 0.5 J", done.stderr)
        report = self.read_json("r.json")
        self.assertIs(report["good"], False)
        self.assertGreater(report["method_loss"], 0.49)
        self.run_program("simulate", "fast.json", "--accept-rough")
        kept = self.json_of("simulate", "fast.json", "--solver", "verlet", "--step", "1e-8", "--duration", "1e-3",
                            "--frames", "1000", "--work", "1e9")
        self.assertIs(kept["good"], True)

    def test_a_net_that_folds_multiplies_errors_and_it_is_said(self):
        # Exact integrators part by 7e-2 on it after half a second, where 1e-4 had been asked for.
        done = self.run_program("simulate", NETS / "folding_sheet.json", "--tolerance", "1e-4", "--report", "r.json",
                                "-o", "m.f64", exit_code=3)
        self.assertIn("multiplies small errors", done.stderr)
        self.assertIn("--verify", done.stderr)
        report = self.read_json("r.json")
        self.assertGreater(report["error_growth"], 100)
        self.assertIs(report["good"], False)
        self.assertTrue((self.folder / "m.f64").exists())

    def test_a_struck_organ_multiplies_errors_where_no_damper_takes_them(self):
        # Half a second of some thousand steps at 1e-2: looks are paid for by the work, of which there is little.
        self.run_program("export", SOURCE / "resources" / "samples" / "gallbladder.esm", "-o", "damped.json")
        net = self.read_json("damped.json")
        height = net["nodes"]["position"][2::3]
        net["nodes"]["velocity"] = [v for z in height for v in ((0.3 if z < min(height) + 0.015 else 0.0), 0.0, 0.0)]
        self.write("damped.json", json.dumps(net))
        net["springs"]["viscosity"] = 0.0
        net["nodes"].pop("mass_damping", None)
        if "anchors" in net:
            net["anchors"]["viscosity"] = 0.0
        self.write("undamped.json", json.dumps(net))
        run = ("--duration", "1", "--tolerance", "1e-2")
        self.assertIn("multiplies small errors", self.run_program("simulate", "undamped.json", *run, exit_code=3).stderr)
        self.assertNotIn("multiplies", self.run_program("simulate", "damped.json", *run).stderr)

    def test_organs_do_not_and_nothing_is_said(self):
        for sample in ("uterus", "fallopian_tube", "gallbladder"):
            for tolerance in ("1e-1", "1e-3"):
                done = self.run_program("simulate", SOURCE / "resources" / "samples" / f"{sample}.esm", "--duration",
                                        "0.5", "--tolerance", tolerance)
                self.assertNotIn("multiplies", done.stderr)


if __name__ == "__main__":
    unittest.main()
