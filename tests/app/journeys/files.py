# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A project that somebody else saves meanwhile is not overwritten without a question. Before that it is opened, and pulled
at while it is paused. In German."""
import json
import time

from window import MAIN, OUT, click, drag, focus, keys, picture, run, state, until

PROJECT = OUT / "files.esm"


def as_on_disk():
    return json.loads(PROJECT.read_text())


def save_as_somebody_else(name):
    other = as_on_disk()
    other["name"] = name
    PROJECT.write_text(json.dumps(other))


def journey():
    until("the window shows the project", lambda s: s["nodes"] > 0 and not s["playing"])
    focus(MAIN)
    picture("opened")
    keys("e")
    start = until("a node can be pulled", lambda s: s["pullPoint"])["pullPoint"]
    drag(start, (start[0] + 30, start[1] - 30), hold=True)
    until("the node is held", lambda s: s["grabbedNode"] >= 0)
    picture("paused-pull")
    drag((start[0] + 30, start[1] - 30), start)

    before = len(state()["regions"])
    keys("ctrl+shift+r")  # an edit
    until("it is modified", lambda s: s["modified"])
    save_as_somebody_else("theirs")
    keys("ctrl+s")
    until("it asks", lambda s: s["dialog"] == "dlgOtherVersion" and "otherVersionOverwrite" in s["widgets"])
    time.sleep(0.5)
    picture("other-version")
    keys("Escape")
    until("nothing is saved", lambda s: s["dialog"] == "" and s["modified"])
    assert as_on_disk()["name"] == "theirs"
    focus(MAIN)
    keys("ctrl+s")
    until("it asks again", lambda s: s["dialog"] == "dlgOtherVersion" and "otherVersionOverwrite" in s["widgets"])
    click("otherVersionOverwrite")
    until("it is saved", lambda s: s["dialog"] == "" and not s["modified"])
    assert as_on_disk()["name"] != "theirs" and len(as_on_disk()["regions"]) == before + 1
    assert json.loads((OUT / "files.esm.other.bak").read_text())["name"] == "theirs"
    focus(MAIN)
    keys("ctrl+shift+r", "ctrl+s")
    until("its own version needs no question", lambda s: s["dialog"] == "" and not s["modified"] and len(s["regions"]) == before + 2)


(OUT / "files.esm.other.bak").unlink(missing_ok=True)  # of an earlier run
PROJECT.write_bytes((OUT / "start.esm").read_bytes())
run(journey, project="files.esm", language="de")
