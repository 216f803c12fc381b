#pragma once

#include "slope/seepage/mean_conductivity.hpp"

namespace slope::seepage {

/// A face whose pressure is given, and the soil between it and its particle.
struct HeldFace {
  PotentialAt face;
  PotentialAt particle;
  double conductivity_slope = 0.0;  ///< of the particle's conductivity over its pressure head (1/s), >= 0
  double rise = 0.0;                ///< height of the face above the particle (m), negative below
  double distance = 0.0;            ///< of the face from the particle (m), > 0: half a spacing

  /// Fall of the hydraulic head from the face to the particle (m).
  [[nodiscard]] double fall() const { return face.pressure_head - particle.pressure_head + rise; }
};

/// What has come in through a face since it began to wet its particle.
struct WettingFront {
  PotentialAt start;          ///< of the particle's soil, before that
  double filled = 0.0;        ///< share of the pores that the face's pressure fills between that and now (-)
  double filled_slope = 0.0;  ///< over the particle's pressure head (1/m), >= 0
};

/// Flow into the soil through a square metre of face.
struct FaceFlow {
  double flux = 0.0;   ///< (m/s), positive inwards
  double slope = 0.0;  ///< over the particle's pressure head (1/s), <= 0
};

/// Through half a spacing in which the pressure goes over steadily from the face's to the particle's: the
/// kirchhoff_mean() times the gradient of the head.
[[nodiscard]] FaceFlow settled_flow(const HeldFace& face);

/// As far as a sharp front that is still within the particle's spacing 2 d: the soil behind it is as wet as the face
/// makes it, so that it is l = 2 d s / f deep when a share s of the pores is filled, and before it as at the start,
///
///     q = K_0 n + (Phi_f - Phi_0) / (l phi(-a n l)),   a = (K_f - K_0) / (Phi_f - Phi_0),   phi(t) = (e^t - 1) / t,
///
/// n = rise / d: the exact steady flow through exponential soil (after Green and Ampt 1911). f = 0.95 stands for how
/// sharp the front is: by Parlange's integral it is 0.84 to 0.96 in the twelve USDA textures, 3/4 under a constant
/// diffusivity, 1 for a step. From s = 0.02 on; less counts as that.
[[nodiscard]] FaceFlow flow_to_front(const HeldFace& face, const WettingFront& front);

/// Flow through a face that wets a particle: to the front while that is within the particle's half next to the face,
/// and the lesser of both afterwards, when either the front or the far side of the particle holds the water up. It
/// never rises with the particle's pressure. A settled_flow() alone has the front half a spacing away from the first
/// drop on: dry loam on particles of 0.25 m took in a third less in an hour or two than it does.
[[nodiscard]] FaceFlow wetting_flow(const HeldFace& face, const WettingFront& front);

}  // namespace slope::seepage
