#include "contour_picture.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace slope::tools {
namespace {

constexpr double margin = 1.4;         // em
constexpr double tallest_plot = 0.75;  // over the picture's width
constexpr double thinnest_plot = 4.0;  // pixels, of a domain that is far longer than high, or higher than long

/// Greedy lines of at most a width (pixels).
std::vector<std::string> wrapped(const Canvas& canvas, const std::string& text, double width) {
  std::vector<std::string> lines(1);
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
    if (!lines.back().empty() && canvas.text_width(longer) > width) {
      lines.push_back(word);
    } else {
      lines.back() = longer;
    }
  }
  return lines;
}

std::vector<LegendEntry> legend_entries(const Canvas& canvas, const ContourPanel& panel) {
  return tools::legend_entries(canvas, std::span(&panel, 1));
}

/// The bar below the plot, the legend beside the time.
void write_wide_picture(const std::filesystem::path& file, int width, const ContourPanel& panel) {
  const double em = font_share * width;
  const double left = std::round(panel_left_room * em);
  const double plot_width = std::floor(width - left - margin * em);
  const double plot_height = std::max(thinnest_plot, std::round(plot_width * height_over_width(panel.domain)));
  const double bottom = std::round((5.0 + lying_bar_height) * em);
  Canvas canvas(width, static_cast<int>(bottom + plot_height + 3.6 * em), em);
  const Box box{left, bottom, left + plot_width, bottom + plot_height};

  canvas.fitted_text({box.left, canvas.height() - 1.05 * em}, panel.title, box.width());
  const double second_line = canvas.height() - 2.55 * em;
  const double legend = draw_legend(canvas, box.right, second_line, legend_entries(canvas, panel));
  canvas.fitted_text({box.left, second_line}, panel.caption, legend - box.left);
  draw_contour_panel(canvas, box, panel);

  draw_titled_bar(canvas, left, box.right, 1.6 * em, panel.field, panel.scale);
  canvas.write_png(file);
}

/// The bar beside the plot, title and legend in lines above it.
void write_tall_picture(const std::filesystem::path& file, int width, const ContourPanel& panel) {
  const double em = font_share * width;
  const double left = std::round(panel_left_room * em);
  const double plot_height = std::round(tallest_plot * width);
  const double plot_width = std::max(thinnest_plot, std::round(plot_height / height_over_width(panel.domain)));
  const double beside = 7.0 * em;  // the bar, its numbers and title
  const int picture_width = static_cast<int>(std::max(left + plot_width + beside + margin * em, 0.62 * width));
  const double text_width = picture_width - 2.0 * margin * em;
  const Canvas measure(picture_width, 1, em);
  auto lines = wrapped(measure, panel.title, text_width);
  lines.push_back(panel.caption);
  const std::size_t legend_lines = legend_entries(measure, panel).size();

  const double bottom = std::round(3.1 * em);
  const double line_height = 1.5 * em;
  const double above = static_cast<double>(lines.size() + legend_lines) * line_height + 1.6 * em;
  Canvas canvas(picture_width, static_cast<int>(bottom + plot_height + above), em);
  double row = canvas.height() - 1.05 * em;
  for (const auto& line : lines) {
    canvas.fitted_text({margin * em, row}, line, text_width);
    row -= line_height;
  }
  for (const auto& entry : legend_entries(canvas, panel)) {
    draw_legend_entry(canvas, {margin * em, row}, entry);
    row -= line_height;
  }

  const double shift = std::floor(0.5 * (picture_width - left - plot_width - beside - margin * em));
  const Box box{left + shift, bottom, left + shift + plot_width, bottom + plot_height};
  draw_contour_panel(canvas, box, panel);
  const Box bar{box.right + 1.6 * em, box.bottom, box.right + 2.5 * em, box.top};
  draw_colour_bar(canvas, bar, panel.field, panel.scale, {.upright = true});
  const double numbers = widest_number(canvas, panel.scale.range, panel.scale.step);
  canvas.text({bar.right + 1.4 * em + numbers, bar.centre().y}, panel.field.title,
              {.anchor = Anchor::centre, .upwards = true});
  canvas.write_png(file);
}

}  // namespace

void write_contour_picture(const std::filesystem::path& file, int width, const ContourPanel& panel) {
  const double plot_width = width * (1.0 - font_share * (panel_left_room + margin));
  if (plot_width * height_over_width(panel.domain) <= tallest_plot * width) {
    write_wide_picture(file, width, panel);
  } else {
    write_tall_picture(file, width, panel);
  }
}

}  // namespace slope::tools
