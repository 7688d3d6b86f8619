#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
"""`esm haptics`: devices with their reason, paths that come back, the same forces each time, zero at the end."""
import csv
import math
import os
import signal
import subprocess
import time
import unittest

from program import PROGRAM, SOURCE, ProgramTest


class Haptics(ProgramTest):
    def rows(self, name):
        with open(self.folder / name, newline="", encoding="utf-8") as file:
            return [{key.split(" [")[0]: float(value) for key, value in row.items()} for row in csv.DictReader(file)]

    def press_path(self):
        """From 2 cm over the top of the uterus to 1 cm under it and back, in 2 s."""
        with open(self.folder / "hand.csv", "w", encoding="utf-8") as file:
            file.write("t,x,y,z\n")
            for i in range(201):
                t = i / 100
                z = 0.095 - 0.03 * math.sin(math.pi * min(max(t - 0.5, 0.0) / 1.5, 1.0))
                file.write(f"{t!r},0.0,0.009,{z!r}\n")

    def replay(self, out, *more):
        return self.json_of("haptics", "replay", "hand.csv", SOURCE / "resources/samples/uterus.esm", "--csv", out,
                            *more)

    def force(self, row):
        return math.hypot(row["fx"], row["fy"], row["fz"])

    def test_the_simulated_device_is_ready_and_others_say_why_not(self):
        devices = {device["name"]: device for device in self.json_of("haptics", "list")["devices"]}
        self.assertTrue(devices["simulated"]["usable"])
        for device in devices.values():
            self.assertTrue(device["usable"] or device["reason"], device)

    def test_the_firmware_is_named_with_its_hash(self):
        (self.folder / "image.bin").write_bytes(b"abc")
        sha = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"  # FIPS 180-4
        said = self.json_of("haptics", "info", "--device", "falcon", "--firmware", "image.bin")
        self.assertEqual(said["name"], "Novint Falcon")
        self.assertEqual(said["max_force"], 8.0)
        devices = {device["name"]: device for device in self.json_of("haptics", "list", "--firmware", "image.bin")["devices"]}
        if "USB" not in devices["falcon"]["reason"]:  # a machine without a USB bus has nothing to look at
            self.assertIn(sha, said["details"])
            self.assertIn(sha, devices["falcon"]["details"])

    def test_a_device_of_nobody_is_opened_with_consent_only_and_a_profile_counts(self):
        (self.folder / "own.json").write_text('{"limits": {"force_N": 2.5}}', encoding="utf-8")
        said = self.json_of("haptics", "info", "--device", "wooden", "--opt-in", "--profile", "own.json")
        self.assertEqual(said["max_force"], 2.5)
        self.run_program("haptics", "record", "--device", "wooden", "--opt-in", "-o", "x.csv", exit_code=1)  # absent

    def test_a_path_presses_the_uterus_and_equal_paths_give_equal_forces(self):
        self.press_path()
        said = self.replay("a.csv")
        self.replay("b.csv")
        with open(self.folder / "a.csv", "rb") as a, open(self.folder / "b.csv", "rb") as b:
            self.assertEqual(a.read(), b.read())
        rows = self.rows("a.csv")
        self.assertGreater(said["largest_force"], 0.05)
        self.assertLessEqual(said["largest_force"], 5.0 + 1e-12)
        for before, row in zip(rows, rows[1:]):
            change = math.hypot(*(row[k] - before[k] for k in ("fx", "fy", "fz")))
            self.assertLessEqual(change, 1.0 + 1e-9)

    def test_a_simulation_that_answers_no_more_is_no_wall(self):
        self.press_path()
        self.replay("a.csv", "--stop-simulation", "1.2")
        rows = self.rows("a.csv")
        felt = max(self.force(r) for r in rows if r["t"] < 1.2)
        self.assertGreater(felt, 0.02)
        # The last answer holds as a spring, for 10 mm of the way back, which the hand has gone by 1.66 s; 50 ms later
        # it is gone.
        self.assertGreater(max(self.force(r) for r in rows if 1.36 < r["t"] < 1.5), 0.0)
        self.assertEqual(max(self.force(r) for r in rows if r["t"] > 1.72), 0.0)

    def test_the_falcon_s_twin_feels_what_is_there(self):
        said = self.json_of("haptics", "replay", SOURCE / "resources/samples/uterus_press.csv",
                            SOURCE / "resources/samples/uterus.esm", "--device", "falcon", "--frames", "125",
                            "--seconds", "3.0", "--compare")
        self.assertGreater(said["true_peak"], 0.1)
        self.assertLess(said["error_rms"], 0.05)
        self.assertEqual(said["reason"], "")
        self.run_program("haptics", "replay", SOURCE / "resources/samples/uterus_press.csv",
                         SOURCE / "resources/samples/uterus.esm", "--device", "pid", exit_code=1)

    def test_sigterm_ends_with_zero_force_and_a_record(self):
        process = subprocess.Popen([PROGRAM, "haptics", "run", "--seconds", "60", "--arm", "--csv", "felt.csv"],
                                   cwd=self.folder)
        time.sleep(1.5)
        process.send_signal(signal.SIGTERM)
        self.assertEqual(process.wait(timeout=30), -signal.SIGTERM)
        rows = self.rows("felt.csv")
        self.assertGreater(len(rows), 100)
        self.assertEqual(self.force(rows[-1]), 0.0)

    def test_a_killed_program_leaves_its_record_up_to_the_last_half_second(self):
        for command, out, header in ((["run", "--csv"], "felt.csv", "t [s],x [m],"), (["record", "-o"], "way.csv", "t,x,")):
            process = subprocess.Popen([PROGRAM, "haptics", *command, out, "--seconds", "60"], cwd=self.folder)
            file = self.folder / out
            deadline = time.monotonic() + 30
            while (not file.exists() or file.stat().st_size < 1000) and time.monotonic() < deadline:
                time.sleep(0.02)
            begun = time.monotonic()  # the first part of the record is there
            time.sleep(1.5)
            process.kill()
            ran = time.monotonic() - begun
            process.wait(timeout=30)
            text = file.read_text(encoding="utf-8")
            self.assertTrue(text.startswith(header), text[:60])
            lines = text[:text.rindex("\n")].split("\n")[1:]
            times = [float(line.split(",")[0]) for line in lines]
            self.assertTrue(all(line.count(",") == lines[0].count(",") for line in lines))
            self.assertGreater(times[-1] - times[0], ran - 0.5)

    def test_a_record_is_refused_before_the_device_moves(self):
        self.run_program("haptics", "run", "--seconds", "60", "--csv", "no/such/folder/felt.csv", exit_code=1)

    def test_bad_paths_are_one_line(self):
        with open(self.folder / "hand.csv", "w", encoding="utf-8") as file:
            file.write("t,x,y,z\n0,0,0,0\n0,0,0,0\n")
        self.run_program("haptics", "replay", "hand.csv", SOURCE / "resources/samples/uterus.esm", exit_code=1)

    def test_the_selftest_is_good(self):
        said = self.json_of("haptics", "selftest")
        self.assertTrue(said["good"], [row for row in said["rows"] if not row["good"]])
        self.assertEqual({row["id"] for row in said["rows"]}, {f"A{i}" for i in range(1, 10)})


if __name__ == "__main__":
    unittest.main()
