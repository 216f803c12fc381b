#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "slope/seepage/boundary.hpp"
#include "slope/seepage/pore_flow.hpp"

namespace slope::seepage {

/// One condition in the equations of a step: which particle it acts on, in which account its water is booked, and its
/// law. Conditions on one particle add up.
struct BoundaryTerm {
  std::uint32_t particle = 0;
  std::uint32_t account = 0;
  BoundaryLaw law;

  [[nodiscard]] double inflow(double head) const {
    return std::visit([head](const auto& l) { return l.inflow(head); }, law);
  }
  [[nodiscard]] double stiffness() const {
    return std::visit([](const auto& l) { return l.stiffness(); }, law);
  }
  [[nodiscard]] double conductance_slope() const {
    return std::visit([](const auto& l) { return l.conductance_slope(); }, law);
  }
  bool follow(double head) {
    return std::visit([head](auto& l) { return l.follow(head); }, law);
  }
  [[nodiscard]] Exchange exchange(double head) const {
    return std::visit([head](const auto& l) { return l.exchange(head); }, law);
  }
};

/// The water boundaries of a step as its equations have them, kept from the first of them to the books.
class BoundaryTerms {
 public:
  /// Works the laws out at the present state of the water.
  /// @param elevation  of the particles (m); @param head  there (m)
  void find(const Boundary& boundary, const PoreFlow& flow, std::span<const double> elevation,
            std::span<const double> head);

  [[nodiscard]] std::span<const BoundaryTerm> terms() const { return terms_; }
  [[nodiscard]] std::span<BoundaryTerm> terms() { return terms_; }
  [[nodiscard]] std::span<const HeldPressure> held() const { return held_; }

  /// Takes what comes in off the particles' outflow, and notes it by account. @param head  at the end of the step (m)
  void take_in(std::span<const double> head, StepFlow& flow) const;

 private:
  std::vector<BoundaryTerm> terms_;
  std::vector<HeldPressure> held_;
  std::size_t accounts_ = 0;
};

}  // namespace slope::seepage
