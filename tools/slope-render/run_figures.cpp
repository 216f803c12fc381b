#include "run_figures.hpp"

#include <fmt/format.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <initializer_list>

#include "slope/couple/read_case.hpp"

namespace slope::tools {

namespace {

// What stands in a summary under one key after the other; null if one of them is not there.
YAML::Node find(YAML::Node node, std::initializer_list<const char*> keys) {
  for (const char* key : keys) {
    if (!node.IsMap() || !node[key].IsDefined()) return YAML::Node();
    node.reset(node[key]);
  }
  return node;
}

double number(const YAML::Node& node) {
  return node.IsScalar() ? node.as<double>(nothing) : nothing;
}

ZoneFigures zone_of(const YAML::Node& node) {
  return {number(find(node, {"length_m"})), number(find(node, {"height_m"})), number(find(node, {"area_m2"})),
          number(find(node, {"highest_m"})), number(find(node, {"largest_suction_Pa"}))};
}

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
  const auto time = displacement_times.find(displacement_passed);
  return time == displacement_times.end() ? nothing : time->second;
}

RunFigures figures_of(const RunFolder& run) {
  const auto file = run.path / "summary.json";
  try {
    const YAML::Node summary = YAML::LoadFile(file.string());
    RunFigures f;
    f.onset = run.onset.value_or(nothing);
    f.runaway = run.runaway_onset.value_or(nothing);
    const YAML::Node slide = find(summary, {"slide", "at_end"});
    f.run_out = number(find(slide, {"run_out_m"}));
    f.horizontal = number(find(slide, {"largest_horizontal_displacement_m"}));
    f.slid = number(find(slide, {"area_m2"}));
    f.verdict = summary["verdict"].IsDefined() ? summary["verdict"].as<std::string>("") : "";
    for (const YAML::Node& mark : find(summary, {"displacement_times"})) {
      f.displacement_times[number(find(mark, {"displacement_m"}))] = number(find(mark, {"time_s"}));
    }
    const YAML::Node position = find(summary, {"onset", "position_m"});
    if (position.IsSequence() && position.size() == 2) {
      f.x = number(position[0]);
      f.y = number(position[1]);
    }
    f.suction_there = suction_at_onset(run);
    f.early = zone_of(find(summary, {"failure_zone", "at_10_cm"}));
    f.last = zone_of(find(summary, {"failure_zone", "at_end"}));
    f.conductivity = run.input.soils.front().seepage.hydraulic_conductivity;
    f.displacement = number(find(summary, {"largest_displacement_m"}));
    f.end = number(find(summary, {"end", "time_s"}));
    f.budget = number(find(summary, {"water_budget", "error"}));
    return f;
  } catch (const YAML::Exception& error) {
    throw couple::FileError(fmt::format("{}: cannot be read: {}", file.string(), error.what()));
  }
}

void write_comparison(const std::vector<std::filesystem::path>& folders, const std::filesystem::path& file) {
  std::string text =
      "| run | verdict | 1 cm | onset | against the first | runs away | 5 cm | 10 cm | zone at 10 cm, length x height, "
      "area | end of the run | run-out | slid | zone at the end | suction left |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  double first = nothing;
  for (const auto& folder : folders) {
    const RunFolder run = read_run_folder(folder);
    const RunFigures f = figures_of(run);
    if (folder == folders.front()) first = f.onset;
    const auto zone = [](const ZoneFigures& z) {
      return std::isnan(z.area) ? "-" : fmt::format("{:.1f} x {:.1f} m, {:.1f} m2", z.length, z.height, z.area);
    };
    text +=
        fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} | {}, {} | {} | {} | {} | {} |\n", run.input.title,
                    f.verdict.empty() ? "-" : f.verdict, shown(f.time_of(0.01), "{:.1f} s"), shown(f.onset, "{:.1f} s"),
                    shown(100.0 * (f.onset / first - 1.0), "{:+.1f} %"), shown(f.runaway, "{:.1f} s"),
                    shown(f.time_of(0.05), "{:.1f} s"), shown(f.time_of(0.10), "{:.1f} s"), zone(f.early),
                    shown(f.end, "{:.1f} s"), shown(f.displacement, "{:.2f} m moved"), shown(f.run_out, "{:.2f} m"),
                    shown(f.slid, "{:.1f} m2"), zone(f.last), shown(f.last.suction * 1e-3, "{:.1f} kPa"));
  }
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  if (!out) throw couple::FileError(fmt::format("{}: cannot be written", file.string()));
}

}  // namespace slope::tools
