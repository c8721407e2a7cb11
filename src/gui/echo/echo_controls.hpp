#pragma once

#include <QWidget>

#include <functional>

#include "gui/common/colour_rows.hpp"
#include "gui/common/form_rows.hpp"
#include "picture/echo/echo_window.hpp"
#include "scene/model/scene.hpp"

namespace sarsim::gui {

/// The choices of a simulation window as a form (thesis 4.5.1): what is computed, how it is drawn, which part is seen.
class EchoControls : public QWidget {
  Q_OBJECT

 public:
  explicit EchoControls(QWidget* parent = nullptr);

  /// Shows the choices; says nothing back.
  void show_window(const picture::EchoWindow& window, const scene::Scene& scene);
  /// The axes that follow other windows.
  [[nodiscard]] picture::AxisLink link() const;

 signals:
  void edited(const sarsim::picture::EchoWindow& window);  ///< Something was chosen or typed.
  void view_typed(const sarsim::picture::EchoView& view);  ///< Limits were typed.
  void link_changed();                                     ///< Other axes follow other windows.

 private:
  void make_data_group(QFormLayout* form);
  void make_drawing_group(QFormLayout* form);
  void make_colour_group(QFormLayout* form);
  void make_reference_rows(QFormLayout* form);
  void make_view_group(QFormLayout* form);
  QComboBox* add_list(QFormLayout* form, const FormRows::Words& words, const QStringList& items,
                      std::function<void(picture::EchoWindow&, int)> apply);
  void change(const std::function<void(picture::EchoWindow&)>& apply);
  void show_data();
  void show_view();
  void show_rows();

  picture::EchoWindow window_;
  ProblemLine* problem_;
  FormRows rows_;
  ColourRows colours_;
  QComboBox* radar_ = nullptr;
  QComboBox* data_ = nullptr;
  QComboBox* sampling_ = nullptr;
  QLineEdit* sampling_value_ = nullptr;
  QComboBox* position_ = nullptr;
  QCheckBox* peak_ = nullptr;
  QComboBox* draw_as_ = nullptr;
  QComboBox* placing_ = nullptr;
  QComboBox* reference_ = nullptr;
  QLineEdit* reference_v_ = nullptr;
  QLineEdit* range_from_ = nullptr;
  QLineEdit* range_to_ = nullptr;
  QLineEdit* time_from_ = nullptr;
  QLineEdit* time_to_ = nullptr;
  QCheckBox* link_range_ = nullptr;
  QCheckBox* link_time_ = nullptr;
  QFormLayout* data_form_ = nullptr;
  QFormLayout* colour_form_ = nullptr;
};

}  // namespace sarsim::gui
