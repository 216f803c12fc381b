#!/usr/bin/env bash
# Runs clang-tidy, with the checks of .clang-tidy, on the sources of the libraries as the release build compiles them.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
version=14

if [[ $(clang-tidy --version 2>/dev/null) != *"version $version."* ]]; then
  echo "clang-tidy $version is needed to check the sources (Debian 12: clang-tidy)" >&2
  exit 1
fi
if [ ! -f build/release/compile_commands.json ]; then
  cmake --preset release
fi
# The commands are GCC's, some of whose warnings clang does not know.
find libsolid libseepage libcouple -name '*.cpp' -print0 |
  xargs -0 -n 1 -P "$(nproc)" clang-tidy -p build/release --quiet --warnings-as-errors='*' \
    --extra-arg=-Wno-unknown-warning-option
