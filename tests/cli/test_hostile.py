#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
"""Mutated and truncated projects through the real program: exit 1 and one line each, never a crash."""
import json
import os
import pathlib
import random
import stat
import subprocess
import time
import unittest

from program import OSCILLATOR, PROGRAM, ProgramTest

DATA = pathlib.Path(__file__).parent.parent / "data"


def mutate(content, dice):
    place = dice.randrange(len(content))
    kind = dice.randrange(4)
    if kind == 0:
        return content[:place]
    if kind == 1:
        return content[:place] + bytes([dice.randrange(256)]) + content[place + 1:]
    if kind == 2:
        return content[:place] + content[place + dice.randrange(1, 40):]
    return content[:place] + dice.choice([b"1e999", b"[[[[", b"\xff\xfe", b'"', b"-1", b"{}"]) + content[place:]


class HostileProjects(ProgramTest):
    def test_mutated_projects(self):
        dice = random.Random(7)
        self.run_program("import", "tet.obj", "-o", "p.esm")
        self.run_program("export", "p.esm", "-o", "p.esmb")
        refused = 0
        for name in ("p.esm", "p.esmb"):
            content = (self.folder / name).read_bytes()
            for number in range(30):
                self.write("hostile.esm", mutate(content, dice))
                done = self.run_anyhow("validate", "hostile.esm")
                self.assertIn(done.returncode, (0, 1), (name, number, done.stderr))
                if done.returncode == 1:
                    refused += 1
                    self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
                    self.assertIn("hostile.esm", done.stderr)
        self.assertGreater(refused, 30)

    def test_newer_schema(self):
        self.run_program("import", "tet.obj", "-o", "p.esm")
        self.write("p.esm", (self.folder / "p.esm").read_text().replace('"schema_version": 1', '"schema_version": 9'))
        self.assertIn("newer version", self.refused("info", "p.esm"))


class OutputsAndTerminal(ProgramTest):
    """What is written where, and what reaches the terminal."""

    def test_a_pipe_at_the_output_is_not_replaced(self):
        for option in ("-o", "--report", "--force-curve"):
            name = "pipe" + option + ".csv"
            os.mkfifo(self.folder / name)
            self.assertIn("pipe", self.refused("simulate", "osc.json", option, name))
            self.assertTrue(stat.S_ISFIFO((self.folder / name).stat().st_mode))

    def test_two_outputs_on_one_file_are_refused(self):
        line = self.refused("simulate", "osc.json", "-o", "x.csv", "--report", "./x.csv", exit_code=2)
        self.assertIn("two outputs", line)
        self.assertFalse((self.folder / "x.csv").exists())

    def refused_and_kept(self, path, *arguments):
        """Exit code 2, and the file as it was."""
        before = (self.folder / path).read_bytes()
        self.assertIn("written over what is read", self.refused(*arguments, exit_code=2), arguments)
        self.assertEqual((self.folder / path).read_bytes(), before, arguments)

    def test_what_is_read_is_never_written_over(self):
        self.run_program("import", "tet.obj", "-o", "p.obj")
        self.write("osc.csv", json.dumps(OSCILLATOR))
        self.write("osc_springs.csv", json.dumps(OSCILLATOR))
        self.write("hand.csv", "t,x,y,z\n0,0,0,0.1\n1,0,0,0.05\n")
        self.write("s.fll", "Engine: s\n")
        os.symlink("tet.obj", self.folder / "link.obj")
        os.link(self.folder / "tet.obj", self.folder / "hard.obj")
        (self.folder / "sub").mkdir()
        for path, *arguments in (
                ("tet.obj", "import", "tet.obj", "-o", "tet.obj"), ("tet.obj", "import", "tet.obj", "-o", "link.obj"),
                ("tet.obj", "import", "link.obj", "-o", "sub/../tet.obj"),
                ("tet.obj", "import", "hard.obj", "-o", "tet.obj"),
                ("tet.obj", "import", "tet.obj", "-o", "x.esm", "--save-recipe", "tet.obj"),
                ("osc.json", "simulate", "osc.json", "--report", "./osc.json"),
                ("osc.csv", "simulate", "osc.csv", "-o", "osc.csv"),
                ("osc.csv", "simulate", "osc.csv", "--force-curve", "osc.csv"),
                ("osc.csv", "simulate", "osc.csv", "--mesh", "osc.csv"),
                ("osc_springs.csv", "simulate", "osc_springs.csv", "--mesh", "osc.csv"),
                ("p.obj", "export", "p.obj", "-o", "p.obj"),
                ("osc_springs.csv", "export", "osc_springs.csv", "-o", "osc.csv"),
                ("p.obj", "apply", "osc.json", "--rules", "p.obj", "-o", "p.obj"),
                ("hand.csv", "haptics", "replay", "hand.csv", "p.obj", "--csv", "hand.csv"),
                ("p.obj", "haptics", "replay", "hand.csv", "p.obj", "--csv", "p.obj"),
                ("s.fll", "fuzzy", "convert", "s.fll", "s.fll"),
                ("hand.csv", "fuzzy", "eval", "s.fll", "--in", "hand.csv", "-o", "hand.csv")):
            with self.subTest(arguments):
                self.refused_and_kept(path, *arguments)

    def test_the_second_file_of_an_export_counts_too(self):
        line = self.refused("simulate", "osc.json", "-o", "x_springs.csv", "--mesh", "x.csv", exit_code=2)
        self.assertIn("two outputs", line)

    def test_a_motion_follows_its_link(self):
        os.symlink("real.csv", self.folder / "link.csv")
        self.run_program("simulate", "osc.json", "-o", "link.csv")
        self.assertTrue((self.folder / "link.csv").is_symlink())
        self.assertIn("t,id,x,y,z", (self.folder / "real.csv").read_text())

    def test_a_file_that_may_not_grow_is_an_error_and_no_crash(self):
        self.run_program("import", "tet.obj", "-o", "p.esm")
        before = (self.folder / "p.esm").read_bytes()
        for arguments in (("apply", "p.esm", "-o", "p.esm", "--gravity", "0,0,-1"),
                          ("simulate", "osc.json", "-o", "m.csv"), ("simulate", "osc.json", "-o", "m.pvd")):
            with self.subTest(arguments):
                done = subprocess.run(["prlimit", "--fsize=300", PROGRAM, *arguments], cwd=self.folder,
                                      capture_output=True, text=True, timeout=60, check=False)
                self.assertEqual(done.returncode, 1, done.stderr)
                self.assertIn("cannot be written (File too large)", done.stderr)
        self.assertEqual((self.folder / "p.esm").read_bytes(), before)
        self.assertFalse([name for name in os.listdir(self.folder) if "esm-tmp" in name])

    def test_a_bad_path_is_told_before_the_work(self):
        """A run that would take years."""
        (self.folder / "folder.obj").mkdir()
        for option, path in (("--report", "absent/r.json"), ("--force-curve", "absent/c.csv"), ("-o", "absent/m.f64"),
                             ("--mesh", "absent/x.obj"), ("--mesh", "folder.obj")):
            with self.subTest(option):
                self.assertIn("cannot be written", self.refused("simulate", "osc.json", "--step", "1e-13", "--work",
                                                                "1e30", "--duration", "1000", option, path))

    def test_a_step_that_never_ends_is_refused(self):
        self.assertIn("--step", self.refused("simulate", "osc.json", "--step", "1e-300"))

    def test_a_tolerance_that_was_given_up_is_said(self):
        self.write("rough.json", (DATA / "nets" / "rough_cloud.json").read_bytes())
        done = self.run_program("simulate", "rough.json", "--duration", "0.1", exit_code=3)
        self.assertIn("the tolerance of 0.001 was given up", done.stderr)
        self.run_program("simulate", "rough.json", "--duration", "0.1", "--accept-rough")

    def test_a_pipe_is_no_input(self):
        os.mkfifo(self.folder / "in.esm")
        for command in (("validate",), ("info",), ("import", "--update"), ("simulate",), ("inspect",)):
            self.assertIn("is a pipe", self.refused(*command, "in.esm"), command)
        for command in (("validate",), ("import", "--update"), ("inspect",)):
            self.assertIn("is a device", self.refused(*command, "/dev/zero"), command)

    def test_a_byte_order_mark_is_no_fault(self):
        self.write("bom.json", b"\xef\xbb\xbf" + json.dumps(OSCILLATOR).encode())
        self.run_program("validate", "bom.json")

    def test_control_characters_do_not_reach_the_terminal(self):
        self.write("escape.json", json.dumps({**OSCILLATOR, "name": "a\x1b[2Jb"}))
        done = self.run_program("info", "escape.json")
        self.assertNotIn("\x1b", done.stdout + done.stderr)
        for name in ("no\x1b[2J.esm", "no\x9b2J.esm", b"no\x9b2J.esm"):  # CSI in 7 bits, as UTF-8, in 8 bits
            done = subprocess.run([PROGRAM, "info", name, "--json"], cwd=self.folder, capture_output=True, check=False)
            self.assertNotRegex((done.stdout + done.stderr).decode(), "[\x00-\x09\x0b-\x1f\x7f-\x9f]")
            self.assertIn("error", json.loads(done.stdout))

    def test_a_full_standard_output_is_a_failure(self):
        with open("/dev/full", "w", encoding="utf-8") as full:
            done = subprocess.run([PROGRAM, "info", "osc.json"], cwd=self.folder, stdout=full,
                                  stderr=subprocess.PIPE, text=True, timeout=60, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertIn("standard output", done.stderr)

    def test_with_json_an_error_is_an_object_too(self):
        for arguments, exit_code in ((("info", "absent.esm"), 1), (("export", "osc.json", "-o", "x.nothing"), 1),
                                     (("simulate", "osc.json", "--duration", "long"), 2), (("inform", "osc.json"), 2),
                                     (("fuzzy", "check", "absent.fll"), 1), (("inspect", "absent.obj"), 1),
                                     (("import", "absent.obj", "-o", "x.esm"), 1), (("validate", "absent.esm"), 1)):
            with self.subTest(arguments):
                done = self.run_anyhow(*arguments, "--json")
                self.assertEqual(done.returncode, exit_code, done.stderr)
                answer = json.loads(done.stdout)
                self.assertEqual(answer["exit_code"], exit_code)
                self.assertIn(answer["error"], done.stderr)

    def test_a_mistyped_name_gets_the_nearest(self):
        for arguments, meant in ((("simlate", "osc.json"), "simulate"), (("exprot", "osc.json"), "export"),
                                 (("simulate", "osc.json", "--tolerence", "1e-3"), "--tolerance"),
                                 (("simulate", "osc.json", "--durat=1"), "--duration"),
                                 (("fuzzy", "eval", "x.fll", "--inn", "y"), "--in"),
                                 (("haptics", "slftest"), "selftest"), (("insp", "tet.obj"), "inspect")):
            with self.subTest(arguments):
                self.assertIn("did you mean " + meant + "?", self.refused(*arguments, exit_code=2))
        for arguments in (("zebra", "osc.json"), ("simulate", "osc.json", "--zebra")):
            with self.subTest(arguments):
                self.assertNotIn("did you mean", self.refused(*arguments, exit_code=2))

    def test_a_key_that_occurs_twice_is_refused(self):
        text = json.dumps(OSCILLATOR)
        self.write("twice.json", text[:-1] + ', "duration": 9.0}')
        self.assertIn('"duration" occurs twice', self.refused("validate", "twice.json"))

    @unittest.skipIf(b"__asan_init" in pathlib.Path(PROGRAM).read_bytes(), "the sanitizer reserves terabytes")
    def test_too_little_memory_is_said(self):
        count = 400_000
        net = {**OSCILLATOR, "nodes": {"position": [0.125] * 3 * count, "mass": [1.5] * count, "fixed": [0]}}
        self.write("big.json", json.dumps(net))
        for megabytes in (40, 60, 80, 100, 120):  # below what the text and its tree take
            with self.subTest(megabytes):
                done = subprocess.run(["prlimit", f"--as={megabytes * 1000 * 1000}", PROGRAM, "validate", "big.json"],
                                      cwd=self.folder, capture_output=True, text=True, timeout=60, check=False)
                self.assertEqual(done.returncode, 4, done.stderr)
                self.assertIn("not enough memory", done.stderr)

    def test_the_next_run_sweeps_what_a_killed_one_left(self):
        running = subprocess.Popen([PROGRAM, "simulate", "osc.json", "--step", "1e-13", "--duration", "1000",
                                    "-o", "m.csv"], cwd=self.folder, stderr=subprocess.DEVNULL)
        self.addCleanup(running.wait)
        self.addCleanup(running.kill)
        while not any("esm-tmp" in name for name in os.listdir(self.folder)):
            self.assertIsNone(running.poll())
            time.sleep(0.01)
        self.run_program("simulate", "osc.json", "-o", "n.csv")
        self.assertTrue(any("esm-tmp" in name for name in os.listdir(self.folder)), "it still runs")
        running.kill()
        running.wait()
        self.run_program("simulate", "osc.json", "-o", "n.csv")
        self.assertEqual(sorted(os.listdir(self.folder)), ["n.csv", "osc.json", "tet.obj"])


if __name__ == "__main__":
    unittest.main()
