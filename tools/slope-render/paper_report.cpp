#include "paper_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <limits>
#include <optional>

#include "run_figures.hpp"
#include "slope/couple/read_case.hpp"

namespace slope::tools {
namespace {

constexpr double moves = 0.02;      // m: a point that moved less hardly moved
constexpr double same = 0.03;       // two onset times that scale with k agree within this share
constexpr double suction_60 = 6e4;  // Pa: what the paper gives as left in W1
constexpr std::array slopes{"slope-w1", "slope-w2", "slope-w3", "slope-h1", "slope-h2", "slope-h3"};
using Figures = RunFigures;
using Three = std::array<const char*, 3>;
constexpr Three wetness{"slope-w1", "slope-w2", "slope-w3"}, permeability{"slope-h1", "slope-h2", "slope-h3"};

// A column of the history, "<point> <quantity> [unit]"; null if there is none.
const std::vector<double>* column(const RunFolder& run, const std::string& name) {
  for (std::size_t c = 0; c < run.history.names.size(); ++c) {
    if (run.history.names[c].starts_with(name + " [")) return &run.history.columns[c];
  }
  return nullptr;
}

// The value in the last row that is not after a time.
double at(const RunFolder& run, const std::string& name, double time) {
  const auto* values = column(run, name);
  if (values == nullptr) return nothing;
  double result = nothing;
  for (std::size_t i = 0; i < values->size() && run.history.columns.front()[i] <= time; ++i) result = (*values)[i];
  return result;
}

// The first time at which a column is no longer above a limit.
double time_below(const RunFolder& run, const std::string& name, double limit) {
  const auto* values = column(run, name);
  if (values == nullptr) return nothing;
  for (std::size_t i = 0; i < values->size(); ++i) {
    if ((*values)[i] <= limit) return run.history.columns.front()[i];
  }
  return nothing;
}

class Report {
 public:
  explicit Report(const PaperRuns& runs) : runs_(runs) {
    for (const char* name : slopes) {
      if (const auto run = runs.runs.find(name); run != runs.runs.end())
        figures_.emplace(name, figures_of(run->second));
    }
  }

  [[nodiscard]] std::string text() const { return runs_table() + wetness_claims() + permeability_claims(); }

 private:
  using Value = std::function<double(const RunFolder&, const Figures&)>;

  [[nodiscard]] std::array<double, 3> three(const Three& names, const Value& value) const {
    std::array<double, 3> result{nothing, nothing, nothing};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto figures = figures_.find(names[i]);
      if (figures != figures_.end()) result[i] = value(runs_.runs.at(names[i]), figures->second);
    }
    return result;
  }

  static std::string shown(const std::array<double, 3>& values, double scale, const char* format, const char* unit) {
    std::string text;
    for (const double value : values) {
      text += text.empty() ? "" : " / ";
      text += std::isnan(value) ? "-" : fmt::format(fmt::runtime(format), value * scale + 0.0);
    }
    return text + " " + unit;
  }

  static std::string known(double value, const char* format) {
    return std::isnan(value) ? "-" : fmt::format(fmt::runtime(format), value);
  }

  static std::string row(const char* claim, const std::string& measured, std::optional<bool> holds) {
    return fmt::format("| {} | {} | {} |\n", claim, measured,
                       holds ? (*holds ? "holds" : "does not hold") : "not judged");
  }

  // A claim on three values; not judged if one of them is not there.
  static std::optional<bool> judge(const std::array<double, 3>& v,
                                   const std::function<bool(double, double, double)>& test) {
    if (std::ranges::any_of(v, [](double value) { return std::isnan(value); })) return std::nullopt;
    return test(v[0], v[1], v[2]);
  }
  static bool ascend(double a, double b, double c) { return a < b && b < c; }
  static bool descend(double a, double b, double c) { return a > b && b > c; }

  [[nodiscard]] std::string runs_table() const {
    std::string text =
        "## The runs\n\n"
        "Onset: by the case's criterion. Runs away: the kink of the largest displacement. Zone: particles whose "
        "deviatoric strain passes the case's threshold. Run-out: advance beyond the first toe; slid: what moved by "
        "more "
        "than the onset displacement.\n\n"
        "| case | onset | runs away | 10 cm | onset at x, y | zone at 10 cm, length x height | end of the run | "
        "run-out | "
        "slid | zone at the end | suction left | water balance error "
        "|\n|---|---|---|---|---|---|---|---|---|---|---|---|\n";
    for (const auto& [name, f] : figures_) {
      text += fmt::format(
          "| {} | {:.1f} s | {} | {:.1f} s | {:.1f} m, {:.1f} m | {:.1f} x {:.1f} m | {:.2f} m moved | {} | {} | "
          "{:.1f} x "
          "{:.1f} m, {:.1f} m2 | {:.1f} kPa | {:.0e} |\n",
          name, f.onset, known(f.found.runaway_onset.value_or(nothing), "{:.1f} s"), f.time_of(0.1), f.x, f.y,
          f.early.length, f.early.height, f.found.largest_displacement,
          known(f.found.slide_at_end.run_out.value_or(nothing), "{:.2f} m"),
          known(f.found.slide_at_end.area, "{:.1f} m2"), f.last.length, f.last.height, f.last.area,
          f.last.largest_suction * 1e-3, std::abs(f.found.water.relative_balance_error));
    }
    return text + "\n";
  }

  [[nodiscard]] std::string wetness_claims() const {
    const auto onset = three(wetness, [](const RunFolder&, const Figures& f) { return f.onset; });
    const auto height = three(wetness, [](const RunFolder&, const Figures& f) { return f.y; });
    const auto suction = three(wetness, [](const RunFolder&, const Figures& f) { return f.suction_there; });
    const auto climb =
        three(wetness, [](const RunFolder&, const Figures& f) { return f.last.highest - f.early.highest; });
    const auto early = three(wetness, [](const RunFolder&, const Figures& f) { return f.early.area; });
    const auto late = three(wetness, [](const RunFolder&, const Figures& f) { return f.last.area; });
    const auto left = three(wetness, [](const RunFolder&, const Figures& f) { return f.last.largest_suction; });
    const auto c1 = three(
        wetness, [](const RunFolder& run, const Figures& f) { return at(run, "C1 displacement", f.time_of(0.1)); });
    const auto b = three(wetness, [](const RunFolder& run, const Figures& f) {
      double largest = -std::numeric_limits<double>::infinity();
      for (const char* point : {"B1 suction", "B2 suction", "B3 suction"}) {
        const double value = at(run, point, f.onset);
        if (std::isnan(value)) return nothing;
        largest = std::max(largest, value);
      }
      return largest;
    });
    return std::string(
               "## Initial saturation: W1, W2, W3 (sections 4.2 and 4.3)\n\n"
               "| claim | measured, W1 / W2 / W3 | verdict |\n|---|---|---|\n") +
           row("failure starts in the lowest third of the face",
               "height of the onset " + shown(height, 1.0, "{:.1f}", "m"),
               judge(height,
                     [](double x, double y, double z) {
                       return std::max({x, y, z}) < 5.0 + 7.0 / 3.0;
                     })) +
           row("it starts in the saturated part, never in the unsaturated",
               "suction where the soil moved most at onset " + shown(suction, 1e-3, "{:.2f}", "kPa"),
               judge(suction,
                     [](double x, double y, double z) {
                       return std::max({x, y, z}) <= 0.0;
                     })) +
           row("it works upwards", "rise of the zone's top from 10 cm to the end " + shown(climb, 1.0, "{:.1f}", "m"),
               judge(climb,
                     [](double x, double y, double z) {
                       return std::min({x, y, z}) > 0.0;
                     })) +
           row("the wetter, the earlier", "onset " + shown(onset, 1.0, "{:.1f}", "s"), judge(onset, ascend)) +
           row("W1 is the largest, then W2, W3 (10 cm moved)", "area " + shown(early, 1.0, "{:.1f}", "m2"),
               judge(early, descend)) +
           row("W1 is the largest, then W2, W3 (end of the run)", "area " + shown(late, 1.0, "{:.1f}", "m2"),
               judge(late, descend)) +
           row("about 60 kPa of suction are left in W1", "largest at the end " + shown(left, 1e-3, "{:.1f}", "kPa"),
               judge(left, [](double x, double, double) { return std::abs(x - suction_60) < 0.1 * suction_60; })) +
           row("the drier, the more suction is left", "largest at the end " + shown(left, 1e-3, "{:.1f}", "kPa"),
               judge(left, ascend)) +
           row("C1 moves most in W1, hardly in W2 and W3",
               "C1 when 10 cm have moved " + shown(c1, 100.0, "{:.1f}", "cm"),
               judge(c1, [](double x, double y, double z) { return x > moves && std::max(y, z) < moves; })) +
           row("the suction at B1 to B3 is gone at onset", "the largest of them " + shown(b, 1e-3, "{:.2f}", "kPa"),
               judge(b,
                     [](double x, double y, double z) {
                       return std::max({x, y, z}) <= 0.0;
                     })) +
           "\n";
  }

  [[nodiscard]] std::string permeability_claims() const {
    const auto onset = three(permeability, [](const RunFolder&, const Figures& f) { return f.onset; });
    const auto scaled =
        three(permeability, [](const RunFolder&, const Figures& f) { return f.onset * f.conductivity; });
    const auto early = three(permeability, [](const RunFolder&, const Figures& f) { return f.early.area; });
    const auto late = three(permeability, [](const RunFolder&, const Figures& f) { return f.last.area; });
    const auto gone =
        three(permeability, [](const RunFolder& run, const Figures&) { return time_below(run, "B3 suction", 0.0); });
    const auto c1 = three(permeability, [](const RunFolder& run, const Figures& f) {
      return at(run, "C1 displacement", f.time_of(0.1));
    });
    const auto b1 = three(permeability, [](const RunFolder& run, const Figures& f) {
      return at(run, "B1 displacement", f.time_of(0.1));
    });
    const auto largest_first = [](double x, double y, double z) { return x > std::max(y, z); };
    return std::string(
               "## Hydraulic conductivity: H1, H2, H3 (section 4.4)\n\n"
               "| claim | measured, H1 / H2 / H3 | verdict |\n|---|---|---|\n") +
           row("the more permeable, the earlier", "onset " + shown(onset, 1.0, "{:.2f}", "s"), judge(onset, ascend)) +
           row("the onset scales with 1/k, within 3 %", "onset times k " + shown(scaled, 1e3, "{:.4f}", "mm"),
               judge(scaled, [](double x, double y,
                                double z) { return std::max(std::abs(x / y - 1.0), std::abs(z / y - 1.0)) < same; })) +
           row("H1 is the largest (10 cm moved)", "area " + shown(early, 1.0, "{:.1f}", "m2"),
               judge(early, largest_first)) +
           row("H1 is the largest (end of the run)", "area " + shown(late, 1.0, "{:.1f}", "m2"),
               judge(late, largest_first)) +
           row("C1 moves in H1 only", "C1 when 10 cm have moved " + shown(c1, 100.0, "{:.1f}", "cm"),
               judge(c1, [](double x, double y, double z) { return x > moves && std::max(y, z) < moves; })) +
           row("suction goes faster with k", "B3's is gone after " + shown(gone, 1.0, "{:.0f}", "s"),
               judge(gone, ascend)) +
           row("B1 moves most in H3", "B1 when 10 cm have moved " + shown(b1, 100.0, "{:.1f}", "cm"),
               judge(b1, [](double x, double y, double z) { return z > std::max(x, y); }));
  }

  const PaperRuns& runs_;
  std::map<std::string, Figures, std::less<>> figures_;
};

}  // namespace

void write_paper_report(const PaperRuns& runs, const std::filesystem::path& file) {
  const std::string text = Report(runs).text();
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  if (!out) throw couple::FileError(fmt::format("{}: cannot be written", file.string()));
}

}  // namespace slope::tools
