#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
"""esm simulate --log and esm replay-log: a run is repeated to the bit, and a difference is named."""
import re
import unittest

from program import SOURCE, ProgramTest


class ReplayLog(ProgramTest):
    def test_a_run_is_repeated_to_the_bit_on_any_number_of_threads(self):
        self.run_program("apply", SOURCE / "resources/samples/fallopian_tube.esm", "-o", "poked.esm", "--poke",
                         "0,0,0.01,0,0,-0.2,0.02")
        self.run_program("simulate", "poked.esm", "--duration", "0.2", "--log", "r.esmlog", "-o", "m.csv")
        self.run_program("simulate", "poked.esm", "--duration", "0.2", "-o", "without.csv")
        self.assertEqual((self.folder / "m.csv").read_bytes(), (self.folder / "without.csv").read_bytes())
        for threads in (1, 2):
            done = self.json_of("replay-log", "r.esmlog", "--threads", threads)
            self.assertIs(done["same"], True)
            self.assertIs(done["whole"], True)
            self.assertEqual(done["advances"], 12)
            self.assertAlmostEqual(done["simulated_time"], 0.2)
        self.run_program("replay-log", "r.esmlog", "--project", "again.esm")
        self.assertEqual(self.read_json("again.esm")["net"], self.read_json("poked.esm")["net"])

    def test_a_difference_is_named_with_its_entry(self):
        self.run_program("simulate", "osc.json", "--duration", "0.1", "--log", "r.esmlog")
        text = (self.folder / "r.esmlog").read_text(encoding="utf-8")
        self.write("other.esmlog", text.replace('"stiffness": 100', '"stiffness": 101', 1))
        done = self.run_program("replay-log", "other.esmlog", exit_code=3)
        self.assertRegex(done.stderr, r"other\.esmlog, entry \d+: ")
        steps = re.search(r'"stretches": \[\[[^,]+, [^,]+, (\d+)', text)
        wrong = text[:steps.start(1)] + str(int(steps.group(1)) + 1) + text[steps.end(1):]
        self.write("steps.esmlog", wrong)
        self.assertIn("the log says", self.run_program("replay-log", "steps.esmlog", exit_code=3).stderr)

    def test_what_is_no_log_and_outputs_that_are_none_are_refused(self):
        self.assertIn("is no log", self.run_program("replay-log", "osc.json", exit_code=1).stderr)
        self.run_program("replay-log", "absent.esmlog", exit_code=1)
        self.run_program("simulate", "osc.json", "--log", "/dev/null", exit_code=1)
        self.run_program("simulate", "osc.json", "--log", "osc.json", exit_code=2)
        self.run_program("simulate", "osc.json", "--log", "r.esmlog", "--verify", exit_code=2)

    def test_a_log_that_was_cut_off_is_replayed_up_to_there(self):
        self.run_program("simulate", "osc.json", "--duration", "0.1", "--log", "r.esmlog")
        whole = (self.folder / "r.esmlog").read_bytes()
        for lines in (1, 3):  # the end alone, and two calls
            self.write("cut.esmlog", b"".join(whole.splitlines(keepends=True)[:-lines]))
            self.assertIn("killed", self.run_program("replay-log", "cut.esmlog").stderr)
            self.assertIs(self.json_of("replay-log", "cut.esmlog")["whole"], False)


if __name__ == "__main__":
    unittest.main()
