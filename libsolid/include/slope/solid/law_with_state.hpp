#pragma once

#include <concepts>
#include <span>

#include "slope/solid/soil.hpp"
#include "slope/solid/tensor.hpp"

namespace slope::solid {

/// A number that a strength law keeps at each particle.
struct InternalVariable {
  const char* name;  ///< as in output files
  const char* unit;
};

/// What one particle goes through in a step.
struct StrainStep {
  SymmetricTensor strain;        ///< increment (-), tension positive; rotation is in the stress already
  double suction = 0.0;          ///< at the step's start (Pa), any sign
  double specific_volume = 1.0;  ///< v = 1 / (1 - n) at the step's start (-), >= 1
  bool yields = true;            ///< false: the elastic answer, whatever the strength
};

/// A strength law with a stiffness of its own and internal variables, which particles keep for it:
///
///     internal_variables                     their names and units, an array known when compiling
///     initial(stress, internal)              sets them for soil that is found under a stress (Pa)
///     stiffness(stress, v)                   the Elastic that it answers with to a small strain
///     update(step, internal, stress)         takes stress and variables over a step; returns the deviatoric plastic
///                                            strain sqrt(2/3 de:de) of it (-). What it cannot integrate becomes a
///                                            stress that is not a number
template <class Law>
concept LawWithState = requires(const Law& law, const StrainStep& step, const SymmetricTensor& found,
                                std::span<double> internal, SymmetricTensor& stress) {
  Law::internal_variables.size();
  law.initial(found, internal);
  { law.stiffness(found, 1.0) } -> std::same_as<Elastic>;
  { law.update(step, internal, stress) } -> std::same_as<double>;
};

}  // namespace slope::solid
