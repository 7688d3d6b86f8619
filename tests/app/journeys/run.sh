#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs one journey on a virtual screen of its own, with settings of its own.
# usage: run.sh NAME MODELER ESM SAMPLES OUT
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
for tool in xvfb-run xdotool python3; do
  command -v "$tool" >/dev/null || { echo "run.sh: $tool is missing" >&2; exit 1; }
done
name=$1 modeler=$2 esm=$3 samples=$4 out=$5
mkdir -p "$out"
"$esm" import "$samples/fallopian_tube.obj" --unit mm -o "$out/start.esm"
home=$(mktemp -d)
trap 'rm -rf "$home"' EXIT
mkdir -m 700 "$home/runtime"
export XDG_RUNTIME_DIR="$home/runtime" XDG_CONFIG_HOME="$home/config" XDG_STATE_HOME="$home/state" XDG_CACHE_HOME="$home/cache"
export QT_QPA_PLATFORM=xcb QT_QPA_PLATFORMTHEME=
unset WAYLAND_DISPLAY
xvfb-run -a -s "-screen 0 1600x1000x24 -noreset" python3 "$here/$name.py" "$modeler" "$samples" "$out"
