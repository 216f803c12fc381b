#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "canvas.hpp"
#include "colour_maps.hpp"
#include "plot_frame.hpp"
#include "slope/couple/case.hpp"

namespace slope::tools {

/// A field of the particles and how it is drawn.
struct Field {
  std::string name;     ///< of the pictures: <name>_<label>.png
  std::string array;    ///< of the particle file
  std::string title;    ///< of the colour bar, with symbol and unit
  double factor = 1.0;  ///< drawn value over the one in the file
  ColourMap colours;
  bool from_zero = false;    ///< the scale starts at zero and leaves out the largest few values
  bool level_lines = false;  ///< thin lines at the numbers of the colour bar
  bool in_every_run = true;  ///< false: only particle files of soil that has it hold it
};

/// The fields that can be drawn.
[[nodiscard]] const std::vector<Field>& drawable_fields();
/// @throws std::invalid_argument, which lists the fields, if there is none of this name.
[[nodiscard]] const Field& field_called(const std::string& name);

/// From which value to which the colours go.
struct ColourScale {
  Range range;
  double step = 1.0;        ///< between the numbers of the colour bar, if they fit, and between level lines
  bool more_above = false;  ///< some values lie above
};

/// One scale for several pictures of a field, with round ends.
[[nodiscard]] ColourScale common_scale(const Field& field, const std::vector<vtkSmartPointer<vtkPolyData>>& particles);

/// Water of a reservoir at one time.
struct StandingWater {
  Range x;             ///< where it may stand (m)
  double level = 0.0;  ///< y of its surface (m)
};

/// The reservoirs of a case at a time (s).
[[nodiscard]] std::vector<StandingWater> standing_water_at(const couple::Case& input, double time);

/// What a contour picture shows.
struct ContourPanel {
  vtkPolyData* particles = nullptr;
  Field field;
  ColourScale scale;
  couple::Domain domain;                 ///< what is shown, with its walls
  std::optional<double> failure_strain;  ///< outlined, if given: deviatoric strain of the failure zone (-)
  std::string title;                     ///< of the run
  std::string caption;                   ///< of this picture: its time
  bool x_title = true;                   ///< whether the horizontal axis has its title
  std::vector<StandingWater> standing_water = {};
};

/// Draws the field, the outline of the soil, the water level and the axes into a box whose sides have the ratio of
/// the domain's.
void draw_contour_panel(Canvas& canvas, const Box& box, const ContourPanel& panel);

/// Height over width of what a panel shows.
[[nodiscard]] double height_over_width(const couple::Domain& domain);

/// The frame of a panel that is drawn into a box: where a point of the domain (m) lies.
[[nodiscard]] PlotFrame panel_frame(const Box& box, const ContourPanel& panel);

/// What a line in a panel means.
struct LegendEntry {
  std::string text;
  std::vector<LineStyle> strokes;  ///< one over the other
};

/// The lines that are in any of the panels.
[[nodiscard]] std::vector<LegendEntry> legend_entries(const Canvas& canvas, std::span<const ContourPanel> panels);
/// From a place to the right.
void draw_legend_entry(Canvas& canvas, Pixel where, const LegendEntry& entry);
/// In one line that ends at `right`; returns where it begins.
double draw_legend(Canvas& canvas, double right, double y, const std::vector<LegendEntry>& entries);

struct BarStyle {
  bool upright = false;
};

/// The colours with their numbers, which stand below a lying bar and to the right of an upright one.
void draw_colour_bar(Canvas& canvas, const Box& box, const Field& field, const ColourScale& scale,
                     const BarStyle& style);
/// The bar beside the field's title, from `left` to `right` with its lower edge at `bottom`.
void draw_titled_bar(Canvas& canvas, double left, double right, double bottom, const Field& field,
                     const ColourScale& scale);

/// Width of a panel's numbers and title to the left of its box, and height of a lying colour bar (em).
inline constexpr double panel_left_room = 3.9;
inline constexpr double lying_bar_height = 0.9;
}  // namespace slope::tools
