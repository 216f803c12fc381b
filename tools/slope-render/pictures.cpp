#include "pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contour_picture.hpp"
#include "drawable_particles.hpp"
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

/// Notes a picture that is written, or why it could not be.
template <class Write>
void write_picture(const fs::path& file, Pictures& pictures, Write write) {
  if (pictures.losses.attempt(write)) pictures.written.push_back(file);
}

void write_contours(const RunFolder& run, const PictureOptions& options, Pictures& pictures) {
  const auto fields = chosen_fields(options.fields);
  if (run.input.path.empty() || run.snapshots.empty()) return;
  const auto& times = options.times.empty() ? run.input.figures.contour_times : options.times;
  auto moments = times.empty() ? standard_moments(run) : moments_at(run, times, pictures.notes);
  std::vector<vtkSmartPointer<vtkPolyData>> particles;
  std::erase_if(moments, [&](const Moment& moment) {
    return !pictures.losses.attempt(
        [&] { particles.push_back(read_drawable_particles(moment.snapshot.file, pictures.losses)); });
  });
  for (const Field& field : fields) {
    const ColourScale scale = common_scale(field, particles);
    for (std::size_t i = 0; i < moments.size(); ++i) {
      const fs::path file = options.folder / fmt::format("{}_{}.png", field.name, moments[i].label);
      write_picture(file, pictures, [&] {
        write_contour_picture(
            file, options.width,
            {particles[i], field, scale, run.input.domain, run.input.failure_zone_strain, run.input.title,
             moments[i].caption, true, standing_water_at(run.input, moments[i].snapshot.time)});
      });
    }
  }
}

/// How the slope would flow when it was least safe.
void write_mechanism(const RunFolder& run, const PictureOptions& options, Pictures& pictures) {
  if (!run.summary || run.snapshots.empty() || run.input.path.empty()) return;
  std::vector<couple::FactorOfSafety> found = run.summary->found.safety;
  std::erase_if(found, [](const couple::FactorOfSafety& safety) { return safety.area <= 0.0; });
  if (found.empty()) return;
  const couple::FactorOfSafety least = *std::ranges::min_element(found, {}, &couple::FactorOfSafety::factor);
  const Field& field = field_called("mechanism_shear_strain");
  const Snapshot& snapshot = nearest_snapshot(run.snapshots, least.time);
  const fs::path file = options.folder / "mechanism.png";
  write_picture(file, pictures, [&] {
    const auto particles = read_drawable_particles(snapshot.file, pictures.losses);
    const std::string caption = fmt::format("t = {}, factor of safety {:.3f}", time_text(least.time), least.factor);
    write_contour_picture(
        file, options.width,
        {particles, field, common_scale(field, {particles}), run.input.domain, run.input.failure_zone_strain,
         run.input.title, caption, true, standing_water_at(run.input, least.time)});
  });
}

/// What a run is called in its charts.
std::string title_of(const RunFolder& run) {
  return run.input.path.empty() ? run.path.filename().string() : run.input.title;
}

void write_histories(const RunFolder& run, const PictureOptions& options, Pictures& pictures) {
  const auto write = [&](const char* name, const std::string& y_title, const std::vector<double>& chart_times,
                         std::vector<Curve> curves) {
    const fs::path file = options.folder / (std::string(name) + ".png");
    write_picture(file, pictures, [&] {
      write_history_chart(file, options.width,
                          {title_of(run), y_title, chart_times, std::move(curves), run.onset, other_onset(run)});
    });
  };
  const auto has_rows = [](const CsvTable& table) {
    return !table.columns.empty() && table.columns.front().size() > 1;
  };
  if (has_rows(run.history)) {
    const auto& times = run.history.columns.front();
    auto displacement = history_curves(run.history, "displacement");
    auto suction = history_curves(run.history, "suction");
    if (displacement.empty() && suction.empty()) {
      pictures.losses.leave_out(
          fmt::format("{}: has neither displacements nor suctions", (run.path / "history.csv").string()));
    }
    if (!displacement.empty()) {
      const auto [factor, unit] = length_unit(displacement);
      scale_curves(displacement, factor);
      write("displacement", "Displacement |u| (" + unit + ")", times, std::move(displacement));
    }
    if (!suction.empty()) {
      scale_curves(suction, 1.0e-3);
      write("suction", "Suction s (kPa)", times, std::move(suction));
    }
  }
  if (run.summary && run.summary->found.safety.size() > 1) {
    std::vector<double> safety_times;
    Curve factor{"factor of safety", {}}, one{"1", {}};
    for (const couple::FactorOfSafety& safety : run.summary->found.safety) {
      safety_times.push_back(safety.time);
      factor.values.push_back(safety.factor);
      one.values.push_back(1.0);
    }
    write("safety", "Factor of safety (-)", safety_times, {factor, one});
  }
  if (!has_rows(run.budget)) return;
  if (!has_amounts(run.budget)) {
    pictures.losses.leave_out(fmt::format("{}: has no amounts of water", (run.path / "budget.csv").string()));
  }
  auto budget = budget_curves(run.budget);
  if (!budget.empty()) write("budget", "Water since the start (m³/m)", run.budget.columns.front(), std::move(budget));
}

void write_profiles(const RunFolder& run, const PictureOptions& options, Pictures& pictures) {
  if (run.input.figures.profile_times.empty() || run.snapshots.empty()) {
    return;
  }
  const fs::path file = options.folder / "suction_profile.png";
  write_picture(file, pictures, [&] {
    write_profile_chart(file, options.width, run.input.title, timed_profiles(run, pictures.losses));
  });
}

}  // namespace

Pictures write_pictures(const RunFolder& run, const PictureOptions& options) {
  make_folder(options.folder);
  Pictures pictures;
  write_contours(run, options, pictures);
  write_mechanism(run, options, pictures);
  write_histories(run, options, pictures);
  write_profiles(run, options, pictures);
  return pictures;
}

}  // namespace slope::tools
