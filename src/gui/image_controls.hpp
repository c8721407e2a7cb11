#pragma once

#include <QWidget>

#include <functional>

#include "gui/image_part.hpp"
#include "view/echo_window.hpp"
#include "view/quantity.hpp"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLineEdit;
class QSlider;

namespace sarsim {

class ProblemLine;

/// The choices of an image viewer as a form: what of the samples is drawn, and in which colours.
class ImageControls : public QWidget {
  Q_OBJECT

 public:
  explicit ImageControls(QWidget* parent = nullptr);

  /// Shows a look for values of a kind; says nothing back.
  /// @param unit  of magnitudes: "V", or empty for counts
  void show_look(const ImageLook& look, ImageValue value, const QString& unit);
  /// Limits that are set by hand begin with these.
  void set_present_limits(const ColourLimits& limits) { present_ = limits; }
  /// Columns (range) and rows (time) that follow other viewers.
  [[nodiscard]] AxisLink link() const;

 signals:
  void edited(const sarsim::ImageLook& look);
  void link_changed();

 private:
  void make_colours(QFormLayout* form);
  void make_limits(QFormLayout* form);
  void make_links(QFormLayout* form);
  QComboBox* add_choice(QFormLayout* form, const QString& label, const char* name, const QString& tip,
                        const std::function<void(ImageLook&, int)>& apply);
  QLineEdit* add_number(QFormLayout* form, const QString& label, const char* name, const QString& tip,
                        const std::function<QString(double)>& apply, std::function<Quantity()> kind);
  QSlider* add_slider(QFormLayout* form, const QString& label, const char* name, double ClassicSliders::*slider);
  void change(const std::function<void(ImageLook&)>& apply);
  [[nodiscard]] Quantity value_kind() const;
  void show_rows();

  ImageLook look_;
  ImageValue value_ = ImageValue::complex;
  QString unit_;
  ColourLimits present_;
  bool showing_ = false;
  QFormLayout* form_ = nullptr;
  QComboBox* quantity_ = nullptr;
  QCheckBox* peak_ = nullptr;
  QComboBox* map_ = nullptr;
  QCheckBox* inverted_ = nullptr;
  QSlider* brightness_ = nullptr;
  QSlider* contrast_ = nullptr;
  QSlider* saturation_ = nullptr;
  QComboBox* limits_ = nullptr;
  QLineEdit* percentile_ = nullptr;
  QLineEdit* low_ = nullptr;
  QLineEdit* high_ = nullptr;
  QLineEdit* floor_ = nullptr;
  QCheckBox* link_columns_ = nullptr;
  QCheckBox* link_rows_ = nullptr;
  ProblemLine* problem_ = nullptr;
};

}  // namespace sarsim
