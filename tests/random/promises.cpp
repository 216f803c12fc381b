#include "promises.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "slope/seepage/retention.hpp"

namespace slope::random_cases {

namespace {

using couple::Case;
using couple::ParticleTable;

// What is promised: the water's books close to a ten-thousandth of what went in or out (the verification asks for 1e-3
// to 1e-6, and reaches 3e-5 through ponding, drying and slides). Where little flows, to a millionth of what the pores
// held; and in the coupled schemes to what a step leaves to the next. It reduces the root of the sum of squares to
// numerics.pressure_tolerance of that of what it moves, and follows the retention curves as closely: so the sum to no
// more than twice that times the root of the particles' number. No step moves more than the most that was moved
// between two looks.
constexpr double most_missing_of_flow = 1.0e-4, most_missing_of_storage = 1.0e-6;
constexpr double rounding = 1.0e-9;
constexpr double a_sliver = 1.0e-6;       // of a step, by which a run may end beside its time
constexpr double most_rain_off = 0.03;    // what falls, over intensity times width: the surface is found from particles
constexpr double most_head_off = 0.02;    // of the range of heads, besides a tenth of a spacing
constexpr double resting = 1.0e-3;        // m: moved by less, the ground is where it was
constexpr double heaviest_soil = 25.0e3;  // N/m3
constexpr double most_overburden = 3.0;   // pore pressure of soil that is squeezed, over the weight above it

double spacing_of(const Case& input) {
  return input.domain.cell_size / std::sqrt(input.domain.particles_per_cell);
}

bool moves_no_water_by_strain(const Case& input) {
  return input.scheme == couple::Scheme::seepage || input.skeleton == couple::Skeleton::rigid;
}

/// Lowest and highest of the ground's surface, column by column (m).
std::pair<double, double> ground_range(const Case& input, const ParticleTable& start) {
  const double spacing = spacing_of(input);
  std::map<long, double> tops;
  for (const couple::Point& position : start.position) {
    const long column = std::lround((position[0] - input.domain.lower[0]) / spacing - 0.5);
    const auto top = tops.try_emplace(column, position[1]).first;
    top->second = std::max(top->second, position[1]);
  }
  double low = couple::never, high = -couple::never;
  for (const auto& [column, top] : tops) low = std::min(low, top);
  for (const couple::Region& region : input.regions) {
    for (const couple::Point& corner : region.polygon) high = std::max(high, corner[1]);
  }
  return {low - spacing, high};
}

/// Water in each particle's pores (m2).
std::vector<double> contents(const ParticleTable& now, const std::vector<double>& volume,
                             const std::vector<double>& porosity) {
  std::vector<double> content;
  for (std::size_t p = 0; p < volume.size(); ++p) content.push_back(volume[p] * porosity[p] * now.saturation[p]);
  return content;
}

double sum_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

std::pair<double, double> range_of(const couple::TimeSeries& series) {
  const auto lower = [](const couple::TimedValue& a, const couple::TimedValue& b) { return a.value < b.value; };
  const auto [low, high] = std::minmax_element(series.points.begin(), series.points.end(), lower);
  return {low->value, high->value};
}

/// The heads between which water stays that nothing squeezes: those at the start, and those at its boundaries. Where a
/// flux is prescribed there is no bound on its side, and soil that drains freely falls dry.
struct Heads {
  double low = couple::never, high = -couple::never;

  void take(double least, double most) { low = std::min(low, least), high = std::max(high, most); }
};

class BoundaryHeads {
 public:
  BoundaryHeads(const Case& input, const ParticleTable& start)
      : unit_weight_(input.water.density * input.gravity), bottom_(input.domain.lower[1]) {
    std::tie(ground_low_, ground_high_) = ground_range(input, start);
  }

  void take(const couple::WaterBoundary& boundary, Heads& heads) const {
    std::visit([&](const auto& condition) { take(condition, boundary.where.place, heads); }, boundary.condition);
  }

 private:
  void take(const couple::PrescribedPressure& held, couple::Place place, Heads& heads) const {
    const auto [low, high] = range_of(held.total_head ? *held.total_head : held.pressure);
    if (held.total_head) {
      heads.take(low, high);
      return;
    }
    const bool base = place == couple::Place::base, ground = place == couple::Place::ground_surface;
    heads.take(low / unit_weight_ + (ground ? ground_low_ : bottom_),
               high / unit_weight_ + (base ? bottom_ : ground_high_));
  }
  void take(const couple::PrescribedFlux& flux, couple::Place, Heads& heads) const {
    const auto [low, high] = range_of(flux.flux);
    if (high > 0.0) heads.high = couple::never;
    if (low < 0.0) heads.low = -couple::never;
  }
  void take(const couple::FreeDrainage&, couple::Place, Heads& heads) const { heads.low = -couple::never; }
  void take(const couple::Rain& rain, couple::Place, Heads& heads) const {
    double least = 0.0;
    for (const couple::RainStep& step : rain.hyetograph) least = std::min(least, step.intensity);
    least = std::min(least, rain.before_start.value_or(0.0));
    heads.take(ground_low_ - (least < 0.0 ? rain.evaporation_limit / unit_weight_ : 0.0),
               ground_high_ + rain.ponding_depth);
  }
  void take(const couple::Reservoir& reservoir, couple::Place, Heads& heads) const {
    const auto [low, high] = range_of(reservoir.level);
    heads.take(std::min(low, ground_low_), std::max(high, ground_high_));
  }

  double unit_weight_, bottom_, ground_low_ = 0.0, ground_high_ = 0.0;
};

/// Rain per metre of width until a time (m); none if something else has a say in how much falls.
std::optional<double> fallen(const Case& input, double time) {
  const couple::Rain* rain = nullptr;
  double begin = 0.0;
  for (const couple::WaterBoundary& boundary : input.water_boundaries) {
    if (std::holds_alternative<couple::Reservoir>(boundary.condition)) return std::nullopt;
    const auto* one = std::get_if<couple::Rain>(&boundary.condition);
    if (one == nullptr) continue;
    if (boundary.ramp > 0.0 || rain != nullptr) return std::nullopt;
    rain = one;
    begin = boundary.start;
  }
  if (rain == nullptr) return std::nullopt;
  double sum = 0.0;
  for (std::size_t i = 0; i < rain->hyetograph.size(); ++i) {
    const double from = std::max(begin, rain->hyetograph[i].time);
    const double to = i + 1 < rain->hyetograph.size() ? rain->hyetograph[i + 1].time : couple::never;
    sum += std::max(0.0, rain->hyetograph[i].intensity) * std::max(0.0, std::min(to, time) - from);
  }
  return sum;
}

bool all_finite(const std::vector<double>& values) {
  return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

bool all_finite(const std::vector<couple::Point>& values) {
  return std::ranges::all_of(values, [](const auto& v) { return std::isfinite(v[0]) && std::isfinite(v[1]); });
}

bool all_finite(const std::vector<couple::PlaneTensor>& values) {
  return std::ranges::all_of(values, [](const couple::PlaneTensor& v) {
    return std::isfinite(v.xx) && std::isfinite(v.yy) && std::isfinite(v.zz) && std::isfinite(v.xy);
  });
}

}  // namespace

Promises::Promises(const Case& input, const ParticleTable& start, const couple::Summary& before)
    : input_(input),
      first_volume_(start.volume),
      first_porosity_(start.porosity),
      contents_(contents(start, start.volume, start.porosity)),
      volumes_(start.volume),
      first_storage_(sum_of(contents_)) {
  Heads heads;
  const double unit_weight = input.water.density * input.gravity;
  for (std::size_t p = 0; p < start.position.size(); ++p) {
    const double head = start.pore_pressure[p] / unit_weight + start.position[p][1];
    heads.take(head, head);
  }
  const BoundaryHeads boundaries(input, start);
  for (const couple::WaterBoundary& boundary : input.water_boundaries) boundaries.take(boundary, heads);
  lowest_head_ = heads.low, highest_head_ = heads.high;
  look(start, before);
}

void Promises::look(const ParticleTable& now, const couple::Summary& summary) {
  look_at_fields(now);
  look_at_heads(now, summary.largest_displacement);
  look_at_water(now, summary.water);
  look_at_rain(summary.water, summary.time, summary.largest_displacement);
}

void Promises::look_at_fields(const ParticleTable& now) {
  const bool finite = all_finite(now.position) && all_finite(now.displacement) && all_finite(now.velocity) &&
                      all_finite(now.darcy_velocity) && all_finite(now.stress_effective) && all_finite(now.strain) &&
                      all_finite(now.deviatoric_strain) && all_finite(now.plastic_strain) &&
                      all_finite(now.pore_pressure) && all_finite(now.suction) && all_finite(now.saturation) &&
                      all_finite(now.porosity) && all_finite(now.volume);
  expect(finite, "every field is finite, at t", now.time, now.time);
  for (std::size_t p = 0; p < now.position.size(); ++p) {
    const seepage::Retention& retention = input_.soils[static_cast<std::size_t>(now.soil[p])].seepage.retention;
    const double driest = seepage::evaluate(retention, 1.0e12).saturation;
    const double wettest = seepage::evaluate(retention, 0.0).saturation;
    expect(now.saturation[p] >= driest - rounding, "a saturation is not below the soil's residual one",
           now.saturation[p], driest);
    expect(now.saturation[p] <= wettest + rounding, "a saturation is not above the soil's largest one",
           now.saturation[p], wettest);
    expect(now.porosity[p] > 0.0 && now.porosity[p] < 1.0, "a porosity lies between 0 and 1", now.porosity[p], 1.0);
    expect(now.volume[p] > 0.0, "a volume is positive", now.volume[p], 0.0);
    expect(now.suction[p] == -now.pore_pressure[p], "suction is the negative pore pressure", now.suction[p],
           -now.pore_pressure[p]);
    for (const std::size_t axis : {0U, 1U}) {
      const double place = now.position[p][axis];
      expect(place >= input_.domain.lower[axis] && place <= input_.domain.upper[axis], "a particle is in the domain",
             place, input_.domain.upper[axis]);
    }
  }
}

void Promises::look_at_heads(const ParticleTable& now, double displacement) {
  const double unit_weight = input_.water.density * input_.gravity;
  double lowest = couple::never, highest = -couple::never, largest = -couple::never;
  for (std::size_t p = 0; p < now.position.size(); ++p) {
    const double head = now.pore_pressure[p] / unit_weight + now.position[p][1];
    lowest = std::min(lowest, head), highest = std::max(highest, head);
    largest = std::max(largest, now.pore_pressure[p]);
  }
  if (moves_no_water_by_strain(input_)) {
    const double range = highest_head_ - lowest_head_;
    const double off = 0.1 * spacing_of(input_) + displacement + (range < couple::never ? most_head_off * range : 0.0);
    expect(lowest >= lowest_head_ - off, "no head is below all at the start and the boundaries (m)", lowest,
           lowest_head_);
    expect(highest <= highest_head_ + off, "no head is above all at the start and the boundaries (m)", highest,
           highest_head_);
    return;
  }
  if (input_.scheme == couple::Scheme::explicit_two_pass) return;  // its pressures vibrate
  double load = 0.0;
  for (const couple::Traction& traction : input_.tractions) load += std::abs(traction.traction[1]);
  const double height = input_.domain.upper[1] - input_.domain.lower[1];
  const double bound = unit_weight * std::max(0.0, highest_head_ - input_.domain.lower[1]) +
                       most_overburden * (heaviest_soil * height + load);
  expect(largest <= bound, "no pore pressure is beyond what the weight can squeeze (Pa)", largest, bound);
}

void Promises::look_at_water(const ParticleTable& now, const couple::WaterBudget& water) {
  const bool same_pores = moves_no_water_by_strain(input_);
  const std::vector<double> volumes = std::exchange(volumes_, now.volume);
  const std::vector<double> before = std::exchange(
      contents_, same_pores ? contents(now, first_volume_, first_porosity_) : contents(now, now.volume, now.porosity));
  const double storage = sum_of(contents_);
  double squares = 0.0;  // of what was moved since the last look, at least: by flow, and by the pores that held it
  for (std::size_t p = 0; p < before.size(); ++p) {
    const double squeezed = same_pores ? 0.0 : now.saturation[p] * std::abs(volumes_[p] - volumes[p]);
    const double moved = squeezed + std::abs(contents_[p] - before[p]);
    squares += moved * moved;
  }
  most_moved_ = std::max(most_moved_, std::sqrt(static_cast<double>(before.size()) * squares));
  const double carried =
      input_.scheme == couple::Scheme::seepage ? 0.0 : 2.0 * input_.numerics.pressure_tolerance * most_moved_;
  const double flow = std::max(water.infiltration, water.outflow);
  // the paper's own cycle neither solves for the balance nor carries over what is missing
  const bool promised = input_.scheme != couple::Scheme::explicit_two_pass;
  const double bound = most_missing_of_flow * flow + most_missing_of_storage * first_storage_ + carried;
  const double missing = water.infiltration - water.outflow - water.storage;
  water_error_ = std::max(water_error_, std::abs(missing) / std::max(flow, 1.0e-2 * first_storage_));
  expect(std::abs(missing) <= bound || (!promised && std::isfinite(missing)),
         "what went in and out is what is stored (m3/m)", missing, bound);
  // the books count the water's mass, which a pressure makes denser
  for (const double one : now.pore_pressure) largest_pressure_ = std::max(largest_pressure_, std::abs(one));
  const double denser = 2.0 * largest_pressure_ / input_.water.bulk_modulus * std::max(first_storage_, storage);
  const double off = storage - first_storage_ - water.storage;
  expect(std::abs(off) <= bound + denser || (!promised && std::isfinite(off)),
         "the pores hold what the books say (m3/m)", off, bound + denser);
  const double parts = water.rain_infiltration + water.run_off - water.rain;
  expect(std::abs(parts) <= rounding * std::max(water.rain, 1.0e-6), "rain is its infiltration and its run-off (m3/m)",
         parts, rounding);
  double net = 0.0;
  for (const auto& [name, inflow] : water.by_boundary) net += inflow;
  const double off_net = net - (water.infiltration - water.outflow);
  expect(std::abs(off_net) <= rounding * std::max(flow, 1.0e-3), "the boundaries' flows add up (m3/m)", off_net,
         rounding);
}

void Promises::look_at_rain(const couple::WaterBudget& water, double time, double displacement) {
  const auto rain = fallen(input_, time);
  if (!rain || displacement > resting) return;
  // particles whose centre lies in the range take the rain on all of their width; what is held at a side takes none
  double width = 0.0, edges = spacing_of(input_);
  for (const couple::WaterBoundary& boundary : input_.water_boundaries) {
    const couple::PlaceRange& where = boundary.where;
    if (where.place == couple::Place::left || where.place == couple::Place::right) edges += spacing_of(input_);
    if (!std::holds_alternative<couple::Rain>(boundary.condition)) continue;
    width = std::min(input_.domain.upper[0], where.to) - std::max(input_.domain.lower[0], where.from);
  }
  const double off = *rain * (most_rain_off * width + edges);
  expect(std::abs(water.rain - *rain * width) <= off, "rain is intensity times time times width (m3/m)", water.rain,
         *rain * width);
}

void Promises::look_at_row(const std::vector<double>& row, const std::vector<double>& budget) {
  expect(all_finite(row), "a row of the history is finite, at t", row.front(), row.front());
  expect(all_finite(budget), "a row of the budget is finite, at t", budget.front(), budget.front());
  expect(row.front() == budget.front(), "history and budget have the same times", row.front(), budget.front());
  if (!last_budget_.empty()) {
    expect(row.front() > last_budget_.front(), "times of the history ascend", row.front(), last_budget_.front());
    // time, rain, its infiltration, run-off, seepage, evaporation, infiltration, outflow: all grow
    constexpr std::size_t growing = 8;
    for (std::size_t i = 0; i < growing; ++i)
      expect(budget[i] >= last_budget_[i], "what is counted in the budget never falls", budget[i], last_budget_[i]);
  }
  last_budget_ = budget;
}

void Promises::look_at_end(const couple::Summary& summary) {
  using couple::Verdict;
  const Verdict verdict = summary.verdict;
  expect(verdict != Verdict::undecided || summary.end_reason != couple::EndReason::time,
         "a run to its end has a verdict", 0.0, 0.0);
  if (summary.end_reason == couple::EndReason::time)
    expect(std::abs(summary.time - input_.stop.time) <= a_sliver * input_.stop.time, "it ends at stop.time",
           summary.time, input_.stop.time);
  const bool water_alone = input_.scheme == couple::Scheme::seepage;
  expect((verdict == Verdict::water_alone) == water_alone, "the verdict is on the water alone where only it moves", 0.0,
         0.0);
  if (water_alone)
    expect(summary.largest_displacement == 0.0, "the water alone moves no soil", summary.largest_displacement, 0.0);
  const bool elastic = std::ranges::all_of(input_.soils, [](const couple::Soil& soil) {
    return std::holds_alternative<solid::NoYield>(soil.solid.strength);
  });
  // behind an absorbing wall the soil goes on, and may settle by more than what is drawn; one particle in a cell leaves
  // motions of the grid's nodes that no stress resists
  if (elastic && input_.domain.particles_per_cell > 1 && !input_.walls.absorbing_depth &&
      input_.initial_stress != couple::InitialStress::none) {
    expect(verdict != Verdict::fails && verdict != Verdict::does_not_stand, "what is elastic does not fail",
           summary.largest_displacement, input_.onset_displacement);
  }
}

void Promises::expect(bool kept, const char* what, double value, double bound) {
  if (kept || !seen_.insert(what).second) return;
  broken_.push_back(fmt::format("{}: {:.6g}, bound {:.6g}", what, value, bound));
}

}  // namespace slope::random_cases
