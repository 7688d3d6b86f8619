#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
# Makes the projects of resources/samples from its meshes and rules.
# usage: scripts/make_sample_projects.sh ESM_PROGRAM [FOLDER]   (default folder: resources/samples)
set -euo pipefail
esm=$(realpath "$1")
samples=$(cd "$(dirname "${BASH_SOURCE[0]}")/../resources/samples" && pwd)
out=${2:-$samples}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# make NAME MESH TITLE ARGUMENT...: imports a mesh in millimetres and applies the arguments
make() {
  local name=$1 mesh=$2 title=$3
  shift 3
  cp "$samples/$mesh" "$work/" # beside the project, as in the samples' folder
  "$esm" import "$work/$mesh" --unit mm --rules "$samples/tissue.rules" --name "$title" -o "$work/$name.esm" 2>/dev/null
  "$esm" apply "$work/$name.esm" -o "$work/$name.esm" "$@" 2>/dev/null
  cp "$work/$name.esm" "$out/$name.esm"
  echo "$out/$name.esm"
}

# Both ends are held; a softer stretch in the middle.
make fallopian_tube fallopian_tube.obj "Fallopian tube" \
  --set hardness=0.5 --set elasticity=0.75 --set shiftability=0.3 \
  --fix-box "-1,-1,-1,0.002,1,1" --fix-box "0.0545,-1,-1,1,1,1" \
  --region "0.028,0,0.012,0.014,0.012,0.012" --falloff 0.5 \
  --set "hardness=rather soft" --set elasticity=0.75 --set shiftability=0.3

# The cervix is held; a soft spot in the front wall of the fundus.
make uterus uterus.stl "Uterus" \
  --set hardness=0.5 --set elasticity=0.75 --set "shiftability=hardly shiftable" \
  --fix-box "-1,-1,-1,1,1,0.006" \
  --region "0,-0.010,0.055,0.014,0.012,0.014" --falloff 0.5 \
  --set "hardness=soft" --set elasticity=0.75 --set "shiftability=hardly shiftable"

# Held by its inner struts rather than by a bed, and hung up at its neck.
make gallbladder gallbladder.obj "Gallbladder" \
  --set "hardness=rather soft" --set elasticity=0.9 --set shiftability=0.7 \
  --fix-box "-1,-1,0.068,1,1,1"
