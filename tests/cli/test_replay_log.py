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

    def test_an_interval_that_was_edited_is_refused(self):
        self.run_program("simulate", "osc.json", "--duration", "0.1", "--log", "r.esmlog")
        text = (self.folder / "r.esmlog").read_text(encoding="utf-8")
        intervals = list(re.finditer(r'"interval": ([\d.e-]+)', text))
        for entry in (intervals[0], intervals[2], intervals[-1]):
            self.write("long.esmlog", text[:entry.start(1)] + "9e5" + text[entry.end(1):])
            refusal = self.refused("replay-log", "long.esmlog")
            self.assertRegex(refusal, r"long\.esmlog, entry \d+: its interval of 900000 s .* might not end")
        self.run_program("simulate", "osc.json", "--duration", "0.1", "--frames", "10", "--log", "one.esmlog")
        for name in ("r.esmlog", "one.esmlog"):
            text = (self.folder / name).read_text(encoding="utf-8")
            self.write("long.esmlog", re.sub(r'"interval": [\d.e-]+', '"interval": 9e5', text))
            self.assertIn("might not end", self.refused("replay-log", "long.esmlog"))
        # a call that asks for more than all others, and moves on by it, is sound
        self.run_program("simulate", "osc.json", "--duration", "50", "--frames", "0.02", "--log", "slow.esmlog")
        self.run_program("replay-log", "slow.esmlog")

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
