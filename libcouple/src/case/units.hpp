#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace slope::couple {

/// What a value of a case file measures.
enum class Dimension {
  number,
  length,
  area,
  time,
  velocity,
  acceleration,
  inverse_length,
  angle,
  mass,
  force,
  density,
  unit_weight,
  pressure,
};

/// "pressure", "number", …
[[nodiscard]] std::string_view name_of(Dimension dimension);
/// The units in which it can be written, its SI unit first; "%" for a number, which can also go without.
[[nodiscard]] std::vector<std::string_view> units_of(Dimension dimension);

/// The value in SI units (angles: rad) of a text such as "10 MPa", or what is wrong with the text.
[[nodiscard]] std::variant<double, std::string> parse_quantity(std::string_view text, Dimension dimension);

/// A text that parse_quantity() reads as the same value, to the last bit: in SI units, or in degrees, kPa, MPa or GPa
/// where that is shorter.
[[nodiscard]] std::string quantity_text(double value, Dimension dimension);

/// A length for messages, to the micrometre whatever its size: "500123.45 m", "0.3 m".
[[nodiscard]] std::string length_text(double metres);

/// A regular expression (ECMA) of the texts that parse_quantity() takes as that dimension.
[[nodiscard]] std::string quantity_pattern(Dimension dimension);

}  // namespace slope::couple
