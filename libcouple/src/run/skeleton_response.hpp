#pragma once

#include <span>

#include "slope/seepage/volume_response.hpp"
#include "slope/solid/material_point_method.hpp"

namespace slope::couple {

/// Joins what the soil offers to what the pore water asks for: the volume change that a change of pore pressure causes
/// within one step.
class SkeletonResponse final : public seepage::VolumeResponse {
 public:
  SkeletonResponse(const solid::MaterialPointMethod& soil, double time_step) : soil_(soil), time_step_(time_step) {}

  void apply(std::span<const double> q, std::span<double> volume_change) const override {
    soil_.volume_response(time_step_, q, volume_change);
  }
  void diagonal(std::span<double> diagonal) const override { soil_.volume_response_diagonal(time_step_, diagonal); }

 private:
  const solid::MaterialPointMethod& soil_;
  double time_step_;
};

}  // namespace slope::couple
