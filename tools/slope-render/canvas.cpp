#include "canvas.hpp"

#include <fmt/format.h>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>
#include <vtkTexture.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "quiet_vtk.hpp"
#include "render_window.hpp"
#include "slope/couple/read_case.hpp"

namespace slope::tools {
namespace {

constexpr int dots_per_inch = 72;  // so that a font size is in pixels
constexpr double subscript_scale = 0.72;
constexpr double subscript_drop = 0.22;  // em

const std::string& font_file() {
  static const std::string file = [] {
    const char* chosen = std::getenv("SLOPE_FONT_FILE");
    std::string name = chosen != nullptr ? chosen : SLOPE_FONT_FILE;
    if (!std::filesystem::is_regular_file(name)) {
      throw RenderError(
          fmt::format("{}: font not found; set the environment variable SLOPE_FONT_FILE to DejaVuSans.ttf", name));
    }
    return name;
  }();
  return file;
}

void set_font(vtkTextProperty* property, double size) {
  property->SetFontFamily(VTK_FONT_FILE);
  property->SetFontFile(font_file().c_str());
  property->SetFontSize(static_cast<int>(std::lround(size)));
}

/// A piece of a text that is set in one size.
struct Run {
  std::string text;
  bool subscript = false;
};

std::vector<Run> split_runs(const std::string& text) {
  std::vector<Run> runs;
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t open = text.find("_{", begin);
    const std::size_t close = open == std::string::npos ? open : text.find('}', open);
    if (close == std::string::npos) {
      runs.push_back({text.substr(begin), false});
      break;
    }
    if (open > begin) {
      runs.push_back({text.substr(begin, open - begin), false});
    }
    runs.push_back({text.substr(open + 2, close - open - 2), true});
    begin = close + 1;
  }
  return runs;
}

double run_width(const Run& run, double font_size) {
  vtkNew<vtkTextProperty> property;
  set_font(property, run.subscript ? subscript_scale * font_size : font_size);
  std::array<int, 4> bounds{};
  // Blanks at the ends of a text take no room in VTK's bounds: measure it between two letters.
  vtkTextRenderer::GetInstance()->GetBoundingBox(property, "x" + run.text + "x", bounds.data(), dots_per_inch);
  const int with = bounds[1] - bounds[0];
  vtkTextRenderer::GetInstance()->GetBoundingBox(property, "xx", bounds.data(), dots_per_inch);
  return with - (bounds[1] - bounds[0]);
}

vtkNew<vtkActor> unlit_actor(vtkPolyData* data) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  return actor;
}

/// A disc's corners: enough for it to look round.
std::vector<Pixel> round_polygon(Pixel centre, double radius) {
  const int corners = std::max(12, static_cast<int>(4.0 * std::sqrt(radius) + 8.0));
  std::vector<Pixel> polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / corners;
    polygon.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
  }
  return polygon;
}

/// The drawn pieces of a dashed line.
std::vector<std::vector<Pixel>> cut_into_dashes(const std::vector<Pixel>& points, const std::vector<double>& dashes) {
  std::vector<std::vector<Pixel>> pieces{{points.front()}};
  std::size_t dash = 0;
  double left = dashes.front();
  for (std::size_t i = 1; i < points.size(); ++i) {
    Pixel from = points[i - 1];
    double length = std::hypot(points[i].x - from.x, points[i].y - from.y);
    while (length > left) {
      const double share = left / length;
      from = {from.x + share * (points[i].x - from.x), from.y + share * (points[i].y - from.y)};
      length -= left;
      if (dash % 2 == 0) {
        pieces.back().push_back(from);
      } else {
        pieces.push_back({from});
      }
      dash = (dash + 1) % dashes.size();
      left = dashes[dash];
    }
    left -= length;
    if (dash % 2 == 0) {
      pieces.back().push_back(points[i]);
    }
  }
  return pieces;
}

}  // namespace

std::vector<Pixel> thinned(const std::vector<Pixel>& line, double distance) {
  if (line.size() < 3) {
    return line;
  }
  const auto far = [distance](const Pixel& a, const Pixel& b) { return std::hypot(a.x - b.x, a.y - b.y) >= distance; };
  std::vector<Pixel> kept{line.front()};
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    if (far(line[i], kept.back()) && far(line[i], line.back())) {
      kept.push_back(line[i]);
    }
  }
  kept.push_back(line.back());
  return kept;
}

/// Coloured polygons, each drawing nearer to the eye than those before.
class Canvas::Mesh {
 public:
  Mesh() {
    points_->SetDataTypeToDouble();
    colours_->SetNumberOfComponents(3);
  }

  void add(const std::vector<Pixel>& polygon, double depth, Colour colour) {
    polygons_->InsertNextCell(static_cast<int>(polygon.size()));
    for (const Pixel& corner : polygon) {
      polygons_->InsertCellPoint(points_->InsertNextPoint(corner.x, corner.y, depth));
      colours_->InsertNextTuple3(colour.red, colour.green, colour.blue);
    }
  }

  [[nodiscard]] vtkNew<vtkActor> actor() const {
    vtkNew<vtkPolyData> data;
    data->SetPoints(points_);
    data->SetPolys(polygons_);
    data->GetPointData()->SetScalars(colours_);
    return unlit_actor(data);
  }

 private:
  vtkNew<vtkPoints> points_;
  vtkNew<vtkCellArray> polygons_;
  vtkNew<vtkUnsignedCharArray> colours_;
};

Canvas::Canvas(int width, int height, double font_size)
    : width_(width),
      height_(height),
      font_size_(font_size),
      renderer_(vtkSmartPointer<vtkRenderer>::New()),
      mesh_(std::make_unique<Mesh>()) {
  renderer_->SetBackground(1.0, 1.0, 1.0);
}

Canvas::~Canvas() = default;

void Canvas::fill(const std::vector<Pixel>& polygon, Colour colour) {
  mesh_->add(polygon, ++depth_, colour);
}

void Canvas::fill(const Box& box, Colour colour) {
  fill({{box.left, box.bottom}, {box.right, box.bottom}, {box.right, box.top}, {box.left, box.top}}, colour);
}

void Canvas::disc(Pixel centre, double radius, Colour colour) {
  fill(round_polygon(centre, radius), colour);
}

void Canvas::stroke(const std::vector<Pixel>& points, const LineStyle& style) {
  if (points.size() < 2) {
    return;
  }
  if (!style.dashes.empty()) {
    const LineStyle unbroken{style.width, style.colour, {}};
    for (const auto& piece : cut_into_dashes(points, style.dashes)) {
      stroke(piece, unbroken);
    }
    return;
  }
  const double half = 0.5 * style.width;
  ++depth_;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Pixel& a = points[i - 1];
    const Pixel& b = points[i];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    if (length == 0.0) {
      continue;
    }
    const double nx = -half * (b.y - a.y) / length;
    const double ny = half * (b.x - a.x) / length;
    mesh_->add({{a.x + nx, a.y + ny}, {a.x - nx, a.y - ny}, {b.x - nx, b.y - ny}, {b.x + nx, b.y + ny}}, depth_,
               style.colour);
    if (style.width > 2.5 && i + 1 < points.size()) {
      mesh_->add(round_polygon(b, half), depth_, style.colour);
    }
  }
}

void Canvas::stroke(const Box& box, const LineStyle& style) {
  // The corners are closed by running half a line width past each of them.
  const double half = 0.5 * style.width;
  stroke({{box.left - half, box.bottom}, {box.right + half, box.bottom}}, style);
  stroke({{box.left - half, box.top}, {box.right + half, box.top}}, style);
  stroke({{box.left, box.bottom}, {box.left, box.top}}, style);
  stroke({{box.right, box.bottom}, {box.right, box.top}}, style);
}

void Canvas::image(int left, int bottom, int columns, const std::vector<Colour>& colours) {
  const int rows = static_cast<int>(colours.size()) / columns;
  vtkNew<vtkImageData> pixels;
  pixels->SetDimensions(columns, rows, 1);
  pixels->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* value = static_cast<std::uint8_t*>(pixels->GetScalarPointer());
  for (const Colour& colour : colours) {
    *value++ = colour.red;
    *value++ = colour.green;
    *value++ = colour.blue;
  }

  ++depth_;
  vtkNew<vtkPoints> corners;
  vtkNew<vtkFloatArray> texture_coordinates;
  texture_coordinates->SetNumberOfComponents(2);
  vtkNew<vtkCellArray> quads;
  quads->InsertNextCell(4);
  for (const auto& [i, j] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
    quads->InsertCellPoint(corners->InsertNextPoint(left + i * columns, bottom + j * rows, depth_));
    texture_coordinates->InsertNextTuple2(i, j);
  }
  vtkNew<vtkPolyData> quad;
  quad->SetPoints(corners);
  quad->SetPolys(quads);
  quad->GetPointData()->SetTCoords(texture_coordinates);
  vtkNew<vtkTexture> texture;
  texture->SetInputData(pixels);
  texture->SetColorModeToDirectScalars();
  auto actor = unlit_actor(quad);
  actor->SetTexture(texture);
  renderer_->AddActor(actor);
}

double Canvas::text_width(const std::string& text, double font_size) {
  double width = 0.0;
  for (const Run& run : split_runs(text)) {
    width += run_width(run, font_size);
  }
  return width;
}

void Canvas::text(Pixel where, const std::string& text, const TextStyle& style) {
  const double size = style.scale * font_size_;
  const double width = text_width(text, size);
  double along = style.anchor == Anchor::left ? 0.0 : style.anchor == Anchor::centre ? -0.5 * width : -width;
  for (const Run& run : split_runs(text)) {
    vtkNew<vtkTextActor> actor;
    auto* property = actor->GetTextProperty();
    set_font(property, run.subscript ? subscript_scale * size : size);
    property->SetColor(style.colour.red / 255.0, style.colour.green / 255.0, style.colour.blue / 255.0);
    property->SetJustificationToLeft();
    property->SetVerticalJustificationToCentered();
    const double drop = run.subscript ? subscript_drop * size : 0.0;
    actor->SetInput(run.text.c_str());
    actor->SetTextScaleModeToNone();
    actor->SetPosition(std::round(where.x + (style.upwards ? drop : along)),
                       std::round(where.y + (style.upwards ? along : -drop)));
    if (style.upwards) {
      property->SetOrientation(90.0);
    }
    texts_.emplace_back(actor);
    along += run_width(run, size);
  }
}

void Canvas::fitted_text(Pixel where, const std::string& text, double width, TextStyle style) {
  const double needed = style.scale * text_width(text);
  if (needed <= width) {
    this->text(where, text, style);
    return;
  }
  constexpr double smallest = 0.7;
  style.scale *= std::max(smallest, width / needed);
  std::string kept = text;
  std::string shown = text;
  while (!kept.empty() && style.scale * text_width(shown) > width) {
    do {  // a whole letter
      kept.pop_back();
    } while (!kept.empty() && (static_cast<unsigned char>(kept.back()) & 0xc0U) == 0x80U);
    shown = kept + "…";
  }
  this->text(where, shown, style);
}

void Canvas::write_png(const std::filesystem::path& file) {
  const QuietVtk quiet;
  renderer_->AddActor(mesh_->actor());
  auto* camera = renderer_->GetActiveCamera();  // one unit is one pixel
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.5 * height_);
  camera->SetFocalPoint(0.5 * width_, 0.5 * height_, 0.0);
  camera->SetPosition(0.5 * width_, 0.5 * height_, depth_ + 2.0);
  camera->SetClippingRange(1.0, depth_ + 3.0);
  for (const auto& text : texts_) {
    renderer_->AddViewProp(text);
  }
  auto window = make_offscreen_window(width_, height_);
  window->SetDPI(dots_per_inch);
  window->AddRenderer(renderer_);
  window->Render();

  vtkNew<vtkWindowToImageFilter> pixels;
  pixels->SetInput(window);
  pixels->SetInputBufferTypeToRGB();
  pixels->ReadFrontBufferOff();
  pixels->ShouldRerenderOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputConnection(pixels->GetOutputPort());
  writer->Write();
  window->RemoveRenderer(renderer_);
  if (writer->GetErrorCode() != 0) {
    throw couple::FileError(
        fmt::format("{}: cannot be written; is the disk full or the folder write-protected?", file.string()));
  }
}

}  // namespace slope::tools
