#include "profile_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <string_view>

#include "canvas.hpp"
#include "colour_maps.hpp"
#include "csv_table.hpp"
#include "field_image.hpp"
#include "particle_file.hpp"
#include "plot_frame.hpp"
#include "slope/couple/read_case.hpp"
#include "time_unit.hpp"

namespace slope::tools {
namespace {

constexpr double aspect = 0.72;
constexpr double ring_radius = 0.24;  // em
constexpr std::string_view reference_prefix = "suction_head_m_t";

/// Times run through viridis, short of its yellow end, which is too pale for lines.
Colour time_colour(std::size_t index, std::size_t count) {
  constexpr double last = 0.85;
  return colour_at(viridis(), count > 1 ? last * static_cast<double>(index) / static_cast<double>(count - 1) : 0.3);
}

Range range_of(const std::vector<TimedProfile>& profiles, std::vector<double> Profile::*values) {
  Range range{0.0, 0.0};
  for (const auto& profile : profiles) {
    for (const auto* part : {&(profile.computed.*values), &(profile.reference.*values)}) {
      for (const double value : *part) {
        range.low = std::min(range.low, value);
        range.high = std::max(range.high, value);
      }
    }
  }
  if (range.length() == 0.0) {
    range.high = 1.0;
  }
  return range;
}

std::vector<Pixel> to_pixels(const PlotFrame& frame, const Profile& profile) {
  std::vector<Pixel> points;
  for (std::size_t i = 0; i < profile.head.size(); ++i) {
    points.push_back(frame.at(profile.head[i], profile.height[i]));
  }
  return points;
}

void draw_ring(Canvas& canvas, Pixel centre, Colour colour) {
  canvas.disc(centre, ring_radius * canvas.em(), colour);
  canvas.disc(centre, 0.55 * ring_radius * canvas.em(), white);
}

/// Rings at every so many points that they do not run into each other.
void draw_rings(Canvas& canvas, const std::vector<Pixel>& points, Colour colour) {
  if (points.empty()) {
    return;
  }
  const double room = 3.4 * ring_radius * canvas.em();
  const double height = points.back().y - points.front().y;
  const auto rings = static_cast<std::size_t>(std::abs(height) / room) + 1;
  const std::size_t stride = (points.size() + rings - 1) / rings;
  for (std::size_t i = stride / 2; i < points.size(); i += stride) {
    draw_ring(canvas, points[i], colour);
  }
}

std::string legend_text(const TimedProfile& profile, const TimeUnit& unit) {
  const std::string asked = time_text(profile.time, unit), drawn = time_text(profile.snapshot_time, unit);
  return asked == drawn ? "t = " + asked : "t = " + drawn + " (asked: " + asked + ")";
}

}  // namespace

Profile suction_profile(vtkPolyData* particles, double unit_weight) {
  auto* suction = particle_array(particles, "suction");
  auto* volume = particle_array(particles, "volume");
  const vtkIdType count = particles->GetNumberOfPoints();
  double total = 0.0;
  for (vtkIdType p = 0; p < count; ++p) {
    total += volume->GetComponent(p, 0);
  }
  const double spacing = std::sqrt(total / static_cast<double>(std::max<vtkIdType>(count, 1)));
  struct Layer {
    double volume = 0.0, head = 0.0, height = 0.0;
  };
  std::map<double, Layer> layers;
  for (vtkIdType p = 0; p < count; ++p) {
    const double y = particles->GetPoint(p)[1];
    const double v = volume->GetComponent(p, 0);
    Layer& layer = layers[std::floor(y / spacing)];
    layer.volume += v;
    layer.head += v * suction->GetComponent(p, 0) / unit_weight;
    layer.height += v * y;
  }
  Profile profile;
  for (const auto& [index, layer] : layers) {
    profile.head.push_back(layer.head / layer.volume);
    profile.height.push_back(layer.height / layer.volume);
  }
  return profile;
}

Profile reference_profile(const std::filesystem::path& file, double time) {
  const CsvTable table = read_csv(file);
  Profile profile;
  bool any = false;
  for (std::size_t c = 0; c < table.names.size(); ++c) {
    const std::string& name = table.names[c];
    if (name == "z_m") {
      profile.height = table.columns[c];
    } else if (name.starts_with(reference_prefix)) {
      any = true;
      double column_time = 0.0;
      const auto [end, error] =
          std::from_chars(name.data() + reference_prefix.size(), name.data() + name.size(), column_time);
      if (error == std::errc{} && std::abs(column_time - time) < 1.0e-6 * std::max(1.0, time)) {
        profile.head = table.columns[c];
      }
    }
  }
  const auto drawn = [](double value) { return std::abs(value) <= largest_drawn; };
  if (!std::ranges::all_of(profile.height, drawn) || !std::ranges::all_of(profile.head, drawn))
    throw couple::FileError(fmt::format("{}: has values that are no numbers that can be drawn", file.string()));
  if (!any || profile.height.empty()) {
    throw couple::FileError(fmt::format("{}: needs the columns z_m and {}<time>, for example {}300", file.string(),
                                        reference_prefix, reference_prefix));
  }
  return profile.head.empty() ? Profile{} : profile;
}

void write_profile_chart(const std::filesystem::path& file, int width, const std::string& title,
                         const std::vector<TimedProfile>& profiles) {
  const double em = font_share * width;
  Canvas canvas(width, static_cast<int>(std::lround(aspect * width)), em);
  const bool referenced =
      std::any_of(profiles.begin(), profiles.end(), [](const auto& p) { return !p.reference.head.empty(); });

  const double sample = 1.6 * em;
  double longest = 0.0;
  for (const auto& profile : profiles) {
    longest = std::max(longest, profile.time);
  }
  const TimeUnit unit = time_unit(longest);
  double names = canvas.text_width(referenced ? "reference" : "computed");
  for (const auto& profile : profiles) {
    names = std::max(names, canvas.text_width(legend_text(profile, unit)));
  }
  const double bottom = room_below(canvas) + 0.4 * em;
  const double top = canvas.height() - 2.2 * em;
  const double right = width - names - sample - 3.0 * em;

  PlotFrame frame;
  const Range heights = range_of(profiles, &Profile::height);
  const Axis y{"Height y (m)", round_step(heights, (top - bottom) / (2.8 * em))};
  frame.y = widened(heights, y.step);
  const double left = room_on_the_left(canvas, frame.y, y);
  const Range heads = range_of(profiles, &Profile::head);
  const Axis x = axis_for("Suction head s/γ_{w} (m)", heads, right - left, 4.5 * em);
  frame.x = widened(heads, x.step);
  frame.box = {left, bottom, right, top};
  draw_axes(canvas, frame, x, y, true);

  const LineStyle line{0.1 * em, ink, {}};
  double row = top - 0.7 * em;
  const auto legend_row = [&](const std::string& text) {
    canvas.text({right + 1.7 * em + sample, row}, text);
    const std::pair ends{Pixel{right + 1.2 * em, row}, Pixel{right + 1.2 * em + sample, row}};
    row -= 1.5 * em;
    return ends;
  };
  for (std::size_t i = 0; i < profiles.size(); ++i) {
    const Colour colour = time_colour(i, profiles.size());
    canvas.stroke(to_pixels(frame, profiles[i].reference), {line.width, colour, {}});
    draw_rings(canvas, to_pixels(frame, profiles[i].computed), colour);
    const auto [from, to] = legend_row(legend_text(profiles[i], unit));
    canvas.fill({from.x, from.y - 0.25 * em, to.x, from.y + 0.25 * em}, colour);
  }
  row -= 0.7 * em;
  const auto [from, to] = legend_row("computed");
  draw_ring(canvas, {0.5 * (from.x + to.x), from.y}, ink);
  if (referenced) {
    const auto [begin, end] = legend_row("reference");
    canvas.stroke({begin, end}, line);
  }
  canvas.fitted_text({left, canvas.height() - 1.05 * em}, title, width - left - em);
  canvas.write_png(file);
}

}  // namespace slope::tools
