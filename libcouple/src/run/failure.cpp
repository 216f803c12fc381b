#include "failure.hpp"

#include <algorithm>
#include <cmath>

#include "slope/solid/tensor.hpp"

namespace slope::couple {

GroundSurface::GroundSurface(const InitialParticles& particles, const std::vector<Face>& uppermost) {
  for (const Face& face : uppermost)
    points_.push_back({particles.x[face.particle], particles.y[face.particle] + face.outwards});
  std::ranges::sort(points_);
}

double GroundSurface::depth(double x, double y) const {
  double nearest = never;
  for (std::size_t k = 0; k + 1 < points_.size(); ++k) {
    const auto [ax, ay] = points_[k];
    const double ex = points_[k + 1][0] - ax, ey = points_[k + 1][1] - ay;
    const double along = std::clamp(((x - ax) * ex + (y - ay) * ey) / (ex * ex + ey * ey), 0.0, 1.0);
    nearest = std::min(nearest, std::hypot(x - ax - along * ex, y - ay - along * ey));
  }
  return points_.size() < 2 ? 0.0 : nearest;
}

double deviatoric_strain_of(const solid::Particles& particles, std::size_t p) {
  return solid::deviatoric_strain({particles.exx[p], particles.eyy[p], 0.0, particles.exy[p]});
}

FailureZone find_failure_zone(const solid::Particles& particles, std::span<const double> suction,
                              const GroundSurface& surface, double spacing, double threshold) {
  FailureZone zone;
  if (!suction.empty()) zone.largest_suction = std::max(0.0, *std::ranges::max_element(suction));
  std::vector<std::size_t> failed;
  for (std::size_t p = 0; p < particles.size(); ++p) {
    if (deviatoric_strain_of(particles, p) <= threshold) continue;
    failed.push_back(p);
    zone.area += particles.volume[p];
    zone.depth =
        std::max(zone.depth, surface.depth(particles.x[p] - particles.ux[p], particles.y[p] - particles.uy[p]));
  }
  if (failed.empty()) return zone;
  const auto by_x = [&](std::size_t a, std::size_t b) { return particles.x[a] < particles.x[b]; };
  const auto by_y = [&](std::size_t a, std::size_t b) { return particles.y[a] < particles.y[b]; };
  const auto [left, right] = std::ranges::minmax_element(failed, by_x);
  const auto [low, high] = std::ranges::minmax_element(failed, by_y);
  zone.length = particles.x[*right] - particles.x[*left] + spacing;
  zone.lowest = particles.y[*low] - 0.5 * spacing;
  zone.highest = particles.y[*high] + 0.5 * spacing;
  zone.height = zone.highest - zone.lowest;
  return zone;
}

}  // namespace slope::couple
