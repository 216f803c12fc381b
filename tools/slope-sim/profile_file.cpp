#include "profile_file.hpp"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "quiet_vtk.hpp"
#include "slope/couple/read_case.hpp"
#include "slope/couple/text_file.hpp"
#include "text_file.hpp"
#include "xml_tags.hpp"

namespace slope::tools {

namespace {

constexpr std::size_t most_bytes = 100'000'000;
constexpr int most_points = 1'000'000;  // of a ground surface
constexpr int most_components = 9;      // of an array: those of a tensor

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& message) {
  throw couple::InputError({{file.string(), 0, "", message}});
}

/// Refuses a file whose head claims what no ground surface has: VTK would ask for the memory first.
void check_head(const std::string& content, const std::filesystem::path& file) {
  const auto check = [&](const XmlTag& tag, std::string_view attribute, int most) {
    const std::string_view text = tag.value(attribute);
    if (text.empty()) return;
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc() && end == text.data() + text.size() && value >= 0 && value <= most) return;
    refuse(file, fmt::format("has {}=\"{}\"; from 0 to {} can be read", attribute, couple::shortened(text), most));
  };
  const std::size_t data = content.find("<AppendedData");
  for (const XmlTag& tag : xml_tags(std::string_view(content).substr(0, data))) {
    if (tag.name == "Piece") {
      for (const auto* what : {"NumberOfPoints", "NumberOfVerts", "NumberOfLines", "NumberOfStrips", "NumberOfPolys"}) {
        check(tag, what, most_points);
      }
    } else if (tag.name == "DataArray") {
      check(tag, "NumberOfComponents", most_components);
      check(tag, "NumberOfTuples", most_points);
    }
  }
}

/// The numbers of the points along the line; cells that go on where the last one ends count as one line.
std::vector<vtkIdType> points_along(vtkPolyData& data, const std::filesystem::path& file) {
  std::vector<vtkIdType> along;
  vtkCellArray* lines = data.GetLines();
  if (!lines->IsValid()) refuse(file, "has lines that are damaged");
  lines->InitTraversal();
  vtkIdType count = 0;
  const vtkIdType* points = nullptr;
  while (lines->GetNextCell(count, points) != 0) {
    const bool goes_on = !along.empty() && count > 0 && points[0] == along.back();
    if (!along.empty() && !goes_on) refuse(file, "holds more than one poly-line; keep the one of the ground surface");
    along.insert(along.end(), points + (goes_on ? 1 : 0), points + count);
  }
  for (const vtkIdType point : along) {
    if (point >= 0 && point < data.GetNumberOfPoints()) continue;
    refuse(file, fmt::format("its line goes through point {} of {}", point, data.GetNumberOfPoints()));
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
  check_head(couple::read_bytes(file, most_bytes), file);
  const QuietVtk quiet;
  vtkNew<vtkXMLPolyDataReader> reader;
  if (reader->CanReadFile(file.c_str()) == 0) refuse(file, "is not a VTK PolyData file (.vtp)");
  reader->SetFileName(file.c_str());
  reader->Update();
  if (reader->GetErrorCode() != 0) refuse(file, "cannot be read as VTK PolyData; is it whole?");
  std::vector<std::array<double, 2>> line;
  for (const vtkIdType point : points_along(*reader->GetOutput(), file)) {
    const double* position = reader->GetOutput()->GetPoint(point);
    if (!std::isfinite(position[0]) || !std::isfinite(position[1])) {
      refuse(file, fmt::format("its point {} lies at x = {} m, y = {} m", point, position[0], position[1]));
    }
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
