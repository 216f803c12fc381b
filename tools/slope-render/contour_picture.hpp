#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <optional>
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
};

/// The fields that can be drawn.
[[nodiscard]] const std::vector<Field>& drawable_fields();

/// From which value to which the colours go.
struct ColourScale {
  Range range;
  double step = 1.0;        ///< between the numbers of the colour bar, if they fit, and between level lines
  bool more_above = false;  ///< some values lie above
};

/// One scale for several pictures of a field, with round ends.
[[nodiscard]] ColourScale common_scale(const Field& field, const std::vector<vtkSmartPointer<vtkPolyData>>& particles);

/// What a contour picture shows.
struct ContourPanel {
  vtkPolyData* particles = nullptr;
  Field field;
  ColourScale scale;
  couple::Domain domain;                 ///< what is shown, with its walls
  std::optional<double> failure_strain;  ///< outlined, if given: deviatoric strain of the failure zone (-)
  std::string title;                     ///< of the run
  std::string caption;                   ///< of this picture: its time
};

/// Draws the field, the outline of the soil, the water level and the axes into a box whose sides have the ratio of
/// the domain's.
void draw_contour_panel(Canvas& canvas, const Box& box, const ContourPanel& panel);

/// A picture of one panel with title, legend and colour bar, `width` pixels wide (narrower for a tall domain).
/// @throws couple::FileError if it cannot be written.
void write_contour_picture(const std::filesystem::path& file, int width, const ContourPanel& panel);

}  // namespace slope::tools
