#!/usr/bin/env bash
# Runs the cases of tests/regression and makes what they give the new references, with the reason in the log of
# tests/reference/NOTES.md. Usage: tests/update-references.sh "why"
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
if [ $# -ne 1 ] || [ -z "$1" ]; then
  echo "References change for a reason: tests/update-references.sh \"why\"" >&2
  exit 2
fi
cmake --preset release
WHY=$1 cmake --build --preset release --target update-references
