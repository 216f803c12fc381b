#include "run_figures.hpp"

#include <fmt/format.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "slope/couple/read_case.hpp"

namespace slope::tools {

namespace {

// Suction of the particle that has moved most at the onset.
double suction_at_onset(const RunFolder& run) {
  const auto snapshot = std::ranges::find(run.snapshots, "onset", &Snapshot::label);
  if (snapshot == run.snapshots.end()) return nothing;
  const auto particles = read_particles(snapshot->file);
  vtkDataArray* displacement = particles->GetPointData()->GetArray("displacement");
  vtkDataArray* suction = particles->GetPointData()->GetArray("suction");
  if (displacement == nullptr || suction == nullptr) return nothing;
  double farthest = -1.0, result = nothing;
  for (vtkIdType p = 0; p < displacement->GetNumberOfTuples(); ++p) {
    const double moved = std::hypot(displacement->GetComponent(p, 0), displacement->GetComponent(p, 1));
    if (moved <= farthest) continue;
    farthest = moved;
    result = suction->GetComponent(p, 0);
  }
  return result;
}

std::string shown(double value, const char* format) {
  return std::isnan(value) ? "-" : fmt::format(fmt::runtime(format), value);
}

}  // namespace

double RunFigures::time_of(double displacement_passed) const {
  const auto mark =
      std::ranges::find(found.displacement_times, displacement_passed, &couple::DisplacementTime::displacement);
  return mark == found.displacement_times.end() ? nothing : mark->time.value_or(nothing);
}

RunFigures figures_of(const RunFolder& run) {
  if (!run.summary) throw couple::FileError(fmt::format("{}: is not there", (run.path / "summary.json").string()));
  constexpr couple::FailureZone none{nothing, nothing, nothing, nothing, nothing, nothing, nothing};
  RunFigures f;
  f.found = run.summary->found;
  f.onset = run.onset.value_or(nothing);
  if (run.onset) {
    f.x = f.found.onset_position[0];
    f.y = f.found.onset_position[1];
  }
  f.suction_there = suction_at_onset(run);
  f.early = f.found.zone_at_10_cm.value_or(none);
  f.last = f.found.zone_at_end;
  f.conductivity = run.input.soils.front().seepage.hydraulic_conductivity;
  return f;
}

std::vector<std::string> write_comparison(const std::vector<std::filesystem::path>& folders,
                                          const std::filesystem::path& file) {
  std::string text =
      "| run | verdict | 1 cm | onset | against the first | runs away | 5 cm | 10 cm | zone at 10 cm, length x height, "
      "area | end of the run | run-out | slid | zone at the end | suction left |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  double first = nothing;
  std::vector<std::string> notes;
  for (const auto& folder : folders) {
    const RunFolder run = read_run_folder(folder);
    notes.insert(notes.end(), run.notes.begin(), run.notes.end());
    const RunFigures f = figures_of(run);
    if (folder == folders.front()) first = f.onset;
    const auto zone = [](const couple::FailureZone& z) {
      return std::isnan(z.area) ? "-" : fmt::format("{:.1f} x {:.1f} m, {:.1f} m2", z.length, z.height, z.area);
    };
    text += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} | {}, {} | {} | {} | {} | {} |\n",
                        run.input.title, couple::text_of(f.found.verdict), shown(f.time_of(0.01), "{:.1f} s"),
                        shown(f.onset, "{:.1f} s"), shown(100.0 * (f.onset / first - 1.0), "{:+.1f} %"),
                        shown(f.found.runaway_onset.value_or(nothing), "{:.1f} s"), shown(f.time_of(0.05), "{:.1f} s"),
                        shown(f.time_of(0.10), "{:.1f} s"), zone(f.early), shown(f.found.time, "{:.1f} s"),
                        shown(f.found.largest_displacement, "{:.2f} m moved"),
                        shown(f.found.slide_at_end.run_out.value_or(nothing), "{:.2f} m"),
                        shown(f.found.slide_at_end.area, "{:.1f} m2"), zone(f.last),
                        shown(f.last.largest_suction * 1e-3, "{:.1f} kPa"));
  }
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  if (!out) throw couple::FileError(fmt::format("{}: cannot be written", file.string()));
  return notes;
}

}  // namespace slope::tools
