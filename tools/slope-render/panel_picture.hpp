#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "contour_panel.hpp"
#include "run_folder.hpp"

namespace slope::tools {

/// Size of a failure zone.
struct ZoneSize {
  double length = 0.0;  ///< horizontally (m)
  double height = 0.0;  ///< (m)
};

/// A failure zone's place and the size that is written at its dimension lines.
struct ZoneDimensions {
  couple::Point lower{0.0, 0.0};  ///< of its bounding box (m)
  couple::Point upper{0.0, 0.0};  ///< (m)
  ZoneSize size;
};

/// Where the zone lies whose particles have a larger deviatoric strain than the threshold, half a particle spacing
/// around their centres; none if there are none.
[[nodiscard]] std::optional<ZoneDimensions> zone_dimensions(vtkPolyData* particles, double threshold,
                                                            const ZoneSize& size);

/// One of several contour panels.
struct StackedPanel {
  vtkSmartPointer<vtkPolyData> particles;
  couple::Domain domain;
  std::optional<double> failure_strain;  ///< outlined, if given
  std::string caption;                   ///< "Case W1, t = 640 s"; the picture adds "(a)"
  std::optional<ZoneDimensions> zone;
};

/// Panels of one field one above the other, with one legend, and one colour scale and one bar for all of them.
/// @param panels  at least one, at most 26.
/// @throws couple::FileError if it cannot be written.
void write_stacked_panels(const std::filesystem::path& file, int width, const Field& field,
                          const std::vector<StackedPanel>& panels);

}  // namespace slope::tools
