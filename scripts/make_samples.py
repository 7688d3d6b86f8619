#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
"""Makes the sample organs of resources/samples and counts.json, what `esm inspect` must print for them.

    scripts/make_samples.py            writes into resources/samples
    scripts/make_samples.py --out DIR  writes elsewhere
    scripts/make_samples.py --check    makes them anew and compares with resources/samples, byte for byte

Python's standard library only. All lengths in mm. Coordinates are rounded before they are written, so that
the last bits of sin() on another machine do not matter. The counts come from the data here, by plain
dictionaries, and share no code with the program that they test.
"""

import argparse
import filecmp
import json
import math
import struct
import sys
import tempfile
from pathlib import Path

SAMPLES = Path(__file__).resolve().parent.parent / "resources" / "samples"
HEADER = "Made by scripts/make_samples.py. Units: mm."


# === Surfaces ================================================================================================

def capsule_rings(cap, belt):
    """Sizes of the rings of a stretched icosahedron: 1, 5, 10, ... up to 5 cap, `belt` of those, and back.

    Its triangles are all nearly alike, the poles included: six around each vertex, five at twelve of them.
    """
    grow = [max(1, 5 * k) for k in range(cap)]
    return grow + [5 * cap] * belt + grow[::-1]


def capsule_triangles(cap, belt):
    """Corner numbers, outward (counter-clockwise from outside) when rings run down and angles run left."""
    sizes = capsule_rings(cap, belt)
    start = [sum(sizes[:i]) for i in range(len(sizes))]
    triangles = []

    def widening(upper, lower, k):
        """From a ring of 5 k to one of 5 (k + 1); each returned triangle as (ring, place) pairs."""
        for sector in range(5):
            for i in range(k + 1):
                a, b = sector * k + i, sector * (k + 1) + i
                yield (upper, a), (lower, b), (lower, b + 1)
                if i < k:
                    yield (upper, a), (lower, b + 1), (upper, a + 1)

    def number(place):
        ring, i = place
        return start[ring] + i % sizes[ring]

    last = len(sizes) - 1
    for k in range(cap):
        for p, q, r in widening(k, k + 1, k):
            triangles.append((number(p), number(q), number(r)))
    for ring in range(cap, cap + belt - 1):
        for i in range(5 * cap):  # the lower ring is turned by half a step
            triangles.append((number((ring, i)), number((ring + 1, i)), number((ring, i + 1))))
            triangles.append((number((ring, i + 1)), number((ring + 1, i)), number((ring + 1, i + 1))))
    for k in range(cap):
        for p, q, r in widening(last - k, last - k - 1, k):
            triangles.append((number(p), number(r), number(q)))
    return triangles


def capsule_angles(cap, belt):
    """The angle of each vertex, ring by ring."""
    sizes = capsule_rings(cap, belt)
    half = math.pi / (5 * cap)
    turn = [half * min(max(ring - cap, 0), belt - 1) for ring in range(len(sizes))]
    return [[turn[ring] + 2 * math.pi * i / size for i in range(size)] for ring, size in enumerate(sizes)]


def spread_rings(sizes, height, radius):
    """Places the rings on a meridian (height(t), radius(t)), t from 0 to 1, so that triangles stay even:
    the gap between two rings grows with the mean step within them."""
    steps = 4000
    t = [i / steps for i in range(steps + 1)]
    length = [0.0]
    for a, b in zip(t, t[1:]):
        length.append(length[-1] + math.hypot(height(b) - height(a), radius(b) - radius(a)))
    total, gaps = length[-1], len(sizes) - 1

    def at_length(wanted):
        i = min(max(next((k for k, s in enumerate(length) if s >= wanted), steps), 1), steps)
        share = (wanted - length[i - 1]) / (length[i] - length[i - 1])
        return t[i - 1] + share * (t[i] - t[i - 1])

    gap = [total / gaps] * gaps
    for _ in range(30):
        place, reached = [0.0], 0.0
        for g in gap:
            reached += g
            place.append(at_length(min(reached, total)))
        place[-1] = 1.0
        step = [2 * math.pi * radius(p) / size for p, size in zip(place, sizes)]
        step[0], step[-1] = step[1], step[-2]
        mean = sum(step) / len(step)
        wish = [0.5 * mean + 0.25 * (a + b) for a, b in zip(step, step[1:])]
        scale = total / sum(wish)
        gap = [0.5 * g + 0.5 * scale * w for g, w in zip(gap, wish)]
    return place


def organ(cap, belt, length, girth, flatness, bend):
    """A closed, pear-shaped surface: axis along z from `length` (fundus, first vertex) to 0.

    girth(c): half width [mm] before rounding off, c = 1 at the fundus, -1 at the other end;
    flatness: thickness / width; bend(z): shift along y [mm].
    """
    def height(t):
        return 0.5 * length * (1.0 + math.cos(math.pi * t))

    def radius(t):
        return math.sin(math.pi * t) * girth(math.cos(math.pi * t))

    places = spread_rings(capsule_rings(cap, belt), height, radius)
    vertices = []
    for t, angles in zip(places, capsule_angles(cap, belt)):
        z, r = height(t), radius(t)
        for angle in angles:
            vertices.append((r * math.cos(angle), flatness * r * math.sin(angle) + bend(z), z))
    return vertices, capsule_triangles(cap, belt)


def uterus():
    """75 mm long, fundus about 45 mm wide, cervix about 20 mm; nodes + springs = 5,002."""
    def girth(c):
        return 19.0 + 8.0 * math.tanh(2.2 * (c - 0.05)) + 3.0 * math.exp(-(((c + 0.75) / 0.25) ** 2))

    return organ(10, 16, 75.0, girth, 0.75, lambda z: 9.0 * (z / 75.0) ** 2)


def gallbladder():
    """80 mm long, fundus about 30 mm wide, with struts from wall to wall that stand for its filling."""
    cap, belt = 4, 15
    vertices, triangles = organ(cap, belt, 80.0, lambda c: 12.0 + 4.5 * math.tanh(1.8 * c), 0.9,
                                lambda z: 6.0 * math.sin(math.pi * z / 80.0))
    sizes = capsule_rings(cap, belt)
    struts, start = [], 0
    for size in sizes:
        if size % 2 == 0:
            struts += [(start + i, start + i + size // 2) for i in range(size // 2)]
        start += size
    return vertices, triangles, struts


def fallopian_tube():
    """40 rings of 10 nodes on a curved line of 60 mm, 2 mm radius at the uterus to 5 mm at the ampulla."""
    rings, around, length = 40, 10, 60.0

    def direction(s):  # the angle of the centre line in the x-z plane
        return 0.9 * math.sin(1.15 * math.pi * s / length) - 0.35

    def radius(s):
        u = s / length
        swell = 2.0 + 3.0 * math.exp(-(((u - 0.72) / 0.27) ** 2))
        rounding = 0.35 * (math.exp(-s / 1.5) + math.exp(-(length - s) / 1.5))
        return swell * (1.0 - rounding)

    vertices, x, z, fine = [], 0.0, 0.0, 50
    gap = length / (rings - 1)
    for ring in range(rings):
        s = ring * gap
        side = (-math.sin(direction(s)), math.cos(direction(s)))
        for i in range(around):
            angle = 2 * math.pi * (i + 0.5 * ring) / around
            p, q = radius(s) * math.cos(angle), radius(s) * math.sin(angle)
            vertices.append((x + side[0] * p, q, z + side[1] * p))
        for k in range(fine):  # midpoint rule along the centre line
            middle = direction(s + (k + 0.5) * gap / fine)
            x, z = x + math.cos(middle) * gap / fine, z + math.sin(middle) * gap / fine

    triangles = []
    for ring in range(rings - 1):
        low, high = ring * around, (ring + 1) * around
        for i in range(around):
            j = (i + 1) % around
            triangles.append((low + i, low + j, high + i))
            triangles.append((low + j, high + j, high + i))
    first, last = lid(around), lid(around)
    triangles += [(a, c, b) for a, b, c in first]
    triangles += [tuple((rings - 1) * around + v for v in corners) for corners in last]
    return vertices, [(a, c, b) for a, b, c in triangles]


def lid(around):
    """A polygon cut in a zigzag, so that no corner becomes a hub."""
    low, high, triangles = 0, around - 1, []
    while high - low >= 2:
        triangles.append((low, low + 1, high))
        low += 1
        if high - low >= 2:
            triangles.append((low, high - 1, high))
            high -= 1
    return triangles


# === Files ===================================================================================================

def rounded(vertices):
    return [tuple(round(c, 5) + 0.0 for c in v) for v in vertices]


def obj_bytes(name, vertices, triangles, lines=()):
    text = [f"# {HEADER}", f"o {name}"]
    text += ["v {:.5f} {:.5f} {:.5f}".format(*v) for v in vertices]
    text += ["f {} {} {}".format(*(i + 1 for i in t)) for t in triangles]
    text += ["l {} {}".format(a + 1, b + 1) for a, b in lines]
    return ("\n".join(text) + "\n").encode("ascii")


def stl_bytes(name, vertices, triangles):
    out = [f"{name}. {HEADER}".encode("ascii").ljust(80), struct.pack("<I", len(triangles))]
    for t in triangles:
        a, b, c = (vertices[i] for i in t)
        u, v = [q - p for p, q in zip(a, b)], [q - p for p, q in zip(a, c)]
        n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
        size = math.sqrt(sum(x * x for x in n)) or 1.0
        normal = [round(x / size, 4) + 0.0 for x in n]
        out.append(struct.pack("<12fH", *normal, *a, *b, *c, 0))
    return b"".join(out)


def as_float32(vertices):
    return [struct.unpack("<3f", struct.pack("<3f", *v)) for v in vertices]


# === Counts ==================================================================================================

def counts(vertices, triangles, lines=()):
    """What a welded net of these faces and lines consists of."""
    first = {}
    join = [first.setdefault(v, len(first)) for v in vertices]
    points = list(first)
    triangles = [tuple(join[i] for i in t) for t in triangles]
    lines = [tuple(join[i] for i in s) for s in lines]

    faces_at = {}
    for t in triangles:
        for edge in {frozenset((t[i], t[(i + 1) % 3])) for i in range(3)}:
            if len(edge) == 2:
                faces_at[edge] = faces_at.get(edge, 0) + 1
    edges = set(faces_at) | {frozenset(s) for s in lines if s[0] != s[1]}
    neighbours = {}
    for a, b in (tuple(edge) for edge in edges):
        neighbours.setdefault(a, []).append(b)
        neighbours.setdefault(b, []).append(a)
    seen, components = set(), 0
    for node in neighbours:
        if node in seen:
            continue
        components += 1
        stack = [node]
        while stack:
            here = stack.pop()
            if here not in seen:
                seen.add(here)
                stack += neighbours[here]

    def is_degenerate(t):
        if len(set(t)) < 3:
            return True
        a, b, c = (math.dist(points[t[i]], points[t[(i + 1) % 3]]) for i in range(3))
        return max(a, b, c) >= (a + b + c - max(a, b, c)) * (1 - 1e-12)  # on one line

    return {
        "nodes": len(points),
        "springs": len(edges),
        "triangles": len(triangles),
        "components": components,
        "isolated_vertices": len(points) - len(neighbours),
        "boundary_edges": sum(n == 1 for n in faces_at.values()),
        "nonmanifold_edges": sum(n > 2 for n in faces_at.values()),
        "degenerate_faces": sum(map(is_degenerate, triangles)),
        "duplicate_faces": len(triangles) - len({frozenset(t) for t in triangles}),
        "nonfinite_vertices": sum(not all(map(math.isfinite, p)) for p in points),
        "bbox_min": [min(p[k] for p in points) for k in range(3)],
        "bbox_max": [max(p[k] for p in points) for k in range(3)],
        "finite": all(math.isfinite(c) for p in points for c in p),
        "sum_rest_length": math.fsum(sorted(math.dist(*(points[i] for i in edge)) for edge in edges)),
    }


def make(folder):
    folder.mkdir(parents=True, exist_ok=True)
    table = {}

    vertices, triangles = fallopian_tube()
    vertices = rounded(vertices)
    (folder / "fallopian_tube.obj").write_bytes(obj_bytes("fallopian_tube", vertices, triangles))
    table["fallopian_tube.obj"] = counts(vertices, triangles)

    vertices, triangles = uterus()
    vertices = as_float32(rounded(vertices))
    (folder / "uterus.stl").write_bytes(stl_bytes("Uterus", vertices, triangles))
    table["uterus.stl"] = counts(vertices, triangles)

    vertices, triangles, struts = gallbladder()
    vertices = rounded(vertices)
    (folder / "gallbladder.obj").write_bytes(obj_bytes("gallbladder", vertices, triangles, struts))
    table["gallbladder.obj"] = counts(vertices, triangles, struts)

    (folder / "counts.json").write_text(json.dumps(table, indent=2) + "\n", encoding="ascii")
    return sorted(table) + ["counts.json"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--out", type=Path, default=SAMPLES, help="folder to write into")
    parser.add_argument("--check", action="store_true", help="compare with resources/samples, write nothing")
    options = parser.parse_args()
    if not options.check:
        for name in make(options.out):
            print(options.out / name)
        return 0
    with tempfile.TemporaryDirectory() as folder:
        names = make(Path(folder))
        _, differ, absent = filecmp.cmpfiles(folder, SAMPLES, names, shallow=False)
    for name in differ + absent:
        print(f"resources/samples/{name}: is not what scripts/make_samples.py makes; run it", file=sys.stderr)
    return 1 if differ or absent else 0


if __name__ == "__main__":
    sys.exit(main())
