#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
# Formats every C++ file in place, or with --check only says which ones are not formatted (exit 1).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
mapfile -t files < <(git ls-files -co --exclude-standard '*.h' '*.cpp')
if [ "${1:-}" = --check ]; then
  clang-format --dry-run -Werror "${files[@]}" && echo "${#files[@]} files, all formatted"
else
  clang-format -i "${files[@]}"
fi
