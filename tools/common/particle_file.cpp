#include "particle_file.hpp"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationStringKey.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <optional>
#include <system_error>

#include "particle_layout.hpp"
#include "quiet_vtk.hpp"
#include "slope/couple/read_case.hpp"
#include "slope/couple/text_file.hpp"
#include "xml_tags.hpp"

namespace slope::tools {
namespace {

namespace fs = std::filesystem;
using couple::FileError;

constexpr std::size_t most_collection_bytes = 10'000'000;  // a run writes 10,000 particle files at most

template <class Array = vtkDoubleArray>
vtkNew<Array> make_array(const char* name, int components, std::size_t count) {
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(count));
  return array;
}

vtkNew<vtkDoubleArray> scalars(const char* name, const std::vector<double>& values) {
  auto array = make_array(name, 1, values.size());
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  return array;
}

vtkNew<vtkDoubleArray> internal_scalars(const solid::InternalField& field) {
  auto array = scalars(field.name.c_str(), field.values);
  array->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), field.unit.c_str());
  return array;
}

vtkNew<vtkDoubleArray> vectors(const char* name, const std::vector<couple::Point>& values) {
  auto array = make_array(name, 3, values.size());
  for (std::size_t p = 0; p < values.size(); ++p) {
    array->SetTuple3(static_cast<vtkIdType>(p), values[p][0], values[p][1], 0.0);
  }
  return array;
}

vtkNew<vtkDoubleArray> tensors(const char* name, const std::vector<couple::PlaneTensor>& values) {
  auto array = make_array(name, 6, values.size());
  static constexpr std::array components{"XX", "YY", "ZZ", "XY", "YZ", "XZ"};
  for (int c = 0; c < 6; ++c) {
    array->SetComponentName(c, components[static_cast<std::size_t>(c)]);
  }
  for (std::size_t p = 0; p < values.size(); ++p) {
    const auto& t = values[p];
    array->SetTuple6(static_cast<vtkIdType>(p), t.xx, t.yy, t.zz, t.xy, 0.0, 0.0);
  }
  return array;
}

vtkNew<vtkPolyData> to_polydata(const couple::ParticleTable& particles, std::string_view label) {
  const std::size_t count = particles.position.size();
  vtkNew<vtkPolyData> data;

  vtkNew<vtkPoints> points;
  points->SetDataType(VTK_DOUBLE);
  points->SetNumberOfPoints(static_cast<vtkIdType>(count));
  vtkNew<vtkCellArray> vertices;
  auto id = make_array<vtkIntArray>("id", 1, count);
  for (std::size_t p = 0; p < count; ++p) {
    const auto index = static_cast<vtkIdType>(p);
    points->SetPoint(index, particles.position[p][0], particles.position[p][1], 0.0);
    vertices->InsertNextCell(1, &index);
    id->SetValue(index, static_cast<int>(p));
  }
  data->SetPoints(points);
  data->SetVerts(vertices);

  auto soil = make_array<vtkIntArray>("soil", 1, count);
  std::copy(particles.soil.begin(), particles.soil.end(), soil->GetPointer(0));

  auto* arrays = data->GetPointData();
  arrays->AddArray(vectors("displacement", particles.displacement));
  arrays->AddArray(vectors("velocity", particles.velocity));
  arrays->AddArray(tensors("stress_effective", particles.stress_effective));
  arrays->AddArray(tensors("strain", particles.strain));
  arrays->AddArray(scalars("deviatoric_strain", particles.deviatoric_strain));
  arrays->AddArray(scalars("plastic_strain", particles.plastic_strain));
  arrays->AddArray(scalars("pore_pressure", particles.pore_pressure));
  arrays->AddArray(scalars("suction", particles.suction));
  arrays->AddArray(scalars("saturation", particles.saturation));
  arrays->AddArray(scalars("porosity", particles.porosity));
  arrays->AddArray(vectors("darcy_velocity", particles.darcy_velocity));
  arrays->AddArray(soil);
  arrays->AddArray(id);
  arrays->AddArray(scalars("volume", particles.volume));
  for (const solid::InternalField& field : particles.internal) arrays->AddArray(internal_scalars(field));

  data->GetFieldData()->AddArray(scalars("TimeValue", {particles.time}));
  vtkNew<vtkStringArray> name;
  name->SetName("label");
  name->InsertNextValue(std::string(label));
  data->GetFieldData()->AddArray(name);
  return data;
}

void rename_or_throw(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::rename(from, to, error);
  if (error) {
    throw FileError(fmt::format("{}: cannot be written: {}", to.string(), error.message()));
  }
}

/// Takes away what was begun and tells why it was not finished, from errno.
[[noreturn]] void give_up(const fs::path& unfinished, const fs::path& file) {
  const std::string reason = errno != 0 ? std::strerror(errno) : "is the disk full or the folder write-protected?";
  std::error_code ignored;
  fs::remove(unfinished, ignored);
  throw FileError(fmt::format("{}: cannot be written: {}", file.string(), reason));
}

void write_polydata(vtkPolyData* data, const fs::path& file) {
  const fs::path unfinished = file.string() + ".part";
  const QuietVtk quiet;
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetFileName(unfinished.c_str());
  writer->SetInputData(data);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToZLib();
  errno = 0;
  if (writer->Write() != 1 || writer->GetErrorCode() != 0) give_up(unfinished, file);
  rename_or_throw(unfinished, file);
}

void write_collection(const std::vector<Snapshot>& snapshots, const fs::path& file) {
  const fs::path unfinished = file.string() + ".part";
  errno = 0;
  std::ofstream out(unfinished);
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\">\n  <Collection>\n";
  for (const auto& snapshot : snapshots) {
    out << fmt::format("    <DataSet timestep=\"{}\" group=\"\" part=\"0\" name=\"{}\" file=\"{}\"/>\n", snapshot.time,
                       snapshot.label, snapshot.file.filename().string());
  }
  out << "  </Collection>\n</VTKFile>\n";
  out.close();
  if (!out) give_up(unfinished, file);
  rename_or_throw(unfinished, file);
}

std::string particle_file_name(std::size_t number) {
  return fmt::format("particles_{:04}.vtp", number);
}

}  // namespace

ParticleFileSeries::ParticleFileSeries(fs::path directory) : directory_(std::move(directory)) {
  std::error_code error;
  fs::create_directories(directory_, error);
  if (error) {
    throw FileError(fmt::format("{}: cannot be created: {}", directory_.string(), error.message()));
  }
}

ParticleFileSeries::ParticleFileSeries(fs::path directory, std::size_t kept_files) : directory_(std::move(directory)) {
  if (kept_files > 0) written_ = read_particle_series(directory_);
  for (std::size_t i = 0; i < kept_files; ++i) {
    if (i < written_.size() && fs::is_regular_file(written_[i].file)) continue;
    throw FileError(fmt::format("{}: is not there, and the checkpoint counts on it",
                                (directory_ / particle_file_name(i)).string()));
  }
  written_.resize(kept_files);
  std::error_code error;
  std::size_t beyond = kept_files;
  while (fs::remove(directory_ / particle_file_name(beyond), error)) ++beyond;
  if (!error) fs::remove(directory_ / (particle_file_name(beyond) + ".part"), error);
  if (!error && kept_files == 0) fs::remove(directory_ / particle_collection, error);
  if (error) throw FileError(fmt::format("{}: cannot be changed: {}", directory_.string(), error.message()));
  if (kept_files > 0) write_collection(written_, directory_ / particle_collection);
}

fs::path ParticleFileSeries::write(const couple::ParticleTable& particles, std::string_view label) {
  const fs::path file = directory_ / particle_file_name(written_.size());
  write_polydata(to_polydata(particles, label), file);

  auto snapshots = written_;
  snapshots.push_back({particles.time, std::string(label), file});
  write_collection(snapshots, directory_ / particle_collection);
  written_ = std::move(snapshots);
  return file;
}

namespace {

/// A time that a run can have.
std::optional<double> time_of(std::string_view text) {
  double time = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), time);
  const bool sound = error == std::errc() && end == text.data() + text.size() && std::abs(time) <= largest_drawn;
  return sound ? std::optional(time) : std::nullopt;
}

std::vector<Snapshot> in_order(std::vector<Snapshot> snapshots) {
  std::stable_sort(snapshots.begin(), snapshots.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
  return snapshots;
}

}  // namespace

std::vector<Snapshot> read_particle_series(const fs::path& directory) {
  const fs::path file = directory / particle_collection;
  const std::string content = couple::read_text_file(file, most_collection_bytes);
  std::vector<Snapshot> snapshots;
  for (const XmlTag& tag : xml_tags(content)) {
    if (tag.name != "DataSet") continue;
    const auto time = time_of(tag.value("timestep"));
    const std::string_view path = tag.value("file");
    if (!time || path.empty())
      throw FileError(fmt::format("{}: entry {} lacks its file or time", file.string(), snapshots.size() + 1));
    snapshots.push_back({*time, std::string(tag.value("name")), directory / path});
  }
  if (snapshots.empty()) throw FileError(fmt::format("{}: names no particle file", file.string()));
  return in_order(std::move(snapshots));
}

std::vector<Snapshot> find_particle_files(const fs::path& directory) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator entry(directory, error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (name.starts_with("particles_") && name.ends_with(".vtp")) files.push_back(entry->path());
  }
  std::sort(files.begin(), files.end());
  std::vector<Snapshot> snapshots;
  for (const fs::path& file : files) {
    try {
      const auto particles = read_particles(file);
      auto* label = vtkStringArray::SafeDownCast(particles->GetFieldData()->GetAbstractArray("label"));
      snapshots.push_back({particles->GetFieldData()->GetArray("TimeValue")->GetComponent(0, 0),
                           label != nullptr && label->GetNumberOfValues() > 0 ? label->GetValue(0) : "", file});
    } catch (const FileError&) {  // one that cannot be read has no time either
    }
  }
  return in_order(std::move(snapshots));
}

vtkSmartPointer<vtkPolyData> read_particles(const fs::path& file) {
  check_particle_layout(file);
  const QuietVtk quiet;
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  if (reader->GetErrorCode() != 0) throw FileError(fmt::format("{}: is cut short or damaged", file.string()));
  vtkDataArray* time = reader->GetOutput()->GetFieldData()->GetArray("TimeValue");
  if (time == nullptr) throw FileError(fmt::format("{}: has no array \"TimeValue\"", file.string()));
  if (time->GetNumberOfTuples() < 1 || !(std::abs(time->GetComponent(0, 0)) <= largest_drawn))
    throw FileError(fmt::format("{}: has no time", file.string()));
  return reader->GetOutput();
}

}  // namespace slope::tools
