#include "random_ground.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace slope::random_cases {

namespace {

using couple::Point;

/// One face after the other from a toe, level berms between them; narrower than the room if there is enough of it.
std::vector<Point> faces(RandomNumbers& random, const RandomGround& ground, double toe, double rise, int count) {
  const double room = ground.width - 2.0 * ground.cell;
  const double berm = count > 1 ? ground.cell * random.uniform(1.0, 2.5) : 0.0;
  const double wanted = rise / std::tan(random.uniform(12.0, 75.0) * std::numbers::pi / 180.0);
  const double run = std::min(wanted, room - berm * (count - 1));
  // some faces begin at the side of the domain
  const double free = ground.width - run - berm * (count - 1);
  double x = random.chance(0.1) ? 0.0 : random.uniform(ground.cell, free - 0.5 * ground.cell), y = toe;
  std::vector<Point> line;
  if (x > 0.0) line.push_back({0.0, y});
  for (int i = 0; i < count; ++i) {
    line.push_back({x, y});
    x += run / count, y += rise / count;
    line.push_back({x, y});
    x += berm;
  }
  const double rest = ground.width - line.back()[0];
  line.push_back({ground.width, y + (random.chance(0.2) ? random.uniform(0.0, 0.1) * rest : 0.0)});
  return line;
}

std::vector<Point> embankment(RandomNumbers& random, const RandomGround& ground, double toe, double rise) {
  const double crest = ground.cell * random.uniform(3.0, 4.0), room = ground.width - 2.0 * ground.cell - crest;
  const double tangent = std::max(std::tan(random.uniform(15.0, 60.0) * std::numbers::pi / 180.0), 2.0 * rise / room);
  const double run = rise / tangent, left = random.uniform(ground.cell, ground.width - ground.cell - crest - 2.0 * run);
  return {{0.0, toe},
          {left, toe},
          {left + run, toe + rise},
          {left + run + crest, toe + rise},
          {left + 2.0 * run + crest, toe},
          {ground.width, toe}};
}

void mirror(RandomGround& ground) {
  ground.mirrored = true;
  std::ranges::reverse(ground.line);
  for (Point& point : ground.line) point[0] = ground.width - point[0];
}

}  // namespace

double RandomGround::height_at(double x) const {
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Point &a = line[i - 1], &b = line[i];
    if (x <= b[0]) return a[1] + (b[1] - a[1]) * std::clamp((x - a[0]) / (b[0] - a[0]), 0.0, 1.0);
  }
  return line.back()[1];
}

double RandomGround::lowest(double from, double to) const {
  double least = std::min(height_at(from), height_at(to));
  for (const Point& point : line) {
    if (point[0] >= from && point[0] <= to) least = std::min(least, point[1]);
  }
  return least;
}

double RandomGround::spacing() const {
  return cell / std::sqrt(particles_per_cell);
}

RandomGround random_ground(RandomNumbers& random) {
  RandomGround ground;
  ground.cell = random.one_of({0.25, 0.4, 0.5, 0.5, 1.0});
  ground.particles_per_cell = random.one_of({1, 4, 4, 4, 4, 9});
  const bool fine = ground.particles_per_cell == 9;
  ground.width = ground.cell * random.whole(9, fine ? 11 : 16);
  const int below = random.whole(2, 3), above = random.whole(2, fine ? 3 : 5);
  ground.height = ground.cell * (below + above + 2);
  const double toe = ground.cell * below, rise = ground.cell * (above - random.uniform(0.0, 0.9));
  switch (random.index({0.12, 0.5, 0.18, 0.2})) {
    case 0:
      ground.word = "level";
      ground.line = {{0.0, toe + rise}, {ground.width, toe + rise}};
      break;
    case 1:
      ground.word = "slope";
      ground.line = faces(random, ground, toe, rise, 1);
      break;
    case 2:
      ground.word = "benches";
      ground.line = faces(random, ground, toe, rise, random.whole(2, 3));
      break;
    default:
      ground.word = "embankment";
      ground.line = embankment(random, ground, toe, rise);
  }
  if (random.chance(0.5)) mirror(ground);
  const auto by_height = [](const Point& a, const Point& b) { return a[1] < b[1]; };
  const auto [low, high] = std::minmax_element(ground.line.begin(), ground.line.end(), by_height);
  ground.low = (*low)[1], ground.high = (*high)[1];
  return ground;
}

RandomRegion random_layer(RandomNumbers& random, const RandomGround& ground) {
  const double least = 1.2 * ground.cell;
  if (random.chance(0.5) || ground.low < 2.0 * least) {  // goes along with the ground
    const double share = random.uniform(0.3, 0.8);
    std::vector<Point> polygon{{0.0, 0.0}, {ground.width, 0.0}};
    for (auto point = ground.line.rbegin(); point != ground.line.rend(); ++point)
      polygon.push_back({(*point)[0], share * (*point)[1]});
    return {polygon, "layer along"};
  }
  const double left = random.uniform(least, ground.low), right = random.uniform(least, ground.low);
  return {{{0.0, 0.0}, {ground.width, 0.0}, {ground.width, right}, {0.0, left}}, "layer"};
}

RandomRegion random_lens(RandomNumbers& random, const RandomGround& ground) {
  const double half_width = ground.cell * random.uniform(1.2, 4.0),
               half_height = ground.cell * random.uniform(0.6, 1.0);
  const double x = random.uniform(half_width, ground.width - half_width);
  const double top = std::max(ground.lowest(x - half_width, x + half_width), 2.0 * half_height);
  const double y = random.uniform(half_height, top - half_height);
  return {{{x - half_width, y},
           {x - 0.5 * half_width, y - half_height},
           {x + 0.5 * half_width, y - half_height},
           {x + half_width, y},
           {x + 0.5 * half_width, y + half_height},
           {x - 0.5 * half_width, y + half_height}},
          "lens"};
}

}  // namespace slope::random_cases
