# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Why is it stiff? A click on a node and on a spring: what the dock says is what `esm explain` says of the saved
project; a suggested change is one step and does what it says."""
import json
import pathlib
import subprocess
import time

from window import MAIN, MODELER, OUT, click, drag, focus, keys, picture, place, run, state, until, xdo

ESM = pathlib.Path(MODELER).with_name("esm")


def explain(*arguments):
    """What the command line says of the saved project."""
    command = [ESM, "explain", OUT / "start.esm", *map(str, arguments)]
    return subprocess.run(command, check=True, capture_output=True).stdout.decode()


def save():
    time.sleep(0.5)
    keys("ctrl+s")
    until("it is saved", lambda s: not s["modified"])


def journey():
    until("the window shows the project", lambda s: s["nodes"] > 0 and s["openGl"])
    focus(MAIN)
    until("with nothing selected the base tissue is explained", lambda s: s["why"].startswith("Base tissue has "))

    # A node by its projected place, with a region of other tissue over it
    click("tool_actToolSelect")
    point = until("there is something to select", lambda s: len(s["pullPoint"]) == 2)["pullPoint"]
    xdo("mousemove", *point)
    xdo("click", 1)
    chosen = until("the node is explained", lambda s: s["selectedNode"] >= 0 and
                   s["why"].startswith(f"Node {s['selectedNode']} lies in tissue of "))
    node = chosen["selectedNode"]
    click("regionAdd")
    until("a region lies over it", lambda s: len(s["regions"]) == 1 and s["target"] == 0)
    before = state()["why"]
    middle = place("slider_hardness", 0.5)
    drag(middle, (place("slider_hardness", 0.8)[0], middle[1]))
    until("the sentence names region and rule", lambda s: "Region 1 (rule " in s["why"] and s["why"] != before)
    save()
    told = json.loads(explain("--node", node, "--json"))
    assert state()["why"] == told["sentence"], (state()["why"], told["sentence"])
    picture("node")

    # The table on the clipboard is that of the command line, to the byte
    click("whyMenu")
    keys("Down", "Down", "Return")
    table = explain("--node", node, "--csv", "--change", "0.8")
    copied = until("the table is on the clipboard", lambda s: s["clipboard"].startswith("part,region,"))["clipboard"]
    assert copied.split() == table.split() and len(copied.splitlines()) == len(table.splitlines()), copied
    print("ok   the table is that of the command line")

    # What would make it 20 % softer: the button does it, as one step
    steps = state()["undoCount"]
    sentence = state()["why"]
    click("whyApply0")
    until("one step", lambda s: s["undoCount"] == steps + 1 and s["why"] != sentence)
    save()
    softer = json.loads(explain("--node", node, "--json"))
    ratio = softer["parameters"]["youngs_modulus"] / told["parameters"]["youngs_modulus"]
    assert abs(ratio - 0.8) < 0.008, ratio
    print("ok   it is 20 % softer")
    click("view3d", 0.02, 0.02)
    keys("ctrl+z")
    until("undone", lambda s: s["why"] == sentence)
    save()

    # A spring by the place of its middle
    point = until("there is a spring to select", lambda s: len(s["springPoint"]) == 2)["springPoint"]
    xdo("mousemove", *point)
    xdo("click", 1)
    chosen = until("the spring is explained", lambda s: s["selectedSpring"] >= 0 and s["why"].startswith("Spring "))
    told = json.loads(explain("--spring", chosen["selectedSpring"], "--json"))
    assert state()["why"] == told["sentence"], (state()["why"], told["sentence"])
    assert told["values"]["stiffness"]["value"] == told["values"]["stiffness"]["from_tissue"], told["values"]
    picture("spring")
    print("ok   the spring's sentence is that of the command line")


run(journey)
