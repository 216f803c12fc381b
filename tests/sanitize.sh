#!/usr/bin/env bash
# Builds the libraries' unit tests and the programs with the address and undefined-behaviour sanitizers and runs them:
# the tests, whole programs at a time, since hundreds of processes would each set up their sanitizers anew; a run of each
# scheme and its pictures; runs that are stopped and gone on with.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

unit=(couple/test_state couple/test_case couple/test_results solid/test_solid seepage/test_seepage support/test_support)
# Left out is what reads a case hundreds of times, as the fuzz targets do, and a whole run, of which there are others here.
left_out='*WrongCases*:CaseSchema.*:DamagedSummary.*:Frame.GivesCopiesTheSameHistoryAndTurnsTheRestBack'
resumed='Resume.AnInterrupted*:Resume.WhatDoesNotFit*:SafetyCommand.TellsIt*'

cmake --preset asan
cmake --build --preset asan --target "${unit[@]##*/}" test_slope_sim slope-render
export ASAN_OPTIONS=detect_stack_use_after_return=1 UBSAN_OPTIONS=print_stacktrace=1
export LSAN_OPTIONS=suppressions=$PWD/cmake/leaks.supp:print_suppressions=0
export build=$PWD/build/asan folder
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# run_scheme NAME SETTING...: the smallest slope under one scheme, with its pictures.
run_scheme() {
  local name=$1 setting settings=()
  shift
  for setting in domain.cell_size="1 m" "$@"; do settings+=(--set "$setting"); done
  "$build/bin/slope-sim" run cases/quick.yaml -o "$folder/$name" --quiet --checkpoint-interval 0 "${settings[@]}"
  "$build/bin/slope-render" "$folder/$name" --width 400 >/dev/null
}
export -f run_scheme

jobs=()
for program in "${unit[@]}"; do jobs+=("$build/tests/unit/$program --gtest_brief=1 --gtest_filter='-$left_out'"); done
jobs+=(
  "$build/tests/cli/test_slope_sim --gtest_brief=1 --gtest_filter='$resumed'"
  'run_scheme coupled stop.time="2 s"'
  'run_scheme rigid coupling.skeleton=rigid stop.time="2 s"'
  'run_scheme water_alone coupling.scheme=seepage stop.time="1 h" output.history_interval="10 min"'
  'run_scheme explicit coupling.scheme=explicit stop.time="0.02 s" output.history_interval="0.01 s"'
)
printf '%s\n' "${jobs[@]}" | xargs -d '\n' -n 1 -P 2 bash -euo pipefail -c
