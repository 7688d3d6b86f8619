#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
"""What `esm inspect` says a net takes of memory, beside what `esm simulate` takes at its peak."""
import os
import subprocess
import unittest

from program import PROGRAM, ProgramTest


def bumpy_sphere(rings, around):
    """OBJ of a closed surface of about rings x around nodes, 80 mm across."""
    from math import cos, pi, sin
    lines = ["v 0 0 40"]
    for ring in range(1, rings):
        for i in range(around):
            a, b = pi * ring / rings, 2 * pi * i / around
            r = 40 + 2 * sin(5 * b) * sin(3 * a)
            lines.append(f"v {r * sin(a) * cos(b):.6f} {r * sin(a) * sin(b):.6f} {r * cos(a):.6f}")
    lines.append("v 0 0 -40")
    last = 2 + (rings - 1) * around
    node = lambda ring, i: 2 + (ring - 1) * around + i % around
    for i in range(around):
        lines.append(f"f 1 {node(1, i)} {node(1, i + 1)}")
        lines.append(f"f {last} {node(rings - 1, i + 1)} {node(rings - 1, i)}")
        for ring in range(1, rings - 1):
            lines.append(f"f {node(ring, i)} {node(ring + 1, i)} {node(ring + 1, i + 1)}")
            lines.append(f"f {node(ring, i)} {node(ring + 1, i + 1)} {node(ring, i + 1)}")
    return "\n".join(lines) + "\n"


class Memory(ProgramTest):
    MOST = 1.5  # what the promise may be off, either way: that is what the user is told

    def peak(self, *arguments):
        """Bytes of resident memory that the program takes at its peak."""
        with open(os.devnull, "wb") as nowhere:
            child = subprocess.Popen([PROGRAM, *arguments], cwd=self.folder, stdout=nowhere, stderr=nowhere)
            _, status, usage = os.wait4(child.pid, 0)
            child.returncode = os.waitstatus_to_exitcode(status)
        self.assertIn(child.returncode, (0, 3))
        return 1024 * usage.ru_maxrss

    def check(self, peak, promised):
        self.assertLess(peak, self.MOST * promised, f"{peak / 1e6:.0f} MB where {promised / 1e6:.0f} MB are promised")
        self.assertGreater(peak, promised / self.MOST, f"{peak / 1e6:.0f} MB where {promised / 1e6:.0f} MB are promised")

    def promised(self, *choices):
        return self.json_of("inspect", "a.obj", "--unit", "mm", *choices)["cost"]["memory_bytes"]

    def test_a_surface_at_rest_and_in_motion(self):
        self.write("a.obj", bumpy_sphere(160, 160))
        promised = self.promised()
        self.run_program("import", "a.obj", "--unit", "mm", "-o", "a.esmb")
        self.check(self.peak("simulate", "a.esmb", "--duration", "0.05"), promised)
        self.run_program("apply", "a.esmb", "-o", "b.esmb", "--gravity", "0,0,-1")
        self.check(self.peak("simulate", "b.esmb", "--duration", "0.02", "--solver", "leapfrog"), promised)

    def test_a_solid_with_struts(self):
        self.write("a.obj", bumpy_sphere(80, 80))
        promised = self.promised("--interior", "struts")
        self.run_program("import", "a.obj", "--unit", "mm", "--interior", "struts", "-o", "a.esmb")
        self.check(self.peak("simulate", "a.esmb", "--duration", "0.05"), promised)


if __name__ == "__main__":
    unittest.main()
