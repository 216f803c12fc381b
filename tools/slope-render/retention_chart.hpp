#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "plot_frame.hpp"
#include "slope/seepage/retention.hpp"

namespace slope::tools {

/// A retention curve and the part of it that occurs in a soil.
struct RetentionCurve {
  std::string name;
  seepage::Retention law;
  Range suction;  ///< in the soil (Pa), >= 0
};

/// Degree of saturation at a suction (Pa).
/// @param unit_weight  of water (N/m3).
[[nodiscard]] double saturation_at(const seepage::Retention& law, double suction, double unit_weight);

/// Degree of saturation over suction: unbroken where the curve's suction occurs in the soil, dashed beyond. The range
/// of saturation stands in the legend.
/// @throws couple::FileError if it cannot be written.
void write_retention_chart(const std::filesystem::path& file, int width, const std::vector<RetentionCurve>& curves,
                           double unit_weight);

}  // namespace slope::tools
