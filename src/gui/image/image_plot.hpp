#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "gui/common/gesture_plot.hpp"
#include "gui/image/image_part.hpp"
#include "gui/image/image_slices.hpp"
#include "raster/table/image_places.hpp"

namespace sarsim::gui {

/// A place of an image in samples.
struct SamplePlace {
  double column = 0.0;
  double row = 0.0;
};

/// The part of an image that is looked at, with its axes, in the places of its samples where those are known, and
/// colour bar ("image_plot"). It shows what it is given and
/// turns gestures into wishes; who reads is the owner's business. Until samples of a new view arrive, those of the old
/// one are shown where they belong, before a coarse picture of the whole image.
///
/// Left drag zooms to the rectangle, with Shift selects it; a left click sets the first cursor, with Shift the second.
/// With the reading tool a click asks for a reading instead. Escape drops a rectangle, then selection and cursors.
class ImagePlot : public GesturePlot {
  Q_OBJECT

 public:
  explicit ImagePlot(QWidget* parent = nullptr);

  /// Size of the image, for the limits of views.
  void set_size(std::size_t rows, std::size_t columns);
  /// Where rows and samples are, for the axes; nothing: their numbers.
  void set_places(std::optional<raster::FocusedPlaces> places);
  [[nodiscard]] const std::optional<raster::FocusedPlaces>& places() const { return places_; }
  /// Whether the axes have those places or numbers, and whether metres are as long across as downwards.
  void set_axes(bool numbers, bool equal_scale);
  /// A view as it can be shown: within the limits of the image, and with equal scales where they are wanted.
  [[nodiscard]] ImageView shown_view(const ImageView& view) const;
  /// Names, units and places as the axes have them; the numbers of rows and samples where no places are shown.
  [[nodiscard]] raster::FocusedPlaces shown_places() const;
  /// Shows another part; what there is of it is drawn at once.
  void set_view(const ImageView& view);
  [[nodiscard]] const ImageView& view() const { return view_; }
  /// What was read and painted; null part: nothing.
  void set_part(std::shared_ptr<const ImagePart> part, PaintedPart painted, const QString& unit);
  [[nodiscard]] const std::shared_ptr<const ImagePart>& part() const { return part_; }
  [[nodiscard]] const PaintedPart& painted() const { return painted_; }
  /// Whether what was read is drawn as pixels or as curves (`slices_of`).
  void set_draw_as(picture::DrawAs draw_as);
  /// The curves that are seen; none where there are pixels.
  [[nodiscard]] std::vector<ImageSlice> slices() const;
  /// A picture of the whole image, to be seen where no samples are yet.
  void set_coarse(const QImage& picture);
  /// Whether a click asks for a reading.
  void set_reading_tool(bool on);

  [[nodiscard]] QRect plot_rect() const override;
  /// The place below a pixel of the widget, and back.
  [[nodiscard]] SamplePlace place_at(QPointF pixel) const;
  /// The pixel of a place.
  [[nodiscard]] QPointF pixel_of(SamplePlace place) const;
  /// The place below the pointer; nothing where it is outside the plot.
  [[nodiscard]] std::optional<SamplePlace> pointer_place() const;

  /// A place of the image that is marked.
  struct Ring {
    SamplePlace at;
    bool found = true;  ///< What should be there was found; otherwise the ring is dotted.
  };
  /// Marks places, one of which may be chosen.
  void set_rings(std::vector<Ring> rings, std::optional<std::size_t> chosen);
  [[nodiscard]] const std::vector<Ring>& rings() const { return rings_; }
  [[nodiscard]] std::optional<std::size_t> chosen_ring() const { return chosen_ring_; }

  [[nodiscard]] const std::optional<SamplePlace>& cursor(std::size_t index) const { return cursors_.at(index); }
  /// Sets cursor 0 or 1, or takes it away.
  void set_cursor(std::size_t index, std::optional<SamplePlace> place);
  /// The selected samples; nothing where none are.
  [[nodiscard]] const std::optional<raster::ImageWindow>& selection() const { return selection_; }
  /// Selects samples, or nothing.
  void set_selection(std::optional<raster::ImageWindow> selection);

 signals:
  void view_wanted(const sarsim::gui::ImageView& view);      ///< Zoom: the view before is one to go back to.
  void view_dragged(const sarsim::gui::ImageView& view);     ///< One of many views on the way.
  void selection_changed();                                  ///< Other samples are selected, or none.
  void reading_wanted(std::size_t row, std::size_t column);  ///< The point next to a sample is to be measured.
  void ring_clicked(std::size_t ring);                       ///< One of the rings, by its number.

 protected:
  void paint_plot(QPainter& painter) const override;
  void paintEvent(QPaintEvent* event) override;
  void click(QPointF at, Qt::KeyboardModifiers keys) override;
  void take_rectangle(QPointF from, QPointF to) override;
  void show_twice(QPointF middle) override;
  void scale_about_pixel(QPointF pixel, double across, double upwards) override;
  void begin_drag() override { dragged_view_ = view_; }
  void drag(QPointF by) override;
  void step(double right, double up) override;
  void drop_marks() override;
  [[nodiscard]] std::optional<QPointF> mark(std::size_t index) const override;
  void move_mark(std::size_t index, QPointF to) override;

 private:
  void paint_slices(QPainter& painter) const;
  void paint_axes(QPainter& painter) const;
  void paint_colour_bar(QPainter& painter) const;
  void paint_marks(QPainter& painter) const;
  void paint_rings(QPainter& painter) const;
  [[nodiscard]] std::optional<std::size_t> ring_at(QPointF pixel) const;
  [[nodiscard]] QRectF rect_of(const QRectF& samples) const;
  /// A view moved by shares of its size, to the right and downwards.
  [[nodiscard]] ImageView moved(const ImageView& view, double right, double down) const;
  [[nodiscard]] ImageView mended_here(const ImageView& view) const { return mended(view, rows_, columns_); }
  [[nodiscard]] bool has_equal_scale() const;

  std::size_t rows_ = 1;
  std::size_t columns_ = 1;
  std::optional<raster::FocusedPlaces> places_;
  bool numbers_ = false;
  bool equal_scale_ = true;
  picture::DrawAs draw_as_ = picture::DrawAs::pixels;
  ImageView view_;
  std::shared_ptr<const ImagePart> part_;
  PaintedPart painted_;
  QString unit_;
  QImage coarse_;
  QImage bar_;
  std::array<std::optional<SamplePlace>, 2> cursors_;
  std::optional<raster::ImageWindow> selection_;
  bool reading_tool_ = false;
  std::vector<Ring> rings_;
  std::optional<std::size_t> chosen_ring_;
  ImageView dragged_view_;
};

}  // namespace sarsim::gui
