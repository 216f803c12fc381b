#include "study_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "case/input.hpp"
#include "results/result_format.hpp"
#include "slope/couple/csv_rows.hpp"
#include "slope/couple/read_case.hpp"
#include "slope/couple/text_file.hpp"

namespace slope::tools {

namespace {

using couple::Document;
using couple::ResultFormat;
using couple::ResultRecord;

constexpr const char* program = "slope-sim study";
constexpr std::size_t most_bytes = std::size_t{1} << 30U;

/// A number in the unit that stands beside it, or without one.
ResultFormat<double> number() {
  return couple::measured("");
}

ResultFormat<Estimate> estimate_format() {
  return ResultRecord<Estimate>()
      .key("value", &Estimate::value, number(), "the estimate")
      .key("lower_95", &Estimate::lower, number(), "lower end of its 95 % interval; null: there is none")
      .key("upper_95", &Estimate::upper, number(), "upper end of its 95 % interval; null: there is none")
      .format();
}

ResultFormat<FoundParameter> parameter_format() {
  return ResultRecord<FoundParameter>()
      .key("name", &FoundParameter::name, couple::words(), "of the parameter")
      .key("key", &FoundParameter::key, couple::words(), "in the case")
      .key("unit", &FoundParameter::unit, couple::words(), "of its values; -: none")
      .key("distribution", &FoundParameter::distribution, couple::words(), "its kind")
      .key("mean", &FoundParameter::mean, number(), "of the distribution, in the unit")
      .key("standard_deviation", &FoundParameter::standard_deviation, number(), "of the distribution, in the unit")
      .key("sample_mean", &FoundParameter::sample_mean, number(), "of the samples, in the unit")
      .key("sample_standard_deviation", &FoundParameter::sample_standard_deviation, number(),
           "of the samples, in the unit")
      .format();
}

ResultFormat<Influence> influence_format() {
  return ResultRecord<Influence>()
      .key("parameter", &Influence::parameter, couple::words(), "its name")
      .key("rank_correlation", &Influence::rank_correlation, number(),
           "Spearman's, of parameter and result, -1 to 1; null: one of them does not vary")
      .key("partial_rank_correlation", &Influence::partial_rank_correlation, number(),
           "the same without what the other parameters explain of both; null: something does not vary, or too few runs")
      .key("first_order_index", &Influence::first_order, maybe(estimate_format()),
           "Sobol's: share of the result's variance that the parameter explains alone; null: not of this design")
      .key("total_index", &Influence::total, maybe(estimate_format()),
           "Sobol's: share that it explains with the others; null: not of this design")
      .format();
}

ResultFormat<FoundQuantile> quantile_format() {
  return ResultRecord<FoundQuantile>()
      .key("probability", &FoundQuantile::probability, number(), "with which the value is not exceeded")
      .key("estimate", &FoundQuantile::estimate, estimate_format(), "in the unit of the result")
      .format();
}

ResultFormat<FoundResult> result_format() {
  return ResultRecord<FoundResult>()
      .key("name", &FoundResult::name, couple::words(), "of the result")
      .key("key", &FoundResult::key, couple::words(), "in summary.json")
      .key("unit", &FoundResult::unit, couple::words(), "of its values; -: none")
      .key("runs", &FoundResult::runs, couple::count(), "number of those that have it, and on which the rest is based")
      .key("mean", &FoundResult::mean, estimate_format(), "in the unit; interval by Student's t")
      .key("standard_deviation", &FoundResult::standard_deviation, number(), "in the unit")
      .key("smallest", &FoundResult::smallest, number(), "in the unit")
      .key("largest", &FoundResult::largest, number(), "in the unit")
      .key("quantiles", &FoundResult::quantiles, list_of(quantile_format()), "intervals by ranks")
      .key("influences", &FoundResult::influences, list_of(influence_format()), "of the parameters, in their order")
      .format();
}

ResultFormat<FoundFailure> failure_format() {
  return ResultRecord<FoundFailure>()
      .key("criterion", &FoundFailure::criterion, couple::words(), "what counts as failure")
      .key("result", &FoundFailure::result, couple::words(), "name of the result that it is of; empty: the verdict")
      .key("limit", &FoundFailure::limit, number(), "of that result, in its unit; null: the verdict has none")
      .key("runs", &FoundFailure::runs, couple::count(), "number of those in which it is known")
      .key("failed", &FoundFailure::failed, couple::count(), "number of those that failed")
      .key("probability", &FoundFailure::probability, estimate_format(), "of failure: failed over runs")
      .key("interval", &FoundFailure::interval, couple::words(), "how its interval was found")
      .format();
}

ResultFormat<StudyResults> study_results_format() {
  return ResultRecord<StudyResults>()
      .constant("program", program, "that wrote this")
      .key("version", &StudyResults::version, couple::words(), "of the program")
      .key("title", &StudyResults::title, couple::words(), "of the study")
      .key("case", &StudyResults::case_file, couple::words(), "as the study names it")
      .key("design", &StudyResults::design, couple::words(), "which samples were run")
      .key("seed", &StudyResults::seed, couple::count(), "of the random numbers")
      .key("runs", &StudyResults::runs, couple::count(), "number of them")
      .key("broken", &StudyResults::broken, couple::count(), "number of those whose physics broke")
      .key("parameters", &StudyResults::parameters, list_of(parameter_format()), "what is uncertain")
      .key("failure", &StudyResults::failure, maybe(failure_format()), "null: the study does not say what it is")
      .key("results", &StudyResults::results, list_of(result_format()), "what was asked of the runs")
      .format();
}

std::string with_unit(const std::string& name, const std::string& unit) {
  return fmt::format("{} [{}]", name, unit);
}

}  // namespace

std::string study_json(const StudyResults& results) {
  return couple::json_text(study_results_format().write(results));
}

StudyResults read_study_results(const std::filesystem::path& file) {
  std::vector<couple::Problem> problems, not_understood;
  const Document document = couple::parse_yaml(couple::read_text_file(file, most_bytes), file.string(), problems,
                                               {"study's results", "JSON"});
  const Document* writer = document.find("program");
  if (problems.empty() && (writer == nullptr || writer->value != program))
    problems.push_back({file.string(), 0, "program", fmt::format("expected \"{}\"", program)});
  StudyResults results;
  if (problems.empty())
    study_results_format().read(couple::Input(document, file.string(), problems, &not_understood), results);
  if (!problems.empty()) throw couple::FileError(couple::InputError(problems).what());
  return results;
}

std::string study_results_schema() {
  Document schema = Document::map();
  schema.set("$schema", Document::text("https://json-schema.org/draft/2020-12/schema"))
      .set("title", Document::text("slope study results"))
      .set("description", Document::text("What a study of slope-sim found: study.json. null: is no number."));
  for (const Document& keyword : study_results_format().schema.children) schema.set(keyword.key, keyword);
  return couple::json_text(schema);
}

std::string study_csv(const StudyResults& study, const std::vector<StudyRow>& rows) {
  std::string text = "sample";
  for (const FoundParameter& parameter : study.parameters) text += ',' + with_unit(parameter.name, parameter.unit);
  for (const FoundResult& result : study.results) text += ',' + with_unit(result.name, result.unit);
  text += ",verdict,failure,state,seed,folder\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const StudyRow& row = rows[i];
    text += std::to_string(i + 1);
    for (const double value : row.parameters) text += fmt::format(",{:.6g}", value);
    for (const std::optional<double>& value : row.results) text += value ? fmt::format(",{}", *value) : ",";
    const char* failed = !row.failed ? "" : *row.failed ? "yes" : "no";
    text += fmt::format(",{},{},{},{},{}\n", row.verdict, failed, row.state, study.seed, row.folder);
  }
  return text;
}

std::vector<double> study_column(const std::filesystem::path& file, const std::string& name) {
  couple::CsvRows rows(couple::read_text_file(file, most_bytes));
  const auto refuse = [&file](int line, const std::string& what) {
    throw couple::FileError(fmt::format("{}:{}: {}", file.string(), line, what));
  };
  if (!rows.next()) refuse(1, "has no header");
  const std::size_t columns = rows.cells().size();
  const auto found =
      std::ranges::find_if(rows.cells(), [&name](const std::string& cell) { return cell.starts_with(name + " ["); });
  if (found == rows.cells().end()) refuse(rows.line(), fmt::format("has no column \"{}\"", name));
  const auto column = static_cast<std::size_t>(found - rows.cells().begin());
  std::vector<double> values;
  while (rows.next()) {
    if (rows.cells().size() != columns)
      refuse(rows.line(), fmt::format("has {} columns where the header has {}", rows.cells().size(), columns));
    const std::string& cell = rows.cells()[column];
    double value = std::nan("");
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (!cell.empty() && (error != std::errc() || end != cell.data() + cell.size()))
      refuse(rows.line(), fmt::format("\"{}\" is not a number", couple::shortened(cell)));
    values.push_back(value);
  }
  return values;
}

}  // namespace slope::tools
