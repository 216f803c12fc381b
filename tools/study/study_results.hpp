#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "slope/couple/document.hpp"

/// What a study has found: study.json and study.csv.
namespace slope::tools {

/// A value and its 95 % interval; NaN where there is none.
struct Estimate {
  double value = std::numeric_limits<double>::quiet_NaN();
  double lower = std::numeric_limits<double>::quiet_NaN();
  double upper = std::numeric_limits<double>::quiet_NaN();
};

struct FoundQuantile {
  double probability = 0.0;
  Estimate estimate;
};

/// What a parameter has to do with a result.
struct Influence {
  std::string parameter;
  double rank_correlation = 0.0;               ///< Spearman's; NaN: one of them does not vary
  double partial_rank_correlation = 0.0;       ///< without what the other parameters explain; NaN likewise
  std::optional<Estimate> first_order, total;  ///< Sobol's indices, of a design that is made for them
};

/// A parameter as its distribution has it, and as it was sampled; in its unit.
struct FoundParameter {
  std::string name, key, unit, distribution;
  double mean = 0.0, standard_deviation = 0.0;
  double sample_mean = 0.0, sample_standard_deviation = 0.0;
};

/// A result over the runs that have it, in its unit.
struct FoundResult {
  std::string name, key, unit;
  std::size_t runs = 0;
  Estimate mean;
  double standard_deviation = 0.0, smallest = 0.0, largest = 0.0;
  std::vector<FoundQuantile> quantiles;
  std::vector<Influence> influences;
};

struct FoundFailure {
  std::string criterion;
  std::string result;                                       ///< that it is of; empty: the verdict
  double limit = std::numeric_limits<double>::quiet_NaN();  ///< of that result, in its unit
  std::size_t runs = 0, failed = 0;                         ///< of those in which it is known
  Estimate probability;
  std::string interval;  ///< how the interval was found
};

struct StudyResults {
  std::string version, title, case_file, design;
  std::size_t seed = 0, runs = 0, broken = 0;
  std::vector<FoundParameter> parameters;
  std::optional<FoundFailure> failure;
  std::vector<FoundResult> results;
};

/// The content of study.json.
[[nodiscard]] std::string study_json(const StudyResults& results);
/// @throws couple::FileError with file, line and key if it cannot be read, or is damaged
[[nodiscard]] StudyResults read_study_results(const std::filesystem::path& file);
/// JSON Schema (draft 2020-12) of study.json.
[[nodiscard]] std::string study_results_schema();

/// A run as study.csv has it.
struct StudyRow {
  std::vector<double> parameters;              ///< in their units
  std::vector<std::optional<double>> results;  ///< in their units; none: the run does not tell
  std::string verdict;
  std::optional<bool> failed;
  std::string state;  ///< "finished" or "physics broke"
  std::string folder;
};

/// The content of study.csv.
[[nodiscard]] std::string study_csv(const StudyResults& study, const std::vector<StudyRow>& rows);
/// Columns of numbers of study.csv, by the names of parameters and results; NaN where a run does not tell.
/// @throws couple::FileError if it cannot be read, or lacks one of the columns
[[nodiscard]] std::vector<double> study_column(const std::filesystem::path& file, const std::string& name);

}  // namespace slope::tools
