#pragma once

#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace slope::tools {

/// A place on a picture (pixels), from its lower left corner.
struct Pixel {
  double x = 0.0;
  double y = 0.0;
};

/// A box on a picture (pixels).
struct Box {
  double left = 0.0;
  double bottom = 0.0;
  double right = 0.0;
  double top = 0.0;

  [[nodiscard]] double width() const { return right - left; }
  [[nodiscard]] double height() const { return top - bottom; }
  [[nodiscard]] Pixel centre() const { return {0.5 * (left + right), 0.5 * (bottom + top)}; }
};

struct Colour {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;

  friend bool operator==(const Colour&, const Colour&) = default;
};

inline constexpr Colour black{0, 0, 0};
inline constexpr Colour ink{34, 34, 34};  ///< text and axes
inline constexpr Colour white{255, 255, 255};

struct LineStyle {
  double width = 2.0;  ///< (pixels)
  Colour colour = ink;
  std::vector<double> dashes;  ///< lengths drawn and left out in turn (pixels); empty: unbroken
};

/// Font size over a picture's width: legible when it is printed 84 mm wide.
inline constexpr double font_share = 0.0225;

enum class Anchor { left, centre, right };

struct TextStyle {
  Anchor anchor = Anchor::left;  ///< along the text; across it, the text is centred
  bool upwards = false;          ///< reads from below to above
  double scale = 1.0;            ///< of the picture's font size
  Colour colour = ink;
};

/// A line without the points that lie closer than `distance` (pixels) to the one kept before; both ends are kept.
[[nodiscard]] std::vector<Pixel> thinned(const std::vector<Pixel>& line, double distance);

/// A picture being drawn: filled polygons, lines, images and text, on white. What comes later covers what came before,
/// and text covers everything.
class Canvas {
 public:
  /// @param font_size  height of the letters' em square (pixels); everything else is laid out in units of it.
  Canvas(int width, int height, double font_size);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] double em() const { return font_size_; }

  /// A convex polygon.
  void fill(const std::vector<Pixel>& polygon, Colour colour);
  void fill(const Box& box, Colour colour);
  /// A line through points, with round joints.
  void stroke(const std::vector<Pixel>& points, const LineStyle& style);
  void stroke(const Box& box, const LineStyle& style);
  void disc(Pixel centre, double radius, Colour colour);
  /// Colours row by row from below, one for each pixel.
  void image(int left, int bottom, int columns, const std::vector<Colour>& colours);
  /// A line of text; "_{...}" is a subscript.
  void text(Pixel where, const std::string& text, const TextStyle& style = {});
  /// The text, made smaller (to no less than 70 %) and then cut short with an ellipsis to fit a width (pixels).
  void fitted_text(Pixel where, const std::string& text, double width, TextStyle style = {});

  /// Draws and writes the picture.
  /// @throws couple::FileError if it cannot be written.
  void write_png(const std::filesystem::path& file);

  /// Width of a text in this font (pixels).
  [[nodiscard]] static double text_width(const std::string& text, double font_size);
  [[nodiscard]] double text_width(const std::string& text) const { return text_width(text, font_size_); }

 private:
  class Mesh;

  int width_;
  int height_;
  double font_size_;
  double depth_ = 0.0;  // towards the eye; grows with each drawing
  vtkSmartPointer<vtkRenderer> renderer_;
  std::vector<vtkSmartPointer<vtkProp>> texts_;
  std::unique_ptr<Mesh> mesh_;
};

}  // namespace slope::tools
