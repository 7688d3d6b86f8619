# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Shaping words: a foot dragged in the plot with its number, ghost and surface, keys, the way back; then the cross on
the surface."""
import subprocess
import time

from window import MAIN, click, drag, focus, keys, picture, place, run, until, xdo


def point(state, name, plot="mfPlot"):
    """[x, y, value] of a point by its name."""
    return next(p[1:] for p in state["points"][plot] if p[0] == name)


def surface_picture():
    """What can be seen of the map, as bytes; without the keyboard, which shows as a frame."""
    click("view3d", 0.02, 0.02)
    x, y, width, height = until("the map can be seen", lambda s: "surfacePlot" in s["widgets"])["widgets"]["surfacePlot"]
    time.sleep(0.7)
    return subprocess.run(["import", "-window", "root", "-crop", f"{width}x{height}+{x}+{y}", "rgb:-"], check=True,
                          capture_output=True).stdout


def looks_like(one, other):
    """Whether an eye sees no difference: the halo of a number may differ by a few shades out of 256."""
    return len(one) == len(other) and sum(abs(a - b) > 24 for a, b in zip(one, other)) < 20


def show_dock(tab):
    """Terms and Surface share a place; their tabs are below it."""
    shown = "mfPlot" if tab == 0 else "surfacePlot"
    hidden = until("one of the docks is shown", lambda s: "dockMf" in s["widgets"] or "dockSurface" in s["widgets"])
    name = "dockMf" if "dockMf" in hidden["widgets"] else "dockSurface"
    x, y, _, height = hidden["widgets"][name]
    xdo("mousemove", x + (25 if tab == 0 else 80), y + height + 10)
    xdo("click", 1)
    return until(f"{shown} is in front", lambda s: shown in s["points"])


def journey():
    until("the window shows the project", lambda s: s["nodes"] > 0 and "mfPlot" in s["points"])
    focus(MAIN)
    show_dock(1)
    before_surface = surface_picture()
    start = show_dock(0)
    rules, stiffness = start["rules"], start["meanStiffness"]

    # A foot is dragged: the value is under the mouse, one undo step, rules untouched
    soft, hard = point(start, "soft: shoulder"), point(start, "hard: shoulder")
    pixel = 1.0 / (hard[0] - soft[0])  # the words of hardness go from 0 to 1
    x, y, value = point(start, "medium: right foot")
    drag((x, y), (x + 30, y))
    near = value + 30 * pixel  # within a pixel, once the state is not from amid the drag
    dragged = until("the value is under the mouse", lambda s: abs(point(s, "medium: right foot")[2] - near) <= 1.01 * pixel)
    assert dragged["undoCount"] == 1, dragged["undoCount"]
    moved = point(dragged, "medium: right foot")[2]
    assert abs(point(dragged, "firm: peak")[2] - moved) < 1e-9, "the neighbour's peak follows"
    assert dragged["rules"] == rules
    picture("dragged")

    # Esc takes a drag back, and leaves no step
    x, y, value = point(dragged, "medium: peak")
    drag((x, y), (x + 40, y), hold=True)
    until("the peak follows the mouse", lambda s: point(s, "medium: peak")[2] > value)
    xdo("key", "Escape")  # not by keys(), which lets mouse buttons go
    xdo("mouseup", 1)
    until("Esc takes it back", lambda s: s["undoCount"] == 1 and abs(point(s, "medium: peak")[2] - value) < 1e-12)

    # Keys: Tab to the next point, arrows by 1/100 of the range, a run of them is one step
    click("mfPlot", 0.5, 0.02)
    x, y, value = point(dragged, "medium: peak")
    xdo("mousemove", x, y)
    xdo("click", 1)
    keys("Tab")  # its right foot
    keys("Right", "Right")
    stepped = until("arrows move the foot", lambda s: abs(point(s, "medium: right foot")[2] - moved - 0.02) < 1e-9)
    assert stepped["undoCount"] == 2, stepped["undoCount"]
    time.sleep(1.0)  # a pause ends the run
    keys("shift+Left")
    back = until("Shift goes ten steps", lambda s: s["undoCount"] == 3)
    assert abs(point(back, "medium: right foot")[2] - moved + 0.08) < 1e-9, point(back, "medium: right foot")

    # A word that rules speak of is not removed, and the rules are named
    keys("Delete")
    until("it says which rules", lambda s: "termsMessage" in s["widgets"])
    assert "medium" in str(until("it stays", lambda s: s["undoCount"] == 3)["points"]["mfPlot"])
    picture("refused")

    # A result's words, on a logarithmic axis, in kPa
    click("mfVariable")
    keys("End", "Return")
    keys("Up", "Up", "Up", "Up", "Up", "Up")
    result = until("the stiffness is shown", lambda s: any("rather high: peak" == p[0] for p in s["points"]["mfPlot"]))
    x, y, value = point(result, "rather high: peak")
    drag((x, y), (x + 25, y))
    time.sleep(0.7)  # past the last move
    harder = until("its peak is dragged", lambda s: s["undoCount"] == 4 and point(s, "rather high: peak")[2] > 1.1 * value)
    picture("result")

    # The surface is another one now; its cross sets two inputs as one step
    seen = show_dock(1)
    deadline = time.monotonic() + 10
    while looks_like(surface_picture(), before_surface) and time.monotonic() < deadline:
        time.sleep(0.2)
    assert not looks_like(surface_picture(), before_surface), "the surface must follow the words"
    cross = next(p[1:] for p in seen["points"]["surfacePlot"])
    drag((cross[0], cross[1]), (cross[0] + 40, cross[1] - 30))
    time.sleep(0.7)
    inputs = until("the cross sets inputs", lambda s: s["undoCount"] == 5)
    changed = [name for name in inputs["inputs"] if inputs["inputs"][name] != harder["inputs"][name]]
    assert len(changed) == 2, changed
    assert inputs["meanStiffness"] != harder["meanStiffness"]
    picture("surface")

    # All the way back
    for _ in range(5):
        keys("ctrl+z")
    end = until("everything is undone", lambda s: s["undoIndex"] == 0 and not s["modified"])
    assert end["meanStiffness"] == stiffness and end["rules"] == rules
    assert place("surfacePlot")
    deadline = time.monotonic() + 10  # it is computed beside the window
    while not looks_like(surface_picture(), before_surface) and time.monotonic() < deadline:
        time.sleep(0.2)
    assert looks_like(surface_picture(), before_surface), "the surface is what it was"
    picture("end")
    print("ok   the surface is what it was")


run(journey)
