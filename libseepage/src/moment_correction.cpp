#include "moment_correction.hpp"

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "for_each_index.hpp"
#include "slope/seepage/conjugate_gradients.hpp"

namespace slope::seepage {

namespace {

// The two kinds of moments are corrected in turn. A sweep for the second moments reduces what is left about fivefold,
// an iteration for the first moments by half.
constexpr int rounds = 2;
constexpr int second_moment_sweeps = 2;
constexpr int first_moment_iterations = 4;
// Bounds of a correction: they keep every conductance positive.
constexpr double least_correction = 0.1;
constexpr double largest_correction = 4.0;
// Asymmetry of a neighbourhood, relative to that at a flat surface, from which a particle begins to count as one of the
// surface and at which it does in full. Displacements of a tenth of the spacing make at most 0.33 inside and at least
// 0.84 at the surface.
constexpr double surface_begins = 0.45;
constexpr double surface_full = 0.75;
// Radius, in spacings, of the discs whose outline is the surface: those of a lattice whose particles are displaced by
// 0.13 leave no gap, and particles of an inclined surface, up to 1.41 apart, still touch.
constexpr double disc_radius = 0.9;
// Second moments are left alone where surfaces of two directions are in reach; this many times the smaller over the
// larger principal value of the surface normals' moment.
constexpr double corner_reach = 8.0;

const double root_two = std::sqrt(2.0);

double ramp(double x, double from, double to) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// How far a neighbour counts towards the asymmetry: less steep than the kernel's gradient, so that disorder inside is
// told from a surface.
double nearness(double r, double support) {
  const double t = std::max(0.0, 1.0 - r / support);
  return t * t;
}

double along(double x, double y, double xx, double xy, double yy) {
  return x * x * xx + 2.0 * x * y * xy + y * y * yy;
}

}  // namespace

MomentCorrection::MomentCorrection(const Images& images, std::span<const double> volume, const WendlandC2& kernel,
                                   double spacing, int threads)
    : images_(images),
      threads_(threads),
      at_surface_(images.size()),
      first_moment_(images.size()),
      free_of_(images.size()),
      response_(images.size()),
      tensor_(images.size()),
      vector_(2 * images.size()) {
  find_surface(volume, kernel, spacing);
  find_surface_layer();
  find_responses();
  std::vector<Tensor> old = tensor_;
  for (int round = 0; round < rounds; ++round) {
    for (int sweep = 0; sweep < second_moment_sweeps; ++sweep) {
      std::swap(old, tensor_);
      sweep_second_moments(old);
    }
    correct_first_moments(volume);
  }
}

double MomentCorrection::operator()(std::size_t p, const Image& image) const {
  return std::clamp(even_part(tensor_, p, image) + odd_part(p, image), least_correction, largest_correction);
}

// 1 + e.(B_p + B_q).e / 2
double MomentCorrection::even_part(const std::vector<Tensor>& tensor, std::size_t p, const Image& image) const {
  const Tensor& b_p = tensor[p];
  const Tensor& b_q = tensor[image.particle];
  const double parity = image.flip_x * image.flip_y;
  return 1.0 + 0.5 * along(image.ex, image.ey, b_p.xx + b_q.xx, b_p.xy + parity * b_q.xy, b_p.yy + b_q.yy);
}

// (a_p - a_q).e
double MomentCorrection::odd_part(std::size_t p, const Image& image) const {
  const double* a_p = &vector_[2 * p];
  const double* a_q = &vector_[2 * static_cast<std::size_t>(image.particle)];
  return image.ex * (a_p[0] - image.flip_x * a_q[0]) + image.ey * (a_p[1] - image.flip_y * a_q[1]);
}

double MomentCorrection::flat_asymmetry(const WendlandC2& kernel, double spacing) {
  const int reach = static_cast<int>(std::ceil(kernel.support() / spacing));
  double asymmetry = 0.0;
  for (int i = -reach; i <= reach; ++i) {
    for (int j = 1; j <= reach; ++j) {
      asymmetry += nearness(spacing * std::hypot(i, j), kernel.support()) * j * spacing;
    }
  }
  return asymmetry;
}

// The rim that the discs of its neighbours leave free of a particle's disc has a neighbour at either end. The outline
// of the soil runs from neighbour to neighbour, half a spacing outside the lines between them; between the middles of
// its two lines it is the particle's own, so that the pieces of all particles close. @return their outward normals
// times their lengths, in sum (m); `covered` is room to work in
MomentCorrection::Vector MomentCorrection::surface_of(std::size_t p, double spacing, std::vector<Arc>& covered) const {
  const double diameter = 2.0 * disc_radius * spacing;
  covered.clear();
  for (const Image& q : images_.of(p)) {
    if (q.r >= diameter) continue;
    const double to_x = -q.ex, to_y = -q.ey;
    const double direction = std::atan2(to_y, to_x), half = std::acos(q.r / diameter);
    covered.push_back({direction - half, direction + half, {to_x, to_y}, 0.5 * q.r});
  }
  Vector surface{0.0, 0.0};
  if (covered.empty()) return surface;
  std::ranges::sort(covered, {}, &Arc::from);
  const double half_spacing = 0.5 * spacing;
  // the free rim lies to the left of the way to `before` and to the right of the way to `after`
  const auto add = [&](const Arc& before, const Arc& after) {
    const double from_x = before.middle * before.to.x - half_spacing * before.to.y;
    const double from_y = before.middle * before.to.y + half_spacing * before.to.x;
    const double to_x = after.middle * after.to.x + half_spacing * after.to.y;
    const double to_y = after.middle * after.to.y - half_spacing * after.to.x;
    surface.x += to_y - from_y;
    surface.y += from_x - to_x;
  };
  const Arc* last = &covered.front();
  for (const Arc& arc : covered) {
    if (arc.from > last->until) add(*last, arc);
    if (arc.until > last->until) last = &arc;
  }
  if (covered.front().from + 2.0 * std::numbers::pi > last->until) add(*last, covered.front());
  return surface;
}

// Which particles are the outermost, and the first moments wanted.
void MomentCorrection::find_surface(std::span<const double> volume, const WendlandC2& kernel, double spacing) {
  const double flat = flat_asymmetry(kernel, spacing);
  for_each_index(images_.size(), threads_, [&](std::size_t p) {
    thread_local std::vector<Arc> covered;
    Vector asymmetry{0.0, 0.0};
    for (const Image& q : images_.of(p)) {
      const double near = nearness(q.r, kernel.support()) * q.r;
      asymmetry.x += near * q.ex;
      asymmetry.y += near * q.ey;
    }
    at_surface_[p] = ramp(std::hypot(asymmetry.x, asymmetry.y) / flat, surface_begins, surface_full);
    const Vector surface = surface_of(p, spacing, covered);
    first_moment_[p] = {0.5 * surface.x / volume[p], 0.5 * surface.y / volume[p]};
  });
}

// In reach of a flat surface only the direction along it is left, in reach of two none.
void MomentCorrection::find_surface_layer() {
  for_each_index(images_.size(), threads_, [&](std::size_t p) {
    Tensor normals{0.0, 0.0, 0.0};
    double strength = 0.0;
    const auto add = [&](std::size_t q, double parity) {
      if (at_surface_[q] == 0.0) return;
      const Vector& n = first_moment_[q];
      normals.xx += n.x * n.x;
      normals.xy += parity * n.x * n.y;
      normals.yy += n.y * n.y;
      strength = std::max(strength, at_surface_[q]);
    };
    add(p, 1.0);
    for (const Image& q : images_.of(p)) add(q.particle, q.flip_x * q.flip_y);
    free_of_[p] = {1.0, 0.0, 1.0};
    if (strength == 0.0) return;
    const double mean = 0.5 * (normals.xx + normals.yy), half = 0.5 * (normals.xx - normals.yy);
    const double radius = std::hypot(half, normals.xy);
    const double second = strength * std::min(1.0, corner_reach * (mean - radius) / (mean + radius));
    // (1 - second) I + (second - strength) m m, m the principal direction of the normals
    const double c = radius > 0.0 ? half / radius : 1.0, s = radius > 0.0 ? normals.xy / radius : 0.0;
    const double across = 0.5 * (second - strength), rest = 1.0 - second;
    free_of_[p] = {rest + across * (1.0 + c), across * s, rest + across * (1.0 - c)};
  });
}

// In the basis (xx, sqrt(2) xy, yy) the map from a tensor to the moment that it makes is symmetric; it is inverted
// once.
void MomentCorrection::find_responses() {
  for_each_index(images_.size(), threads_, [&](std::size_t p) {
    Eigen::Matrix3d map = Eigen::Matrix3d::Zero();
    for (const Image& q : images_.of(p)) {
      const double xx = q.ex * q.ex, xy = root_two * q.ex * q.ey, yy = q.ey * q.ey;
      const double w = q.weight * q.r * q.r;
      map(0, 0) += w * xx * xx;
      map(1, 0) += w * xx * xy;
      map(2, 0) += w * xx * yy;
      map(1, 1) += w * xy * xy;
      map(2, 1) += w * xy * yy;
      map(2, 2) += w * yy * yy;
    }
    const double size = map.trace();
    if (!(size > 0.0)) {
      response_[p].setZero();
      return;
    }
    map(0, 1) = map(1, 0);
    map(0, 2) = map(2, 0);
    map(1, 2) = map(2, 1);
    map.diagonal().array() += 1.0e-3 * size;  // neighbours in one line determine one component only
    response_[p] = map.inverse();
  });
}

void MomentCorrection::sweep_second_moments(const std::vector<Tensor>& old) {
  for_each_index(images_.size(), threads_, [&](std::size_t p) {
    double xx = 1.0, xy = 0.0, yy = 1.0;  // lack of the second moment
    for (const Image& q : images_.of(p)) {
      const double weight = q.weight * q.r * q.r * (even_part(old, p, q) + odd_part(p, q));
      xx -= weight * q.ex * q.ex;
      xy -= weight * q.ex * q.ey;
      yy -= weight * q.ey * q.ey;
    }
    Eigen::Matrix2d lack, projector;
    lack << xx, xy, xy, yy;
    projector << free_of_[p].xx, free_of_[p].xy, free_of_[p].xy, free_of_[p].yy;
    lack = projector * lack * projector;
    const Eigen::Vector3d change = response_[p] * Eigen::Vector3d(lack(0, 0), root_two * lack(1, 0), lack(1, 1));
    tensor_[p] = {old[p].xx + change[0], old[p].xy + change[1] / root_two, old[p].yy + change[2]};
  });
}

// The vectors solve sum_q V_p w_pq r (a_p - a_q).e = V_p (wanted - first moment of the even part), a symmetric system
// like that of a net of springs. A few iterations take away what varies from particle to particle, which is what
// matters.
void MomentCorrection::correct_first_moments(std::span<const double> volume) {
  const std::size_t n = images_.size();
  std::vector<double> lack(2 * n), diagonal(2 * n);
  for_each_index(n, threads_, [&](std::size_t p) {
    Vector first = first_moment_[p], own{0.0, 0.0};
    for (const Image& q : images_.of(p)) {
      const double w = q.weight * q.r, weight = w * even_part(tensor_, p, q);
      first.x -= weight * q.ex;
      first.y -= weight * q.ey;
      own.x += w * q.ex * q.ex;
      own.y += w * q.ey * q.ey;
    }
    lack[2 * p] = volume[p] * first.x;
    lack[2 * p + 1] = volume[p] * first.y;
    // a particle without neighbours keeps its zero
    diagonal[2 * p] = own.x > 0.0 ? volume[p] * own.x : 1.0;
    diagonal[2 * p + 1] = own.y > 0.0 ? volume[p] * own.y : 1.0;
  });
  const double stiffening = 1.0e-4;  // a net that floats freely has no unique solution
  const auto apply = [&](std::span<const double> in, std::span<double> out) {
    for_each_index(n, threads_, [&](std::size_t p) {
      const double x = in[2 * p], y = in[2 * p + 1];
      double sum_x = 0.0, sum_y = 0.0;
      for (const Image& q : images_.of(p)) {
        const std::size_t k = 2 * static_cast<std::size_t>(q.particle);
        const double w = q.weight * q.r * (q.ex * (x - q.flip_x * in[k]) + q.ey * (y - q.flip_y * in[k + 1]));
        sum_x += w * q.ex;
        sum_y += w * q.ey;
      }
      out[2 * p] = volume[p] * sum_x + stiffening * diagonal[2 * p] * x;
      out[2 * p + 1] = volume[p] * sum_y + stiffening * diagonal[2 * p + 1] * y;
    });
  };
  ConjugateGradients solver;
  solver.solve(apply, diagonal, lack, vector_, 1.0e-3, first_moment_iterations, threads_);
}

}  // namespace slope::seepage
