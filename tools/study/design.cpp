#include "design.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <openturns/Box.hxx>
#include <openturns/DistFunc.hxx>
#include <openturns/LHSExperiment.hxx>
#include <openturns/LowDiscrepancyExperiment.hxx>
#include <openturns/MonteCarloExperiment.hxx>
#include <openturns/Normal.hxx>
#include <openturns/NormalCopula.hxx>
#include <openturns/RandomGenerator.hxx>
#include <openturns/SobolIndicesExperiment.hxx>
#include <openturns/SobolSequence.hxx>

#include "openturns_distributions.hpp"

namespace slope::tools {

namespace {

/// Samples of independent normal scores.
struct ScoresMaker {
  OT::UnsignedInteger parameters;

  OT::Sample operator()(const Grid& grid) const {
    const auto levels = static_cast<double>(grid.levels);
    OT::Sample points = OT::Box(OT::Point(parameters, levels - 2.0)).generate();  // from 0 to 1 with both ends
    for (OT::UnsignedInteger i = 0; i < points.getSize(); ++i) {
      for (OT::UnsignedInteger j = 0; j < parameters; ++j) {
        points(i, j) = OT::DistFunc::qNormal((0.5 + points(i, j) * (levels - 1.0)) / levels);
      }
    }
    return points;
  }
  OT::Sample operator()(const LatinHypercube& design) const {
    seed(design);
    return OT::LHSExperiment(OT::Normal(parameters), size(design)).generate();
  }
  OT::Sample operator()(const SobolSequence& design) const {
    seed(design);
    OT::LowDiscrepancyExperiment experiment(OT::SobolSequence(), OT::Normal(parameters), size(design));
    experiment.setRandomize(true);
    return experiment.generate();
  }
  OT::Sample operator()(const SobolIndices& design) const {
    seed(design);
    return OT::SobolIndicesExperiment(OT::MonteCarloExperiment(OT::Normal(parameters), size(design))).generate();
  }
  OT::Sample operator()(const MonteCarlo& design) const {
    seed(design);
    return OT::MonteCarloExperiment(OT::Normal(parameters), size(design)).generate();
  }

 private:
  static void seed(const auto& design) { OT::RandomGenerator::SetSeed(static_cast<OT::UnsignedInteger>(design.seed)); }
  static OT::UnsignedInteger size(const auto& design) { return static_cast<OT::UnsignedInteger>(design.samples); }
};

}  // namespace

Samples samples_of(const Study& study) {
  const OT::UnsignedInteger parameters = study.parameters.size();
  const OT::Sample scores = std::visit(ScoresMaker{parameters}, study.design);
  const OT::NormalCopula copula(scores_correlation(study.parameters, study.correlations));
  const OT::Sample probabilities = copula.getInverseIsoProbabilisticTransformation()(scores);
  Samples samples(scores.getSize(), std::vector<double>(parameters));
  for (OT::UnsignedInteger j = 0; j < parameters; ++j) {
    const OT::Distribution distribution = distribution_of(study.parameters[j].distribution);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      samples[i][j] = distribution.computeQuantile(probabilities(i, j))[0];
    }
  }
  return samples;
}

std::size_t independent_samples(const Study& study, std::size_t samples) {
  const auto* indices = std::get_if<SobolIndices>(&study.design);
  return indices == nullptr ? samples : 2 * static_cast<std::size_t>(indices->samples);
}

bool is_random(const Design& design) {
  return !std::holds_alternative<Grid>(design);
}

std::string name_of(const Design& design) {
  constexpr std::array names{"grid", "latin_hypercube", "sobol_sequence", "sobol_indices", "monte_carlo"};
  return names.at(design.index());
}

int seed_of(const Design& design) {
  return std::visit(
      [](const auto& one) {
        if constexpr (requires { one.seed; }) {
          return one.seed;
        } else {
          return 0;
        }
      },
      design);
}

}  // namespace slope::tools
