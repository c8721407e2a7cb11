#include "picture/drawing/draw_panel.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "picture/drawing/thin_curve.hpp"
#include "picture/figure/fitted_image.hpp"

namespace sarsim::picture {

namespace {

void clip_to(const Canvas& canvas, const Area& area) {
  cairo_rectangle(canvas.cairo(), area.left, area.top, area.width, area.height);
  cairo_clip(canvas.cairo());
}

// Drawing within an area, and as before afterwards.
class Within {
 public:
  Within(const Canvas& canvas, const Area& area) : cairo_(canvas.cairo()) {
    cairo_save(cairo_);
    clip_to(canvas, area);
  }
  Within(const Within&) = delete;
  Within& operator=(const Within&) = delete;
  ~Within() { cairo_restore(cairo_); }

 private:
  cairo_t* cairo_;
};

struct SurfaceCloser {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
using Surface = std::unique_ptr<cairo_surface_t, SurfaceCloser>;

// An image of so many dots for each cell.
Surface surface_of(const Canvas& canvas, const FigureImage& image, std::size_t across, std::size_t up) {
  Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(across * image.width),
                                             static_cast<int>(up * image.height)));
  expect_good(cairo_surface_status(surface.get()));
  cairo_surface_flush(surface.get());
  unsigned char* const data = cairo_image_surface_get_data(surface.get());
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface.get()));
  for (std::size_t row = 0; row < up * image.height; ++row) {
    canvas.end_if_asked();
    auto* const line = reinterpret_cast<std::uint32_t*>(data + row * stride);
    for (std::size_t column = 0; column < across * image.width; ++column) {
      const raster::Rgb& cell = image.cells[row / up * image.width + column / across];
      line[column] = static_cast<std::uint32_t>(cell.red) << 16U | static_cast<std::uint32_t>(cell.green) << 8U |
                     static_cast<std::uint32_t>(cell.blue);
    }
  }
  cairo_surface_mark_dirty(surface.get());
  return surface;
}

void draw_image(const Canvas& canvas, const FigureImage& whole, const std::optional<FigureColourBar>& bar,
                const PlacedPanel& p) {
  const double left = p.x.place(whole.x_first);
  const double top = p.y.place(whole.y_first);
  const auto at_most = [&](double length_px) {
    return static_cast<std::size_t>(std::max(1.0, std::floor(std::abs(length_px) * canvas.dots_per_px())));
  };
  const FigureImage image = fitted(whole, bar, at_most(p.x.place(whole.x_last) - left),
                                   at_most(p.y.place(whole.y_last) - top), canvas.stop());
  const double per_column = (p.x.place(image.x_last) - left) / static_cast<double>(image.width);
  const double per_row = (p.y.place(image.y_last) - top) / static_cast<double>(image.height);
  if (per_column == 0.0 || per_row == 0.0) return;
  const auto dots = [&](double cell_px) {
    constexpr double per_px = 2.0;
    constexpr double most = 64.0;
    if (!canvas.smooths_images()) return std::size_t{1};
    return static_cast<std::size_t>(std::clamp(std::ceil(per_px * std::abs(cell_px)), 1.0, most));
  };
  const std::size_t across = dots(per_column);
  const std::size_t up = dots(per_row);
  const Surface surface = surface_of(canvas, image, across, up);
  const Within within(canvas, p.area);
  cairo_t* const cairo = canvas.cairo();
  cairo_translate(cairo, left, top);
  cairo_scale(cairo, per_column / static_cast<double>(across), per_row / static_cast<double>(up));
  cairo_set_source_surface(cairo, surface.get(), 0.0, 0.0);
  // Cells stay cells: no colour that no sample has.
  cairo_pattern_set_filter(cairo_get_source(cairo), CAIRO_FILTER_NEAREST);
  cairo_set_antialias(cairo, CAIRO_ANTIALIAS_NONE);
  cairo_rectangle(cairo, 0.0, 0.0, static_cast<double>(across * image.width), static_cast<double>(up * image.height));
  cairo_fill(cairo);
}

void draw_grid(const Canvas& canvas, const PlacedPanel& p) {
  const Within within(canvas, p.area);
  constexpr double dots[] = {1.0, 2.0};
  canvas.use(Role::faint);
  cairo_set_dash(canvas.cairo(), dots, 2, 0.0);
  for (const Tick& tick : p.x.ticks.ticks) {
    const double x = p.x.place(tick.value);
    canvas.line(x, p.area.top, x, p.area.bottom());
  }
  for (const Tick& tick : p.y.ticks.ticks) {
    const double y = p.y.place(tick.value);
    canvas.line(p.area.left, y, p.area.right(), y);
  }
}

// Keeps the part of a line that is within an area (Liang and Barsky); false where there is none. What is far outside
// would be beyond the numbers of the drawing library.
bool cut_to(const Area& area, Point& a, Point& b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  double from = 0.0;
  double to = 1.0;
  for (const auto& [step, room] : {std::pair(-dx, a.x - area.left), std::pair(dx, area.right() - a.x),
                                   std::pair(-dy, a.y - area.top), std::pair(dy, area.bottom() - a.y)}) {
    if (step == 0.0) {
      if (room < 0.0) return false;
      continue;
    }
    const double share = room / step;
    if (step < 0.0)
      from = std::max(from, share);
    else
      to = std::min(to, share);
  }
  if (from > to) return false;
  b = {a.x + to * dx, a.y + to * dy};
  a = {a.x + from * dx, a.y + from * dy};
  return true;
}

// Joins the points of a curve that can be told apart.
void join(const Canvas& canvas, const std::vector<Point>& points, const Area& near) {
  constexpr double trifle_px = 0.1;
  cairo_t* const cairo = canvas.cairo();
  bool joined = false;
  Point last;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point here = points[i];
    if (joined && i + 1 < points.size() && std::hypot(here.x - last.x, here.y - last.y) < trifle_px) continue;
    Point from = joined ? last : here;
    Point to = here;
    if (cut_to(near, from, to)) {
      const bool goes_on = joined && cairo_has_current_point(cairo) != 0 && from.x == last.x && from.y == last.y;
      if (!goes_on) cairo_move_to(cairo, from.x, from.y);
      cairo_line_to(cairo, to.x, to.y);
    }
    joined = true;
    last = here;
  }
}

// The points of a curve, joined where they follow each other.
void trace(const Canvas& canvas, const FigureCurve& curve, const PlacedPanel& p) {
  constexpr double beside_px = 100.0;
  constexpr double column_px = 0.5;
  const Area near{p.area.left - beside_px, p.area.top - beside_px, p.area.width + 2.0 * beside_px,
                  p.area.height + 2.0 * beside_px};
  constexpr std::size_t points_at_once = 65536;  // Between two questions for a stop: a millisecond.
  core::StopPoints stop(canvas.stop(), points_at_once);
  std::vector<Point> points;
  for (std::size_t i = 0; i <= curve.x.size(); ++i) {
    stop.pass();
    if (i < curve.x.size()) {
      const Point here{p.x.place(curve.x[i]), p.y.place(curve.y[i])};
      if (std::isfinite(here.x) && std::isfinite(here.y)) {
        points.push_back(here);
        continue;
      }
    }
    join(canvas, thinned(points, column_px), near);
    points.clear();
  }
}

void draw_bars(const Canvas& canvas, const FigureCurve& curve, const PlacedPanel& p) {
  const double width = curve.x.size() > 1 ? 0.7 * std::abs(p.x.place(curve.x[1]) - p.x.place(curve.x[0])) : 10.0;
  const auto inside = [&](double y) { return std::clamp(y, p.area.top - 10.0, p.area.bottom() + 10.0); };
  const double ground = inside(p.y.place(0.0));
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    const Point here{p.x.place(curve.x[i]), p.y.place(curve.y[i])};
    if (!std::isfinite(here.x) || !std::isfinite(here.y) || here.x < p.area.left - width ||
        here.x > p.area.right() + width)
      continue;
    cairo_rectangle(canvas.cairo(), here.x - 0.5 * width, ground, width, inside(here.y) - ground);
  }
  canvas.use(curve.role, 0.4);
  cairo_fill_preserve(canvas.cairo());
}

void draw_curve(const Canvas& canvas, const FigureCurve& curve, const PlacedPanel& p) {
  constexpr double pen_px = 1.5;
  canvas.end_if_asked();
  const Within within(canvas, p.area);
  cairo_t* const cairo = canvas.cairo();
  cairo_new_path(cairo);
  if (curve.bars)
    draw_bars(canvas, curve, p);
  else
    trace(canvas, curve, p);
  canvas.use(curve.role);
  cairo_set_line_width(cairo, curve.bars ? 1.0 : pen_px);
  cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
  cairo_stroke(cairo);
}

// Light on dark, so that it is seen on any colour.
void draw_ring(cairo_t* cairo, double x, double y) {
  constexpr double radius_px = 8.0;
  for (const double light : {0.0, 1.0}) {
    cairo_set_source_rgb(cairo, light, light, light);
    cairo_set_line_width(cairo, light > 0.0 ? 1.3 : 3.0);
    cairo_new_sub_path(cairo);
    cairo_arc(cairo, x, y, radius_px, 0.0, 2.0 * std::numbers::pi);
    cairo_stroke(cairo);
  }
}

// A ring, or a cross with words above it, to the right where they have room.
void draw_mark(const Canvas& canvas, const FigureMark& mark, const PlacedPanel& p) {
  constexpr double arm_px = 4.5;
  const double x = p.x.place(mark.x);
  const double y = p.y.place(mark.y);
  if (!(x >= p.area.left && x <= p.area.right() && y >= p.area.top && y <= p.area.bottom())) return;
  const Within within(canvas, p.area);
  cairo_t* const cairo = canvas.cairo();
  if (mark.ring) return draw_ring(cairo, x, y);
  canvas.use(Role::error);
  cairo_set_line_width(cairo, 1.5);
  cairo_move_to(cairo, x - arm_px, y);
  cairo_line_to(cairo, x + arm_px, y);
  cairo_move_to(cairo, x, y - arm_px);
  cairo_line_to(cairo, x, y + arm_px);
  cairo_stroke(cairo);
  const Words words(canvas, mark.text);
  // Words that would end outside stand to the left of their place.
  const bool fits = x + gap_px + words.width() <= p.area.right();
  words.draw(fits ? x + gap_px : x - gap_px - words.width(), y - gap_px + 2.0 - words.height());
}

// Marks and words below (or above) the panel's area.
void draw_axis_across(const Canvas& canvas, const PlacedAxis& axis, const Area& area, bool above) {
  const double edge = above ? area.top : area.bottom();
  const double side = above ? -1.0 : 1.0;
  double outer = edge + side * (tick_px + 0.5 * gap_px);
  canvas.use(Role::text);
  for (const Tick& tick : axis.ticks.ticks) {
    const double x = axis.place(tick.value);
    canvas.line(x, edge, x, edge + side * tick_px);
    const Words words(canvas, tick.label);
    words.draw(x - 0.5 * words.width(), above ? outer - words.height() : outer);
  }
  outer += side * (axis.highest + 0.5 * gap_px);
  const Words title(canvas, axis.title);
  title.draw(area.left + 0.5 * (area.width - title.width()), above ? outer - title.height() : outer);
}

// The same to the left, or to the right of `edge`.
void draw_axis_upwards(const Canvas& canvas, const PlacedAxis& axis, const Area& area, double edge, bool right) {
  const double side = right ? 1.0 : -1.0;
  const double words_at = edge + side * (tick_px + 0.5 * gap_px);
  canvas.use(Role::text);
  for (const Tick& tick : axis.ticks.ticks) {
    const double y = axis.place(tick.value);
    canvas.line(edge, y, edge + side * tick_px, y);
    const Words words(canvas, tick.label);
    words.draw(right ? words_at : words_at - words.width(), y - 0.5 * words.height());
  }
  const double title_at = words_at + side * (axis.widest + gap_px + 0.5 * axis.title_height);
  Words(canvas, axis.title).draw_turned(title_at, area.top + 0.5 * area.height, right);
}

void draw_frame(const Canvas& canvas, const Area& area) {
  canvas.use(Role::text);
  cairo_set_line_width(canvas.cairo(), 1.0);
  cairo_rectangle(canvas.cairo(), area.left + 0.5, area.top + 0.5, area.width - 1.0, area.height - 1.0);
  cairo_stroke(canvas.cairo());
}

void draw_bar(const Canvas& canvas, const FigureColourBar& bar, const PlacedPanel& p) {
  const Area strip{std::round(p.bar_left), p.area.top, bar_px, p.area.height};
  cairo_pattern_t* const colours = cairo_pattern_create_linear(0.0, strip.bottom(), 0.0, strip.top);
  for (std::size_t i = 0; i < bar.colours.size(); ++i) {
    const raster::Rgb& c = bar.colours[i];
    const double at = static_cast<double>(i) / static_cast<double>(bar.colours.size() - 1);
    cairo_pattern_add_color_stop_rgb(colours, at, c.red / 255.0, c.green / 255.0, c.blue / 255.0);
  }
  cairo_set_source(canvas.cairo(), colours);
  cairo_pattern_destroy(colours);
  cairo_rectangle(canvas.cairo(), strip.left, strip.top, strip.width, strip.height);
  cairo_fill(canvas.cairo());
  draw_frame(canvas, strip);
  draw_axis_upwards(canvas, *p.bar, strip, strip.right(), true);
}

void draw_legend(const Canvas& canvas, const FigurePanel& panel, const Area& area) {
  constexpr double sample_px = 22.0;
  double width = 0.0;
  double height = gap_px;
  for (const FigureCurve& curve : panel.curves) {
    if (curve.name.empty()) continue;
    const Words words(canvas, curve.name);
    width = std::max(width, words.width());
    height += words.height();
  }
  if (width == 0.0) return;
  const Area box{area.right() - width - sample_px - 5.0 * gap_px, area.top + 2.0 * gap_px,
                 width + sample_px + 3.0 * gap_px, height};
  cairo_t* const cairo = canvas.cairo();
  cairo_rectangle(cairo, box.left, box.top, box.width, box.height);
  canvas.use(Role::background);
  cairo_fill_preserve(cairo);
  canvas.use(Role::faint);
  cairo_set_line_width(cairo, 1.0);
  cairo_stroke(cairo);
  double top = box.top + 0.5 * gap_px;
  for (const FigureCurve& curve : panel.curves) {
    if (curve.name.empty()) continue;
    const Words words(canvas, curve.name);
    const double middle = top + 0.5 * words.height();
    canvas.use(curve.role);
    cairo_set_line_width(cairo, 1.5);
    cairo_move_to(cairo, box.left + gap_px, middle);
    cairo_line_to(cairo, box.left + gap_px + sample_px, middle);
    cairo_stroke(cairo);
    canvas.use(Role::text);
    words.draw(box.left + 2.0 * gap_px + sample_px, top);
    top += words.height();
  }
}

}  // namespace

void draw_panel(const Canvas& canvas, const FigurePanel& panel, const PlacedPanel& p) {
  const bool has_image = panel.image && !panel.image->cells.empty();
  if (has_image)
    draw_image(canvas, *panel.image, panel.colour_bar, p);
  else
    draw_grid(canvas, p);
  for (const FigureCurve& curve : panel.curves) draw_curve(canvas, curve, p);
  for (const FigureMark& mark : panel.marks) {
    canvas.end_if_asked();
    draw_mark(canvas, mark, p);
  }
  draw_frame(canvas, p.area);
  draw_axis_across(canvas, p.x, p.area, false);
  draw_axis_upwards(canvas, p.y, p.area, p.area.left, false);
  if (p.x_twin) draw_axis_across(canvas, *p.x_twin, p.area, true);
  if (p.y_twin) draw_axis_upwards(canvas, *p.y_twin, p.area, p.area.right(), true);
  if (p.bar) draw_bar(canvas, *panel.colour_bar, p);
  draw_legend(canvas, panel, p.area);
}

}  // namespace sarsim::picture
