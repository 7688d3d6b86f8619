# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""In German: steps, a rule with a mistake, the question at closing; then the process is killed, and the next start
offers what was lost and brings it back."""
import os
import shutil

import window
from window import JOURNALS, MAIN, OUT, click, drag, focus, keys, picture, place, run, start, state, until, write


def begin(*arguments):
    start(*arguments, language="de", forget=False)
    return focus(MAIN)


def shut():
    window.program.wait(timeout=window.PATIENCE)


def journey():
    fresh = until("the window shows the project", lambda s: s["nodes"] > 0 and s["language"] == "de")
    focus(MAIN)
    assert not os.path.exists(JOURNALS) or not os.listdir(JOURNALS), "looking at a project leaves nothing behind"

    # Two steps, and a rule with a mistake
    middle = place("slider_hardness", 0.5)
    drag(middle, (place("slider_hardness", 0.9)[0], middle[1]))
    until("a step", lambda s: s["undoCount"] == 1)
    drag((place("slider_hardness", 0.9)[0], middle[1]), (place("slider_hardness", 0.7)[0], middle[1]))
    until("another step", lambda s: s["undoCount"] == 2)
    click("rulesTabs1")
    click("rulesText", 0.5, 0.8)
    keys("ctrl+End", "Return")
    write("WENN Härte IST sehr hart DANN Steifigkeit IST hohc")
    keys("Escape")
    typed = until("the mistake is unsaved work", lambda s: "hohc" in s["texts"]["rulesTextMessage"] and s["modified"])

    # Closing asks, and says what the matter is
    keys("ctrl+q")
    until("it is asked about", lambda s: s["dialog"] == "dlgUnsaved")
    picture("closing")
    keys("Escape")
    until("the window stays", lambda s: s["dialog"] == "")

    # The process dies; the next start offers its work
    window.program.kill()
    shut()
    assert len(os.listdir(JOURNALS)) == 1, os.listdir(JOURNALS)
    begin(OUT / "recovery.esm")
    offered = until("the work is offered", lambda s: s["dialog"] == "dlgRecovery")
    picture("offer")
    row = offered["items"]["recoveryList"][0][0]
    assert "2 Schritte nach dem letzten Speichern, eine Regel in Arbeit" in row, row
    focus("Nicht gespeicherte Arbeit")
    click("recoveryRecover")
    back = until("it is back", lambda s: s["dialog"] == "" and s["modified"] and s["nodes"] == fresh["nodes"])
    assert back["inputs"] == typed["inputs"], (back["inputs"], typed["inputs"])
    assert back["meanStiffness"] == typed["meanStiffness"]
    focus(MAIN)
    click("rulesTabs1")
    until("the rule with its mistake too", lambda s: s["texts"]["rulesText"] == typed["texts"]["rulesText"])
    picture("recovered")

    # The mistake is mended, all is saved: nothing is left to be offered
    click("rulesTextCure")
    until("the rule is there", lambda s: s["ruleCount"] == fresh["ruleCount"] + 1)
    keys("ctrl+s")
    until("it is saved", lambda s: not s["modified"])
    window.program.kill()
    shut()
    assert not os.listdir(JOURNALS), os.listdir(JOURNALS)
    begin(OUT / "recovery.esm")
    until("nothing is asked", lambda s: s["dialog"] == "" and s["ruleCount"] == fresh["ruleCount"] + 1)


shutil.copy(OUT / "start.esm", OUT / "recovery.esm")
run(journey, project="recovery.esm", language="de")
