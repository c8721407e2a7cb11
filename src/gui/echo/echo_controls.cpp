#include "gui/echo/echo_controls.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "core/maths/rounding.hpp"
#include "gui/common/problem_line.hpp"

namespace sarsim::gui {

namespace {

// In the order of the list.
constexpr std::array data_kinds{scene::Processing::raw, scene::Processing::matched_filter, scene::Processing::srp};

constexpr double any = std::numeric_limits<double>::infinity();

// How limits that a mouse has drawn are shown; one that is not typed anew keeps all its digits.
constexpr double shown_range_m = 1e-3;
constexpr double shown_time_s = 1e-9;

}  // namespace

EchoControls::EchoControls(QWidget* parent)
    : QWidget(parent),
      problem_(new ProblemLine(this)),
      rows_(*this, *problem_),
      colours_(rows_, QStringLiteral("echo_"), this) {
  setObjectName("echo_controls");
  problem_->setObjectName("echo_problem");
  auto* const layout = new QVBoxLayout(this);
  make_data_group(data_form_ = add_form_group(layout, tr("Data")));
  make_view_group(add_form_group(layout, tr("Window")));
  make_drawing_group(add_form_group(layout, tr("Drawing")));
  make_colour_group(colour_form_ = add_form_group(layout, tr("Colours")));
  connect(&colours_, &ColourRows::chosen, this, [this](const picture::ColourLook& chosen) {
    change([&](picture::EchoWindow& w) { static_cast<picture::ColourLook&>(w) = chosen; });
  });
  layout->addWidget(problem_);
  layout->addStretch(1);
}

void EchoControls::change(const std::function<void(picture::EchoWindow&)>& apply) {
  picture::EchoWindow changed = window_;
  apply(changed);
  if (changed == window_) return;
  window_ = changed;
  show_rows();
  emit edited(window_);
}

QComboBox* EchoControls::add_list(QFormLayout* form, const FormRows::Words& words, const QStringList& items,
                                  std::function<void(picture::EchoWindow&, int)> apply) {
  auto* const list = rows_.add_choice(form, words, [this, apply = std::move(apply)](int index) {
    change([&](picture::EchoWindow& w) { apply(w, index); });
  });
  list->addItems(items);
  return list;
}

void EchoControls::make_data_group(QFormLayout* form) {
  radar_ = add_list(form, {tr("Radar"), "echo_radar", tr("Radar whose echoes are shown")}, {},
                    [this](picture::EchoWindow& w, int) { w.recording.radar = radar_->currentText().toStdString(); });
  data_ = add_list(form, {tr("Data"), "echo_data", tr("Raw samples, or range-compressed")},
                   {tr("Raw return"), tr("Range compressed"), tr("Synthetic range profiles")},
                   [](picture::EchoWindow& w, int index) {
                     w.recording.processing = data_kinds[static_cast<std::size_t>(index)];
                     if (index > 0 && w.sampling.kind == picture::Sampling::Kind::screen)
                       w.sampling = {picture::Sampling::Kind::multiple, 0.0, 1.0};
                   });
  sampling_ = add_list(
      form,
      {tr("Sampling"), "echo_sampling", tr("One sample for each pixel, a frequency, or a multiple of the bandwidth")},
      {tr("Screen"), tr("Frequency"), tr("x bandwidth")}, [](picture::EchoWindow& w, int index) {
        w.sampling.kind = static_cast<picture::Sampling::Kind>(index);
        if (w.sampling.kind != picture::Sampling::Kind::rate) return;
        if (w.sampling.rate_hz <= 0.0) w.sampling.rate_hz = w.recording.sample_rate_hz;
        if (w.sampling.rate_hz <= 0.0) w.sampling.rate_hz = 1e6;
        w.recording.sample_rate_hz = w.sampling.rate_hz;
      });
  const auto is_rate = [this] { return window_.sampling.kind == picture::Sampling::Kind::rate; };
  sampling_value_ = rows_.add_number(
      form,
      {tr("Rate"), "echo_sampling_value", tr("Sampling frequency, as 60 MHz, or how many times the bandwidth, as 1.2")},
      {[is_rate] { return is_rate() ? scene::Quantity::frequency : scene::Quantity::number; }, 0.0, any,
       tr("the sampling must be above zero")},
      [this, is_rate](double value) {
        change([&](picture::EchoWindow& w) {
          if (is_rate())
            w.sampling.rate_hz = w.recording.sample_rate_hz = value;
          else
            w.sampling.multiple = value;
        });
      });
  position_ = add_list(form,
                       {tr("Pulse position"), "echo_position",
                        tr("Which part of the echo is placed at the target's range: its leading edge or its centre")},
                       {tr("Begin"), tr("Centre")}, [](picture::EchoWindow& w, int index) {
                         w.recording.pulse_position = static_cast<scene::Simulation::PulsePosition>(index);
                       });
}

void EchoControls::make_view_group(QFormLayout* form) {
  const auto limit = [&](const FormRows::Words& words, double picture::EchoView::*end, scene::Quantity kind) {
    return rows_.add_number(form, words, {[kind] { return kind; }}, [this, end](double value) {
      picture::EchoView view = picture::view_of(window_);
      view.*end = value;
      emit view_typed(picture::mended(view));
    });
  };
  range_from_ = limit({tr("Slant range from"), "echo_range_from", tr("One way, as 9.5 km")},
                      &picture::EchoView::range_start_m, scene::Quantity::length);
  range_to_ = limit({tr("to"), "echo_range_to", tr("One way, as 10.5 km")}, &picture::EchoView::range_end_m,
                    scene::Quantity::length);
  time_from_ = limit({tr("Azimuth from"), "echo_time_from", tr("Time, as 0 s")}, &picture::EchoView::time_start_s,
                     scene::Quantity::time);
  time_to_ =
      limit({tr("to"), "echo_time_to", tr("Time, as 10 ms")}, &picture::EchoView::time_end_s, scene::Quantity::time);
  const auto link = [&](const QString& label, const char* name) {
    return rows_.add_mark(form, {label, name, tr("Windows with this mark move and zoom together along this axis")},
                          [this](bool) { emit link_changed(); });
  };
  link_range_ = link(tr("Range follows other windows"), "echo_link_range");
  link_time_ = link(tr("Azimuth follows other windows"), "echo_link_time");
}

void EchoControls::make_drawing_group(QFormLayout* form) {
  colours_.add_quantity(form);
  draw_as_ = add_list(
      form,
      {tr("Draw as"), "echo_draw_as", tr("Auto: curves where pulses are at least 20 pixels apart, colours elsewhere")},
      {tr("Colour pixels"), tr("Curve for each pulse"), tr("Curve for each range"), tr("Auto")},
      [](picture::EchoWindow& w, int index) { w.draw_as = static_cast<picture::DrawAs>(index); });
  placing_ = add_list(
      form,
      {tr("Between Pulses"), "echo_placing", tr("Rows between pulses: repeat the nearest pulse, or leave them empty")},
      {tr("Repeat Nearest"), tr("Leave Empty")},
      [](picture::EchoWindow& w, int index) { w.placing = static_cast<picture::RowPlacing>(index); });
  peak_ = rows_.add_mark(
      form,
      {tr("Peak of each pixel"), "echo_peak",
       tr("Where a pixel has many samples: the largest of them instead of one. Takes all of them to compute.")},
      [this](bool on) {
        change([on](picture::EchoWindow& w) {
          w.pixel_rule = on ? picture::PixelRule::peak : picture::PixelRule::sample;
        });
      });
}

void EchoControls::make_colour_group(QFormLayout* form) {
  colours_.add_palette(form);
  colours_.add_limits(form);
  make_reference_rows(form);
  colours_.add_span(form);
}

void EchoControls::make_reference_rows(QFormLayout* form) {
  reference_ = add_list(form, {tr("0 dB is"), "echo_reference", tr("0 dB Reference")},
                        {tr("the largest value"), tr("a voltage")}, [](picture::EchoWindow& w, int index) {
                          w.decibels.reference = static_cast<picture::Decibels::Reference>(index);
                        });
  reference_v_ = rows_.add_number(
      form, {tr("Voltage"), "echo_reference_v", tr("Magnitude of 0 dB, as 1 uV")},
      {[] { return scene::Quantity::voltage; }, 0.0, any, tr("enter a voltage above 0 V")},
      [this](double value) { change([value](picture::EchoWindow& w) { w.decibels.reference_v = value; }); });
}

picture::AxisLink EchoControls::link() const { return {link_range_->isChecked(), link_time_->isChecked()}; }

void EchoControls::show_window(const picture::EchoWindow& window, const scene::Scene& scene) {
  window_ = window;
  rows_.while_showing([&] {
    radar_->clear();
    for (const scene::Radar& radar : scene.radars) radar_->addItem(QString::fromStdString(radar.name));
    radar_->setCurrentText(QString::fromStdString(window.recording.radar));
    show_data();
    show_view();
  });
  colours_.show(window, scene::Quantity::voltage);
  show_rows();
}

void EchoControls::show_data() {
  const auto kind = std::ranges::find(data_kinds, window_.recording.processing);
  data_->setCurrentIndex(static_cast<int>(kind - data_kinds.begin()));
  sampling_->setCurrentIndex(static_cast<int>(window_.sampling.kind));
  if (window_.sampling.kind == picture::Sampling::Kind::rate)
    show_number(sampling_value_, window_.sampling.rate_hz, scene::Quantity::frequency);
  else
    show_number(sampling_value_, window_.sampling.multiple, scene::Quantity::number);
  position_->setCurrentIndex(static_cast<int>(window_.recording.pulse_position));
  peak_->setChecked(window_.pixel_rule == picture::PixelRule::peak);
  draw_as_->setCurrentIndex(static_cast<int>(window_.draw_as));
  placing_->setCurrentIndex(static_cast<int>(window_.placing));
  reference_->setCurrentIndex(static_cast<int>(window_.decibels.reference));
  show_number(reference_v_, window_.decibels.reference_v, scene::Quantity::voltage);
}

void EchoControls::show_view() {
  const picture::EchoView view = picture::view_of(window_);
  show_number(range_from_, core::rounded_to(view.range_start_m, shown_range_m), scene::Quantity::length);
  show_number(range_to_, core::rounded_to(view.range_end_m, shown_range_m), scene::Quantity::length);
  show_number(time_from_, core::rounded_to(view.time_start_s, shown_time_s), scene::Quantity::time);
  show_number(time_to_, core::rounded_to(view.time_end_s, shown_time_s), scene::Quantity::time);
}

// Only what has a say now.
void EchoControls::show_rows() {
  show_row(data_form_, sampling_value_, window_.sampling.kind != picture::Sampling::Kind::screen);
  const bool db = window_.quantity == picture::DisplayQuantity::decibels;
  show_row(colour_form_, reference_, db);
  show_row(colour_form_, reference_v_, db && window_.decibels.reference == picture::Decibels::Reference::volts);
}

}  // namespace sarsim::gui
