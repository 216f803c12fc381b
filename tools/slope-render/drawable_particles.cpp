#include "drawable_particles.hpp"

#include <fmt/format.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "contour_panel.hpp"
#include "particle_file.hpp"

namespace slope::tools {

namespace {

/// A volume so many times the median is that of a run that broke.
constexpr double largest_volume = 1.0e4;

/// Arrays without which no picture can be drawn.
std::vector<std::string> needed_arrays() {
  std::vector<std::string> names{"volume"};
  for (const Field& field : drawable_fields()) {
    if (field.in_every_run) names.push_back(field.array);
  }
  return names;
}

double median_volume(vtkDataArray* volume) {
  std::vector<double> values;
  for (vtkIdType p = 0; p < volume->GetNumberOfTuples(); ++p) {
    const double value = volume->GetComponent(p, 0);
    if (value > 0.0 && value <= largest_drawn) values.push_back(value);
  }
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

bool is_sound(vtkDataArray* array, vtkIdType particle) {
  for (int c = 0; c < array->GetNumberOfComponents(); ++c) {
    if (!(std::abs(array->GetComponent(particle, c)) <= largest_drawn)) return false;
  }
  return true;
}

vtkSmartPointer<vtkPolyData> only(vtkPolyData* all, const std::vector<vtkIdType>& kept) {
  auto some = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(VTK_DOUBLE);
  some->GetPointData()->CopyAllocate(all->GetPointData());
  for (const vtkIdType p : kept) {
    some->GetPointData()->CopyData(all->GetPointData(), p, points->InsertNextPoint(all->GetPoint(p)));
  }
  some->SetPoints(points);
  return some;
}

}  // namespace

vtkSmartPointer<vtkPolyData> read_drawable_particles(const std::filesystem::path& file, Losses& losses) {
  auto particles = read_particles(file);
  std::vector<vtkDataArray*> arrays;
  for (const std::string& name : needed_arrays()) {
    vtkDataArray* array = particles->GetPointData()->GetArray(name.c_str());
    if (array == nullptr) throw couple::FileError(fmt::format("{}: has no array \"{}\"", file.string(), name));
    arrays.push_back(array);
  }
  vtkDataArray* volume = arrays.front();
  if (particles->GetPoints() != nullptr) arrays.push_back(particles->GetPoints()->GetData());
  const double most = largest_volume * median_volume(volume);
  std::vector<vtkIdType> kept;
  for (vtkIdType p = 0; p < particles->GetNumberOfPoints(); ++p) {
    const double v = volume->GetComponent(p, 0);
    const bool sound = std::ranges::all_of(arrays, [p](vtkDataArray* array) { return is_sound(array, p); });
    if (sound && v > 0.0 && v <= most) kept.push_back(p);
  }
  const auto count = particles->GetNumberOfPoints();
  const auto found = static_cast<vtkIdType>(kept.size());
  if (found == 0) throw couple::FileError(fmt::format("{}: holds no particle that can be drawn", file.string()));
  if (found == count) return particles;
  losses.leave_out(fmt::format("{}: {} of {} particles have values that are no numbers, or no volume, and are left out",
                               file.string(), count - found, count));
  return only(particles, kept);
}

}  // namespace slope::tools
