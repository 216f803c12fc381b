#pragma once

#include <set>
#include <string>
#include <vector>

#include "slope/couple/simulation.hpp"

namespace slope::random_cases {

/// What every run must keep, whatever its case is; looked at before the start and whenever the run says something.
class Promises {
 public:
  /// @param start  the state before the start
  Promises(const couple::Case& input, const couple::ParticleTable& start, const couple::Summary& before);

  /// @param row, budget  of the history and of the water's books, if they are due
  void look(const couple::ParticleTable& now, const couple::Summary& summary);
  void look_at_row(const std::vector<double>& row, const std::vector<double>& budget);
  void look_at_end(const couple::Summary& summary);

  /// What was not kept, each once; empty: all was.
  [[nodiscard]] const std::vector<std::string>& broken() const { return broken_; }
  /// Water that is missing or too much, over what went in or out or the pores held (-): the largest so far.
  [[nodiscard]] double water_error() const { return water_error_; }

 private:
  void expect(bool kept, const char* what, double value, double bound);
  void look_at_fields(const couple::ParticleTable& now);
  void look_at_heads(const couple::ParticleTable& now, double displacement);
  void look_at_water(const couple::ParticleTable& now, const couple::WaterBudget& water);
  void look_at_rain(const couple::WaterBudget& water, double time, double displacement);

  const couple::Case& input_;
  std::vector<double> first_volume_, first_porosity_;
  std::vector<double> contents_;   ///< water of each particle's pores at the last look (m2)
  std::vector<double> volumes_;    ///< of the particles then (m2)
  double largest_pressure_ = 0.0;  ///< of any particle, of either sign (Pa)
  double most_moved_ = 0.0;  ///< of it from one look to the next: root of the sum of squares times their number (m3/m)
  double first_storage_ = 0.0;                     ///< their sum before the start (m3/m)
  double lowest_head_ = 0.0, highest_head_ = 0.0;  ///< between which water stays that nothing squeezes (m)
  std::vector<double> last_budget_;
  double water_error_ = 0.0;
  std::set<std::string> seen_;
  std::vector<std::string> broken_;
};

}  // namespace slope::random_cases
