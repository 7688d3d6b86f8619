#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
"""Pictures and docs/BENCHMARKS.md from the CSV files of scripts/bench.sh.

usage: plot_bench.py CSV_FOLDER [--pictures-only FOLDER]
"""
import csv
import pathlib
import platform
import sys
from collections import defaultdict

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parent.parent


def save(figure, target):
    figure.tight_layout()
    figure.savefig(target, dpi=90)
    plt.close(figure)


def read(folder, name):
    path = folder / name
    if not path.exists():
        return []
    with open(path, newline="", encoding="utf-8") as file:
        return [row for row in csv.DictReader(file) if None not in row.values()]


def front(points):
    """Those points that no other beats in both time and error."""
    best, kept = float("inf"), []
    for seconds, error in sorted(points):
        if error < best:
            best = error
            kept.append((error, seconds))
    return kept


def plot_work(rows, target, title):
    scenes = list(dict.fromkeys(row["scene"] for row in rows))
    if not scenes:
        return False
    columns = min(3, len(scenes))
    lines = (len(scenes) + columns - 1) // columns
    figure, axes = plt.subplots(lines, columns, figsize=(5.2 * columns, 4.4 * lines), squeeze=False)
    for axis in axes.flat[len(scenes):]:
        axis.set_visible(False)
    names = list(dict.fromkeys(row["method"] for row in rows))
    colours = {name: plt.cm.tab20(i % 20) for i, name in enumerate(names)}
    for axis, scene in zip(axes.flat, scenes):
        curves = defaultdict(list)
        for row in rows:
            if row["scene"] == scene and row["error"]:
                curves[(row["method"], row["ours"])].append((float(row["seconds"]), float(row["error"])))
        for (name, ours), points in curves.items():
            kept = front(points)
            style = "-" if ours == "1" else "--"
            width = 2.6 if name == "auto" else 1.2
            axis.loglog([e for e, _ in kept], [s for _, s in kept], style, marker=".", linewidth=width,
                        color="black" if name == "auto" else colours[name], label=name)
        axis.set_title(scene)
        axis.set_xlabel("measured error")
        axis.set_ylabel("processor time [s]")
        axis.set_xlim(1, 1e-8)
        axis.grid(True, which="major", alpha=0.3)
        axis.legend(fontsize=6)
    figure.suptitle(title)
    save(figure, target)
    return True


def plot_stability(rows, target):
    if not rows:
        return False
    methods = list(dict.fromkeys(row["method"] for row in rows))
    columns = 5
    lines = (len(methods) + columns - 1) // columns
    figure, axes = plt.subplots(lines, columns, figsize=(3.1 * columns, 2.5 * lines), squeeze=False, sharex=True)
    for axis in axes.flat[len(methods):]:
        axis.set_visible(False)
    for axis, method in zip(axes.flat, methods):
        for row in rows:
            if row["method"] != method:
                continue
            x, y = float(row["stiffness_decades"]), float(row["second_decades"])
            if row["axis"] == "viscosity":
                y = {-9.0: 15.0, -3.0: 16.5, 3.0: 18.0, 6.0: 19.5}[y]
            good = row["bounded"] == "1"
            axis.plot(x, y, "o" if good else "x", color="tab:green" if good else "tab:red", markersize=5)
        axis.set_title(method, fontsize=9)
        axis.set_yticks([0, 6, 12, 15, 16.5, 18, 19.5])
        axis.set_yticklabels(["0", "6", "12", "c = 0", "c/1e3", "c*1e3", "c*1e6"], fontsize=6)
        axis.set_xticks([0, 3, 6, 9])
    figure.supxlabel("stiffness, decades above the tube's")
    figure.supylabel("below: decades of mass spread; above: viscosity", fontsize=9)
    save(figure, target)
    return True


def plot_growth(rows, target):
    if not rows:
        return False
    nodes = [float(row["nodes"]) for row in rows]
    figure, axis = plt.subplots(figsize=(6, 4.4))
    axis.loglog(nodes, [float(row["seconds_per_frame"]) for row in rows], "o-", label="auto, one frame of motion")
    axis.loglog(nodes, [float(row["force_pass_s"]) for row in rows], "s--", label="one force pass")
    axis.axhline(1 / 60, color="grey", linewidth=0.8)
    axis.text(nodes[0], 1.15 / 60, "1/60 s", fontsize=8)
    axis.set_xlabel("nodes")
    axis.set_ylabel("processor time [s]")
    axis.grid(True, alpha=0.3)
    axis.legend()
    save(figure, target)
    return True


def table(rows):
    if not rows:
        return "Not measured in the run that made this page.\n"
    heads = list(rows[0])
    lines = ["| " + " | ".join(head.replace("_", " ") for head in heads) + " |", "|" + "---|" * len(heads)]
    shown = {None: "", "nan": ""}  # what was not measured
    lines += ["| " + " | ".join(shown.get(row[head], row[head]) for head in heads) + " |" for row in rows]
    return "\n".join(lines) + "\n"


def bounded_table(rows):
    counts = defaultdict(lambda: [0, 0, 0.0])
    for row in rows:
        count = counts[row["method"]]
        count[0] += int(row["bounded"])
        count[1] += 1
        count[2] += float(row["seconds_per_frame"])
    lines = ["| method | bounded | mean ms per frame |", "|---|---|---|"]
    lines += [f"| {name} | {good} of {all_} | {1e3 * seconds / all_:.3g} |"
              for name, (good, all_, seconds) in counts.items()]
    return "\n".join(lines) + "\n"


def processor():
    try:
        for line in open("/proc/cpuinfo", encoding="utf-8"):
            if line.startswith("model name"):
                return line.split(":", 1)[1].strip()
    except OSError:
        pass
    return platform.processor() or platform.machine()


def real_time_sentence(rows):
    shares = [(int(r["nodes"]), int(r["springs"]), float(r["mean_share"])) for r in rows]
    keeping = [s for s in shares if s[2] < 1.0]
    if not shares or not keeping:
        return "No net of this series kept real time.\n"
    free = 100 * (1 - shares[0][2])
    nodes, springs, _ = keeping[-1]
    free_moving = 100 * (1 - float(rows[0]["moving_share"]))
    return (f"The uterus leaves {free:.0f} % of the frame time free on average, {free_moving:.0f} % while it moves. "
            f"The largest net of the series that keeps real time on average has {nodes} nodes and {springs} springs.\n")


def document(folder, work_table, points_all, kernel, realtime, growth, stability, skip):
    all_methods = ("" if not points_all else " For scale, the methods that never win, on the tube:\n\n"
                   "![All methods on the tube](images/bench-all.png)")
    text = f"""# Benchmarks

Generated by `scripts/bench.sh` on {processor()}, one thread, {platform.system()} {platform.release()}. The machine
was a shared virtual one: seconds are its own and ratios under 1.3 mean nothing. `scripts/bench.sh` makes this page
anew with your own numbers; `scripts/bench.sh --quick` needs minutes and leaves this page alone. Single questions:
`esm_bench work_precision tube:seed=7,size=2 stiff`, and `esm_bench kernel`, `growth`, `realtime`, `stability`, `skip`, `fit`, `holdout`.
`esm_bench work_precision --again bench/candidates.csv [SCENE...] [--runs N] [--budget SECONDS]` times the settings that searches
found best, and `auto`, without searching anew: the rows of tube, uterus, sheet and stiff in a quarter of an hour.

## What is measured

**Error**: RMS over nodes and frames of the position error over RMS of the displacement
([FILE_FORMAT.md](FILE_FORMAT.md)). **Reference**: a textbook program with the classical Runge-Kutta method, checked by
an adaptive Dormand-Prince pair on another kernel; a cell counts only where the two agree ten times better than the
error asked for. **Time**: processor time of one thread with set-up, median of up to five runs (fewer where a round of
all candidates takes long), all candidates in turn.

**Competitors** (`bench/reference`) share no code with the engine: symplectic Euler, velocity Verlet with predicted
velocity, classical Runge-Kutta, Dormand-Prince 5(4), linearised implicit Euler with conjugate gradients and with
Cholesky, fast mass springs, XPBD, and CVODE and ARKODE of SUNDIALS. They stand on a kernel of their own: nodes renumbered
breadth-first, four springs at a time, AVX2 and FMA. Their steps are tuned by search on the scene itself, to 4 % at
each winning cell, which nobody can do in advance; `auto` gets the tolerance and the length of the run. The adaptive ones also know the scales of the motion beforehand.

**Scenes**: tube (400 nodes, linear), uterus (1,250, exponential), sheet (10,000, linear), stiff (400; stiffness over six decades, masses
over four), organ100k (100,002 nodes, 300,000 cubic springs, 0.2 s); variants by seed and size.

## Run time against error

`auto` has `--tolerance` equal to the error of its line and knows how long the run is, as in `esm simulate`. *Best of ours* is the fastest setting that a search found, fixed steps at the edge of
stability among them; *best named with that tolerance* is what a user gets who names a method (`--solver`) and gives the same tolerance. *Auto at any tolerance* is `auto` measured as the others are: by the fastest of its settings whose error came out below. A scene that
is missing here was not part of the run that made this page.

{work_table}
![Run time against error](images/bench-work.png)

Broken lines are competitors.{all_methods}

## The force pass

Nanoseconds per spring, least of several repetitions, and what the machine allows: the arithmetic of a linear spring on
data in the first cache, its division and square root alone, and the memory stream alone of a net far beyond the caches
(75 bytes a spring). Each with its share of the nodes (clearing the forces, weight, anchors); *springs alone* is without
weight and anchors, *kept dampers* the viscous forces alone, *plain* the competitors' kernel.

{table(kernel)}
## Real time

The uterus, pulled by 10 mm and let go, all of it moving, tolerance 1e-2; shares of 1/60 s of one core, then the same
organ with a finer net until it does not keep up.

{table(realtime)}
{real_time_sentence(realtime)}
## Growth

The poked organ from 100 to 1,000,000 nodes, the first frames, tolerance 1e-2. Growing the net without growing the organ
shortens the springs but not their steps: masses and stiffness per element stay.

{table(growth)}
![Growth](images/bench-growth.png)

## Stability

The tube, its stiffness multiplied by up to 1e9, against masses spread over up to twelve decades, and against viscosity
from none to a million times its own; twenty frames, one step of 1/60 s per frame (`auto`: as many steps as a frame of
a display bears). Green: stayed finite and near. Explicit methods cannot at such steps; they are shown so that nobody
has to believe it.

{bounded_table(stability)}
![Stability](images/bench-stability.png)

## Skipping what rests

{table(skip)}"""
    (ROOT / "docs" / "BENCHMARKS.md").write_text(text, encoding="utf-8")


def main():
    folder = pathlib.Path(sys.argv[1])
    pictures_only = "--pictures-only" in sys.argv
    images = pathlib.Path(sys.argv[-1]) if pictures_only else ROOT / "docs" / "images"
    points, points_all = read(folder, "points.csv"), read(folder, "points_all.csv")
    growth, stability = read(folder, "growth.csv"), read(folder, "stability.csv")
    plot_work(points, images / "bench-work.png", "")
    plot_work(points_all, images / "bench-all.png", "")
    plot_growth(growth, images / "bench-growth.png")
    plot_stability(stability, images / "bench-stability.png")
    if pictures_only:
        return
    work_table = (folder / "table.md").read_text(encoding="utf-8")
    document(folder, work_table, points_all, read(folder, "kernel.csv"), read(folder, "realtime.csv"), growth,
             stability, read(folder, "skip.csv"))


if __name__ == "__main__":
    main()
