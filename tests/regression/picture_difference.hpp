#pragma once

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <filesystem>

namespace slope::testing {

/// How far two pictures are apart.
///
/// A pixel differs by the channel that is farthest from the one of the 3 x 3 pixels there in the other picture that
/// comes nearest; it is looked for in both directions. These differences are averaged over tiles, and the worst tile
/// counts: a thin line that moved or a legend that is missing stands out in its tile and would be lost in the mean of
/// the picture, while the edges of letters and lines that another machine draws a little differently fill no tile.
///
/// (vtkImageDifference is the same idea without tiles, but lets everything move by two pixels: that hides most of a
/// water level's 0.1 m, which are 2.2 pixels.)
struct PictureDifference {
  double largest = 0.0;                   ///< mean of the worst tile, 0 to 255
  int x = 0;                              ///< centre of this tile (pixels from the left)
  int y = 0;                              ///< (pixels from the top)
  vtkSmartPointer<vtkImageData> picture;  ///< difference of each pixel, white where there is none
};

inline constexpr int tile_width = 32;  ///< of a tile, which overlap by half (pixels)

/// @throws std::runtime_error if a file is no PNG picture in colour or the sizes differ.
[[nodiscard]] PictureDifference picture_difference(const std::filesystem::path& actual,
                                                   const std::filesystem::path& reference);
[[nodiscard]] PictureDifference picture_difference(vtkImageData* actual, vtkImageData* reference);

/// @throws std::runtime_error if the file is no PNG picture in colour.
[[nodiscard]] vtkSmartPointer<vtkImageData> read_picture(const std::filesystem::path& file);
/// @throws std::runtime_error if the file cannot be written.
void write_picture(const std::filesystem::path& file, vtkImageData* picture);

}  // namespace slope::testing
