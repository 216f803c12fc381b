#include "run_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "drawable_particles.hpp"
#include "slope/couple/water_amounts.hpp"

namespace slope::tools {

std::vector<Curve> history_curves(const CsvTable& history, const std::string& quantity) {
  std::vector<Curve> curves;
  for (std::size_t c = 0; c < history.names.size(); ++c) {
    const std::string name = history.names[c].substr(0, history.names[c].find(" ["));
    const std::string ending = " " + quantity;
    if (name.ends_with(ending)) {
      curves.push_back({name.substr(0, name.size() - ending.size()), history.columns[c]});
    }
  }
  return curves;
}

namespace {

namespace amounts = couple::water_amounts;

/// One above the other in the legend.
constexpr std::array drawn_amounts{amounts::rain,        amounts::infiltration, amounts::run_off, amounts::seepage,
                                   amounts::evaporation, amounts::outflow,      amounts::storage};

std::string column_name(const couple::WaterAmount& amount) {
  return fmt::format("{} [{}]", amount.name, amount.unit);
}

}  // namespace

bool has_amounts(const CsvTable& budget) {
  return std::ranges::any_of(amounts::all, [&budget](const couple::WaterAmount& amount) {
    return std::ranges::find(budget.names, column_name(amount)) != budget.names.end();
  });
}

std::vector<Curve> budget_curves(const CsvTable& budget) {
  std::vector<Curve> curves;
  for (const couple::WaterAmount& amount : drawn_amounts) {
    const auto column = std::ranges::find(budget.names, column_name(amount));
    if (column == budget.names.end()) continue;
    const auto& values = budget.columns[static_cast<std::size_t>(column - budget.names.begin())];
    const bool drawn = std::ranges::any_of(curves, [&](const Curve& curve) { return curve.values == values; });
    const bool flows = std::ranges::any_of(values, [](double value) { return value != 0.0; });
    if (flows && (!drawn || amount.value == amounts::storage.value))
      curves.push_back({std::string(amount.name), values});
  }
  return curves;
}

std::optional<TimeMark> other_onset(const RunFolder& run) {
  const bool runaway = run.input.onset == couple::Onset::runaway;
  if (!run.summary) return std::nullopt;
  const auto& time = runaway ? run.summary->found.displacement_onset : run.summary->found.runaway_onset;
  if (!time) return std::nullopt;
  return TimeMark{*time, runaway ? fmt::format("{:g} cm", 100.0 * run.input.onset_displacement) : "runs away"};
}

void scale_curves(std::vector<Curve>& curves, double factor) {
  for (auto& curve : curves) {
    for (double& value : curve.values) {
      value *= factor;
    }
  }
}

std::pair<double, std::string> length_unit(const std::vector<Curve>& curves) {
  double largest = 0.0;
  for (const auto& curve : curves) {
    for (const double value : curve.values) {
      largest = std::max(largest, std::abs(value));
    }
  }
  if (largest >= 0.5) {
    return {1.0, "m"};
  }
  return largest >= 0.02 ? std::pair{100.0, std::string("cm")} : std::pair{1000.0, std::string("mm")};
}

std::vector<TimedProfile> timed_profiles(const RunFolder& run, Losses& losses) {
  const auto& figures = run.input.figures;
  std::vector<TimedProfile> profiles;
  for (const double time : figures.profile_times) {
    const Snapshot& snapshot = nearest_snapshot(run.snapshots, time);
    TimedProfile profile{time, snapshot.time, {}, {}};
    profile.computed = suction_profile(read_drawable_particles(snapshot.file, losses), run.input.water.unit_weight());
    if (!figures.profile_reference.empty()) {
      profile.reference = reference_profile(run.path / figures.profile_reference, time);
    }
    profiles.push_back(std::move(profile));
  }
  return profiles;
}

}  // namespace slope::tools
