#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <regex>

#include "case/units.hpp"

namespace slope::couple {
namespace {

double value_of(std::string_view text, Dimension dimension) {
  const auto parsed = parse_quantity(text, dimension);
  if (const auto* problem = std::get_if<std::string>(&parsed)) {
    ADD_FAILURE() << text << ": " << *problem;
    return std::numeric_limits<double>::quiet_NaN();
  }
  return std::get<double>(parsed);
}

std::string problem_of(std::string_view text, Dimension dimension) {
  const auto parsed = parse_quantity(text, dimension);
  const auto* problem = std::get_if<std::string>(&parsed);
  return problem != nullptr ? *problem : "";
}

const std::vector<Dimension> all_dimensions{
    Dimension::number,       Dimension::length,         Dimension::area,    Dimension::time, Dimension::velocity,
    Dimension::acceleration, Dimension::inverse_length, Dimension::angle,   Dimension::mass, Dimension::force,
    Dimension::density,      Dimension::unit_weight,    Dimension::pressure};

TEST(Units, AreConvertedToSiWithoutRoundingTwice) {
  EXPECT_EQ(value_of("10 MPa", Dimension::pressure), 1.0e7);
  EXPECT_EQ(value_of("1.3 MN/m2", Dimension::pressure), 1.3e6);
  EXPECT_EQ(value_of("-5 kPa", Dimension::pressure), -5.0e3);
  EXPECT_EQ(value_of("+.5 kPa", Dimension::pressure), 500.0);
  EXPECT_EQ(value_of("25 deg", Dimension::angle), 25.0 * std::numbers::pi / 180.0);
  EXPECT_EQ(value_of("36 mm/h", Dimension::velocity), 1.0e-5);
  EXPECT_EQ(value_of("1e-5 m/s", Dimension::velocity), 1.0e-5);
  EXPECT_EQ(value_of("0.05 1/m", Dimension::inverse_length), 0.05);
  EXPECT_EQ(value_of("2 cm", Dimension::length), 0.02);
  EXPECT_EQ(value_of("3 min", Dimension::time), 180.0);
  EXPECT_EQ(value_of("2 h", Dimension::time), 7200.0);
  EXPECT_EQ(value_of("1 d", Dimension::time), 86400.0);
  EXPECT_EQ(value_of("2.7 g/cm3", Dimension::density), 2700.0);
  EXPECT_EQ(value_of("9.81 m/s2", Dimension::acceleration), 9.81);
  EXPECT_EQ(value_of("35 %", Dimension::number), 0.35);
  EXPECT_EQ(value_of("1e-6", Dimension::number), 1.0e-6);
}

TEST(Units, ABareNumberIsNoDimensionalValue) {
  EXPECT_EQ(
      problem_of("10", Dimension::pressure),
      R"(expected a pressure with its unit, such as "10 kPa" (units: Pa, kPa, MPa, GPa, N/m2, kN/m2, MN/m2), got 10 without a unit)");
}

TEST(Units, TheDimensionOfAWrongUnitIsTold) {
  EXPECT_EQ(
      problem_of("19 kN/m3", Dimension::density),
      R"(expected a density with its unit, such as "2700 kg/m3" (units: kg/m3, g/cm3, t/m3), got "19 kN/m3", which is a unit weight)");
  EXPECT_EQ(problem_of("3 m", Dimension::number),
            R"(expected a number without a unit, such as 0.35 (or in percent, "35 %"), got "3 m", which is a length)");
}

TEST(Units, AnUnknownUnitIsToldWithWhatWasProbablyMeant) {
  EXPECT_TRUE(problem_of("10 Mpa", Dimension::pressure).starts_with(R"(unknown unit "Mpa", did you mean "MPa"?)"));
  EXPECT_TRUE(
      problem_of("2700 kg/m^3", Dimension::density).starts_with(R"(unknown unit "kg/m^3", did you mean "kg/m3"?)"));
  EXPECT_TRUE(problem_of("3 furlongs", Dimension::length).starts_with(R"(unknown unit "furlongs"; expected a length)"));
}

TEST(Units, WhatIsNoNumberIsRefused) {
  for (const char* text : {"", "ten m", "inf m", "nan m", "-", "m", ".", "0x10 m", "1e m", "- 3 m"}) {
    EXPECT_NE(problem_of(text, Dimension::length), "") << text;
  }
  EXPECT_EQ(problem_of("1e999 m", Dimension::length), R"("1e999 m" is beyond the range of numbers)");
  EXPECT_EQ(problem_of("10m", Dimension::length), R"(write a space between number and unit: "10 m")");
  EXPECT_TRUE(problem_of("0,5 m", Dimension::length).ends_with("write a decimal point"));
}

TEST(Units, AWrittenValueReadsBackTheSameToTheLastBit) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> mantissa(-10.0, 10.0);
  std::uniform_int_distribution<int> exponent(-30, 30);
  for (const Dimension dimension : all_dimensions) {
    for (int i = 0; i < 2000; ++i) {
      const double value = mantissa(random) * std::pow(10.0, exponent(random));
      ASSERT_EQ(value_of(quantity_text(value, dimension), dimension), value) << quantity_text(value, dimension);
    }
  }
}

TEST(Units, ValuesAreWrittenInUnitsThatAreEasyToRead) {
  EXPECT_EQ(quantity_text(1.0e7, Dimension::pressure), "10 MPa");
  EXPECT_EQ(quantity_text(0.0, Dimension::pressure), "0 Pa");
  EXPECT_EQ(quantity_text(25.0 * std::numbers::pi / 180.0, Dimension::angle), "25 deg");
  EXPECT_EQ(quantity_text(0.02, Dimension::length), "0.02 m");
  EXPECT_EQ(quantity_text(0.35, Dimension::number), "0.35");
}

TEST(Units, ThePatternTakesWhatTheReaderTakes) {
  const std::vector<std::string> numbers{"1", "-1", "+1", "1.", ".5",  "1.5e-3", "1E3",
                                         "",  ".",  "e3", "1e", "abc", "1,5"};
  const std::vector<std::string> gaps{"", " ", "  "};
  for (const Dimension dimension : all_dimensions) {
    const std::regex pattern(quantity_pattern(dimension));
    for (const Dimension other : all_dimensions) {
      for (const std::string_view unit : units_of(other)) {
        for (const std::string& number : numbers) {
          for (const std::string& gap : gaps) {
            const std::string text = number + gap + std::string(unit);
            EXPECT_EQ(std::regex_match(text, pattern), problem_of(text, dimension).empty()) << text;
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace slope::couple
