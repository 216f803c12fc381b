#pragma once

#include <cstddef>
#include <cstdint>
#include <variant>
#include <vector>

#include "slope/seepage/drain.hpp"
#include "slope/seepage/face_pressure.hpp"
#include "slope/seepage/inflow.hpp"
#include "slope/seepage/open_face.hpp"

namespace slope::seepage {

/// The pressure of a particle is prescribed.
struct HeldPressure {
  std::uint32_t particle = 0;
  std::uint32_t boundary = 0;  ///< which budget the water counts in
  double pressure = 0.0;       ///< P_w at the end of the step (Pa)
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

  /// Calls visit(list) for the lists of conditions that have a law, in the order in which they add up.
  template <class Self, class Visit>
  static void for_each_list(Self& s, const Visit& visit) {
    visit(s.faces);
    visit(s.inflows);
    visit(s.drains);
    visit(s.open_faces);
  }
  void clear() {
    held.clear();
    for_each_list(*this, [](auto& list) { list.clear(); });
  }
};

/// The law of one condition: what comes in over the head of the particle. Each is, in its own file beside its
/// condition, made by law_of() and has
///
///     inflow(h)            the part of it that stands in the equations, linear in the head h (m2/s)
///     stiffness()          by how much that falls with h (m/s), >= 0
///     conductance_slope()  what the slope of a conductance adds to that of the inflow, for Newton's method (m/s)
///     follow(h)            takes the part that holds at a head into the equations; whether that is another one
///     exchange(h)          what the law itself lets in (m2/s)
using BoundaryLaw = std::variant<FaceLaw, InflowLaw, DrainLaw, OpenFaceLaw>;

}  // namespace slope::seepage
