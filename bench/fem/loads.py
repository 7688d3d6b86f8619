# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
"""The load cases: dead tractions that fade as cos^2 from the middle of a patch to its rim.

A patch is (centre, force, radius) [mm, mN]. A twist is (centre, axis, moment, radius) [mm, -, mN mm]: forces around
the axis; on the tube they fade along it, on the block away from it. tr: to fit with; te: to judge on.
"""
import math

import numpy as np

from bodies import samples


def on_tube(z, degrees):
    angle = math.radians(degrees)
    outwards = np.array([math.cos(angle), math.sin(angle), 0.0])
    return 5.0 * outwards + [0.0, 0.0, z], outwards


def push(z, degrees, force, radius=5.0, along=0.0, around=0.0):
    """Inwards by `force`, with shares of it along the tube and around it."""
    place, outwards = on_tube(z, degrees)
    tangent = np.array([-outwards[1], outwards[0], 0.0])
    return [(place, -force * outwards + along * np.array([0, 0, 1.0]) + around * tangent, radius)]


def pinch(z, degrees, force, radius=5.0):
    return push(z, degrees, force, radius) + push(z, degrees + 180.0, force, radius)


def twist(z, moment, radius=8.0):
    return [(np.array([0, 0, z]), np.array([0, 0, 1.0]), moment, radius)]


def at(place, force, radius):
    return [(np.array(place, float), np.array(force, float), radius)]


CASES = {
    "tube": {
        "tr01": ("poke", push(30, 0, 36)), "tr02": ("poke", push(15, 90, 70)), "tr03": ("poke", push(42, 200, 50, 7)),
        "tr04": ("pull", push(30, 45, -36)), "tr05": ("pull", push(18, 290, -60, 7)),
        "tr06": ("drag", push(30, 120, 0, 6, along=110)), "tr07": ("drag", push(20, 0, 0, 6, around=50)),
        "tr08": ("pinch", pinch(30, 0, 110)), "tr09": ("pinch", pinch(20, 60, 120, 7)),
        "tr10": ("twist", twist(30, 170)), "tr11": ("twist", twist(18, 240)),
        "tr12": ("drag", push(36, 250, 25, 6, along=60, around=15)),
        "te01": ("poke", push(24, 160, 42, 6)), "te02": ("poke", push(48, 310, 110, 6)),
        "te03": ("pull", push(38, 220, -44, 5)), "te04": ("drag", push(40, 75, 0, 7, along=-110)),
        "te05": ("pinch", pinch(33, 25, 115, 6)), "te06": ("pinch", pinch(42, 100, 100, 5)),
        "te07": ("twist", twist(38, -200, 10)), "te08": ("poke", push(27, 340, 30, 6, along=45, around=-20)),
    },
    "block": {
        "tr01": ("poke", at((20, 10, 20), (0, 0, -330), 8)), "tr02": ("poke", at((10, 8, 20), (0, 0, -260), 7)),
        "tr03": ("poke", at((20, 0, 12), (0, 280, 0), 7)), "tr04": ("pull", at((26, 12, 20), (0, 0, 300), 8)),
        "tr05": ("pull", at((12, 20, 11), (0, 260, 0), 7)), "tr06": ("drag", at((20, 10, 20), (330, 0, 0), 8)),
        "tr07": ("drag", at((28, 8, 20), (0, 300, 0), 8)),
        "tr08": ("pinch", at((20, 0, 12), (0, 300, 0), 7) + at((20, 20, 12), (0, -300, 0), 7)),
        "tr09": ("pinch", at((0, 10, 12), (300, 0, 0), 7) + at((40, 10, 12), (-300, 0, 0), 7)),
        "tr10": ("twist", [(np.array([20.0, 10, 20]), np.array([0, 0, 1.0]), 2200, 10.0)]),
        "tr11": ("twist", [(np.array([12.0, 10, 20]), np.array([0, 0, 1.0]), -2000, 9.0)]),
        "tr12": ("drag", at((14, 10, 20), (180, 120, -150), 8)),
        "te01": ("poke", at((24, 12, 20), (0, 0, -320), 8)), "te02": ("poke", at((30, 20, 13), (0, -260, 0), 7)),
        "te03": ("pull", at((14, 8, 20), (0, 0, 280), 8)), "te04": ("drag", at((24, 10, 20), (-240, 200, 0), 8)),
        "te05": ("pinch", at((26, 0, 13), (0, 280, 0), 7) + at((26, 20, 13), (0, -280, 0), 7)),
        "te06": ("pinch", at((12, 0, 11), (0, 260, 0), 7) + at((12, 20, 11), (0, -260, 0), 7)),
        "te07": ("twist", [(np.array([26.0, 10, 20]), np.array([0, 0, 1.0]), 2000, 9.0)]),
        "te08": ("drag", at((16, 12, 20), (-160, 100, -160), 8)),
    },
}


def fade(distance, radius):
    return math.cos(0.5 * math.pi * distance / radius) ** 2 if distance < radius else 0.0


def densities(body, load):
    """Traction per unit of the load at a place, not yet scaled."""
    if len(load) == 3:
        centre, force, radius = load
        return lambda x: fade(np.linalg.norm(x - centre), radius) * force
    centre, axis, moment, radius = load

    def around(x):
        away = x - centre
        along = axis @ away
        across = away - along * axis
        distance = abs(along) if body.name == "tube" else (np.linalg.norm(across) if abs(along) < 1e-9 else radius)
        return fade(distance, radius) * moment * np.cross(axis, across)
    return around


def scale(load, points):
    """What makes the sampled traction the wished force or moment."""
    if len(load) == 3:
        total = sum(traction * area for _, _, _, area, traction in points)
        return np.linalg.norm(load[1]) / np.linalg.norm(total)
    centre, axis, moment, _ = load
    return moment / sum(axis @ np.cross(x - centre, traction) * area for _, _, x, area, traction in points)


def nodal_forces(body, loads):
    """(forces on the elements' nodes, forces on the net's nodes) [mN], both of the same traction."""
    fine, coarse = np.zeros(body.points.shape), np.zeros((len(body.net), 3))
    corners = [body.points[[body.net[n] for n in quad]] for quad in body.quads]
    middles = np.array([c.mean(axis=0) for c in corners])
    for load in loads:
        density = densities(body, load)
        points = [(face, shape, x, area, density(x)) for face, shape, x, area in samples(body)]
        points = [p for p in points if p[4].any()]
        factor = scale(load, points)
        for face, shape, x, area, traction in points:
            force = factor * area * traction
            fine[face] += np.outer(shape, force)
            quad = int(np.argmin(((middles - x) ** 2).sum(axis=1)))
            coarse[list(body.quads[quad])] += np.outer(four(corners[quad], x), force)
    return fine, coarse


def four(corners, x):
    """Shares of a square's corners in a place on it, so that force and moment stay."""
    u = v = 0.0
    for _ in range(8):
        shape = np.array([(1 - u) * (1 - v), (1 + u) * (1 - v), (1 + u) * (1 + v), (1 - u) * (1 + v)]) / 4
        by_u = np.array([-(1 - v), 1 - v, 1 + v, -(1 + v)]) / 4
        by_v = np.array([-(1 - u), -(1 + u), 1 + u, 1 - u]) / 4
        jacobian = np.stack([by_u @ corners, by_v @ corners], axis=1)
        du, dv = np.linalg.lstsq(jacobian, x - shape @ corners, rcond=None)[0]
        u, v = np.clip(u + du, -1, 1), np.clip(v + dv, -1, 1)
    return np.array([(1 - u) * (1 - v), (1 + u) * (1 - v), (1 + u) * (1 + v), (1 - u) * (1 + v)]) / 4
