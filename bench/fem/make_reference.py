#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
"""Makes bench/fem/data: what finite elements say of a tube and a block (CalculiX, `apt-get install calculix-ccx`).

    bench/fem/make_reference.py                         all cases, about an hour on one core
    bench/fem/make_reference.py tube tr01 te05          these cases of the tube
    bench/fem/make_reference.py --refine tube tr01      with finer elements: prints by how much they differ, writes nothing
    bench/fem/make_reference.py --coarse --refine block tr01    the same from coarse to usual elements

Compressible Neo-Hooke, E = 20 kPa, Poisson's ratio 0.45 (C10 = mu/2, D1 = 2/K), large motions, C3D20R. Each file
holds the load on the nodes of the net and their displacement at some shares of it; README.md has the format.
"""
import argparse
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

import bodies
import loads

E, NU = 20.0, 0.45
LEVELS = [0.1, 0.3, 0.6, 1.0]
FOLDER = pathlib.Path(__file__).resolve().parent / "data"
FINE = {"tube": lambda: bodies.tube(40, 20, 3), "block": lambda: bodies.block(24, 12, 12)}
COARSE = {"tube": lambda: bodies.tube(20, 20, 1), "block": lambda: bodies.block(8, 4, 4)}
USUAL = {"tube": bodies.tube, "block": bodies.block}


def lines_of(numbers, per_line=12):
    return "\n".join(", ".join(map(str, numbers[i:i + per_line])) + "," for i in range(0, len(numbers), per_line))


def deck(body, forces):
    mu, bulk = E / (2 * (1 + NU)), E / (3 * (1 - 2 * NU))
    text = ["*NODE, NSET=ALL"]
    text += [f"{n + 1}, {x:.12g}, {y:.12g}, {z:.12g}" for n, (x, y, z) in enumerate(body.points)]
    text.append("*ELEMENT, TYPE=C3D20R, ELSET=BODY")
    for e, brick in enumerate(body.bricks):
        numbers = [e + 1] + [n + 1 for n in brick]
        text += [", ".join(map(str, numbers[:11])) + ",", ", ".join(map(str, numbers[11:]))]
    text += ["*NSET, NSET=CLAMPED", lines_of([n + 1 for n in body.clamped])]
    text += ["*NSET, NSET=NET", lines_of([n + 1 for n in body.net])]
    text += ["*MATERIAL, NAME=TISSUE", "*HYPERELASTIC, NEO HOOKE", f"{mu / 2:.12g}, {2 / bulk:.12g}",
             "*SOLID SECTION, ELSET=BODY, MATERIAL=TISSUE", "*BOUNDARY", "CLAMPED, 1, 3",
             "*TIME POINTS, NAME=SHARES", ", ".join(map(str, LEVELS)) + ",",
             "*STEP, NLGEOM, INC=200", "*STATIC", "0.1, 1.0, 1e-4, 0.25", "*CLOAD"]
    text += [f"{n + 1}, {d + 1}, {forces[n, d]:.12g}" for n in range(len(forces)) for d in range(3) if forces[n, d]]
    text += ["*NODE PRINT, NSET=NET, TIME POINTS=SHARES", "U", "*NODE PRINT, NSET=CLAMPED, TOTALS=ONLY, TIME POINTS=SHARES",
             "RF", "*END STEP", ""]
    return "\n".join(text)


def solve(body, forces):
    """({share: displacements of the net [mm]}, relative error of the reactions' sum)."""
    with tempfile.TemporaryDirectory() as folder:
        pathlib.Path(folder, "case.inp").write_text(deck(body, forces))
        run = subprocess.run(["ccx", "-i", "case"], cwd=folder, capture_output=True, text=True, check=False)
        result = pathlib.Path(folder, "case.dat")
        if not result.exists():
            sys.exit("ccx left no result: " + run.stdout[-2000:])
        return read(body, result.read_text(), forces)


def read(body, text, forces):
    shares, worst, mode = {}, 0.0, None
    place = {n + 1: i for i, n in enumerate(body.net)}
    for line in text.splitlines():
        words = line.split()
        if line.lstrip().startswith("displacements"):
            level = min(LEVELS, key=lambda share: abs(share - float(words[-1])))
            if abs(level - float(words[-1])) > 1e-6:
                mode = None
                continue
            mode = shares[level] = np.zeros((len(body.net), 3))
        elif line.lstrip().startswith("total force"):
            mode, total_at = "total", float(words[-1])
        elif len(words) == 4 and isinstance(mode, np.ndarray):
            mode[place[int(words[0])]] = [float(w) for w in words[1:]]
        elif len(words) == 3 and mode == "total":
            reaction, applied = np.array([float(w) for w in words]), total_at * forces.sum(axis=0)
            size = total_at * np.abs(forces).sum()
            worst = max(worst, np.abs(reaction + applied).max() / size)
    return shares, worst


def write(body, name, kind, coarse, shares):
    """Displacements in micrometres, forces in micronewtons: whole numbers are short."""
    levels = sorted(shares)
    text = [f"# body {body.name}, case {name}, kind {kind}; CalculiX C3D20R {'x'.join(map(str, body.counts))}, "
            f"Neo-Hooke E {E:g} kPa nu {NU:g}",
            "# id of the net's node; force [uN]; displacement [um] at shares of the load " + " ".join(map(str, levels))]
    for n in range(len(body.net)):
        if n in body.fixed:
            continue
        numbers = [*(1e3 * coarse[n])] + [1e3 * u for level in levels for u in shares[level][n]]
        text.append(f"{n}," + ",".join(str(int(round(x))) for x in numbers))
    (FOLDER / f"{body.name}_{name}.csv").write_text("\n".join(text) + "\n")


def write_mesh(body):
    text = [f"# {body.name} [mm]; node ids count from 0 in the order of the v lines; fixed: "
            + " ".join(map(str, body.fixed))]
    text += [f"v {x:.9g} {y:.9g} {z:.9g}" for x, y, z in body.points[body.net]]
    text += [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in bodies.triangles(body)]
    (FOLDER / f"{body.name}.obj").write_text("\n".join(text) + "\n")


def free_of(body, field):
    return np.delete(field, body.fixed, axis=0)


def refine(name, cases):
    for case in cases:
        kind, case_loads = loads.CASES[name][case]
        fields = []
        for body in (USUAL[name](), FINE[name]()):
            fine, _ = loads.nodal_forces(body, case_loads)
            shares, _ = solve(body, fine)
            fields.append({level: free_of(body, u) for level, u in shares.items()})
        for level in sorted(set(fields[0]) & set(fields[1])):
            error = np.linalg.norm(fields[0][level] - fields[1][level]) / np.linalg.norm(fields[1][level])
            print(f"{name},{case},{kind},{level},{100 * error:.2f}", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("words", nargs="*", help="body, then cases")
    parser.add_argument("--refine", action="store_true")
    parser.add_argument("--coarse", action="store_true", help="with elements twice as wide: an eighth of the time")
    wanted = parser.parse_args()
    if wanted.coarse:
        FINE.update(USUAL)
        USUAL.update(COARSE)
    names = [wanted.words[0]] if wanted.words else list(USUAL)
    FOLDER.mkdir(exist_ok=True)
    if wanted.refine:
        print("body,case,kind,share_of_load,difference_percent")
        for name in names:
            refine(name, wanted.words[1:] or list(loads.CASES[name]))
        return
    print("body,case,kind,shares,peak_mm,reaction_error")
    for name in names:
        body = USUAL[name]()
        write_mesh(body)
        for case in wanted.words[1:] or list(loads.CASES[name]):
            kind, case_loads = loads.CASES[name][case]
            fine, coarse = loads.nodal_forces(body, case_loads)
            shares, error = solve(body, fine)
            peak = max((np.linalg.norm(u, axis=1).max() for u in shares.values()), default=0.0)
            print(f"{name},{case},{kind},{len(shares)},{peak:.2f},{error:.1e}", flush=True)
            if shares:
                write(body, case, kind, coarse, shares)


if __name__ == "__main__":
    main()
