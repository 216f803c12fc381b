#pragma once

#include <vtkImageData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

#include "slope/couple/case.hpp"

namespace slope::tools {

/// A rectangle that is sampled at the centres of equal cells, at least two each way.
struct ImageGrid {
  couple::Point lower{0.0, 0.0};  ///< (m)
  couple::Point upper{0.0, 0.0};  ///< (m)
  int columns = 0;
  int rows = 0;

  [[nodiscard]] double cell_width() const { return (upper[0] - lower[0]) / columns; }
  [[nodiscard]] double cell_height() const { return (upper[1] - lower[1]) / rows; }
};

/// Fields of the particles on a regular image.
///
/// A field's value is the constant term of a straight-line (moving least squares) fit to the particles around, with the
/// Wendland C2 kernel as weight, kept between the smallest and largest value that went into it: a linear field comes
/// out unchanged, and nothing overshoots at a free surface. Where the particles around do not span a plane it is
/// their weighted (Shepard) mean.
///
/// The coverage is the Shepard sum of volumes times the kernel: 1 inside the soil and 1/2 at a surface half a spacing
/// outside the outermost particles, which is where the soil ends. Beside the left, right and lower sides of the
/// rectangle, the walls, the particles are mirrored so that the soil reaches up to them.
class FieldImage {
 public:
  /// @param fields  names of point arrays of the particles, each once; of vectors the length is taken.
  FieldImage(vtkPolyData* particles, const ImageGrid& grid, const std::vector<std::string>& fields);

  /// Whether the soil covers a point of the rectangle (m).
  [[nodiscard]] bool inside(const couple::Point& where) const;
  /// Value at a point (m), interpolated between the cells' centres; meaningful where inside() holds.
  [[nodiscard]] double value(const std::string& field, const couple::Point& where) const;

  using Line = std::vector<couple::Point>;
  /// The lines inside the soil on which a field has a value (m), without specks of a few particle spacings.
  [[nodiscard]] std::vector<Line> iso_lines(const std::string& field, double value) const;
  /// Lines without the stretches that run along the surface of the soil, less than about a spacing and a half below it.
  [[nodiscard]] std::vector<Line> without_surface(const std::vector<Line>& lines) const;
  /// The surface of the soil (m); not the walls.
  [[nodiscard]] std::vector<Line> outline() const;

 private:
  [[nodiscard]] double coverage_at(const couple::Point& where) const;
  [[nodiscard]] std::vector<Line> contour(const std::string& array, double value) const;

  ImageGrid grid_;
  double spacing_ = 0.0;  // of the particles, mean (m)
  vtkSmartPointer<vtkImageData> image_;
};

/// A point array of the particles.
/// @throws couple::FileError if they lack it.
[[nodiscard]] vtkDataArray* particle_array(vtkPolyData* particles, const std::string& name);

/// A particle's value; of a vector its length.
[[nodiscard]] double scalar(vtkDataArray* array, std::size_t particle);

}  // namespace slope::tools
