#include <gtest/gtest.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationStringKey.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>

#include <filesystem>
#include <fstream>

#include "particle_file.hpp"
#include "scratch_folder.hpp"
#include "slope/couple/read_case.hpp"

namespace slope::tools::test {
namespace {

/// Three particles with a different number in every component of every field.
couple::ParticleTable numbered_particles(double time) {
  couple::ParticleTable table;
  table.time = time;
  double number = 0.1;
  const auto next = [&number] { return number += 1.0 / 3.0; };
  for (int p = 0; p < 3; ++p) {
    for (auto* field : {&table.position, &table.displacement, &table.velocity, &table.darcy_velocity}) {
      const double x = next();
      field->push_back({x, next()});
    }
    for (auto* field : {&table.stress_effective, &table.strain}) {
      couple::PlaneTensor tensor;
      for (double* component : {&tensor.xx, &tensor.yy, &tensor.zz, &tensor.xy}) {
        *component = next();
      }
      field->push_back(tensor);
    }
    for (auto* field : {&table.deviatoric_strain, &table.plastic_strain, &table.pore_pressure, &table.suction,
                        &table.saturation, &table.porosity, &table.volume}) {
      field->push_back(next());
    }
    table.soil.push_back(7 * p);
  }
  return table;
}

double value(vtkPolyData* data, const char* array, vtkIdType particle, int component = 0) {
  auto* found = data->GetPointData()->GetArray(array);
  EXPECT_NE(found, nullptr) << array;
  return found != nullptr ? found->GetComponent(particle, component) : -1.0e99;
}

void expect_vector(vtkPolyData* data, const char* array, vtkIdType p, const couple::Point& expected) {
  EXPECT_EQ(value(data, array, p, 0), expected[0]) << array;
  EXPECT_EQ(value(data, array, p, 1), expected[1]) << array;
  EXPECT_EQ(value(data, array, p, 2), 0.0) << array;
}

void expect_tensor(vtkPolyData* data, const char* array, vtkIdType p, const couple::PlaneTensor& expected) {
  const std::array<double, 6> components{expected.xx, expected.yy, expected.zz, expected.xy, 0.0, 0.0};
  for (int c = 0; c < 6; ++c) {
    EXPECT_EQ(value(data, array, p, c), components[static_cast<std::size_t>(c)]) << array;
  }
}

TEST(ParticleFile, GivesBackEveryValue) {
  const ScratchFolder folder;
  const auto table = numbered_particles(459.1);
  const auto file = ParticleFileSeries(folder.path()).write(table, "onset");

  const auto data = read_particles(file);
  ASSERT_EQ(data->GetNumberOfPoints(), 3);
  EXPECT_EQ(data->GetNumberOfVerts(), 3);
  EXPECT_EQ(data->GetPointData()->GetNumberOfArrays(), 14);
  for (int p = 0; p < 3; ++p) {
    const auto i = static_cast<std::size_t>(p);
    EXPECT_EQ(data->GetPoint(p)[0], table.position[i][0]);
    EXPECT_EQ(data->GetPoint(p)[1], table.position[i][1]);
    expect_vector(data, "displacement", p, table.displacement[i]);
    expect_vector(data, "velocity", p, table.velocity[i]);
    expect_vector(data, "darcy_velocity", p, table.darcy_velocity[i]);
    expect_tensor(data, "stress_effective", p, table.stress_effective[i]);
    expect_tensor(data, "strain", p, table.strain[i]);
    EXPECT_EQ(value(data, "deviatoric_strain", p), table.deviatoric_strain[i]);
    EXPECT_EQ(value(data, "plastic_strain", p), table.plastic_strain[i]);
    EXPECT_EQ(value(data, "pore_pressure", p), table.pore_pressure[i]);
    EXPECT_EQ(value(data, "suction", p), table.suction[i]);
    EXPECT_EQ(value(data, "saturation", p), table.saturation[i]);
    EXPECT_EQ(value(data, "porosity", p), table.porosity[i]);
    EXPECT_EQ(value(data, "volume", p), table.volume[i]);
    EXPECT_EQ(value(data, "soil", p), table.soil[i]);
    EXPECT_EQ(value(data, "id", p), p);
  }
  EXPECT_STREQ(data->GetPointData()->GetArray("strain")->GetComponentName(3), "XY");
  EXPECT_EQ(data->GetFieldData()->GetArray("TimeValue")->GetComponent(0, 0), 459.1);
  auto* label = vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray("label"));
  ASSERT_NE(label, nullptr);
  EXPECT_EQ(label->GetValue(0), "onset");
}

TEST(ParticleFile, HoldsWhatTheStrengthLawsKeepWithItsUnit) {
  const ScratchFolder folder;
  auto table = numbered_particles(0.0);
  table.internal = {{"preconsolidation_pressure", "Pa", {1.5e5, 0.0, 2.5e5}}, {"second", "-", {0.1, 0.2, 0.3}}};
  const auto data = read_particles(ParticleFileSeries(folder.path()).write(table));
  EXPECT_EQ(data->GetPointData()->GetNumberOfArrays(), 16);
  EXPECT_EQ(value(data, "preconsolidation_pressure", 2), 2.5e5);
  EXPECT_EQ(value(data, "second", 1), 0.2);
  auto* information = data->GetPointData()->GetArray("preconsolidation_pressure")->GetInformation();
  ASSERT_TRUE(information->Has(vtkDataArray::UNITS_LABEL()));
  EXPECT_STREQ(information->Get(vtkDataArray::UNITS_LABEL()), "Pa");
}

TEST(ParticleFile, SeriesIsCompleteAfterEachWrite) {
  const ScratchFolder folder;
  ParticleFileSeries series(folder.path() / "out");
  series.write(numbered_particles(0.0), "start");
  EXPECT_EQ(read_particle_series(folder.path() / "out").size(), 1U);
  series.write(numbered_particles(0.1), "");

  const auto snapshots = read_particle_series(folder.path() / "out");
  ASSERT_EQ(snapshots.size(), 2U);
  EXPECT_EQ(snapshots[0].time, 0.0);
  EXPECT_EQ(snapshots[0].label, "start");
  EXPECT_EQ(snapshots[1].time, 0.1);
  EXPECT_EQ(snapshots[1].label, "");
  EXPECT_EQ(snapshots[1].file.filename(), "particles_0001.vtp");
  EXPECT_EQ(read_particles(snapshots[1].file)->GetNumberOfPoints(), 3);
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "out")) {
    EXPECT_NE(entry.path().extension(), ".part") << "left over: " << entry.path();
  }
}

TEST(ParticleFile, UnwritableFolderIsAFileError) {
  const ScratchFolder folder;
  std::ofstream(folder.path() / "file") << "not a folder";
  EXPECT_THROW(ParticleFileSeries(folder.path() / "file" / "out"), couple::FileError);

  ParticleFileSeries series(folder.path() / "gone");
  std::filesystem::remove_all(folder.path() / "gone");
  EXPECT_THROW(series.write(numbered_particles(0.0)), couple::FileError);
}

TEST(ParticleFile, UnreadableFilesAreFileErrors) {
  const ScratchFolder folder;
  EXPECT_THROW((void)read_particle_series(folder.path()), couple::FileError);
  std::ofstream(folder.path() / "particles.pvd") << "not XML";
  EXPECT_THROW((void)read_particle_series(folder.path()), couple::FileError);
  std::ofstream(folder.path() / "broken.vtp") << "<VTKFile type=\"PolyData\"";
  EXPECT_THROW((void)read_particles(folder.path() / "broken.vtp"), couple::FileError);
  EXPECT_THROW((void)read_particles(folder.path() / "missing.vtp"), couple::FileError);

  const auto cut_short = ParticleFileSeries(folder.path()).write(numbered_particles(0.0));
  std::filesystem::resize_file(cut_short, std::filesystem::file_size(cut_short) - 200);
  EXPECT_THROW((void)read_particles(cut_short), couple::FileError);
}

}  // namespace
}  // namespace slope::tools::test
