# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A rule written in German, with a mistake: it is marked and changes nothing, its cure makes it a rule that
fires, and the same rule reads English after the language of the window is changed."""
import time

from window import MAIN, click, focus, keys, picture, place, drag, run, state, until, write


def number(text):
    return float(text.replace(",", "."))


def journey():
    fresh = until("the window shows the project", lambda s: s["nodes"] > 0 and s["language"] == "de")
    focus(MAIN)

    # A word that is none is marked; the model stays as it was
    click("rulesTabs1")
    click("rulesText", 0.5, 0.8)
    keys("ctrl+End", "Return")
    write("WENN Härte IST sehr hart DANN Steifigkeit IST hohc")
    keys("Escape")
    marked = until("the mistake is named", lambda s: "hohc" in s["texts"]["rulesTextMessage"])
    assert "rulesTextCure" in marked["widgets"], "no cure is offered"
    time.sleep(1.5)  # longer than the pause after which a text is taken
    assert state()["undoCount"] == 0 and state()["meanStiffness"] == fresh["meanStiffness"], state()["undoCount"]
    picture("mistake")

    # The cure takes the word that was meant
    click("rulesTextCure")
    cured = until("the rule is there", lambda s: s["ruleCount"] == fresh["ruleCount"] + 1)
    assert cured["rules"][-1] == "IF hardness IS very hard THEN stiffness IS high", cured["rules"][-1]
    assert cured["texts"]["rulesText"].splitlines()[-1].endswith("Steifigkeit IST hoch"), cured["texts"]["rulesText"]

    # Hard tissue makes it fire
    middle = place("slider_hardness", 0.5)
    drag(middle, (place("slider_hardness", 0.97)[0], middle[1]))
    click("rulesTabs0")
    fires = until("the rule fires", lambda s: number(s["items"]["rulesTable"][-1][4]) > 0.5)
    assert "sehr hart" in fires["items"]["rulesTable"][-1][1], fires["items"]["rulesTable"][-1]
    picture("fires")

    # The same rule in English
    keys("alt+a", "Up", "Up", "Right", "Down", "Return")  # View, Language, English
    english = until("the window speaks English", lambda s: s["language"] == "en")
    assert english["ruleCount"] == cured["ruleCount"]
    row = until("the rule is English", lambda s: "very hard" in s["items"]["rulesTable"][-1][1])["items"]["rulesTable"][-1]
    assert row[1:3] == ["hardness IS very hard", "stiffness IS high"], row
    click("rulesTabs1")
    until("the text is English", lambda s: s["texts"]["rulesText"].splitlines()[-1]
          == "IF hardness IS very hard THEN stiffness IS high")
    assert state()["undoCount"] == 2, state()["undoCount"]  # the rule and the drag; a language is no edit
    picture("english")

    # As a matrix: wall down, hardness across. A cell's own rule stands before those that cover its row.
    click("rulesTabs2")
    matrix = until("the matrix is there", lambda s: len(s["items"]["rulesMatrix"]) == 4)["items"]["rulesMatrix"]
    assert matrix[3][0].startswith("high") and "(medium)" in matrix[3][0] and matrix[0][0] == "(low)", matrix
    click("matrixOutput")
    write("visc")
    keys("Return")
    holes = until("viscosity is shown", lambda s: s["items"]["rulesMatrix"][0][0] == "")
    assert holes["items"]["rulesMatrix"][3][1].startswith("high"), holes["items"]["rulesMatrix"]
    assert sum(cell != "" for row in holes["items"]["rulesMatrix"] for cell in row) == 1, holes["items"]["rulesMatrix"]

    # A word is chosen in an empty cell by keys: a rule
    click("rulesMatrix", 0.12, 0.25)
    keys("Home", "ctrl+Home", "Return")
    time.sleep(0.5)
    keys("Down", "Return")
    written = until("the cell has its rule", lambda s: s["items"]["rulesMatrix"][0][0] == "very low")
    assert written["rules"][-1] == "IF wall IS hollow AND hardness IS soft THEN viscosity IS very low", written["rules"][-1]
    assert written["undoCount"] == 3, written["undoCount"]
    picture("matrix")


run(journey, language="de")
