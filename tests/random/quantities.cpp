#include "quantities.hpp"

#include <fmt/format.h>

#include <numbers>

namespace slope::random_cases {

namespace {

struct Unit {
  const char* name;
  double value;
};

std::string text_in(const Unit& unit, double value) {
  return fmt::format("{:.7g} {}", value / unit.value, unit.name);
}

}  // namespace

std::string length_text(RandomNumbers& random, double metres) {
  return text_in(random.one_of<Unit>({{"m", 1.0}, {"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}}), metres);
}

std::string pressure_text(RandomNumbers& random, double pascals) {
  return text_in(random.one_of<Unit>({{"kPa", 1.0e3}, {"Pa", 1.0}, {"kN/m2", 1.0e3}, {"MPa", 1.0e6}, {"MN/m2", 1.0e6}}),
                 pascals);
}

std::string time_text(RandomNumbers& random, double seconds) {
  return text_in(random.one_of<Unit>({{"s", 1.0}, {"min", 60.0}, {"h", 3600.0}, {"d", 86400.0}}), seconds);
}

std::string velocity_text(RandomNumbers& random, double metres_per_second) {
  return text_in(random.one_of<Unit>({{"m/s", 1.0},
                                      {"cm/s", 0.01},
                                      {"mm/h", 0.001 / 3600.0},
                                      {"cm/h", 0.01 / 3600.0},
                                      {"mm/d", 0.001 / 86400.0},
                                      {"m/d", 1.0 / 86400.0}}),
                 metres_per_second);
}

std::string density_text(RandomNumbers& random, double kilograms_per_cubic_metre) {
  return text_in(random.one_of<Unit>({{"kg/m3", 1.0}, {"g/cm3", 1000.0}, {"t/m3", 1000.0}}), kilograms_per_cubic_metre);
}

std::string angle_text(RandomNumbers& random, double degrees) {
  return text_in(random.one_of<Unit>({{"deg", 1.0}, {"deg", 1.0}, {"rad", 180.0 / std::numbers::pi}}), degrees);
}

std::string share_text(RandomNumbers& random, double share) {
  return random.chance(0.2) ? text_in({"%", 0.01}, share) : fmt::format("{:.7g}", share);
}

std::string inverse_length_text(RandomNumbers& random, double per_metre) {
  return text_in(random.one_of<Unit>({{"1/m", 1.0}, {"1/cm", 100.0}}), per_metre);
}

}  // namespace slope::random_cases
