#include "frame.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "polygon.hpp"
#include "slope/couple/read_case.hpp"

namespace slope::couple {

namespace {

constexpr int quantum_decades = 6;  // below the cell size
// Share of a quantum from which on a length is rounded up: not a half, at which lengths of few decimals lie.
constexpr double upwards_from = 0.382;

double side_of(const Domain& domain, std::size_t axis) {
  return std::round((domain.upper[axis] - domain.lower[axis]) / domain.cell_size) * domain.cell_size;
}

Place mirrored(Place place) {
  if (place == Place::left) return Place::right;
  if (place == Place::right) return Place::left;
  return place;
}

std::vector<std::vector<Point>> outlines_of(const Case& input) {
  std::vector<std::vector<Point>> outlines;
  for (const Region& region : input.regions) outlines.push_back(region.polygon);
  return outlines;
}

}  // namespace

Frame::Frame(const Case& given, std::optional<bool> mirrored)
    : origin_(given.domain.lower),
      width_(side_of(given.domain, 0)),
      height_(side_of(given.domain, 1)),
      quanta_per_metre_(std::pow(10.0, quantum_decades - std::floor(std::log10(given.domain.cell_size)))) {
  if (mirrored) {
    mirrored_ = *mirrored;
    return;
  }
  const Case straight = place(given);
  mirrored_ = true;
  const Case image = place(given);
  const auto outlines = outlines_of(straight), image_outlines = outlines_of(image);
  mirrored_ = outlines == image_outlines ? resolved_yaml(image) < resolved_yaml(straight) : image_outlines > outlines;
}

double Frame::rounded(double length) const {
  return std::floor(length * quanta_per_metre_ + (1.0 - upwards_from)) / quanta_per_metre_;
}

double Frame::x_of(double given) const {
  const double x = given - origin_[0];
  return rounded(mirrored_ ? width_ - x : x);
}

// The corners anticlockwise, from the first one in order of x and y, without repetitions.
std::vector<Point> Frame::outline_of(const std::vector<Point>& polygon) const {
  std::vector<Point> outline;
  for (const Point& corner : polygon) outline.push_back({x_of(corner[0]), y_of(corner[1])});
  outline.erase(std::unique(outline.begin(), outline.end()), outline.end());
  while (outline.size() > 1 && outline.front() == outline.back()) outline.pop_back();
  if (signed_area(outline) < 0.0) std::ranges::reverse(outline);
  if (!outline.empty()) std::rotate(outline.begin(), std::ranges::min_element(outline), outline.end());
  return outline;
}

void Frame::place(PlaceRange& where) const {
  auto& [place, from, to] = where;
  const bool by_height = place == Place::left || place == Place::right;
  from = by_height ? y_of(from) : x_of(from);
  to = by_height ? y_of(to) : x_of(to);
  if (!mirrored_) return;
  if (!by_height) std::swap(from, to);
  place = mirrored(place);
}

void Frame::place(InitialWater& water) const {
  if (auto* hydrostatic = std::get_if<HydrostaticWater>(&water)) {
    auto& [water_table, maximum_suction] = *hydrostatic;
    water_table = y_of(water_table);
  } else if (auto* table = std::get_if<WaterTable>(&water)) {
    auto& [points, maximum_suction] = *table;
    for (Point& point : points) point = {x_of(point[0]), y_of(point[1])};
    if (mirrored_) std::ranges::reverse(points);
  } else if (auto* steady = std::get_if<SteadyWater>(&water)) {
    auto& [water_table] = *steady;
    water_table = y_of(water_table);
  }
}

void Frame::place(WaterBoundary& boundary) const {
  auto& [name, where, condition, start, ramp, initial] = boundary;
  place(where);
  const auto place_heights = [this](TimeSeries& series) {
    for (TimedValue& point : series.points) point.value = y_of(point.value);
  };
  if (auto* held = std::get_if<PrescribedPressure>(&condition)) {
    auto& [pressure, total_head, at_face] = *held;
    if (total_head) place_heights(*total_head);
  } else if (auto* reservoir = std::get_if<Reservoir>(&condition)) {
    auto& [level] = *reservoir;
    place_heights(level);
  }
}

// Every member is named, so that none that is added is forgotten: it would not compile.
Case Frame::place(const Case& given) const {
  Case result = given;
  auto& [path, title, gravity, domain, walls, soils, regions, water, initial_water, initial_stress, k0_coefficient,
         water_boundaries, tractions, seismic, scheme, skeleton, mixture_density, numerics, clock, onset,
         onset_displacement, failure_zone_strain, stop, points, output, figures, safety] = result;
  auto& [lower, upper, cell_size, particles_per_cell, surface_particles] = domain;
  lower = {0.0, 0.0};
  upper = {width_, height_};
  for (auto& [soil, polygon] : regions) polygon = outline_of(polygon);
  place(initial_water);
  for (WaterBoundary& boundary : water_boundaries) place(boundary);
  for (auto& [name, where, traction, start, ramp] : tractions) {
    place(where);
    if (mirrored_) negate(traction[0]);
  }
  safety.within = outline_of(safety.within);
  for (auto& [name, position] : points) position = {x_of(position[0]), y_of(position[1])};
  if (mirrored_) {
    auto& [left, right, base, left_friction, right_friction, base_friction, absorbing_depth] = walls;
    std::swap(left, right);
    std::swap(left_friction, right_friction);
    auto& [horizontal_coefficient, vertical_coefficient, start, ramp] = seismic;
    negate(horizontal_coefficient);
  }
  return result;
}

Point Frame::position(const Point& in_frame) const {
  return {origin_[0] + (mirrored_ ? width_ - in_frame[0] : in_frame[0]), height(in_frame[1])};
}

void Frame::turn_back(InitialParticles& particles) const {
  for (std::size_t p = 0; p < particles.x.size(); ++p) {
    const Point point = position({particles.x[p], particles.y[p]});
    particles.x[p] = point[0];
    particles.y[p] = point[1];
  }
  if (!mirrored_) return;
  const int last = static_cast<int>(std::lround(width_ / particles.spacing)) - 1;
  for (int& column : particles.column) column = last - column;
}

InitialParticles first_particles(const Case& given) {
  const Frame frame(given);
  const Case input = frame.place(given);
  InitialParticles particles = fill_regions(input.domain, input.regions);
  frame.turn_back(particles);
  return particles;
}

}  // namespace slope::couple
