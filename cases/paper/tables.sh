#!/usr/bin/env bash
# Puts what slope-render wrote into this folder's README, between the marks of the same name.
# Usage: cases/paper/tables.sh report|choices|equal-time FILE
set -euo pipefail
readme=$(dirname "${BASH_SOURCE[0]}")/README.md
name=$1 file=$2
grep -q "^<!-- $name:begin -->$" "$readme" || { echo "$readme has no marks of \"$name\"" >&2; exit 2; }
awk -v name="$name" -v file="$file" '
  $0 == "<!-- " name ":begin -->" { print; while ((getline line < file) > 0) print line; inside = 1 }
  $0 == "<!-- " name ":end -->" { inside = 0 }
  !inside && $0 != "<!-- " name ":begin -->" { print }' "$readme" > "$readme.new"
mv "$readme.new" "$readme"
