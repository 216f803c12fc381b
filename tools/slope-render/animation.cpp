#include "animation.hpp"

#include "contour_picture.hpp"
#include "drawable_particles.hpp"
#include "time_unit.hpp"

namespace slope::tools {

FrameSequence write_frames(const RunFolder& run, const std::string& field, const std::filesystem::path& folder,
                           int width, Losses& losses) {
  const Field& drawn = field_called(field);
  make_folder(folder);
  std::vector<vtkSmartPointer<vtkPolyData>> particles;
  std::vector<Snapshot> snapshots;
  for (const auto& snapshot : run.snapshots) {
    const bool read = losses.attempt([&] { particles.push_back(read_drawable_particles(snapshot.file, losses)); });
    if (read) snapshots.push_back(snapshot);
  }
  const ColourScale scale = common_scale(drawn, particles);
  FrameSequence frames{folder, field, 0};
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const auto& snapshot = snapshots[i];
    const bool failed = run.onset && snapshot.time >= *run.onset;
    const std::string caption = "t = " + time_text(snapshot.time) + (failed ? ", after the onset of failure" : "");
    write_contour_picture(frames.frame(frames.count++), width,
                          {particles[i], drawn, scale, run.input.domain, run.input.failure_zone_strain, run.input.title,
                           caption, true, standing_water_at(run.input, snapshot.time)});
  }
  std::error_code error;
  for (int i = frames.count; std::filesystem::remove(frames.frame(i), error); ++i) {
  }
  return frames;
}

}  // namespace slope::tools
