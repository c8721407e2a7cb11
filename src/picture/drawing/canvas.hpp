#pragma once

#include <cairo.h>
#include <pango/pangocairo.h>

#include <memory>
#include <string>

#include "core/task/stop_points.hpp"
#include "picture/figure/picture_file.hpp"

namespace sarsim::picture {

/// A rectangle of a picture, pixels from its upper left corner.
struct Area {
  double left = 0.0;
  double top = 0.0;
  double width = 0.0;
  double height = 0.0;

  [[nodiscard]] double right() const { return left + width; }
  [[nodiscard]] double bottom() const { return top + height; }
};

/// Throws where drawing failed: std::bad_alloc without memory, std::runtime_error with the cause otherwise.
void expect_good(cairo_status_t status);

/// What a picture is drawn on, in pixels of PictureStyle.
class Canvas {
 public:
  /// @param stop  null: cannot be stopped
  /// @throws as `expect_good`, where there is no room for so many dots
  Canvas(PictureKind kind, const PictureStyle& style, const std::string& title, const core::StopFlag* stop);
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  [[nodiscard]] cairo_t* cairo() const { return cairo_.get(); }
  [[nodiscard]] double width() const { return style_.width_px; }
  [[nodiscard]] double height() const { return style_.height_px; }
  /// Dots of a pixel; of pictures that are drawn at any size, the finest that anybody looks at.
  [[nodiscard]] double dots_per_px() const { return kind_ == PictureKind::png ? style_.scale : finest_dots_per_px; }
  /// Whether whoever shows the picture makes images larger by smoothing them, whatever they are asked.
  [[nodiscard]] bool smooths_images() const { return kind_ == PictureKind::svg; }

  /// Throws Interrupted where a stop has been requested: before what takes some milliseconds.
  void end_if_asked() const { core::end_if_asked(output_.stop); }
  [[nodiscard]] const core::StopFlag* stop() const { return output_.stop; }

  /// The colour of what is drawn next.
  void use(Role role, double alpha = 1.0) const;
  /// A straight line, one pixel wide.
  void line(double x1, double y1, double x2, double y2) const;

  /// Ends the picture and returns its bytes.
  /// @throws std::runtime_error where something of it could not be drawn; Interrupted
  [[nodiscard]] std::string finish();

 private:
  struct Closer {
    void operator()(cairo_t* cairo) const { cairo_destroy(cairo); }
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  };

  // What the library hands over, which ends its work where that is no longer wanted.
  struct Output {
    std::string bytes;
    const core::StopFlag* stop = nullptr;

    static cairo_status_t append(void* output, const unsigned char* data, unsigned int length);
  };

  static cairo_surface_t* surface_for(PictureKind kind, const PictureStyle& style, const std::string& title,
                                      Output& output);

  static constexpr double finest_dots_per_px = 16.0;

  PictureKind kind_;
  PictureStyle style_;
  Output output_;
  std::unique_ptr<cairo_surface_t, Closer> surface_;
  std::unique_ptr<cairo_t, Closer> cairo_;
};

/// Words set in the picture's font.
class Words {
 public:
  /// One line, as long as it is.
  Words(const Canvas& canvas, const std::string& text, bool bold = false);
  /// Centred in lines of a width; what is longer than three lines ends with dots.
  Words(const Canvas& canvas, const std::string& text, double width, bool bold);

  [[nodiscard]] double width() const { return width_; }
  [[nodiscard]] double height() const { return height_; }
  /// Draws them with their upper left corner at a place.
  void draw(double left, double top) const;
  /// Of the first line, from its upper edge.
  [[nodiscard]] double base_line() const;
  /// Draws their outlines as lines of a width, with the left end of the base line at a place.
  void outline(double left, double base_line, double width) const;
  /// Draws them upwards (or, from above, downwards) with their middle at a place.
  void draw_turned(double x, double y, bool downwards) const;

 private:
  struct Closer {
    void operator()(PangoLayout* layout) const { g_object_unref(layout); }
  };

  void measure();

  const Canvas* canvas_;
  std::unique_ptr<PangoLayout, Closer> layout_;
  double width_ = 0.0;
  double height_ = 0.0;
};

}  // namespace sarsim::picture
