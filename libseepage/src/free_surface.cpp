#include "slope/seepage/free_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "moved_beyond.hpp"
#include "require.hpp"
#include "slope/seepage/neighbours.hpp"

namespace slope::seepage {

namespace {

constexpr double pi = std::numbers::pi;
// In spacings. Four particles of a lattice, each displaced by 0.13, still cover what is between them.
constexpr double disc_radius = 0.9;
constexpr double follow_distance = 0.05;
constexpr double least_arc = pi / 6.0;  // of a disc's rim; a flat surface has 67 degrees, the inner edge of a step 40
constexpr double strips_per_spacing = 16.0;
constexpr double reach = 1.0;  // how far, in spacings, a particle may be from a strip that it takes

// An arc of a rim, by its beginning and its length, counterclockwise (rad).
struct Arc {
  double from, length;
};

// What the covered arcs leave of a rim: the widest free arc and, of equal ones, that which faces upwards most.
Arc widest_free(std::vector<Arc>& covered) {
  if (covered.empty()) return {-0.5 * pi, 2.0 * pi};
  std::ranges::sort(covered, {}, &Arc::from);
  const double tie = 1.0e-6;
  Arc widest{0.0, 0.0};
  double reached = covered.front().from + covered.front().length;
  const auto look_at = [&](double next) {
    const Arc free{reached, next - reached};
    const auto upwards = [](const Arc& arc) { return std::sin(arc.from + 0.5 * arc.length); };
    const bool wider = free.length > widest.length + tie;
    if (wider || (free.length > widest.length - tie && upwards(free) > upwards(widest))) widest = free;
  };
  for (const Arc& arc : covered) {
    if (arc.from > reached) look_at(arc.from);
    reached = std::max(reached, arc.from + arc.length);
  }
  const double whole = covered.front().from + 2.0 * pi;
  if (whole > reached) look_at(whole);
  return widest;
}

// The coordinate and its mirror images at two walls.
std::array<double, 3> with_images(double at, double low_wall, double high_wall) {
  return {at, 2.0 * low_wall - at, 2.0 * high_wall - at};
}

}  // namespace

FreeSurface::FreeSurface(double spacing, const MirrorWalls& walls) : spacing_(spacing), walls_(walls) {
  require_above(0.0, "spacing", spacing);
  walls.check();
}

bool FreeSurface::update(const Skeleton& skeleton) {
  if (state_.x.size() == skeleton.size() && !moved_beyond(follow_distance * spacing_, skeleton, state_.x, state_.y)) {
    return false;
  }
  state_.x.assign(skeleton.x.begin(), skeleton.x.end());
  state_.y.assign(skeleton.y.begin(), skeleton.y.end());
  find_pieces();
  find_widths();
  return true;
}

void FreeSurface::set_state(State state) {
  if (state.x.size() != state.y.size()) throw std::invalid_argument("the free surface's arrays differ in length");
  state_ = std::move(state);
  find_pieces();
  find_widths();
}

void FreeSurface::find_pieces() {
  pieces_.clear();
  const double diameter = 2.0 * disc_radius * spacing_;
  const Neighbours neighbours = find_neighbours(state_.x, state_.y, diameter);
  std::vector<Arc> covered;
  for (std::size_t p = 0; p < state_.x.size(); ++p) {
    const double px = state_.x[p], py = state_.y[p];
    covered.clear();
    const auto cover = [&](double x, double y) {
      const double dx = x - px, dy = y - py;
      const double r = std::hypot(dx, dy);
      if (!(r < diameter)) return;
      const double half = std::acos(r / diameter);
      covered.push_back({std::atan2(dy, dx) - half, 2.0 * half});
    };
    const auto cover_all = [&](std::size_t q) {
      const auto xs = with_images(state_.x[q], walls_.left, walls_.right);
      const auto ys = with_images(state_.y[q], walls_.base, walls_.top);
      for (std::size_t i = 0; i < xs.size(); ++i) {
        for (std::size_t j = 0; j < ys.size(); ++j) {
          if (q != p || i > 0 || j > 0) cover(xs[i], ys[j]);
        }
      }
    };
    for (const std::uint32_t q : neighbours.of(p)) cover_all(q);
    cover_all(p);
    const Arc free = widest_free(covered);
    if (free.length < least_arc) continue;
    const double chord = 2.0 * disc_radius * std::sin(0.5 * std::min(free.length, pi));
    const double direction = free.from + 0.5 * free.length;
    pieces_.push_back({static_cast<std::uint32_t>(p), std::cos(direction), std::sin(direction), spacing_ * chord, 0.0});
  }
}

void FreeSurface::find_widths() {
  if (pieces_.empty()) return;
  double left = std::numeric_limits<double>::infinity(), right = -left;
  for (const SurfacePiece& piece : pieces_) {
    left = std::min(left, state_.x[piece.particle]);
    right = std::max(right, state_.x[piece.particle]);
  }
  // soil this close to a wall reaches up to it
  left = left - walls_.left < spacing_ ? walls_.left : left - 0.5 * spacing_;
  right = walls_.right - right < spacing_ ? walls_.right : right + 0.5 * spacing_;
  const double count = std::max(1.0, std::round((right - left) / spacing_ * strips_per_spacing));
  const double strip = (right - left) / count;

  // the taker of each strip: the highest of those above which it lies, else the nearest
  struct Taker {
    SurfacePiece* piece = nullptr;
    bool above = false;
    double height = 0.0, distance = 0.0;
  };
  std::vector<Taker> takers(static_cast<std::size_t>(count));
  const double half = (0.5 + 1.0e-6) * spacing_;
  for (SurfacePiece& piece : pieces_) {
    const double x = state_.x[piece.particle], y = state_.y[piece.particle];
    const double first = std::max(0.0, std::ceil((x - reach * spacing_ - left) / strip - 0.5));
    for (double k = first; k < count; ++k) {
      const double distance = std::abs(left + (k + 0.5) * strip - x);
      if (distance > reach * spacing_) break;
      const Taker now{&piece, distance < half, y, distance};
      Taker& taker = takers[static_cast<std::size_t>(k)];
      const bool better = taker.piece == nullptr || (now.above && !taker.above) ||
                          (now.above && taker.above && now.height > taker.height) ||
                          (!now.above && !taker.above && now.distance < taker.distance);
      if (better) taker = now;
    }
  }
  for (const Taker& taker : takers) {
    if (taker.piece != nullptr) taker.piece->width += strip;
  }
}

}  // namespace slope::seepage
