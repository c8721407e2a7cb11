#pragma once

#include <QObject>

#include <functional>
#include <optional>

#include "gui/common/form_rows.hpp"
#include "picture/colour/display_quantity.hpp"
#include "scene/schema/quantity.hpp"

namespace sarsim::gui {

/// The rows of a form that choose how samples become colours: quantity, palette, limits and decibels. Only those are
/// seen that have a say now.
class ColourRows : public QObject {
  Q_OBJECT

 public:
  /// @param rows    makes the rows
  /// @param prefix  of the names of the fields: "echo_" makes "echo_quantity", "echo_map" ...
  ColourRows(FormRows& rows, QString prefix, QObject* parent);

  /// What of the samples is shown. Another kind of quantity changes a palette that would mislead.
  QComboBox* add_quantity(QFormLayout* form);
  /// Palette, its order, and the sliders of the classic ones.
  void add_palette(QFormLayout* form);
  /// How limits are found, and their values.
  void add_limits(QFormLayout* form);
  /// Decibels below the upper limit that are shown.
  void add_span(QFormLayout* form);

  /// Shows a look; says nothing back. All rows must have been added.
  /// @param values     what magnitudes are: voltages or numbers
  /// @param meaningful false where the samples are colours themselves: then nothing here has a say
  void show(const picture::ColourLook& look, scene::Quantity values, bool meaningful = true);
  /// Limits that are set by hand begin with these, to six digits.
  void set_present_limits(const picture::ColourLimits& limits);

 signals:
  void chosen(const sarsim::picture::ColourLook& look);  ///< Something of it was changed.

 private:
  using Words = FormRows::Words;
  [[nodiscard]] Words words(const QString& label, const char* name, const QString& tip) const;
  void change(const std::function<void(picture::ColourLook&)>& apply);
  QLineEdit* add_limit(QFormLayout* form, const Words& words, double picture::LimitRule::*end);
  [[nodiscard]] scene::Quantity shown_kind() const;
  void show_rows();

  FormRows& rows_;
  QString prefix_;
  picture::ColourLook look_;
  scene::Quantity values_ = scene::Quantity::voltage;
  bool meaningful_ = true;
  std::optional<picture::ColourLimits> present_;
  QComboBox* quantity_ = nullptr;
  QComboBox* map_ = nullptr;
  QCheckBox* inverted_ = nullptr;
  QSlider* brightness_ = nullptr;
  QSlider* contrast_ = nullptr;
  QSlider* saturation_ = nullptr;
  QComboBox* limits_ = nullptr;
  QLineEdit* percentile_ = nullptr;
  QLineEdit* low_ = nullptr;
  QLineEdit* high_ = nullptr;
  QLineEdit* span_ = nullptr;
  QFormLayout* palette_form_ = nullptr;
  QFormLayout* limits_form_ = nullptr;
  QFormLayout* span_form_ = nullptr;
};

}  // namespace sarsim::gui
