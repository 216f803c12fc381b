// Implicit steps of pore water in a skeleton that does not move: Newton's method on an assembled matrix.

#include <algorithm>
#include <cmath>

#include "slope/seepage/pore_flow.hpp"

namespace slope::seepage {

// matrix_ = storage + t L / gamma_w with the rows and columns of held particles taken out. The pattern is that of the
// neighbours, filled in place while they stay the same.
void PoreFlow::assemble(double flow_scale) {
  const Neighbours& neighbours = operator_.neighbours();
  const std::size_t n = pressure_.size();
  if (!pattern_known_) {
    matrix_.resize(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n));
    matrix_.resizeNonZeros(static_cast<Eigen::Index>(n + neighbours.index.size()));
    auto* outer = matrix_.outerIndexPtr();
    auto* inner = matrix_.innerIndexPtr();
    std::size_t k = 0;
    for (std::size_t p = 0; p < n; ++p) {
      outer[p] = static_cast<int>(k);
      bool placed = false;
      for (const std::uint32_t q : neighbours.of(p)) {
        if (!placed && q > p) {
          inner[k++] = static_cast<int>(p);
          placed = true;
        }
        inner[k++] = static_cast<int>(q);
      }
      if (!placed) inner[k++] = static_cast<int>(p);
    }
    outer[n] = static_cast<int>(k);
  }
  const std::span<const double> conductance = operator_.conductance();
  double* value = matrix_.valuePtr();
  const auto* inner = matrix_.innerIndexPtr();
  std::size_t k = 0, s = 0;
  for (std::size_t p = 0; p < n; ++p) {
    const std::size_t end = k + neighbours.of(p).size() + 1;
    for (; k < end; ++k) {
      const auto q = static_cast<std::size_t>(inner[k]);
      if (q == p) {
        value[k] = storage_[p] + flow_scale * operator_.diagonal()[p];
      } else {
        value[k] = is_held_[p] != 0 || is_held_[q] != 0 ? 0.0 : -flow_scale * conductance[s];
        ++s;
      }
    }
  }
  if (!pattern_known_) factorisation_.analyzePattern(matrix_);
  pattern_known_ = true;
}

SolveReport PoreFlow::advance(double time_step, const Skeleton& skeleton, const Boundary& boundary,
                              double tolerance_pressure, int maximum_iterations) {
  const std::size_t n = pressure_.size();
  const double flow_scale = time_step / water_.unit_weight();
  follow(skeleton);
  const std::vector<double> start = pressure_;
  std::fill(is_held_.begin(), is_held_.end(), std::uint8_t{0});
  for (const HeldPressure& held : boundary.held) is_held_[held.particle] = 1;

  SolveReport report;
  report.converged = false;
  Eigen::VectorXd b(static_cast<Eigen::Index>(n));
  while (!report.converged && report.iterations < maximum_iterations) {
    find_head(skeleton);
    operator_.set_conductivity(conductivity_);
    operator_.apply(head_, outflow_);
    for (std::size_t p = 0; p < n; ++p) {
      storage_[p] = skeleton.volume[p] * skeleton.porosity[p] *
                    (saturation_[p] / water_.bulk_modulus + capacity_[p] * (1.0 + pressure_[p] / water_.bulk_modulus));
      right_side_[p] = content_[p] + defect_[p] - water_of(p, skeleton) - time_step * outflow_[p];
    }
    for (const FacePressure& face : boundary.faces) {
      storage_[face.particle] += flow_scale * face_conductance(face);
      right_side_[face.particle] += time_step * face_inflow(face, head_[face.particle]);
    }
    for (const Inflow& inflow : boundary.inflows) right_side_[inflow.particle] += time_step * inflow.rate;
    find_open_face_laws(boundary);
    for (std::size_t k = 0; k < open_laws_.size(); ++k) {
      const std::size_t p = boundary.open_faces[k].particle;
      storage_[p] += flow_scale * open_laws_[k].conductance(open_parts_[k]);
      right_side_[p] += time_step * open_laws_[k].inflow(open_parts_[k], head_[p]);
    }
    std::fill(change_.begin(), change_.end(), 0.0);
    for (const HeldPressure& held : boundary.held) change_[held.particle] = held.pressure - pressure_[held.particle];
    operator_.apply(change_, work_);
    assemble(flow_scale);
    for (std::size_t p = 0; p < n; ++p) {
      b[static_cast<Eigen::Index>(p)] = is_held_[p] != 0
                                            ? (storage_[p] + flow_scale * operator_.diagonal()[p]) * change_[p]
                                            : right_side_[p] - flow_scale * work_[p];
    }
    factorisation_.factorize(matrix_);
    ++report.iterations;
    if (factorisation_.info() != Eigen::Success) break;
    const Eigen::VectorXd solution = factorisation_.solve(b);
    double largest = 0.0;
    for (std::size_t p = 0; p < n; ++p) {
      const double step = solution[static_cast<Eigen::Index>(p)];
      change_[p] = pressure_[p] + step - start[p];
      largest = std::max(largest, std::abs(step));
    }
    if (!std::isfinite(largest)) break;
    report.converged = largest <= tolerance_pressure;
    if (!report.converged) {
      for (std::size_t p = 0; p < n; ++p) pressure_[p] = start[p] + change_[p];
      evaluate_soil();
    }
  }
  pressure_ = start;
  if (!report.converged) {
    evaluate_soil();
    return report;
  }
  for (std::size_t p = 0; p < n; ++p) report.largest_change = std::max(report.largest_change, std::abs(change_[p]));
  find_head(skeleton);
  finish(time_step, skeleton, boundary);
  return report;
}

}  // namespace slope::seepage
