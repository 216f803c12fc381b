#include "field_image.hpp"

#include <vtkContourFilter.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "slope/couple/read_case.hpp"

namespace slope::tools {
namespace {

// Supports of the kernel over the particle spacing: the coverage's is wider, to smooth the steps of the lattice along
// an inclined face.
constexpr double value_support = 2.4;
constexpr double coverage_support = 3.6;
constexpr double shortest_line = 3.0;     // particle spacings: shorter ones are specks
constexpr double longest_crossing = 4.0;  // particle spacings, of the shallow zone
constexpr double shallow_coverage = 0.9;  // less than a spacing and a half below the surface
constexpr const char* coverage_name = "coverage";

/// Particles sorted into square cells of the kernel's support.
class Neighbourhood {
 public:
  Neighbourhood(const std::vector<couple::Point>& positions, double radius) : radius_(radius) {
    lower_ = {std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
    couple::Point upper{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest()};
    for (const auto& x : positions) {
      for (std::size_t d = 0; d < 2; ++d) {
        lower_[d] = std::min(lower_[d], x[d]);
        upper[d] = std::max(upper[d], x[d]);
      }
    }
    if (!positions.empty()) {
      constexpr double most_cells = 2000.0;  // each way; larger ones find the same particles
      radius_ = std::max({radius, (upper[0] - lower_[0]) / most_cells, (upper[1] - lower_[1]) / most_cells});
      columns_ = static_cast<int>((upper[0] - lower_[0]) / radius_) + 1;
      rows_ = static_cast<int>((upper[1] - lower_[1]) / radius_) + 1;
    }
    cells_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    for (std::size_t p = 0; p < positions.size(); ++p) {
      cell(column(positions[p][0]), row(positions[p][1])).push_back(p);
    }
  }

  template <class Visit>
  void around(const couple::Point& x, Visit visit) {
    const int i = column(x[0]);
    const int j = row(x[1]);
    for (int b = std::max(j - 1, 0); b <= std::min(j + 1, rows_ - 1); ++b) {
      for (int a = std::max(i - 1, 0); a <= std::min(i + 1, columns_ - 1); ++a) {
        for (const std::size_t p : cell(a, b)) {
          visit(p);
        }
      }
    }
  }

 private:
  [[nodiscard]] int column(double x) const { return cell_number((x - lower_[0]) / radius_, columns_); }
  [[nodiscard]] int row(double y) const { return cell_number((y - lower_[1]) / radius_, rows_); }
  /// What is far outside has the number of a cell that lies just beyond the neighbours of the last one.
  static int cell_number(double place, int count) {
    return static_cast<int>(std::clamp(std::floor(place), -2.0, count + 1.0));
  }
  std::vector<std::size_t>& cell(int i, int j) {
    return cells_[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(i)];
  }

  double radius_;
  couple::Point lower_{};
  int columns_ = 0;
  int rows_ = 0;
  std::vector<std::vector<std::size_t>> cells_;
};

/// Wendland C2 kernel in the plane, per area.
double kernel(double distance, double radius) {
  const double q = distance / radius;
  if (q >= 1.0) {
    return 0.0;
  }
  const double rest = 1.0 - q;
  return 7.0 / (std::numbers::pi * radius * radius) * rest * rest * rest * rest * (1.0 + 4.0 * q);
}

/// Weighted sums over the particles around a point; offsets are in units of the kernel's radius.
struct Moments {
  double w = 0.0, wx = 0.0, wy = 0.0, wxx = 0.0, wxy = 0.0, wyy = 0.0;
};
struct FieldSums {
  double wf = 0.0, wxf = 0.0, wyf = 0.0;
  double lowest = std::numeric_limits<double>::max();
  double highest = std::numeric_limits<double>::lowest();
};

/// Constant term of the weighted straight-line fit.
double fitted_value(const Moments& m, const FieldSums& f) {
  const double mean = f.wf / m.w;
  const double mx = m.wx / m.w;
  const double my = m.wy / m.w;
  const double cxx = m.wxx / m.w - mx * mx;
  const double cxy = m.wxy / m.w - mx * my;
  const double cyy = m.wyy / m.w - my * my;
  const double determinant = cxx * cyy - cxy * cxy;
  constexpr double flat = 1.0e-4;  // of the kernel's radius to the fourth: the particles do not span a plane
  if (determinant < flat) {
    return mean;
  }
  const double cxf = f.wxf / m.w - mx * mean;
  const double cyf = f.wyf / m.w - my * mean;
  const double slope_x = (cyy * cxf - cxy * cyf) / determinant;
  const double slope_y = (cxx * cyf - cxy * cxf) / determinant;
  return std::clamp(mean - slope_x * mx - slope_y * my, f.lowest, f.highest);
}

couple::Point point_of(vtkPolyData* data, std::size_t index) {
  const double* x = data->GetPoint(static_cast<vtkIdType>(index));
  return {x[0], x[1]};
}

double length(const FieldImage::Line& line) {
  double sum = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    sum += std::hypot(line[i][0] - line[i - 1][0], line[i][1] - line[i - 1][1]);
  }
  return sum;
}

/// The stretches of a line whose points satisfy a condition; each point is asked for once, in order.
template <class Condition>
std::vector<FieldImage::Line> split_where(const FieldImage::Line& line, Condition condition) {
  std::vector<FieldImage::Line> pieces(1);
  for (const auto& point : line) {
    if (condition(point)) {
      pieces.back().push_back(point);
    } else if (!pieces.back().empty()) {
      pieces.emplace_back();
    }
  }
  if (pieces.back().empty()) {
    pieces.pop_back();
  }
  return pieces;
}

}  // namespace

vtkDataArray* particle_array(vtkPolyData* particles, const std::string& name) {
  auto* array = particles->GetPointData()->GetArray(name.c_str());
  if (array == nullptr) {
    throw couple::FileError("a particle file lacks the array " + name + "; run slope-sim again");
  }
  return array;
}

double scalar(vtkDataArray* array, std::size_t particle) {
  const auto p = static_cast<vtkIdType>(particle);
  double square = 0.0;
  if (array->GetNumberOfComponents() == 1) {
    return array->GetComponent(p, 0);
  }
  for (int c = 0; c < array->GetNumberOfComponents(); ++c) {
    square += array->GetComponent(p, c) * array->GetComponent(p, c);
  }
  return std::sqrt(square);
}

FieldImage::FieldImage(vtkPolyData* particles, const ImageGrid& grid, const std::vector<std::string>& fields)
    : grid_(grid), image_(vtkSmartPointer<vtkImageData>::New()) {
  const double width = grid.cell_width();
  const double height = grid.cell_height();
  image_->SetDimensions(grid.columns, grid.rows, 1);
  image_->SetSpacing(width, height, 1.0);
  image_->SetOrigin(grid.lower[0] + 0.5 * width, grid.lower[1] + 0.5 * height, 0.0);

  const auto count = static_cast<std::size_t>(particles->GetNumberOfPoints());
  auto* volume = particle_array(particles, "volume");
  double total = 0.0;
  for (std::size_t p = 0; p < count; ++p) total += volume->GetComponent(static_cast<vtkIdType>(p), 0);
  spacing_ = std::sqrt(total / static_cast<double>(std::max<std::size_t>(count, 1)));
  const double wide_radius = coverage_support * spacing_;
  const double radius = value_support * spacing_;

  // What lies farther outside of the rectangle has no part in it.
  std::vector<couple::Point> position;
  std::vector<double> area;
  std::vector<std::size_t> particle;
  for (std::size_t p = 0; p < count; ++p) {
    const double* x = particles->GetPoint(static_cast<vtkIdType>(p));
    const bool near = x[0] > grid.lower[0] - wide_radius && x[0] < grid.upper[0] + wide_radius &&
                      x[1] > grid.lower[1] - wide_radius && x[1] < grid.upper[1] + wide_radius;
    if (!near) continue;
    position.push_back({x[0], x[1]});
    area.push_back(volume->GetComponent(static_cast<vtkIdType>(p), 0));
    particle.push_back(p);
  }

  // Mirror images behind the walls count for the coverage only.
  const auto mirror = [&](std::size_t direction, double wall) {
    const std::size_t so_far = position.size();
    for (std::size_t p = 0; p < so_far; ++p) {
      if (std::abs(position[p][direction] - wall) < wide_radius) {
        auto image = position[p];
        image[direction] = 2.0 * wall - image[direction];
        position.push_back(image);
        area.push_back(area[p]);
      }
    }
  };
  mirror(0, grid.lower[0]);
  mirror(0, grid.upper[0]);
  mirror(1, grid.lower[1]);
  Neighbourhood neighbours(position, wide_radius);

  vtkNew<vtkDoubleArray> coverage;
  coverage->SetName(coverage_name);
  coverage->SetNumberOfTuples(image_->GetNumberOfPoints());
  coverage->FillValue(0.0);
  image_->GetPointData()->AddArray(coverage);
  std::vector<std::vector<double>> given(fields.size(), std::vector<double>(particle.size()));
  std::vector<double*> sampled;
  for (std::size_t k = 0; k < fields.size(); ++k) {
    auto* array = particle_array(particles, fields[k]);
    for (std::size_t p = 0; p < particle.size(); ++p) {
      given[k][p] = scalar(array, particle[p]);
    }
    vtkNew<vtkDoubleArray> image_array;
    image_array->SetName(fields[k].c_str());
    image_array->SetNumberOfTuples(image_->GetNumberOfPoints());
    image_array->FillValue(0.0);
    image_->GetPointData()->AddArray(image_array);
    sampled.push_back(image_array->GetPointer(0));
  }

  const double reach = (wide_radius / radius) * (wide_radius / radius);
  std::vector<FieldSums> sums(fields.size());
  for (int j = 0; j < grid.rows; ++j) {
    for (int i = 0; i < grid.columns; ++i) {
      const couple::Point x{grid.lower[0] + (i + 0.5) * width, grid.lower[1] + (j + 0.5) * height};
      double covered = 0.0;
      Moments moments;
      std::fill(sums.begin(), sums.end(), FieldSums{});
      neighbours.around(x, [&](std::size_t p) {
        const double dx = (position[p][0] - x[0]) / radius;
        const double dy = (position[p][1] - x[1]) / radius;
        const double square = dx * dx + dy * dy;
        if (square >= reach) {
          return;
        }
        const double distance = radius * std::sqrt(square);
        covered += area[p] * kernel(distance, wide_radius);
        if (p >= particle.size() || square >= 1.0) {
          return;
        }
        const double w = area[p] * kernel(distance, radius);
        moments.w += w;
        moments.wx += w * dx;
        moments.wy += w * dy;
        moments.wxx += w * dx * dx;
        moments.wxy += w * dx * dy;
        moments.wyy += w * dy * dy;
        for (std::size_t k = 0; k < fields.size(); ++k) {
          const double f = given[k][p];
          sums[k].wf += w * f;
          sums[k].wxf += w * dx * f;
          sums[k].wyf += w * dy * f;
          sums[k].lowest = std::min(sums[k].lowest, f);
          sums[k].highest = std::max(sums[k].highest, f);
        }
      });
      const vtkIdType cell = static_cast<vtkIdType>(j) * grid.columns + i;
      coverage->SetValue(cell, covered);
      if (moments.w > 0.0) {
        for (std::size_t k = 0; k < fields.size(); ++k) {
          sampled[k][cell] = fitted_value(moments, sums[k]);
        }
      }
    }
  }
}

bool FieldImage::inside(const couple::Point& where) const {
  return coverage_at(where) >= 0.5;
}

double FieldImage::coverage_at(const couple::Point& where) const {
  return value(coverage_name, where);
}

double FieldImage::value(const std::string& field, const couple::Point& where) const {
  const double x = (where[0] - grid_.lower[0]) / grid_.cell_width() - 0.5;
  const double y = (where[1] - grid_.lower[1]) / grid_.cell_height() - 0.5;
  const int i = std::clamp(static_cast<int>(std::floor(x)), 0, grid_.columns - 2);
  const int j = std::clamp(static_cast<int>(std::floor(y)), 0, grid_.rows - 2);
  const double a = std::clamp(x - i, 0.0, 1.0);
  const double b = std::clamp(y - j, 0.0, 1.0);
  const auto* array = vtkDoubleArray::SafeDownCast(image_->GetPointData()->GetArray(field.c_str()));
  const vtkIdType corner = static_cast<vtkIdType>(j) * grid_.columns + i;
  const double below = (1.0 - a) * array->GetValue(corner) + a * array->GetValue(corner + 1);
  const double above =
      (1.0 - a) * array->GetValue(corner + grid_.columns) + a * array->GetValue(corner + grid_.columns + 1);
  return (1.0 - b) * below + b * above;
}

std::vector<FieldImage::Line> FieldImage::contour(const std::string& array, double value) const {
  image_->GetPointData()->SetActiveScalars(array.c_str());
  vtkNew<vtkContourFilter> filter;
  filter->SetInputData(image_);
  filter->SetValue(0, value);
  filter->Update();
  auto* found = filter->GetOutput();

  // Chains of segments: open ones from their ends, then the closed ones.
  const auto count = static_cast<std::size_t>(found->GetNumberOfPoints());
  std::vector<std::vector<std::size_t>> neighbours(count);
  vtkNew<vtkIdList> ids;
  for (found->GetLines()->InitTraversal(); found->GetLines()->GetNextCell(ids) != 0;) {
    const auto from = static_cast<std::size_t>(ids->GetId(0));
    const auto to = static_cast<std::size_t>(ids->GetId(1));
    neighbours[from].push_back(to);
    neighbours[to].push_back(from);
  }
  std::vector<Line> lines;
  for (const bool open : {true, false}) {
    for (std::size_t start = 0; start < count; ++start) {
      if (open && neighbours[start].size() != 1) {
        continue;
      }
      Line line;
      for (std::size_t at = start; !neighbours[at].empty();) {
        const std::size_t next = neighbours[at].back();
        neighbours[at].pop_back();
        std::erase(neighbours[next], at);
        line.push_back(point_of(found, at));
        at = next;
        if (neighbours[at].empty()) {
          line.push_back(point_of(found, at));
        }
      }
      if (line.size() > 1) {
        lines.push_back(std::move(line));
      }
    }
  }
  return lines;
}

std::vector<FieldImage::Line> FieldImage::outline() const {
  return contour(coverage_name, 0.5);
}

std::vector<FieldImage::Line> FieldImage::iso_lines(const std::string& field, double value) const {
  const double across = grid_.upper[0] - grid_.lower[0];  // a line across a narrow column is no speck
  const double shortest = std::min(shortest_line * spacing_, 0.5 * across);
  std::vector<Line> pieces;
  for (const Line& line : contour(field, value)) {
    for (auto& piece : split_where(line, [this](const auto& x) { return inside(x); })) {
      if (length(piece) > shortest) {
        pieces.push_back(std::move(piece));
      }
    }
  }
  return pieces;
}

std::vector<FieldImage::Line> FieldImage::without_surface(const std::vector<Line>& lines) const {
  std::vector<Line> kept;
  for (const Line& line : lines) {
    std::vector<bool> shallow;
    for (const auto& point : line) {
      shallow.push_back(coverage_at(point) < shallow_coverage);
    }
    // A line that crosses the shallow zone on its way to the surface stays.
    for (std::size_t begin = 0; begin < line.size();) {
      std::size_t end = begin;
      while (end < line.size() && shallow[end] == shallow[begin]) {
        ++end;
      }
      const Line run(line.begin() + static_cast<std::ptrdiff_t>(begin),
                     line.begin() + static_cast<std::ptrdiff_t>(end));
      if (shallow[begin] && length(run) < longest_crossing * spacing_) {
        std::fill(shallow.begin() + static_cast<std::ptrdiff_t>(begin),
                  shallow.begin() + static_cast<std::ptrdiff_t>(end), false);
      }
      begin = end;
    }
    const bool cut = std::find(shallow.begin(), shallow.end(), true) != shallow.end();
    std::size_t i = 0;
    for (auto& piece : split_where(line, [&](const auto&) { return !shallow[i++]; })) {
      if (!cut || length(piece) > longest_crossing * spacing_) {
        kept.push_back(std::move(piece));
      }
    }
  }
  return kept;
}

}  // namespace slope::tools
