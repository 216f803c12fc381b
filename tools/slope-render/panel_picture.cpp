#include "panel_picture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "field_image.hpp"

namespace slope::tools {
namespace {

constexpr double margin = 1.4;             // em
constexpr double line_height = 1.6;        // em
constexpr double below_panel = 1.7;        // em, for the numbers of its x axis
constexpr double bar_bottom = 1.6;         // em
constexpr double arrow_length = 0.6;       // em
constexpr double arrow_half_width = 0.19;  // em
constexpr double line_to_zone = 1.7;       // em, from a dimension line to the zone
constexpr double text_gap = 0.5;           // em, from a dimension line to its text

LineStyle dimension_style(const Canvas& canvas) {
  return {0.07 * canvas.em(), ink, {}};
}

/// A line with an arrow head at each end; it runs along x or along y.
void stroke_dimension(Canvas& canvas, Pixel from, Pixel to) {
  canvas.stroke({from, to}, dimension_style(canvas));
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  const Pixel along{(to.x - from.x) / length, (to.y - from.y) / length};
  const double head = std::min(arrow_length * canvas.em(), 0.5 * length);
  const double half = arrow_half_width * canvas.em();
  const auto draw_head = [&](Pixel tip, double sign) {
    const Pixel foot{tip.x + sign * head * along.x, tip.y + sign * head * along.y};
    canvas.fill(
        {tip, {foot.x - half * along.y, foot.y + half * along.x}, {foot.x + half * along.y, foot.y - half * along.x}},
        ink);
  };
  draw_head(from, 1.0);
  draw_head(to, -1.0);
}

std::string metres(double value) {
  return number_text(value, 0.1) + " m";
}

/// The height (m) of the topmost particles around a place.
double ground_height(vtkPolyData* particles, const couple::Domain& domain, double x) {
  double ground = domain.lower[1];
  for (vtkIdType p = 0; p < particles->GetNumberOfPoints(); ++p) {
    const double* position = particles->GetPoint(p);
    if (std::abs(position[0] - x) < domain.cell_size) {
      ground = std::max(ground, position[1]);
    }
  }
  return ground;
}

/// Above the zone, which ends at the ground, there is nothing but air.
void draw_length(Canvas& canvas, const PlotFrame& frame, const ZoneDimensions& zone) {
  const double em = canvas.em();
  const Pixel lower = frame.at(zone.lower[0], zone.lower[1]);
  const Pixel upper = frame.at(zone.upper[0], zone.upper[1]);
  const double y = std::min(upper.y + line_to_zone * em, frame.box.top - 1.5 * em);
  const LineStyle thin{0.5 * dimension_style(canvas).width, ink, {}};
  canvas.stroke({{lower.x, lower.y}, {lower.x, y + 0.4 * em}}, thin);
  canvas.stroke({{upper.x, upper.y}, {upper.x, y + 0.4 * em}}, thin);
  stroke_dimension(canvas, {lower.x, y}, {upper.x, y});
  canvas.text({0.5 * (lower.x + upper.x), y + (text_gap + 0.3) * em}, metres(zone.size.length),
              {.anchor = Anchor::centre});
}

/// On the side of the toe; the text stands in the air if there is room.
void draw_height(Canvas& canvas, const PlotFrame& frame, const StackedPanel& panel) {
  const double em = canvas.em();
  const ZoneDimensions& zone = *panel.zone;
  const std::string text = metres(zone.size.height);
  const Pixel lower = frame.at(zone.lower[0], zone.lower[1]);
  const double top = frame.at(zone.lower[0], zone.upper[1]).y;
  const double room = canvas.text_width(text) + (text_gap + 0.5) * em;
  const double x = std::max(lower.x - line_to_zone * em, frame.box.left + room);
  const LineStyle thin{0.5 * dimension_style(canvas).width, ink, {}};
  const double upper_right = frame.at(zone.upper[0], zone.upper[1]).x;
  canvas.stroke({{lower.x, lower.y}, {x - 0.4 * em, lower.y}}, thin);
  canvas.stroke({{upper_right, top}, {x - 0.4 * em, top}}, thin);
  stroke_dimension(canvas, {x, lower.y}, {x, top});
  const double at_line = frame.x.low + (x - frame.box.left) / frame.box.width() * frame.x.length();
  const double ground = frame.at(at_line, ground_height(panel.particles, panel.domain, at_line)).y + 0.3 * em;
  const double from = top - ground > 1.2 * em ? std::max(lower.y, ground) : lower.y;
  canvas.text({x - text_gap * em, 0.5 * (from + top)}, text, {.anchor = Anchor::right});
}

void draw_panel(Canvas& canvas, const Box& box, const ContourPanel& contour, const StackedPanel& panel) {
  draw_contour_panel(canvas, box, contour);
  canvas.text({box.left, box.top + 0.85 * canvas.em()}, contour.caption);
  if (panel.zone) {
    const PlotFrame frame = panel_frame(box, contour);
    draw_length(canvas, frame, *panel.zone);
    draw_height(canvas, frame, panel);
  }
}

}  // namespace

std::optional<ZoneDimensions> zone_dimensions(vtkPolyData* particles, double threshold, const ZoneSize& size) {
  auto* strain = particle_array(particles, "deviatoric_strain");
  auto* volume = particle_array(particles, "volume");
  constexpr double far = std::numeric_limits<double>::max();
  ZoneDimensions zone{{far, far}, {-far, -far}, size};
  for (vtkIdType p = 0; p < particles->GetNumberOfPoints(); ++p) {
    if (strain->GetComponent(p, 0) <= threshold) {
      continue;
    }
    const double half = 0.5 * std::sqrt(volume->GetComponent(p, 0));
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double at = particles->GetPoint(p)[axis];
      zone.lower[axis] = std::min(zone.lower[axis], at - half);
      zone.upper[axis] = std::max(zone.upper[axis], at + half);
    }
  }
  return zone.lower[0] < zone.upper[0] ? std::optional(zone) : std::nullopt;
}

void write_stacked_panels(const std::filesystem::path& file, int width, const Field& field,
                          const std::vector<StackedPanel>& panels) {
  std::vector<vtkSmartPointer<vtkPolyData>> particles;
  for (const auto& panel : panels) {
    particles.push_back(panel.particles);
  }
  const ColourScale scale = common_scale(field, particles);
  std::vector<ContourPanel> contours;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const bool lowest = i + 1 == panels.size();
    contours.push_back({panels[i].particles, field, scale, panels[i].domain, panels[i].failure_strain, "",
                        lettered(i, panels[i].caption), lowest});
  }

  const double em = font_share * width;
  const double left = std::round(panel_left_room * em);
  const double plot_width = std::floor(width - left - margin * em);
  const double bottom = std::round((5.0 + lying_bar_height) * em);
  double height = bottom + (2.0 * line_height + 0.4) * em;  // a line for the legend, one for the top panel's caption
  for (const auto& panel : panels) {
    height += std::round(plot_width * height_over_width(panel.domain));
  }
  const double between = std::round((below_panel + line_height) * em);
  height += between * static_cast<double>(panels.size() - 1);

  Canvas canvas(width, static_cast<int>(height), em);
  double top = std::round(height - (2.0 * line_height + 0.4) * em);
  draw_legend(canvas, left + plot_width, canvas.height() - 1.05 * em, legend_entries(canvas, contours));
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const double panel_height = std::round(plot_width * height_over_width(panels[i].domain));
    draw_panel(canvas, {left, top - panel_height, left + plot_width, top}, contours[i], panels[i]);
    top -= panel_height + between;
  }
  draw_titled_bar(canvas, left, left + plot_width, bar_bottom * em, field, scale);
  canvas.write_png(file);
}

}  // namespace slope::tools
