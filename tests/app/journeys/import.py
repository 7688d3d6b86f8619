# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A modeler's import: an STL in inches, unwelded, with a hole and a non-manifold edge, and the lines of an OBJ
beside it; the report counts right, an entry of the list flies the camera there, the net is what was promised;
then a large import is given up half-way."""
import math
import struct
import time

import window
from window import MAIN, OUT, click, focus, keys, picture, run, state, until

SIDE = 12  # quads along each side of the cube


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


def large_stl(path, side=388):
    """2 side^2 triangles: 301,088."""
    parts = [b"large".ljust(80, b"\0"), struct.pack("<I", 2 * side * side)]
    for i in range(side):
        for j in range(side):
            a, b, c, d = (i, j, math.sin(i)), (i + 1, j, math.sin(i + 1)), (i + 1, j + 1, math.sin(i + 1)), (i, j + 1, math.sin(i))
            parts.append(struct.pack("<12fH", 0, 0, 0, *a, *b, *c, 0) + struct.pack("<12fH", 0, 0, 0, *a, *c, *d, 0))
    path.write_bytes(b"".join(parts))


def ask_for(*paths):
    """Opens the import dialog for files of one folder."""
    focus(MAIN)
    keys("ctrl+i")
    until("the file dialog is there", lambda s: s["dialog"] == "QFileDialog")
    focus("Import meshes")
    window.write(" ".join(f'"{path}"' for path in paths) if len(paths) > 1 else paths[0])
    time.sleep(1.0)
    keys("Return")
    for _ in range(20):  # the first Return may go to the list of completions
        time.sleep(0.5)
        if state().get("dialog") != "QFileDialog":
            return
    keys("Return")


def counts(s):
    """What the report says of the file and of what came of it."""
    return {row[0].replace("⚠ ", ""): (row[1], row[2]) for row in s["items"]["importReport"]}


def journey():
    cube, lines, large = OUT / "cube.stl", OUT / "struts.obj", OUT / "large.stl"
    write_stl(cube, faces())
    write_lines(lines)
    large_stl(large)
    until("the window is there", lambda s: s["nodes"] > 0)

    ask_for(cube, lines)
    focus("Import cube.stl")
    seen = until("the preview is there", lambda s: "importOk" in s["enabled"] and s["items"]["importReport"])
    nodes = 6 * SIDE * SIDE + 2 + 1 + 5  # of the cube; the tip of the triangle on the edge; the lines meet a corner
    report = counts(seen)
    assert report["Vertices"][0] == str(nodes), report
    assert report["Triangles"][0] == str(12 * SIDE * SIDE - 2 + 1), report
    assert report["Line segments"][0] == "5", report
    assert report["Boundary edges"][0] == "6", report
    assert report["Non-manifold edges"][0] == "1", report
    assert seen["texts"]["importSize"].startswith("4 × 4 × 4 mm"), seen["texts"]["importSize"]

    click("importUnit")
    keys("End", "Return")
    seen = until("the unit is inch", lambda s: "101.6 × 101.6 × 101.6 mm" in s["texts"]["importSize"] and "importOk" in s["enabled"])
    picture("report")
    assert seen["views"]["importView"]["marks"] == 0
    click("importDefects", 0.4, 0.07)  # the second row: the first of the open borders
    until("its first hole is marked", lambda s: s["views"]["importView"]["marks"] == 4)
    # The hole is in the top of the cube, at 5.5 of 12 quads: there the camera looks.
    middle = 5.5 * 2 / SIDE * 0.0254
    until("the camera has flown there", lambda s: math.dist(s["views"]["importView"]["target"], [middle, middle, 2 * 0.0254]) < 1e-4)
    time.sleep(2.0)  # the picture follows on a slow screen
    picture("defect")
    click("importOk")
    until("the net is there", lambda s: s["nodes"] == nodes and s["dialog"] == "")
    seen = until("it is one step", lambda s: s["undoCount"] == 1)
    springs = 18 * SIDE * SIDE - 1 + 2 + 5  # the diagonal of the missing quad; two of the triangle; the lines
    assert seen["springs"] == springs, (seen["springs"], springs)

    # The choices are remembered, and a large file can be given up while it is read.
    ask_for(large)
    focus("Import large.stl")
    until("the dialog is there", lambda s: s["dialog"] == "dlgImport" and s["texts"]["importRemembered"] == "Choices as for the last STL file")
    start = time.monotonic()
    click("importCancel")
    after = until("the dialog is gone", lambda s: s["dialog"] == "")
    print(f"     given up within {time.monotonic() - start:.1f} s, as the state dump sees it", flush=True)
    assert after["nodes"] == nodes and after["undoCount"] == 1, after["nodes"]

    focus(MAIN)
    keys("ctrl+z")
    until("undone", lambda s: s["nodes"] != nodes and s["undoIndex"] == 0)


run(journey)
