# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The whole way of a modeler: import, slider, a rule with a mistake and its cure, a region, play, pull, undo
to the start, save."""
import json
import time

import window
from window import MAIN, OUT, PATIENCE, SAMPLES, click, drag, focus, keys, picture, place, run, state, until, write, xdo


def journey():
    fresh = until("the window shows the project", lambda s: s["nodes"] > 0 and s["openGl"])
    assert not fresh["modified"] and fresh["undoCount"] == 0, fresh

    focus(MAIN)

    # Import: a file dialog, the report, one undo step
    keys("ctrl+i")
    until("the file dialog is open", lambda s: s["dialog"] == "QFileDialog")
    focus("Import mesh")
    write(SAMPLES / "gallbladder.obj")
    for pause in (1.0, 4.0):  # the first Return may go to the list of completions; a second one too soon, to the report
        time.sleep(pause)
        if state().get("dialog") == "QFileDialog":
            keys("Return")
    until("the report is there", lambda s: s["dialog"] == "dlgImport" and "importOk" in s["enabled"])
    picture("import")
    click("importOk")
    counts = json.loads((SAMPLES / "counts.json").read_text())
    counts = next(v for k, v in counts.items() if "gallbladder" in k)
    imported = until("the model is imported", lambda s: s["dialog"] == "" and s["undoCount"] == 1)
    assert imported["nodes"] == counts["nodes"], (imported["nodes"], counts["nodes"])
    assert imported["springs"] == counts["springs"], (imported["springs"], counts["springs"])

    focus(MAIN)

    # Slider: one drag, one step, stiffer springs
    left = place("slider_hardness", 0.5)
    drag(left, (place("slider_hardness", 0.97)[0], left[1]))
    harder = until("harder tissue", lambda s: s["undoCount"] == 2 and float(s["inputs"]["hardness"]) > 0.8)
    assert harder["meanStiffness"] > 1.5 * imported["meanStiffness"], (harder["meanStiffness"], imported["meanStiffness"])

    # Rule as text: a mistake changes nothing, its cure is one step
    click("rulesTabs1")
    keys("ctrl+End")
    click("rulesText", 0.5, 0.8)
    keys("ctrl+End", "Return")
    write("IF hardness IS very hard THEN youngs_modulus IS hihg")
    keys("Escape")
    until("the mistake is shown", lambda s: "rulesTextMessage" in s["widgets"])
    time.sleep(1.5)
    assert state()["undoCount"] == 2 and state()["ruleCount"] == fresh["ruleCount"], state()["undoCount"]
    picture("mistake")
    click("rulesTextCure")
    cured = until("the cure makes the rule", lambda s: s["ruleCount"] == fresh["ruleCount"] + 1)
    assert cured["undoCount"] == 3, cured["undoCount"]
    assert "very hard" in cured["rules"][-1] and "high" in cured["rules"][-1], cured["rules"][-1]

    # Region: a soft ball; its inputs are the target now
    click("regionAdd")
    until("the region is there", lambda s: len(s["regions"]) == 1 and s["target"] == 0)
    middle = place("slider_hardness", 0.97)
    drag(middle, (place("slider_hardness", 0.06)[0], middle[1]))
    softer = until("the region is softer", lambda s: s["undoCount"] == 5 and float(s["inputs"]["hardness"]) < 0.2)
    assert softer["meanStiffness"] < cured["meanStiffness"]
    picture("region")

    # Why: a click on the model explains the node, with the region's share
    click("tool_actToolSelect")
    point = until("there is something to select", lambda s: len(s["pullPoint"]) == 2)["pullPoint"]
    xdo("mousemove", *point)
    xdo("click", 1)
    until("the node is explained", lambda s: s["selectedNode"] >= 0 and s["why"].startswith("Node "))
    picture("why")

    # Play and pull: the force can be read
    click("tool_actPlay")
    until("it plays", lambda s: s["playing"] and s["time"] > 0)
    click("tool_actToolPull")
    point = until("there is something to pull", lambda s: len(s["pullPoint"]) == 2)["pullPoint"]
    drag(point, (point[0] + 60, point[1] - 110), hold=True)
    pulled = until("the hand feels a force", lambda s: s["forceNorm"] > 1e-4 and s["grabbedNode"] >= 0)
    assert pulled["stability"] in ("good", "implicit", "rough", "slow"), pulled["stability"]
    assert pulled["device"]["force"] == 0, pulled["device"]  # never armed
    time.sleep(1.0)
    picture("pull")
    xdo("mouseup", 1)
    until("letting go ends the force", lambda s: s["grabbedNode"] < 0 and s["forceNorm"] == 0)
    keys("Escape")
    click("tool_actPlay")
    until("it is paused", lambda s: not s["playing"])

    # Undo to the start, save: the file is what it was
    click("view3d", 0.02, 0.02)
    for _ in range(5):
        keys("ctrl+z")
    back = until("everything is undone", lambda s: s["undoIndex"] == 0)
    assert not back["modified"] and back["nodes"] == fresh["nodes"], back
    assert back["meanStiffness"] == fresh["meanStiffness"]
    keys("ctrl+s")
    until("the former file stays beside the saved one", lambda s: (OUT / "start.esm.bak").exists())
    before, after = (json.loads((OUT / name).read_text()) for name in ("start.esm.bak", "start.esm"))
    before.pop("view", None), after.pop("view", None)
    assert before == after, "the saved project differs from the one at the start"
    print("ok   undo to the start saves the same project")

    # A change is not lost without a question
    click("regionAdd")
    until("changed again", lambda s: s["modified"])
    keys("ctrl+q")
    until("it asks before closing", lambda s: s["dialog"] == "dlgUnsaved")
    focus("Unsaved changes")
    picture("unsaved")
    keys("Escape")
    until("cancel keeps the window", lambda s: s["dialog"] == "")
    focus(MAIN)
    keys("ctrl+z", "ctrl+q")
    assert window.program.wait(timeout=PATIENCE) == 0, window.program.returncode
    print("ok   it ends with 0")


(OUT / "start.esm.bak").unlink(missing_ok=True)
run(journey)
