#pragma once

#include <vtkPolyData.h>

#include <filesystem>
#include <string>
#include <vector>

namespace slope::tools {

/// Suction head over height.
struct Profile {
  std::vector<double> head;    ///< (m)
  std::vector<double> height;  ///< (m)
};

/// The computed profile at one time and, if there is one, the reference's.
struct TimedProfile {
  double time = 0.0;           ///< asked for (s)
  double snapshot_time = 0.0;  ///< of the snapshot that lies nearest (s)
  Profile computed;
  Profile reference;
};

/// Mean suction head of the particles in each layer one spacing thick.
/// @param unit_weight  of water (N/m3).
[[nodiscard]] Profile suction_profile(vtkPolyData* particles, double unit_weight);

/// The column suction_head_m_t<time> of a reference file over its column z_m; empty if it has none for this time.
/// Lines that begin with '#' are comments, but for one that begins with "# z_m", which is the header.
/// @throws couple::FileError if the file cannot be read or has no such columns at all.
[[nodiscard]] Profile reference_profile(const std::filesystem::path& file, double time);

/// Points for what was computed and lines for the reference, one colour for each time.
/// @throws couple::FileError if it cannot be written.
void write_profile_chart(const std::filesystem::path& file, int width, const std::string& title,
                         const std::vector<TimedProfile>& profiles);

}  // namespace slope::tools
