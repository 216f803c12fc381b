#include "paper_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <limits>
#include <stdexcept>

#include "drawable_particles.hpp"
#include "field_image.hpp"
#include "mesh_picture.hpp"
#include "panel_picture.hpp"
#include "retention_chart.hpp"
#include "run_curves.hpp"
#include "time_unit.hpp"

namespace slope::tools {
namespace {

namespace fs = std::filesystem;

/// A figure cannot be drawn; what() says why.
class LeftOut : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A run and what its case is called in the captions.
struct NamedRun {
  const RunFolder* run;
  std::string folder_name;  ///< "slope-w1"
  std::string name;         ///< "Case W1"
};

/// "Case W1" of "slope-w1".
std::string caption_name(std::string_view paper_case) {
  std::string name(paper_case.substr(paper_case.find('-') + 1));
  name.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(name.front())));
  return "Case " + name;
}

using CaseNames = std::vector<std::string_view>;

const CaseNames base_case{"slope-w2"};
const CaseNames retention_cases{"slope-w1", "slope-w2", "slope-w3"};
const CaseNames conductivity_cases{"slope-h1", "slope-h2", "slope-h3"};

/// The runs of cases, all of which a figure needs.
std::vector<NamedRun> find_runs(const PaperRuns& runs, const CaseNames& cases) {
  std::vector<NamedRun> found;
  std::string reasons;
  for (const auto name : cases) {
    const auto run = runs.runs.find(name);
    if (run != runs.runs.end()) {
      found.push_back({&run->second, std::string(name), caption_name(name)});
      continue;
    }
    const auto unusable = runs.unusable.find(name);
    reasons += reasons.empty() ? "" : "; ";
    reasons += unusable != runs.unusable.end() ? unusable->second : fmt::format("no run of {}", name);
  }
  if (!reasons.empty()) {
    throw LeftOut(reasons);
  }
  return found;
}

const Snapshot& labelled_snapshot(const NamedRun& named, std::string_view label) {
  const auto& snapshots = named.run->snapshots;
  const auto found = std::ranges::find(snapshots, label, &Snapshot::label);
  if (found == snapshots.end()) {
    throw LeftOut(label == "onset" ? fmt::format("{} did not fail", named.folder_name)
                                   : fmt::format("{} has no snapshot of its {}", named.folder_name, label));
  }
  return *found;
}

/// The first snapshot of the rain, unless it lies later than a quarter of the way to the onset: then the start.
const Snapshot& early_snapshot(const NamedRun& named) {
  const auto& snapshots = named.run->snapshots;
  const double latest = 0.25 * labelled_snapshot(named, "onset").time;
  const auto found = std::ranges::find_if(snapshots, [](const auto& s) { return s.time > 0.0; });
  return found != snapshots.end() && found->time <= latest ? *found : labelled_snapshot(named, "start");
}

/// @throws couple::FileError if some of a snapshot's particles cannot be drawn.
vtkSmartPointer<vtkPolyData> drawable_particles(const Snapshot& snapshot) {
  Losses losses;
  auto particles = read_drawable_particles(snapshot.file, losses);
  losses.throw_first();
  return particles;
}

StackedPanel stacked_panel(const NamedRun& named, const Snapshot& snapshot, const std::string& what) {
  StackedPanel panel;
  panel.particles = drawable_particles(snapshot);
  panel.domain = named.run->input.domain;
  panel.failure_strain = named.run->input.failure_zone_strain;
  panel.caption = fmt::format("{}, t = {} ({})", named.name, time_text(snapshot.time), what);
  return panel;
}

double largest_displacement(vtkPolyData* particles) {
  auto* displacement = particle_array(particles, "displacement");
  double largest = 0.0;
  for (vtkIdType p = 0; p < particles->GetNumberOfPoints(); ++p) {
    largest = std::max(largest, scalar(displacement, static_cast<std::size_t>(p)));
  }
  return largest;
}

/// Figs. 7 and 8.
void write_process(const fs::path& file, int width, const std::vector<NamedRun>& runs, const std::string& field) {
  const NamedRun& named = runs.front();
  const Snapshot& early = early_snapshot(named);
  write_stacked_panels(file, width, field_called(field),
                       {stacked_panel(named, early, early.time > 0.0 ? "start of the infiltration" : "before the rain"),
                        stacked_panel(named, labelled_snapshot(named, "onset"), "onset of failure"),
                        stacked_panel(named, labelled_snapshot(named, "end"), "end")});
}

/// Figs. 10 and 15.
void write_failures(const fs::path& file, int width, const std::vector<NamedRun>& runs) {
  std::vector<StackedPanel> panels;
  for (const NamedRun& named : runs) {
    (void)labelled_snapshot(named, "onset");
    auto panel = stacked_panel(named, labelled_snapshot(named, "end"), "");
    const couple::FailureZone& zone = named.run->summary.value().found.zone_at_end;
    if (std::isnan(zone.length) || std::isnan(zone.height)) {
      throw LeftOut(fmt::format("the summary of {} has no failure zone", named.folder_name));
    }
    panel.caption = fmt::format("{}, t = {}, |u| ≤ {:.2f} m", named.name,
                                time_text(labelled_snapshot(named, "end").time), largest_displacement(panel.particles));
    panel.zone = zone_dimensions(panel.particles, *panel.failure_strain, {zone.length, zone.height});
    panels.push_back(std::move(panel));
  }
  write_stacked_panels(file, width, field_called("deviatoric_strain"), panels);
}

/// Figs. 11 and 16.
void write_onsets(const fs::path& file, int width, const std::vector<NamedRun>& runs) {
  std::vector<StackedPanel> panels;
  for (const NamedRun& named : runs) {
    panels.push_back(stacked_panel(named, labelled_snapshot(named, "onset"), "onset of failure"));
  }
  write_stacked_panels(file, width, field_called("suction"), panels);
}

/// The curve of the run's first soil and the suction in it before the rain.
RetentionCurve retention_curve(const NamedRun& named) {
  const auto& input = named.run->input;
  const std::size_t soil = input.regions.front().soil;
  const auto particles = drawable_particles(labelled_snapshot(named, "start"));
  auto* suctions = particle_array(particles, "suction");
  auto* soils = particle_array(particles, "soil");
  double largest = 0.0;
  double least = std::numeric_limits<double>::max();
  for (vtkIdType p = 0; p < particles->GetNumberOfPoints(); ++p) {
    if (static_cast<std::size_t>(soils->GetComponent(p, 0)) == soil) {
      const double suction = std::max(0.0, suctions->GetComponent(p, 0));
      largest = std::max(largest, suction);
      least = std::min(least, suction);
    }
  }
  return {named.name, input.soils[soil].seepage.retention, {std::min(least, largest), largest}};
}

/// Figs. 6 and 9.
void write_retention(const fs::path& file, int width, const std::vector<NamedRun>& runs) {
  std::vector<RetentionCurve> curves;
  for (const NamedRun& named : runs) {
    curves.push_back(retention_curve(named));
  }
  write_retention_chart(file, width, curves, runs.front().run->input.water.unit_weight());
}

/// Some of a run's curves.
std::vector<Curve> curves_at(const NamedRun& named, const std::string& quantity,
                             std::initializer_list<std::string_view> points) {
  auto curves = history_curves(named.run->history, quantity);
  std::vector<Curve> chosen;
  for (const auto point : points) {
    const auto found = std::ranges::find(curves, point, &Curve::name);
    if (found == curves.end()) {
      throw LeftOut(fmt::format("{} has no history of the {} at {}", named.folder_name, quantity, point));
    }
    chosen.push_back(std::move(*found));
  }
  return chosen;
}

HistoryChart history_of(const NamedRun& named, std::vector<Curve> curves) {
  return {named.name + (named.run->onset ? "" : ", no failure"), "", named.run->history.columns.front(),
          std::move(curves), named.run->onset};
}

/// Figs. 13 and 17.
void write_displacements(const fs::path& file, int width, const std::vector<NamedRun>& runs) {
  std::vector<HistoryChart> charts;
  std::vector<Curve> all;
  for (const NamedRun& named : runs) {
    charts.push_back(history_of(named, curves_at(named, "displacement", {"A1", "A2", "B1", "B2", "C1", "C2"})));
    all.insert(all.end(), charts.back().curves.begin(), charts.back().curves.end());
  }
  const auto [factor, unit] = length_unit(all);
  for (auto& chart : charts) {
    scale_curves(chart.curves, factor);
    chart.y_title = fmt::format("|u| ({})", unit);
  }
  write_stacked_histories(file, width, charts);
}

/// Figs. 14 and 18.
void write_suctions(const fs::path& file, int width, const std::vector<NamedRun>& runs) {
  std::vector<HistoryChart> charts;
  for (const NamedRun& named : runs) {
    charts.push_back(history_of(named, curves_at(named, "suction", {"B1", "B2", "B3"})));
    scale_curves(charts.back().curves, 1.0e-3);
    charts.back().y_title = "Suction s (kPa)";
  }
  write_stacked_histories(file, width, charts);
}

/// Fig. 4.
void write_column(const fs::path& file, int width, const std::vector<NamedRun>& runs) {
  const RunFolder& run = *runs.front().run;
  if (run.input.figures.profile_times.empty()) {
    throw LeftOut(fmt::format("the case of {} asks for no profile (figures.profile_times)", runs.front().folder_name));
  }
  Losses losses;
  write_profile_chart(file, width, run.input.title, timed_profiles(run, losses));
  losses.throw_first();
}

/// A figure, the cases that it needs and what draws it.
struct PaperFigure {
  std::string name;
  CaseNames cases;
  std::function<void(const fs::path&, int, const std::vector<NamedRun>&)> write;
};

std::vector<PaperFigure> paper_figures() {
  const auto process = [](const char* field) {
    return [field](const fs::path& file, int width, const auto& runs) { write_process(file, width, runs, field); };
  };
  return {{"fig04", {"liakopoulos"}, write_column},
          {"fig06", base_case, write_retention},
          {"fig07", base_case, process("suction")},
          {"fig08", base_case, process("deviatoric_strain")},
          {"fig09", retention_cases, write_retention},
          {"fig10", retention_cases, write_failures},
          {"fig11", retention_cases, write_onsets},
          {"fig12", base_case,
           [](const fs::path& file, int width, const auto& runs) {
             write_mesh_picture(file, width, runs.front().run->input);
           }},
          {"fig13", retention_cases, write_displacements},
          {"fig14", retention_cases, write_suctions},
          {"fig15", conductivity_cases, write_failures},
          {"fig16", conductivity_cases, write_onsets},
          {"fig17", conductivity_cases, write_displacements},
          {"fig18", conductivity_cases, write_suctions}};
}

}  // namespace

PaperFigures write_paper_figures(const PaperRuns& runs, const fs::path& folder, int width) {
  make_folder(folder);
  PaperFigures result;
  for (const auto& figure : paper_figures()) {
    const fs::path file = folder / (figure.name + ".png");
    try {
      figure.write(file, width, find_runs(runs, figure.cases));
      result.written.push_back(file);
    } catch (const couple::FileError& reason) {
      result.left_out.push_back(fmt::format("{}: {}", figure.name, reason.what()));
    } catch (const LeftOut& reason) {
      result.left_out.push_back(fmt::format("{}: {}", figure.name, reason.what()));
    }
  }
  return result;
}

}  // namespace slope::tools
