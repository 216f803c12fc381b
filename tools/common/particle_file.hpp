#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "slope/couple/simulation.hpp"

namespace slope::tools {

/// One particle file of a run.
struct Snapshot {
  double time = 0.0;           ///< since the start of the rain (s)
  std::string label;           ///< "start", "onset", "end", or empty
  std::filesystem::path file;  ///< VTK PolyData (.vtp)
};

/// Name of the collection that lists a run's particle files; ParaView opens it as one time series.
inline constexpr std::string_view particle_collection = "particles.pvd";

/// Writes the particles of a run as particles_NNNN.vtp, compressed, and keeps particles.pvd up to date.
///
/// Each file appears under its name only when it is complete, and the collection names only complete files, so that
/// a run that is killed leaves a series that can be read.
///
/// Point arrays (SI units, tension positive, pore pressure positive in compression): displacement, velocity,
/// darcy_velocity (3 components), stress_effective, strain (XX YY ZZ XY YZ XZ), deviatoric_strain, plastic_strain,
/// pore_pressure, suction, saturation, porosity, volume, soil, id; and what the strength laws keep, with the unit as
/// UNITS_LABEL: preconsolidation_pressure. Field data: TimeValue (s) and label.
class ParticleFileSeries {
 public:
  /// Starts a new series in a directory, which is created if need be; an older series there is overwritten file by
  /// file.
  /// @throws couple::FileError if the directory cannot be created.
  explicit ParticleFileSeries(std::filesystem::path directory);

  /// Goes on with an earlier series, of which it keeps the first files; what lies beyond is removed.
  /// @throws couple::FileError if it has less files, or cannot be changed.
  ParticleFileSeries(std::filesystem::path directory, std::size_t kept_files);

  /// In the order in which they were written.
  [[nodiscard]] const std::vector<Snapshot>& written() const { return written_; }

  /// Adds a snapshot.
  /// @param label  what slope-render looks for: "start", "onset", "end"; empty for the others.
  /// @return the file that was written.
  /// @throws couple::FileError if it cannot be written; the series then stays as it was.
  std::filesystem::path write(const couple::ParticleTable& particles, std::string_view label = {});

 private:
  std::filesystem::path directory_;
  std::vector<Snapshot> written_;
};

/// No result of a run is larger, in SI units: what is comes from a run that broke, or from a file that is damaged.
inline constexpr double largest_drawn = 1.0e15;

/// The snapshots that the collection of a directory names, in the order of time; at least one.
/// @throws couple::FileError if there is no collection, or it cannot be read, or it names no file.
[[nodiscard]] std::vector<Snapshot> read_particle_series(const std::filesystem::path& directory);

/// The snapshots of a directory whose collection is lost, in the order of time: each particle file knows its own time
/// and label. One that cannot be read is left out.
[[nodiscard]] std::vector<Snapshot> find_particle_files(const std::filesystem::path& directory);

/// One particle file, with the arrays that ParticleFileSeries writes.
/// @throws couple::FileError if it cannot be read or is damaged.
[[nodiscard]] vtkSmartPointer<vtkPolyData> read_particles(const std::filesystem::path& file);

}  // namespace slope::tools
