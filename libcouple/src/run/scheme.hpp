#pragma once

#include <variant>
#include <vector>

#include "clock_paced.hpp"
#include "explicit_scheme.hpp"
#include "seepage_scheme.hpp"
#include "semi_implicit_scheme.hpp"

namespace slope::couple {

/// How a step is taken, and how long it is: what the case's `coupling.scheme` names. Each scheme owns its pace.
class AnyScheme {
 public:
  /// @param change_times  of the boundary conditions (s)
  AnyScheme(const Case& input, const Mixture& mixture, const SlopeScale& scale,
            const std::vector<double>& change_times);

  /// @throws what the solvers throw; the slope is then neither what it was nor what it would be.
  StepDone step(const StepTask& task);
  /// The longest step of the soil; where its stiffness varies, and of the water alone, the latest (s).
  [[nodiscard]] double time_step() const;
  [[nodiscard]] bool moves_soil() const;
  /// Adds how far the soil was out of balance, if it is moved.
  void tell(Summary& summary) const;

  [[nodiscard]] PaceState state() const;
  /// @throws std::invalid_argument if the state is of another kind of scheme, or of another number of particles
  void set_state(PaceState state);

 private:
  std::variant<ClockPaced<SemiImplicitScheme>, ClockPaced<ExplicitScheme>, SeepageScheme> scheme_;
};

}  // namespace slope::couple
