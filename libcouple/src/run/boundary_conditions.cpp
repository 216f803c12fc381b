#include "boundary_conditions.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace slope::couple {

namespace {

// Share of a ramp that is over (-), in [0, 1].
double ramp_share(double time, double start, double ramp) {
  return ramp > 0.0 ? std::clamp((time - start) / ramp, 0.0, 1.0) : 1.0;
}

// Whether what starts at a time holds in the step that ends at another. One that ends at the start is before it.
bool has_begun(double time, double start) {
  return time > start || start == 0.0;
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

double TimeSeries::at(double time) const {
  const auto after = std::ranges::find_if(points, [time](const TimedValue& point) { return point.time >= time; });
  if (after == points.end()) return points.back().value;
  if (after == points.begin()) return points.front().value;
  const TimedValue& before = *(after - 1);
  return before.value + (after->value - before.value) * ((time - before.time) / (after->time - before.time));
}

double TimeSeries::rate_after(double time) const {
  const auto after = std::ranges::find_if(points, [time](const TimedValue& point) { return point.time > time; });
  if (after == points.end() || after == points.begin()) return 0.0;
  return (after->value - (after - 1)->value) / (after->time - (after - 1)->time);
}

double TimeSeries::highest() const {
  return std::ranges::max_element(points, {}, &TimedValue::value)->value;
}

BoundaryConditions::BoundaryConditions(const Case& input, const InitialParticles& particles)
    : water_(input.water_boundaries),
      tractions_(input.tractions),
      seismic_(input.seismic),
      gravity_(input.gravity),
      unit_weight_(input.water.unit_weight()),
      face_distance_(particles.face_distance),
      first_cover_(particles.x.size(), Cover::none),
      spacing_(particles.spacing),
      share_(water_),
      surface_(particles.spacing, mirror_walls(input)) {
  const auto add_times = [this](double start, double ramp) {
    change_times_.push_back(start);
    if (ramp > 0.0) change_times_.push_back(start + ramp);
  };
  for (const WaterBoundary& boundary : water_) {
    water_faces_.push_back(faces_at(boundary.where, input, particles));
    names_.push_back(boundary.name);
    add_times(boundary.start, boundary.ramp);
    const bool covers =
        boundary.where.place != Place::free_surface && !std::holds_alternative<FreeDrainage>(boundary.condition);
    if (!covers) continue;
    for (const Face& face : water_faces_.back()) first_cover_[face.particle] = Cover::condition;
  }
  for (const WaterBoundary& boundary : water_) {
    if (!std::holds_alternative<Reservoir>(boundary.condition)) continue;
    names_.push_back(boundary.name + " above the level");
  }
  for (const Traction& traction : tractions_) {
    traction_faces_.push_back(faces_at(traction.where, input, particles));
    add_times(traction.start, traction.ramp);
  }
  if (seismic_.horizontal_coefficient != 0.0 || seismic_.vertical_coefficient != 0.0) {
    add_times(seismic_.start, seismic_.ramp);
  }
  std::ranges::sort(change_times_);
  change_times_.erase(std::unique(change_times_.begin(), change_times_.end()), change_times_.end());
  first_pressure_.assign(particles.x.size(), 0.0);
}

void BoundaryConditions::set_state(BoundaryState state) {
  first_pressure_ = std::move(state.first_pressure);
  surface_.set_state(std::move(state.free_surface));
}

void BoundaryConditions::start(Actions& actions) {
  actions.water.clear();
  actions.water.count = names_.size();
  actions.standing_water = {};
  actions.tractions.clear();
  actions.body_acceleration = {0.0, 0.0};
  cover_ = first_cover_;
}

void BoundaryConditions::apply(double time, const Mixture& mixture, Actions& actions) {
  start(actions);
  const double shaking =
      has_begun(time, seismic_.start) ? gravity_ * ramp_share(time, seismic_.start, seismic_.ramp) : 0.0;
  actions.body_acceleration = {shaking * seismic_.horizontal_coefficient, shaking * seismic_.vertical_coefficient};
  flood(time, false, mixture, actions);
  for (std::size_t b = 0; b < water_.size(); ++b) {
    if (!has_begun(time, water_[b].start) || std::holds_alternative<Reservoir>(water_[b].condition)) continue;
    const double share = ramp_share(time, water_[b].start, water_[b].ramp);
    if (const auto* rain = std::get_if<Rain>(&water_[b].condition)) {
      add_rain(b, share * intensity_until(*rain, time), mixture, actions);
    } else {
      add_water(b, time, share, mixture, actions);
    }
  }
  add_seepage_faces(false, mixture, actions);
  for (std::size_t k = 0; k < tractions_.size(); ++k) {
    const Traction& traction = tractions_[k];
    if (!has_begun(time, traction.start)) continue;
    const double share = ramp_share(time, traction.start, traction.ramp);
    const Point direction = outwards_of(traction.where.place);
    for (const Face& face : traction_faces_[k]) {
      actions.tractions.push_back({face.particle, share * traction.traction[0], share * traction.traction[1],
                                   direction[0] * face.outwards, direction[1] * face.outwards});
    }
  }
}

void BoundaryConditions::apply_initial(const Mixture& mixture, Actions& actions) {
  start(actions);
  flood(0.0, true, mixture, actions);
  for (std::size_t b = 0; b < water_.size(); ++b) {
    if (!water_[b].initial || std::holds_alternative<Reservoir>(water_[b].condition)) continue;
    if (const auto* rain = std::get_if<Rain>(&water_[b].condition)) {
      add_rain(b, rain->before_start.value_or(rain->hyetograph.front().intensity), mixture, actions);
    } else {
      add_water(b, 0.0, 1.0, mixture, actions);
    }
  }
  add_seepage_faces(true, mixture, actions);
}

std::array<double, 2> BoundaryConditions::standing_acceleration() const {
  if (seismic_.start > 0.0 || seismic_.ramp > 0.0) return {0.0, 0.0};
  return {gravity_ * seismic_.horizontal_coefficient, gravity_ * seismic_.vertical_coefficient};
}

double BoundaryConditions::next_change(double time) const {
  const auto change = std::ranges::upper_bound(change_times_, time);
  double next = change == change_times_.end() ? never : *change;
  const auto look_at = [&](const auto& points) {
    for (const auto& point : points) {
      if (point.time > time) next = std::min(next, point.time);
    }
  };
  for (const WaterBoundary& boundary : water_) {
    if (const auto* rain = std::get_if<Rain>(&boundary.condition)) look_at(rain->hyetograph);
    if (const auto* reservoir = std::get_if<Reservoir>(&boundary.condition)) look_at(reservoir->level.points);
    if (const auto* flux = std::get_if<PrescribedFlux>(&boundary.condition)) look_at(flux->flux.points);
    if (const auto* held = std::get_if<PrescribedPressure>(&boundary.condition)) {
      look_at(held->total_head ? held->total_head->points : held->pressure.points);
    }
  }
  return next;
}

double BoundaryConditions::prescribed_rate(double time) const {
  double fastest = 0.0;
  const auto look_at = [&](const TimeSeries& series, double factor) {
    fastest = std::max(fastest, factor * std::abs(series.rate_after(time)));
  };
  for (const WaterBoundary& boundary : water_) {
    if (const auto* reservoir = std::get_if<Reservoir>(&boundary.condition)) look_at(reservoir->level, unit_weight_);
    const auto* held = std::get_if<PrescribedPressure>(&boundary.condition);
    if (held == nullptr) continue;
    look_at(held->total_head ? *held->total_head : held->pressure, held->total_head ? unit_weight_ : 1.0);
  }
  return fastest;
}

// Puts the surface below the levels under water.
void BoundaryConditions::flood(double time, bool before_start, const Mixture& mixture, Actions& actions) {
  const double unit_weight = mixture.water.water().unit_weight();
  for (std::size_t b = 0; b < water_.size(); ++b) {
    const auto* reservoir = std::get_if<Reservoir>(&water_[b].condition);
    if (reservoir == nullptr || (before_start && !water_[b].initial)) continue;
    const double level = reservoir->level.at(time);
    const PlaceRange& where = water_[b].where;
    surface_.update(mixture.skeleton());
    for (const seepage::SurfacePiece& piece : surface_.pieces()) {
      const std::uint32_t p = piece.particle;
      const double x = mixture.soil.particles().x[p];
      const double rise = face_distance_[p] * piece.ny;
      const double depth = level - mixture.soil.particles().y[p] - rise;
      if (cover_[p] != Cover::none || x < where.from || x > where.to || depth <= 0.0) continue;
      cover_[p] = Cover::water;
      actions.water.faces.push_back(
          {p, static_cast<std::uint32_t>(b), unit_weight * depth, rise, face_distance_[p], piece.area});
    }
    add_standing_water(b, level, mixture, actions.standing_water);
  }
}

// The pressure of standing water, as if there were no soil. At the level a particle has the mean over its square.
void BoundaryConditions::add_standing_water(std::size_t boundary, double level, const Mixture& mixture,
                                            StandingWater& standing) const {
  const double unit_weight = mixture.water.water().unit_weight();
  const solid::Particles& soil = mixture.soil.particles();
  standing.pressure.resize(soil.size(), 0.0);
  standing.gradient_x.resize(soil.size(), 0.0);
  standing.gradient_y.resize(soil.size(), 0.0);
  for (std::size_t p = 0; p < soil.size(); ++p) {
    const double depth = level - soil.y[p];
    const double wet = std::clamp(depth / spacing_ + 0.5, 0.0, 1.0);  // part of the particle that is under water
    if (wet == 0.0) continue;
    const double pressure = unit_weight * (wet < 1.0 ? 0.5 * spacing_ * wet * wet : depth);
    const StandingWaterShare::Share share = share_.of(boundary, soil.x[p]);
    standing.pressure[p] += share.value * pressure;
    standing.gradient_x[p] += share.slope * pressure;
    standing.gradient_y[p] -= share.value * unit_weight * wet;
  }
}

// Lets water out where a reservoir's range is neither under water nor under rain.
void BoundaryConditions::add_seepage_faces(bool before_start, const Mixture& mixture, Actions& actions) {
  std::size_t index = water_.size();
  for (const WaterBoundary& boundary : water_) {
    if (!std::holds_alternative<Reservoir>(boundary.condition)) continue;
    const auto open_air = static_cast<std::uint32_t>(index++);
    if (before_start && !boundary.initial) continue;
    for (const seepage::SurfacePiece& piece : surface_.pieces()) {
      const std::uint32_t p = piece.particle;
      const double x = mixture.soil.particles().x[p];
      if (cover_[p] != Cover::none || x < boundary.where.from || x > boundary.where.to) continue;
      actions.water.open_faces.push_back(
          {p, open_air, 0.0, 0.0, -never, face_distance_[p] * piece.ny, face_distance_[p], piece.area});
    }
  }
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
    if (cover_[piece.particle] != Cover::none || x < where.from || x > where.to) continue;
    cover_[piece.particle] = Cover::rain;
    actions.water.open_faces.push_back({piece.particle, static_cast<std::uint32_t>(boundary), intensity * piece.width,
                                        ponding_pressure, -rain.evaporation_limit, distance * piece.ny, distance,
                                        piece.area});
  }
}

void BoundaryConditions::add_water(std::size_t boundary, double time, double share, const Mixture& mixture,
                                   Actions& actions) const {
  const WaterBoundary& condition = water_[boundary];
  const auto index = static_cast<std::uint32_t>(boundary);
  const double unit_weight = mixture.water.water().unit_weight();
  for (const Face& face : water_faces_[boundary]) {
    const std::size_t p = face.particle;
    const auto particle = static_cast<std::uint32_t>(p);
    if (const auto* flux = std::get_if<PrescribedFlux>(&condition.condition)) {
      actions.water.inflows.push_back({particle, index, share * flux->flux.at(time) * face.area});
      continue;
    }
    if (std::holds_alternative<FreeDrainage>(condition.condition)) {
      actions.water.drains.push_back({particle, index, spacing_});
      continue;
    }
    const auto& held = std::get<PrescribedPressure>(condition.condition);
    const double rise = face.distance * face.normal[1];
    const double height = mixture.soil.particles().y[p] + (held.at_face ? rise : 0.0);
    const double full = held.total_head ? unit_weight * (held.total_head->at(time) - height) : held.pressure.at(time);
    const double start = first_pressure_[p] - (held.at_face ? unit_weight * rise : 0.0);
    const double pressure = start + share * (full - start);
    if (held.at_face) {
      actions.water.faces.push_back({particle, index, pressure, rise, face.distance, face.area});
    } else {
      actions.water.held.push_back({particle, index, pressure});
    }
  }
}

}  // namespace slope::couple
