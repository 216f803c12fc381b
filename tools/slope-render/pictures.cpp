#include "pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contour_picture.hpp"
#include "history_chart.hpp"
#include "profile_chart.hpp"
#include "run_curves.hpp"
#include "time_unit.hpp"

namespace slope::tools {
namespace {

namespace fs = std::filesystem;

/// A snapshot of which contour pictures are drawn.
struct Moment {
  std::string label;  ///< in the pictures' file names
  std::string caption;
  Snapshot snapshot;
};

constexpr double same_moment = 1.0e-6;  // share of a time by which a snapshot may be beside it

std::vector<Moment> moments_at(const RunFolder& run, const std::vector<double>& times,
                               std::vector<std::string>& notes) {
  std::vector<Moment> moments;
  for (const double time : times) {
    const Snapshot& snapshot = nearest_snapshot(run.snapshots, time);
    if (std::abs(snapshot.time - time) > same_moment * std::max(time, 1.0)) {
      notes.push_back(fmt::format("t = {:.10g} s: there is no snapshot; the nearest one, of {:.10g} s, was drawn", time,
                                  snapshot.time));
    }
    moments.push_back({fmt::format("{}s", time), "t = " + time_text(snapshot.time), snapshot});
  }
  return moments;
}

std::vector<Moment> standard_moments(const RunFolder& run) {
  const auto caption = [](const char* what, const Snapshot& snapshot) {
    return "t = " + time_text(snapshot.time) + " (" + what + ")";
  };
  const auto& snapshots = run.snapshots;
  std::vector<Moment> moments{{"start", caption("start", snapshots.front()), snapshots.front()}};
  const auto onset = std::find_if(snapshots.begin(), snapshots.end(), [](const auto& s) { return s.label == "onset"; });
  if (onset != snapshots.end()) {
    moments.push_back({"onset", caption("onset of failure", *onset), *onset});
  }
  const bool complete = snapshots.back().label == "end";
  moments.push_back(
      {"end", caption(complete ? "end" : "last of an unfinished run", snapshots.back()), snapshots.back()});
  return moments;
}

std::vector<Field> chosen_fields(const std::vector<std::string>& names) {
  if (names.empty()) {
    return {field_called("suction"), field_called("deviatoric_strain")};
  }
  std::vector<Field> fields;
  for (const auto& name : names) {
    fields.push_back(field_called(name));
  }
  return fields;
}

void write_contours(const RunFolder& run, const PictureOptions& options, Pictures& pictures) {
  const auto& times = options.times.empty() ? run.input.figures.contour_times : options.times;
  const auto moments = times.empty() ? standard_moments(run) : moments_at(run, times, pictures.notes);
  std::vector<vtkSmartPointer<vtkPolyData>> particles;
  for (const auto& moment : moments) {
    particles.push_back(read_particles(moment.snapshot.file));
  }
  for (const Field& field : chosen_fields(options.fields)) {
    const ColourScale scale = common_scale(field, particles);
    for (std::size_t i = 0; i < moments.size(); ++i) {
      const fs::path file = options.folder / fmt::format("{}_{}.png", field.name, moments[i].label);
      write_contour_picture(
          file, options.width,
          {particles[i], field, scale, run.input.domain, run.input.failure_zone_strain, run.input.title,
           moments[i].caption, true, standing_water_at(run.input, moments[i].snapshot.time)});
      pictures.written.push_back(file);
    }
  }
}

void write_histories(const RunFolder& run, const PictureOptions& options, std::vector<fs::path>& written) {
  if (run.history.columns.empty() || run.history.columns.front().size() < 2) {
    return;
  }
  const auto write = [&](const char* name, const std::string& y_title, std::vector<Curve> curves) {
    const fs::path file = options.folder / (std::string(name) + ".png");
    write_history_chart(
        file, options.width,
        {run.input.title, y_title, run.history.columns.front(), std::move(curves), run.onset, other_onset(run)});
    written.push_back(file);
  };
  auto displacement = history_curves(run.history, "displacement");
  if (!displacement.empty()) {
    const auto [factor, unit] = length_unit(displacement);
    scale_curves(displacement, factor);
    write("displacement", "Displacement |u| (" + unit + ")", std::move(displacement));
  }
  auto suction = history_curves(run.history, "suction");
  if (!suction.empty()) {
    scale_curves(suction, 1.0e-3);
    write("suction", "Suction s (kPa)", std::move(suction));
  }
  auto budget = budget_curves(run.budget);
  if (!budget.empty()) {
    const fs::path file = options.folder / "budget.png";
    write_history_chart(file, options.width,
                        {run.input.title, "Water since the start (m³/m)", run.budget.columns.front(), std::move(budget),
                         run.onset, other_onset(run)});
    written.push_back(file);
  }
}

void write_profiles(const RunFolder& run, const PictureOptions& options, std::vector<fs::path>& written) {
  if (run.input.figures.profile_times.empty()) {
    return;
  }
  const fs::path file = options.folder / "suction_profile.png";
  write_profile_chart(file, options.width, run.input.title, timed_profiles(run));
  written.push_back(file);
}

}  // namespace

Pictures write_pictures(const RunFolder& run, const PictureOptions& options) {
  make_folder(options.folder);
  Pictures pictures;
  write_contours(run, options, pictures);
  write_histories(run, options, pictures.written);
  write_profiles(run, options, pictures.written);
  return pictures;
}

}  // namespace slope::tools
