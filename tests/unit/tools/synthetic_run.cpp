#include "synthetic_run.hpp"

#include <array>
#include <fstream>

#include "particle_file.hpp"
#include "slope/couple/read_case.hpp"
#include "synthetic_slope.hpp"

namespace slope::tools::test {
namespace {

namespace fs = std::filesystem;

void write_case(const fs::path& folder, const couple::Case& input) {
  fs::create_directories(folder);
  std::ofstream(folder / "case.yaml") << couple::resolved_yaml(input);
}

void write_history(const fs::path& folder, double slide) {
  constexpr std::array points{"A1", "A2", "B1", "B2", "B3", "C1", "C2"};
  std::ofstream file(folder / "history.csv");
  file << "time [s],clock factor [-],largest displacement [m]";
  for (const auto* point : points) {
    file << ',' << point << " displacement [m]," << point << " suction [Pa]";
  }
  for (const auto& [time, share] : {std::pair{0.0, 0.0}, {300.0, 0.001}, {459.1, 0.022}, {640.0, 1.0}}) {
    file << '\n' << time << ",1," << share * slide;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double depth = 1.0 + static_cast<double>(i);
      file << ',' << share * slide / depth << ',' << 4000.0 * depth - 30.0 * time;
    }
  }
  file << '\n';
}

}  // namespace

couple::RunSummary summary_of_a_slide(double onset) {
  couple::Summary found;
  found.end_reason = couple::EndReason::displacement;
  found.verdict = couple::Verdict::fails;
  found.time = 640.0;
  found.onset_time = onset;
  couple::Case input;
  input.path = "cases/some.yaml";
  return couple::run_summary(input, found);
}

void write_summary(const fs::path& folder, const couple::RunSummary& summary) {
  std::ofstream(folder / "summary.json") << couple::summary_json(summary);
}

void write_slope_run(const fs::path& folder, double slide) {
  write_case(folder, couple::read_case(fs::path(SLOPE_CASES) / "paper/slope-w2.yaml"));
  ParticleFileSeries series(folder);
  series.write(synthetic_slope(0.0), "start");
  series.write(synthetic_slope(300.0, 0.0, 0.7));
  series.write(synthetic_slope(459.1, 0.05, 1.0), "onset");
  series.write(synthetic_slope(640.0, slide, 1.8), "end");
  write_history(folder, slide);
  couple::RunSummary summary = summary_of_a_slide(459.1);
  summary.found.zone_at_end.length = 12.3;
  summary.found.zone_at_end.height = 6.8;
  write_summary(folder, summary);
}

void write_column_run(const fs::path& folder) {
  auto input = couple::read_case(fs::path(SLOPE_CASES) / "paper/liakopoulos.yaml");
  input.figures.profile_reference.clear();
  write_case(folder, input);
  ParticleFileSeries series(folder);
  series.write(synthetic_column(0.0, 0.0), "start");
  series.write(synthetic_column(300.0, 0.4));
  series.write(synthetic_column(7200.0, 0.9), "end");
  std::ofstream(folder / "history.csv") << "time [s],top suction [Pa]\n0,0\n7200,9000\n";
  couple::Summary found;
  found.end_reason = couple::EndReason::time;
  found.time = 7200.0;
  input.path = "liakopoulos.yaml";
  write_summary(folder, couple::run_summary(input, found));
}

}  // namespace slope::tools::test
