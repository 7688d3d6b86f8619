# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A region by hand: laid around selected nodes, resized by a handle in the preview, its falloff and its words changed,
turned inside out, reordered. Which springs an edit has changed is counted in the saved files and compared with the
geometry of the ellipsoid and with what the status bar says. Undo to the start saves the same project."""
import json
import math
import shutil
import subprocess
import time

import window
from window import MAIN, OUT, click, drag, focus, keys, picture, place, run, state, until, write, xdo


def project(name="start.esm"):
    return json.loads((OUT / name).read_text())


def save(name):
    """Saves and keeps a copy under that name."""
    before = (OUT / "start.esm").stat().st_mtime_ns
    keys("ctrl+s")
    until(f"saved as {name}", lambda s: (OUT / "start.esm").stat().st_mtime_ns != before and not s["modified"])
    shutil.copy(OUT / "start.esm", OUT / name)
    return project(name)


def rotated_back(q, v):
    """v by the inverse of the unit quaternion w, x, y, z."""
    w, x, y, z = q[0], -q[1], -q[2], -q[3]
    t = [2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0])]
    return [v[0] + w * t[0] + y * t[2] - z * t[1], v[1] + w * t[1] + z * t[0] - x * t[2],
            v[2] + w * t[2] + x * t[1] - y * t[0]]


def radius(region, point):
    local = rotated_back(region["rotation"], [p - c for p, c in zip(point, region["centre"])])
    return math.sqrt(sum((x / a) ** 2 for x, a in zip(local, region["semi_axes"])))


def radii(saved, region):
    """Of the middle of every spring at rest."""
    position, ends = saved["geometry"]["position"], saved["net"]["springs"]["ends"]
    node = [position[i:i + 3] for i in range(0, len(position), 3)]
    pairs = zip(ends[0::2], ends[1::2])
    return [radius(region, [(a + b) / 2 for a, b in zip(node[i], node[j])]) for i, j in pairs]


def each(saved, key):
    """One number per spring, also where the file has one for all."""
    numbers = saved["net"]["springs"][key]
    return numbers if isinstance(numbers, list) else [numbers] * (len(saved["net"]["springs"]["ends"]) // 2)


def changed(before, after):
    keys_ = ("stiffness", "viscosity", "law_parameter")
    pairs = [zip(each(before, key), each(after, key)) for key in keys_]
    return [i for i, values in enumerate(zip(*pairs)) if any(a != b for a, b in values)]


def journey():
    fresh = until("the window shows the project", lambda s: s["nodes"] > 0 and s["openGl"])
    start = project()
    focus(MAIN)

    # Select: a box over the middle of the organ takes what can be seen
    click("tool_actToolSelect")
    drag(place("view3d", 0.40, 0.15), place("view3d", 0.60, 0.80))
    selected = until("nodes are selected", lambda s: s["selectedNodes"] > 10)
    assert selected["selectedNodes"] < selected["nodes"], "the back is not selected"
    picture("selection")

    # A region around them
    click("regionFromSelection")
    until("the region is there", lambda s: len(s["regions"]) == 1 and s["target"] == 0 and s["undoCount"] == 1)

    # Its radius by a handle, with the mouse: one step, the centre stays, Esc takes a drag back
    click("tool_actToolRegion")
    ready = until("the gizmo is there", lambda s: any(name.startswith("stretch") for name in s["gizmo"]))
    handle = next(name for name in sorted(ready["gizmo"]) if name.startswith("stretch"))
    axis = "xyz".index(handle[8])
    place_of_handle, middle = ready["gizmo"][handle], ready["gizmo"]["move"]
    away = [h - m for h, m in zip(place_of_handle, middle)]
    target = [h + round(30 * a / math.hypot(*away)) for h, a in zip(place_of_handle, away)]
    drag(place_of_handle, target, hold=True)
    until("the region grows while the handle moves",
          lambda s: s["regions"][0]["semiAxes"][axis] > 1.02 * ready["regions"][0]["semiAxes"][axis])
    picture("drag")
    xdo("mouseup", 1)
    grown = until("one drag is one step", lambda s: s["undoCount"] == 2)
    assert grown["regions"][0]["centre"] == ready["regions"][0]["centre"], grown["regions"]
    drag(grown["gizmo"]["move"], [grown["gizmo"]["move"][0] + 40, grown["gizmo"]["move"][1] - 30], hold=True)
    until("the region moves", lambda s: s["regions"][0]["centre"] != grown["regions"][0]["centre"])
    xdo("key", "Escape")  # keys() would let the button go first
    xdo("mouseup", 1)
    back = until("Esc takes it back", lambda s: s["regions"][0]["centre"] == grown["regions"][0]["centre"])
    assert back["undoCount"] == 2, back["undoCount"]

    # Falloff 20 %
    click("regionFalloff", 0.3)
    keys("ctrl+a")
    write("20")
    keys("Return")
    until("the falloff is 20 %", lambda s: abs(s["regions"][0]["falloff"] - 0.2) < 1e-12 and s["undoCount"] == 3)
    picture("falloff")
    before = save("before.esm")

    # Its tissue becomes softer: only its springs change, as many as the status bar says
    spot = place("slider_hardness", 0.5)
    drag(spot, (place("slider_hardness", 0.06)[0], spot[1]))
    softer = until("the region is softer", lambda s: s["undoCount"] == 4 and float(s["inputs"]["hardness"]) < 0.2)
    after = save("softer.esm")
    inside = [i for i, r in enumerate(radii(before, before["regions"][0])) if r < 1]
    assert 0 < len(inside) < softer["springs"], len(inside)
    assert changed(before, after) == inside, (len(changed(before, after)), len(inside))
    assert softer["springsDerived"] == len(inside), (softer["springsDerived"], len(inside))
    assert "lblDerived" in softer["widgets"]
    print(f"ok   {len(inside)} of {softer['springs']} springs changed, and were derived")

    # The heat map of its weight, with the region's name in the legend
    click("colouringBox")
    time.sleep(0.5)
    keys("End", "Return")
    until("the legend speaks of the region", lambda s: "Region 1" in s["legend"])
    picture("weight")

    # Inside out: all other springs change
    click("regionInsideOut", 0.08)
    until("it is inside out", lambda s: s["regions"][0]["insideOut"] and s["undoCount"] == 5)
    picture("inside-out")
    turned = save("inside_out.esm")
    sizes, changed_now = radii(turned, turned["regions"][0]), set(changed(after, turned))
    same = set(range(len(sizes))) - changed_now
    assert all(0.8 < sizes[i] < 1.0 for i in same), "w and 1 - w are equal only within the falloff"
    assert state()["springsDerived"] >= len(changed_now)

    # A second region, and another order
    click("regionAdd")
    until("two regions", lambda s: len(s["regions"]) == 2 and s["target"] == 1)
    until("the legend follows the choice", lambda s: "Region 2" in s["legend"])
    click("regionUp")
    until("the order is another", lambda s: [r["name"] for r in s["regions"]] == ["Region 2", "Region 1"])
    left, top, width, height = state()["widgets"]["regionsList"]
    rows = [(left + 90, top + 12 + 22 * row) for row in range(3)]
    drag(rows[1], (rows[2][0], rows[2][1] + 8), steps=16)
    until("a row is dragged to another place", lambda s: [r["name"] for r in s["regions"]] == ["Region 1", "Region 2"])
    picture("reordered")

    # Locked: no handles, nothing to change
    click("regionLocked")
    until("it is locked", lambda s: s["regions"][1]["locked"] and not s["gizmo"])
    picture("locked")

    # Undo to the start saves the same project
    click("view3d", 0.02, 0.02)
    for _ in range(state()["undoCount"]):
        keys("ctrl+z")
    until("everything is undone", lambda s: s["undoIndex"] == 0 and not s["regions"])
    end = save("undone.esm")
    start.pop("view"), end.pop("view")
    assert start == end, "the saved project differs from the one at the start"
    print("ok   undo to the start saves the same project")


run(journey)

# For the eye: handles on a dark ground, in German
softer = json.loads((OUT / "softer.esm").read_text())
softer["view"]["colouring"] = "region_weight"
(OUT / "dark.esm").write_text(json.dumps(softer))
window.STATE.unlink(missing_ok=True)
window.program = subprocess.Popen([window.MODELER, "--dump-state", str(window.STATE), "--lang", "de", "--theme", "dark",
                                   str(OUT / "dark.esm")])
try:
    until("the region is there in German", lambda s: s["language"] == "de" and len(s["regions"]) == 1)
    focus(MAIN)
    click("regionsList", 0.3, 0.35)
    until("it is chosen", lambda s: s["target"] == 0)
    click("tool_actToolRegion")
    until("the gizmo is there in German", lambda s: s["gizmo"])
    time.sleep(1.0)
    picture("dark")
finally:
    window.program.kill()
