#include "slope/seepage/face_flow.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "slope/seepage/conductivity_curve.hpp"

namespace slope::seepage {
namespace {

struct Ground {
  explicit Ground(double alpha, double n) {
    const SaturationRange range{0.15, 1.0};
    soil.retention = VanGenuchten{.alpha = alpha, .n = n, .range = range};
    soil.relative_permeability.law = VanGenuchtenMualem{.n = n, .range = range};
    soil.hydraulic_conductivity = 1.0e-6;
    curve.emplace(soil);
  }
  [[nodiscard]] PotentialAt at(double pressure_head) const {
    const ConductivityCurve::Value value = curve->at(pressure_head);
    return {value.conductivity, pressure_head, value.potential};
  }
  [[nodiscard]] Saturation saturation(double pressure_head) const { return evaluate(soil.retention, -pressure_head); }

  // Through a face at a pressure, into a particle half a metre times `size` away, that was at `start`.
  [[nodiscard]] FaceFlow wetting(double face, double particle, double start, double size, double steep = 1.0) const {
    const Saturation now = saturation(particle);
    const double dry = saturation(start).saturation, room = saturation(face).saturation - dry;
    return wetting_flow(held(face, particle, size, steep),
                        {at(start), (now.saturation - dry) / room, -now.slope / room});
  }
  [[nodiscard]] HeldFace held(double face, double particle, double size, double steep = 1.0) const {
    return {at(face), at(particle), curve->at(particle).slope, 0.5 * size * steep, 0.5 * size};
  }

  Soil soil;
  std::optional<ConductivityCurve> curve;
};

const std::vector<Ground>& grounds() {
  static const std::vector<Ground> all{Ground(14.5, 2.68), Ground(3.6, 1.56), Ground(2.0, 1.41), Ground(0.5, 3.0)};
  return all;
}

TEST(FaceFlow, IsStillUnderAUniformHead) {
  for (const Ground& ground : grounds()) {
    for (const double steep : {1.0, 0.4, 0.0}) {
      for (const double face : {-3.0, -0.4, 0.0, 0.7}) {
        const double particle = face + 0.1 * steep;
        EXPECT_NEAR(settled_flow(ground.held(face, particle, 0.2, steep)).flux, 0.0, 1e-20);
        EXPECT_NEAR(ground.wetting(face, particle, face - 4.0, 0.2, steep).flux, 0.0, 1e-20);
      }
    }
  }
}

TEST(FaceFlow, NeverRisesWithThePressureOfTheParticleAndHasItsSlope) {
  for (const Ground& ground : grounds()) {
    for (const double size : {0.02, 0.25, 1.0}) {
      for (const double start : {-0.6, -15.0}) {
        for (const double steep : {1.0, 0.3, 0.0}) {
          double before = std::numeric_limits<double>::infinity();
          for (double h = 1.5 * -start; h > 1.0e-4; h *= 0.98) {
            const FaceFlow flow = ground.wetting(0.0, -h, start, size, steep);
            EXPECT_LE(flow.flux, before * (1.0 + 1.0e-9)) << size << " " << start << " " << h;
            EXPECT_LE(flow.slope, 1.0e-9 * flow.flux);
            before = flow.flux;
            const double step = 1.0e-5 * h;
            const FaceFlow wetter = ground.wetting(0.0, -h + step, start, size, steep);
            const FaceFlow drier = ground.wetting(0.0, -h - step, start, size, steep);
            if (std::abs(wetter.slope - drier.slope) > 1.0e-3 * std::abs(flow.slope)) continue;  // a kink
            EXPECT_NEAR(flow.slope, (wetter.flux - drier.flux) / (2.0 * step),
                        2.0e-3 * std::abs(flow.slope) + 1.0e-9 * flow.flux / size + 1.0e-15 * flow.flux / step)
                << size << " " << start << " " << h;
          }
        }
      }
    }
  }
}

// Green and Ampt: K (1 + potential / (K l)) to a sharp front at the depth l, here within what its shape is worth.
TEST(FaceFlow, GoesToTheFrontWhileThatIsNear) {
  const Ground& sand = grounds()[0];
  const PotentialAt wet = sand.at(0.0), dry = sand.at(-10.0);
  for (const double filled : {0.05, 0.1, 0.25}) {
    const HeldFace face = sand.held(0.0, -10.0, 0.25);
    const WettingFront front{dry, filled, 0.0};
    const double depth = 0.25 * filled;
    const double sharp = wet.conductivity + (wet.potential - dry.potential) / depth;
    EXPECT_NEAR(wetting_flow(face, front).flux / sharp, 1.0, 0.3) << filled;
    EXPECT_GT(wetting_flow(face, front).flux, settled_flow(face).flux);
  }
  EXPECT_DOUBLE_EQ(wetting_flow(sand.held(0.0, -0.01, 0.25), {dry, 1.0, 0.0}).flux,
                   settled_flow(sand.held(0.0, -0.01, 0.25)).flux)
      << "of a particle that is full";
}

}  // namespace
}  // namespace slope::seepage
