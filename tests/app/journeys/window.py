# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The modeler's window under an X display, by real mouse and keys (xdotool). What it shows is read from its
state dump (app/state_dump.h). A journey is a script `NAME.py` beside this file, called by run.sh:

    from window import click, run, until
    def journey(): ...
    run(journey)

Arguments of every journey: MODELER SAMPLES OUT; OUT holds start.esm and takes the pictures.
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

MODELER, SAMPLES, OUT = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
NAME = pathlib.Path(sys.argv[0]).stem
STATE = OUT / "state.json"
JOURNALS = pathlib.Path(os.environ["XDG_STATE_HOME"]) / "esm-modeler" / "recovery"
MAIN = "Elastodynamic Shape Modeler"  # part of the window's title
PATIENCE = 40.0  # [s] for one expectation; a debug build on a busy machine is slow
program = None


def xdo(*arguments):
    subprocess.run(["xdotool", *map(str, arguments)], check=True)


def state():
    try:
        return json.loads(STATE.read_text())
    except (OSError, ValueError):
        return {}


def until(what, condition):
    """Waits for a state for which `condition` holds; a KeyError counts as not yet."""
    end = time.monotonic() + PATIENCE
    seen = {}
    while time.monotonic() < end:
        if program.poll() is not None:
            fail(f"{what}: the program has ended with {program.returncode}")
        seen = state()
        try:
            if seen and condition(seen):
                print(f"ok   {what}", flush=True)
                return seen
        except (KeyError, IndexError):
            pass
        time.sleep(0.2)
    seen = {k: v for k, v in seen.items() if k not in ("widgets", "texts", "items")}
    fail(f"{what}: not within {PATIENCE:.0f} s; state: {json.dumps(seen)[:1500]}")


def fail(message):
    picture("failure")
    program.kill()
    sys.exit(f"FAIL {message}")


def picture(name):
    subprocess.run(["import", "-window", "root", str(OUT / f"{NAME}-{name}.png")], check=False)


def place(name, x=0.5, y=0.5):
    corner_x, corner_y, width, height = until(f"{name} can be seen", lambda s: name in s["widgets"])["widgets"][name]
    return round(corner_x + x * width), round(corner_y + y * height)


def click(name, x=0.5, y=0.5):
    xdo("mousemove", *place(name, x, y))
    xdo("click", 1)


def drag(start, end, steps=12, hold=False):
    xdo("mousemove", *start)
    xdo("mousedown", 1)
    for i in range(1, steps + 1):
        xdo("mousemove", *(round(a + (b - a) * i / steps) for a, b in zip(start, end)))
        time.sleep(0.05)
    if not hold:
        xdo("mouseup", 1)


def carry_files(target, *paths):
    """Takes files out of another program's window, as out of a file manager, and holds them over `target`, the button
    still down. let_go(), with what this returns, drops them."""
    source = subprocess.Popen([os.environ["ESM_DRAG_SOURCE"], "8", "900", *map(str, paths)])
    focus("Files to drag")
    drag((60, 930), place(target), hold=True)
    return source


def let_go(source):
    xdo("mouseup", 1)
    if source.wait(timeout=PATIENCE) != 0:
        fail("the files were not taken")


def keys(*names):
    for name in names:
        xdo("key", "--clearmodifiers", name)
        time.sleep(0.1)


def write(text):
    """Types. A letter that no key of the keyboard has ("ä") borrows a key for a moment: the window needs time to see it."""
    for part in re.findall(r"[\x00-\x7f]+|[^\x00-\x7f]", str(text)):
        xdo("type", "--delay", 25 if part.isascii() else 600, part)


def focus(title):
    """Gives the keyboard to a window; there is no window manager that would."""
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        found = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", title], capture_output=True, text=True)
        windows = found.stdout.split()
        if windows:
            xdo("windowfocus", windows[-1])
            time.sleep(0.3)
            return
        time.sleep(0.2)
    fail(f"no window named {title}")


def start(*arguments, language="en", theme="light", forget=True):
    """With `forget`, what a former program that was killed could not save is not offered."""
    global program
    if forget:
        shutil.rmtree(JOURNALS, ignore_errors=True)
    STATE.unlink(missing_ok=True)
    program = subprocess.Popen([MODELER, "--dump-state", str(STATE), "--lang", language, "--theme", theme, *map(str, arguments)])


def run(journey, project="start.esm", language="en", theme="light", arguments=()):
    """Opens a project of OUT, goes the way, and ends with an error and a picture where it is not as it should be."""
    start(OUT / project, *arguments, language=language, theme=theme)
    try:
        journey()
    except AssertionError as wrong:
        fail(f"assertion: {wrong}")
    finally:
        if program.poll() is None:
            program.kill()
