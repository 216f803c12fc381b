#pragma once

// The matrix-free pressure step of PoreFlow; included by pore_flow.hpp.

#include <algorithm>
#include <cmath>

#include "slope/seepage/pore_flow.hpp"

namespace slope::seepage {

template <VolumeResponse Response>
SolveReport PoreFlow::solve(double time_step, const Skeleton& skeleton, std::span<const double> strain,
                            const Boundary& boundary, const Response& response, double tolerance) {
  const std::size_t n = state_.pressure.size();
  const double flow_scale = time_step / water_.unit_weight();
  find_head(skeleton);
  operator_.set_conductivity(conductivity_, pressure_head_, potential_);
  operator_.apply(head_, outflow_);
  response.diagonal(work_);
  for (std::size_t p = 0; p < n; ++p) {
    const double s = saturation_[p];
    storage_slope_[p] = skeleton.volume[p] * skeleton.porosity[p] * (s / water_.bulk_modulus + capacity_[p]);
    storage_offset_[p] = 0.0;
    touched_[p] = state_.pressure[p];
    storage_[p] = storage_slope_[p];
    right_side_[p] = -s * skeleton.volume[p] * strain[p] - time_step * outflow_[p] + state_.defect[p];
    diagonal_[p] = storage_[p] + flow_scale * operator_.diagonal()[p] + s * s * work_[p];
  }
  for (const FacePressure& face : boundary.faces) {
    const double conductance = face_law(face).conductance;
    storage_[face.particle] += flow_scale * conductance;
    diagonal_[face.particle] += flow_scale * conductance;
    right_side_[face.particle] += time_step * face_inflow(face, head_[face.particle]);
  }
  for (const Inflow& inflow : boundary.inflows) right_side_[inflow.particle] += time_step * inflow.rate;
  find_drain_laws(boundary);
  for (std::size_t k = 0; k < drain_laws_.size(); ++k) {
    const std::size_t p = boundary.drains[k].particle;
    storage_[p] += flow_scale * drain_laws_[k].slope;
    diagonal_[p] += flow_scale * drain_laws_[k].slope;
    right_side_[p] -= time_step * drain_laws_[k].rate;
  }
  find_open_face_laws(boundary);
  for (std::size_t k = 0; k < open_laws_.size(); ++k) {
    const std::size_t p = boundary.open_faces[k].particle;
    const double conductance = open_laws_[k].conductance(open_parts_[k]);
    storage_[p] += flow_scale * conductance;
    diagonal_[p] += flow_scale * conductance;
    right_side_[p] += time_step * open_laws_[k].inflow(open_parts_[k], head_[p]);
  }

  // q -> [storage + flow + response] q; the rows of held pressures are taken out
  const auto full = [&](std::span<const double> in, std::span<double> out) {
    operator_.apply(in, out);
    for (std::size_t p = 0; p < n; ++p) work_[p] = saturation_[p] * in[p];
    response.apply(work_, work2_);
    for (std::size_t p = 0; p < n; ++p) {
      out[p] = storage_[p] * in[p] + flow_scale * out[p] + saturation_[p] * work2_[p];
    }
  };
  if (!boundary.held.empty()) {
    std::fill(stress_change_.begin(), stress_change_.end(), 0.0);
    bool any_change = false;
    for (const HeldPressure& held : boundary.held) {
      stress_change_[held.particle] = held.pressure - state_.pressure[held.particle];
      any_change = any_change || stress_change_[held.particle] != 0.0;
    }
    if (any_change) {
      full(stress_change_, outflow_);
      for (std::size_t p = 0; p < n; ++p) right_side_[p] -= outflow_[p];
    }
    for (const HeldPressure& held : boundary.held) right_side_[held.particle] = 0.0;
  }
  const auto reduced = [&](std::span<const double> in, std::span<double> out) {
    full(in, out);
    for (const HeldPressure& held : boundary.held) out[held.particle] = diagonal_[held.particle] * in[held.particle];
  };
  std::fill(change_.begin(), change_.end(), 0.0);
  SolveReport report;
  tolerance *= tolerance_share_;
  const double tolerable = tolerance * std::sqrt(blocked_dot(right_side_, right_side_, settings_.threads));
  for (int pass = 0; pass < most_passes; ++pass) {
    const double reduction = pass == 0 ? tolerance : std::min(tolerance, tolerance * offset_share());
    const auto result = solver_.solve(reduced, diagonal_, right_side_, change_, reduction, 500, settings_.threads);
    report.iterations += result.iterations;
    const bool switched = switch_open_faces(boundary, time_step, flow_scale);
    const bool bent = follow_retention(skeleton, tolerable);
    report.converged = result.converged && !switched && !bent;
    if (!switched && !bent) break;
  }
  for (const HeldPressure& held : boundary.held)
    change_[held.particle] = held.pressure - state_.pressure[held.particle];
  for (std::size_t p = 0; p < n; ++p) {
    stress_change_[p] = saturation_[p] * change_[p];
    report.largest_change = std::max(report.largest_change, std::abs(change_[p]));
  }
  return report;
}

}  // namespace slope::seepage
