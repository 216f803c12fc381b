#include "mesh_picture.hpp"

#include <algorithm>
#include <cmath>

#include "canvas.hpp"
#include "contour_panel.hpp"
#include "plot_frame.hpp"

namespace slope::tools {
namespace {

constexpr double margin = 1.4;  // em
constexpr Colour mesh_colour{200, 200, 200};
constexpr Colour point_colour{0xd5, 0x5e, 0x00};

void draw_grid(Canvas& canvas, const PlotFrame& frame, const couple::Domain& domain) {
  const LineStyle line{std::max(1.0, 0.03 * canvas.em()), mesh_colour, {}};
  const auto lines = [&](std::size_t axis) {
    return static_cast<int>(std::lround((domain.upper[axis] - domain.lower[axis]) / domain.cell_size));
  };
  for (int i = 0; i <= lines(0); ++i) {
    const double x = frame.at(domain.lower[0] + i * domain.cell_size, frame.y.low).x;
    canvas.stroke({{x, frame.box.bottom}, {x, frame.box.top}}, line);
  }
  for (int j = 0; j <= lines(1); ++j) {
    const double y = frame.at(frame.x.low, domain.lower[1] + j * domain.cell_size).y;
    canvas.stroke({{frame.box.left, y}, {frame.box.right, y}}, line);
  }
}

void draw_outline(Canvas& canvas, const PlotFrame& frame, const couple::Region& region) {
  std::vector<Pixel> corners;
  for (const auto& corner : region.polygon) {
    corners.push_back(frame.at(corner[0], corner[1]));
  }
  corners.insert(corners.end(), {corners[0], corners[1]});  // past the first corner, to close it with a round joint
  canvas.stroke(corners, {0.14 * canvas.em(), ink, {}});
}

bool inside(const std::vector<couple::Point>& polygon, const couple::Point& where) {
  bool result = false;
  for (std::size_t i = 0, before = polygon.size() - 1; i < polygon.size(); before = i++) {
    const couple::Point& a = polygon[before];
    const couple::Point& b = polygon[i];
    if ((a[1] > where[1]) != (b[1] > where[1]) && where[0] < a[0] + (where[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0])) {
      result = !result;
    }
  }
  return result;
}

/// Points near the surface have their label in the air above, the others to the right, on a white patch so that no line
/// of the grid runs through it.
void draw_point(Canvas& canvas, const PlotFrame& frame, const couple::Case& input,
                const couple::VerificationPoint& point) {
  constexpr double label_scale = 0.8;
  const double em = canvas.em();
  const Pixel centre = frame.at(point.position[0], point.position[1]);
  const double width = label_scale * canvas.text_width(point.name);
  const double metres_per_em = em * frame.y.length() / frame.box.height();
  const couple::Point above{point.position[0], point.position[1] + 0.7 * metres_per_em};
  const bool buried =
      std::ranges::any_of(input.regions, [&above](const auto& region) { return inside(region.polygon, above); });
  const Pixel label =
      buried ? Pixel{centre.x + 0.5 * em + 0.5 * width, centre.y} : Pixel{centre.x, centre.y + 0.95 * em};
  const double half = 0.5 * width + 0.08 * em;
  canvas.fill(Box{label.x - half, label.y - 0.36 * em, label.x + half, label.y + 0.36 * em}, white);
  canvas.text(label, point.name, {.anchor = Anchor::centre, .scale = label_scale});
  canvas.disc(centre, 0.24 * em, point_colour);
}

}  // namespace

void write_mesh_picture(const std::filesystem::path& file, int width, const couple::Case& input) {
  const couple::Domain& domain = input.domain;
  const double em = font_share * width;
  const double left = std::round(panel_left_room * em);
  const double plot_width = std::floor(width - left - margin * em);
  const double plot_height = std::round(plot_width * height_over_width(domain));
  const double bottom = room_below(Canvas(width, 1, em)) + 0.4 * em;
  Canvas picture(width, static_cast<int>(bottom + plot_height + margin * em), em);
  const PlotFrame frame{{left, bottom, left + plot_width, bottom + plot_height},
                        {domain.lower[0], domain.upper[0]},
                        {domain.lower[1], domain.upper[1]}};
  draw_grid(picture, frame, domain);
  for (const auto& region : input.regions) {
    draw_outline(picture, frame, region);
  }
  for (const auto& point : input.points) {
    draw_point(picture, frame, input, point);
  }
  draw_axes(picture, frame, axis_for("x (m)", frame.x, plot_width, 4.5 * em),
            axis_for("y (m)", frame.y, plot_height, 2.8 * em), false);
  picture.write_png(file);
}

}  // namespace slope::tools
