#include "particle_file.hpp"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUtilities.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <system_error>

#include "quiet_vtk.hpp"
#include "slope/couple/read_case.hpp"

namespace slope::tools {
namespace {

namespace fs = std::filesystem;
using couple::FileError;

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

void write_polydata(vtkPolyData* data, const fs::path& file) {
  const fs::path unfinished = file.string() + ".part";
  const QuietVtk quiet;
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetFileName(unfinished.c_str());
  writer->SetInputData(data);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToZLib();
  if (writer->Write() != 1 || writer->GetErrorCode() != 0) {
    std::error_code ignored;
    fs::remove(unfinished, ignored);
    throw FileError(
        fmt::format("{}: cannot be written; is the disk full or the folder write-protected?", file.string()));
  }
  rename_or_throw(unfinished, file);
}

void write_collection(const std::vector<Snapshot>& snapshots, const fs::path& file) {
  const fs::path unfinished = file.string() + ".part";
  std::ofstream out(unfinished);
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\">\n  <Collection>\n";
  for (const auto& snapshot : snapshots) {
    out << fmt::format("    <DataSet timestep=\"{}\" group=\"\" part=\"0\" name=\"{}\" file=\"{}\"/>\n", snapshot.time,
                       snapshot.label, snapshot.file.filename().string());
  }
  out << "  </Collection>\n</VTKFile>\n";
  out.close();
  if (!out) {
    throw FileError(
        fmt::format("{}: cannot be written; is the disk full or the folder write-protected?", file.string()));
  }
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

std::vector<Snapshot> read_particle_series(const fs::path& directory) {
  const fs::path file = directory / particle_collection;
  if (!fs::is_regular_file(file)) {
    throw FileError(
        fmt::format("{}: not found; is {} an output folder of slope-sim?", file.string(), directory.string()));
  }
  const QuietVtk quiet;
  const auto root = vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromFile(file.c_str()));
  auto* collection = root != nullptr ? root->FindNestedElementWithName("Collection") : nullptr;
  if (collection == nullptr) {
    throw FileError(fmt::format("{}: is not a ParaView collection; run slope-sim again", file.string()));
  }
  std::vector<Snapshot> snapshots;
  for (int i = 0; i < collection->GetNumberOfNestedElements(); ++i) {
    auto* entry = collection->GetNestedElement(i);
    Snapshot snapshot;
    const char* name = entry->GetAttribute("name");
    const char* path = entry->GetAttribute("file");
    if (path == nullptr || entry->GetScalarAttribute("timestep", snapshot.time) == 0) {
      throw FileError(
          fmt::format("{}: entry {} lacks its file or timestep; run slope-sim again", file.string(), i + 1));
    }
    snapshot.label = name != nullptr ? name : "";
    snapshot.file = directory / path;
    snapshots.push_back(std::move(snapshot));
  }
  std::stable_sort(snapshots.begin(), snapshots.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
  return snapshots;
}

vtkSmartPointer<vtkPolyData> read_particles(const fs::path& file) {
  if (!fs::is_regular_file(file)) {
    throw FileError(fmt::format("{}: not found; run slope-sim again", file.string()));
  }
  const QuietVtk quiet;
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  if (reader->GetErrorCode() != 0 || reader->GetOutput()->GetFieldData()->GetArray("TimeValue") == nullptr) {
    throw FileError(fmt::format("{}: cannot be read as a VTK particle file; run slope-sim again", file.string()));
  }
  return reader->GetOutput();
}

}  // namespace slope::tools
