#pragma once

#include <string>

#include "random_numbers.hpp"

namespace slope::random_cases {

// Values in SI units as a case file has them, each time in another of the units that it takes.
[[nodiscard]] std::string length_text(RandomNumbers& random, double metres);
[[nodiscard]] std::string pressure_text(RandomNumbers& random, double pascals);
[[nodiscard]] std::string time_text(RandomNumbers& random, double seconds);
[[nodiscard]] std::string velocity_text(RandomNumbers& random, double metres_per_second);
[[nodiscard]] std::string density_text(RandomNumbers& random, double kilograms_per_cubic_metre);
[[nodiscard]] std::string angle_text(RandomNumbers& random, double degrees);
[[nodiscard]] std::string share_text(RandomNumbers& random, double share);
[[nodiscard]] std::string inverse_length_text(RandomNumbers& random, double per_metre);

}  // namespace slope::random_cases
