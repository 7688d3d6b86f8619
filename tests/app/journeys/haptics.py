# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Feel: an emulated Falcon from "not permitted" over firmware and homing to force; a recorded hand presses on the tube,
the force fades in and stays below its limit; ticks go on while a modal dialog is open, and Esc in it takes the force
away; then somebody pulls the cable. Driver, threads and servo are those of a real device."""
import csv
import hashlib
import re
import shutil
import time

from window import MAIN, OUT, SAMPLES, click, focus, keys, picture, run, state, until, write

IDLE, ARMING, ACTIVE, FADING, FAULT = 1, 2, 3, 4, 5  # DeviceState
NEEDS_HOME, RUNNING, BROKEN, LOST = 2, 3, 4, 5  # DevicePhase
DEVICES, FORCE, POSITION, ENERGY, TIMING, PATH, EMULATOR = range(7)  # tabs
LIMIT = 0.4  # [N]
TRIES = 12  # of a way along which force must flow, where the computer stalls
STEADY = 990.0  # [Hz]; mean of half a second: it falls by as much where 5 ms are missing
FIRMWARE, HAND, LOG = OUT / "firmware.bin", OUT / "hand.csv", OUT / "felt.csv"


def tab(number):
    click(f"hapticTabs{number}")


class Stalled(Exception):
    """The computer did not run for a while: after 20 ms the servo takes the force away, as from a device that does not
    reply, after a second as from a simulation that does not answer. With much gain the one old force that the hand felt
    meanwhile may give it more energy than the tissue had."""


def alive(s):
    device = s["device"]
    if device["state"] == FAULT and (re.search("does not reply|answers too late", device["reason"])
                                     or device["rate"] < STEADY and "more energy" in device["reason"]):
        raise Stalled
    return True


def arm():
    """What the window shows may be from before the click: a fault of then is none now."""
    before = state()["device"]["ticks"]
    click("hapticArm")
    return until("the force comes", lambda s: s["device"]["ticks"] > before + 300 and alive(s)
                 and s["device"]["state"] in (ARMING, ACTIVE))


def unless_stalled(way, mend):
    """Goes a way along which force must flow, once more where the computer stalled."""
    for _ in range(TRIES):
        try:
            return way()
        except Stalled:
            print("note the computer stalled: once more", flush=True)
            mend()
    raise AssertionError(f"the computer stalled {TRIES} times")


def can_connect(s):
    return "Falcon" in s["texts"]["hapticWhat"] and "hapticConnect" in s["enabled"]


def choose_falcon():
    tab(DEVICES)
    click("hapticList", 0.5, 0.06)
    keys("Home", "Down", "Down")


def file_dialog(name, path):
    """Types a path into Qt's own file dialog."""
    until(f"a dialog asks for {path.name}", lambda s: s["dialog"])
    focus(name)
    write(path)
    keys("Return")
    until("the dialog is closed", lambda s: not s["dialog"])
    focus(MAIN)


def write_hand():
    """Presses on the top of the tube by 9 mm in half a second, and stays."""
    tops = [[float(word) for word in line.split()[1:4]] for line in (SAMPLES / "fallopian_tube.obj").read_text().splitlines()
            if line.startswith("v ")]
    x, y, z = max((v for v in tops if 12 < v[0] < 24), key=lambda v: v[2])
    above, inside = z + 3 + 6, z + 3 - 9  # 3 mm: radius of the tip
    with HAND.open("w") as file:
        file.write("t,x,y,z\n")
        for i in range(901):
            t = i / 900
            depth = min(max((t - 0.3) / 0.5, 0), 1) * (above - inside)
            file.write(f"{t:.4f},{x / 1000},{y / 1000},{(above - depth) / 1000}\n")


def set_number(name, text):
    click(name, 0.3)
    keys("ctrl+a")
    write(text)
    keys("Return")


def not_permitted():
    tab(EMULATOR)
    click("emulatorPermitted", 0.1)
    choose_falcon()
    seen = until("the udev line is shown", lambda s: "0403" in s["texts"]["hapticRule"] and "uaccess" in s["texts"]["hapticRule"])
    assert "not permitted" in seen["texts"]["hapticReason"], seen["texts"]["hapticReason"]
    assert "hapticConnect" not in seen["enabled"]
    click("hapticCopyRule")
    until("it is copied", lambda s: s["clipboard"] == s["texts"]["hapticRule"])
    picture("not-permitted")
    tab(EMULATOR)
    click("emulatorPermitted", 0.1)


def from_firmware_to_home():
    choose_falcon()
    until("it can be connected", can_connect)
    click("hapticConnect")
    seen = until("without firmware it says so", lambda s: s["device"]["phase"] == BROKEN)
    until("in words", lambda s: "firmware" in s["texts"]["hapticReason"])
    assert "hapticArm" not in seen["enabled"], "force must wait for a device that runs"
    click("hapticConnect")
    until("it is disconnected", lambda s: s["device"]["attached"] == "")
    click("hapticChooseFirmware")
    file_dialog("Firmware", FIRMWARE)
    digest = hashlib.sha256(FIRMWARE.read_bytes()).hexdigest()
    until("the firmware is shown with its SHA-256", lambda s: digest in s["texts"]["hapticFirmware"].replace(" ", ""))
    click("hapticConnect")
    seen = until("it wants its home", lambda s: s["device"]["phase"] == NEEDS_HOME and "1, 2, 3" in s["texts"]["hapticReason"])
    assert "Pull the grip" in seen["texts"]["hapticReason"], seen["texts"]["hapticReason"]
    assert seen["device"]["force"] == 0
    picture("needs-home")
    tab(EMULATOR)
    click("emulatorOutAndIn")
    until("it is home", lambda s: s["device"]["phase"] == RUNNING)


def press():
    set_number("hapticForceLimit", LIMIT)
    until("the limit is in force", lambda s: abs(s["device"]["limit"] - LIMIT) < 1e-9)
    tab(PATH)
    click("hapticLoadPath")
    file_dialog("Path of a hand", HAND)
    until("the path is loaded", lambda s: "901" in s["texts"]["hapticLoaded"])
    if not state()["playing"]:
        click("tool_actPlay")
    until("the simulation runs", lambda s: s["playing"])
    click("hapticRecord")
    until("it records", lambda s: "Recording" in s["texts"]["hapticRecorded"])
    set_number("hapticGain", 0.3)  # so little that force may begin with the tool on the tissue
    click("hapticLead")
    until("the tip touches", lambda s: s["views"]["view3d"]["touches"])
    until("the hand has arrived", lambda s: s["forceNorm"] > 0.05)
    time.sleep(2)  # once more, the tip was on the tissue before the hand set out: it must have come, and rest
    seen = state()
    assert seen["device"]["force"] == 0, "nobody has let force flow yet"
    arm()
    until("the force is in the hand", lambda s: alive(s) and s["device"]["state"] == ACTIVE and s["device"]["force"] > 0.005)
    set_number("hapticGain", 9)
    until("the limit holds the force", lambda s: alive(s) and abs(s["device"]["force"] - LIMIT) < 1e-6)
    tab(FORCE)
    time.sleep(1)
    picture("pressing")


def stop_in_a_dialog():
    focus(MAIN)
    keys("F1")
    opened = until("a modal dialog is open", lambda s: s["dialog"])
    time.sleep(2)
    later = until("the ticks go on", lambda s: s["device"]["ticks"] > opened["device"]["ticks"] + 200)
    print(f"note ticks at {later['device']['rate']:.0f} Hz while a modal dialog is open", flush=True)
    assert alive(later) and later["device"]["state"] == ACTIVE, later["device"]
    focus("Keys")
    keys("Escape")
    stopped = until("Esc in the dialog takes the force away", lambda s: alive(s) and s["device"]["state"] == FAULT)
    assert stopped["device"]["force"] == 0, stopped["device"]
    assert stopped["dialog"], "the first Esc is for the force alone"
    keys("Escape")
    until("the second closes the dialog", lambda s: not s["dialog"])
    focus(MAIN)
    until("it says who stopped", lambda s: "Stopped by the user" in s["texts"]["hapticMessage"])


def press_and_stop():
    press()
    stop_in_a_dialog()


def take_force_away():
    """A window that stalled may take the click that armed only after the way was given up: this one comes behind it."""
    time.sleep(1)
    click("hapticStop")
    until("no force flows", lambda s: s["device"]["state"] == FAULT and s["device"]["force"] == 0)


def end_of_press():
    for _ in range(2):
        if state()["dialog"]:
            keys("Escape")
        time.sleep(1)
    focus(MAIN)
    take_force_away()
    tab(PATH)
    click("hapticRecord")


def check_log():
    tab(PATH)
    click("hapticRecord")
    click("hapticSaveLog")
    LOG.unlink(missing_ok=True)
    file_dialog("Save what", LOG)
    until("the log is there", lambda _: LOG.exists() and LOG.stat().st_size > 0)
    rows = [{k.split(" ")[0]: float(v) for k, v in row.items()} for row in csv.DictReader(LOG.open())]  # "fx [N]"
    force = [(r["fx"] ** 2 + r["fy"] ** 2 + r["fz"] ** 2) ** 0.5 for r in rows]
    peak = max(force)
    assert LIMIT - 1e-6 < peak <= LIMIT + 1e-9, peak
    first = next(i for i, f in enumerate(force) if f > 0)
    assert first >= 50, first  # fifty ticks with little in the hand come first
    early, late = sum(force[first:first + 200]) / 200, sum(force[first + 1700:first + 1900]) / 200
    assert 0 < early < 0.15 * late, (early, late)  # it fades in over two seconds, with a steady hand
    last = max(i for i, f in enumerate(force) if f > 0)
    assert all(f == 0 for f in force[last + 1:]) and len(force) - last > 100
    before = max(force[max(last - 30, 0):last + 1])
    fall = last - max(i for i in range(max(last - 30, 0), last + 1) if force[i] >= 0.9 * before)
    assert fall <= 5, fall  # exactly zero within five ticks
    steps = [t["t"] - s["t"] for s, t in zip(rows, rows[1:])]
    print(f"note peak {peak:.3f} N of {LIMIT} N, {len(rows)} ticks at {1 / (sum(steps) / len(steps)):.0f} Hz, "
          f"largest step of force {max(abs(b - a) for a, b in zip(force, force[1:])):.3f} N, zero {fall + 1} ticks after Esc", flush=True)


def space_stops():
    set_number("hapticGain", 0)  # the hand is on the tissue still: force begins with nothing only
    armed = arm()
    keys("space")  # the focus is on the button that armed
    until("space stops", lambda s: alive(s) and s["device"]["state"] == FAULT and "Stopped by the user" in s["device"]["reason"])
    assert state()["playing"] == armed["playing"], "space was used up: it neither pauses nor arms again"


def pull_the_cable():
    tab(EMULATOR)
    click("emulatorPlugged", 0.1)
    until("the loss is seen, with its reason", lambda s: s["device"]["phase"] == LOST and "unplugged" in s["texts"]["hapticMessage"])
    choose_falcon()
    until("the list knows", lambda s: "unplugged" in s["items"]["hapticList"][2][0] and "hapticConnect" not in s["enabled"])
    picture("unplugged")
    tab(EMULATOR)
    click("emulatorPlugged", 0.1)
    choose_falcon()
    until("it can be connected again", can_connect)
    click("hapticConnect")
    until("it has forgotten firmware and home, and idles", lambda s: s["device"]["phase"] == NEEDS_HOME and s["device"]["state"] == IDLE)
    seen = state()
    assert seen["device"]["force"] == 0 and seen["nodes"] > 0


def journey():
    until("the window shows the project", lambda s: s["nodes"] > 0 and "hapticTabs6" in s["widgets"])
    focus(MAIN)
    not_permitted()
    from_firmware_to_home()
    until("the grip rests", lambda s: abs(s["device"]["position"][2]) < 0.003)
    unless_stalled(press_and_stop, end_of_press)
    check_log()
    unless_stalled(space_stops, take_force_away)
    pull_the_cable()


def pictures():
    """The same in German and dark; the firmware is remembered."""
    until("the window shows the project", lambda s: s["nodes"] > 0 and "hapticTabs6" in s["widgets"])
    focus(MAIN)
    choose_falcon()
    until("it can be connected", can_connect)
    click("hapticConnect")
    until("it wants its home", lambda s: s["device"]["phase"] == NEEDS_HOME)
    picture("german-devices")
    tab(EMULATOR)
    click("emulatorOutAndIn")
    until("it is home", lambda s: s["device"]["phase"] == RUNNING)
    click("tool_actPlay")
    for number, name in ((FORCE, "force"), (POSITION, "position"), (ENERGY, "energy"), (TIMING, "timing"), (PATH, "path")):
        tab(number)
        time.sleep(1.2)
        picture(f"german-{name}")
    for name in ("hapticStop", "tool_actStop"):
        x, _, width, _ = state()["widgets"][name]
        assert x + width <= 1600, f"{name} ends beyond the screen, at {x + width}"


FIRMWARE.write_bytes(bytes(range(250)) * 12)
write_hand()
shutil.copy(SAMPLES / "fallopian_tube.esm", OUT / "haptics.esm")
run(journey, project="haptics.esm", arguments=("--emulate-device", "falcon"))
run(pictures, project="haptics.esm", language="de", theme="dark", arguments=("--emulate-device", "falcon"))
