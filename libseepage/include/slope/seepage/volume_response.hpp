#pragma once

#include <algorithm>
#include <span>

namespace slope::seepage {

/// How the skeleton answers a change of pore pressure within one step: given a pressure-like field q = S_r dP (Pa), the
/// volume change (m2 per metre of thickness) that it causes, symmetric and positive semidefinite in q, and the diagonal
/// of that map (m2/Pa). One entry per particle; asked once per iteration of a step, for all of them.
class VolumeResponse {
 public:
  virtual ~VolumeResponse() = default;
  virtual void apply(std::span<const double> q, std::span<double> volume_change) const = 0;
  virtual void diagonal(std::span<double> diagonal) const = 0;

 protected:
  VolumeResponse() = default;
  VolumeResponse(const VolumeResponse&) = default;
  VolumeResponse& operator=(const VolumeResponse&) = default;
};

/// A skeleton that does not move.
class RigidSkeleton final : public VolumeResponse {
 public:
  void apply(std::span<const double> /*q*/, std::span<double> volume_change) const override {
    std::fill(volume_change.begin(), volume_change.end(), 0.0);
  }
  void diagonal(std::span<double> diagonal) const override { std::fill(diagonal.begin(), diagonal.end(), 0.0); }
};

}  // namespace slope::seepage
