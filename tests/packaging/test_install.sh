#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
# An installed tree works by itself: its programs find their worker and their samples, wherever it lies.
# usage: test_install.sh CMAKE BUILD_FOLDER
set -euo pipefail
cmake=$1
build=$2
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT

"$cmake" --install "$build" --prefix "$tree/somewhere" >"$tree/log" || { cat "$tree/log"; exit 1; }
mv "$tree/somewhere" "$tree/else where" # no path may have been built in
cd "$tree"
esm="$tree/else where/bin/esm"
samples="$tree/else where/share/esm/samples"

"$esm" import "$samples/fallopian_tube.obj" --unit mm -o tube.esm
"$esm" validate tube.esm
# AC3D comes in through assimp, and so through the worker beside the program.
cat >triangle.ac <<'E2'
AC3Db
MATERIAL "white" rgb 1 1 1  amb 1 1 1  emis 0 0 0  spec 0 0 0  shi 10  trans 0
OBJECT world
kids 1
OBJECT poly
name "t"
numvert 3
0 0 0
1 0 0
0 1 0
numsurf 1
SURF 0x00
mat 0
refs 3
0 0 0
1 0 0
2 0 0
kids 0
E2
"$esm" inspect triangle.ac
