#pragma once

#include <algorithm>
#include <concepts>
#include <span>

namespace slope::seepage {

/// How the skeleton answers a change of pore pressure within one step: given a pressure-like field q = S_r dP (Pa), the
/// volume change (m2 per metre of thickness) that it causes, symmetric and positive semidefinite in q, and the diagonal
/// of that map (m2/Pa). One entry per particle.
template <class R>
concept VolumeResponse = requires(const R& response, std::span<const double> q, std::span<double> volume_change) {
  response.apply(q, volume_change);
  response.diagonal(volume_change);
};

/// A skeleton that does not move.
struct RigidSkeleton {
  void apply(std::span<const double> /*q*/, std::span<double> volume_change) const {
    std::fill(volume_change.begin(), volume_change.end(), 0.0);
  }
  void diagonal(std::span<double> diagonal) const { std::fill(diagonal.begin(), diagonal.end(), 0.0); }
};

}  // namespace slope::seepage
