#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
"""What `esm inspect` says a net takes of memory, beside what `esm simulate` takes at its peak."""
import os
import subprocess
import unittest

from program import PROGRAM, ProgramTest


def geodesic_sphere(n):
    """OBJ of a sphere of 10 n^2 + 2 nodes, 80 mm across: each face of an icosahedron is cut n times."""
    g = (1 + 5 ** 0.5) / 2
    corners = [(-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g), (0, -1, -g), (0, 1, -g),
               (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1)]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6),
             (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10),
             (8, 6, 7), (9, 8, 1)]
    number, lines = {}, []

    def node(face, i, j):
        weights = (n - i - j, i, j)
        point = tuple(sum(w * corners[c][k] for w, c in zip(weights, face)) for k in range(3))
        key = tuple(round(1e6 * x) for x in point)
        if key not in number:
            number[key] = len(number) + 1
            scale = 40 / sum(x * x for x in point) ** 0.5
            lines.append("v " + " ".join(f"{scale * x:.6f}" for x in point))
        return number[key]

    triangles = []
    for face in faces:
        for i in range(n):
            for j in range(n - i):
                triangles.append((node(face, i, j), node(face, i + 1, j), node(face, i, j + 1)))
                if i + j + 1 < n:
                    triangles.append((node(face, i + 1, j), node(face, i + 1, j + 1), node(face, i, j + 1)))
    return "\n".join(lines + [f"f {a} {b} {c}" for a, b, c in triangles]) + "\n"


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
        self.write("a.obj", geodesic_sphere(50))
        promised = self.promised()
        self.run_program("import", "a.obj", "--unit", "mm", "-o", "a.esmb")
        self.check(self.peak("simulate", "a.esmb", "--duration", "0.05"), promised)
        self.run_program("apply", "a.esmb", "-o", "b.esmb", "--gravity", "0,0,-1")
        self.check(self.peak("simulate", "b.esmb", "--duration", "0.02", "--solver", "leapfrog"), promised)

    def test_a_solid_with_struts(self):
        self.write("a.obj", geodesic_sphere(24))
        promised = self.promised("--interior", "struts")
        self.run_program("import", "a.obj", "--unit", "mm", "--interior", "struts", "-o", "a.esmb")
        self.check(self.peak("simulate", "a.esmb", "--duration", "0.05"), promised)


if __name__ == "__main__":
    unittest.main()
