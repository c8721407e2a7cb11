#pragma once

#include <QWidget>

#include <functional>

#include "scene/scene.hpp"
#include "view/echo_window.hpp"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QSlider;

namespace sarsim {

class ProblemLine;

/// The choices of a simulation window as a form (thesis 4.5.1): what is computed, how it is drawn, which part is seen.
class EchoControls : public QWidget {
  Q_OBJECT

 public:
  explicit EchoControls(QWidget* parent = nullptr);

  /// Shows the choices; says nothing back.
  void show_window(const EchoWindow& window, const Scene& scene);
  [[nodiscard]] AxisLink link() const;

 signals:
  void edited(const sarsim::EchoWindow& window);  ///< Something was chosen or typed.
  void view_typed(const sarsim::EchoView& view);  ///< Limits were typed.
  void link_changed();

 private:
  void make_data_group(QFormLayout* form);
  void make_drawing_group(QFormLayout* form);
  void make_colour_group(QFormLayout* form);
  void make_view_group(QFormLayout* form);
  QComboBox* add_choice(QFormLayout* form, const QString& label, const char* name, const QString& tip,
                        const std::function<void(EchoWindow&, int)>& apply);
  QLineEdit* add_text(QFormLayout* form, const QString& label, const char* name, const QString& tip,
                      const std::function<QString(const QString&)>& apply);
  QSlider* add_slider(QFormLayout* form, const QString& label, const char* name,
                      const std::function<void(EchoWindow&, double)>& apply);
  void change(const std::function<void(EchoWindow&)>& apply);
  [[nodiscard]] QString take_sampling(const QString& text);
  [[nodiscard]] QString take_limit(const QString& text, double LimitRule::*end);
  [[nodiscard]] QString take_view(const QString& text, double EchoView::*end, bool is_range);
  void show_rows();

  EchoWindow window_;
  bool showing_ = false;
  QComboBox* radar_ = nullptr;
  QComboBox* data_ = nullptr;
  QComboBox* sampling_ = nullptr;
  QLineEdit* sampling_value_ = nullptr;
  QComboBox* position_ = nullptr;
  QCheckBox* peak_ = nullptr;
  QComboBox* quantity_ = nullptr;
  QComboBox* draw_as_ = nullptr;
  QComboBox* placing_ = nullptr;
  QComboBox* map_ = nullptr;
  QCheckBox* inverted_ = nullptr;
  QSlider* brightness_ = nullptr;
  QSlider* contrast_ = nullptr;
  QSlider* saturation_ = nullptr;
  QComboBox* limits_ = nullptr;
  QLineEdit* low_ = nullptr;
  QLineEdit* high_ = nullptr;
  QLineEdit* percentile_ = nullptr;
  QComboBox* reference_ = nullptr;
  QLineEdit* reference_v_ = nullptr;
  QLineEdit* floor_ = nullptr;
  QLineEdit* range_from_ = nullptr;
  QLineEdit* range_to_ = nullptr;
  QLineEdit* time_from_ = nullptr;
  QLineEdit* time_to_ = nullptr;
  QCheckBox* link_range_ = nullptr;
  QCheckBox* link_time_ = nullptr;
  ProblemLine* problem_ = nullptr;
  QFormLayout* drawing_ = nullptr;
  QFormLayout* data_form_ = nullptr;
  QFormLayout* colour_form_ = nullptr;
};

}  // namespace sarsim
