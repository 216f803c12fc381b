#include "slope/solid/mohr_coulomb.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "slope/solid/shear_strength.hpp"

namespace slope::solid {

namespace {

// No friction angle exceeds a right one.
double friction_within_right_angle(double angle) {
  return std::min(angle, 0.5 * std::numbers::pi);
}

// Principal stresses of plane strain: two in the plane, with their directions, and sigma_zz.
struct Principal {
  double larger, smaller;  // in the plane
  double cosine, sine;     // of twice the angle from x to the direction of the larger one

  explicit Principal(const SymmetricTensor& t) {
    const double centre = 0.5 * (t.xx + t.yy), half = 0.5 * (t.xx - t.yy);
    const double radius = std::sqrt(half * half + t.xy * t.xy);
    larger = centre + radius;
    smaller = centre - radius;
    cosine = radius > 0.0 ? half / radius : 1.0;
    sine = radius > 0.0 ? t.xy / radius : 0.0;
  }
};

// sigma_1 >= sigma_2 >= sigma_3, and which of them is sigma_zz.
struct Ordered {
  double major, middle, minor;
  enum class Rank { major, middle, minor } out_of_plane;

  Ordered(const Principal& p, double zz) {
    if (zz >= p.larger) {
      *this = {zz, p.larger, p.smaller, Rank::major};
    } else if (zz > p.smaller) {
      *this = {p.larger, zz, p.smaller, Rank::middle};
    } else {
      *this = {p.larger, p.smaller, zz, Rank::minor};
    }
  }

  [[nodiscard]] SymmetricTensor tensor(const Principal& p) const {
    double larger = major, smaller = minor, zz = middle;
    if (out_of_plane == Rank::major) {
      larger = middle;
      zz = major;
    } else if (out_of_plane == Rank::minor) {
      smaller = middle;
      zz = minor;
    }
    const double centre = 0.5 * (larger + smaller), radius = 0.5 * (larger - smaller);
    return {centre + radius * p.cosine, centre - radius * p.cosine, zz, radius * p.sine};
  }

 private:
  Ordered(double first, double second, double third, Rank zz)
      : major(first), middle(second), minor(third), out_of_plane(zz) {}
};

double yield_function(const YieldPyramid& pyramid, double major, double minor) {
  return major - minor + (major + minor) * pyramid.sin_friction - 2.0 * pyramid.c_cos_friction;
}

}  // namespace

double YieldPyramid::value(const SymmetricTensor& stress) const {
  const Ordered s(Principal(stress), stress.zz);
  return yield_function(*this, s.major, s.minor);
}

double YieldPyramid::shear_along_slip(double normal_stress) const {
  const double cos_dilatancy = std::sqrt(1.0 - sin_dilatancy * sin_dilatancy);
  return cos_dilatancy * (c_cos_friction - normal_stress * sin_friction) / (1.0 - sin_friction * sin_dilatancy);
}

SuctionDependentPyramid::SuctionDependentPyramid(const MohrCoulomb& strength) : strength_(strength) {
  const ShearStrength now = shear_strength(strength, 0.0, 0.0);
  cos_friction_ = std::cos(now.friction_angle);
  saturated_ = {std::sin(now.friction_angle), std::sin(now.dilatancy_angle), now.cohesion * cos_friction_};
}

YieldPyramid SuctionDependentPyramid::at(double suction, double plastic_strain) const {
  const bool softened = has_softened(strength_, plastic_strain);
  if (suction <= 0.0 && !softened) return saturated_;
  const ShearStrength now = shear_strength(strength_, suction, plastic_strain);
  if (strength_.friction_angle_suction_rate == 0.0 && !softened) {
    return {saturated_.sin_friction, saturated_.sin_dilatancy, now.cohesion * cos_friction_};
  }
  const double angle = friction_within_right_angle(now.friction_angle);
  return {std::sin(angle), std::sin(now.dilatancy_angle), now.cohesion * std::cos(angle)};
}

Return return_to_yield_surface(const YieldPyramid& pyramid, const Elastic& elastic, SymmetricTensor& stress) {
  const Principal principal(stress);
  Ordered s(principal, stress.zz);
  const double sin_phi = pyramid.sin_friction, sin_psi = pyramid.sin_dilatancy;
  const double f = yield_function(pyramid, s.major, s.minor);
  if (f <= 0.0) return Return::elastic;

  const double shear = elastic.shear_modulus(), bulk = elastic.bulk_modulus();
  const double volumetric = 2.0 * (bulk - 2.0 / 3.0 * shear) * sin_psi;
  // how f falls with the flow of its own plane
  const double own = 2.0 * volumetric * sin_phi + 4.0 * shear * (1.0 + sin_phi * sin_psi);
  const double multiplier = f / own;
  // flow at which sigma_2 becomes the largest or the smallest stress
  const double to_major = (s.major - s.middle) / (2.0 * shear * (1.0 + sin_psi));
  const double to_minor = (s.middle - s.minor) / (2.0 * shear * (1.0 - sin_psi));
  if (multiplier <= std::min(to_major, to_minor)) {
    s.major -= multiplier * (volumetric + 2.0 * shear * (1.0 + sin_psi));
    s.middle -= multiplier * volumetric;
    s.minor -= multiplier * (volumetric - 2.0 * shear * (1.0 - sin_psi));
    stress = s.tensor(principal);
    return Return::face;
  }

  // On an edge two planes flow. Both lose alike by the flow of both, so the sum of their multipliers is known, and with
  // it the mean stress; f = 0 and the equality of two stresses give the rest.
  const bool upper = to_major < to_minor;  // sigma_1 = sigma_2
  const double side = upper ? -1.0 : 1.0;
  const double other_f =
      upper ? yield_function(pyramid, s.middle, s.minor) : yield_function(pyramid, s.major, s.middle);
  const double both = own + 2.0 * volumetric * sin_phi + 2.0 * shear * (1.0 + side * sin_phi) * (1.0 + side * sin_psi);
  const double mean = (s.major + s.middle + s.minor) / 3.0 - 2.0 * bulk * sin_psi * (f + other_f) / both;
  // what the yield function leaves to sigma_1 - sigma_3 at that mean stress; negative beyond the tip
  const double difference = 2.0 * (pyramid.c_cos_friction - mean * sin_phi) / (1.0 + side * sin_phi / 3.0);
  if (difference >= 0.0) {
    s.major = mean + (upper ? 1.0 : 2.0) / 3.0 * difference;
    s.minor = mean - (upper ? 2.0 : 1.0) / 3.0 * difference;
    s.middle = upper ? s.major : s.minor;
    stress = s.tensor(principal);
    return Return::edge;
  }
  const double tip = pyramid.c_cos_friction / sin_phi;
  stress = {tip, tip, tip, 0.0};
  return Return::apex;
}

}  // namespace slope::solid
