#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
# Installs what is missing, builds, and does the main job.
# With a display: opens the modeler with the sample running, or with the files that you name.
# Without one (or with --headless): imports the sample organ, gives it tissue by rules, pokes it for 2 s, and
# writes the results into out/.                      usage: scripts/run.sh [--headless | FILE...]
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

headless=0
if [ "${1:-}" = --headless ]; then
  headless=1
  shift
elif [ -z "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
  headless=1
fi
[ $headless -eq 0 ] || [ $# -eq 0 ] || esm_die "files are opened in the window, and there is no display here"

esm_install "${esm_build_packages[@]}" "${esm_show_packages[@]}"
esm_build release esm esm-modeler
bin=$esm_root/build/release/bin

if [ $headless -eq 0 ]; then
  esm_say "Opening the modeler"
  exec "$bin/esm-modeler" "$@"
fi

out=$esm_root/out
samples=$esm_root/resources/samples
mkdir -p "$out"
cd "$out"
rm -rf poke.pvd poke_frames deformed.obj force.csv report.json picture.png

esm_say "1/5 Importing the fallopian tube"
"$bin/esm" inspect "$samples/fallopian_tube.obj"
"$bin/esm" import "$samples/fallopian_tube.obj" --unit mm --rules "$samples/tissue.rules" -o tube.esm

esm_say "2/5 Giving it tissue by rules: a softer stretch in the middle, both ends held"
"$bin/esm" apply tube.esm -o poked.esm \
  --set hardness=0.5 --set "elasticity=elastic" --set "shiftability=hardly shiftable" \
  --region "0.028,0,0.012,0.014,0.012,0.012" --set "hardness=rather soft" --set "elasticity=elastic" \
  --set "shiftability=hardly shiftable" \
  --fix-box "-1,-1,-1,0.002,1,1" --fix-box "0.0545,-1,-1,1,1,1" \
  --poke "0.028,0,0.0155,0,0,-0.08,0.005"

esm_say "3/5 Poking it for 2 s"
"$bin/esm" simulate poked.esm --duration 2 --frames 60 -o poke.pvd --force-curve force.csv \
  --mesh deformed.obj --report report.json

esm_say "4/5 Taking its picture"
home=$(mktemp -d)
trap 'rm -rf "$home"' EXIT
mkdir -m 700 "$home/runtime"
env -u WAYLAND_DISPLAY XDG_CONFIG_HOME="$home" XDG_RUNTIME_DIR="$home/runtime" QT_QPA_PLATFORM=xcb QT_QPA_PLATFORMTHEME= \
  xvfb-run -a -s "-screen 0 1600x1000x24 -noreset" \
  "$bin/esm-modeler" poked.esm --lang en --screenshot "$out/picture.png" --after 1

esm_say "5/5 Done. In $out:"
cat <<EOF
  tube.esm, poked.esm   the project after import, and with tissue, region and poke
  poke.pvd              the motion as a ParaView time series (frames in poke_frames/)
  deformed.obj          the mesh as it is at the end
  force.csv             force and displacement over time
  report.json           solver, steps, energies, largest force
  picture.png           the modeler's window
EOF
