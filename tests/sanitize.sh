#!/usr/bin/env bash
# Builds the unit tests of the libraries with the address and undefined-behaviour sanitizers and runs them, half of each
# program at a time: hundreds of processes would each set up its sanitizers anew.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
filter=--gtest_filter=-*WrongCases*  # hundreds of them, and the fuzz target reads more
programs=(unit/support/test_support unit/solid/test_solid unit/seepage/test_seepage unit/couple/test_case)

cmake --preset asan
cmake --build --preset asan --target "${programs[@]##*/}"
export ASAN_OPTIONS=detect_stack_use_after_return=1 UBSAN_OPTIONS=print_stacktrace=1
for program in "${programs[@]}"; do
  shards=()
  for shard in 0 1; do
    GTEST_TOTAL_SHARDS=2 GTEST_SHARD_INDEX=$shard build/asan/tests/"$program" --gtest_brief=1 "$filter" &
    shards+=($!)
  done
  for shard in "${shards[@]}"; do wait "$shard"; done
done
