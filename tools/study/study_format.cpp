#include "study_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "case/input.hpp"
#include "case/units.hpp"

namespace slope::tools {

namespace {

using couple::Alternatives;
using couple::Dimension;
using couple::Document;
using couple::Format;
using couple::Input;
using couple::Record;

/// How values of a parameter stand in the file.
struct ValueFormats {
  Format<double> value;
  Format<double> width;  ///< above 0
};

/// Of a key whose dimension is known.
ValueFormats values_of(Dimension dimension) {
  return {couple::quantity(dimension), couple::quantity(dimension, couple::above(0.0))};
}

/// Of any key: for the schema, and to find what else is wrong where the key is.
ValueFormats any_values() {
  Format<double> any = couple::quantity(Dimension::number);
  any.read = [](const Input& input, double& value) {
    value = 1.0;
    static_cast<void>(couple::expect_value(input, "one value"));
  };
  Document types = Document::list({Document::text("number"), Document::text("string")});
  any.schema = Document::map();
  any.schema.set("type", std::move(types)).set("description", Document::text("value of the key, with its unit"));
  return {any, any};
}

Format<int> whole_number(int least, int most) {
  const auto to_whole = [](const Input& input, const double& number, int& value) {
    if (number != std::floor(number)) input.problem(fmt::format("must be a whole number, got {}", number));
    value = static_cast<int>(number);
  };
  const Format<double> number = couple::quantity(Dimension::number, couple::from_to(least, most));
  return couple::converted<double, int>(number, to_whole, [](const int& value) { return static_cast<double>(value); });
}

Format<Quantile> quantile_format(const ValueFormats& values) {
  return Record<Quantile>()
      .required("probability", &Quantile::probability, couple::quantity(Dimension::number, couple::between(0.0, 1.0)),
                "with which the value is not exceeded", "5 %")
      .required("value", &Quantile::value, values.value, "not exceeded with it", "3 kPa")
      .format();
}

constexpr const char* location_keys = "\"mean\" with \"standard_deviation\" or \"coefficient_of_variation\"";

/// Whether one way of saying where a distribution lies was taken, and one alone.
void check_location(const Input& input, const Location& location, bool has_quantiles) {
  const int widths = (location.standard_deviation ? 1 : 0) + (location.coefficient_of_variation ? 1 : 0);
  const std::string otherwise = has_quantiles ? ", or two \"quantiles\" instead" : "";
  if (!location.quantiles.empty() && (location.mean || widths > 0)) {
    input.at("quantiles").problem(fmt::format("tell what {} tell too; remove one or the other", location_keys));
  } else if (location.quantiles.empty() && (!location.mean || widths != 1)) {
    const std::string both =
        widths > 1 ? " (standard_deviation and coefficient_of_variation tell the same: keep one)" : "";
    input.problem(fmt::format("give {}{}{}", location_keys, otherwise, both));
  }
}

template <class Law>
void add_moments(Record<Law>& record, const ValueFormats& values) {
  const Format<double> ratio = couple::quantity(Dimension::number, couple::above(0.0));
  record.optional("mean", &Law::mean, couple::maybe(values.value), "of the distribution before it is cut off")
      .optional("standard_deviation", &Law::standard_deviation, couple::maybe(values.width), "likewise")
      .optional("coefficient_of_variation", &Law::coefficient_of_variation, couple::maybe(ratio),
                "likewise: standard deviation over the size of the mean");
}

template <class Law>
void add_quantiles(Record<Law>& record, const ValueFormats& values) {
  Format<std::vector<Quantile>> two = couple::list_of(quantile_format(values), 2);
  two.read = [read = two.read](const Input& input, std::vector<Quantile>& quantiles) {
    read(input, quantiles);
    if (quantiles.size() > 2) input.problem(fmt::format("needs 2 items, got {}", quantiles.size()));
  };
  two.schema.set("maxItems", Document::number(2));
  record.optional("quantiles", &Law::quantiles, two, "two of the distribution, instead of its mean and width");
}

template <class Law>
void add_limits(Record<Law>& record, const ValueFormats& values, const std::string& lower, const std::string& upper) {
  record.optional("minimum", &Law::minimum, couple::maybe(values.value), lower)
      .optional("maximum", &Law::maximum, couple::maybe(values.value), upper);
}

template <class Law>
Record<Law> located(const ValueFormats& values) {
  Record<Law> record;
  add_moments(record, values);
  add_quantiles(record, values);
  add_limits(record, values, "the distribution is cut off below", "and above");
  return record.check([](const Input& input, Law& law) { check_location(input, law, true); });
}

Record<Uniform> uniform_record(const ValueFormats& values) {
  Record<Uniform> record;
  add_limits(record, values, "lower end", "upper end");
  add_moments(record, values);
  add_quantiles(record, values);
  return record.check([](const Input& input, Uniform& law) {
    const bool located = law.mean || law.standard_deviation || law.coefficient_of_variation || !law.quantiles.empty();
    const bool limited = law.minimum || law.maximum;
    if (limited && (located || !law.minimum || !law.maximum)) {
      input.problem(R"(give both "minimum" and "maximum" and nothing else, or neither)");
    } else if (!limited) {
      check_location(input, law, true);
    }
  });
}

Record<Triangular> triangular_record(const ValueFormats& values) {
  return Record<Triangular>()
      .required("minimum", &Triangular::minimum, values.value, "lower end", "2 kPa")
      .required("mode", &Triangular::mode, values.value, "most likely value", "5 kPa")
      .required("maximum", &Triangular::maximum, values.value, "upper end", "9 kPa");
}

Record<Beta> beta_record(const ValueFormats& values) {
  Record<Beta> record;
  record.required("minimum", &Beta::minimum, values.value, "lower end", "2 kPa")
      .required("maximum", &Beta::maximum, values.value, "upper end", "9 kPa");
  add_moments(record, values);
  return record.check([](const Input& input, Beta& law) { check_location(input, law, false); });
}

Format<Parameter> parameter_of(const ValueFormats& values) {
  const auto law = [](auto& parameter) -> auto& {
    return parameter.distribution;
  };
  Record<Parameter> shared;
  shared
      .required("key", &Parameter::key, couple::text(), "dotted key of a number that the case gives, as --set takes it",
                "soils.clay.strength.cohesion")
      .optional("unit", &Parameter::unit, couple::text(),
                "in which values are told; without it that of the first value here");
  return Alternatives<Parameter>("distribution")
      .add<Normal>("normal", "Normal (Gaussian)", law, located<Normal>(values))
      .add<Lognormal>("lognormal", "The logarithm is normal", law, located<Lognormal>(values))
      .add<Uniform>("uniform", "All values between two ends alike", law, uniform_record(values))
      .add<Triangular>("triangular", "Straight up to the mode, and down from it", law, triangular_record(values))
      .add<Beta>("beta", "Between two ends, with a mean and a width", law, beta_record(values))
      .shared(shared)
      .format();
}

/// "kPa" of the first value with a unit below a place.
std::string first_unit(const Document& node, Dimension dimension) {
  if (node.kind == Document::Kind::value && node.key != "coefficient_of_variation" && node.key != "probability") {
    if (std::holds_alternative<double>(couple::parse_quantity(node.value, dimension))) {
      const std::size_t space = node.value.find_last_of(" \t");
      if (space != std::string::npos) return node.value.substr(space + 1);
    }
  }
  for (const Document& child : node.children) {
    std::string unit = first_unit(child, dimension);
    if (!unit.empty()) return unit;
  }
  return "";
}

void take_unit(const Input& input, Dimension dimension, Parameter& parameter) {
  if (parameter.unit.empty()) parameter.unit = first_unit(input.node(), dimension);
  if (parameter.unit.empty()) return;
  const auto size = couple::parse_quantity("1 " + parameter.unit, dimension);
  if (const double* one = std::get_if<double>(&size)) {
    parameter.unit_size = *one;
  } else {
    input.at("unit").problem(
        fmt::format("is no unit of a {}{}", name_of(dimension), couple::suggestion("", [dimension] {
                      const auto units = units_of(dimension);
                      return std::vector<std::string>(units.begin(), units.end());
                    }())));
  }
}

Format<Parameter> parameter_format(const CaseNumbers* numbers) {
  Format<Parameter> format = parameter_of(any_values());
  if (numbers == nullptr) return format;
  format.read = [numbers, read_any = format.read](const Input& input, Parameter& parameter) {
    std::string key;
    if (input.has("key") && input.at("key").node().kind == Document::Kind::value) key = input.at("key").node().value;
    const auto found = numbers->find(key);
    const auto* number = std::get_if<CaseNumber>(&found);
    if (number == nullptr) {
      if (!key.empty()) input.at("key").problem(std::get<std::string>(found));
      return read_any(input, parameter);
    }
    const std::size_t before = input.problem_count();
    parameter_of(values_of(number->dimension)).read(input, parameter);
    parameter.key = number->key;
    if (input.problem_count() == before) take_unit(input, number->dimension, parameter);
  };
  format.write = [numbers](const Parameter& parameter) {
    const CaseNumber number = std::get<CaseNumber>(numbers->find(parameter.key));
    return parameter_of(values_of(number.dimension)).write(parameter);
  };
  return format;
}

Format<Correlation> correlation_format() {
  const Format<double> coefficient = couple::quantity(Dimension::number, couple::between(-1.0, 1.0));
  return Record<Correlation>()
      .required("between", &Correlation::between, couple::list_of(couple::name_text(), 2), "names of two parameters",
                "[cohesion, friction]")
      .optional("rank", &Correlation::rank, couple::maybe(coefficient), "Spearman's coefficient, of the ranks")
      .optional("pearson", &Correlation::pearson, couple::maybe(coefficient),
                "Pearson's coefficient, of the values, instead")
      .check([](const Input& input, Correlation& correlation) {
        if (correlation.between.size() != 2)
          input.at("between").problem(fmt::format("needs 2 items, got {}", correlation.between.size()));
        if (correlation.rank.has_value() == correlation.pearson.has_value())
          input.problem(R"(give one of "rank" and "pearson": the coefficient, and what it is of)");
      })
      .format();
}

constexpr int most_samples = 100'000, largest_seed = 2'000'000'000;

/// The keys of a design that draws at random.
template <class A>
Record<A> drawn(const std::string& meaning) {
  Record<A> record;
  record.required("samples", &A::samples, whole_number(2, most_samples), meaning, "100")
      .optional("seed", &A::seed, whole_number(0, largest_seed), "of the random numbers: the same, the same samples");
  return record;
}

Format<Design> design_format() {
  const auto whole = [](auto& design) -> auto& {
    return design;
  };
  Record<Grid> grid;
  grid.required("levels", &Grid::levels, whole_number(2, 1000), "number of values of each parameter", "5");
  Record<MonteCarlo> monte_carlo = drawn<MonteCarlo>("number of them, at most");
  monte_carlo
      .optional("batch", &MonteCarlo::batch, whole_number(1, most_samples),
                "number of samples between two looks at the interval")
      .optional("interval_width", &MonteCarlo::interval_width,
                couple::maybe(couple::quantity(Dimension::number, couple::between(0.0, 1.0))),
                "of the 95 % interval of the probability of failure, from which on no more samples are taken");
  return Alternatives<Design>("type")
      .add<Grid>("grid", "Every combination of some values of each parameter, without correlations", whole, grid)
      .add<LatinHypercube>("latin_hypercube", "One sample in each of as many equal shares of each parameter", whole,
                           drawn<LatinHypercube>("number of them"))
      .add<SobolSequence>("sobol_sequence", "Sobol's sequence, shifted at random", whole,
                          drawn<SobolSequence>("number of them, best a power of 2"))
      .add<SobolIndices>("sobol_indices", "Saltelli's design for Sobol's indices of each parameter", whole,
                         drawn<SobolIndices>("number n of them: n times the number of parameters plus 2 runs"))
      .add<MonteCarlo>("monte_carlo", "Independent random samples", whole, monte_carlo)
      .format();
}

Format<Question> question_format() {
  return Record<Question>()
      .required("key", &Question::key, couple::text(), "dotted key of a number of summary.json",
                "factor_of_safety.factor")
      .optional("at", &Question::at, couple::maybe(couple::quantity(Dimension::time, couple::at_least(0.0))),
                "of a factor of safety: when; without it when it is least")
      .check([](const Input& input, Question& question) {
        const SummaryNumber number = summary_number(question.key);
        if (!number.problem.empty()) input.at("key").problem(number.problem);
        question.unit = number.unit;
        if (question.at && couple::words_of(question.key).front() != safety_key)
          input.at("at").problem(
              fmt::format("has a meaning only for a factor of safety, a key that begins with {}; "
                          "remove it",
                          safety_key));
      })
      .format();
}

/// As it was given; check_study() takes it apart, since that needs the results.
Format<std::optional<Failure>> failure_format() {
  return couple::maybe(couple::part<Failure>(&Failure::text, couple::text()));
}

}  // namespace

Format<Study> study_format(const CaseNumbers* numbers) {
  return Record<Study>()
      .required("title", &Study::title, couple::text(), "what the study is about", "How sure is the cut")
      .required(case_key, &Study::case_name, couple::text(), "case file, its path from the folder of this file",
                "cut.yaml")
      .required("parameters", &Study::parameters, couple::named(parameter_format(numbers), 1),
                "what is uncertain, each by a name",
                "{cohesion: {key: soils.clay.strength.cohesion, distribution: lognormal, mean: 5 kPa, "
                "coefficient_of_variation: 30 %}}")
      .optional("correlations", &Study::correlations, couple::list_of(correlation_format()),
                "how parameters go together (Gaussian copula); without them they are independent")
      .required("design", &Study::design, design_format(), "which samples are run",
                "{type: latin_hypercube, samples: 100}")
      .optional("results", &Study::questions, couple::named(question_format()), "what is asked of each run, by names")
      .optional("failure", &Study::failure, failure_format(),
                "what counts as failure: \"verdict\" (fails, or does not stand before the start), or a result below or "
                "above a value, such as \"factor < 1\" or \"run_out > 5 m\"")
      .format();
}

}  // namespace slope::tools
