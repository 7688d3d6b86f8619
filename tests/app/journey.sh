#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs journey.py on a virtual screen of its own, with settings of its own.
# usage: journey.sh MODELER ESM SAMPLES OUT
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
for tool in xvfb-run xdotool python3; do
  command -v "$tool" >/dev/null || { echo "journey.sh: $tool is missing" >&2; exit 1; }
done
modeler=$1 esm=$2 samples=$3 out=$4
mkdir -p "$out"
"$esm" import "$samples/fallopian_tube.obj" --unit mm -o "$out/start.esm"
home=$(mktemp -d)
trap 'rm -rf "$home"' EXIT
mkdir -m 700 "$home/runtime"
export XDG_RUNTIME_DIR="$home/runtime" XDG_CONFIG_HOME="$home/config" XDG_STATE_HOME="$home/state" XDG_CACHE_HOME="$home/cache"
export QT_QPA_PLATFORM=xcb QT_QPA_PLATFORMTHEME=
unset WAYLAND_DISPLAY
xvfb-run -a -s "-screen 0 1600x1000x24 -noreset" python3 "$here/journey.py" "$modeler" "$samples" "$out"

for look in "en light" "de dark"; do
  read -r language theme <<<"$look"
  xvfb-run -a -s "-screen 0 1600x1000x24 -noreset" "$modeler" "$out/start.esm" --lang "$language" --theme "$theme" \
    --screenshot "$out/window-$language-$theme.png" --after 3
  test -s "$out/window-$language-$theme.png"
done
if QT_QPA_PLATFORM=offscreen "$modeler" "$out/absent.esm" --screenshot "$out/none.png" 2>"$out/error.txt"; then
  echo "FAIL an absent file must not end with 0" >&2
  exit 1
fi
grep -q "absent.esm" "$out/error.txt" && echo "ok   an absent file ends with 1 and its name"
