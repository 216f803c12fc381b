#pragma once

#include <cstdint>
#include <vector>

#include "actions.hpp"
#include "case/standing_water_share.hpp"
#include "mixture.hpp"
#include "slope/couple/case.hpp"
#include "slope/couple/geometry.hpp"
#include "slope/couple/state.hpp"
#include "slope/seepage/free_surface.hpp"

namespace slope::couple {

/// The case's water boundaries, tractions and earthquake, tied to the particles that they were given at the start; rain
/// and reservoirs to those that are the free surface now. A particle that another water boundary has takes neither, and
/// what is under water takes no rain.
class BoundaryConditions {
 public:
  BoundaryConditions(const Case& input, const InitialParticles& particles);

  /// Sets what acts in a step that ends at a time (s); pressures ramp from those of the start.
  void apply(double time, const Mixture& mixture, Actions& actions);
  /// What holds before the start: the conditions marked `initial`, at their full value.
  void apply_initial(const Mixture& mixture, Actions& actions);
  /// Body acceleration (m/s2) of an earthquake that acts in full from the start on, else none.
  [[nodiscard]] std::array<double, 2> standing_acceleration() const;
  /// Pressures from which ramps start.
  void remember_pressures(std::span<const double> pressure) {
    first_pressure_.assign(pressure.begin(), pressure.end());
  }
  [[nodiscard]] const std::vector<double>& first_pressure() const { return first_pressure_; }
  [[nodiscard]] BoundaryState state() const { return {first_pressure_, surface_.state()}; }
  void set_state(BoundaryState state);

  /// Times at which a condition begins or ends its ramp, ascending (s).
  [[nodiscard]] const std::vector<double>& change_times() const { return change_times_; }
  /// The first time after the one given (s) at which a condition begins or ends its ramp, a rain changes or a level,
  /// pressure, head or flux has a point.
  [[nodiscard]] double next_change(double time) const;
  /// How fast the fastest of the prescribed pressures, heads and levels changes just after a time (Pa/s), >= 0.
  [[nodiscard]] double prescribed_rate(double time) const;
  /// Whether a boundary of the water's books is the open air, whose parts the water counts as air_flow(): rain, or what
  /// a reservoir leaves dry.
  [[nodiscard]] bool is_open(std::size_t boundary) const {
    return boundary >= water_.size() || std::holds_alternative<Rain>(water_[boundary].condition);
  }
  /// Names of the boundaries in the water's books: the water boundaries, then what each reservoir leaves dry.
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }

 private:
  // What has a particle's piece of the free surface.
  enum class Cover : std::uint8_t { none, condition, water, rain };

  void start(Actions& actions);
  void add_water(std::size_t boundary, double time, double share, const Mixture& mixture, Actions& actions) const;
  void flood(double time, bool before_start, const Mixture& mixture, Actions& actions);
  void add_standing_water(std::size_t boundary, double level, const Mixture& mixture, StandingWater& standing) const;
  void add_seepage_faces(bool before_start, const Mixture& mixture, Actions& actions);
  void add_rain(std::size_t boundary, double intensity, const Mixture& mixture, Actions& actions);

  std::vector<WaterBoundary> water_;
  std::vector<Traction> tractions_;
  Seismic seismic_;
  double gravity_, unit_weight_;
  std::vector<std::vector<Face>> water_faces_, traction_faces_;
  std::vector<std::string> names_;
  std::vector<double> change_times_;
  std::vector<double> first_pressure_;
  std::vector<double> face_distance_;
  std::vector<Cover> first_cover_, cover_;  // of each particle, by what holds always, and now
  double spacing_;
  StandingWaterShare share_;
  seepage::FreeSurface surface_;
};

}  // namespace slope::couple
