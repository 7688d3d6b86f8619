#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
# Runs every benchmark, writes CSV into build/bench/ and makes docs/BENCHMARKS.md with its pictures.
# References and tuned steps of the competitors are kept in ESM_BENCH_CACHE (the user's cache folder): the first run
# takes much longer.   usage: scripts/bench.sh [--quick]   (--quick: small scenes, few minutes, docs stay as they are)
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

quick=
[ "${1:-}" = --quick ] && quick=--quick

esm_install "${esm_build_packages[@]}" "${esm_bench_packages[@]}"
if [ -f "$esm_root/build/release/build.ninja" ]; then # packages may have come since it was configured
  cmake "$esm_root/build/release" >/dev/null
fi
esm_build release esm_bench
cd "$esm_root"
out=build/bench
mkdir -p "$out"
bench=build/release/bin/esm_bench
export OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1

# run NAME WORDS...: one benchmark into its CSV; one that was left out (its package is missing) leaves none.
run() {
  esm_say "$*"
  "$bench" "$@" >"$out/$1.csv" || { rm -f "$out/$1.csv"; echo "left out: $1"; }
}

if [ -n "$quick" ]; then
  "$bench" work_precision tube uterus --no-fixed --runs 3 --csv "$out/points.csv" --table "$out/table.md"
else
  "$bench" work_precision tube tube:seed=7,size=2 uterus sheet stiff organ100k --runs 5 --cap 40 \
    --csv "$out/points.csv" --table "$out/table.md"
  # The methods that never win, on one scene, for scale.
  "$bench" work_precision tube --all --no-fixed --ours verlet --patience 20 --cap 8 --runs 1 \
    --csv "$out/points_all.csv" >/dev/null
fi
run kernel $quick
run realtime $quick
run growth $quick
run stability $quick
run skip $quick

# Debian's own Python, which has the matplotlib installed above.
/usr/bin/python3 scripts/plot_bench.py "$out" ${quick:+--pictures-only "$out"}
