#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "slope/seepage/boundary.hpp"
#include "slope/seepage/conjugate_gradients.hpp"
#include "slope/seepage/face_flow.hpp"
#include "slope/seepage/head_operator.hpp"
#include "slope/seepage/skeleton.hpp"
#include "slope/seepage/soil.hpp"
#include "slope/seepage/two_pass_operator.hpp"
#include "slope/seepage/volume_response.hpp"

namespace slope::seepage {

/// Broken physics of the pore water: a pressure that is not a number, a step that cannot be solved.
class SeepageError : public std::runtime_error {
 public:
  SeepageError(std::size_t particle, const std::string& field, double value);
  std::size_t particle;  ///< index
  std::string field;
  double value;
};

struct FlowSettings {
  double spacing = 0.0;          ///< particle spacing (m), > 0
  double smoothing_ratio = 1.2;  ///< smoothing length over spacing (-)
  MirrorWalls walls;
  int threads = 1;  ///< >= 1; results do not depend on it
};

/// What one solution came to.
struct SolveReport {
  int iterations = 0;           ///< of conjugate gradients, or of Newton's method
  double largest_change = 0.0;  ///< of the pressure (Pa)
  bool converged = true;
};

/// Pore water on particles: generalised Darcy flow, retention, and mass balance (paper, Eqs. 4-10), implicit in time
/// and exact in mass.
///
/// With a moving skeleton, a step is: follow(); solve() for the pressure change, with the volume change that the
/// skeleton makes on its own and the one that it makes in response; then, when the skeleton has moved, finish(), which
/// takes stock of the water and carries what is left to the next step. With a rigid skeleton, advance() does all that
/// with Newton's method on an assembled matrix and may take steps of any length.
///
/// What it is between two steps is its State and that of its head operator; all else is given once or worked out anew.
/// A copy goes on as the original does.
class PoreFlow {
 public:
  struct State {
    std::vector<double> pressure;     ///< P_w (Pa)
    std::vector<double> content;      ///< water of each particle at its last booking (m2)
    std::vector<double> defect;       ///< water that the last booking left unexplained (m2)
    std::vector<double> front_start;  ///< P_w before the water came that wets a particle from its face (Pa)
    std::vector<double> inflow;       ///< by each boundary since the start (m2)
    std::vector<double> inflow_rate;  ///< by each boundary in the latest step (m2/s)
    AirFlow air_flow;                 ///< of the open faces in the latest step, in sum

    template <class Self, class Visit>
    static void for_each_field(Self& s, const Visit& visit) {
      visit("pressure", s.pressure);
      visit("content", s.content);
      visit("defect", s.defect);
      visit("front_start", s.front_start);
      visit("inflow", s.inflow), visit("inflow_rate", s.inflow_rate);
      visit("air_flow", s.air_flow);
    }
    bool operator==(const State&) const = default;
  };

  /// @param soil  index into `soils` of each particle; @param pressure  initial P_w (Pa)
  PoreFlow(std::vector<Soil> soils, const Water& water, std::span<const std::uint16_t> soil,
           std::span<const double> pressure, const Skeleton& skeleton, const FlowSettings& settings);

  /// Takes up the skeleton's present positions; call before solve().
  void follow(const Skeleton& skeleton);

  /// Finds the pressure change dP of a step from the mass balance of every particle:
  ///
  ///     [V (n S_r/K_w + C_s) + t L/gamma_w + S_r R S_r] dP = -S_r V e - t L h + boundary terms + defect
  ///
  /// by conjugate gradients with diagonal preconditioner. Where a particle gets so much wetter or drier that the slope
  /// of its retention curve does not hold, Newton's method follows the curve. What both leave is the next step's
  /// defect.
  /// @param time_step  t (s), > 0; @param strain  volumetric strain e of the skeleton at unchanged pressure (-),
  /// expansion positive; @param response  R; @param tolerance  reduction of the residual, in (0, 1)
  template <VolumeResponse Response>
  SolveReport solve(double time_step, const Skeleton& skeleton, std::span<const double> strain,
                    const Boundary& boundary, const Response& response, double tolerance);

  /// The pressure change found by solve() (Pa).
  [[nodiscard]] std::span<const double> pressure_change() const { return change_; }
  /// S_r dP of it (Pa).
  [[nodiscard]] std::span<const double> pore_stress_change() const { return stress_change_; }

  /// Adds the pressure change, evaluates saturation and permeability, and books the water of the step.
  /// @param skeleton  volumes and porosities after the step
  void finish(double time_step, const Skeleton& skeleton, const Boundary& boundary);

  /// A whole implicit step with a rigid skeleton (backward Euler, assembled matrix): Newton's method, at first with
  /// lagged permeability. If it does not converge, nothing has changed.
  SolveReport advance(double time_step, const Skeleton& skeleton, const Boundary& boundary, double tolerance_pressure,
                      int maximum_iterations = 20);

  /// A whole explicit step with the paper's two-pass operator (Eqs. 18, 19), for reference: it is stable only for steps
  /// below explicit_step(), and on disordered particles not even then; it books the water that it loses as unexplained.
  /// @param vx, vy  velocity of the skeleton in the water's time (m/s)
  void advance_explicitly(double time_step, const Skeleton& skeleton, std::span<const double> vx,
                          std::span<const double> vy, const Boundary& boundary);
  /// spacing^2 n gamma_w / (k K_w), the shortest over the particles: the time (s) in which a pressure crosses a spacing
  /// of saturated soil.
  [[nodiscard]] double explicit_step(const Skeleton& skeleton) const;

  [[nodiscard]] const State& state() const { return state_; }
  /// Goes on from a state that one with the same soils had. Conductances and pressure changes are of the next step on.
  /// @throws std::invalid_argument if there is not an entry for each particle
  void set_state(State state, HeadOperator::State head_operator);

  [[nodiscard]] std::span<const double> pressure() const { return state_.pressure; }    ///< P_w (Pa)
  [[nodiscard]] std::span<const double> suction() const { return suction_; }            ///< s = -P_w (Pa)
  [[nodiscard]] std::span<const double> saturation() const { return saturation_; }      ///< S_r (-)
  [[nodiscard]] std::span<const double> conductivity() const { return conductivity_; }  ///< k k_rw (m/s)
  [[nodiscard]] std::span<const double> pore_stress() const { return pore_stress_; }    ///< S_r P_w (Pa)
  /// Of the pressures in the latest step of advance() that converged (Pa).
  [[nodiscard]] std::span<const double> latest_change() const { return latest_change_; }
  [[nodiscard]] const HeadOperator& head_operator() const { return operator_; }
  [[nodiscard]] const Water& water() const { return water_; }

  /// Darcy's velocity w = -k k_rw grad h (m/s) (paper, Eq. 4 without the acceleration).
  void darcy_velocity(const Skeleton& skeleton, std::span<double> wx, std::span<double> wy) const;

  /// Water in the pores now, at its reference density (m2), and what has come in by each boundary since the start.
  [[nodiscard]] double stored_water() const;
  [[nodiscard]] std::span<const double> cumulative_inflow() const { return state_.inflow; }
  /// Net flow that each boundary brought in the latest step (m2/s).
  [[nodiscard]] std::span<const double> inflow_rate() const { return state_.inflow_rate; }
  /// What the open faces exchanged with the air in the latest step, in sum.
  [[nodiscard]] const AirFlow& air_flow() const { return state_.air_flow; }
  /// Water that the last solution left unexplained, summed over the particles (m2).
  [[nodiscard]] double unexplained_water() const;

 private:
  // At most so many times a step is solved until its open faces stay with their parts of the law and its storage keeps
  // to the retention curves.
  static constexpr int most_passes = 20;

  // Outflow of a drain, linear about the head at which it was found, up to that of saturated soil.
  struct DrainLaw {
    double rate = 0.0;     // (m2/s)
    double slope = 0.0;    // (m/s), >= 0
    double head = 0.0;     // (m)
    double largest = 0.0;  // (m2/s)

    [[nodiscard]] double outflow(double at_head) const {
      return std::clamp(rate + slope * (at_head - head), 0.0, largest);
    }
  };

  // Inflow through a face at the present pressure of its particle.
  struct FaceLaw {
    double conductance = 0.0;  // over the fall of the head from the face to the particle (m/s)
    double slope = 0.0;        // over the particle's head (m/s), <= 0
  };

  // Of what a particle stores in a step, over the pressure at its end.
  struct Tangent {
    std::size_t particle = 0;
    double offset = 0.0;   // (m2)
    double slope = 0.0;    // (m2/Pa)
    double touched = 0.0;  // (Pa)
  };

  // The equations of advance(), kept while the neighbours stay the same. A copy starts empty and works out the same.
  struct Assembled {
    Assembled() = default;
    Assembled(const Assembled& /*other*/) {}
    Assembled& operator=(const Assembled& /*other*/) {
      forget();
      return *this;
    }
    ~Assembled() = default;
    void forget() { pattern_known = ordering_known = false; }

    Eigen::SparseMatrix<double> matrix;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> lagged_factorisation;
    Eigen::SparseLU<Eigen::SparseMatrix<double>> factorisation;
    bool pattern_known = false;   // whether matrix and lagged_factorisation fit the present neighbours
    bool ordering_known = false;  // whether factorisation does
  };

  void evaluate_soil();
  void find_head(const Skeleton& skeleton);
  [[nodiscard]] double water_of(std::size_t p, const Skeleton& skeleton) const;
  [[nodiscard]] PotentialAt conductivity_at(std::size_t p, double pressure) const;
  [[nodiscard]] double conductivity_slope(std::size_t p) const;
  [[nodiscard]] WettingFront front_of(std::size_t p, double face_pressure) const;
  [[nodiscard]] FaceLaw face_law(const FacePressure& face) const;
  [[nodiscard]] double face_inflow(const FacePressure& face, double head) const;
  void find_open_face_laws(const Boundary& boundary);
  void find_drain_laws(const Boundary& boundary);
  bool switch_open_faces(const Boundary& boundary, double time_step, double flow_scale);
  [[nodiscard]] Tangent tangent_at(std::size_t p, double pressure, const Skeleton& skeleton) const;
  bool follow_retention(const Skeleton& skeleton, double tolerable);
  [[nodiscard]] double offset_share() const;
  void take_in_boundary_flow(const Boundary& boundary);
  void find_flow(const Boundary& boundary);
  void follow_front(std::size_t p, double gain, double time_step);
  void book(double time_step, const Skeleton& skeleton, const Boundary& boundary);
  double find_imbalance(double time_step, const Skeleton& skeleton, const Boundary& boundary);
  void add_face_slopes(double time_step, const Boundary& boundary);
  bool find_pressure_step(double time_step, const Boundary& boundary, bool lagged);
  void assemble(double time_step, bool lagged);
  [[nodiscard]] double stepped(std::size_t p, double pressure, double step) const;
  void check() const;

  std::vector<Soil> soils_;
  Water water_;
  FlowSettings settings_;
  HeadOperator operator_;
  std::vector<std::uint16_t> soil_;
  std::vector<std::vector<std::uint32_t>> particles_of_soil_;
  std::vector<double> drying_onset_;  // of each soil: P_w at which its conductivity has begun to fall (Pa)
  double tolerance_share_;            // of the tolerance that solve() is given

  State state_;
  std::vector<double> suction_, saturation_, pore_stress_;
  std::vector<double> capacity_;              // dS_r/dP_w (1/Pa)
  std::vector<double> conductivity_;          // k k_rw (m/s)
  std::vector<double> potential_;             // its integral over the pressure head (m2/s)
  std::vector<double> pressure_head_, head_;  // P_w / gamma_w, h (m)
  std::vector<double> elevation_;             // of the particles during the step (m)
  std::vector<double> face_gain_;             // what faces let into each particle in the latest step (m2/s), >= 0
  std::vector<std::uint8_t> face_full_;       // whether one of them let in all that the soil takes
  std::vector<double> change_, stress_change_, latest_change_;
  std::vector<OpenFaceLaw> open_laws_;         // of the present step's open faces
  std::vector<OpenFaceLaw::Part> open_parts_;  // the parts for which the step is solved
  std::vector<DrainLaw> drain_laws_;           // of the present step's drains

  double rounding_ = 0.0;  // of the imbalance of a step (m2)
  std::vector<double> storage_, right_side_, diagonal_, outflow_, work_, work2_;
  // What a particle stores in the step is taken as offset + slope dP, the tangent at the pressure touched.
  std::vector<double> storage_offset_, storage_slope_, touched_;
  std::vector<Tangent> tangents_;
  std::vector<std::uint8_t> is_held_;
  std::optional<TwoPassOperator> two_pass_;  // of explicit steps only
  std::vector<double> wx_, wy_;
  ConjugateGradients solver_;
  Assembled assembled_;
};

}  // namespace slope::seepage

#include "slope/seepage/pore_flow_solve.hpp"
