#pragma once

#include <QImage>
#include <QWidget>

#include "gui/image/image_part.hpp"

namespace sarsim::gui {

/// The whole image, small, with a mark around the part that is seen; a click or drag moves the view there.
class ImageThumbnail : public QWidget {
  Q_OBJECT

 public:
  explicit ImageThumbnail(QWidget* parent = nullptr);

  /// Shows a picture of an image of so many samples.
  void set_picture(const QImage& picture, std::size_t rows, std::size_t columns);
  [[nodiscard]] const QImage& picture() const { return picture_; }
  /// Marks the part that is seen.
  void set_view(const ImageView& view);
  /// Where the mark is drawn.
  [[nodiscard]] QRectF mark() const;

  [[nodiscard]] QSize sizeHint() const override { return {200, 200}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {200, 200}; }

 signals:
  void centre_wanted(double column, double row);   ///< The view is to have this place in its middle.
  void centre_dragged(double column, double row);  ///< On from where it was wanted, with the button held.

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;

 private:
  [[nodiscard]] QRectF place() const;
  [[nodiscard]] QPointF sample_at(QPointF pixel) const;

  QImage picture_;
  std::size_t rows_ = 1;
  std::size_t columns_ = 1;
  ImageView view_;
};

}  // namespace sarsim::gui
