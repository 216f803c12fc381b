#pragma once

#include <array>

#include "format.hpp"
#include "slope/couple/case.hpp"

/// The case format: every key with its meaning, its unit, its range, and whether it is required.
namespace slope::couple {

/// The key of a case file under which its base stands, and the path that it holds.
inline constexpr const char* include_key = "include";
[[nodiscard]] Format<std::string> include_format();

/// The keys under which a soil names the file that it comes from, and its name there.
inline constexpr const char* library_key = "from";
inline constexpr const char* library_soil_key = "soil";
[[nodiscard]] Format<std::string> library_format();

/// The keys of a water boundary of which it has exactly one.
inline constexpr std::array water_conditions{"pressure", "total_head", "flux", "free_drainage", "rain", "reservoir"};
/// The keys of rain of which it has exactly one.
inline constexpr std::array rain_conditions{"intensity", "hyetograph", "file"};

[[nodiscard]] Format<Soil> soil_format();
[[nodiscard]] Format<InitialWater> initial_water_format();
[[nodiscard]] Format<WaterBoundary> water_boundary_format();
[[nodiscard]] Format<Traction> traction_format();
[[nodiscard]] Format<Seismic> seismic_format();
[[nodiscard]] Format<Case> case_format();

/// Checks what concerns more than one key. Each check is left out where the keys it needs are already wrong.
void check_case(const Input& root, const Case& input);

}  // namespace slope::couple
