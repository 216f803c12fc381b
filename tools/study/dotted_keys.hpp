#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "case/units.hpp"
#include "slope/couple/case.hpp"
#include "slope/couple/document.hpp"
#include "slope/couple/summary.hpp"

/// Numbers of a case and of a summary by their dotted keys.
namespace slope::tools {

/// A number of a case, as --set reaches it.
struct CaseNumber {
  std::string key;  ///< as problems name it: items of lists by their names
  couple::Dimension dimension = couple::Dimension::number;
};

/// The numbers of a case with all its defaults.
class CaseNumbers {
 public:
  explicit CaseNumbers(const couple::Case& input);

  /// @return the number, or what is wrong with the key
  [[nodiscard]] std::variant<CaseNumber, std::string> find(std::string_view key) const;

 private:
  couple::Document document_;
};

/// The unit of a number of the summary ("-": none), or in `problem` what is wrong with the key.
struct SummaryNumber {
  std::string unit = "-";
  std::string problem;
};
[[nodiscard]] SummaryNumber summary_number(std::string_view key);

/// Its value in a summary; none: it did not happen, or is not known.
/// @param at  time of the factor of safety that is meant (s); none: that at which it is least
[[nodiscard]] std::optional<double> number_in(const couple::Document& summary, std::string_view key,
                                              std::optional<double> at);

/// Under which the summary has its factors of safety.
inline constexpr std::string_view safety_key = "factor_of_safety";
inline constexpr std::string_view factor_key = "factor_of_safety.factor";

}  // namespace slope::tools
