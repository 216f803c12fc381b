#!/usr/bin/env bash
# Installs the Debian packages that slope is built with and that are missing.
# Usage: tools/setup-debian.sh [further package...]
set -euo pipefail

packages=(
  build-essential cmake ninja-build
  libeigen3-dev libtbb-dev libfmt-dev libyaml-cpp-dev libxxhash-dev
  libvtk9-dev libosmesa6-dev libcli11-dev fonts-dejavu-core
  libopenturns-dev
  libgtest-dev libbenchmark-dev
  "$@"
)

if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
  cat >&2 <<'TEXT'
This script knows Debian 12 and systems like it (apt-get). On another system, install these yourself:
  a C++20 compiler (GCC 12 or later), CMake 3.25 or later, Ninja,
  Eigen 3.4, oneTBB 2021, fmt 9, yaml-cpp 0.7, xxHash 0.8, VTK 9.1 or later, OSMesa, CLI11 2, the DejaVu fonts,
  OpenTURNS 1.20 or later, GoogleTest, Google Benchmark.
Then build and test with
  cmake --preset release && cmake --build --preset release && ctest --preset release
TEXT
  exit 1
fi

missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$status" = installed ] || missing+=("$package")
done

if [ ${#missing[@]} -gt 0 ]; then
  as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
      echo "Packages are missing, and there is no sudo here. As root, run:" >&2
      echo "  apt-get update && apt-get install --no-install-recommends ${missing[*]}" >&2
      exit 1
    fi
    as_root=(sudo)
  fi
  echo "Installing: ${missing[*]}"
  "${as_root[@]}" apt-get update -qq
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -qq -y --no-install-recommends "${missing[@]}"
fi

# older_than MINIMUM VERSION
older_than() { [ "$(printf '%s\n%s\n' "$1" "$2" | sort --version-sort | head -n 1)" != "$1" ]; }
cmake_version=$(cmake --version | sed -n '1s/.* //p')
compiler_version=$(${CXX:-c++} -dumpversion)
if older_than 3.25 "$cmake_version"; then
  echo "CMake 3.25 or later is needed; this system has $cmake_version. Debian 12 and Ubuntu 24.04 are new enough." >&2
  exit 1
fi
if [[ $(${CXX:-c++} --version) == *"Free Software Foundation"* ]] && older_than 12 "$compiler_version"; then
  echo "GCC 12 or later is needed; this system has $compiler_version. Debian 12 and Ubuntu 24.04 are new enough." >&2
  exit 1
fi
