#include "boundary_conditions.hpp"

#include <algorithm>
#include <cstdint>

namespace slope::couple {

namespace {

// Share of a ramp that is over (-), in [0, 1].
double ramp_share(double time, double start, double ramp) {
  return ramp > 0.0 ? std::clamp((time - start) / ramp, 0.0, 1.0) : 1.0;
}

// Where a place's faces lie, seen from their particles.
Point outwards_of(Place place) {
  switch (place) {
    case Place::ground_surface:
    case Place::free_surface:
      return {0.0, 1.0};
    case Place::base:
      return {0.0, -1.0};
    case Place::left:
      return {-1.0, 0.0};
    case Place::right:
      return {1.0, 0.0};
  }
  return {0.0, 0.0};
}

// Intensity during a step that ends at a time and passes none at which the rain changes.
double intensity_until(const Rain& rain, double time) {
  double intensity = 0.0;
  for (const RainStep& step : rain.hyetograph) {
    if (step.time < time) intensity = step.intensity;
  }
  return intensity;
}

}  // namespace

BoundaryConditions::BoundaryConditions(const Case& input, const InitialParticles& particles)
    : water_(input.water_boundaries),
      tractions_(input.tractions),
      seismic_(input.seismic),
      gravity_(input.gravity),
      face_distance_(particles.face_distance),
      takes_rain_(particles.x.size(), true),
      spacing_(particles.spacing),
      surface_(particles.spacing, mirror_walls(input)) {
  const auto add_times = [this](double start, double ramp) {
    change_times_.push_back(start);
    if (ramp > 0.0) change_times_.push_back(start + ramp);
  };
  for (const WaterBoundary& boundary : water_) {
    water_particles_.push_back(particles_at(boundary.where, particles));
    names_.push_back(boundary.name);
    add_times(boundary.start, boundary.ramp);
    if (is_rain(names_.size() - 1)) continue;
    for (const std::size_t p : water_particles_.back()) takes_rain_[p] = false;
  }
  for (const Traction& traction : tractions_) {
    traction_particles_.push_back(particles_at(traction.where, particles));
    add_times(traction.start, traction.ramp);
  }
  if (seismic_.horizontal_coefficient != 0.0 || seismic_.vertical_coefficient != 0.0) {
    add_times(seismic_.start, seismic_.ramp);
  }
  std::ranges::sort(change_times_);
  const auto repeated = std::ranges::unique(change_times_);
  change_times_.erase(repeated.begin(), repeated.end());
  first_pressure_.assign(particles.x.size(), 0.0);
}

void BoundaryConditions::apply(double time, const Mixture& mixture, Actions& actions) {
  actions.water.held.clear();
  actions.water.faces.clear();
  actions.water.inflows.clear();
  actions.water.open_faces.clear();
  actions.water.count = water_.size();
  actions.tractions.clear();
  const double shaking = time >= seismic_.start ? gravity_ * ramp_share(time, seismic_.start, seismic_.ramp) : 0.0;
  actions.body_acceleration = {shaking * seismic_.horizontal_coefficient, shaking * seismic_.vertical_coefficient};
  for (std::size_t b = 0; b < water_.size(); ++b) {
    if (time < water_[b].start) continue;
    const double share = ramp_share(time, water_[b].start, water_[b].ramp);
    if (const auto* rain = std::get_if<Rain>(&water_[b].condition)) {
      add_rain(b, share * intensity_until(*rain, time), mixture, actions);
    } else {
      add_water(b, share, mixture, actions);
    }
  }
  for (std::size_t k = 0; k < tractions_.size(); ++k) {
    const Traction& traction = tractions_[k];
    if (time < traction.start) continue;
    const double share = ramp_share(time, traction.start, traction.ramp);
    const Point face = outwards_of(traction.where.place);
    for (const std::size_t p : traction_particles_[k]) {
      actions.tractions.push_back({p, share * traction.traction[0], share * traction.traction[1],
                                   face[0] * face_distance_[p], face[1] * face_distance_[p]});
    }
  }
}

void BoundaryConditions::apply_initial(const Mixture& mixture, Actions& actions) {
  actions = {};
  actions.water.count = water_.size();
  for (std::size_t b = 0; b < water_.size(); ++b) {
    if (!water_[b].initial) continue;
    if (const auto* rain = std::get_if<Rain>(&water_[b].condition)) {
      add_rain(b, rain->before_start.value_or(rain->hyetograph.front().intensity), mixture, actions);
    } else {
      add_water(b, 1.0, mixture, actions);
    }
  }
}

double BoundaryConditions::next_rain_change(double time) const {
  double next = never;
  for (const WaterBoundary& boundary : water_) {
    const auto* rain = std::get_if<Rain>(&boundary.condition);
    if (rain == nullptr) continue;
    for (const RainStep& step : rain->hyetograph) {
      if (step.time > time) next = std::min(next, step.time);
    }
  }
  return next;
}

// Rain falls vertically: each particle gets it on the width that is seen from above. All of the surface lets water out.
void BoundaryConditions::add_rain(std::size_t boundary, double intensity, const Mixture& mixture, Actions& actions) {
  const auto& rain = std::get<Rain>(water_[boundary].condition);
  const PlaceRange& where = water_[boundary].where;
  const double ponding_pressure = mixture.water.water().unit_weight() * rain.ponding_depth;
  surface_.update(mixture.skeleton());
  for (const seepage::SurfacePiece& piece : surface_.pieces()) {
    const double x = mixture.soil.particles().x[piece.particle];
    const double distance = face_distance_[piece.particle];
    if (!takes_rain_[piece.particle] || x < where.from || x > where.to) continue;
    actions.water.open_faces.push_back({piece.particle, static_cast<std::uint32_t>(boundary), intensity * piece.width,
                                        ponding_pressure, -rain.evaporation_limit, distance * piece.ny, distance,
                                        piece.area});
  }
}

void BoundaryConditions::add_water(std::size_t boundary, double share, const Mixture& mixture, Actions& actions) const {
  const WaterBoundary& condition = water_[boundary];
  const auto index = static_cast<std::uint32_t>(boundary);
  const double unit_weight = mixture.water.water().unit_weight();
  const double upwards = outwards_of(condition.where.place)[1];
  for (const std::size_t p : water_particles_[boundary]) {
    const auto particle = static_cast<std::uint32_t>(p);
    if (const auto* flux = std::get_if<PrescribedFlux>(&condition.condition)) {
      actions.water.inflows.push_back({particle, index, share * flux->flux * spacing_});
      continue;
    }
    const auto& held = std::get<PrescribedPressure>(condition.condition);
    const double rise = upwards * face_distance_[p];
    const double height = mixture.soil.particles().y[p] + (held.at_face ? rise : 0.0);
    const double full = held.total_head ? unit_weight * (*held.total_head - height) : held.pressure;
    const double start = first_pressure_[p] - (held.at_face ? unit_weight * rise : 0.0);
    const double pressure = start + share * (full - start);
    if (held.at_face) {
      actions.water.faces.push_back({particle, index, pressure, rise, face_distance_[p], spacing_});
    } else {
      actions.water.held.push_back({particle, index, pressure});
    }
  }
}

}  // namespace slope::couple
