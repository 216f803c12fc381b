#include "pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "contour_picture.hpp"
#include "history_chart.hpp"
#include "profile_chart.hpp"
#include "slope/couple/read_case.hpp"

namespace slope::tools {
namespace {

namespace fs = std::filesystem;

/// A snapshot of which contour pictures are drawn.
struct Moment {
  std::string label;  ///< in the pictures' file names
  std::string caption;
  Snapshot snapshot;
};

std::vector<Moment> moments_at(const RunFolder& run, const std::vector<double>& times) {
  std::vector<Moment> moments;
  for (const double time : times) {
    const Snapshot& snapshot = nearest_snapshot(run.snapshots, time);
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
  std::vector<Field> fields;
  for (const auto& name : names.empty() ? std::vector<std::string>{"suction", "deviatoric_strain"} : names) {
    const auto& known = drawable_fields();
    const auto found = std::find_if(known.begin(), known.end(), [&name](const auto& f) { return f.name == name; });
    if (found == known.end()) {
      std::string all;
      for (const auto& field : known) {
        all += (all.empty() ? "" : ", ") + field.name;
      }
      throw std::invalid_argument(fmt::format("no field is called \"{}\"; choose from {}", name, all));
    }
    fields.push_back(*found);
  }
  return fields;
}

void write_contours(const RunFolder& run, const PictureOptions& options, std::vector<fs::path>& written) {
  const auto& times = options.times.empty() ? run.input.figures.contour_times : options.times;
  const auto moments = times.empty() ? standard_moments(run) : moments_at(run, times);
  std::vector<vtkSmartPointer<vtkPolyData>> particles;
  for (const auto& moment : moments) {
    particles.push_back(read_particles(moment.snapshot.file));
  }
  for (const Field& field : chosen_fields(options.fields)) {
    const ColourScale scale = common_scale(field, particles);
    for (std::size_t i = 0; i < moments.size(); ++i) {
      const fs::path file = options.folder / fmt::format("{}_{}.png", field.name, moments[i].label);
      write_contour_picture(file, options.width,
                            {particles[i], field, scale, run.input.domain, run.input.failure_zone_strain,
                             run.input.title, moments[i].caption});
      written.push_back(file);
    }
  }
}

/// The history's columns "<point> <quantity> [unit]" as curves named after their points.
std::vector<Curve> history_curves(const CsvTable& history, const std::string& quantity) {
  std::vector<Curve> curves;
  for (std::size_t c = 0; c < history.names.size(); ++c) {
    const std::string name = history.names[c].substr(0, history.names[c].find(" ["));
    const std::string ending = " " + quantity;
    if (name.ends_with(ending)) {
      curves.push_back({name.substr(0, name.size() - ending.size()), history.columns[c]});
    }
  }
  return curves;
}

void scale_curves(std::vector<Curve>& curves, double factor) {
  for (auto& curve : curves) {
    for (double& value : curve.values) {
      value *= factor;
    }
  }
}

/// Metres, centimetres or millimetres, whichever gives handy numbers.
std::pair<double, std::string> length_unit(const std::vector<Curve>& curves) {
  double largest = 0.0;
  for (const auto& curve : curves) {
    for (const double value : curve.values) {
      largest = std::max(largest, std::abs(value));
    }
  }
  if (largest >= 0.5) {
    return {1.0, "m"};
  }
  return largest >= 0.02 ? std::pair{100.0, std::string("cm")} : std::pair{1000.0, std::string("mm")};
}

void write_histories(const RunFolder& run, const PictureOptions& options, std::vector<fs::path>& written) {
  if (run.history.columns.empty() || run.history.columns.front().size() < 2) {
    return;
  }
  const auto write = [&](const char* name, const std::string& y_title, std::vector<Curve> curves) {
    const fs::path file = options.folder / (std::string(name) + ".png");
    write_history_chart(file, options.width,
                        {run.input.title, y_title, run.history.columns.front(), std::move(curves), run.onset});
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
}

void write_profiles(const RunFolder& run, const PictureOptions& options, std::vector<fs::path>& written) {
  const auto& figures = run.input.figures;
  if (figures.profile_times.empty()) {
    return;
  }
  std::vector<TimedProfile> profiles;
  for (const double time : figures.profile_times) {
    const Snapshot& snapshot = nearest_snapshot(run.snapshots, time);
    TimedProfile profile{time, snapshot.time, {}, {}};
    profile.computed = suction_profile(read_particles(snapshot.file), run.input.water.unit_weight());
    if (!figures.profile_reference.empty()) {
      profile.reference = reference_profile(run.path / figures.profile_reference, time);
    }
    profiles.push_back(std::move(profile));
  }
  const fs::path file = options.folder / "suction_profile.png";
  write_profile_chart(file, options.width, run.input.title, profiles);
  written.push_back(file);
}

}  // namespace

std::vector<fs::path> write_pictures(const RunFolder& run, const PictureOptions& options) {
  std::error_code error;
  fs::create_directories(options.folder, error);
  if (error) {
    throw couple::FileError(fmt::format("{}: cannot be created: {}", options.folder.string(), error.message()));
  }
  std::vector<fs::path> written;
  write_contours(run, options, written);
  write_histories(run, options, written);
  write_profiles(run, options, written);
  return written;
}

}  // namespace slope::tools
