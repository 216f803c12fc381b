#include "profile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <string_view>

#include "slope/couple/csv_rows.hpp"
#include "slope/couple/text_file.hpp"
#include "suggestion.hpp"
#include "units.hpp"

namespace slope::couple {

namespace {

constexpr std::size_t most_bytes = 100'000'000;

/// The unit of length at the end of a column's name, as in "x_m" or "x [m]"; none if there is none.
std::optional<std::string> unit_of(const std::string& column) {
  std::string_view name = column;
  const bool bracketed = name.ends_with(']');
  if (bracketed) name.remove_suffix(1);
  const std::size_t at = name.find_last_of(bracketed ? "[" : "_");
  if (at == std::string_view::npos) return std::nullopt;
  const std::string_view unit = name.substr(at + 1);
  const auto units = units_of(Dimension::length);
  if (std::find(units.begin(), units.end(), unit) == units.end()) return std::nullopt;
  return std::string(unit);
}

/// A table being read row by row.
class Table {
 public:
  Table(const Input& place, const ProfileText& profile, std::string file, std::string content)
      : place_(place), profile_(profile), file_(std::move(file)), rows_(std::move(content)) {}

  std::vector<Point> read() {
    const std::size_t before = place_.problem_count();
    std::vector<Point> points;
    bool header_read = false;
    while (rows_.next()) {
      if (rows_.is_comment()) continue;
      if (!header_read) {
        if (!read_header(rows_.cells(), rows_.line())) return {};
        header_read = true;
      } else if (!read_point(rows_.cells(), rows_.line(), points)) {
        return {};
      }
    }
    if (points.size() < 2) {
      place_.problem_in(file_, 0,
                        fmt::format("needs a line of column names and at least 2 points, has {}", points.size()));
    }
    return place_.problem_count() == before ? points : std::vector<Point>{};
  }

 private:
  bool read_header(const std::vector<std::string>& names, int line) {
    columns_ = names.size();
    const std::array wanted{&profile_.x, &profile_.y};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const std::string& name = *wanted[axis];
      const auto found = std::find(names.begin(), names.end(), name);
      const auto unit = unit_of(name);
      if (found == names.end()) {
        place_.at(axis == 0 ? "x" : "y")
            .problem(fmt::format("{}:{} has no column \"{}\"{}", file_, line, name, suggestion(name, names)));
        return false;
      }
      if (!unit) {
        place_.at(axis == 0 ? "x" : "y")
            .problem(fmt::format("the column \"{}\" of {} does not end with its unit of length; call it for example "
                                 "\"{}_m\" or \"{} [m]\"",
                                 name, file_, name, name));
        return false;
      }
      column_[axis] = static_cast<std::size_t>(found - names.begin());
      unit_[axis] = *unit;
    }
    return true;
  }

  bool read_point(const std::vector<std::string>& cells, int line, std::vector<Point>& points) {
    if (cells.size() != columns_) {
      place_.problem_in(file_, line, fmt::format("has {} columns where the first line has {}", cells.size(), columns_));
      return false;
    }
    Point point{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const std::string& cell = cells[column_[axis]];
      const auto value = parse_quantity(fmt::format("{} {}", cell, unit_[axis]), Dimension::length);
      if (!std::holds_alternative<double>(value)) {
        place_.problem_in(file_, line, fmt::format("\"{}\" is not a number", shortened(cell)));
        return false;
      }
      point[axis] = std::get<double>(value);
    }
    if (!points.empty() && point[0] < points.back()[0]) {
      place_.problem_in(file_, line,
                        fmt::format("x = {} lies left of {} in the line before; give the points from left to right",
                                    length_text(point[0]), length_text(points.back()[0])));
      return false;
    }
    points.push_back(point);
    return true;
  }

  const Input& place_;
  const ProfileText& profile_;
  std::string file_;
  CsvRows rows_;
  std::size_t columns_ = 0;
  std::array<std::size_t, 2> column_{};
  std::array<std::string, 2> unit_;
};

/// The point of a segment at a share of its length.
Point between(const Point& a, const Point& b, double share) {
  return {a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])};
}

/// The part of a line from one x to another.
std::vector<Point> part_of(const std::vector<Point>& line, double from, double to) {
  std::vector<Point> part;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Point& here = line[i];
    if (i > 0) {
      const Point& last = line[i - 1];
      for (const double end : {from, to}) {
        if (last[0] < end && end < here[0]) part.push_back(between(last, here, (end - last[0]) / (here[0] - last[0])));
      }
    }
    if (here[0] >= from && here[0] <= to) part.push_back(here);
  }
  return part;
}

}  // namespace

std::vector<Point> read_profile(const Input& place, const ProfileText& profile) {
  namespace fs = std::filesystem;
  const fs::path file = fs::path(place.file()).parent_path() / profile.file;
  std::error_code error;
  if (!fs::exists(file, error)) {
    place.at("file").problem(
        fmt::format("there is no file {}; the path counts from the folder of this file", file.string()));
    return {};
  }
  try {
    return Table(place, profile, file.string(), read_text_file(file, most_bytes)).read();
  } catch (const FileError& wrong) {
    place.at("file").problem(wrong.what());
    return {};
  }
}

std::vector<Point> region_below(const std::vector<Point>& line, double depth, double base, const Domain& domain) {
  std::vector<Point> lowered = part_of(line, domain.lower[0], domain.upper[0]);
  for (Point& point : lowered) point[1] -= depth;
  std::vector<Point> region;
  for (std::size_t i = 0; i < lowered.size(); ++i) {
    const Point& here = lowered[i];
    if (i > 0) {
      const Point& last = lowered[i - 1];
      if ((last[1] - base) * (here[1] - base) < 0.0) {
        region.push_back({between(last, here, (base - last[1]) / (here[1] - last[1]))[0], base});
      }
    }
    region.push_back({here[0], std::max(here[1], base)});
  }
  region.push_back({region.back()[0], base});
  region.push_back({region.front()[0], base});
  region.erase(std::unique(region.begin(), region.end()), region.end());
  return region;
}

}  // namespace slope::couple
