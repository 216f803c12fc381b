#include "slope/seepage/face_flow.hpp"

#include <algorithm>

#include "exponential_fitting.hpp"

namespace slope::seepage {

namespace {

constexpr double sharpness = 0.95;  // f
constexpr double least_filled = 0.02;
// Between these shares of filled pores the front gives way to the particle's own pressure.
constexpr double within_first_quarter = 0.25, half_way = 0.5;

}  // namespace

FaceFlow settled_flow(const HeldFace& face) {
  const double mean = kirchhoff_mean(face.face, face.particle, face.rise);
  const double mean_slope = kirchhoff_mean_slope(face.particle, face.face, -face.rise, face.conductivity_slope);
  const double fall = face.fall();
  return {mean * fall / face.distance, (mean_slope * fall - mean) / face.distance};
}

FaceFlow flow_to_front(const HeldFace& face, const WettingFront& front) {
  const double scale = 2.0 * face.distance / sharpness;
  const double depth = scale * std::max(front.filled, least_filled);
  const double depth_slope = front.filled > least_filled ? scale * front.filled_slope : 0.0;
  const double steep = face.rise / face.distance;
  const double more = face.face.conductivity - front.start.conductivity;
  const double gain = face.face.potential - front.start.potential;
  const double x = more / gain * steep * depth;
  const double suction = gain / (depth * phi(-x));
  return {front.start.conductivity * steep + suction, suction * (x * log_phi_slope(-x) - 1.0) / depth * depth_slope};
}

FaceFlow wetting_flow(const HeldFace& face, const WettingFront& front) {
  const FaceFlow settled = settled_flow(face);
  if (front.filled >= 1.0) return settled;
  const FaceFlow to_front = flow_to_front(face, front);
  const double more = to_front.flux - settled.flux;
  if (more <= 0.0) return to_front;
  if (front.filled >= half_way) return settled;
  if (front.filled <= within_first_quarter) return to_front;
  constexpr double slope = 1.0 / (half_way - within_first_quarter);
  const double share = (half_way - front.filled) * slope;
  return {settled.flux + share * more,
          settled.slope + share * (to_front.slope - settled.slope) - slope * front.filled_slope * more};
}

}  // namespace slope::seepage
