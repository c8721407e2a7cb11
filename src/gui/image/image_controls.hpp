#pragma once

#include <QWidget>

#include <functional>
#include <vector>

#include "gui/common/colour_rows.hpp"
#include "gui/common/form_rows.hpp"
#include "gui/image/image_part.hpp"
#include "picture/echo/echo_window.hpp"
#include "raster/table/image_places.hpp"

namespace sarsim::gui {

/// The choices of an image viewer as a form: what of the samples is drawn, and in which colours.
class ImageControls : public QWidget {
  Q_OBJECT

 public:
  explicit ImageControls(QWidget* parent = nullptr);

  /// Shows a look for values of a kind; says nothing back.
  /// @param unit  of magnitudes: "V", or empty for counts
  void show_look(const PartLook& look, raster::ImageValue value, const QString& unit);
  /// Shows which part is seen, in the places that its axes show; says nothing back.
  void show_view(const ImageView& view, const raster::FocusedPlaces& places);
  /// Limits that are set by hand begin with these.
  void set_present_limits(const picture::ColourLimits& limits) { colours_.set_present_limits(limits); }
  /// Columns (range) and rows (time) that follow other viewers.
  [[nodiscard]] picture::AxisLink link() const;

 signals:
  void edited(const sarsim::gui::PartLook& look);       ///< Something was chosen or typed.
  void view_typed(const sarsim::gui::ImageView& view);  ///< An end of an axis was typed.
  void link_changed();                                  ///< Other axes follow other viewers.

 private:
  // An end of an axis.
  struct Limit {
    double ImageView::*end;
    raster::ImagePlaces raster::FocusedPlaces::*axis;
    QLineEdit* field = nullptr;
  };

  void make_axes(QFormLayout* form);
  void make_limits(QFormLayout* form);
  void take_limit(const Limit& limit, double place);
  void make_links(QFormLayout* form);
  void change(const std::function<void(PartLook&)>& apply);

  PartLook look_;
  ImageView view_;
  raster::FocusedPlaces places_;
  std::vector<Limit> limits_;
  raster::ImageValue value_ = raster::ImageValue::complex;
  QString unit_;
  ProblemLine* problem_;
  FormRows rows_;
  ColourRows colours_;
  QFormLayout* form_ = nullptr;
  QComboBox* quantity_ = nullptr;
  QComboBox* draw_as_ = nullptr;
  QCheckBox* peak_ = nullptr;
  QCheckBox* numbers_ = nullptr;
  QCheckBox* equal_scale_ = nullptr;
  QCheckBox* link_columns_ = nullptr;
  QCheckBox* link_rows_ = nullptr;
};

}  // namespace sarsim::gui
