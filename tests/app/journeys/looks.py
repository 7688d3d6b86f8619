# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of the window in both languages and themes, taken by the program itself; and how it ends when the file that
it should show is absent, without a display that could show it."""
import os
import subprocess

from window import MODELER, OUT

for language, theme in (("en", "light"), ("de", "dark")):
    image = OUT / f"window-{language}-{theme}.png"
    image.unlink(missing_ok=True)
    command = [MODELER, OUT / "start.esm", "--lang", language, "--theme", theme, "--screenshot", image, "--after", "3"]
    subprocess.run(command, check=True, timeout=120)
    assert image.stat().st_size > 0, image
    print(f"ok   a picture in {language}, {theme}", flush=True)

ended = subprocess.run([MODELER, OUT / "absent.esm", "--screenshot", OUT / "none.png"], capture_output=True, text=True,
                       timeout=120, env={**os.environ, "QT_QPA_PLATFORM": "offscreen"})
assert ended.returncode == 1 and "absent.esm" in ended.stderr, (ended.returncode, ended.stderr)
print("ok   an absent file ends with 1 and its name")
