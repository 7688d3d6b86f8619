# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A modeler's import: an STL in inches, unwelded, with a hole and a non-manifold edge, is dropped onto the window; the
report counts right, an entry of the list flies the camera there, the net is what was promised; the lines of an OBJ are
added as springs; the shape is exported, and another program counts the same. Then a large import is given up half-way,
and both files are dropped together, in German on dark."""
import json
import math
import pathlib
import re
import struct
import subprocess
import time

import window
from window import MAIN, MODELER, OUT, carry_files, click, focus, keys, let_go, picture, place, run, state, until, xdo

ESM = pathlib.Path(MODELER).with_name("esm")
CUBE, LINES, LARGE, EXPORTED = OUT / "cube.stl", OUT / "struts.obj", OUT / "large.stl", OUT / "exported.obj"
SIDE = 12  # quads along each side of the cube
INCH = 0.0254  # [m]
NODES = 6 * SIDE * SIDE + 2 + 1  # of the cube; the tip of the triangle on the edge
TRIANGLES = 12 * SIDE * SIDE - 2 + 1  # a quad is missing, the triangle on the edge
SPRINGS = 18 * SIDE * SIDE - 1 + 2  # the diagonal of the missing quad; two of the triangle


def faces():
    """A cube of 2 inches: corners as written, facet by facet; one quad is missing, one triangle stands on an edge."""
    step = 2.0 / SIDE
    triangles = []
    for axis in range(3):
        for end in (0.0, 2.0):
            for i in range(SIDE):
                for j in range(SIDE):
                    if axis == 2 and end == 2.0 and (i, j) == (5, 5):
                        continue  # the hole

                    def corner(a, b):
                        place = [0.0, 0.0, 0.0]
                        place[axis], place[(axis + 1) % 3], place[(axis + 2) % 3] = end, (i + a) * step, (j + b) * step
                        return tuple(struct.unpack("f", struct.pack("f", x))[0] for x in place)

                    a, b, c, d = corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)
                    triangles += [(a, b, c), (a, c, d)] if end else [(a, c, b), (a, d, c)]
    first = triangles[0]
    triangles.append((first[0], first[1], (-1.0, -1.0, -1.0)))
    return triangles


def write_stl(path, triangles):
    body = b"".join(struct.pack("<12fH", 0, 0, 0, *a, *b, *c, 0) for a, b, c in triangles)
    path.write_bytes(b"inches".ljust(80, b"\0") + struct.pack("<I", len(triangles)) + body)


def write_lines(path):
    """Two polylines from a corner of the cube, with five new points and five pieces."""
    path.write_text("v 0 0 0\nv 3 0 0\nv 3 3 0\nv 3 3 3\nl 1 2 3 4\nv 0 3 0\nv 0 3 3\nl 1 5 6\n")


def large_stl(path, side=1200):
    """2 side^2 triangles: 2.88 million, seconds of work for a quick computer."""
    parts = [b"large".ljust(80, b"\0"), struct.pack("<I", 2 * side * side)]
    for i in range(side):
        for j in range(side):
            a, b, c, d = (i, j, math.sin(i)), (i + 1, j, math.sin(i + 1)), (i + 1, j + 1, math.sin(i + 1)), (i, j + 1, math.sin(i))
            parts.append(struct.pack("<12fH", 0, 0, 0, *a, *b, *c, 0) + struct.pack("<12fH", 0, 0, 0, *a, *c, *d, 0))
    path.write_bytes(b"".join(parts))


def file_name(title, path, *, accept):
    """Types a path into the file dialog that is open; `accept` says of a state whether the dialog has done its work."""
    until("the file dialog is there", lambda s: s["dialog"] == "QFileDialog")
    focus(title)
    window.write(path)
    for _ in range(3):  # the first Return may go to the list of completions
        time.sleep(1.0)
        if accept(state()):
            return
        keys("Return")


def counts(s):
    """What the report says of the file and of what came of it."""
    return {row[0].replace("⚠ ", ""): (row[1], row[2]) for row in s["items"]["importReport"]}


def scroll_to(name):
    """Turns the wheel over the scroll bar of the import's choices until a widget can be seen."""
    for _ in range(12):
        if name in state().get("widgets", {}):
            break
        xdo("mousemove", *place("importScroll", 0.98))
        xdo("click", "--repeat", 4, 5)
        time.sleep(1.0)
    click(name, 0.05)  # of boxes only the box and its text take clicks


def unit_is_inch(size):
    """The last of the units; `size` is what the dialog then says."""
    click("importUnit")
    keys("End", "Return")
    return until("the unit is inch", lambda s: size in s["texts"]["importSize"] and "importOk" in s["enabled"])


def saved(replaces=False):
    """Ctrl+S; what the file then holds: (nodes, springs, triangles), and the project as JSON.

    Over another organ the window asks first.
    """
    file = OUT / "start.esm"
    before = file.stat().st_mtime_ns
    keys("ctrl+s")
    if replaces:
        until("it asks about the other model", lambda s: s["dialog"] == "dlgOtherModel" and "otherVersionOverwrite" in s["widgets"])
        click("otherVersionOverwrite")
    until("it is saved", lambda s: file.stat().st_mtime_ns != before and not s["modified"])
    if replaces:
        focus(MAIN)
    info = json.loads(subprocess.run([ESM, "info", "--json", file], capture_output=True, check=True).stdout)
    return (info["nodes"], info["springs"], info["triangles"]), json.loads(file.read_text())


def assimp_counts(path):
    """(corners, faces and pieces of lines) as assimp reads them, which gives each face corners of its own."""
    told = subprocess.run(["assimp", "info", path, "-r"], capture_output=True, text=True, check=True).stdout
    return tuple(int(re.search(rf"^{what}:\s+(\d+)", told, re.MULTILINE)[1]) for what in ("Vertices", "Faces"))


def seconds_until_gone(title):
    """How long a window stays on the screen after the mouse button has been clicked."""
    xdo("mousemove", *place("importCancel"))
    start = time.monotonic()
    xdo("click", 1)
    while time.monotonic() < start + window.PATIENCE:
        found = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", title], capture_output=True, text=True)
        if not found.stdout.strip():
            return time.monotonic() - start
    window.fail(f"{title} does not go away")


def drop_the_cube():
    """The STL is dropped onto the window; the report counts right."""
    files = carry_files("view3d", CUBE)
    until("the window says what it would do", lambda s: "Drop to import" in s["texts"]["dropHint"])
    picture("drop")
    let_go(files)
    until("the dialog is there", lambda s: s["dialog"] == "dlgImport" and "dropHint" not in s["widgets"])
    focus("Import cube.stl")
    seen = until("the preview is there", lambda s: "importOk" in s["enabled"] and s["items"]["importReport"])
    report = counts(seen)
    assert report["Vertices"] == (str(NODES), str(NODES)), report
    assert report["Triangles"][0] == str(TRIANGLES), report
    assert report["Boundary edges"][0] == "6", report
    assert report["Non-manifold edges"][0] == "1", report
    assert seen["texts"]["importSize"].startswith("3 × 3 × 3 mm"), seen["texts"]["importSize"]


def choose_and_take():
    """Unit and weld are chosen, the list is asked for the hole, the net is taken. @return the saved project."""
    unit_is_inch("76.2 × 76.2 × 76.2 mm")
    click("importWeld", 0.05)
    corners = str(3 * TRIANGLES)
    until("not welded, each corner is a vertex", lambda s: "importOk" in s["enabled"] and counts(s)["Vertices"][0] == corners)
    click("importWeld", 0.05)
    until("welded again", lambda s: "importOk" in s["enabled"] and counts(s)["Vertices"][0] == str(NODES))
    picture("report")
    assert state()["views"]["importView"]["marks"] == 0
    click("importDefects", 0.4, 0.07)  # the second row: the first of the open borders
    until("its first hole is marked", lambda s: s["views"]["importView"]["marks"] == 4)
    # The hole is in the top of the cube, at 5.5 of 12 quads: there the camera looks.
    middle = 5.5 * 2 / SIDE * INCH
    hole = [middle, middle, 2 * INCH]
    until("the camera has flown there", lambda s: math.dist(s["views"]["importView"]["target"], hole) < 1e-4)
    time.sleep(2.0)  # the picture follows on a slow screen
    picture("defect")
    click("importOk")
    until("the net is there, in one step", lambda s: s["nodes"] == NODES and s["dialog"] == "" and s["undoCount"] == 1)
    focus(MAIN)
    sizes, project = saved(replaces=True)
    assert sizes == (NODES, SPRINGS, TRIANGLES), sizes
    assert project["source"]["unit"] == "inch", project["source"]
    return project


def add_the_lines(alone):
    """The lines of an OBJ come as springs beside the model; what was there keeps its place and number."""
    keys("ctrl+i")
    file_name("Import meshes", LINES, accept=lambda s: s.get("dialog") == "dlgImport")
    focus("Import struts.obj")
    until("the lines are there", lambda s: "importOk" in s["enabled"] and counts(s)["Line segments"][0] == "5")
    unit_is_inch("76.2 × 76.2 × 76.2 mm")
    scroll_to("importAdd")
    time.sleep(1.0)
    picture("add")
    click("importOk")
    until("they are added, in one step", lambda s: s["nodes"] == NODES + 6 and s["dialog"] == "" and s["undoCount"] == 2)
    focus(MAIN)
    sizes, both = saved()
    assert sizes == (NODES + 6, SPRINGS + 5, TRIANGLES), sizes
    position, before = both["geometry"]["position"], alone["geometry"]["position"]
    assert position[: len(before)] == before, "nodes of the model have moved"
    added = [[round(x / INCH, 9) for x in position[i : i + 3]] for i in range(len(before), len(position), 3)]
    assert added == [[0, 0, 0], [3, 0, 0], [3, 3, 0], [3, 3, 3], [0, 3, 0], [0, 3, 3]], added
    assert both["net"]["springs"]["lines"] == list(range(SPRINGS, SPRINGS + 5)), both["net"]["springs"]["lines"]


def export():
    """What is exported has the same counts, for us and for another program."""
    keys("ctrl+e")
    file_name("Export shape", EXPORTED, accept=lambda s: EXPORTED.exists())
    until("the shape is exported", lambda s: EXPORTED.exists() and s["dialog"] == "")
    assert assimp_counts(EXPORTED) == (3 * TRIANGLES + 2 * 5, TRIANGLES + 5), assimp_counts(EXPORTED)
    told = json.loads(subprocess.run([ESM, "inspect", "--json", EXPORTED], capture_output=True, check=True).stdout)
    read = tuple(told[key] for key in ("triangles", "segments", "boundary_edges", "nonmanifold_edges"))
    assert read == (TRIANGLES, 5, 6, 1), read
    assert told["nodes"] == NODES + 5, told["nodes"]  # the lines begin at a corner of the cube


def give_up():
    """The choices are remembered; a large file is given up while it is read, and nothing has changed."""
    waits = []
    for _ in range(3):
        focus(MAIN)
        keys("ctrl+i")
        file_name("Import meshes", LARGE, accept=lambda s: s.get("dialog") == "dlgImport")
        focus("Import large.stl")
        remembered = "Choices as for the last STL file"
        seen = until("the dialog is there", lambda s: s["dialog"] == "dlgImport" and s["texts"]["importRemembered"] == remembered)
        assert "importOk" not in seen["enabled"] and "importProgress" in seen["widgets"], "it is read already"
        waits.append(seconds_until_gone("Import large.stl"))
        after = until("the window is back", lambda s: s["dialog"] == "")
        assert after["nodes"] == NODES + 6 and after["undoCount"] == 2 and not after["modified"], after["nodes"]
    print("     given up within " + ", ".join(f"{wait:.2f}" for wait in waits) + " s", flush=True)
    assert min(waits) < 0.5, waits  # other work on the machine may slow one of them

    focus(MAIN)
    keys("ctrl+z", "ctrl+z")
    until("undone", lambda s: s["nodes"] != NODES and s["undoIndex"] == 0)


def journey():
    until("the window is there", lambda s: s["nodes"] > 0)
    drop_the_cube()
    alone = choose_and_take()
    add_the_lines(alone)
    export()
    give_up()


def together():
    """Both files dropped at once become one net, joined where they touch."""
    until("the window is there", lambda s: s["nodes"] > 0)
    files = carry_files("view3d", CUBE, LINES)
    until("the window counts them", lambda s: "2 Dateien" in s["texts"]["dropHint"])
    picture("drop-german-dark")
    let_go(files)
    until("the dialog is there", lambda s: s["dialog"] == "dlgImport")
    seen = until("the preview is there", lambda s: "importOk" in s["enabled"] and s["items"]["importReport"])
    column = {row[0].replace("⚠ ", ""): row[1] for row in seen["items"]["importReport"]}
    assert (column["Punkte"], column["Liniensegmente"]) == (str(NODES + 5), "5"), column
    time.sleep(2.0)
    picture("report-german-dark")
    click("importOk")
    until("the net is there", lambda s: (s["nodes"], s["springs"]) == (NODES + 5, SPRINGS + 5) and s["dialog"] == "")


EXPORTED.unlink(missing_ok=True)
write_stl(CUBE, faces())
write_lines(LINES)
large_stl(LARGE)
run(journey)
run(together, language="de", theme="dark")
