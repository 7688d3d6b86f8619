#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
"""`esm inspect --json` against the generated mesh corpus (scripts/make_mesh_corpus.py): every count right, every refusal one
line with exit code 1, in less than 200 MB and 2 s of processor time (the limits do not hold under sanitizers)."""
import json
import os
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(os.environ["ESM_SOURCE_DIR"]) / "scripts"))
import make_mesh_corpus  # noqa: E402

ESM = os.environ["ESM"]
SANITIZED = bool(os.environ.get("ESM_SANITIZED"))
MOST_BYTES, MOST_SECONDS = 200e6, 2.0


class Run:
    """One `esm inspect --json FILE` and what it cost, the worker that it may start included."""

    def __init__(self, folder, name):
        with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
            child = os.fork()
            if child == 0:
                os.chdir(folder)
                os.dup2(out.fileno(), 1)
                os.dup2(err.fileno(), 2)
                os.execv(ESM, [ESM, "inspect", "--json", "./" + name])
            _, status, usage = os.wait4(child, 0)
            self.code = os.waitstatus_to_exitcode(status)
            out.seek(0)
            err.seek(0)
            self.out, self.err = out.read().decode(), err.read().decode()
        self.bytes = 1024 * usage.ru_maxrss
        self.seconds = usage.ru_utime + usage.ru_stime


class Corpus(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        cls.files = make_mesh_corpus.corpus()
        for name, (data, _) in cls.files.items():
            (cls.folder / name).parent.mkdir(parents=True, exist_ok=True)
            (cls.folder / name).write_bytes(data)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def test_is_large_enough(self):
        self.assertGreaterEqual(len(self.files), 120)
        self.assertGreaterEqual(sum("refused" in what for _, what in self.files.values()), 40)

    def test_counts_are_those_of_the_model(self):
        for name, (_, expected) in self.files.items():
            if "refused" in expected:
                continue
            with self.subTest(name):
                run = Run(self.folder, name)
                self.assertEqual(run.code, 0, run.err)
                found = json.loads(run.out.splitlines()[-1])
                for key, value in expected.items():
                    if key == "sum_rest_length":
                        self.assertAlmostEqual(found[key] / value, 1.0, delta=1e-12)  # a sum in another order
                    else:
                        self.assertEqual(found[key], value, f"{key} {found['notes']}")

    def test_refusals_are_one_line_and_cheap(self):
        for name, (_, expected) in self.files.items():
            if "refused" not in expected:
                continue
            with self.subTest(name):
                run = Run(self.folder, name)
                self.assertEqual(run.code, 1, run.out + run.err)
                self.assertEqual(run.err.count("\n"), 1, run.err)
                self.assertIn(expected["refused"], run.err)
                if not SANITIZED:
                    self.assertLess(run.bytes, MOST_BYTES)
                    self.assertLess(run.seconds, MOST_SECONDS)


if __name__ == "__main__":
    unittest.main()
