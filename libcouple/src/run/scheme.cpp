#include "scheme.hpp"

#include <stdexcept>
#include <utility>

namespace slope::couple {

AnyScheme::AnyScheme(const Case& input, const Mixture& mixture, const SlopeScale& scale,
                     const std::vector<double>& change_times)
    : scheme_([&]() -> decltype(scheme_) {
        if (input.scheme == Scheme::explicit_two_pass) {
          return ClockPaced(ExplicitScheme(), input, mixture, scale, change_times);
        }
        if (input.scheme == Scheme::seepage) return SeepageScheme();
        return ClockPaced(SemiImplicitScheme(input.numerics.pressure_tolerance), input, mixture, scale, change_times);
      }()) {}

StepDone AnyScheme::step(const StepTask& task) {
  return std::visit([&](auto& scheme) { return scheme.step(task); }, scheme_);
}

double AnyScheme::time_step() const {
  return std::visit([](const auto& scheme) { return scheme.time_step(); }, scheme_);
}

bool AnyScheme::moves_soil() const {
  return std::visit([]<class Own>(const Own& /*scheme*/) { return Own::moves_soil; }, scheme_);
}

void AnyScheme::tell(Summary& summary) const {
  std::visit(
      [&]<class Own>(const Own& scheme) {
        if constexpr (Own::moves_soil) scheme.tell(summary);
      },
      scheme_);
}

PaceState AnyScheme::state() const {
  return std::visit([](const auto& scheme) -> PaceState { return scheme.state(); }, scheme_);
}

void AnyScheme::set_state(PaceState state) {
  std::visit(
      [&]<class Own>(Own& scheme) {
        if (!std::holds_alternative<typename Own::State>(state)) throw std::invalid_argument("its scheme is another");
        scheme.set_state(std::get<typename Own::State>(std::move(state)));
      },
      scheme_);
}

}  // namespace slope::couple
