#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
"""`esm explain`: the numbers are the project's, a change that it suggests does what it says, faults are one line."""
import csv
import io
import json
import math
import unittest

from program import SOURCE, ProgramTest


def no_constants(name):
    raise ValueError(name)


class Explain(ProgramTest):
    def setUp(self):
        super().setUp()
        self.run_program("import", SOURCE / "resources/samples/fallopian_tube.obj", "-o", "tube.esm", "--unit", "mm")
        self.run_program("apply", "tube.esm", "-o", "p.esm", "--region", "0.03,0,0,0.02,0.01,0.01",
                         "--set", "hardness=0.8")
        self.project = self.read_json("p.esm")

    def explain(self, *arguments):
        return self.json_of("explain", "p.esm", *arguments)

    def test_every_number_is_that_of_the_project(self):
        stiffness = self.project["net"]["springs"]["stiffness"]
        for spring in range(0, len(stiffness), 97):
            why = self.explain("--spring", spring)
            self.assertEqual(why["values"]["stiffness"]["value"], stiffness[spring])
            self.assertEqual(why["values"]["stiffness"]["from_tissue"], stiffness[spring])
            geometry = why["geometry"]
            by_formula = (why["parameters"]["youngs_modulus"] * geometry["thickness"] * geometry["area"]
                          / geometry["length"] ** 2)
            self.assertAlmostEqual(by_formula / stiffness[spring], 1, places=13)
            self.assertAlmostEqual(sum(layer["share"] for layer in why["layers"]), 1, places=13)
            logarithm = sum(layer["share"] * math.log(layer["outputs"][0]["value"]) for layer in why["layers"])
            self.assertAlmostEqual(math.exp(logarithm) / why["parameters"]["youngs_modulus"], 1, places=12)
        masses = self.project["net"]["nodes"]["mass"]
        for node in range(0, len(masses), 57):
            self.assertEqual(self.explain("--node", node)["values"]["mass"]["value"], masses[node])

    def test_a_suggested_change_does_what_it_says(self):
        blended = next(spring for spring in range(len(self.project["net"]["springs"]["stiffness"]))
                       if spring % 13 == 0 and len(self.explain("--spring", spring)["layers"]) == 2)
        why = self.explain("--spring", blended, "--change", "0.8")
        before = why["values"]["stiffness"]["value"]
        reached = [change for change in why["change"]["inputs"] if change["reached"]]
        self.assertTrue(reached)
        for change in reached:
            project = self.read_json("p.esm")
            inputs = project["regions"][change["region"] - 1]["inputs"] if change["region"] else project["inputs"]
            inputs[change["input"]] = change["to"]
            self.write("changed.esm", json.dumps(project))
            self.run_program("apply", "changed.esm", "-o", "q.esm")
            after = self.read_json("q.esm")["net"]["springs"]["stiffness"][blended]
            self.assertAlmostEqual(after / before, 0.8, delta=0.008)
            self.assertAlmostEqual(after / before / change["factor"], 1, places=12)

    def test_the_table_holds_the_same(self):
        done = self.run_program("explain", "p.esm", "--spring", 400, "--csv", "--change", "1.3")
        rows = list(csv.DictReader(io.StringIO(done.stdout, newline="")))
        why = self.explain("--spring", 400, "--change", "1.3")
        self.assertEqual(rows[0]["text"], why["sentence"])
        value = next(row for row in rows if row["part"] == "value")
        self.assertEqual((value["name"], float(value["value"])), ("stiffness", why["values"]["stiffness"]["value"]))
        shares = [float(row["value"]) for row in rows if row["part"] == "layer"]
        self.assertEqual(shares, [layer["share"] for layer in why["layers"]])
        degrees = [float(row["value"]) for row in rows if row["part"] == "rule"]
        self.assertEqual(degrees, [rule["degree"] for layer in why["layers"] for output in layer["outputs"]
                                   for rule in output["rules"]])
        changes = [float(row["other"]) for row in rows if row["part"] == "change"]
        self.assertEqual(changes, [change["to"] for change in why["change"]["inputs"]])

    def test_json_is_as_its_schema_says(self):
        schema = json.loads((SOURCE / "docs/explain.schema.json").read_text(encoding="utf-8"))
        for arguments in (["--spring", 5, "--change", "0.5"], ["--node", 7], ["--region", 1], ["--region", 0]):
            text = self.run_program("explain", "p.esm", "--json", *arguments).stdout
            why = json.loads(text, parse_constant=no_constants)
            self.assertLessEqual(set(schema["required"]), set(why))
            self.assertLessEqual(set(why), set(schema["properties"]))
            for layer in why["layers"]:
                self.assertEqual(set(layer), set(schema["$defs"]["layer"]["properties"]))

    def test_words_for_people_in_both_languages(self):
        english = self.run_program("explain", "p.esm", "--spring", 5).stdout
        german = self.run_program("explain", "p.esm", "--spring", 5, "--lang", "de").stdout
        self.assertTrue(english.startswith("Spring 5 has "), english)
        self.assertTrue(german.startswith("Feder 5 hat "), german)
        self.assertIn("WENN Härte IST", german)

    def test_a_net_with_numbers_of_its_own_says_so(self):
        why = self.json_of("explain", "osc.json", "--spring", 0)
        self.assertIs(why["follows_tissue"], False)
        self.assertEqual(why["values"]["stiffness"]["value"], 100)
        self.assertIn("from its file", why["sentence"])

    def test_faults_are_one_line_that_says_what_there_is(self):
        self.assertIn("0 to 1193", self.refused("explain", "p.esm", "--spring", 1194))
        self.assertIn("0 to 399", self.refused("explain", "p.esm", "--node", 5000))
        self.assertIn("has 1", self.refused("explain", "p.esm", "--region", 2))
        self.assertIn("viscosity", self.refused("explain", "p.esm", "--spring", 1, "--change", 2, "--of", "colour"))
        self.assertIn("absent.esm", self.refused("explain", "absent.esm", "--node", 1))
        for arguments in ([], ["--spring", 1, "--node", 1], ["--spring", -1], ["--spring", "1.5"],
                          ["--spring", 1, "--change", "-1"], ["--spring", 1, "--change", "0,8"],
                          ["--spring", 1, "--lang", "fr"], ["--spring", 1, "--json", "--csv"]):
            with self.subTest(arguments):
                self.refused("explain", "p.esm", *arguments, exit_code=2)


if __name__ == "__main__":
    unittest.main()
