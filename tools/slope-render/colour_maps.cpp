#include "colour_maps.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace slope::tools {
namespace {

// Every 17th of the 256 colours of viridis and magma by N. J. Smith, S. van der Walt and E. Firing, matplotlib 1.5
// (2015), given to the public domain (CC0): https://bids.github.io/colormap
constexpr std::array<Colour, 16> viridis_colours{{{0x44, 0x01, 0x54},
                                                  {0x48, 0x1a, 0x6c},
                                                  {0x47, 0x2f, 0x7d},
                                                  {0x41, 0x44, 0x87},
                                                  {0x39, 0x56, 0x8c},
                                                  {0x31, 0x68, 0x8e},
                                                  {0x2a, 0x78, 0x8e},
                                                  {0x23, 0x88, 0x8e},
                                                  {0x1f, 0x98, 0x8b},
                                                  {0x22, 0xa8, 0x84},
                                                  {0x35, 0xb7, 0x79},
                                                  {0x54, 0xc5, 0x68},
                                                  {0x7a, 0xd1, 0x51},
                                                  {0xa5, 0xdb, 0x36},
                                                  {0xd2, 0xe2, 0x1b},
                                                  {0xfd, 0xe7, 0x25}}};

constexpr std::array<Colour, 16> magma_colours_from_light{{{0xfc, 0xfd, 0xbf},
                                                           {0xfd, 0xde, 0xa0},
                                                           {0xfe, 0xbf, 0x84},
                                                           {0xfe, 0x9f, 0x6d},
                                                           {0xfa, 0x7f, 0x5e},
                                                           {0xf1, 0x60, 0x5d},
                                                           {0xde, 0x49, 0x68},
                                                           {0xc4, 0x3c, 0x75},
                                                           {0xa8, 0x32, 0x7d},
                                                           {0x8c, 0x29, 0x81},
                                                           {0x72, 0x1f, 0x81},
                                                           {0x57, 0x15, 0x7e},
                                                           {0x3b, 0x0f, 0x70},
                                                           {0x20, 0x11, 0x4b},
                                                           {0x0b, 0x09, 0x24},
                                                           {0x00, 0x00, 0x04}}};

// M. Okabe and K. Ito, "Color universal design" (2008), their yellow left out and grey added.
constexpr std::array<Colour, 8> curve_colours{{{0x00, 0x72, 0xb2},
                                               {0xd5, 0x5e, 0x00},
                                               {0x00, 0x9e, 0x73},
                                               {0xcc, 0x79, 0xa7},
                                               {0xe6, 0x9f, 0x00},
                                               {0x56, 0xb4, 0xe9},
                                               {0x00, 0x00, 0x00},
                                               {0x80, 0x80, 0x80}}};

std::uint8_t between(std::uint8_t a, std::uint8_t b, double share) {
  return static_cast<std::uint8_t>(std::lround(a + share * (b - a)));
}

}  // namespace

ColourMap viridis() {
  return viridis_colours;
}
ColourMap magma_reversed() {
  return magma_colours_from_light;
}

Colour colour_at(ColourMap map, double share) {
  const double place = std::clamp(share, 0.0, 1.0) * static_cast<double>(map.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(place), map.size() - 2);
  const double rest = place - static_cast<double>(i);
  return {between(map[i].red, map[i + 1].red, rest), between(map[i].green, map[i + 1].green, rest),
          between(map[i].blue, map[i + 1].blue, rest)};
}

Colour curve_colour(std::size_t index) {
  return curve_colours[index % curve_colours.size()];
}

}  // namespace slope::tools
