#include "study_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bar_chart.hpp"
#include "distribution_chart.hpp"
#include "field_image.hpp"
#include "run_folder.hpp"
#include "study_results.hpp"

namespace slope::tools {
namespace {

namespace fs = std::filesystem;

std::string title_of(const StudyResults& study, const FoundResult& result) {
  return fmt::format("{}: {}, {} runs", study.title, result.name, result.runs);
}

/// "factor < 1: P = 15 % (3 to 38 %)"
std::string probability_text(const FoundFailure& failure) {
  const auto percent = [](double share) { return fmt::format("{:.2g}", 100.0 * share); };
  const Estimate& p = failure.probability;
  const std::string interval =
      std::isnan(p.lower) ? "" : fmt::format(", 95 % interval {} to {} %", percent(p.lower), percent(p.upper));
  return fmt::format("{}: {} % of {} runs{}", failure.criterion, percent(p.value), failure.runs, interval);
}

DistributionChart distribution_chart(const StudyResults& study, const FoundResult& result, std::vector<double> values) {
  DistributionChart chart;
  chart.title = title_of(study, result);
  chart.x_title = fmt::format("{} ({}); dots: quantiles with 95 % intervals", result.name, result.unit);
  chart.values = std::move(values);
  for (const FoundQuantile& one : result.quantiles) {
    chart.marks.push_back({one.probability, one.estimate.value, one.estimate.lower, one.estimate.upper});
  }
  if (study.failure && study.failure->result == result.name) {
    chart.limit = study.failure->limit;
    chart.limit_name = probability_text(*study.failure);
  }
  return chart;
}

/// The influences, the largest first; those that are not known last.
std::vector<Influence> sorted(std::vector<Influence> influences, auto size_of) {
  std::ranges::stable_sort(influences, std::greater{}, [&](const Influence& one) {
    const double size = std::abs(size_of(one));
    return std::isnan(size) ? -1.0 : size;
  });
  return influences;
}

BarChart tornado_chart(const StudyResults& study, const FoundResult& result) {
  BarChart chart{title_of(study, result),
                 "Rank correlation with " + result.name + " (-)",
                 {-1.0, 1.0},
                 {"all in all", "without what the other parameters explain (partial)"},
                 {}};
  for (const Influence& one : sorted(result.influences, [](const Influence& i) { return i.rank_correlation; })) {
    Bar all{}, partial{};
    all.value = one.rank_correlation;
    partial.value = one.partial_rank_correlation;
    chart.rows.push_back({one.parameter, {all, partial}});
  }
  return chart;
}

BarChart indices_chart(const StudyResults& study, const FoundResult& result) {
  BarChart chart{fmt::format("{}: {}, {} runs", study.title, result.name, study.runs),
                 "Share of the variance of " + result.name + " (-), with 95 % intervals",
                 {-0.2, 1.2},
                 {"explained alone (Sobol', first order)", "explained with the others (Sobol', total)"},
                 {}};
  const auto bar = [](const std::optional<Estimate>& estimate) {
    return estimate ? Bar{estimate->value, estimate->lower, estimate->upper} : Bar{};
  };
  const auto total = [](const Influence& one) { return one.total ? one.total->value : std::nan(""); };
  for (const Influence& one : sorted(result.influences, total)) {
    chart.rows.push_back({one.parameter, {bar(one.first_order), bar(one.total)}});
  }
  return chart;
}

/// The values of a result that can be drawn; those that cannot are noted.
std::vector<double> drawable_values(const fs::path& file, const std::string& name, Losses& losses) {
  std::vector<double> values = study_column(file, name);
  std::erase_if(values, [](double value) { return std::isnan(value); });
  const std::size_t lost = std::erase_if(values, [](double value) { return !(std::abs(value) <= largest_drawn); });
  if (lost > 0) losses.leave_out(fmt::format("{}: {}: {} values cannot be drawn", file.string(), name, lost));
  return values;
}

}  // namespace

bool holds_study(const fs::path& folder) {
  std::error_code error;
  return fs::exists(folder / "study.json", error);
}

std::vector<fs::path> write_study_pictures(const fs::path& study_folder, const fs::path& folder, int width,
                                           Losses& losses) {
  const StudyResults study = read_study_results(study_folder / "study.json");
  make_folder(folder);
  std::vector<fs::path> written;
  const auto write = [&](const std::string& name, auto draw) {
    const fs::path file = folder / (name + ".png");
    if (losses.attempt([&] { draw(file); })) written.push_back(file);
  };
  for (const FoundResult& result : study.results) {
    std::vector<double> values;
    losses.attempt([&] { values = drawable_values(study_folder / "study.csv", result.name, losses); });
    if (values.empty()) continue;
    write(result.name + "_distribution", [&](const fs::path& file) {
      write_distribution_chart(file, width, distribution_chart(study, result, values));
    });
    if (result.influences.empty()) continue;
    write(result.name + "_tornado",
          [&](const fs::path& file) { write_bar_chart(file, width, tornado_chart(study, result)); });
    if (!result.influences.front().total) continue;
    write(result.name + "_indices",
          [&](const fs::path& file) { write_bar_chart(file, width, indices_chart(study, result)); });
  }
  return written;
}

}  // namespace slope::tools
