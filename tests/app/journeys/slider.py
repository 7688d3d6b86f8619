# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A slider makes tissue harder: the springs are stiffer, another rule is the reason, and one undo gives back
the very same project."""
import json

from window import MAIN, OUT, click, drag, focus, keys, picture, place, run, state, until


def reason(s):
    """What the panel 'Why?' says about the tissue."""
    return " ".join(text for name, text in sorted(s["texts"].items()) if name.startswith("why"))


def journey():
    fresh = until("the window shows the project", lambda s: s["nodes"] > 0 and reason(s))
    focus(MAIN)
    picture("before")

    left = place("slider_hardness", 0.5)
    drag(left, (place("slider_hardness", 0.9)[0], left[1]))
    harder = until("the tissue is harder", lambda s: float(s["inputs"]["hardness"]) > 0.8 and reason(s) != reason(fresh))
    assert harder["undoCount"] == 1, harder["undoCount"]  # one drag, one step
    # Half a decade of stiffness from word to word, two words on: tenfold, at least five
    assert harder["meanStiffness"] > 5 * fresh["meanStiffness"], (harder["meanStiffness"], fresh["meanStiffness"])
    assert "hardness" in reason(harder) and "hard" in reason(harder).replace("hardness", ""), reason(harder)
    picture("after")

    click("view3d", 0.02, 0.02)
    keys("ctrl+z")
    back = until("one undo is enough", lambda s: s["undoIndex"] == 0)
    assert back["meanStiffness"] == fresh["meanStiffness"], (back["meanStiffness"], fresh["meanStiffness"])
    until("the reason is the former one", lambda s: reason(s) == reason(fresh))
    keys("ctrl+s")
    until("it is saved", lambda s: (OUT / "start.esm.bak").exists())
    before, after = (json.loads((OUT / name).read_text()) for name in ("start.esm.bak", "start.esm"))
    before.pop("view", None), after.pop("view", None)
    assert before == after, "the saved project differs from the one at the start"
    assert state()["undoIndex"] == 0


(OUT / "start.esm.bak").unlink(missing_ok=True)
run(journey)
