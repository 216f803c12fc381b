#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "slope/couple/case.hpp"

namespace slope::tools {

/// A value that is not exceeded with a probability.
struct Quantile {
  double probability = 0.5;  ///< between 0 and 1
  double value = 0.0;
};

/// Where a distribution lies and how wide it is: its mean with its standard deviation or coefficient of variation, or
/// two quantiles. Values here and below are in SI units of the parameter's key.
struct Location {
  std::optional<double> mean, standard_deviation;
  std::optional<double> coefficient_of_variation;  ///< standard deviation over mean (-)
  std::vector<Quantile> quantiles;                 ///< none or two
};

/// Cut off below the minimum and above the maximum; the location is that of the whole normal distribution.
struct Normal : Location {
  std::optional<double> minimum, maximum;
};
/// Its logarithm is normal. Cut off like Normal.
struct Lognormal : Location {
  std::optional<double> minimum, maximum;
};
/// By its ends or, without them, by its location.
struct Uniform : Location {
  std::optional<double> minimum, maximum;
};
struct Triangular {
  double minimum = 0.0, mode = 0.0, maximum = 0.0;
};
/// Between its ends.
struct Beta : Location {
  double minimum = 0.0, maximum = 0.0;
};

using Distribution = std::variant<Normal, Lognormal, Uniform, Triangular, Beta>;

/// What is uncertain: a number of the case.
struct Parameter {
  std::string name;
  std::string key;  ///< dotted, in the case
  Distribution distribution;
  std::string unit;        ///< in which it is told and handed to the runs; empty: it has none
  double unit_size = 1.0;  ///< of one unit in SI units
};

/// How two parameters go together, by a Gaussian copula. One of the coefficients is given.
struct Correlation {
  std::vector<std::string> between;     ///< two names
  std::optional<double> rank, pearson;  ///< Spearman's, of the ranks; Pearson's, of the values
};

/// Every combination of so many values of each parameter: its quantiles in the middle of as many equal shares.
struct Grid {
  int levels = 3;
};
struct LatinHypercube {
  int samples = 0, seed = 1;
};
/// Sobol's sequence, shifted at random.
struct SobolSequence {
  int samples = 0, seed = 1;
};
/// Saltelli's design for Sobol's indices: two random samples, and for each parameter the first with that parameter of
/// the second.
struct SobolIndices {
  int samples = 0, seed = 1;  ///< of each of the two
};
struct MonteCarlo {
  int samples = 0, seed = 1;                            ///< at most
  int batch = 50;                                       ///< number of samples between two looks at the interval
  std::optional<double> interval_width = std::nullopt;  ///< of the 95 % interval of P(failure), at which it stops (-)
};

using Design = std::variant<Grid, LatinHypercube, SobolSequence, SobolIndices, MonteCarlo>;

/// What is asked of each run: a number of its summary.
struct Question {
  std::string name;
  std::string key;           ///< dotted, in summary.json
  std::optional<double> at;  ///< of a factor of safety: its time (s); none: that at which it is least
  std::string unit = "-";
};

/// What counts as failure: that of the verdict, or a result below or above a value.
struct Failure {
  std::string text;    ///< as it was given
  std::string result;  ///< name of a question; empty: the verdict
  bool below = true;
  double value = 0.0;  ///< in the unit of the question
};

/// A study: many runs of a case with parameters that are not known for sure.
struct Study {
  std::string title;
  std::string case_name;  ///< path from the folder of the study
  std::vector<Parameter> parameters;
  std::vector<Correlation> correlations;
  Design design;
  std::vector<Question> questions;
  std::optional<Failure> failure;
};

/// A study and the case that it is of.
struct StudyInput {
  Study study;
  std::filesystem::path file, case_file;
  couple::Case base;
};

/// Whether all that is asked is the factor of safety, so that nothing but this has to be found.
[[nodiscard]] bool asks_safety_alone(const Study& study);

/// "soils.clay.porosity=0.4": a value in the parameter's unit, as the runs are given it.
[[nodiscard]] std::string assignment(const Parameter& parameter, double value);

}  // namespace slope::tools
