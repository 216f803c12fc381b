#include "picture_difference.hpp"

#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPNGWriter.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace slope::testing {
namespace {

constexpr int channels = 3;

std::string size_of(const int* dimensions) {
  return std::to_string(dimensions[0]) + " x " + std::to_string(dimensions[1]) + " pixels";
}

/// The channels of a picture, row by row from below.
class Pixels {
 public:
  explicit Pixels(vtkImageData* picture)
      : columns_(picture->GetDimensions()[0]),
        rows_(picture->GetDimensions()[1]),
        values_(static_cast<const std::uint8_t*>(picture->GetScalarPointer())) {}

  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] const std::uint8_t* at(int i, int j) const { return values_ + channels * (j * columns_ + i); }

 private:
  int columns_;
  int rows_;
  const std::uint8_t* values_;
};

int distance(const std::uint8_t* a, const std::uint8_t* b) {
  return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

/// From a pixel to the nearest of the nine around this place in another picture.
int distance_to_nearest(const Pixels& pixels, const Pixels& others, int i, int j) {
  int nearest = std::numeric_limits<int>::max();
  for (int y = std::max(0, j - 1); y <= std::min(others.rows() - 1, j + 1); ++y) {
    for (int x = std::max(0, i - 1); x <= std::min(others.columns() - 1, i + 1); ++x) {
      nearest = std::min(nearest, distance(pixels.at(i, j), others.at(x, y)));
    }
  }
  return nearest;
}

/// Row by row from below.
std::vector<int> pixel_differences(const Pixels& a, const Pixels& b) {
  std::vector<int> differences;
  differences.reserve(static_cast<std::size_t>(a.columns()) * static_cast<std::size_t>(a.rows()));
  for (int j = 0; j < a.rows(); ++j) {
    for (int i = 0; i < a.columns(); ++i) {
      differences.push_back(std::max(distance_to_nearest(a, b, i, j), distance_to_nearest(b, a, i, j)));
    }
  }
  return differences;
}

/// Means over rectangles of pixels, from sums over all that lies to their lower left.
class Means {
 public:
  Means(const std::vector<int>& values, int columns)
      : stride_(static_cast<std::size_t>(columns) + 1), sums_(stride_, 0.0) {
    for (auto row = values.begin(); row != values.end(); row += columns) {
      double sum = 0.0;
      sums_.push_back(0.0);
      for (auto value = row; value != row + columns; ++value) {
        sum += *value;
        sums_.push_back(sum + sums_[sums_.size() - stride_]);
      }
    }
  }

  [[nodiscard]] double over(int left, int bottom, int right, int top) const {
    return (at(right, top) - at(left, top) - at(right, bottom) + at(left, bottom)) / ((right - left) * (top - bottom));
  }

 private:
  [[nodiscard]] double at(int i, int j) const { return sums_[static_cast<std::size_t>(j) * stride_ + i]; }

  std::size_t stride_;
  std::vector<double> sums_;
};

/// Where tiles begin: every half tile, the last one flush with the end.
std::vector<int> tile_begins(int length) {
  std::vector<int> begins;
  for (int begin = 0; begin + tile_width < length; begin += tile_width / 2) begins.push_back(begin);
  begins.push_back(std::max(0, length - tile_width));
  return begins;
}

/// Grey on white, the darker the farther apart; as large as a picture.
vtkSmartPointer<vtkImageData> shown(const std::vector<int>& differences, vtkImageData* picture) {
  auto result = vtkSmartPointer<vtkImageData>::New();
  result->CopyStructure(picture);
  result->AllocateScalars(VTK_UNSIGNED_CHAR, channels);
  auto* value = static_cast<std::uint8_t*>(result->GetScalarPointer());
  for (const int difference : differences)
    value = std::fill_n(value, channels, static_cast<std::uint8_t>(255 - difference));
  return result;
}

}  // namespace

PictureDifference picture_difference(vtkImageData* actual, vtkImageData* reference) {
  const int* size = actual->GetDimensions();
  const int* asked = reference->GetDimensions();
  if (!std::equal(size, size + 3, asked)) {
    throw std::runtime_error("the picture has " + size_of(size) + " instead of " + size_of(asked));
  }
  const Pixels pixels(actual);
  const auto differences = pixel_differences(pixels, Pixels(reference));
  const Means means(differences, pixels.columns());
  PictureDifference result;
  for (const int bottom : tile_begins(pixels.rows())) {
    for (const int left : tile_begins(pixels.columns())) {
      const int right = std::min(left + tile_width, pixels.columns());
      const int top = std::min(bottom + tile_width, pixels.rows());
      const double mean = means.over(left, bottom, right, top);
      if (mean > result.largest) {
        result.largest = mean;
        result.x = (left + right) / 2;
        result.y = pixels.rows() - (bottom + top) / 2;
      }
    }
  }
  result.picture = shown(differences, actual);
  return result;
}

PictureDifference picture_difference(const std::filesystem::path& actual, const std::filesystem::path& reference) {
  try {
    return picture_difference(read_picture(actual), read_picture(reference));
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(actual.string() + " beside " + reference.string() + ": " + error.what());
  }
}

vtkSmartPointer<vtkImageData> read_picture(const std::filesystem::path& file) {
  vtkNew<vtkPNGReader> reader;
  if (!std::filesystem::is_regular_file(file) || reader->CanReadFile(file.c_str()) == 0) {
    throw std::runtime_error(file.string() + ": is no PNG picture");
  }
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkSmartPointer<vtkImageData> picture = reader->GetOutput();
  if (picture->GetNumberOfScalarComponents() != channels || picture->GetScalarType() != VTK_UNSIGNED_CHAR) {
    throw std::runtime_error(file.string() + ": is no picture in colour, with eight bits to each of three channels");
  }
  return picture;
}

void write_picture(const std::filesystem::path& file, vtkImageData* picture) {
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputData(picture);
  writer->SetCompressionLevel(9);
  writer->Write();
  if (writer->GetErrorCode() != 0) throw std::runtime_error(file.string() + ": cannot be written");
}

}  // namespace slope::testing
