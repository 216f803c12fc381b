#!/usr/bin/env bash
# Runs all cases of the paper, two at a time, draws its figures and judges its claims.
# Usage: cases/paper/reproduce.sh [FOLDER]   (default: results/paper); needs the release build.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
results=${1:-results/paper}
cases=(slope-w1 slope-w3 slope-h3 slope-h2 slope-w2 slope-h1 liakopoulos)

cmake --preset release
cmake --build --preset release --target slope-sim slope-render

printf '%s\n' "${cases[@]}" | xargs -P 2 -I{} build/release/bin/slope-sim run cases/paper/{}.yaml -o "$results/{}" --threads 1 --overwrite
build/release/bin/slope-render --paper "${cases[@]/#/$results/}" -o "$results/figures"
