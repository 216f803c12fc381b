#include "starter_case.hpp"

#include <fmt/format.h>

#include "slope/couple/read_case.hpp"
#include "text_file.hpp"

namespace slope::tools {

std::string_view starter_case() {
  return R"(# A case of slope-sim: a small slope that gets wet and slides. Change it into your own.
#
#   slope-sim check FILE              says what is wrong with it, or that it is fine
#   slope-sim run FILE -o results     runs it, in seconds as it stands
#   slope-render results              draws it
#
# Every dimensional value carries its unit. x points to the right, y upwards. Suction is positive above the water table,
# pore-water pressure is positive in compression, stress and strain are positive in tension. Keys that are commented out
# show what else there is, with what holds without them where that is a value.

title: My slope under rain
# gravity: 9.81 m/s2

# The background grid. Its sides and its base are walls; above the soil it leaves room for what moves.
domain:
  lower: [0 m, 0 m]           # lower left corner
  upper: [11 m, 6 m]          # upper right corner, a whole number of cells away
  cell_size: 0.5 m            # side of the square cells; a failure should be at least ten of them long
  particles_per_cell: 4       # 1, 4, 9 or 16
  surface_particles: clipped  # follow the polygons exactly; lattice: whole particles, inclined surfaces are stair-steps

# free: no wall, roller: no motion across it, fixed: no motion at all.
walls: {left: roller, right: roller, base: fixed}

# water:
#   density: 1000 kg/m3
#   bulk_modulus: 2 GPa

# Any number of soils, each under a name of your own. With "from: soils.yaml" and "soil: loam" a soil takes what it does
# not say itself from another file.
soils:
  silty_sand:
    youngs_modulus: 10 MPa               # of the skeleton
    poissons_ratio: 0.33                 # of the skeleton
    porosity: 0.35                       # at the start
    grain_density: 2700 kg/m3            # of the grains, without pores
    strength:
      model: drucker_prager              # or elastic: it never yields
      cohesion: 1 kPa                    # at zero suction
      friction_angle: 25 deg             # at zero suction
      dilatancy_angle: 0 deg             # not above the friction angle
      maximum_cohesion_increase: 100 kPa # by suction, at most
      cohesion_suction_rate: 0.07        # how fast the cohesion grows with suction over one atmosphere
      friction_angle_suction_rate: 0 deg # increase of the friction angle per atmosphere of suction
    hydraulic_conductivity: 1e-4 m/s     # of the saturated soil
    retention:
      model: van_genuchten               # or exponential, liakopoulos
      alpha: 0.05 1/m                    # one over a suction head that drains it
      n: 3                               # steepness, above 1
      residual_saturation: 0             # that no suction goes below
      maximum_saturation: 1              # at zero suction
    relative_permeability:
      model: hillel                      # S_r to the power of the exponent; or van_genuchten_mualem, exponential, ...
      exponent: 2

# What is soil, region after region; where two overlap, the later one holds: layers from the surface down, then lenses.
# Instead of a polygon a region can have the line of a table as its surface, and reach from there to the base:
#   - {soil: silty_sand, surface: {file: profile.csv, x: x_m, y: y_m, depth: 0 m}, base: 0 m}
geometry:
  - soil: silty_sand
    polygon: [[0 m, 0 m], [11 m, 0 m], [11 m, 5 m], [7.2 m, 5 m], [2.5 m, 1 m], [0 m, 1 m]]

# The state before the start.
initial:
  water:
    type: hydrostatic                    # or water_table: points of a line; uniform: pressure; steady
    water_table: 0.5 m                   # y of zero pore pressure
    # maximum_suction: 50 kPa            # without it there is no limit
  stress: self_weight                    # in balance with the weight; or none

# What the water meets at the boundary; without a condition a boundary is impermeable.
water_boundaries:
  - name: rain
    at: ground_surface                   # or base, left, right
    # from: 0 m                          # only from this x on (left, right: from this y on)
    # to: 11 m                           # only up to this x (left, right: y)
    pressure: 0 kPa                      # or total_head: 3 m, or flux: 10 mm/h into the soil
    applied_to: face                     # the ground itself; or particle: half a particle spacing inside
    start: 0 s                           # when it begins
    ramp: 1 s                            # how long it takes from what is there to the prescribed value

# loads:
#   - {name: fill, at: ground_surface, from: 8 m, traction: [0 kPa, -10 kPa], start: 0 s, ramp: 10 s}

coupling:
  skeleton: deformable                   # or rigid: the pore water does not feel its volume change
  mixture_density: by_saturation         # or saturated: as if all pores were full

# What counts as failure.
failure:
  onset: displacement                    # or runaway: the kink of the largest displacement over time
  onset_displacement: 2 cm               # the slope has failed when the largest displacement passes this
  zone_deviatoric_strain: 2 %            # the failure zone is where the deviatoric strain is above this

# The run ends when the first of these is met.
stop:
  time: 1 min
  displacement: 20 cm                    # the largest one
  # after_onset: 10 s                    # this long after the onset of failure
  # at_rest: true                        # when the slide has come to rest

# Points of the initial slope that are followed.
points:
  toe: [3 m, 1.2 m]
  face: [4.85 m, 2.9 m]
  crest: [7.5 m, 4.9 m]

output:
  history_interval: 0.5 s                # between the rows of history.csv
  snapshot_interval: 10 s                # particle files; start, onset and end are always written
  # snapshots: [5 s, 20 s]               # more times of particle files
)";
}

void write_starter_case(const std::filesystem::path& file) {
  std::error_code error;
  if (std::filesystem::exists(file, error)) {
    throw couple::FileError(fmt::format("{}: exists already; choose another name", file.string()));
  }
  write_at_once(file, starter_case());
}

}  // namespace slope::tools
