#include "study_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "case/input.hpp"
#include "distributions.hpp"
#include "dotted_keys.hpp"
#include "slope/couple/results.hpp"
#include "statistics.hpp"

namespace slope::tools {

namespace {

bool is_safety(const Question& question) {
  return couple::words_of(question.key).front() == safety_key;
}

/// The strength that the slope bore, and that it did not, when its factor of safety was looked for; none: not with all
/// that was tried.
struct Bracket {
  std::optional<double> lower, upper;
};

Bracket bracket_of(const Question& question, const RunOutcome& outcome) {
  const auto end = [&](const char* name) {
    return number_in(outcome.summary, fmt::format("{}.{}", safety_key, name), question.at);
  };
  Bracket bracket{end("lower"), end("upper")};
  if (bracket.lower == 0.0) bracket.lower.reset();
  return bracket;
}

/// Of a run that broke off, no more than the factors of safety until then are known, and of these none that has no
/// bracket, as that of a slope which slides already.
std::optional<double> answer(const Question& question, const RunOutcome& outcome) {
  if (outcome.state == RunState::broke_off && !is_safety(question)) return std::nullopt;
  if (is_safety(question)) {
    const Bracket bracket = bracket_of(question, outcome);
    if (!bracket.lower || !bracket.upper) return std::nullopt;
  }
  return number_in(outcome.summary, question.key, question.at);
}

/// Whether a factor of safety without a bracket lies below a limit, where its one end tells.
std::optional<bool> lies_below(double limit, const Bracket& bracket) {
  if (bracket.upper && *bracket.upper <= limit) return true;
  if (bracket.lower && *bracket.lower >= limit) return false;
  return std::nullopt;
}

std::optional<bool> failed_by_verdict(const RunOutcome& outcome) {
  switch (outcome.verdict) {
    case couple::Verdict::fails:
    case couple::Verdict::does_not_stand:
      return true;
    case couple::Verdict::stands:
    case couple::Verdict::moves:
      return false;
    case couple::Verdict::undecided:
    case couple::Verdict::water_alone:
      break;
  }
  return std::nullopt;
}

std::optional<bool> failed(const Study& study, const RunOutcome& outcome) {
  const Failure& failure = *study.failure;
  if (failure.result.empty()) return failed_by_verdict(outcome);
  const Question& question = *std::ranges::find(study.questions, failure.result, &Question::name);
  const auto value = answer(question, outcome);
  if (value) return failure.below ? *value < failure.value : *value > failure.value;
  if (outcome.state == RunState::unfinished) return std::nullopt;
  if (question.key == factor_key) {
    const auto below = lies_below(failure.value, bracket_of(question, outcome));
    if (below) return *below == failure.below;
    // it has slid before its factor of safety could be found
    if (failure.below && failed_by_verdict(outcome).value_or(false)) return true;
  }
  if (is_safety(question)) return std::nullopt;
  // what a run that came to its end does not have did not happen
  return outcome.state == RunState::finished ? std::optional(false) : std::nullopt;
}

FoundParameter found_parameter(const Parameter& parameter, const std::vector<double>& values) {
  const double unit = parameter.unit_size;
  return {parameter.name,
          parameter.key,
          parameter.unit.empty() ? "-" : parameter.unit,
          name_of(parameter.distribution),
          mean(parameter.distribution) / unit,
          standard_deviation(parameter.distribution) / unit,
          mean_of(values).value / unit,
          standard_deviation_of(values) / unit};
}

/// No interval where the samples are no random ones.
Estimate without_interval(const Estimate& estimate) {
  return {.value = estimate.value};
}

/// Sobol's indices, if the design is made for them and every run has the result.
void add_indices(const Study& study, const Samples& samples, const std::vector<std::optional<double>>& answers,
                 FoundResult& result) {
  const auto* design = std::get_if<SobolIndices>(&study.design);
  const bool complete = std::ranges::all_of(answers, [](const auto& one) { return one.has_value(); });
  if (design == nullptr || !complete || result.smallest == result.largest) return;
  std::vector<double> values;
  for (const auto& one : answers) values.push_back(*one);
  const SobolEstimates indices = sobol_indices(samples, values, static_cast<std::size_t>(design->samples));
  for (std::size_t j = 0; j < result.influences.size(); ++j) {
    result.influences[j].first_order = indices.first_order[j];
    result.influences[j].total = indices.total[j];
  }
}

FoundResult found_result(const Study& study, const Question& question, const Samples& samples,
                         const std::vector<RunOutcome>& outcomes) {
  std::vector<std::optional<double>> answers;
  for (const RunOutcome& outcome : outcomes) answers.push_back(answer(question, outcome));
  const std::size_t independent = independent_samples(study, samples.size());
  Samples sampled;
  std::vector<double> values;
  for (std::size_t i = 0; i < independent; ++i) {
    if (!answers[i]) continue;
    values.push_back(*answers[i]);
    sampled.push_back(samples[i]);
  }
  FoundResult result{
      question.name, question.key, question.unit, values.size(), {}, std::nan(""), std::nan(""), std::nan(""), {}, {}};
  if (!values.empty()) {
    const auto [smallest, largest] = std::ranges::minmax(values);
    result.smallest = smallest, result.largest = largest;
  }
  const bool random = is_random(study.design);
  result.mean = random ? mean_of(values) : without_interval(mean_of(values));
  result.standard_deviation = standard_deviation_of(values);
  for (const double probability : {0.05, 0.25, 0.5, 0.75, 0.95}) {
    const Estimate estimate = quantile_of(values, probability);
    result.quantiles.push_back({probability, random ? estimate : without_interval(estimate)});
  }
  const std::vector<double> partial = partial_rank_correlations(sampled, values);
  for (std::size_t j = 0; j < study.parameters.size() && !sampled.empty(); ++j) {
    const double correlation = rank_correlation(column_of(sampled, j), values);
    result.influences.push_back({study.parameters[j].name, correlation, partial[j], std::nullopt, std::nullopt});
  }
  add_indices(study, samples, answers, result);
  return result;
}

std::string interval_text(const Design& design) {
  if (std::holds_alternative<MonteCarlo>(design)) return "Clopper-Pearson";
  if (std::holds_alternative<Grid>(design)) return "none: a grid is no random sample";
  if (std::holds_alternative<SobolIndices>(design)) return "Clopper-Pearson, of the two random samples";
  return "Clopper-Pearson, as for independent samples";
}

std::string estimate_text(const Estimate& estimate) {
  std::string value = fmt::format("{:.4g}", estimate.value);
  if (std::isnan(estimate.lower) && std::isnan(estimate.upper)) return value;
  const auto end = [](double one) { return std::isnan(one) ? std::string("?") : fmt::format("{:.4g}", one); };
  return fmt::format("{} ({} to {})", value, end(estimate.lower), end(estimate.upper));
}

std::string coefficient_text(double coefficient) {
  return std::isnan(coefficient) ? "?" : fmt::format("{:.2f}", coefficient);
}

std::string influence_text(const std::vector<Influence>& influences) {
  std::vector<Influence> sorted = influences;
  std::ranges::stable_sort(sorted, std::greater{}, [](const Influence& one) {
    return std::isnan(one.rank_correlation) ? -1.0 : std::abs(one.rank_correlation);
  });
  std::string text;
  for (const Influence& one : sorted) {
    text += fmt::format("{}{} {} (partial {})", text.empty() ? "" : ", ", one.parameter,
                        coefficient_text(one.rank_correlation), coefficient_text(one.partial_rank_correlation));
    if (one.total)
      text += fmt::format(" with Sobol' indices {:.2f} and {:.2f}", one.first_order->value, one.total->value);
  }
  return text;
}

}  // namespace

StudyRow study_row(const Study& study, const std::vector<double>& sample, const RunOutcome& outcome) {
  StudyRow row;
  for (std::size_t j = 0; j < sample.size(); ++j) row.parameters.push_back(sample[j] / study.parameters[j].unit_size);
  for (const Question& question : study.questions) row.results.push_back(answer(question, outcome));
  row.verdict = text_of(outcome.verdict);
  if (study.failure) row.failed = failed(study, outcome);
  row.state = outcome.state == RunState::finished ? "finished" : "broke off";
  return row;
}

std::optional<FoundFailure> found_failure(const Study& study, const std::vector<RunOutcome>& outcomes) {
  if (!study.failure) return std::nullopt;
  FoundFailure found;
  found.criterion = study.failure->text;
  found.result = study.failure->result;
  if (!found.result.empty()) found.limit = study.failure->value;
  found.interval = interval_text(study.design);
  const std::size_t independent = independent_samples(study, outcomes.size());
  for (std::size_t i = 0; i < independent; ++i) {
    const auto one = failed(study, outcomes[i]);
    found.runs += one ? 1 : 0;
    found.failed += one.value_or(false) ? 1 : 0;
  }
  if (found.runs == 0) return found;
  found.probability = probability_of(found.failed, found.runs);
  if (!is_random(study.design)) found.probability = without_interval(found.probability);
  return found;
}

StudyResults study_results(const Study& study, const Samples& samples, const std::vector<RunOutcome>& outcomes) {
  StudyResults results;
  results.version = SLOPE_VERSION;
  results.title = study.title;
  results.case_file = study.case_name;
  results.design = name_of(study.design);
  results.seed = static_cast<std::size_t>(seed_of(study.design));
  results.runs = outcomes.size();
  results.broken = static_cast<std::size_t>(std::ranges::count(outcomes, RunState::broke_off, &RunOutcome::state));
  for (std::size_t j = 0; j < study.parameters.size(); ++j) {
    results.parameters.push_back(found_parameter(study.parameters[j], column_of(samples, j)));
  }
  results.failure = found_failure(study, outcomes);
  for (const Question& question : study.questions) {
    results.results.push_back(found_result(study, question, samples, outcomes));
  }
  return results;
}

std::string study_report(const StudyResults& results) {
  std::string text = results.title + '\n';
  const auto line = [&text](std::string_view name, const std::string& content) {
    text += fmt::format("  {:<15}  {}\n", name, content);
  };
  const bool seeded = results.design != name_of(Grid{});
  line("runs", fmt::format("{} of the design {}{}{}", results.runs, results.design,
                           seeded ? fmt::format(", seed {}", results.seed) : "",
                           results.broken > 0 ? fmt::format("; {} broke off", results.broken) : ""));
  if (const auto& failure = results.failure) {
    line("failure",
         fmt::format("{}: {} of {} runs in which it is known; probability {}, interval of 95 %: {}", failure->criterion,
                     failure->failed, failure->runs, estimate_text(failure->probability), failure->interval));
  }
  for (const FoundResult& result : results.results) {
    const std::string unit = result.unit == "-" ? "" : " " + result.unit;
    line(result.name, fmt::format("mean {}{}, standard deviation {:.3g}{}, in {} runs", estimate_text(result.mean),
                                  unit, result.standard_deviation, unit, result.runs));
    std::string quantiles;
    for (const FoundQuantile& one : result.quantiles) {
      quantiles += fmt::format("{}{:g} % {}{}", quantiles.empty() ? "" : ", ", 100.0 * one.probability,
                               estimate_text(one.estimate), unit);
    }
    line("- quantiles", quantiles);
    line("- explained by", "rank correlations " + influence_text(result.influences));
  }
  return text;
}

}  // namespace slope::tools
