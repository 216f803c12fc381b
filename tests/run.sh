#!/usr/bin/env bash
# Installs what is missing, builds, and runs every test but the long ones. Usage: tests/run.sh [ctest option...]
# With CI set, warnings are errors, the formatting must have been checked, clang-tidy must find nothing in the libraries,
# and their unit tests and short runs pass under the sanitizers too.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
clang_format_version=14

strict=OFF
checkers=()
if [ -n "${CI:-}" ]; then
  strict=ON
  checkers=(clang-format clang-tidy)
fi

tools/setup-debian.sh "${checkers[@]}"

if [[ $(clang-format --version 2>/dev/null) == *"version $clang_format_version."* ]]; then
  find libsolid libseepage libcouple tools tests -name '*.[ch]pp' -print0 | xargs -0 clang-format --dry-run --Werror
elif [ "$strict" = ON ]; then
  echo "clang-format $clang_format_version is needed to check the formatting" >&2
  exit 1
else
  echo "Formatting is not checked: that needs clang-format $clang_format_version."
fi

cmake --preset release -D SLOPE_WERROR=$strict
cmake --build --preset release --target all all_verify_interface_header_sets
ctest --preset release "$@"
if [ "$strict" = ON ]; then
  tests/tidy.sh
  tests/sanitize.sh
fi
