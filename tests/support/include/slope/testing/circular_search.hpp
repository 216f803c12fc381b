#pragma once

#include <array>
#include <functional>
#include <limits>

namespace slope::testing {

/// Soil between a level toe and a level crest, over firm ground. The face rises towards +x.
struct SlopeSection {
  std::array<double, 2> toe{};    ///< (m)
  std::array<double, 2> crest{};  ///< to the right of the toe and above it (m)
  double base = 0.0;              ///< y of the firm ground, which no circle cuts (m)
};

/// What a slip surface meets. The functions take a place (m).
struct SlopeSoil {
  using Field = std::function<double(double x, double y)>;

  double unit_weight = 0.0;  ///< of soil and water (N/m3), > 0
  Field friction_angle;      ///< (rad), >= 0
  Field cohesion;            ///< (Pa), >= 0
  Field pore_stress;  ///< total less effective normal stress, positive in compression (Pa); of water at rest up to
                      ///< `water_level`, which buoys the soil up, none
  /// Up to which water stands inside and outside of the slope (m).
  double water_level = -std::numeric_limits<double>::infinity();
};

struct SlipCircle {
  double factor_of_safety = 0.0;
  std::array<double, 2> centre{};  ///< (m)
  double radius = 0.0;             ///< (m)
};

/// The circle with the lowest factor of safety by Bishop's simplified method (Geotechnique 5, 1955): a search over
/// where the circle comes out, where it begins and how far it sags, on a grid that narrows around the best.
[[nodiscard]] SlipCircle critical_circle(const SlopeSection& section, const SlopeSoil& soil);

}  // namespace slope::testing
