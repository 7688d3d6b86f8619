#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
"""Checks that no include crosses a layer of the house (docs/ARCHITECTURE.md), that public headers include public ones
only, and that every file says its licence.

The linker alone does not keep the layers apart: the headers of assimp, nlohmann-json and libusb lie on the default
include path, so a forbidden include compiles. Prints one line per fault; exit 1 if there is any.
"""
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent.parent

# Which of our folders a folder may include, besides itself.
LOW = ["core/base", "core/geometry", "core/net", "core/forces", "core/linear"]
# What every room of the engine hands over; the door, simulation.h, is not among them.
HANDED = [f"core/dynamics/{name}.h" for name in ("net_state", "solver_settings", "step_report", "energy_report",
                                                 "parameter_change", "motion_log")]
ROOMS = [f"core/dynamics/{room}" for room in ("system", "bounds", "methods", "planner", "rest")]
CORE = {
    "core/base": [],
    "core/geometry": ["core/base"],
    "core/net": ["core/base", "core/geometry"],
    "core/forces": ["core/base", "core/geometry", "core/net"],
    "core/linear": ["core/base", "core/geometry", "core/net", "core/forces"],
    **{room: [*LOW, *HANDED, *ROOMS[:i]] for i, room in enumerate(ROOMS)},
    "core/dynamics": LOW,
    "core/contact": [*LOW, "core/dynamics"],
    "core/fuzzy": ["core/base"],
    "core/tissue": ["core/base", "core/geometry", "core/net", "core/fuzzy"],
    "core/quality": [*LOW, "core/fuzzy", "core/tissue"],
    "core/structure": [*LOW, "core/dynamics", "core/fuzzy", "core/tissue", "core/quality"],
    "core/learning": [*LOW, "core/dynamics", "core/fuzzy", "core/tissue"],
    "core/runtime": [*LOW, "core/dynamics", "core/contact"],
    "core/project": [*LOW, "core/dynamics", "core/fuzzy", "core/tissue", "core/quality", "core/structure"],
}
ALLOWED = {
    **CORE,
    "meshimport": ["core/base", "core/geometry", "core/net", "core/structure", "core/project/import_recipe.h"],
    "haptics": ["core/base"],
    "haptics/replay": [*CORE["core/runtime"], "core/runtime", "haptics"],
    "fuzzyeditor": ["core"],
    "app": ["core", "meshimport", "haptics", "fuzzyeditor"],
    "cli": ["core", "meshimport", "haptics"],
    "bench": ["core", "meshimport", "haptics"],
    "examples": ["core", "meshimport", "haptics"],
    "tests": ["core", "meshimport", "haptics", "fuzzyeditor", "app", "cli", "bench"],
}
# Where a foreign header may be included: pattern of the header -> folders. The rest is free.
FOREIGN = [
    (re.compile(r"Q[A-Z]|q[a-z]+\.h$|Qt|qcustomplot"), ["fuzzyeditor", "app", "tests/fuzzyeditor", "tests/app"]),
    (re.compile(r"nlohmann/"), ["core/project", "haptics/device", "cli", "tests", "app"]),
    (re.compile(r"assimp/"), ["meshimport/worker", "bench"]),
    (re.compile(r"libusb"), ["haptics/usb", "tests/haptics"]),
    (re.compile(r"CLI/"), ["cli", "app"]),
]
LICENCE = {"app": "GPL-3.0-or-later", "fuzzyeditor": "GPL-3.0-or-later", "tests/app": "GPL-3.0-or-later",
           "tests/fuzzyeditor": "GPL-3.0-or-later"}
# Where the headers that other programs may include are listed, in set(public ...) and list(APPEND public ...).
PUBLIC_LISTS = ["core/CMakeLists.txt", "meshimport/CMakeLists.txt"]
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)


def longest_key(path, keys):
    fitting = [key for key in keys if path == key or path.startswith(key + "/")]
    return max(fitting, key=len) if fitting else None


def faults_of(path):
    text = (ROOT / path).read_text(encoding="utf-8")
    house = longest_key(path, ALLOWED)
    licence = LICENCE.get(longest_key(path, LICENCE), "MIT")
    if f"SPDX-License-Identifier: {licence}" not in text.split("\n\n")[0]:
        yield f"{path}:1: the first lines must say SPDX-License-Identifier: {licence}"
    for match in INCLUDE.finditer(text):
        kind, header = match.groups()
        line = text.count("\n", 0, match.start()) + 1 + match.group(0).count("\n")
        if kind == '"' and longest_key(header, ALLOWED):
            if house and not any(header == ok or header.startswith(ok + "/") for ok in [house] + ALLOWED[house]):
                yield f"{path}:{line}: {house} must not include {header}"
            if not (ROOT / header).exists():
                yield f"{path}:{line}: {header} does not exist"
        elif kind == "<":
            for pattern, places in FOREIGN:
                if pattern.match(header) and not any(path.startswith(place + "/") for place in places):
                    yield f"{path}:{line}: <{header}> belongs in {', '.join(places)} only"


def public_headers():
    for listing in PUBLIC_LISTS:
        folder = Path(listing).parent
        for names in re.findall(r"(?:set\(|list\(APPEND )public\s([^)]*)\)", (ROOT / listing).read_text(encoding="utf-8")):
            yield from (str(folder / name) for name in names.split())


def public_faults(public):
    """Each public header is there, and includes only public ones and what the standard library and Eigen have."""
    for path in sorted(public):
        if not (ROOT / path).exists():
            yield f"{path}: is listed as public and does not exist"
            continue
        for kind, header in INCLUDE.findall((ROOT / path).read_text(encoding="utf-8")):
            if header not in public if kind == '"' else not re.match(r"[a-z_]+$|Eigen/", header):
                yield f"{path}: is public and includes {header}, which is not (docs/EMBEDDING.md)"


def main():
    listed = subprocess.run(["git", "-C", ROOT, "ls-files", "-co", "--exclude-standard", "*.h", "*.cpp"],
                            capture_output=True, text=True)
    if listed.returncode == 0:
        paths = listed.stdout.split()
    else:  # a source archive without git
        paths = [str(p.relative_to(ROOT)) for pattern in ("*.h", "*.cpp") for p in ROOT.rglob(pattern)
                 if not p.relative_to(ROOT).parts[0].startswith("build")]
    paths = sorted(path for path in paths if longest_key(path, ALLOWED) and (ROOT / path).exists())
    if len(paths) < 50:
        sys.exit(f"only {len(paths)} source files found under {ROOT}: the check would prove nothing")
    public = set(public_headers())
    if len(public) < 30:
        sys.exit(f"only {len(public)} public headers found: the check would prove nothing")
    faults = [fault for path in paths for fault in faults_of(path)] + list(public_faults(public))
    print("\n".join(faults) if faults
          else f"{len(paths)} files, every include within its layer; {len(public)} public headers that need no other")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
