#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
# An installed tree works by itself: its programs find their worker and their samples, wherever it lies.
# usage: test_install.sh CMAKE BUILD_FOLDER
set -euo pipefail
cmake=$1
build=$2
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT

"$cmake" --install "$build" --prefix "$tree/somewhere" >"$tree/log" || { cat "$tree/log"; exit 1; }
mv "$tree/somewhere" "$tree/else where" # no path may have been built in
cd "$tree"
esm="$tree/else where/bin/esm"
samples="$tree/else where/share/esm/samples"

"$esm" import "$samples/fallopian_tube.obj" --unit mm -o tube.esm
"$esm" validate tube.esm
# AC3D comes in through assimp, and so through the worker of that tree, which is no program for a user's path.
[ ! -e "$tree/else where/bin/esm-import-worker" ] || { echo "the worker lies among the programs"; exit 1; }
"$esm" inspect "$here/triangle.ac"
