#!/usr/bin/env bash
# What the paper leaves open, varied one choice at a time on case W2, and all slopes at equal time instead of equal
# displacement; then a table of each. Usage: cases/paper/sensitivity.sh [FOLDER]   (default: results/sensitivity);
# needs the release build. Takes the better part of an hour on two cores, most of it for the fine grid.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
results=${1:-results/sensitivity}
slope_sim=build/release/bin/slope-sim

# name, then what it changes; the first is what the others are compared with
choices=(
  "as shipped"
  "cells of 0.25 m (to 12 cm)|domain.cell_size=0.25 m|stop.displacement=12 cm"
  "cells of 1 m|domain.cell_size=1 m"
  "9 particles per cell|domain.particles_per_cell=9"
  "surface without steps|domain.surface_particles=clipped"
  "zero pressure at the ground|water_boundaries.rain.applied_to=face"
  "ground as drawn|domain.surface_particles=clipped|water_boundaries.rain.applied_to=face"
  "rigid skeleton|coupling.skeleton=rigid"
  "rain on the face only|water_boundaries.rain.from=10 m|water_boundaries.rain.to=22.6 m"
  "base 2.5 m thick|domain.lower=[0 m, 2.5 m]|geometry.0.polygon=[[0 m, 2.5 m], [36 m, 2.5 m], [36 m, 12 m], [22.6 m, 12 m], [10 m, 5 m], [0 m, 5 m]]"
  "base 10 m thick|domain.lower=[0 m, -5 m]|geometry.0.polygon=[[0 m, -5 m], [36 m, -5 m], [36 m, 12 m], [22.6 m, 12 m], [10 m, 5 m], [0 m, 5 m]]"
  "ramp of 50 s|water_boundaries.rain.ramp=50 s"
  "dilatancy 5 deg|soils.sandy_clay.strength.dilatancy_angle=5 deg"
  "density by saturation|coupling.mixture_density=by_saturation"
)
cases=(slope-w1 slope-w2 slope-w3 slope-h1 slope-h3)

folder_of() { echo "$results/$(tr -cs 'a-z0-9.\n' '-' <<<"$1")"; }

run() { # folder, case, overrides
  local folder=$1 case=$2 settings=()
  shift 2
  for setting in "$@"; do settings+=(--set "$setting"); done
  "$slope_sim" run "cases/paper/$case.yaml" -o "$folder" --threads 1 --overwrite --quiet "${settings[@]}"
}

jobs_at_once=2
wait_for_a_place() { while [ "$(jobs -rp | wc -l)" -ge "$jobs_at_once" ]; do wait -n; done; }

folders=()
for choice in "${choices[@]}"; do
  IFS='|' read -r -a parts <<<"$choice"
  folders+=("$(folder_of "${parts[0]}")")
  wait_for_a_place
  run "${folders[-1]}" slope-w2 "title=${parts[0]}" "${parts[@]:1}" &
done
equal_time=()
for case in "${cases[@]}"; do
  equal_time+=("$results/$case-2-min-after-onset")
  wait_for_a_place
  run "${equal_time[-1]}" "$case" "title=${case#slope-} to 2 min after onset" "stop.displacement=3 m" "stop.after_onset=2 min" &
done
wait
build/release/bin/slope-render --compare "${folders[@]}" -o "$results/choices.md"
build/release/bin/slope-render --compare "${equal_time[@]}" -o "$results/equal-time.md"
