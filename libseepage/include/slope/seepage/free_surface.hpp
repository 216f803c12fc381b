#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "slope/seepage/skeleton.hpp"

namespace slope::seepage {

/// A particle of the free surface and the piece of it that is the particle's own.
struct SurfacePiece {
  std::uint32_t particle = 0;
  double nx = 0.0, ny = 1.0;  ///< outward normal
  double area = 0.0;          ///< per metre of thickness (m), > 0
  double width = 0.0;         ///< what is seen of it from straight above (m), >= 0: what vertical rain falls on
};

/// The free surface of a set of particles: where soil meets air.
///
/// A particle belongs to it if discs of 0.9 spacings around its neighbours (and their images behind the walls) leave at
/// least 30 degrees of its own disc's rim free; its piece is the chord of the widest free arc. Each particle of a flat
/// surface of a lattice so gets one spacing, whatever the surface's direction; the pieces along a surface follow each
/// other without gaps. Gaps narrower than about 0.8 spacings between particles are no surface; a wider hole inside is.
///
/// The widths are found on vertical strips of a sixteenth of the spacing: a strip belongs to the highest of the surface
/// particles that lie within half a spacing, or where there is none to the nearest within a whole one. They add up to
/// the horizontal extent of the soil; an overhang or a block shades what is below, and a vertical face gets nothing.
class FreeSurface {
 public:
  struct State {
    std::vector<double> x, y;  ///< positions of the particles when the surface was found (m); empty: not yet

    template <class Self, class Visit>
    static void for_each_field(Self& s, const Visit& visit) {
      visit("x", s.x), visit("y", s.y);
    }
    bool operator==(const State&) const = default;
  };

  /// @param spacing  of the particles (m), > 0
  /// @throws std::invalid_argument naming the field that is out of its range
  FreeSurface(double spacing, const MirrorWalls& walls);

  /// Follows the particles; finds the surface anew when one has moved by more than a twentieth of the spacing since the
  /// last time. @return whether it did.
  bool update(const Skeleton& skeleton);

  [[nodiscard]] const State& state() const { return state_; }
  /// Goes on from a state. @throws std::invalid_argument if its arrays differ in length
  void set_state(State state);

  /// In ascending order of the particles.
  [[nodiscard]] std::span<const SurfacePiece> pieces() const { return pieces_; }

 private:
  void find_pieces();
  void find_widths();

  double spacing_;
  MirrorWalls walls_;
  State state_;
  std::vector<SurfacePiece> pieces_;
};

}  // namespace slope::seepage
