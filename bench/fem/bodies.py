# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
"""The bodies of the finite-element reference: hexahedra of 20 nodes on a grid, and the surface net that is judged.

Units: mm, mN, kPa. A grid point has the numbers (i, j, k); a tube's j runs around it and k from the inside out.
"""
import math

import numpy as np

GAUSS = [(-math.sqrt(0.6), 5 / 9), (0.0, 8 / 9), (math.sqrt(0.6), 5 / 9)]
# Corners and middles of a face in its own (u, v), counter-clockwise, as CalculiX numbers an S8.
FACE = [(-1, -1), (1, -1), (1, 1), (-1, 1), (0, -1), (1, 0), (0, 1), (-1, 0)]
# Corners and middles of a C3D20 in half steps of the grid.
BRICK = [(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (0, 0, 2), (2, 0, 2), (2, 2, 2), (0, 2, 2),
         (1, 0, 0), (2, 1, 0), (1, 2, 0), (0, 1, 0), (1, 0, 2), (2, 1, 2), (1, 2, 2), (0, 1, 2),
         (0, 0, 1), (2, 0, 1), (2, 2, 1), (0, 2, 1)]


class Body:
    """Elements, places, clamped nodes, and the faces on which loads act. Grid numbers are in half elements."""

    def __init__(self, name, counts, net_counts, place, period, is_clamped, faces):
        self.name, self.counts, self.period = name, counts, period
        self.number, self.points = {}, []
        # A tube's (along, around, outwards) is a left-handed frame, so its bricks are numbered the other way round.
        corners = [(b, a, c) for a, b, c in BRICK] if period else BRICK
        self.bricks = [[self.node(place, i + a, j + b, k + c) for a, b, c in corners]
                       for i in range(0, 2 * counts[0], 2) for j in range(0, 2 * counts[1], 2)
                       for k in range(0, 2 * counts[2], 2)]
        self.points = np.array(self.points)
        self.clamped = [n for key, n in self.number.items() if is_clamped(key)]
        self.faces = [[self.number[self.key(*corner)] for corner in face] for face in faces]
        step = [counts[d] // net_counts[d] for d in range(3)]
        assert all(step[d] * net_counts[d] == counts[d] for d in range(3)), "the net must lie on the elements"
        self.step = step

    def key(self, i, j, k):
        return (i, j % self.period if self.period else j, k)

    def node(self, place, i, j, k):
        key = self.key(i, j, k)
        if key not in self.number:
            self.number[key] = len(self.points)
            self.points.append(place(*key))
        return self.number[key]

    def at(self, i, j, k):
        """The node of a place of the net, in its own numbers."""
        return self.number[self.key(2 * i * self.step[0], 2 * j * self.step[1], 2 * k * self.step[2])]


def face_of(corner, u, v):
    """The eight places of a face whose sides run along the grid steps u and v."""
    return [tuple(corner[d] + u[d] * (1 + a) + v[d] * (1 + b) for d in range(3)) for a, b in FACE]


def tube(along=20, around=20, through=2):
    """Radii 5 and 2, length 60 along z, both ends clamped. The net: 21 rings of 20 nodes."""
    def place(i, j, k):
        angle, radius = math.pi * j / around, 2.0 + 3.0 * k / (2 * through)
        return (radius * math.cos(angle), radius * math.sin(angle), 60.0 * i / (2 * along))

    faces = [face_of((i, j, 2 * through), (0, 1, 0), (1, 0, 0))
             for i in range(0, 2 * along, 2) for j in range(0, 2 * around, 2)]
    body = Body("tube", (along, around, through), (20, 20, 1), place, 2 * around,
                lambda key: key[0] in (0, 2 * along), faces)
    body.net = [body.at(i, j, 1) for i in range(21) for j in range(20)]
    body.quads = [(20 * i + j, 20 * i + (j + 1) % 20, 20 * i + 20 + (j + 1) % 20, 20 * i + 20 + j)
                  for i in range(20) for j in range(20)]
    body.fixed = [n for n in range(420) if n < 20 or n >= 400]
    return body


def block(along=16, across=8, up=8):
    """40 x 20 x 20, its base z = 0 clamped. The net: its surface in squares of 5."""
    size = (along, across, up)

    def place(i, j, k):
        return (40.0 * i / (2 * along), 20.0 * j / (2 * across), 20.0 * k / (2 * up))

    def sides(counts, make):
        """Squares of all six sides, normals outwards."""
        out = []
        for d in range(3):
            u, v = np.eye(3, dtype=int)[(d + 1) % 3], np.eye(3, dtype=int)[(d + 2) % 3]
            for level in (0, counts[d]):
                for a in range(counts[(d + 1) % 3]):
                    for b in range(counts[(d + 2) % 3]):
                        corner = level * np.eye(3, dtype=int)[d] + a * u + b * v
                        out.append(make(corner, *((u, v) if level else (v, u))))
        return out

    faces = sides(size, lambda corner, u, v: face_of(tuple(2 * corner), tuple(u), tuple(v)))
    body = Body("block", size, (8, 4, 4), place, 0, lambda key: key[2] == 0, faces)
    number, body.net, body.quads = {}, [], []

    def net_node(corner):
        key = tuple(int(c) for c in corner)
        if key not in number:
            number[key] = len(body.net)
            body.net.append(body.at(*key))
        return number[key]

    for corners in sides((8, 4, 4), lambda c, u, v: (c, c + u, c + u + v, c + v)):
        body.quads.append(tuple(net_node(c) for c in corners))
    body.fixed = [n for key, n in number.items() if key[2] == 0]
    return body


def triangles(body):
    return [t for a, b, c, d in body.quads for t in ((a, b, c), (a, c, d))]


def eight(u, v):
    """Shape functions of the eight-node square and their slopes."""
    shape, slopes = np.zeros(8), np.zeros((2, 8))
    for n, (a, b) in enumerate(FACE):
        if n < 4:
            shape[n] = (1 + a * u) * (1 + b * v) * (a * u + b * v - 1) / 4
            slopes[:, n] = (a * (1 + b * v) * (2 * a * u + b * v) / 4, b * (1 + a * u) * (a * u + 2 * b * v) / 4)
        elif a == 0:
            shape[n], slopes[:, n] = (1 - u * u) * (1 + b * v) / 2, (-u * (1 + b * v), b * (1 - u * u) / 2)
        else:
            shape[n], slopes[:, n] = (1 - v * v) * (1 + a * u) / 2, (a * (1 - v * v) / 2, -v * (1 + a * u))
    return shape, slopes


def samples(body):
    """Points on the loaded surface: (face, shape functions, place, area)."""
    for face in body.faces:
        corners = body.points[face]
        for u, wu in GAUSS:
            for v, wv in GAUSS:
                shape, slopes = eight(u, v)
                tangents = slopes @ corners
                yield face, shape, shape @ corners, wu * wv * np.linalg.norm(np.cross(*tangents))
