#include "slope/seepage/pore_flow.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "for_each_index.hpp"
#include "require.hpp"

namespace slope::seepage {

namespace {

void check(const std::vector<Soil>& soils, std::span<const std::uint16_t> soil, std::span<const double> pressure,
           const Skeleton& skeleton) {
  require(!soils.empty(), "soils", "one at least", 0.0);
  for (std::size_t k = 0; k < soils.size(); ++k) {
    try {
      soils[k].check();
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument("soils[" + std::to_string(k) + "]." + error.what());
    }
  }
  skeleton.check();
  require(soil.size() == skeleton.size(), "soil", "one for each particle", static_cast<double>(soil.size()));
  require(pressure.size() == skeleton.size(), "pressure", "one for each particle",
          static_cast<double>(pressure.size()));
  for (const std::uint16_t of_particle : soil)
    require(of_particle < soils.size(), "soil", "an index into soils", of_particle);
  for (const double of_particle : pressure) require(std::isfinite(of_particle), "pressure", "a number", of_particle);
}

}  // namespace

SeepageError::SeepageError(std::size_t at, const std::string& name, double bad)
    : std::runtime_error("particle " + std::to_string(at) + ": " + name + " is " + std::to_string(bad)),
      particle(at),
      field(name),
      value(bad) {}

PoreFlow::PoreFlow(std::vector<Soil> soils, const Water& water, std::span<const std::uint16_t> soil,
                   std::span<const double> pressure, const Skeleton& skeleton, const FlowSettings& settings)
    : soils_(std::move(soils)),
      water_(water),
      settings_(settings),
      operator_(settings.spacing, settings.smoothing_ratio, settings.walls, settings.threads),
      soil_(soil.begin(), soil.end()),
      particles_of_soil_(soils_.size()) {
  water_.check();
  check(soils_, soil, pressure, skeleton);
  const std::size_t n = soil_.size();
  for (std::size_t p = 0; p < n; ++p) particles_of_soil_[soil_[p]].push_back(static_cast<std::uint32_t>(p));
  for (auto* field : {&suction_, &saturation_, &pore_stress_, &pressure_head_, &capacity_, &reach_}) {
    field->assign(n, 0.0);
  }
  operator_.set_soils(soil_, {soils_.begin(), soils_.end()});
  state_.defect.assign(n, 0.0);
  state_.front_start.assign(pressure.begin(), pressure.end());
  set_pressure(pressure);
  follow(skeleton);
  for (std::size_t p = 0; p < n; ++p) state_.content.push_back(water_of(p, skeleton));
}

void PoreFlow::set_state(State state, HeadOperator::State head_operator) {
  const std::size_t n = soil_.size();
  for (const auto* field : {&state.pressure, &state.content, &state.defect, &state.front_start, &head_operator.x}) {
    if (field->size() != n) throw std::invalid_argument("the state of the pore water has another number of particles");
  }
  operator_.set_state(std::move(head_operator));
  state_ = std::move(state);
  evaluate_soil();
  for (std::size_t p = 0; p < n; ++p) {
    if (std::isfinite(operator_.pressure_head(p))) reach_[p] = reach_at(p, -operator_.pressure_head(p));
  }
}

void PoreFlow::set_pressure(std::span<const double> pressure) {
  assert(pressure.size() == size());
  state_.pressure.assign(pressure.begin(), pressure.end());
  evaluate_soil();
}

// Calls visit(particle, index of its soil, retention law, permeability law) for each particle.
template <class Visit>
void PoreFlow::for_each_particle(const Visit& visit) const {
  for (std::size_t k = 0; k < soils_.size(); ++k) {
    const std::vector<std::uint32_t>& members = particles_of_soil_[k];
    std::visit(
        [&](const auto& retention, const auto& permeability) {
          for_each_index(members.size(), settings_.threads,
                         [&](std::size_t i) { visit(members[i], k, retention, permeability); });
        },
        soils_[k].retention, soils_[k].relative_permeability.law);
  }
}

// S_r, dS_r/dP_w and S_r P_w at the present pressure (paper, Eqs. 8-10).
void PoreFlow::evaluate_soil() {
  const double inverse_weight = 1.0 / water_.unit_weight();
  for_each_particle([&](std::size_t p, std::size_t, const auto& retention, const auto&) {
    suction_[p] = -state_.pressure[p];
    const double suction_head = suction_[p] * inverse_weight;
    pressure_head_[p] = -suction_head;
    const Saturation s = retention.evaluate(suction_head);
    saturation_[p] = s.saturation;
    capacity_[p] = -s.slope * inverse_weight;
    pore_stress_[p] = s.saturation * state_.pressure[p];
  });
}

void PoreFlow::find_conductances(double tolerance) {
  for_each_particle([&](std::size_t p, std::size_t k, const auto&, const auto& permeability) {
    const ConductivityCurve& curve = operator_.curves()[k];
    const double head = pressure_head_[p], before = operator_.pressure_head(p);
    const bool one_side = (head < -curve.wet_until()) == (before < -curve.wet_until());
    if (one_side && std::abs(head - before) <= tolerance * reach_[p]) return;
    const Soil& soil = soils_[k];
    const double share = std::max(permeability.evaluate(-head, saturation_[p]), soil.relative_permeability.floor);
    operator_.set_conductivity(p, {soil.hydraulic_conductivity * share, head, curve.potential(head)});
    reach_[p] = tolerance > 0.0 ? reach_at(p, -head) : 0.0;
  });
  operator_.find_conductances();
}

// By how much the suction head may change until the conductivity is another, to first order, or the head is (m).
double PoreFlow::reach_at(std::size_t p, double suction_head) const {
  const RelativePermeability& permeability = soil(p).relative_permeability;
  const Saturation s = evaluate(soil(p).retention, suction_head);
  const double share = permeability.evaluate(suction_head, s.saturation);
  return std::min(settings_.spacing, share / std::abs(permeability.slope(suction_head, s)));
}

double PoreFlow::water_of(std::size_t p, const Skeleton& skeleton) const {
  return skeleton.porosity[p] * saturation_[p] * skeleton.volume[p] * (1.0 + state_.pressure[p] / water_.bulk_modulus);
}

double PoreFlow::conductivity(std::size_t p) const {
  const Soil& of = soil(p);
  return of.hydraulic_conductivity * of.relative_permeability.evaluate(-pressure_head_[p], saturation_[p]);
}

PotentialAt PoreFlow::conductivity_at(std::size_t p) const {
  return {conductivity(p), pressure_head_[p], operator_.curves()[soil_[p]].potential(pressure_head_[p])};
}

PotentialAt PoreFlow::conductivity_at(std::size_t p, double pressure) const {
  const double pressure_head = pressure / water_.unit_weight();
  const ConductivityCurve::Value value = operator_.curves()[soil_[p]].at(pressure_head);
  return {value.conductivity, pressure_head, value.potential};
}

double PoreFlow::conductivity_slope(std::size_t p) const {
  const Soil& soil = soils_[soil_[p]];
  const double suction_head = -state_.pressure[p] / water_.unit_weight();
  return -soil.hydraulic_conductivity *
         soil.relative_permeability.slope(suction_head, evaluate(soil.retention, suction_head));
}

WettingFront PoreFlow::wetting_front(std::size_t p, double face_pressure) const {
  const Retention& retention = soils_[soil_[p]].retention;
  const double inverse_weight = 1.0 / water_.unit_weight();
  const double dry = evaluate(retention, -state_.front_start[p] * inverse_weight).saturation;
  const double room = evaluate(retention, -face_pressure * inverse_weight).saturation - dry;
  constexpr double no_room = 1.0e-6;
  if (room < no_room) return {conductivity_at(p, state_.front_start[p]), 1.0, 0.0};
  return {conductivity_at(p, state_.front_start[p]), (saturation_[p] - dry) / room,
          capacity_[p] * water_.unit_weight() / room};
}

// A front begins anew where a face lets nothing in, and where a particle passes on what rain gives it.
void PoreFlow::follow_front(std::size_t p, double gain, double time_step, const StepFlow& flow) {
  constexpr double kept = 0.1;  // of what comes in, by a particle that does not pass it on
  if (flow.full[p] != 0 && flow.wetting[p] > 0.0) return;
  if (gain <= kept * time_step * flow.wetting[p]) state_.front_start[p] = state_.pressure[p];
}

void PoreFlow::book(double time_step, const Skeleton& skeleton, const StepFlow& flow,
                    std::span<const HeldPressure> held) {
  assert(time_step > 0.0 && skeleton.size() == size() && flow.outflow.size() == size());
  assert(flow.wetting.size() == size() && flow.full.size() == size());
  state_.inflow_rate = flow.inflow_rate;
  state_.air_flow = flow.air_flow;
  for_each_index(size(), settings_.threads, [&](std::size_t p) {
    const double content = water_of(p, skeleton);
    follow_front(p, content - state_.content[p], time_step, flow);
    state_.defect[p] += state_.content[p] - content - time_step * flow.outflow[p];
    state_.content[p] = content;
  });
  for (const HeldPressure& given : held) {
    assert(given.particle < size() && given.boundary < state_.inflow_rate.size());
    state_.inflow_rate[given.boundary] -= state_.defect[given.particle] / time_step;
    state_.defect[given.particle] = 0.0;
  }
  const std::size_t accounts = state_.inflow_rate.size();
  state_.inflow.resize(accounts, 0.0);
  for (std::size_t b = 0; b < accounts; ++b) state_.inflow[b] += time_step * state_.inflow_rate[b];
  check_numbers();
}

void PoreFlow::check_numbers() const {
  for (std::size_t p = 0; p < state_.pressure.size(); ++p) {
    if (!std::isfinite(state_.pressure[p])) throw SeepageError(p, "pore pressure (Pa)", state_.pressure[p]);
    if (!std::isfinite(state_.defect[p])) throw SeepageError(p, "water balance (m2)", state_.defect[p]);
  }
}

void PoreFlow::darcy_velocity(const Skeleton& skeleton, std::span<double> wx, std::span<double> wy) const {
  std::vector<double> head(state_.pressure.size());
  for (std::size_t p = 0; p < head.size(); ++p) head[p] = state_.pressure[p] / water_.unit_weight() + skeleton.y[p];
  operator_.gradient(head, skeleton, wx, wy);
  for (std::size_t p = 0; p < head.size(); ++p) {
    const double conducts = conductivity(p);
    wx[p] *= -conducts;
    wy[p] *= -conducts;
  }
}

double PoreFlow::stored_water() const {
  double sum = 0.0;
  for (const double content : state_.content) sum += content;
  return sum;
}

double PoreFlow::unexplained_water() const {
  double sum = 0.0;
  for (const double defect : state_.defect) sum += defect;
  return sum;
}

}  // namespace slope::seepage
