#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
"""Tables and rule files as spreadsheets and other programs write them, through the program."""
import csv
import io
import unittest

from program import SOURCE, ProgramTest

# y is 2 where x is 0 and 6 where it is 10, and straight between.
RULES = """FUNCTION_BLOCK first
VAR_INPUT
  x : REAL;
END_VAR
VAR_OUTPUT
  y : REAL;
END_VAR
FUZZIFY x
  TERM a := (0, 1) (10, 0);
  TERM b := (0, 0) (10, 1);
END_FUZZIFY
DEFUZZIFY y
  TERM low := 2;
  TERM high := 6;
  METHOD : COGS;
END_DEFUZZIFY
RULEBLOCK one
  AND : MIN;
  RULE 1 : IF x IS a THEN y IS low;
  RULE 2 : IF x IS b THEN y IS high;
END_RULEBLOCK
END_FUNCTION_BLOCK
"""

# A triangle of which one sample takes the middle: 4; three samples and the exact centroid (3) differ.
SAMPLED = """Engine: e
InputVariable: x
  range: 0 1
  term: on Ramp 0 1
OutputVariable: y
  range: 0 8
  aggregation: Maximum
  defuzzifier: Centroid %d
  term: t Triangle 0 1 8
RuleBlock: r
  implication: Minimum
  activation: General
  rule: if x is on then y is t
"""


class Tables(ProgramTest):
    def outputs(self, table, system="rules.fcl", *more):
        """The table that `fuzzy eval` makes of `table`, as rows of cells."""
        self.write("rows.csv", table)
        out = self.run_program("fuzzy", "eval", system, "--in", "rows.csv", *more).stdout
        separator = ";" if ";" in out.splitlines()[0] else "\t" if "\t" in out.splitlines()[0] else ","
        return list(csv.reader(io.StringIO(out), delimiter=separator))

    def setUp(self):
        super().setUp()
        self.write("rules.fcl", RULES)

    def test_rows_in_every_style_give_the_same_outputs(self):
        for table in ("in:x,note\n2.5,a\n5,b\n", "in:x;note\n2,5;a\n5;b\n", "in:x\tnote\r\n2,5\ta\r\n5\tb\r\n",
                      '"in:x","note"\n"2.5","a"\n"5","b"\n', '"in:x","note"\n"2,5","a"\n"5","b"\n',
                      "\ufeff in:x , note \n\n 2.5 , a \n,\n5 , b\n\n", "sep=;\nin:x;note;\n2,5;a;\n5;b;\n"):
            rows = self.outputs(table)
            self.assertEqual([row[-1] for row in rows], ["out:y", "3", "4"], table)
            self.assertEqual([row[1] for row in rows], ["note", "a", "b"], table)

    def test_one_column_may_hold_decimal_commas(self):
        for table in ('in:x\n"2,5"\n5\n', "in:x\n2,5\n5\n"):
            self.assertEqual(self.outputs(table), [["in:x", "out:y"], ["2,5", "3"], ["5", "4"]])

    def test_quotes_and_what_is_in_them_come_out_as_they_went_in(self):
        rows = self.outputs('in:x,note\n2.5,"soft, wet"\n5,"say ""hard"""\n\n')
        self.assertEqual(rows, [["in:x", "note", "out:y"], ["2.5", "soft, wet", "3"], ["5", 'say "hard"', "4"]])

    def test_outputs_have_the_decimal_sign_of_the_table(self):
        self.assertEqual(self.outputs("in:x;n\n5;1\n1,25;2\n")[2][2], "2,5")
        self.assertEqual(self.outputs("in:x;n\n1.25;2\n")[1][2], "2.5")
        self.assertEqual(self.outputs("in:x;n\n2,5..2,5;2\n")[1][2], "3")

    def test_doubtful_commas_are_named(self):
        self.write("rows.csv", "in:x,note\n2,5,a\n")
        self.assertIn("are there decimal commas?", self.refused("fuzzy", "eval", "rules.fcl", "--in", "rows.csv"))
        self.write("rows.csv", 'in:x,note\n"2,500",a\n')
        self.assertIn("may be 2.5 or 2500", self.refused("fuzzy", "eval", "rules.fcl", "--in", "rows.csv"))
        self.write("rows.csv", "in:x,note\nwet,a\n")
        self.assertEqual(self.refused("fuzzy", "eval", "rules.fcl", "--in", "rows.csv"),
                         "esm: rows.csv:2: column 1: 'wet' is no number, no interval low..high and no term of 'x'")

    def test_a_hand_path_with_decimal_commas_leads_the_hand(self):
        style = ("t;x;y;z\n" + "".join(f"{t / 100};0,0;0,009;0,084\n" for t in range(7))).replace(".", ",")
        self.write("a.csv", style)
        self.write("b.csv", style.replace(",", ".").replace(";", ", "))
        said = [self.json_of("haptics", "replay", name, SOURCE / "resources/samples/uterus.esm") for name in ("a.csv", "b.csv")]
        self.assertEqual(said[0]["tip"], said[1]["tip"])


class RuleFiles(ProgramTest):
    def test_a_second_block_is_chosen_or_named(self):
        second = RULES.replace("first", "second").replace(":= 2", ":= 20").replace(":= 6", ":= 60")
        self.write("two.fcl", RULES + second)
        self.write("rows.csv", "in:x\n2.5\n")
        done = self.run_program("fuzzy", "eval", "two.fcl", "--in", "rows.csv")
        self.assertEqual(done.stdout, "in:x,out:y\n2.5,3\n")
        self.assertIn("'first' is read, not 'second'", done.stderr)
        done = self.run_program("fuzzy", "eval", "two.fcl", "--block", "second", "--in", "rows.csv")
        self.assertEqual((done.stdout, done.stderr), ("in:x,out:y\n2.5,30\n", ""))
        self.assertEqual(len(self.json_of("fuzzy", "check", "two.fcl")["notes"]), 1)
        self.run_program("fuzzy", "convert", "two.fcl", "one.fll", "--block", "2")
        self.assertEqual(self.run_program("fuzzy", "eval", "one.fll", "--in", "rows.csv").stdout, "in:x,out:y\n2.5,30\n")
        self.assertIn("only FCL", self.refused("fuzzy", "check", "one.fll", "--block", "2"))

    def test_a_file_is_evaluated_with_its_own_resolution(self):
        self.write("rows.csv", "in:x\n1\n")
        value = lambda *more: float(self.run_program("fuzzy", "eval", "e.fll", "--in", "rows.csv", *more).stdout.split(",")[-1])
        for samples in (1, 3):
            self.write("e.fll", SAMPLED % samples)
            self.assertEqual(value("--resolution", "file"), value("--resolution", samples))
        self.write("e.fll", SAMPLED % 1)
        self.assertAlmostEqual(value(), 3.0, places=12)  # the centroid of a triangle: (0 + 1 + 8) / 3
        self.assertEqual(value("--resolution", "file"), 4.0)


if __name__ == "__main__":
    unittest.main()
