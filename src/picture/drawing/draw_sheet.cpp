#include "picture/drawing/draw_sheet.hpp"

#include <cmath>
#include <cstring>
#include <memory>
#include <numbers>

#include "picture/drawing/canvas.hpp"

namespace sarsim::picture {

namespace {

constexpr double rim_px = 3.0;  // about words
constexpr double rim_opacity = 0.85;
constexpr double disc_rim_part = 0.125;    // of the diameter
constexpr std::size_t marks_at_once = 64;  // Drawn between two questions for a stop: a millisecond.

void use_colour(const Canvas& canvas, raster::Rgb rgb, double alpha = 1.0) {
  cairo_set_source_rgba(canvas.cairo(), rgb.red / 255.0, rgb.green / 255.0, rgb.blue / 255.0, alpha);
}

void paint_ground(const Canvas& canvas, const Sheet& sheet) {
  use_colour(canvas, sheet.background);
  cairo_paint(canvas.cairo());
  if (!sheet.sky) return;
  const std::unique_ptr<cairo_pattern_t, void (*)(cairo_pattern_t*)> sky(
      cairo_pattern_create_linear(0.0, 0.0, 0.0, std::max(1.0, sheet.sky->horizon_px)), cairo_pattern_destroy);
  const auto add = [&](double at, raster::Rgb rgb) {
    cairo_pattern_add_color_stop_rgb(sky.get(), at, rgb.red / 255.0, rgb.green / 255.0, rgb.blue / 255.0);
  };
  add(0.0, sheet.sky->top);
  add(1.0, sheet.sky->horizon);
  cairo_rectangle(canvas.cairo(), 0.0, 0.0, canvas.width(), sheet.sky->horizon_px);
  cairo_set_source(canvas.cairo(), sky.get());
  cairo_fill(canvas.cairo());
}

void paint_image(const Canvas& canvas, const Sheet::Image& image) {
  if (image.argb.empty()) return;
  const std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> surface(
      cairo_image_surface_create(CAIRO_FORMAT_ARGB32, image.width, image.height), cairo_surface_destroy);
  expect_good(cairo_surface_status(surface.get()));
  unsigned char* const dots = cairo_image_surface_get_data(surface.get());
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface.get()));
  const std::size_t row = static_cast<std::size_t>(image.width);
  for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y)
    std::memcpy(dots + y * stride, image.argb.data() + y * row, row * sizeof(std::uint32_t));
  cairo_surface_mark_dirty(surface.get());
  cairo_t* const cairo = canvas.cairo();
  cairo_save(cairo);
  cairo_translate(cairo, image.left, image.top);
  cairo_scale(cairo, 1.0 / image.dots_per_px, 1.0 / image.dots_per_px);
  cairo_set_source_surface(cairo, surface.get(), 0.0, 0.0);
  cairo_pattern_set_filter(cairo_get_source(cairo), CAIRO_FILTER_NEAREST);
  cairo_paint(cairo);
  cairo_restore(cairo);
}

void paint_line(const Canvas& canvas, const Sheet::Line& line) {
  constexpr double dots[] = {1.0, 3.0};
  cairo_t* const cairo = canvas.cairo();
  use_colour(canvas, line.colour);
  cairo_set_line_width(cairo, line.width_px);
  cairo_set_dash(cairo, dots, line.dotted ? 2 : 0, 0.0);
  cairo_move_to(cairo, line.x0, line.y0);
  cairo_line_to(cairo, line.x1, line.y1);
  cairo_stroke(cairo);
}

void paint_disc(const Canvas& canvas, const Sheet::Disc& disc) {
  cairo_t* const cairo = canvas.cairo();
  const double rim = disc.rim ? std::max(1.0, disc_rim_part * disc.diameter_px) : 0.0;
  cairo_arc(cairo, disc.x, disc.y, 0.5 * (disc.diameter_px - rim), 0.0, 2.0 * std::numbers::pi);
  use_colour(canvas, disc.colour);
  cairo_fill_preserve(cairo);
  if (disc.rim) {
    use_colour(canvas, *disc.rim);
    cairo_set_line_width(cairo, rim);
    cairo_stroke(cairo);
  }
  cairo_new_path(cairo);
}

}  // namespace

std::string drawn_sheet(const Sheet& sheet, PictureKind kind, const PictureStyle& style, const core::StopFlag* stop) {
  Canvas canvas(kind, style, {}, stop);
  core::StopPoints points(stop, marks_at_once);
  paint_ground(canvas, sheet);
  if (sheet.image) paint_image(canvas, *sheet.image);
  for (const Sheet::Line& line : sheet.lines) {
    points.pass();
    paint_line(canvas, line);
  }
  cairo_set_dash(canvas.cairo(), nullptr, 0, 0.0);
  for (const Sheet::Disc& disc : sheet.discs) {
    points.pass();
    paint_disc(canvas, disc);
  }
  // All rims first: none covers another word.
  for (const bool rim : {true, false})
    for (const Sheet::Text& text : sheet.texts) {
      points.pass();
      const Words words(canvas, text.text, text.bold);
      const double left = text.x - (text.centred ? 0.5 * words.width() : 0.0);
      use_colour(canvas, rim ? sheet.background : text.colour, rim ? rim_opacity : 1.0);
      rim ? words.outline(left, text.y, rim_px) : words.draw(left, text.y - words.base_line());
    }
  return canvas.finish();
}

}  // namespace sarsim::picture
