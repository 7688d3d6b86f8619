#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
"""Every line of tests/data/own_examples/README.md through the program."""
import csv
import io
import json
import re
import shutil
import unittest

from program import SOURCE, ProgramTest

EXAMPLES = SOURCE / "tests" / "data" / "own_examples"


def table():
    """Rows (inputs, flags, right, said, not said)."""
    rows = []
    for line in (EXAMPLES / "README.md").read_text(encoding="utf-8").splitlines():
        cells = [cell.strip() for cell in line.strip("|").split(" | ")]
        if not line.startswith("| `"):
            continue
        said, _, unsaid = cells[2].partition("not `") if not cells[2].startswith("`not") else (cells[2], "", "")
        rows.append((re.findall("`(.*?)`", cells[0]), cells[0].split("`")[-1].split(), cells[1],
                     re.findall("`(.*?)`", said), re.findall("(.*?)`", unsaid)[:1]))
    return rows


class OwnExamples(ProgramTest):
    def setUp(self):
        super().setUp()
        shutil.copytree(EXAMPLES, self.folder / "examples")
        shutil.copytree(SOURCE / "tests" / "data" / "meshes", self.folder / "meshes")  # what may not be opened

    def numbers(self, done):
        """Nodes, springs and box in mm, as an import tells them."""
        made = json.loads(done.stdout.splitlines()[-1])
        box = made["after"]["bbox_min"] + made["after"]["bbox_max"]
        return made["nodes"], made["springs"], [1000 * x for x in box]

    def check_mesh(self, name, flags, right):
        choices = ("--unit", "mm", *flags)
        looked = self.run_anyhow("inspect", name, *choices, "--json")
        done = self.run_anyhow("import", name, "-o", "made.esm", *choices, "--json")
        if right == "refused":
            self.assertEqual((looked.returncode, done.returncode), (1, 1), done.stdout)
            return done.stderr
        self.assertEqual((looked.returncode, done.returncode), (0, 0), looked.stderr + done.stderr)
        nodes, springs, box = self.numbers(done)
        self.assertEqual(self.numbers(looked), (nodes, springs, box))
        due = re.fullmatch(r"(\d+) nodes, (\d+) springs(?:, box (.*) to (.*))?", right)
        self.assertEqual((nodes, springs), (int(due[1]), int(due[2])), done.stderr)
        if due[3]:
            want = [float(x) for x in (due[3] + " " + due[4]).split()]
            for got, x in zip(box, want):
                self.assertAlmostEqual(got, x, delta=2e-6 * max(map(abs, want)))  # float32 in foreign formats
        return done.stderr

    def check_rules(self, system, rows, flags, right):
        done = self.run_anyhow("fuzzy", "eval", system, "--in", rows, *flags)
        if right == "refused":
            self.assertEqual(done.returncode, 1, done.stdout)
            return done.stderr
        self.assertEqual(done.returncode, 0, done.stderr)
        separator = ";" if ";" in done.stdout.splitlines()[0] else ","
        values = [float(row[-1].replace(",", ".")) for row in csv.reader(io.StringIO(done.stdout), delimiter=separator)
                  if row[-1] != "out:y"]
        due = [float(x) for x in right.split(", ")]
        self.assertEqual(len(values), len(due))
        for got, x in zip(values, due):
            self.assertAlmostEqual(got, x, delta=1e-12)
        return done.stderr

    def test_every_line_of_the_table(self):
        for inputs, flags, right, said, unsaid in table():
            names = ["examples/" + name for name in inputs]
            with self.subTest(names + flags):
                told = (self.check_rules(*names, flags, right) if len(names) == 2 else
                        self.check_mesh(names[0], flags, right))
                for words in said:
                    self.assertIn(words, told)
                for words in unsaid:
                    self.assertNotIn(words, told)

    def test_every_file_is_in_the_table(self):
        named = {name for inputs, *_ in table() for name in inputs}
        there = {path.name for path in EXAMPLES.iterdir() if path.is_file()} - {"README.md"}
        self.assertEqual(named, there)
        self.assertGreater(len(named), 20)


if __name__ == "__main__":
    unittest.main()
