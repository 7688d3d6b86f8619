#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
# Installs what is missing, builds, and runs every test: once as it is, and once more (without the slow ones, and those of
# the engine, which reads and writes no text) in a German locale, where numbers have a comma. Programs of others are built against the library, too (docs/EMBEDDING.md).
# usage: scripts/test.sh [--preset NAME] [ctest options...]
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

preset=release
if [ "${1:-}" = --preset ]; then
  preset=${2:?--preset needs a name of CMakePresets.json}
  shift 2
fi

esm_install "${esm_build_packages[@]}" "${esm_show_packages[@]}" "${esm_test_packages[@]}"
esm_build "$preset"
cd "$esm_root"

# Programs under test must not read or write the settings of whoever runs the tests.
home=$(mktemp -d)
trap 'rm -rf "$home"' EXIT
mkdir -m 700 "$home/runtime"
export XDG_CONFIG_HOME=$home/config XDG_STATE_HOME=$home/state XDG_CACHE_HOME=$home/cache
export XDG_DATA_HOME=$home/data XDG_RUNTIME_DIR=$home/runtime QT_QPA_PLATFORMTHEME= LC_ALL=C.UTF-8

esm_say "Testing ($preset)"
ctest --preset "$preset" "$@" | tee "$home/run.log"

# A locale of our own, so that nothing is changed on the machine.
esm_say "Testing in German ($preset)"
mkdir "$home/locale"
localedef -i de_DE -f UTF-8 "$home/locale/de_DE.UTF-8"
localedef -i C -f UTF-8 "$home/locale/C.UTF-8" 2>/dev/null || true
LOCPATH=$home/locale LC_ALL=de_DE.UTF-8 ctest --preset "$preset" -LE 'slow|engine' "$@" | tee -a "$home/run.log"

esm_say "What took how long (both runs, seconds of all processes)"
awk '$2 == "=" && $4 == "sec*proc" { seconds[$1] += $3 } END { for (l in seconds) printf "%8.1f  %s\n", seconds[l], l }' \
  "$home/run.log" | sort -rn
