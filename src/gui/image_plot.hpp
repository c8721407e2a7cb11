#pragma once

#include <QImage>
#include <QWidget>

#include <array>
#include <memory>
#include <optional>

#include "gui/image_part.hpp"

namespace sarsim {

/// A place of an image in samples.
struct ImagePlace {
  double column = 0.0;
  double row = 0.0;
};

/// The part of an image that is looked at, with its axes and colour bar ("image_plot"). It shows what it is given and
/// turns gestures into wishes; who reads is the owner's business. Until samples of a new view arrive, those of the old
/// one are shown where they belong, before a coarse picture of the whole image.
///
/// Mouse: left drag zooms to the rectangle, with Shift selects it; right click shows twice as much; the wheel zooms at
/// the pointer (Ctrl: columns alone, Shift: rows alone); middle drag moves the view; a left click sets the first
/// cursor, with Shift the second. With the reading tool a click asks for a reading instead. Keys: arrows move by a
/// quarter, + and - zoom, Backspace goes back, Home shows everything, Escape drops a rectangle, then selection and
/// cursors.
class ImagePlot : public QWidget {
  Q_OBJECT

 public:
  explicit ImagePlot(QWidget* parent = nullptr);

  /// Size of the image, for the limits of views.
  void set_size(std::size_t rows, std::size_t columns);
  void set_view(const ImageView& view);
  [[nodiscard]] const ImageView& view() const { return view_; }
  /// What was read and painted; null part: nothing.
  void set_part(std::shared_ptr<const ImagePart> part, PaintedPart painted, const QString& unit);
  [[nodiscard]] const std::shared_ptr<const ImagePart>& part() const { return part_; }
  [[nodiscard]] const PaintedPart& painted() const { return painted_; }
  /// A picture of the whole image, to be seen where no samples are yet.
  void set_coarse(const QImage& picture);
  void set_reading_tool(bool on);

  /// The plot within the widget, and its size in device pixels.
  [[nodiscard]] QRect plot_rect() const;
  [[nodiscard]] QSize device_size() const;
  /// The plot alone, in device pixels.
  [[nodiscard]] QImage plot_image() const;
  /// The place below a pixel of the widget, and back.
  [[nodiscard]] ImagePlace place_at(QPointF pixel) const;
  [[nodiscard]] QPointF pixel_of(ImagePlace place) const;
  /// The place below the pointer; nothing where it is outside the plot.
  [[nodiscard]] std::optional<ImagePlace> pointer_place() const;

  [[nodiscard]] const std::optional<ImagePlace>& cursor(std::size_t index) const { return cursors_.at(index); }
  void set_cursor(std::size_t index, std::optional<ImagePlace> place);
  /// The selected samples; nothing where none are.
  [[nodiscard]] const std::optional<ImageWindow>& selection() const { return selection_; }
  void set_selection(std::optional<ImageWindow> selection);

  [[nodiscard]] QSize sizeHint() const override { return {760, 480}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {260, 200}; }

 signals:
  void view_wanted(const sarsim::ImageView& view);  ///< Zoom: the view before is one to go back to.
  void view_dragged(const sarsim::ImageView& view);
  void drag_began();
  void back_wanted();
  void whole_wanted();
  void resized();
  void hovered();
  void cursors_changed();
  void selection_changed();
  void reading_wanted(std::size_t row, std::size_t column);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  void paint_plot(QPainter& painter) const;
  void paint_axes(QPainter& painter) const;
  void paint_colour_bar(QPainter& painter) const;
  void paint_marks(QPainter& painter) const;
  void paint_cursor(QPainter& painter, std::size_t index) const;
  [[nodiscard]] QRectF rect_of(const QRectF& samples) const;
  void scale_about_pixel(QPointF pixel, double column_factor, double row_factor);
  void click(const QMouseEvent& event);

  std::size_t rows_ = 1;
  std::size_t columns_ = 1;
  ImageView view_;
  std::shared_ptr<const ImagePart> part_;
  PaintedPart painted_;
  QString unit_;
  QImage coarse_;
  QImage bar_;
  std::array<std::optional<ImagePlace>, 2> cursors_;
  std::optional<ImageWindow> selection_;
  bool reading_tool_ = false;
  std::optional<QPointF> rectangle_from_;
  bool selecting_ = false;
  QPointF pointer_{-1.0, -1.0};
  std::optional<QPointF> moved_from_;
  ImageView moved_view_;
};

}  // namespace sarsim
