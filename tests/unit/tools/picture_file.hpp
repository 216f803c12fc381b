#pragma once

#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace slope::tools::test {

/// A PNG picture, read back.
class PictureFile {
 public:
  explicit PictureFile(const std::filesystem::path& file) {
    EXPECT_TRUE(std::filesystem::is_regular_file(file)) << file;
    reader_->SetFileName(file.c_str());
    reader_->Update();
  }

  [[nodiscard]] int width() const { return reader_->GetOutput()->GetDimensions()[0]; }
  [[nodiscard]] int height() const { return reader_->GetOutput()->GetDimensions()[1]; }

  /// From the lower left corner.
  [[nodiscard]] std::array<int, 3> pixel(int x, int y) const {
    std::array<int, 3> colour{};
    for (int c = 0; c < 3; ++c) {
      colour[static_cast<std::size_t>(c)] =
          static_cast<int>(reader_->GetOutput()->GetScalarComponentAsDouble(x, y, 0, c));
    }
    return colour;
  }
  [[nodiscard]] bool is_white(int x, int y) const {
    const auto colour = pixel(x, y);
    return std::all_of(colour.begin(), colour.end(), [](int c) { return c > 250; });
  }
  [[nodiscard]] bool is_dark(int x, int y) const {
    const auto colour = pixel(x, y);
    return std::all_of(colour.begin(), colour.end(), [](int c) { return c < 60; });
  }

 private:
  vtkNew<vtkPNGReader> reader_;
};

inline std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace slope::tools::test
