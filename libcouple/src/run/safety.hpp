#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "balance.hpp"
#include "failure.hpp"

namespace slope::couple {

/// The factor of safety by strength reduction. Each trial divides all strength by a factor and lets the soil move at
/// fixed positions, damped, under the water as it is, until it is balanced or flows: find_balance(), with less than
/// unbalanced_limit left or more. Trials start from the stress of the strongest reduction that was borne. The factor is
/// bracketed; then a trial is made where the force that the last two flows left unbalanced comes to nothing.
class SafetySearch {
 public:
  /// @param slope  in balance, or as it moves; @param actions  on it; @param surface  of the start
  SafetySearch(const Mixture& slope, const Actions& actions, const SlopeScale& scale, double courant_number,
               const GroundSurface& surface);

  /// Only soil within is weakened. @param where  of each particle, whether it is
  void reduce_within(std::vector<std::uint8_t> where) { where_ = std::move(where); }

  /// @param tolerance  of the bracket, over the factor (-), in (0, 1)
  /// @param earlier  factor, near which it is looked for (-), > 0; what is found depends on it within the tolerance
  /// @return none if it was not to go on
  [[nodiscard]] std::optional<FactorOfSafety> find(double tolerance, std::optional<double> earlier,
                                                   const InitialObserver& go_on);
  /// What flows with the least reduction that was found to be too much; zeros if there was none.
  [[nodiscard]] const Mechanism& mechanism() const { return mechanism_; }

 private:
  // What a trial came to.
  struct Trial {
    double factor = 0.0;      // (-)
    double unbalanced = 0.0;  // over the gravity forces (-)
  };

  [[nodiscard]] double next_factor(double growth) const;
  [[nodiscard]] std::optional<Trial> attempt(double factor, const InitialObserver& go_on);
  void take_mechanism(Mixture& flowing);

  const Mixture& slope_;
  const Actions& actions_;
  const SlopeScale& scale_;
  double courant_number_;
  const GroundSurface& surface_;
  std::vector<std::uint8_t> where_;
  std::optional<Trial> borne_;   // with the strongest reduction that was
  std::vector<Trial> too_much_;  // in the order of the trials: the factors fall
  solid::Particles stressed_;    // as they bore it
  Mechanism mechanism_;
  FactorOfSafety found_;
};

}  // namespace slope::couple
