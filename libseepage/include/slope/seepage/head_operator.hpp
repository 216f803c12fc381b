#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "slope/seepage/images.hpp"
#include "slope/seepage/kernel.hpp"
#include "slope/seepage/mean_conductivity.hpp"
#include "slope/seepage/neighbours.hpp"
#include "slope/seepage/seam.hpp"
#include "slope/seepage/skeleton.hpp"

namespace slope::seepage {

/// The pairwise, conservative SPH operator of the hydraulic head h = P_w / gamma_w + y:
///
///     (L h)_p = sum_q g_pq K_pq (h_p - h_q),   g_pq = g_qp > 0,   K_pq = kirchhoff_mean(p, q) = K_qp > 0,
///
/// the outflow of particle p (m2/s per metre of thickness). Symmetric and positive semidefinite; what leaves p enters
/// q; a uniform head does not flow. g_pq = 2 V_p V_q F_pq c_pq, F = -W'/r, with a MomentCorrection c that makes
/// conduction exact in all directions on any lattice, and linear heads flow without residual, up to a free surface.
/// At walls the mirror images of the neighbours are part of the sums, which
/// makes the wall impermeable. Between particles of two soils K_pq is seam_mean(): the seam divides the path as the
/// distances of p and q from the other soil's nearest particle do, each less half a spacing. Under a head that is
/// linear in each of two layers a pair across their seam then conducts what a pair in one soil does.
class HeadOperator {
 public:
  /// What the pair factors and the conductances were worked out for, and what was found at the seams.
  struct State {
    std::vector<double> x, y;                                               ///< positions then (m)
    std::vector<double> volume;                                             ///< then (m2)
    std::vector<double> conductivity, pressure_head, potential;             ///< of the particles (m/s, m, m2/s)
    std::vector<double> seam_conductivity, seam_pressure_head, seam_reach;  ///< the SeamMean of each pair across one

    template <class Self, class Visit>
    static void for_each_field(Self& s, const Visit& visit) {
      visit("x", s.x), visit("y", s.y);
      visit("volume", s.volume);
      visit("conductivity", s.conductivity);
      visit("pressure_head", s.pressure_head);
      visit("potential", s.potential);
      visit("seam_conductivity", s.seam_conductivity);
      visit("seam_pressure_head", s.seam_pressure_head);
      visit("seam_reach", s.seam_reach);
    }
    bool operator==(const State&) const = default;
  };

  /// @param spacing  particle spacing (m); @param smoothing_ratio  smoothing length over spacing (-)
  /// @throws std::invalid_argument naming the field that is out of its range
  HeadOperator(double spacing, double smoothing_ratio, const MirrorWalls& walls, int threads);

  /// Tells soils apart; without it all particles are of one. @param soil  index into `curves` of each particle
  void set_soils(std::span<const std::uint16_t> soil, std::vector<ConductivityCurve> curves);
  [[nodiscard]] std::span<const ConductivityCurve> curves() const { return curves_; }

  /// Follows the particles; works the pair factors out anew when one has moved by more than a hundredth of the
  /// spacing since the last time. @return whether it did.
  bool update(const Skeleton& skeleton);

  [[nodiscard]] const State& state() const { return state_; }
  /// Goes on from a state that one with the same soils had.
  /// @throws std::invalid_argument if its arrays do not belong together
  void set_state(State state);

  /// Conductances of the pairs for the conductivities K_p = k k_rw (m/s), with K_pq the logarithmic mean.
  void set_conductivity(std::span<const double> conductivity);

  /// The pressure head (m) of a particle that its pairs' conductances are for; infinite if there are none yet.
  [[nodiscard]] double pressure_head(std::size_t p) const { return state_.pressure_head[p]; }
  /// What a particle conducts from the next find_conductances() on; it counts as it did before until it is told.
  /// Particles are independent, so that threads may tell of several. @param at  of set_soils()'s curves
  void set_conductivity(std::size_t p, const PotentialAt& at) {
    state_.conductivity[p] = at.conductivity;
    state_.pressure_head[p] = at.pressure_head;
    state_.potential[p] = at.potential;
    stale_[p] = 1;
  }
  /// Works out the conductances of the pairs of which a particle has been told anew, with K_pq = kirchhoff_mean() or
  /// seam_mean().
  void find_conductances();

  /// outflow = L h (m2/s).
  void apply(std::span<const double> head, std::span<double> outflow) const;
  /// Diagonal of L (m/s).
  [[nodiscard]] std::span<const double> diagonal() const { return diagonal_; }

  [[nodiscard]] const Neighbours& neighbours() const { return neighbours_; }
  /// Conductance of each pair (m/s), in the order of neighbours().index.
  [[nodiscard]] std::span<const double> conductance() const { return conductance_; }

  /// By how much more than its conductance (m/s) the flow from particle p through the pair that stands in place s of
  /// neighbours().index changes with the pressure head of p. @param slope  of the conductivity of p over it (1/s);
  /// @param fall  of the head from p to its neighbour (m)
  [[nodiscard]] double flow_slope(std::size_t p, std::size_t s, double slope, double fall) const;

  /// Gradient (per metre) of a particle field, exact for linear fields; mirror images continue it evenly over walls.
  void gradient(std::span<const double> field, const Skeleton& skeleton, std::span<double> dx,
                std::span<double> dy) const;

 private:
  // A pair across a seam.
  struct Seam {
    std::uint32_t first, second;  // particles, first < second
    std::size_t place;            // of the second among the neighbours of the first
    double factor;                // g_pq
    double share;                 // of the path that lies in the soil of the first
  };

  void find_pairs();
  void find_pair_factors();
  void find_ways_back();
  void find_seams();
  void set_conductance(std::size_t s, double conductance);
  template <class Mean>
  void find_stale(const Mean& mean);
  [[nodiscard]] double seam_distance(std::size_t p, std::size_t q) const;
  [[nodiscard]] PotentialAt potential_at(std::size_t p) const;
  [[nodiscard]] double mean_in_soil(std::size_t p, std::size_t q) const;
  [[nodiscard]] SeamLeg leg(std::size_t p, double share, double drop) const;
  [[nodiscard]] SeamLeg first_leg(const Seam& seam) const;
  [[nodiscard]] SeamLeg second_leg(const Seam& seam) const;

  double spacing_;
  WendlandC2 kernel_;
  MirrorWalls walls_;
  int threads_;
  double lattice_scale_;
  Neighbours neighbours_;
  Images images_;
  State state_;
  std::vector<std::uint32_t> after_;  // where the neighbours of a particle begin that follow it in the order of all
  std::vector<std::uint32_t> back_;   // where the pair that stands in a place of neighbours_.index stands again
  std::vector<double> factor_;        // g_pq; 0 across seams
  std::vector<double> conductance_;   // g_pq K_pq
  std::vector<double> diagonal_;
  std::vector<std::uint8_t> stale_;  // whether a particle has been told anew what it conducts
  std::vector<std::uint16_t> soil_;  // empty: one soil
  std::vector<ConductivityCurve> curves_;
  std::vector<Seam> seams_;
  std::vector<std::uint32_t> seam_at_;  // which of them stands in a place of neighbours_.index; only where factor_ is 0
};

}  // namespace slope::seepage
