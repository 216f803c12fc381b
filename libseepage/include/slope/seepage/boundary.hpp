#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "slope/seepage/open_face.hpp"

namespace slope::seepage {

/// The pressure of a particle is prescribed.
struct HeldPressure {
  std::uint32_t particle = 0;
  std::uint32_t boundary = 0;  ///< which budget the water counts in
  double pressure = 0.0;       ///< P_w at the end of the step (Pa)
};

/// The pressure of a face is prescribed, half a spacing away from its particle.
struct FacePressure {
  std::uint32_t particle = 0;
  std::uint32_t boundary = 0;
  double pressure = 0.0;  ///< P_w at the face at the end of the step (Pa)
  double rise = 0.0;      ///< height of the face above the particle (m), negative below
  double distance = 0.0;  ///< of the face from the particle (m), > 0
  double area = 0.0;      ///< of the face per metre of thickness (m), > 0
};

/// An open face while its pressure is held (Pa).
[[nodiscard]] inline FacePressure held_at(const OpenFace& face, double pressure) {
  return {face.particle, face.boundary, pressure, face.rise, face.distance, face.area};
}

/// Water that enters a particle (m2/s per metre of thickness), positive inwards.
struct Inflow {
  std::uint32_t particle = 0;
  std::uint32_t boundary = 0;
  double rate = 0.0;
};

/// Water leaves a particle downwards by its own weight, with a head that falls by one metre per metre (free drainage):
/// the soil goes on below as it is here, and the water table is far down.
struct Drain {
  std::uint32_t particle = 0;
  std::uint32_t boundary = 0;
  double width = 0.0;  ///< horizontal (m), > 0
};

/// What acts on the pore water during one step. A particle appears at most once in `held`, and then not in
/// `open_faces`.
struct Boundary {
  std::vector<HeldPressure> held;
  std::vector<FacePressure> faces;
  std::vector<Inflow> inflows;
  std::vector<OpenFace> open_faces;
  std::vector<Drain> drains;
  std::size_t count = 0;  ///< number of boundaries that water is counted for
};

}  // namespace slope::seepage
