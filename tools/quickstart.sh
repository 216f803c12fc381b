#!/usr/bin/env bash
# From a fresh clone to pictures of a slope that got wet and failed: installs what is missing, builds,
# runs cases/paper/slope-w2.yaml and draws it.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

tools/setup-debian.sh
cmake --preset release
cmake --build --preset release --target slope-sim slope-render

results=results/slope-w2
build/release/bin/slope-sim run cases/paper/slope-w2.yaml -o "$results" --threads 1 --overwrite
build/release/bin/slope-render "$results"

echo "The pictures are in $PWD/$results/figures"
