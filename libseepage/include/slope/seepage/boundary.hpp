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

/// Water that enters a particle (m2/s per metre of thickness), positive inwards.
struct Inflow {
  std::uint32_t particle = 0;
  std::uint32_t boundary = 0;
  double rate = 0.0;
};

/// What acts on the pore water during one step. A particle appears at most once in `held`, and then not in
/// `open_faces`.
struct Boundary {
  std::vector<HeldPressure> held;
  std::vector<FacePressure> faces;
  std::vector<Inflow> inflows;
  std::vector<OpenFace> open_faces;
  std::size_t count = 0;  ///< number of boundaries that water is counted for
};

}  // namespace slope::seepage
