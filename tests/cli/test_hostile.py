#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
"""Mutated and truncated projects through the real program: exit 1 and one line each, never a crash."""
import random
import unittest

from program import ProgramTest


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


if __name__ == "__main__":
    unittest.main()
