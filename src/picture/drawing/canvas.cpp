#include "picture/drawing/canvas.hpp"

#include <cairo-pdf.h>
#include <cairo-svg.h>

#include <cmath>
#include <new>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

namespace sarsim::picture {

namespace {

constexpr double font_px = 12.0;

// Text that Pango takes: names of files may hold any bytes.
std::string valid(const std::string& text) {
  char* const made = g_utf8_make_valid(text.data(), static_cast<gssize>(text.size()));
  std::string result(made);
  g_free(made);
  return result;
}

}  // namespace

void expect_good(cairo_status_t status) {
  if (status == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
  if (status != CAIRO_STATUS_SUCCESS)
    throw std::runtime_error(fmt::format("the picture could not be drawn: {}", cairo_status_to_string(status)));
}

cairo_status_t Canvas::Output::append(void* output, const unsigned char* data, unsigned int length) {
  auto& [bytes, stop] = *static_cast<Output*>(output);
  if (stop != nullptr && stop->requested()) return CAIRO_STATUS_WRITE_ERROR;
  bytes.append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

cairo_surface_t* Canvas::surface_for(PictureKind kind, const PictureStyle& style, const std::string& title,
                                     Output& output) {
  switch (kind) {
    case PictureKind::png: break;
    case PictureKind::svg: {
      cairo_surface_t* const surface =
          cairo_svg_surface_create_for_stream(Output::append, &output, style.width_px, style.height_px);
      cairo_svg_surface_set_document_unit(surface, CAIRO_SVG_UNIT_PX);
      return surface;
    }
    case PictureKind::pdf: {
      cairo_surface_t* const surface =
          cairo_pdf_surface_create_for_stream(Output::append, &output, style.width_px, style.height_px);
      cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_TITLE, valid(title).c_str());
      cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATOR, "sarsim");
      // Not when it was drawn: equal figures are equal files.
      cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, "");
      return surface;
    }
  }
  const auto dots = [&](int px) { return static_cast<int>(std::lround(px * style.scale)); };
  return cairo_image_surface_create(CAIRO_FORMAT_RGB24, dots(style.width_px), dots(style.height_px));
}

Canvas::Canvas(PictureKind kind, const PictureStyle& style, const std::string& title, const core::StopFlag* stop)
    : kind_(kind), style_(style), output_{{}, stop}, surface_(surface_for(kind, style, title, output_)) {
  end_if_asked();
  expect_good(cairo_surface_status(surface_.get()));
  cairo_.reset(cairo_create(surface_.get()));
  if (kind == PictureKind::png) cairo_scale(cairo(), style.scale, style.scale);
  use(Role::background);
  cairo_paint(cairo());
}

void Canvas::use(Role role, double alpha) const {
  const raster::Rgb rgb = colour(role, style_.dark);
  cairo_set_source_rgba(cairo(), rgb.red / 255.0, rgb.green / 255.0, rgb.blue / 255.0, alpha);
}

void Canvas::line(double x1, double y1, double x2, double y2) const {
  // On the middle of a pixel, where it is as dark as it is thin.
  const auto snapped = [](double a, double b, double v) { return a == b ? std::floor(v) + 0.5 : v; };
  cairo_set_line_width(cairo(), 1.0);
  cairo_move_to(cairo(), snapped(x1, x2, x1), snapped(y1, y2, y1));
  cairo_line_to(cairo(), snapped(x1, x2, x2), snapped(y1, y2, y2));
  cairo_stroke(cairo());
}

std::string Canvas::finish() {
  end_if_asked();
  expect_good(cairo_status(cairo()));
  cairo_status_t status = CAIRO_STATUS_SUCCESS;
  if (kind_ == PictureKind::png) {
    cairo_surface_flush(surface_.get());
    status = cairo_surface_write_to_png_stream(surface_.get(), Output::append, &output_);
  } else {
    cairo_show_page(cairo());
    cairo_surface_finish(surface_.get());
    status = cairo_surface_status(surface_.get());
  }
  end_if_asked();
  expect_good(status);
  return std::move(output_.bytes);
}

namespace {

PangoLayout* layout_of(const Canvas& canvas, const std::string& text, bool bold) {
  PangoLayout* const layout = pango_cairo_create_layout(canvas.cairo());
  // Letters stand where they belong, not on whole dots: the same at any scale.
  cairo_font_options_t* const options = cairo_font_options_create();
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  pango_cairo_context_set_font_options(pango_layout_get_context(layout), options);
  cairo_font_options_destroy(options);
  PangoFontDescription* const font = pango_font_description_from_string("Sans");
  pango_font_description_set_absolute_size(font, font_px * PANGO_SCALE);
  if (bold) pango_font_description_set_weight(font, PANGO_WEIGHT_BOLD);
  pango_layout_set_font_description(layout, font);
  pango_font_description_free(font);
  pango_layout_set_single_paragraph_mode(layout, TRUE);
  const std::string sound = valid(text);
  pango_layout_set_text(layout, sound.data(), static_cast<int>(sound.size()));
  return layout;
}

}  // namespace

Words::Words(const Canvas& canvas, const std::string& text, bool bold)
    : canvas_(&canvas), layout_(layout_of(canvas, text, bold)) {
  measure();
}

Words::Words(const Canvas& canvas, const std::string& text, double width, bool bold)
    : canvas_(&canvas), layout_(layout_of(canvas, text, bold)) {
  constexpr int max_lines = 3;
  pango_layout_set_width(layout_.get(), static_cast<int>(std::lround(width * PANGO_SCALE)));
  pango_layout_set_wrap(layout_.get(), PANGO_WRAP_WORD_CHAR);
  pango_layout_set_alignment(layout_.get(), PANGO_ALIGN_CENTER);
  pango_layout_set_height(layout_.get(), -max_lines);
  pango_layout_set_ellipsize(layout_.get(), PANGO_ELLIPSIZE_END);
  measure();
  width_ = width;
}

void Words::measure() {
  PangoRectangle logical;
  pango_layout_get_extents(layout_.get(), nullptr, &logical);
  width_ = static_cast<double>(logical.width) / PANGO_SCALE;
  height_ = static_cast<double>(logical.height) / PANGO_SCALE;
}

void Words::draw(double left, double top) const {
  cairo_move_to(canvas_->cairo(), left, top);
  pango_cairo_show_layout(canvas_->cairo(), layout_.get());
}

double Words::base_line() const { return static_cast<double>(pango_layout_get_baseline(layout_.get())) / PANGO_SCALE; }

void Words::outline(double left, double base_line, double width) const {
  cairo_t* const cairo = canvas_->cairo();
  cairo_move_to(cairo, left, base_line - this->base_line());
  pango_cairo_layout_path(cairo, layout_.get());
  cairo_set_line_width(cairo, width);
  cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
  cairo_stroke(cairo);
}

void Words::draw_turned(double x, double y, bool downwards) const {
  cairo_t* const cairo = canvas_->cairo();
  cairo_save(cairo);
  cairo_translate(cairo, x, y);
  cairo_rotate(cairo, (downwards ? 0.5 : -0.5) * std::numbers::pi);
  draw(-0.5 * width_, -0.5 * height_);
  cairo_restore(cairo);
}

}  // namespace sarsim::picture
