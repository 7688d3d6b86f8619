#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
# Makes the sample projects anew and compares them with those in resources/samples, byte by byte.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
made=$(mktemp -d)
trap 'rm -rf "$made"' EXIT
"$root/scripts/make_sample_projects.sh" "$1" "$made" >/dev/null
count=0
for project in "$made"/*.esm; do
  cmp "$project" "$root/resources/samples/$(basename "$project")"
  "$1" validate "$project"
  count=$((count + 1))
done
[ "$count" -eq 3 ] || { echo "made $count projects, not 3" >&2; exit 1; }
