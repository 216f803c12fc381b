#pragma once

#include <array>
#include <string_view>

#include "slope/couple/summary.hpp"

namespace slope::couple {

/// One line of the water's books. The columns of budget.csv, the keys of the summary's water_budget, what is printed
/// and what the pictures' curves are called all come from here.
struct WaterAmount {
  std::string_view name;     ///< "run-off": of the column, of the curve and, with _ between its words, of the key
  std::string_view unit;     ///< "m3/m", cumulative since the start, per metre of thickness; "-" of a ratio
  std::string_view phrase;   ///< "ran off": behind the amount, in what is printed
  std::string_view meaning;  ///< with its sign
  double WaterBudget::*value;
};

/// Each of the amounts, and all that are counted one by one, in the order of the table's columns.
namespace water_amounts {

inline constexpr WaterAmount rain{"rain", "m3/m", "fell", "what fell on the free surface, >= 0; infiltrated or ran off",
                                  &WaterBudget::rain};
inline constexpr WaterAmount rain_infiltration{"rain infiltration", "m3/m", "infiltrated",
                                               "of the rain, into the soil, >= 0", &WaterBudget::rain_infiltration};
inline constexpr WaterAmount run_off{"run-off", "m3/m", "ran off", "of the rain, along the ground and away, >= 0",
                                     &WaterBudget::run_off};
inline constexpr WaterAmount seepage{"seepage", "m3/m", "seeped out", "out of the free surface as water, >= 0",
                                     &WaterBudget::seepage};
inline constexpr WaterAmount evaporation{"evaporation", "m3/m", "evaporated",
                                         "out of the free surface into the air, >= 0", &WaterBudget::evaporation};
inline constexpr WaterAmount infiltration{
    "infiltration", "m3/m", "in",
    "into the soil through all boundaries, rain, held pressures and heads, fluxes "
    "and reservoirs together, >= 0",
    &WaterBudget::infiltration};
inline constexpr WaterAmount outflow{"outflow", "m3/m", "out",
                                     "out of the soil through all boundaries, seepage, evaporation, held pressures and "
                                     "heads, fluxes and drains together, >= 0",
                                     &WaterBudget::outflow};
inline constexpr WaterAmount storage{"storage", "m3/m", "stored",
                                     "change of what the pores hold, positive where the soil got wetter",
                                     &WaterBudget::storage};
inline constexpr std::array all{rain, rain_infiltration, run_off, seepage, evaporation, infiltration, outflow, storage};

/// What the books do not account for; a column of the table.
inline constexpr WaterAmount balance_error{"balance error", "m3/m", "unaccounted for",
                                           "infiltration - outflow - storage, positive where water is missing",
                                           &WaterBudget::balance_error};
/// The same as a ratio, by which runs are judged; in the summary and in what is printed.
inline constexpr WaterAmount relative_balance_error{
    "relative balance error", "-", "balance error",
    "balance error over the larger of infiltration and outflow, with its sign; 0 where no water moved",
    &WaterBudget::relative_balance_error};

}  // namespace water_amounts

}  // namespace slope::couple
