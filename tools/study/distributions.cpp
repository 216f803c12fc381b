#include "distributions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <openturns/BetaMuSigma.hxx>
#include <openturns/Brent.hxx>
#include <openturns/DistFunc.hxx>
#include <openturns/GaussProductExperiment.hxx>
#include <openturns/LogNormal.hxx>
#include <openturns/LogNormalMuSigma.hxx>
#include <openturns/Normal.hxx>
#include <openturns/NormalCopula.hxx>
#include <openturns/Triangular.hxx>
#include <openturns/TruncatedDistribution.hxx>
#include <openturns/Uniform.hxx>
#include <openturns/UniformMuSigma.hxx>

#include "openturns_distributions.hpp"

namespace slope::tools {

namespace {

double width_of(const Location& location) {
  return location.standard_deviation.value_or(std::abs(*location.mean) *
                                              location.coefficient_of_variation.value_or(0.0));
}

/// The place and the scale of a family of distributions whose standard quantiles, at the probabilities of two quantiles
/// of it, are those given.
struct Line {
  double place, scale;
};
Line line_through(double standard_low, double low, double standard_high, double high) {
  const double scale = (high - low) / (standard_high - standard_low);
  return {low - scale * standard_low, scale};
}

OT::Distribution whole(const Normal& law) {
  if (law.quantiles.empty()) return OT::Normal(*law.mean, width_of(law));
  const auto& [low, high] = std::pair(law.quantiles[0], law.quantiles[1]);
  const Line line = line_through(OT::DistFunc::qNormal(low.probability), low.value,
                                 OT::DistFunc::qNormal(high.probability), high.value);
  return OT::Normal(line.place, line.scale);
}

OT::Distribution whole(const Lognormal& law) {
  if (law.quantiles.empty()) return OT::LogNormalMuSigma(*law.mean, width_of(law), 0.0).getDistribution();
  const auto& [low, high] = std::pair(law.quantiles[0], law.quantiles[1]);
  const Line line = line_through(OT::DistFunc::qNormal(low.probability), std::log(low.value),
                                 OT::DistFunc::qNormal(high.probability), std::log(high.value));
  return OT::LogNormal(line.place, line.scale, 0.0);
}

/// A distribution without what lies beyond its limits.
template <class Law>
OT::Distribution cut(const Law& law) {
  OT::Distribution uncut = whole(law);
  if (law.minimum && law.maximum) return OT::TruncatedDistribution(uncut, *law.minimum, *law.maximum);
  if (law.minimum) return OT::TruncatedDistribution(uncut, *law.minimum, OT::TruncatedDistribution::LOWER);
  if (law.maximum) return OT::TruncatedDistribution(uncut, *law.maximum, OT::TruncatedDistribution::UPPER);
  return uncut;
}

struct Maker {
  OT::Distribution operator()(const Normal& law) const { return cut(law); }
  OT::Distribution operator()(const Lognormal& law) const { return cut(law); }
  OT::Distribution operator()(const Uniform& law) const {
    if (law.minimum) return OT::Uniform(*law.minimum, *law.maximum);
    if (law.quantiles.empty()) return OT::UniformMuSigma(*law.mean, width_of(law)).getDistribution();
    const auto& [low, high] = std::pair(law.quantiles[0], law.quantiles[1]);
    const Line line = line_through(low.probability, low.value, high.probability, high.value);
    return OT::Uniform(line.place, line.place + line.scale);
  }
  OT::Distribution operator()(const Triangular& law) const {
    return OT::Triangular(law.minimum, law.mode, law.maximum);
  }
  OT::Distribution operator()(const Beta& law) const {
    return OT::BetaMuSigma(*law.mean, width_of(law), law.minimum, law.maximum).getDistribution();
  }
};

std::string fault_of_location(const Location& location) {
  if (!location.quantiles.empty()) {
    const auto& [low, high] = std::pair(location.quantiles[0], location.quantiles[1]);
    const bool rising = low.probability < high.probability && low.value < high.value;
    return rising ? "" : "the second of the two quantiles must have the larger probability and the larger value";
  }
  if (*location.mean == 0.0 && location.coefficient_of_variation)
    return "a coefficient_of_variation says nothing of a mean of 0; give the standard_deviation";
  return "";
}

/// Of a distribution that is cut off, whether enough of it is left.
template <class Law>
std::string fault_of_limits(const Law& law) {
  constexpr double least_left = 1.0e-3;
  if (law.minimum && law.maximum && *law.minimum >= *law.maximum) return "the minimum must be below the maximum";
  const OT::Distribution uncut = whole(law);
  const double below = law.minimum ? uncut.computeCDF(*law.minimum) : 0.0;
  const double up_to = law.maximum ? uncut.computeCDF(*law.maximum) : 1.0;
  if (up_to - below >= least_left) return "";
  return fmt::format("only {:.2g} of the distribution lies between its limits; widen them or shift the mean",
                     up_to - below);
}

struct FaultFinder {
  std::string operator()(const Normal& law) const {
    const std::string fault = fault_of_location(law);
    return fault.empty() ? fault_of_limits(law) : fault;
  }
  std::string operator()(const Lognormal& law) const {
    const bool above_zero = law.quantiles.empty() ? *law.mean > 0.0 : law.quantiles.front().value > 0.0;
    if (!above_zero) return "a lognormal distribution lies above 0; choose another, or a larger mean or quantile";
    const std::string fault = fault_of_location(law);
    return fault.empty() ? fault_of_limits(law) : fault;
  }
  std::string operator()(const Uniform& law) const {
    if (law.minimum) return *law.minimum < *law.maximum ? "" : "the minimum must be below the maximum";
    return fault_of_location(law);
  }
  std::string operator()(const Triangular& law) const {
    const bool ordered = law.minimum <= law.mode && law.mode <= law.maximum && law.minimum < law.maximum;
    return ordered ? "" : "the mode must lie between the minimum and the maximum, which must be above the minimum";
  }
  std::string operator()(const Beta& law) const {
    if (!(law.minimum < *law.mean && *law.mean < law.maximum)) return "the mean must lie between minimum and maximum";
    std::string fault = fault_of_location(law);
    if (!fault.empty()) return fault;
    const double most = std::sqrt((*law.mean - law.minimum) * (law.maximum - *law.mean));
    if (width_of(law) < most) return "";
    return fmt::format(
        "the standard deviation is {:.3g} of the largest with these ends and this mean; it must be below 1",
        width_of(law) / most);
  }
};

/// Pearson's correlation of two parameters over that of their normal scores, by Gauss-Hermite quadrature.
class ValuesCorrelation : public OT::UniVariateFunctionImplementation {
 public:
  ValuesCorrelation(OT::Distribution one, OT::Distribution other) : one_(std::move(one)), other_(std::move(other)) {
    constexpr OT::UnsignedInteger nodes = 40;
    OT::GaussProductExperiment quadrature(OT::Normal(2), OT::Indices(2, nodes));
    scores_ = quadrature.generateWithWeights(weights_);
  }
  ValuesCorrelation* clone() const override { return new ValuesCorrelation(*this); }
  OT::Scalar operator()(const OT::Scalar of_scores) const override {
    const double rest = std::sqrt(1.0 - of_scores * of_scores);
    double mean_x = 0.0, mean_y = 0.0, xx = 0.0, yy = 0.0, xy = 0.0;
    for (OT::UnsignedInteger i = 0; i < weights_.getSize(); ++i) {
      const double x = value_of(one_, scores_(i, 0)), w = weights_[i];
      const double y = value_of(other_, of_scores * scores_(i, 0) + rest * scores_(i, 1));
      mean_x += w * x, mean_y += w * y;
      xx += w * x * x, yy += w * y * y, xy += w * x * y;
    }
    return (xy - mean_x * mean_y) / std::sqrt((xx - mean_x * mean_x) * (yy - mean_y * mean_y));
  }

 private:
  static double value_of(const OT::Distribution& distribution, double score) {
    return distribution.computeQuantile(OT::DistFunc::pNormal(score))[0];
  }

  OT::Distribution one_, other_;
  OT::Sample scores_;
  OT::Point weights_;
};

double scores_correlation_for_pearson(double pearson, const OT::Distribution& one, const OT::Distribution& other) {
  constexpr double most = 0.9999, exact = 1.0e-6;
  const OT::UniVariateFunction of_values = ValuesCorrelation(one, other);
  return OT::Brent(exact, exact, exact, 100).solve(of_values, pearson, -most, most);
}

double scores_correlation_for_rank(double rank) {
  OT::CorrelationMatrix ranks(2);
  ranks(0, 1) = rank;
  return OT::NormalCopula::GetCorrelationFromSpearmanCorrelation(ranks)(0, 1);
}

}  // namespace

OT::Distribution distribution_of(const Distribution& law) {
  return std::visit(Maker{}, law);
}

OT::CorrelationMatrix scores_correlation(const std::vector<Parameter>& parameters,
                                         const std::vector<Correlation>& correlations) {
  const auto place_of = [&parameters](const std::string& name) {
    return static_cast<std::size_t>(std::ranges::find(parameters, name, &Parameter::name) - parameters.begin());
  };
  OT::CorrelationMatrix scores(parameters.size());
  for (const Correlation& correlation : correlations) {
    const std::size_t i = place_of(correlation.between[0]), j = place_of(correlation.between[1]);
    scores(i, j) = correlation.rank ? scores_correlation_for_rank(*correlation.rank)
                                    : scores_correlation_for_pearson(*correlation.pearson,
                                                                     distribution_of(parameters[i].distribution),
                                                                     distribution_of(parameters[j].distribution));
  }
  return scores;
}

std::string name_of(const Distribution& distribution) {
  constexpr std::array names{"normal", "lognormal", "uniform", "triangular", "beta"};
  return names.at(distribution.index());
}

std::string fault_of(const Distribution& distribution) {
  return std::visit(FaultFinder{}, distribution);
}

double quantile(const Distribution& distribution, double probability) {
  return distribution_of(distribution).computeQuantile(probability)[0];
}

double mean(const Distribution& distribution) {
  return distribution_of(distribution).getMean()[0];
}

double standard_deviation(const Distribution& distribution) {
  return distribution_of(distribution).getStandardDeviation()[0];
}

std::string fault_of(const std::vector<Parameter>& parameters, const std::vector<Correlation>& correlations) {
  try {
    OT::CorrelationMatrix scores = scores_correlation(parameters, correlations);
    if (scores.isPositiveDefinite()) return "";
  } catch (const OT::Exception&) {
    return "a pearson coefficient is beyond what two of these distributions can have; take a smaller one";
  }
  return "the matrix of these coefficients is not positive definite: no parameters can be correlated like this; make "
         "some "
         "of them smaller";
}

}  // namespace slope::tools
