#include "read_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include "case/input.hpp"
#include "case/units.hpp"
#include "design.hpp"
#include "distributions.hpp"
#include "slope/couple/text_file.hpp"
#include "study_format.hpp"

namespace slope::tools {

namespace {

namespace fs = std::filesystem;
using couple::Document;
using couple::Input;
using couple::Problem;

constexpr std::size_t most_bytes = 1'000'000;  // of a study file
constexpr int most_runs = 1'000'000;
constexpr double hardly_ever = 1.0e-6;  // probability with which a value may be out of its range

/// Names of columns of study.csv.
const std::set<std::string> taken_names{"sample", "verdict", "failure", "state", "seed", "folder"};

void check_names(const Input& root, const Study& study) {
  std::set<std::string> names = taken_names;
  const auto check = [&](const char* where, const std::string& name) {
    if (names.insert(name).second) return;
    root.at(where).at(name).problem(taken_names.contains(name) ? "is the name of a column of study.csv; choose another"
                                                               : "is the name of a parameter too; choose another");
  };
  for (const Parameter& parameter : study.parameters) check("parameters", parameter.name);
  for (const Question& question : study.questions) check("results", question.name);
}

void check_keys_once(const Input& root, const Study& study) {
  for (std::size_t i = 0; i < study.parameters.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (study.parameters[i].key != study.parameters[j].key) continue;
      root.at("parameters")
          .at(study.parameters[i].name)
          .at("key")
          .problem(fmt::format("is that of {} too; keep one", study.parameters[j].name));
    }
  }
}

/// Whether the case takes what the distribution gives, save for hardly any of it.
void check_range(const Input& place, const StudyInput& input, const Parameter& parameter) {
  for (const bool low : {true, false}) {
    const double value = quantile(parameter.distribution, low ? hardly_ever : 1.0 - hardly_ever);
    try {
      static_cast<void>(couple::read_case(input.case_file, {assignment(parameter, value)}));
    } catch (const couple::InputError& error) {
      const auto at_key = [&](const Problem& problem) { return problem.key == parameter.key; };
      const auto found = std::ranges::find_if(error.problems(), at_key);
      if (found == error.problems().end()) continue;
      place.problem(
          fmt::format("the {} distribution goes {} the values that {} can have with a probability of more than "
                      "{:g}: {}; give it a {} among them",
                      name_of(parameter.distribution), low ? "below" : "above", parameter.key, hardly_ever,
                      found->message, low ? "minimum" : "maximum"));
    }
  }
}

void check_distribution(const Input& root, const StudyInput& input, const Parameter& parameter) {
  const Input place = root.at("parameters").at(parameter.name);
  if (!root.clean(place.key())) return;
  const std::string fault = fault_of(parameter.distribution);
  if (!fault.empty()) {
    place.problem(fault);
  } else {
    check_range(place, input, parameter);
  }
}

/// Whether the pairs name parameters, each pair once.
void check_pairs(const Input& correlations, const Study& study) {
  std::vector<std::string> names;
  for (const Parameter& parameter : study.parameters) names.push_back(parameter.name);
  std::set<std::set<std::string>> pairs;
  for (std::size_t i = 0; i < study.correlations.size(); ++i) {
    const Input between = correlations.item(i).at("between");
    const std::vector<std::string>& given = study.correlations[i].between;
    for (const std::string& name : given) {
      if (std::ranges::find(names, name) == names.end())
        between.problem(fmt::format("there is no parameter \"{}\"{}", name, couple::suggestion(name, names)));
    }
    const std::set<std::string> pair(given.begin(), given.end());
    if (pair.size() == 1) between.problem("names one parameter twice; name two");
    if (!pairs.insert(pair).second) between.problem("is given twice; keep one");
  }
}

void check_correlations(const Input& root, const Study& study) {
  if (study.correlations.empty() || study.parameters.empty()) return;
  const Input place = root.at("correlations");
  const bool independent =
      std::holds_alternative<Grid>(study.design) || std::holds_alternative<SobolIndices>(study.design);
  if (root.has("design") && root.clean("design") && independent) {
    place.problem(std::holds_alternative<Grid>(study.design)
                      ? "a grid has every combination of values; remove them, or choose another design"
                      : "Sobol's indices are of independent parameters; remove them, or choose another design");
  }
  check_pairs(place, study);
  const auto needs_distributions = [](const Correlation& one) { return one.pearson.has_value(); };
  const bool has_them = root.clean("parameters") || std::ranges::none_of(study.correlations, needs_distributions);
  if (!root.clean(place.key()) || !has_them) return;
  const std::string fault = fault_of(study.parameters, study.correlations);
  if (!fault.empty()) place.problem(fault);
}

void check_design(const Input& root, const Study& study) {
  const Input place = root.at("design");
  const double parameters = static_cast<double>(study.parameters.size());
  double runs = 0.0;
  if (const auto* grid = std::get_if<Grid>(&study.design)) runs = std::pow(grid->levels, parameters);
  if (const auto* indices = std::get_if<SobolIndices>(&study.design)) runs = indices->samples * (parameters + 2.0);
  if (runs > most_runs) place.problem(fmt::format("makes {:.3g} runs, at most {} are possible", runs, most_runs));
  const auto* monte_carlo = std::get_if<MonteCarlo>(&study.design);
  if (monte_carlo != nullptr && monte_carlo->interval_width && !study.failure) {
    place.at("interval_width")
        .problem(
            "is that of the probability of failure, and nothing counts as failure; add for example \"failure: "
            "verdict\"");
  }
}

couple::Dimension dimension_of_unit(const std::string& unit) {
  for (const couple::Dimension dimension :
       {couple::Dimension::length, couple::Dimension::area, couple::Dimension::time, couple::Dimension::pressure}) {
    const std::vector<std::string_view> units = units_of(dimension);
    if (std::ranges::find(units, unit) != units.end()) return dimension;
  }
  return couple::Dimension::number;
}

/// A value of a result, with the result's unit, or another of its kind.
std::optional<double> value_of(const Input& place, const std::string& text, const Question& question) {
  const couple::Dimension dimension = dimension_of_unit(question.unit);
  std::string number = text;
  const std::string own = " " + question.unit;
  if (dimension == couple::Dimension::number && question.unit != "-") {
    if (!number.ends_with(own)) {
      place.problem(
          fmt::format("{} is in {}: write for example \"{} > 1{}\"", question.name, question.unit, question.name, own));
      return std::nullopt;
    }
    number.resize(number.size() - own.size());
  }
  const auto parsed = couple::parse_quantity(number, dimension);
  if (const auto* wrong = std::get_if<std::string>(&parsed)) {
    place.problem(*wrong);
    return std::nullopt;
  }
  return std::get<double>(parsed);
}

/// Whether the runs find a factor of safety where one is asked for.
void check_safety_times(const Input& root, const StudyInput& input) {
  const couple::SafetyQuestions& asked = input.base.safety;
  const auto is_safety = [](const Question& question) { return couple::words_of(question.key).front() == safety_key; };
  const auto has_time = [](const Question& question) { return question.at.has_value(); };
  const std::vector<Question>& questions = input.study.questions;
  const auto first = std::ranges::find_if(questions, is_safety);
  if (first == questions.end() || asks_safety_alone(input.study) || std::ranges::any_of(questions, has_time)) return;
  if (!asked.times.empty() || asked.interval != couple::never) return;
  root.at("results")
      .at(first->name)
      .problem(
          "no run finds a factor of safety, for the case does not say when; add for "
          "example \"at: 0 h\"");
}

void check_failure(const Input& root, Study& study) {
  if (!study.failure || !root.clean("failure")) return;
  const Input place = root.at("failure");
  Failure& failure = *study.failure;
  if (failure.text == "verdict") return;
  const std::size_t sign = failure.text.find_first_of("<>");
  std::vector<std::string> names{"verdict"};
  for (const Question& question : study.questions) names.push_back(question.name);
  const auto trimmed = [](std::string text) {
    text.erase(0, text.find_first_not_of(' '));
    text.erase(text.find_last_not_of(' ') + 1);
    return text;
  };
  failure.result = trimmed(failure.text.substr(0, sign));
  const auto question = std::ranges::find(study.questions, failure.result, &Question::name);
  if (question == study.questions.end()) {
    place.problem(fmt::format("there is no result \"{}\"{}", couple::shortened(failure.result),
                              couple::suggestion(failure.result, names)));
    return;
  }
  if (sign == std::string::npos) {
    place.problem(fmt::format("expected a comparison, such as \"{} < 1\"", failure.result));
    return;
  }
  failure.below = failure.text[sign] == '<';
  if (!root.clean("results")) return;
  failure.value = value_of(place, trimmed(failure.text.substr(sign + 1)), *question).value_or(0.0);
}

/// Checks what concerns more than one key. Each check is left out where the keys it needs are already wrong.
void check_study(const Input& root, StudyInput& input, bool has_case) {
  Study& study = input.study;
  if (study.questions.empty() && !study.failure && root.clean("results") && root.clean("failure")) {
    root.problem_with("results",
                      "missing, and so is failure: nothing is asked of the runs; write for example \"results: {factor: "
                      "{key: factor_of_safety.factor}}\"");
  }
  check_names(root, study);
  check_failure(root, study);
  if (has_case && root.clean("results")) check_safety_times(root, input);
  if (has_case && root.has("parameters")) {
    check_keys_once(root, study);
    for (const Parameter& parameter : study.parameters) check_distribution(root, input, parameter);
    check_correlations(root, study);
  }
  if (root.has("design") && root.clean("design")) check_design(root, study);
}

/// Reads the case of the study. @return whether it is fine; what is wrong with it is added to the problems
bool read_base(const Input& root, StudyInput& input, std::vector<Problem>& problems) {
  if (!root.has(case_key) || root.at(case_key).node().kind != Document::Kind::value) return false;
  input.case_file = input.file.parent_path() / root.at(case_key).node().value;
  std::error_code error;
  if (!fs::exists(input.case_file, error)) {
    root.at(case_key).problem(
        fmt::format("there is no file {}; the path counts from the folder of this file", input.case_file.string()));
    return false;
  }
  try {
    input.base = couple::read_case(input.case_file);
    return true;
  } catch (const couple::InputError& found) {
    problems.insert(problems.end(), found.problems().begin(), found.problems().end());
    return false;
  }
}

}  // namespace

bool is_study(const fs::path& file) {
  std::vector<Problem> problems;
  try {
    const Document document = couple::parse_yaml(couple::read_text_file(file, most_bytes), "", problems);
    const auto has = [&document](const char* key) { return document.find(key) != nullptr ? 1 : 0; };
    return has(case_key) + has("parameters") + has("design") > 1;
  } catch (const couple::FileError&) {
    return false;  // who reads it as a case tells why
  }
}

StudyInput read_study(const fs::path& file) {
  std::vector<Problem> problems;
  const std::string name = file.string();
  const Document document =
      couple::parse_yaml(couple::read_text_file(file, most_bytes), name, problems, {"study", "YAML"});
  if (document.kind == Document::Kind::empty) throw couple::InputError(problems);
  StudyInput input;
  input.file = file;
  const Input root(document, name, problems);
  const bool has_case = read_base(root, input, problems);
  std::optional<CaseNumbers> numbers;
  if (has_case) numbers.emplace(input.base);
  study_format(numbers ? &*numbers : nullptr).read(root, input.study);
  if (document.kind == Document::Kind::map) check_study(root, input, has_case);
  if (!problems.empty()) {
    std::ranges::stable_sort(problems, [&](const Problem& a, const Problem& b) {
      return std::pair(a.file != name, a.line) < std::pair(b.file != name, b.line);
    });
    throw couple::InputError(problems);
  }
  return input;
}

std::string resolved_yaml(const StudyInput& input) {
  const CaseNumbers numbers(input.base);
  return couple::yaml_text(study_format(&numbers).write(input.study));
}

std::string lasting_part(const std::string& resolved) {
  std::vector<Problem> problems;
  Document study = couple::parse_yaml(resolved, "", problems, {"study", "YAML"});
  Document* design = study.find("design");
  const Document* type = design != nullptr ? design->find("type") : nullptr;
  if (type != nullptr && type->value == name_of(MonteCarlo{})) {
    std::erase_if(design->children,
                  [](const Document& entry) { return entry.key == "samples" || entry.key == "interval_width"; });
  }
  return couple::yaml_text(study);
}

std::string study_schema() {
  Document schema = Document::map();
  schema.set("$schema", Document::text("https://json-schema.org/draft/2020-12/schema"))
      .set("title", Document::text("slope study"))
      .set("description", Document::text("A study of slope-sim: many runs of a case whose parameters are uncertain."));
  for (const Document& keyword : study_format(nullptr).schema.children) schema.set(keyword.key, keyword);
  return couple::json_text(schema);
}

bool asks_safety_alone(const Study& study) {
  return !study.questions.empty() && std::ranges::all_of(study.questions, [](const Question& question) {
    return couple::words_of(question.key).front() == safety_key;
  });
}

std::string assignment(const Parameter& parameter, double value) {
  const std::string number = fmt::format("{:.6g}", value / parameter.unit_size);
  return fmt::format("{}={}{}{}", parameter.key, number, parameter.unit.empty() ? "" : " ", parameter.unit);
}

}  // namespace slope::tools
