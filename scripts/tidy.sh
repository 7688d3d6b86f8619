#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
# clang-tidy over our sources, with the compile commands of the preset dev, which compiles file by file.
# usage: scripts/tidy.sh                 all of them but the tests (two hours)
#        scripts/tidy.sh FILE...
#        scripts/tidy.sh --changed [N]   those changed since origin/main, or by the newest commit if there is nothing
#                                        else; at most the N changed last (0: all)
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
cd "$esm_root"
ours=('core/*.cpp' 'meshimport/*.cpp' 'haptics/*.cpp' 'cli/*.cpp' 'bench/*.cpp' 'fuzzyeditor/*.cpp' 'app/*.cpp')

# The changed sources, those of the newest commit first. A header stands for the source of its name.
changed() {
  local base
  base=$(git merge-base HEAD origin/main 2>/dev/null) || base=
  [ -n "$base" ] && [ "$base" != "$(git rev-parse HEAD)" ] || base=$(git rev-parse -q --verify HEAD~1) || return 0
  { git diff --name-only HEAD; git log --name-only --format= "$base..HEAD"; } | sed 's/\.h$/.cpp/' | awk '!seen[$0]++' |
    while read -r file; do git ls-files -- "${ours[@]}" | grep -Fx -- "$file" || true; done
}

[ -f build/dev/compile_commands.json ] || cmake --preset dev >/dev/null
if [ "${1:-}" = --changed ]; then
  mapfile -t files < <(changed)
  total=${#files[@]}
  [ "${2:-0}" -eq 0 ] || files=("${files[@]:0:$2}")
  [ "${#files[@]}" -eq "$total" ] || echo "the ${#files[@]} changed last of $total; all: scripts/tidy.sh --changed"
elif [ $# -gt 0 ]; then
  files=("$@")
else
  mapfile -t files < <(git ls-files -- "${ours[@]}")
fi
[ ${#files[@]} -eq 0 ] || printf '%s\0' "${files[@]}" | xargs -0 -n 1 -P "$(nproc)" clang-tidy -p build/dev --quiet \
    --extra-arg=-Wno-unknown-warning-option 2>/dev/null
echo "${#files[@]} files, clang-tidy has nothing to say"
