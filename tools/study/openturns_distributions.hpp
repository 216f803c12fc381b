#pragma once

#include <openturns/CorrelationMatrix.hxx>
#include <openturns/Distribution.hxx>
#include <vector>

#include "study.hpp"

/// The distributions of a study as objects of OpenTURNS, whose headers few files include since they are long.
namespace slope::tools {

[[nodiscard]] OT::Distribution distribution_of(const Distribution& law);

/// Of the normal scores of the parameters, from which a Gaussian copula is made; it need not be positive definite.
/// @throws OT::Exception if a correlation of values cannot be reached with these distributions
[[nodiscard]] OT::CorrelationMatrix scores_correlation(const std::vector<Parameter>& parameters,
                                                       const std::vector<Correlation>& correlations);

}  // namespace slope::tools
