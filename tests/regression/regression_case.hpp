#pragma once

#include <filesystem>
#include <string>

#include "tolerances.hpp"

namespace slope::testing {

/// A case of tests/regression, its references and, in the build tree, what was made of it just now.
struct RegressionCase {
  std::string name;

  [[nodiscard]] std::filesystem::path references() const {
    return std::filesystem::path(SLOPE_TEST_REFERENCE_DIR) / name;
  }
  [[nodiscard]] std::filesystem::path built() const { return std::filesystem::path(SLOPE_REGRESSION_DIR) / name; }
  [[nodiscard]] std::filesystem::path run() const { return built() / "run"; }            ///< slope-sim's folder
  [[nodiscard]] std::filesystem::path products() const { return built() / "products"; }  ///< as in references()
  [[nodiscard]] Tolerances tolerances() const { return read_tolerances(references() / "tolerances.yaml"); }
};

inline const RegressionCase short_column{"short_column"};
inline const RegressionCase short_slope{"short_slope"};

}  // namespace slope::testing
