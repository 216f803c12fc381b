#include "profile_file.hpp"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>

#include "quiet_vtk.hpp"
#include "slope/couple/read_case.hpp"
#include "text_file.hpp"

namespace slope::tools {

namespace {

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& message) {
  throw couple::InputError({{file.string(), 0, "", message}});
}

/// The numbers of the points along the line; cells that go on where the last one ends count as one line.
std::vector<vtkIdType> points_along(vtkPolyData& data, const std::filesystem::path& file) {
  std::vector<vtkIdType> along;
  vtkCellArray* lines = data.GetLines();
  lines->InitTraversal();
  vtkIdType count = 0;
  const vtkIdType* points = nullptr;
  while (lines->GetNextCell(count, points) != 0) {
    const bool goes_on = !along.empty() && count > 0 && points[0] == along.back();
    if (!along.empty() && !goes_on) refuse(file, "holds more than one poly-line; keep the one of the ground surface");
    along.insert(along.end(), points + (goes_on ? 1 : 0), points + count);
  }
  if (along.size() < 2) refuse(file, "holds no poly-line; write the ground surface as one line of points");
  return along;
}

}  // namespace

std::vector<std::array<double, 2>> read_poly_line(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) {
    throw couple::FileError(fmt::format("{}: cannot be read; does it exist?", file.string()));
  }
  const QuietVtk quiet;
  vtkNew<vtkXMLPolyDataReader> reader;
  if (reader->CanReadFile(file.c_str()) == 0) refuse(file, "is not a VTK PolyData file (.vtp)");
  reader->SetFileName(file.c_str());
  reader->Update();
  if (reader->GetErrorCode() != 0) refuse(file, "cannot be read as VTK PolyData; is it whole?");
  std::vector<std::array<double, 2>> line;
  for (const vtkIdType point : points_along(*reader->GetOutput(), file)) {
    const double* position = reader->GetOutput()->GetPoint(point);
    line.push_back({position[0], position[1]});
  }
  if (line.front()[0] > line.back()[0]) std::reverse(line.begin(), line.end());
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (line[i][0] >= line[i - 1][0]) continue;
    refuse(file, fmt::format("the poly-line turns back at x = {} m; a ground surface has no overhang", line[i][0]));
  }
  return line;
}

void write_profile(const std::filesystem::path& file, const std::vector<std::array<double, 2>>& line) {
  std::string content = "x_m,y_m\n";
  for (const auto& [x, y] : line) content += fmt::format("{},{}\n", x, y);
  write_at_once(file, content);
}

}  // namespace slope::tools
