#include "table_difference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "slope/testing/curve.hpp"

namespace slope::testing {
namespace {

/// The value nearest to the reference that a curve takes between two places; beyond its ends it stays what it is there.
double nearest_value(const Curve& curve, double from, double to, double reference) {
  from = std::clamp(from, curve.x.front(), curve.x.back());
  to = std::clamp(to, curve.x.front(), curve.x.back());
  double lowest = interpolate(curve, from);
  double highest = lowest;
  const auto include = [&](double value) {
    // Written so that a NaN stays.
    lowest = value >= lowest ? lowest : value;
    highest = value <= highest ? highest : value;
  };
  include(interpolate(curve, to));
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    if (curve.x[i] > from && curve.x[i] < to) include(curve.y[i]);
  }
  return std::isnan(lowest) || std::isnan(highest) ? std::numeric_limits<double>::quiet_NaN()
                                                   : std::clamp(reference, lowest, highest);
}

Deviation deviation(const ColumnTolerance& asked, double along, double value, double reference) {
  // Where nothing is allowed and nothing differs, the share is 0.
  const double share = value == reference ? 0.0 : std::abs(value - reference) / asked.tolerance.at(reference);
  return {asked.column, along, value, reference, share};
}

/// Whether it is worse; NaN is worst.
bool worse(const Deviation& a, const Deviation& b) {
  return std::isnan(a.share) ? !std::isnan(b.share) : a.share > b.share;
}

/// Of a column, from the place and the value to compare at each row of the reference.
template <class Place, class Value>
Deviation worst(const ColumnTolerance& asked, const std::vector<double>& reference, Place place, Value value) {
  Deviation result{asked.column};
  for (std::size_t row = 0; row < reference.size(); ++row) {
    const Deviation here = deviation(asked, place(row), value(row), reference[row]);
    if (row == 0 || worse(here, result)) result = here;
  }
  return result;
}

std::vector<Deviation> deviations_along(const Table& actual, const Table& reference, const ColumnTolerance& along,
                                        const std::vector<ColumnTolerance>& columns) {
  const auto& x = actual.column(along.column);
  const auto& x_reference = reference.column(along.column);
  const Deviation start = deviation(along, x_reference.front(), x.front(), x_reference.front());
  const Deviation end = deviation(along, x_reference.back(), x.back(), x_reference.back());
  std::vector<Deviation> result{worse(end, start) ? end : start};
  for (const auto& asked : columns) {
    const Curve curve{x, actual.column(asked.column)};
    const auto& values = reference.column(asked.column);
    result.push_back(worst(
        asked, values, [&](std::size_t row) { return x_reference[row]; },
        [&](std::size_t row) {
          const double shift = along.tolerance.at(x_reference[row]);
          return nearest_value(curve, x_reference[row] - shift, x_reference[row] + shift, values[row]);
        }));
  }
  return result;
}

}  // namespace

std::vector<Deviation> deviations(const Table& actual, const Table& reference, const TableTolerances& tolerances) {
  if (actual.rows() == 0 || reference.rows() == 0) throw std::runtime_error("a table without rows");
  if (tolerances.along) return deviations_along(actual, reference, *tolerances.along, tolerances.columns);

  if (actual.rows() != reference.rows()) {
    throw std::runtime_error(fmt::format("{} rows instead of {}", actual.rows(), reference.rows()));
  }
  std::vector<Deviation> result;
  for (const auto& asked : tolerances.columns) {
    const auto& values = actual.column(asked.column);
    result.push_back(worst(
        asked, reference.column(asked.column), [](std::size_t row) { return static_cast<double>(row); },
        [&](std::size_t row) { return values[row]; }));
  }
  return result;
}

std::string complaints(const std::vector<Deviation>& deviations) {
  std::string text;
  for (const auto& d : deviations) {
    if (d.share <= 1.0) continue;
    text += fmt::format("  {}: {:.6g} instead of {:.6g} at {:.6g}, {:.3g} times what is allowed\n", d.column, d.value,
                        d.reference, d.along, d.share);
  }
  return text;
}

}  // namespace slope::testing
