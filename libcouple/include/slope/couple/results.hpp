#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "slope/couple/case.hpp"
#include "slope/couple/document.hpp"
#include "slope/couple/read_case.hpp"
#include "slope/couple/summary.hpp"

namespace slope::couple {

/// A value of an enum as it stands in results, and what it means.
template <class E>
struct Word {
  E value;
  std::string_view text;
  std::string_view meaning;
};

inline constexpr std::array end_reasons{
    Word<EndReason>{EndReason::running, "running", "the run has not come to its end, or was killed"},
    Word<EndReason>{EndReason::time, "time", "stop.time was reached"},
    Word<EndReason>{EndReason::displacement, "displacement", "stop.displacement was reached"},
    Word<EndReason>{EndReason::after_onset, "after_onset", "stop.after_onset has passed since the onset"},
    Word<EndReason>{EndReason::at_rest, "at_rest", "the slide has come to rest, as stop.at_rest asks"},
    Word<EndReason>{EndReason::interrupted, "interrupted", "somebody interrupted the run"},
    Word<EndReason>{EndReason::error, "error", "the physics broke, or a file could not be written: see message"}};

inline constexpr std::array verdicts{
    Word<Verdict>{Verdict::undecided, "undecided", "it stands so far, but the run has not come to its end"},
    Word<Verdict>{Verdict::stands, "stands", "no onset of failure until the end"},
    Word<Verdict>{Verdict::moves, "moves without failing",
                  "the largest displacement passed that of the onset, but nothing ran away or sheared"},
    Word<Verdict>{Verdict::fails, "fails", "it stood before the start, and failed then"},
    Word<Verdict>{Verdict::does_not_stand, "does not stand before the start", "no balance was found"},
    Word<Verdict>{Verdict::water_alone, "water alone", "the soil was not asked"}};

inline constexpr std::array onset_criteria{
    Word<Onset>{Onset::displacement, "displacement", "largest displacement above displacement_m"},
    Word<Onset>{
        Onset::runaway, "runaway",
        "kink from which on the largest displacement grew by displacement_m at five times the mean rate before, "
        "without slowing down"}};

[[nodiscard]] std::string_view text_of(EndReason reason);
[[nodiscard]] std::string_view text_of(Verdict verdict);
/// Whether the run came to an end that its case asks for.
[[nodiscard]] bool is_complete(EndReason reason);

/// What summary.json holds: what was found of the slope, of which case, and how the program fared.
struct RunSummary {
  Summary found;
  std::string version;       ///< of slope-sim
  std::string title;         ///< of the case
  std::string case_file;     ///< that was run
  std::string message;       ///< of the error or interruption that ended the run; empty: none
  Onset onset_criterion{};   ///< by which found.onset_time is
  double zone_strain = 0.0;  ///< deviatoric strain above which soil is of the failure zone (-)
  std::size_t threads = 1;
  double wall_time = 0.0;  ///< that the run took (s)
};

/// What this version of the program says of a run of a case; threads, wall time and message are the caller's.
[[nodiscard]] RunSummary run_summary(const Case& input, Summary found);

/// The content of summary.json.
[[nodiscard]] Document summary_document(const RunSummary& summary);
/// The same as text. Names carry their unit; what did not happen, or is no number, is null.
[[nodiscard]] std::string summary_json(const RunSummary& summary);
/// JSON Schema (draft 2020-12) of summary.json, with unit, sign and meaning of every key.
[[nodiscard]] std::string summary_schema();

/// Reads a summary back. One of another version of the program is read as far as it is known; what it does not tell is
/// NaN, none or empty.
/// @param not_understood  takes what of another version's summary is not known here, or missing; empty otherwise
/// @throws FileError that names file, line, key and what is expected, if the file cannot be read, is no summary of
///   slope-sim, or is damaged
[[nodiscard]] RunSummary read_summary(const std::filesystem::path& file,
                                      std::vector<Problem>* not_understood = nullptr);
/// The same of a text. @param name  of the file, for messages
[[nodiscard]] RunSummary summary_of(const std::string& text, const std::string& name,
                                    std::vector<Problem>* not_understood = nullptr);

}  // namespace slope::couple
