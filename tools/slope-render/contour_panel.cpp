#include "contour_panel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "field_image.hpp"

namespace slope::tools {
namespace {

constexpr const char* pressure_array = "pore_pressure";
constexpr const char* strain_array = "deviatoric_strain";
/// The water level is drawn at this pressure (Pa), 5 mm of head, instead of zero: particles that rain holds at exactly
/// zero would otherwise drag the line along the ground surface. Where soil is saturated up to the surface there is no
/// line: the water level is the surface.
constexpr double level_pressure = 50.0;

constexpr Colour pale_water{0xd6, 0xe9, 0xf5};
constexpr Colour water_surface{0x4a, 0x90, 0xc2};

constexpr double pixels_per_cell = 2.0;  // of the interpolated image
constexpr double legend_sample = 2.2;    // em
constexpr double legend_gap = 1.2;       // em

LineStyle casing(const Canvas& canvas) {
  return {0.26 * canvas.em(), black, {}};
}
LineStyle water_line(const Canvas& canvas) {
  return {0.14 * canvas.em(), white, {}};
}
LineStyle zone_line(const Canvas& canvas) {
  return {0.09 * canvas.em(), Colour{0x00, 0x72, 0xb2}, {0.45 * canvas.em(), 0.25 * canvas.em()}};
}

void stroke_water_level(Canvas& canvas, const std::vector<std::vector<Pixel>>& lines) {
  for (const LineStyle& style : {casing(canvas), water_line(canvas)}) {
    for (const auto& line : lines) {
      canvas.stroke(line, style);
    }
  }
}

/// Whether some particles have less and others more than a value: only then is there a line to draw.
bool passes(vtkPolyData* particles, const char* name, double value) {
  auto* array = particle_array(particles, name);
  bool below = false;
  bool above = false;
  for (vtkIdType p = 0; p < particles->GetNumberOfPoints(); ++p) {
    (array->GetComponent(p, 0) < value ? below : above) = true;
  }
  return below && above;
}

bool shows_failure_zone(const ContourPanel& panel) {
  return panel.failure_strain.has_value() && panel.field.array == strain_array &&
         passes(panel.particles, strain_array, *panel.failure_strain);
}

bool shows_water_level(const ContourPanel& panel) {
  return passes(panel.particles, pressure_array, level_pressure);
}

bool under_water(const ContourPanel& panel, const couple::Point& where) {
  return std::ranges::any_of(panel.standing_water, [&](const StandingWater& water) {
    return where[0] >= water.x.low && where[0] <= water.x.high && where[1] < water.level;
  });
}

/// The surface of standing water: a line where there is no soil.
void draw_water_surface(Canvas& canvas, const PlotFrame& frame, const FieldImage& image, const StandingWater& water) {
  const LineStyle style{0.07 * canvas.em(), water_surface, {}};
  if (water.level <= frame.y.low || water.level >= frame.y.high) {
    return;
  }
  const int columns = static_cast<int>(frame.box.width());
  std::vector<Pixel> line;
  for (int i = 0; i <= columns; ++i) {
    const double x = frame.x.low + (i + 0.5) / columns * frame.x.length();
    const bool open = i < columns && x >= water.x.low && x <= water.x.high && !image.inside({x, water.level});
    if (open) {
      line.push_back(frame.at(x, water.level));
    } else if (!line.empty()) {
      canvas.stroke({line.front(), line.back()}, style);
      line.clear();
    }
  }
}

void draw_field(Canvas& canvas, const PlotFrame& frame, const FieldImage& image, const ContourPanel& panel) {
  const auto columns = static_cast<int>(frame.box.width());
  const auto rows = static_cast<int>(frame.box.height());
  std::vector<Colour> colours;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const couple::Point x{frame.x.low + (i + 0.5) / columns * frame.x.length(),
                            frame.y.low + (j + 0.5) / rows * frame.y.length()};
      if (image.inside(x)) {
        const double value = panel.field.factor * image.value(panel.field.array, x);
        colours.push_back(colour_at(panel.field.colours, (value - panel.scale.range.low) / panel.scale.range.length()));
      } else {
        colours.push_back(under_water(panel, x) ? pale_water : white);
      }
    }
  }
  canvas.image(static_cast<int>(frame.box.left), static_cast<int>(frame.box.bottom), columns, colours);
}

/// A line without the ripple, some pixels long, that the lattice of the particles leaves in it.
std::vector<Pixel> smoothed(std::vector<Pixel> line) {
  constexpr int passes = 4;
  for (int pass = 0; pass < passes; ++pass) {
    const auto before = line;
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
      line[i] = {0.25 * before[i - 1].x + 0.5 * before[i].x + 0.25 * before[i + 1].x,
                 0.25 * before[i - 1].y + 0.5 * before[i].y + 0.25 * before[i + 1].y};
    }
  }
  return line;
}

/// The scale's step, or a wider one if the numbers would run into each other.
double step_between_numbers(const Canvas& canvas, const Box& box, const ColourScale& scale, const BarStyle& style) {
  const double length = style.upright ? box.height() : box.width();
  const double room =
      style.upright ? 1.5 * canvas.em() : widest_number(canvas, scale.range, scale.step) + 0.8 * canvas.em();
  return std::max(scale.step, round_step(scale.range, length / room));
}

}  // namespace

const std::vector<Field>& drawable_fields() {
  static const std::vector<Field> fields{
      {"suction", "suction", "Suction s (kPa)", 1.0e-3, viridis(), false, true},
      {"deviatoric_strain", strain_array, "Deviatoric strain ε_{q} = √(2/3 e:e) (-)", 1.0, magma_reversed(), true,
       false},
      {"displacement", "displacement", "Displacement |u| (m)", 1.0, magma_reversed(), true, false},
      {"pore_pressure", pressure_array, "Pore-water pressure P_{w} (kPa)", 1.0e-3, viridis(), false, true},
      {"saturation", "saturation", "Degree of saturation S_{r} (-)", 1.0, viridis(), false, true},
      {"porosity", "porosity", "Porosity n (-)", 1.0, viridis(), false, true},
      {"preconsolidation_pressure", "preconsolidation_pressure", "Preconsolidation pressure p_{c} (kPa)", 1.0e-3,
       viridis(), false, true, false},
      {"mechanism_shear_strain", "mechanism_shear_strain", "Shear strain of the flow, over its largest (-)", 1.0,
       magma_reversed(), true, false, false},
      {"mechanism_speed", "mechanism_speed", "Speed of the flow, over its largest (-)", 1.0, magma_reversed(), true,
       false, false}};
  return fields;
}

const Field& field_called(const std::string& name) {
  const auto& known = drawable_fields();
  const auto found = std::ranges::find(known, name, &Field::name);
  if (found == known.end()) {
    std::string all;
    for (const auto& field : known) {
      all += (all.empty() ? "" : ", ") + field.name;
    }
    throw std::invalid_argument("no field is called \"" + name + "\"; choose from " + all);
  }
  return *found;
}

ColourScale common_scale(const Field& field, const std::vector<vtkSmartPointer<vtkPolyData>>& particles) {
  constexpr double left_out = 0.005;  // share of the particles of the picture with the largest values
  Range data{std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()};
  double largest = data.high;
  for (const auto& snapshot : particles) {
    auto* array = particle_array(snapshot, field.array);
    std::vector<double> values;
    for (vtkIdType p = 0; p < snapshot->GetNumberOfPoints(); ++p) {
      values.push_back(field.factor * scalar(array, static_cast<std::size_t>(p)));
    }
    std::sort(values.begin(), values.end());
    if (values.empty()) {
      continue;
    }
    const auto last = static_cast<std::size_t>((1.0 - left_out) * static_cast<double>(values.size() - 1));
    data.low = std::min(data.low, values.front());
    data.high = std::max(data.high, field.from_zero ? values[last] : values.back());
    largest = std::max(largest, values.back());
  }
  if (field.from_zero) {
    data.low = 0.0;
  }
  if (!(data.high - data.low > 1.0e-9 * std::max({1.0, std::abs(data.low), std::abs(data.high)}))) {
    data.high = data.low + 1.0;
  }
  ColourScale scale;
  scale.step = round_step(data, 8.0);
  scale.range = widened(data, 0.5 * scale.step);
  scale.more_above = largest > scale.range.high * (1.0 + 1.0e-9);
  return scale;
}

std::vector<StandingWater> standing_water_at(const couple::Case& input, double time) {
  std::vector<StandingWater> standing;
  for (const couple::WaterBoundary& boundary : input.water_boundaries) {
    const auto* reservoir = std::get_if<couple::Reservoir>(&boundary.condition);
    if (reservoir == nullptr || (time <= 0.0 && !boundary.initial)) {
      continue;
    }
    standing.push_back({{boundary.where.from, boundary.where.to}, reservoir->level.at(time)});
  }
  return standing;
}

double height_over_width(const couple::Domain& domain) {
  return (domain.upper[1] - domain.lower[1]) / (domain.upper[0] - domain.lower[0]);
}

PlotFrame panel_frame(const Box& box, const ContourPanel& panel) {
  const auto& domain = panel.domain;
  return {box, {domain.lower[0], domain.upper[0]}, {domain.lower[1], domain.upper[1]}};
}

void draw_contour_panel(Canvas& canvas, const Box& box, const ContourPanel& panel) {
  const auto& domain = panel.domain;
  const ImageGrid grid{domain.lower, domain.upper, std::max(2, static_cast<int>(box.width() / pixels_per_cell)),
                       std::max(2, static_cast<int>(box.height() / pixels_per_cell))};
  std::vector<std::string> fields{pressure_array};
  if (panel.field.array != pressure_array) {
    fields.push_back(panel.field.array);
  }
  const FieldImage image(panel.particles, grid, fields);
  const PlotFrame frame = panel_frame(box, panel);
  const double em = canvas.em();
  const auto to_pixels = [&frame, em](const std::vector<FieldImage::Line>& lines) {
    std::vector<std::vector<Pixel>> result;
    for (const auto& line : lines) {
      std::vector<Pixel> pixels;
      for (const auto& point : line) {
        pixels.push_back(frame.at(point[0], point[1]));
      }
      result.push_back(thinned(pixels, 0.1 * em));
    }
    return result;
  };

  draw_field(canvas, frame, image, panel);
  if (panel.field.level_lines) {
    for (const double level : multiples(panel.scale.range, panel.scale.step)) {
      const bool at_an_end = level <= panel.scale.range.low || level >= panel.scale.range.high;
      if (level == 0.0 || at_an_end) {
        continue;  // zero suction is the water level; at an end, the saturation's 1 for one, there is only noise
      }
      for (const auto& line : to_pixels(image.iso_lines(panel.field.array, level / panel.field.factor))) {
        canvas.stroke(line, {0.035 * em, ink, {}});
      }
    }
  }
  for (const StandingWater& water : panel.standing_water) {
    draw_water_surface(canvas, frame, image, water);
  }
  for (const auto& line : to_pixels(image.outline())) {
    canvas.stroke(smoothed(line), {0.07 * em, ink, {}});
  }
  if (shows_failure_zone(panel)) {
    for (const auto& line : to_pixels(image.iso_lines(strain_array, *panel.failure_strain))) {
      canvas.stroke(line, zone_line(canvas));
    }
  }
  stroke_water_level(canvas, to_pixels(image.without_surface(image.iso_lines(pressure_array, level_pressure))));
  draw_axes(canvas, frame, axis_for(panel.x_title ? "x (m)" : "", frame.x, box.width(), 4.5 * em),
            axis_for("y (m)", frame.y, box.height(), 2.8 * em), false);
}

void draw_colour_bar(Canvas& canvas, const Box& box, const Field& field, const ColourScale& scale,
                     const BarStyle& style) {
  const double em = canvas.em();
  const auto place = [&](double share) {
    return style.upright ? box.bottom + share * box.height() : box.left + share * box.width();
  };
  constexpr int pieces = 256;
  for (int i = 0; i < pieces; ++i) {
    const double from = place(static_cast<double>(i) / pieces);
    const double to = place((i + 1.0) / pieces);
    const Colour colour = colour_at(field.colours, (i + 0.5) / pieces);
    canvas.fill(style.upright ? Box{box.left, from, box.right, to} : Box{from, box.bottom, to, box.top}, colour);
  }
  const LineStyle line{0.06 * em, ink, {}};
  canvas.stroke(box, line);
  if (scale.more_above) {
    const std::vector<Pixel> tip =
        style.upright
            ? std::vector<Pixel>{{box.left, box.top}, {box.right, box.top}, {box.centre().x, box.top + 0.8 * em}}
            : std::vector<Pixel>{{box.right, box.bottom}, {box.right + 0.8 * em, box.centre().y}, {box.right, box.top}};
    canvas.fill(tip, colour_at(field.colours, 1.0));
    canvas.stroke({tip[0], tip[1], tip[2], tip[0]}, line);
  }
  const double step = step_between_numbers(canvas, box, scale, style);
  for (const double value : multiples(scale.range, step)) {
    const double at = place((value - scale.range.low) / scale.range.length());
    const std::string number = number_text(value, step);
    if (style.upright) {
      canvas.stroke({{box.right, at}, {box.right + 0.25 * em, at}}, line);
      canvas.text({box.right + 0.5 * em, at}, number);
    } else {
      canvas.stroke({{at, box.bottom}, {at, box.bottom - 0.25 * em}}, line);
      canvas.text({at, box.bottom - 0.9 * em}, number, {.anchor = Anchor::centre});
    }
  }
}

void draw_titled_bar(Canvas& canvas, double left, double right, double bottom, const Field& field,
                     const ColourScale& scale) {
  const double em = canvas.em();
  const double top = bottom + lying_bar_height * em;
  canvas.text({left, 0.5 * (bottom + top)}, field.title);
  draw_colour_bar(canvas, {left + canvas.text_width(field.title) + 1.2 * em, bottom, right - 1.0 * em, top}, field,
                  scale, {});
}

std::vector<LegendEntry> legend_entries(const Canvas& canvas, std::span<const ContourPanel> panels) {
  std::vector<LegendEntry> entries;
  if (std::ranges::any_of(panels, shows_water_level)) {
    entries.push_back({"water level (P_{w} = 0)", {casing(canvas), water_line(canvas)}});
  }
  const auto zone = std::ranges::find_if(panels, shows_failure_zone);
  if (zone != panels.end()) {
    const double percent = 100.0 * *zone->failure_strain;
    entries.push_back(
        {"ε_{q} = " + number_text(percent, percent == std::round(percent) ? 1.0 : 0.1) + " %", {zone_line(canvas)}});
  }
  return entries;
}

void draw_legend_entry(Canvas& canvas, Pixel where, const LegendEntry& entry) {
  for (const LineStyle& style : entry.strokes) {
    canvas.stroke({where, {where.x + legend_sample * canvas.em(), where.y}}, style);
  }
  canvas.text({where.x + (legend_sample + 0.5) * canvas.em(), where.y}, entry.text);
}

double draw_legend(Canvas& canvas, double right, double y, const std::vector<LegendEntry>& entries) {
  double x = right + legend_gap * canvas.em();
  for (const auto& entry : entries) {
    x -= canvas.text_width(entry.text) + (legend_sample + 0.5 + legend_gap) * canvas.em();
    draw_legend_entry(canvas, {x, y}, entry);
  }
  return x - legend_gap * canvas.em();
}

}  // namespace slope::tools
