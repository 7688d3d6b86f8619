#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
# clang-tidy over our sources, with the compile commands of the preset dev, which compiles file by file.
# usage: scripts/tidy.sh [FILE...]   (no file: all of them but the tests)
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
cd "$esm_root"
[ -f build/dev/compile_commands.json ] || cmake --preset dev >/dev/null
files=("$@")
if [ ${#files[@]} -eq 0 ]; then
  mapfile -t files < <(git ls-files 'core/*.cpp' 'meshimport/*.cpp' 'haptics/*.cpp' 'cli/*.cpp' 'bench/*.cpp' \
    'fuzzyeditor/*.cpp' 'app/*.cpp')
fi
printf '%s\0' "${files[@]}" | xargs -0 -n 1 -P "$(nproc)" clang-tidy -p build/dev --quiet \
    --extra-arg=-Wno-unknown-warning-option 2>/dev/null
echo "${#files[@]} files, clang-tidy has nothing to say"
