#include "picture_difference.hpp"

#include <vtkImageDifference.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPNGWriter.h>

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace slope::testing {
namespace {

constexpr int channels = 3;

std::string size_of(const int* dimensions) {
  return std::to_string(dimensions[0]) + " x " + std::to_string(dimensions[1]) + " pixels";
}

/// Sums over rectangles of pixels from sums over all that lies to their lower left.
class Sums {
 public:
  explicit Sums(vtkImageData* difference)
      : columns_(difference->GetDimensions()[0]),
        rows_(difference->GetDimensions()[1]),
        sums_(static_cast<std::size_t>(columns_ + 1) * static_cast<std::size_t>(rows_ + 1), 0.0) {
    const auto* pixel = static_cast<const std::uint8_t*>(difference->GetScalarPointer());
    for (int j = 0; j < rows_; ++j) {
      for (int i = 0; i < columns_; ++i, pixel += channels) {
        at(i + 1, j + 1) = *std::max_element(pixel, pixel + channels) + at(i, j + 1) + at(i + 1, j) - at(i, j);
      }
    }
  }

  [[nodiscard]] double mean(int left, int bottom, int right, int top) {
    return (at(right, top) - at(left, top) - at(right, bottom) + at(left, bottom)) / ((right - left) * (top - bottom));
  }
  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int rows() const { return rows_; }

 private:
  double& at(int i, int j) { return sums_[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_ + 1) + i]; }

  int columns_;
  int rows_;
  std::vector<double> sums_;
};

/// Where tiles begin: every half tile, the last one flush with the end.
std::vector<int> tile_begins(int length) {
  std::vector<int> begins;
  for (int begin = 0; begin + tile_width < length; begin += tile_width / 2) begins.push_back(begin);
  begins.push_back(std::max(0, length - tile_width));
  return begins;
}

vtkSmartPointer<vtkImageData> inverted(vtkImageData* picture) {
  auto result = vtkSmartPointer<vtkImageData>::New();
  result->DeepCopy(picture);
  auto* value = static_cast<std::uint8_t*>(result->GetScalarPointer());
  std::transform(value, value + channels * result->GetNumberOfPoints(), value,
                 [](std::uint8_t v) { return static_cast<std::uint8_t>(255 - v); });
  return result;
}

}  // namespace

PictureDifference picture_difference(vtkImageData* actual, vtkImageData* reference) {
  const int* size = actual->GetDimensions();
  const int* asked = reference->GetDimensions();
  if (!std::equal(size, size + 3, asked)) {
    throw std::runtime_error("the picture has " + size_of(size) + " instead of " + size_of(asked));
  }
  vtkNew<vtkImageDifference> filter;
  filter->SetInputData(actual);
  filter->SetImageData(reference);
  filter->SetThreshold(0);
  filter->AllowShiftOn();
  filter->AveragingOff();
  filter->Update();

  PictureDifference result;
  Sums sums(filter->GetOutput());
  for (const int bottom : tile_begins(sums.rows())) {
    for (const int left : tile_begins(sums.columns())) {
      const int right = std::min(left + tile_width, sums.columns());
      const int top = std::min(bottom + tile_width, sums.rows());
      const double mean = sums.mean(left, bottom, right, top);
      if (mean > result.largest) {
        result.largest = mean;
        result.x = (left + right) / 2;
        result.y = sums.rows() - (bottom + top) / 2;
      }
    }
  }
  result.picture = inverted(filter->GetOutput());
  return result;
}

PictureDifference picture_difference(const std::filesystem::path& actual, const std::filesystem::path& reference) {
  return picture_difference(read_picture(actual), read_picture(reference));
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
