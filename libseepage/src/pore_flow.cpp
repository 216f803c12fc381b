#include "slope/seepage/pore_flow.hpp"

#include <algorithm>
#include <cmath>

namespace slope::seepage {

namespace {

constexpr double begun_to_fall = 0.97;  // share of the saturated conductivity
constexpr double least_onset = 1.0e-5;  // suction head of that (m)

// How much further than asked for conjugate gradients reduce a residual, which they weigh by the diagonal: what much
// more permeable soils lack of water counts for too little beside the others.
double tolerance_share_of(const std::vector<Soil>& soils) {
  constexpr double tolerable = 1.0e-3;
  const auto [least, most] = std::ranges::minmax(soils, {}, &Soil::hydraulic_conductivity);
  return std::min(1.0, std::sqrt(least.hydraulic_conductivity / (tolerable * most.hydraulic_conductivity)));
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
      particles_of_soil_(soils_.size()),
      tolerance_share_(tolerance_share_of(soils_)) {
  state_.pressure.assign(pressure.begin(), pressure.end());
  const std::size_t n = state_.pressure.size();
  for (std::size_t p = 0; p < n; ++p) particles_of_soil_[soil_[p]].push_back(static_cast<std::uint32_t>(p));
  for (auto* v : {&suction_, &saturation_,    &pore_stress_,       &capacity_,      &conductivity_,  &pressure_head_,
                  &head_,    &potential_,     &state_.front_start, &face_gain_,     &state_.content, &state_.defect,
                  &change_,  &stress_change_, &storage_,           &right_side_,    &diagonal_,      &outflow_,
                  &work_,    &work2_,         &storage_offset_,    &storage_slope_, &touched_,       &latest_change_}) {
    v->assign(n, 0.0);
  }
  is_held_.assign(n, 0);
  face_full_.assign(n, 0);
  std::vector<ConductivityCurve> curves(soils_.begin(), soils_.end());
  for (const ConductivityCurve& curve : curves) {
    drying_onset_.push_back(-std::max(curve.suction_head_at(begun_to_fall), least_onset) * water_.unit_weight());
  }
  operator_.set_soils(soil_, std::move(curves));
  evaluate_soil();
  state_.front_start = state_.pressure;
  follow(skeleton);
  for (std::size_t p = 0; p < n; ++p) state_.content[p] = water_of(p, skeleton);
}

void PoreFlow::follow(const Skeleton& skeleton) {
  if (operator_.update(skeleton)) assembled_.forget();
}

void PoreFlow::set_state(State state, HeadOperator::State head_operator) {
  const std::size_t n = soil_.size();
  for (const auto* field : {&state.pressure, &state.content, &state.defect, &state.front_start, &head_operator.x}) {
    if (field->size() != n) throw std::invalid_argument("the state of the pore water has another number of particles");
  }
  operator_.set_state(std::move(head_operator));
  state_ = std::move(state);
  assembled_.forget();
  evaluate_soil();
}

// S_r, dS_r/dP_w, k k_rw and S_r P_w at the present pressure (paper, Eqs. 8-10).
void PoreFlow::evaluate_soil() {
  const double inverse_weight = 1.0 / water_.unit_weight();
  for (std::size_t k = 0; k < soils_.size(); ++k) {
    const std::vector<std::uint32_t>& members = particles_of_soil_[k];
    const double saturated = soils_[k].hydraulic_conductivity;
    const double floor = soils_[k].relative_permeability.floor;
    const ConductivityCurve& curve = operator_.curves()[k];
    std::visit(
        [&](const auto& retention, const auto& permeability) {
#pragma omp parallel for schedule(static) num_threads(settings_.threads) if (settings_.threads > 1)
          for (std::size_t i = 0; i < members.size(); ++i) {
            const std::size_t p = members[i];
            suction_[p] = -state_.pressure[p];
            const double suction_head = suction_[p] * inverse_weight;
            const Saturation s = retention.evaluate(suction_head);
            saturation_[p] = s.saturation;
            capacity_[p] = -s.slope * inverse_weight;
            conductivity_[p] = saturated * std::max(permeability.evaluate(suction_head, s.saturation), floor);
            potential_[p] = curve.potential(-suction_head);
            pore_stress_[p] = s.saturation * state_.pressure[p];
          }
        },
        soils_[k].retention, soils_[k].relative_permeability.law);
  }
}

void PoreFlow::find_head(const Skeleton& skeleton) {
  const double inverse_weight = 1.0 / water_.unit_weight();
  elevation_.assign(skeleton.y.begin(), skeleton.y.end());
  for (std::size_t p = 0; p < state_.pressure.size(); ++p) {
    pressure_head_[p] = state_.pressure[p] * inverse_weight;
    head_[p] = pressure_head_[p] + elevation_[p];
  }
}

double PoreFlow::water_of(std::size_t p, const Skeleton& skeleton) const {
  return skeleton.porosity[p] * saturation_[p] * skeleton.volume[p] * (1.0 + state_.pressure[p] / water_.bulk_modulus);
}

// What the soil of a particle conducts at a pressure (Pa).
PotentialAt PoreFlow::conductivity_at(std::size_t p, double pressure) const {
  const double pressure_head = pressure / water_.unit_weight();
  const ConductivityCurve::Value value = operator_.curves()[soil_[p]].at(pressure_head);
  return {value.conductivity, pressure_head, value.potential};
}

// d(k k_rw)/dpsi of a particle at its present pressure (1/s), >= 0.
double PoreFlow::conductivity_slope(std::size_t p) const {
  const Soil& soil = soils_[soil_[p]];
  const double suction_head = -state_.pressure[p] / water_.unit_weight();
  return -soil.hydraulic_conductivity *
         soil.relative_permeability.slope(suction_head, evaluate(soil.retention, suction_head));
}

// Of the water that the particle's face has let in since it began to.
WettingFront PoreFlow::front_of(std::size_t p, double face_pressure) const {
  const Retention& retention = soils_[soil_[p]].retention;
  const double inverse_weight = 1.0 / water_.unit_weight();
  const double dry = evaluate(retention, -state_.front_start[p] * inverse_weight).saturation;
  const double room = evaluate(retention, -face_pressure * inverse_weight).saturation - dry;
  constexpr double no_room = 1.0e-6;
  if (room < no_room) return {conductivity_at(p, state_.front_start[p]), 1.0, 0.0};
  return {conductivity_at(p, state_.front_start[p]), (saturation_[p] - dry) / room,
          capacity_[p] * water_.unit_weight() / room};
}

// What the face lets in at the present pressure. A front is sharp where gravity does not hold it back.
PoreFlow::FaceLaw PoreFlow::face_law(const FacePressure& face) const {
  const std::size_t p = face.particle;
  const HeldFace held{conductivity_at(p, face.pressure),
                      {conductivity_[p], state_.pressure[p] / water_.unit_weight(), potential_[p]},
                      conductivity_slope(p),
                      face.rise,
                      face.distance};
  const double fall = held.fall();
  if (fall <= 0.0 || face.rise < 0.0) {
    const double mean = kirchhoff_mean(held.face, held.particle, face.rise);
    return {face.area * mean / face.distance, face.area * settled_flow(held).slope};
  }
  const FaceFlow flow = wetting_flow(held, front_of(p, face.pressure));
  return {face.area * flow.flux / fall, face.area * flow.slope};
}

double PoreFlow::face_inflow(const FacePressure& face, double head) const {
  const double face_head = face.pressure / water_.unit_weight() + elevation_[face.particle] + face.rise;
  return face_law(face).conductance * (face_head - head);
}

// The laws of the open faces for the present pressure and head, and the parts of them that hold there.
void PoreFlow::find_open_face_laws(const Boundary& boundary) {
  open_laws_.clear();
  open_parts_.clear();
  for (const OpenFace& face : boundary.open_faces) {
    const double height = elevation_[face.particle] + face.rise;
    OpenFaceLaw law;
    law.rain = face.rain;
    law.wet_conductance = face_law(held_at(face, face.ponding_pressure)).conductance;
    law.wet_head = face.ponding_pressure / water_.unit_weight() + height;
    if (face.rain < 0.0) {
      law.dry_conductance = face_law(held_at(face, face.lowest_pressure)).conductance;
      law.dry_head = face.lowest_pressure / water_.unit_weight() + height;
    }
    open_laws_.push_back(law);
    open_parts_.push_back(law.part_at(head_[face.particle]));
  }
}

// What drains let out, linear about the present head: the conductivity itself, and its slope.
void PoreFlow::find_drain_laws(const Boundary& boundary) {
  drain_laws_.clear();
  for (const Drain& drain : boundary.drains) {
    const std::size_t p = drain.particle;
    drain_laws_.push_back({drain.width * conductivity_[p], drain.width * conductivity_slope(p), head_[p],
                           drain.width * soils_[soil_[p]].hydraulic_conductivity});
  }
}

// Puts the parts of the laws that hold at the head just found into the equations. @return whether one is another.
bool PoreFlow::switch_open_faces(const Boundary& boundary, double time_step, double flow_scale) {
  bool switched = false;
  for (std::size_t k = 0; k < open_laws_.size(); ++k) {
    const std::size_t p = boundary.open_faces[k].particle;
    const OpenFaceLaw& law = open_laws_[k];
    const OpenFaceLaw::Part before = open_parts_[k];
    const OpenFaceLaw::Part now = law.part_at(head_[p] + change_[p] / water_.unit_weight());
    if (now == before) continue;
    const double stiffer = flow_scale * (law.conductance(now) - law.conductance(before));
    storage_[p] += stiffer;
    diagonal_[p] += stiffer;
    right_side_[p] += time_step * (law.inflow(now, head_[p]) - law.inflow(before, head_[p]));
    open_parts_[k] = now;
    switched = true;
  }
  return switched;
}

// The right side without the offsets of storage over the one with them, in the solver's norm.
double PoreFlow::offset_share() const {
  double without = 0.0, with = 0.0;
  for (std::size_t p = 0; p < state_.pressure.size(); ++p) {
    const double first = right_side_[p] + storage_offset_[p];
    without += first * first / diagonal_[p];
    with += right_side_[p] * right_side_[p] / diagonal_[p];
  }
  return with > 0.0 ? std::sqrt(without / with) : 1.0;
}

// The tangent at a pressure.
PoreFlow::Tangent PoreFlow::tangent_at(std::size_t p, double pressure, const Skeleton& skeleton) const {
  const Saturation s = evaluate(soils_[soil_[p]].retention, -pressure / water_.unit_weight());
  const double pores = skeleton.volume[p] * skeleton.porosity[p];
  const double stored = pores * (s.saturation * (1.0 + pressure / water_.bulk_modulus) -
                                 saturation_[p] * (1.0 + state_.pressure[p] / water_.bulk_modulus));
  const double slope = pores * (s.saturation / water_.bulk_modulus - s.slope / water_.unit_weight());
  return {p, stored - slope * (pressure - state_.pressure[p]), slope, pressure};
}

// Puts the tangents of the retention curves at the pressure just found into the equations, if what the present ones get
// wrong exceeds the tolerable (m2, root of the sum of squares). @return whether it did.
bool PoreFlow::follow_retention(const Skeleton& skeleton, double tolerable) {
  constexpr double straight = 0.01;  // relative change of the suction within which a curve counts as its tangent
  double squares = 0.0;
  tangents_.clear();
  for (std::size_t p = 0; p < state_.pressure.size(); ++p) {
    const double before = state_.pressure[p], now = before + change_[p];
    const bool on_tangent = (before > 0.0 && now > 0.0) || std::abs(change_[p]) < -straight * before;
    if (on_tangent && storage_offset_[p] == 0.0) continue;
    tangents_.push_back(tangent_at(p, now, skeleton));
    const Tangent& tangent = tangents_.back();
    const double wrong = tangent.offset - storage_offset_[p] + (tangent.slope - storage_slope_[p]) * change_[p];
    squares += wrong * wrong;
  }
  if (squares <= tolerable * tolerable) return false;
  for (Tangent& tangent : tangents_) {
    const std::size_t p = tangent.particle;
    // from the wet side not past the steepest place, behind which Newton's method would be thrown back further each
    // time
    const double steepest =
        std::visit([&](const auto& law) { return -law.steepest() * water_.unit_weight(); }, soils_[soil_[p]].retention);
    if (tangent.touched < steepest && touched_[p] > steepest) tangent = tangent_at(p, steepest, skeleton);
    const double stiffer = tangent.slope - storage_slope_[p];
    storage_[p] += stiffer;
    diagonal_[p] += stiffer;
    right_side_[p] -= tangent.offset - storage_offset_[p];
    storage_slope_[p] = tangent.slope;
    storage_offset_[p] = tangent.offset;
    touched_[p] = tangent.touched;
  }
  return true;
}

void PoreFlow::finish(double time_step, const Skeleton& skeleton, const Boundary& boundary) {
  const double inverse_weight = 1.0 / water_.unit_weight();
  for (std::size_t p = 0; p < state_.pressure.size(); ++p) head_[p] += change_[p] * inverse_weight;
  find_flow(boundary);
  for (std::size_t p = 0; p < state_.pressure.size(); ++p) state_.pressure[p] += change_[p];
  book(time_step, skeleton, boundary);
}

// The flow of the step at its heads, with the conductivities and positions for which it was solved.
void PoreFlow::find_flow(const Boundary& boundary) {
  operator_.apply(head_, outflow_);
  take_in_boundary_flow(boundary);
}

// Takes what comes in by faces, inflows and drains off the particles' outflow, and notes it by boundary. Of the open
// faces that is what their laws say at the present head: were the step solved for another part of a law, the particle's
// defect has the difference.
void PoreFlow::take_in_boundary_flow(const Boundary& boundary) {
  state_.inflow_rate.assign(boundary.count, 0.0);
  std::fill(face_gain_.begin(), face_gain_.end(), 0.0);
  std::fill(face_full_.begin(), face_full_.end(), std::uint8_t{0});
  for (const FacePressure& face : boundary.faces) {
    const double rate = face_inflow(face, head_[face.particle]);
    face_gain_[face.particle] += std::max(rate, 0.0);
    face_full_[face.particle] = 1;
    outflow_[face.particle] -= rate;
    state_.inflow_rate[face.boundary] += rate;
  }
  for (const Inflow& inflow : boundary.inflows) {
    outflow_[inflow.particle] -= inflow.rate;
    state_.inflow_rate[inflow.boundary] += inflow.rate;
  }
  for (std::size_t k = 0; k < drain_laws_.size(); ++k) {
    const Drain& drain = boundary.drains[k];
    const double rate = drain_laws_[k].outflow(head_[drain.particle]);
    outflow_[drain.particle] += rate;
    state_.inflow_rate[drain.boundary] -= rate;
  }
  state_.air_flow = {};
  for (std::size_t k = 0; k < open_laws_.size(); ++k) {
    const OpenFace& face = boundary.open_faces[k];
    const double head = head_[face.particle];
    const OpenFaceLaw::Part part = open_laws_[k].part_at(head);
    const double rate = open_laws_[k].inflow(part, head);
    face_gain_[face.particle] += std::max(rate, 0.0);
    if (part != OpenFaceLaw::Part::air) face_full_[face.particle] = 1;
    outflow_[face.particle] -= rate;
    state_.inflow_rate[face.boundary] += rate;
    state_.air_flow += seepage::air_flow(face.rain, rate);
  }
}

// A front begins anew where a face lets nothing in, and where a particle passes on what rain gives it.
void PoreFlow::follow_front(std::size_t p, double gain, double time_step) {
  constexpr double kept = 0.1;  // of what comes in, by a particle that does not pass it on
  if (face_full_[p] != 0 && face_gain_[p] > 0.0) return;
  if (gain <= kept * time_step * face_gain_[p]) state_.front_start[p] = state_.pressure[p];
}

// Evaluates the soil at the new pressure and books the water of the step, given the particles' outflow.
void PoreFlow::book(double time_step, const Skeleton& skeleton, const Boundary& boundary) {
  evaluate_soil();
  for (std::size_t p = 0; p < state_.pressure.size(); ++p) {
    const double content = water_of(p, skeleton);
    follow_front(p, content - state_.content[p], time_step);
    state_.defect[p] += state_.content[p] - content - time_step * outflow_[p];
    state_.content[p] = content;
  }
  for (const HeldPressure& held : boundary.held) {
    state_.inflow_rate[held.boundary] -= state_.defect[held.particle] / time_step;
    state_.defect[held.particle] = 0.0;
  }
  state_.inflow.resize(boundary.count, 0.0);
  for (std::size_t b = 0; b < boundary.count; ++b) state_.inflow[b] += time_step * state_.inflow_rate[b];
  check();
}

void PoreFlow::advance_explicitly(double time_step, const Skeleton& skeleton, std::span<const double> vx,
                                  std::span<const double> vy, const Boundary& boundary) {
  const std::size_t n = state_.pressure.size();
  if (!two_pass_) two_pass_.emplace(settings_.spacing, settings_.smoothing_ratio, settings_.walls);
  wx_.resize(n);
  wy_.resize(n);
  two_pass_->update(skeleton);
  find_head(skeleton);
  two_pass_->darcy_velocity(head_, conductivity_, wx_, wy_);
  two_pass_->divergence(wx_, wy_, outflow_);
  two_pass_->divergence(vx, vy, work_);
  for (std::size_t p = 0; p < n; ++p) outflow_[p] *= skeleton.volume[p];
  find_open_face_laws(boundary);
  find_drain_laws(boundary);
  take_in_boundary_flow(boundary);
  for (std::size_t p = 0; p < n; ++p) {
    const double storage = skeleton.porosity[p] * (saturation_[p] / water_.bulk_modulus + capacity_[p]);
    change_[p] = -time_step / storage * (outflow_[p] / skeleton.volume[p] + saturation_[p] * work_[p]);
  }
  for (const HeldPressure& held : boundary.held)
    change_[held.particle] = held.pressure - state_.pressure[held.particle];
  for (std::size_t p = 0; p < n; ++p) state_.pressure[p] += change_[p];
  book(time_step, skeleton, boundary);
}

double PoreFlow::explicit_step(const Skeleton& skeleton) const {
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t p = 0; p < state_.pressure.size(); ++p) {
    const double diffusivity =
        soils_[soil_[p]].hydraulic_conductivity * water_.bulk_modulus / (skeleton.porosity[p] * water_.unit_weight());
    shortest = std::min(shortest, settings_.spacing * settings_.spacing / diffusivity);
  }
  return shortest;
}

void PoreFlow::check() const {
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
    wx[p] *= -conductivity_[p];
    wy[p] *= -conductivity_[p];
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
