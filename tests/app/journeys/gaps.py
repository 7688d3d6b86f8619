# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Two rules are deleted: the list of problems names the gap, a double click sets the sliders to it, the output
takes its default and everything stays a number; two undos bring all back."""
import math

from window import MAIN, click, focus, keys, picture, place, run, state, until, xdo


def journey():
    fresh = until("the window shows the project", lambda s: s["nodes"] > 0 and "problemsNone" in s["widgets"])
    focus(MAIN)

    # The rules of 'medium' and 'firm' (fourth and fifth) go in one step
    click("rulesTabs0")
    click("rulesTable", 0.3, 40.0 / place_height("rulesTable"))
    keys("ctrl+Home", "Down", "Down", "Down", "shift+Down", "Delete")
    gap = until("the gap is listed", lambda s: len(s["items"]["problemsList"]) == 1)
    sentence = gap["items"]["problemsList"][0][0]
    assert gap["ruleCount"] == fresh["ruleCount"] - 2 and gap["undoCount"] == 1, (gap["ruleCount"], gap["undoCount"])
    assert "Steifigkeit" in sentence and "Härte" in sentence and "0,58" in sentence, sentence
    assert gap["texts"]["problemsCount"] == "1", gap["texts"]["problemsCount"]
    picture("listed")

    # A double click goes there
    xdo("mousemove", *place("problemsList", 0.5, 12.0 / place_height("problemsList")))
    xdo("click", "--repeat", 2, "--delay", 80, 1)
    there = until("the slider is at the gap", lambda s: abs(float(s["inputs"]["hardness"]) - 3.5 / 6) < 1e-9)
    assert there["undoCount"] == 2, there["undoCount"]
    shown = until("the default is marked", lambda s: "Steifigkeit" in s["texts"]["rulesProblems"])
    assert "31,6\u00a0kPa" in shown["texts"]["rulesProblems"], shown["texts"]["rulesProblems"]
    # 31.6 kPa is what the middle of the slider gave, too: the springs are as stiff as at the start, to rounding
    assert math.isclose(shown["meanStiffness"], fresh["meanStiffness"], rel_tol=1e-9), shown["meanStiffness"]
    picture("there")

    # It runs: nothing is NaN
    click("tool_actPlay")
    until("it plays", lambda s: s["playing"] and s["time"] > 0.05)
    assert state()["stability"] in ("good", "implicit", "rough", "slow"), state()["stability"]
    click("tool_actPlay")
    until("it is paused", lambda s: not s["playing"])

    # Two undos, and the list is empty
    click("view3d", 0.02, 0.02)
    keys("ctrl+z", "ctrl+z")
    back = until("no problem is left", lambda s: s["undoIndex"] == 0 and "problemsNone" in s["widgets"]
                 and s["texts"]["problemsNone"])
    assert back["meanStiffness"] == fresh["meanStiffness"] and back["inputs"] == fresh["inputs"]
    assert "problemsCount" not in back["widgets"]
    picture("healed")


def place_height(name):
    return until(f"{name} can be seen", lambda s: name in s["widgets"])["widgets"][name][3]


run(journey, language="de")
