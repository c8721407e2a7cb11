#include "gui/echo_controls.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>

#include <cmath>

#include "base/number_text.hpp"
#include "gui/problem_line.hpp"
#include "view/quantity.hpp"

namespace sarsim {

namespace {

QString number_text(double value) { return QString::fromStdString(format_number(value)); }

// Limits that a mouse has drawn, to a millimetre or a nanosecond; a limit that is not typed anew keeps all its digits.
double rounded(double value, double to) { return std::isfinite(value) ? std::round(value / to) * to : value; }

QString unit_text(double value, Quantity quantity) { return QString::fromStdString(quantity_text(value, quantity)); }

void set_number(QLineEdit* edit, const QString& text) {
  if (edit->isModified() && edit->hasFocus()) return;  // What is being typed stays.
  edit->setText(text);
  edit->setCursorPosition(0);
  edit->setModified(false);
}

// Colours that do not mislead: a middle for signed numbers, no end for angles.
ColourMap map_for(ColourMapKind kind) {
  if (kind == ColourMapKind::diverging) return ColourMap::balance_dark;
  return kind == ColourMapKind::cyclic ? ColourMap::cycle : ColourMap::ocean;
}

void show_row(QFormLayout* form, QWidget* field, bool shown) {
  field->setVisible(shown);
  if (QWidget* label = form->labelForField(field)) label->setVisible(shown);
}

}  // namespace

EchoControls::EchoControls(QWidget* parent) : QWidget(parent) {
  setObjectName("echo_controls");
  auto* const layout = new QVBoxLayout(this);
  const auto group = [&](const QString& title) {
    auto* const box = new QGroupBox(title, this);
    auto* const form = new QFormLayout(box);
    form->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
    layout->addWidget(box);
    return form;
  };
  problem_ = new ProblemLine(this);
  problem_->setObjectName("echo_problem");
  make_data_group(data_form_ = group(tr("Data")));
  make_view_group(group(tr("Window")));
  make_drawing_group(drawing_ = group(tr("Drawing")));
  make_colour_group(colour_form_ = group(tr("Colours")));
  layout->addWidget(problem_);
  layout->addStretch(1);
}

void EchoControls::change(const std::function<void(EchoWindow&)>& apply) {
  if (showing_) return;
  EchoWindow changed = window_;
  apply(changed);
  problem_->clear();
  if (changed == window_) return;
  window_ = changed;
  show_rows();
  emit edited(window_);
}

QComboBox* EchoControls::add_choice(QFormLayout* form, const QString& label, const char* name, const QString& tip,
                                    const std::function<void(EchoWindow&, int)>& apply) {
  auto* const box = new QComboBox(this);
  box->setObjectName(name);
  box->setToolTip(tip);
  box->setAccessibleName(label);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(12);
  form->addRow(label, box);
  connect(box, &QComboBox::activated, this,
          [this, apply](int index) { change([&](EchoWindow& w) { apply(w, index); }); });
  return box;
}

QLineEdit* EchoControls::add_text(QFormLayout* form, const QString& label, const char* name, const QString& tip,
                                  const std::function<QString(const QString&)>& apply) {
  auto* const edit = new QLineEdit(this);
  edit->setObjectName(name);
  edit->setToolTip(tip);
  edit->setAccessibleName(label);
  form->addRow(label, edit);
  connect(edit, &QLineEdit::editingFinished, this, [this, edit, apply] {
    if (!edit->isModified()) return;
    const QString failure = apply(edit->text());
    edit->setModified(!failure.isEmpty());
    if (failure.isEmpty())
      problem_->clear();
    else
      problem_->show_texts(Severity::error, {failure});
  });
  return edit;
}

QSlider* EchoControls::add_slider(QFormLayout* form, const QString& label, const char* name,
                                  const std::function<void(EchoWindow&, double)>& apply) {
  auto* const slider = new QSlider(Qt::Horizontal, this);
  slider->setObjectName(name);
  slider->setRange(0, 255);
  slider->setAccessibleName(label);
  slider->setToolTip(tr("0 to 255; the middle is how the original began"));
  form->addRow(label, slider);
  connect(slider, &QSlider::valueChanged, this,
          [this, apply](int value) { change([&](EchoWindow& w) { apply(w, value); }); });
  return slider;
}

void EchoControls::make_data_group(QFormLayout* form) {
  radar_ = add_choice(form, tr("Radar"), "echo_radar", tr("Whose echoes are shown"),
                      [this](EchoWindow& w, int) { w.recording.radar = radar_->currentText().toStdString(); });
  data_ = add_choice(form, tr("Data"), "echo_data",
                     tr("What the A/D converter delivers, or what the matched filter makes of it"),
                     [](EchoWindow& w, int index) {
                       w.recording.processing = index == 0   ? Processing::raw
                                                : index == 1 ? Processing::matched_filter
                                                             : Processing::srp;
                       if (index > 0 && w.sampling.kind == Sampling::Kind::screen)
                         w.sampling = {Sampling::Kind::multiple, 0.0, 1.0};
                     });
  data_->addItems({tr("Raw return"), tr("Range compressed"), tr("Synthetic range profiles")});
  sampling_ = add_choice(form, tr("Sampling"), "echo_sampling",
                         tr("One sample for each pixel, a frequency, or a multiple of the bandwidth"),
                         [](EchoWindow& w, int index) {
                           w.sampling.kind = static_cast<Sampling::Kind>(index);
                           if (w.sampling.kind == Sampling::Kind::rate) {
                             if (w.sampling.rate_hz <= 0.0) w.sampling.rate_hz = w.recording.sample_rate_hz;
                             if (w.sampling.rate_hz <= 0.0) w.sampling.rate_hz = 1e6;
                             w.recording.sample_rate_hz = w.sampling.rate_hz;
                           }
                         });
  sampling_->addItems({tr("Screen"), tr("Frequency"), tr("x bandwidth")});
  sampling_value_ = add_text(form, tr("Rate"), "echo_sampling_value",
                             tr("Sampling frequency, as 60 MHz, or how many times the bandwidth, as 1.2"),
                             [this](const QString& text) { return take_sampling(text); });
  position_ = add_choice(
      form, tr("Pulse position"), "echo_position",
      tr("Where a target's range is in its echo: at the beginning of the pulse or at its centre"),
      [](EchoWindow& w, int index) { w.recording.pulse_position = static_cast<Simulation::PulsePosition>(index); });
  position_->addItems({tr("Begin"), tr("Centre")});
}

void EchoControls::make_view_group(QFormLayout* form) {
  const auto limit = [&](const QString& label, const char* name, const QString& tip, double EchoView::*end,
                         bool range) {
    return add_text(form, label, name, tip,
                    [this, end, range](const QString& text) { return take_view(text, end, range); });
  };
  range_from_ =
      limit(tr("Slant range from"), "echo_range_from", tr("One way, as 9.5 km"), &EchoView::range_start_m, true);
  range_to_ = limit(tr("to"), "echo_range_to", tr("One way, as 10.5 km"), &EchoView::range_end_m, true);
  time_from_ = limit(tr("Azimuth from"), "echo_time_from", tr("Time, as 0 s"), &EchoView::time_start_s, false);
  time_to_ = limit(tr("to"), "echo_time_to", tr("Time, as 10 ms"), &EchoView::time_end_s, false);
  link_range_ = new QCheckBox(tr("Range follows other windows"), this);
  link_range_->setObjectName("echo_link_range");
  link_time_ = new QCheckBox(tr("Azimuth follows other windows"), this);
  link_time_->setObjectName("echo_link_time");
  for (QCheckBox* box : {link_range_, link_time_}) {
    box->setToolTip(tr("Windows with this mark move and zoom together along this axis"));
    form->addRow(box);
    connect(box, &QCheckBox::toggled, this, &EchoControls::link_changed);
  }
}

void EchoControls::make_drawing_group(QFormLayout* form) {
  quantity_ = add_choice(form, tr("Show"), "echo_quantity", tr("What of the complex samples is shown"),
                         [](EchoWindow& w, int index) {
                           const auto before = kind_for(w.quantity);
                           w.quantity = static_cast<DisplayQuantity>(index);
                           // A map that misleads about the new quantity gives way; limits of another unit do so too.
                           if (kind_for(w.quantity) != before && !info_of(w.map).classic)
                             w.map = map_for(kind_for(w.quantity));
                           w.limits.kind = LimitRule::Kind::automatic;
                         });
  for (const auto q : {DisplayQuantity::real, DisplayQuantity::imaginary, DisplayQuantity::magnitude,
                       DisplayQuantity::phase, DisplayQuantity::decibels})
    quantity_->addItem(QString::fromUtf8(title_of(q).data(), static_cast<qsizetype>(title_of(q).size())));
  draw_as_ = add_choice(form, tr("Draw as"), "echo_draw_as",
                        tr("Auto: curves where pulses are at least 20 pixels apart, colours elsewhere"),
                        [](EchoWindow& w, int index) { w.draw_as = static_cast<DrawAs>(index); });
  draw_as_->addItems({tr("Colour pixels"), tr("Curve for each pulse"), tr("Curve for each range"), tr("Auto")});
  placing_ = add_choice(form, tr("Few pulses"), "echo_placing",
                        tr("Where there are fewer pulses than rows: the nearest pulse fills them, or they stay empty"),
                        [](EchoWindow& w, int index) { w.placing = static_cast<RowPlacing>(index); });
  placing_->addItems({tr("Nearest pulse"), tr("Own row only")});
  peak_ = new QCheckBox(tr("Peak of each pixel"), this);
  peak_->setObjectName("echo_peak");
  peak_->setToolTip(
      tr("Where a pixel has many samples: the largest of them instead of one. Takes all of them to compute."));
  form->addRow(peak_);
  connect(peak_, &QCheckBox::toggled, this,
          [this](bool on) { change([&](EchoWindow& w) { w.pixel_rule = on ? PixelRule::peak : PixelRule::sample; }); });
}

void EchoControls::make_colour_group(QFormLayout* form) {
  map_ = add_choice(form, tr("Colours"), "echo_map", tr("All but the classic palettes are even steps for every eye"),
                    [](EchoWindow& w, int index) { w.map = colour_maps()[static_cast<std::size_t>(index)].map; });
  for (const ColourMapInfo& info : colour_maps())
    map_->addItem(QString::fromUtf8(info.title.data(), static_cast<qsizetype>(info.title.size())));
  inverted_ = new QCheckBox(tr("Inverted"), this);
  inverted_->setObjectName("echo_inverted");
  inverted_->setToolTip(tr("The colours in the opposite order"));
  form->addRow(inverted_);
  connect(inverted_, &QCheckBox::toggled, this, [this](bool on) { change([&](EchoWindow& w) { w.inverted = on; }); });
  brightness_ =
      add_slider(form, tr("Brightness"), "echo_brightness", [](EchoWindow& w, double v) { w.sliders.brightness = v; });
  contrast_ =
      add_slider(form, tr("Contrast"), "echo_contrast", [](EchoWindow& w, double v) { w.sliders.contrast = v; });
  saturation_ =
      add_slider(form, tr("Saturation"), "echo_saturation", [](EchoWindow& w, double v) { w.sliders.saturation = v; });
  limits_ = add_choice(form, tr("Limits"), "echo_limits", tr("Values of the first and the last colour"),
                       [](EchoWindow& w, int index) { w.limits.kind = static_cast<LimitRule::Kind>(index); });
  limits_->addItems({tr("Automatic"), tr("Smallest to largest"), tr("Set by hand")});
  percentile_ = add_text(form, tr("Percentile"), "echo_percentile",
                         tr("Share of the samples within the limits; below 100 a few strong ones do not hide the rest"),
                         [this](const QString& text) {
                           const QuantityReading read = read_quantity(text.toStdString(), Quantity::number);
                           if (!read.value) return QString::fromStdString(read.failure);
                           if (*read.value <= 0.0 || *read.value > 100.0)
                             return tr("a percentile is above 0 and at most 100");
                           change([&](EchoWindow& w) { w.limits.percentile = *read.value; });
                           return QString();
                         });
  low_ = add_text(form, tr("from"), "echo_low", tr("Value of the first colour"),
                  [this](const QString& text) { return take_limit(text, &LimitRule::low); });
  high_ = add_text(form, tr("to"), "echo_high", tr("Value of the last colour"),
                   [this](const QString& text) { return take_limit(text, &LimitRule::high); });
  reference_ =
      add_choice(form, tr("0 dB is"), "echo_reference", tr("What decibels count from"),
                 [](EchoWindow& w, int index) { w.decibels.reference = static_cast<Decibels::Reference>(index); });
  reference_->addItems({tr("the largest magnitude"), tr("a voltage")});
  reference_v_ =
      add_text(form, tr("Voltage"), "echo_reference_v", tr("Magnitude of 0 dB, as 1 uV"), [this](const QString& text) {
        const QuantityReading read = read_quantity(text.toStdString(), Quantity::voltage);
        if (!read.value) return QString::fromStdString(read.failure);
        if (*read.value <= 0.0) return tr("the reference of decibels is above 0 V");
        change([&](EchoWindow& w) { w.decibels.reference_v = *read.value; });
        return QString();
      });
  floor_ = add_text(form, tr("Span"), "echo_floor", tr("Decibels from the strongest to the weakest colour"),
                    [this](const QString& text) {
                      const QuantityReading read = read_quantity(text.toStdString(), Quantity::ratio_db);
                      if (!read.value) return QString::fromStdString(read.failure);
                      if (*read.value <= 0.0 || *read.value > 400.0)
                        return tr("the span is above 0 dB and at most 400 dB");
                      change([&](EchoWindow& w) { w.decibels.range_db = *read.value; });
                      return QString();
                    });
}

QString EchoControls::take_sampling(const QString& text) {
  const bool rate = window_.sampling.kind == Sampling::Kind::rate;
  const QuantityReading read = read_quantity(text.toStdString(), rate ? Quantity::frequency : Quantity::number);
  if (!read.value) return QString::fromStdString(read.failure);
  if (*read.value <= 0.0) return tr("the sampling is above zero");
  change([&](EchoWindow& w) {
    if (rate)
      w.sampling.rate_hz = w.recording.sample_rate_hz = *read.value;
    else
      w.sampling.multiple = *read.value;
  });
  return {};
}

QString EchoControls::take_limit(const QString& text, double LimitRule::*end) {
  const bool db = window_.quantity == DisplayQuantity::decibels;
  const QuantityReading read = read_quantity(text.toStdString(), db ? Quantity::ratio_db : Quantity::voltage);
  if (!read.value) return QString::fromStdString(read.failure);
  change([&](EchoWindow& w) { w.limits.*end = *read.value; });
  return {};
}

QString EchoControls::take_view(const QString& text, double EchoView::*end, bool is_range) {
  const QuantityReading read = read_quantity(text.toStdString(), is_range ? Quantity::length : Quantity::time);
  if (!read.value) return QString::fromStdString(read.failure);
  EchoView view = view_of(window_);
  view.*end = *read.value;
  emit view_typed(mended(view));
  return {};
}

AxisLink EchoControls::link() const { return {link_range_->isChecked(), link_time_->isChecked()}; }

void EchoControls::show_window(const EchoWindow& window, const Scene& scene) {
  showing_ = true;
  window_ = window;
  radar_->clear();
  for (const Radar& radar : scene.radars) radar_->addItem(QString::fromStdString(radar.name));
  radar_->setCurrentText(QString::fromStdString(window.recording.radar));
  data_->setCurrentIndex(window.recording.processing == Processing::raw              ? 0
                         : window.recording.processing == Processing::matched_filter ? 1
                                                                                     : 2);
  sampling_->setCurrentIndex(static_cast<int>(window.sampling.kind));
  set_number(sampling_value_, window.sampling.kind == Sampling::Kind::rate
                                  ? unit_text(window.sampling.rate_hz, Quantity::frequency)
                                  : number_text(window.sampling.multiple));
  position_->setCurrentIndex(static_cast<int>(window.recording.pulse_position));
  peak_->setChecked(window.pixel_rule == PixelRule::peak);
  quantity_->setCurrentIndex(static_cast<int>(window.quantity));
  draw_as_->setCurrentIndex(static_cast<int>(window.draw_as));
  placing_->setCurrentIndex(static_cast<int>(window.placing));
  const auto maps = colour_maps();
  for (std::size_t i = 0; i < maps.size(); ++i)
    if (maps[i].map == window.map) map_->setCurrentIndex(static_cast<int>(i));
  inverted_->setChecked(window.inverted);
  brightness_->setValue(static_cast<int>(window.sliders.brightness));
  contrast_->setValue(static_cast<int>(window.sliders.contrast));
  saturation_->setValue(static_cast<int>(window.sliders.saturation));
  limits_->setCurrentIndex(static_cast<int>(window.limits.kind));
  const Quantity unit = window.quantity == DisplayQuantity::decibels ? Quantity::ratio_db : Quantity::voltage;
  set_number(low_, unit_text(window.limits.low, unit));
  set_number(high_, unit_text(window.limits.high, unit));
  set_number(percentile_, number_text(window.limits.percentile));
  reference_->setCurrentIndex(static_cast<int>(window.decibels.reference));
  set_number(reference_v_, unit_text(window.decibels.reference_v, Quantity::voltage));
  set_number(floor_, unit_text(window.decibels.range_db, Quantity::ratio_db));
  const EchoView view = view_of(window);
  set_number(range_from_, unit_text(rounded(view.range_start_m, 1e-3), Quantity::length));
  set_number(range_to_, unit_text(rounded(view.range_end_m, 1e-3), Quantity::length));
  set_number(time_from_, unit_text(rounded(view.time_start_s, 1e-9), Quantity::time));
  set_number(time_to_, unit_text(rounded(view.time_end_s, 1e-9), Quantity::time));
  show_rows();
  showing_ = false;
}

// Only what has a say now.
void EchoControls::show_rows() {
  show_row(data_form_, sampling_value_, window_.sampling.kind != Sampling::Kind::screen);
  const bool phase = window_.quantity == DisplayQuantity::phase;
  const bool db = window_.quantity == DisplayQuantity::decibels;
  const bool by_hand = window_.limits.kind == LimitRule::Kind::manual && !phase;
  for (QSlider* slider : {brightness_, contrast_, saturation_})
    show_row(colour_form_, slider, info_of(window_.map).classic);
  show_row(colour_form_, limits_, !phase);
  show_row(colour_form_, low_, by_hand);
  show_row(colour_form_, high_, by_hand);
  show_row(colour_form_, percentile_, window_.limits.kind == LimitRule::Kind::automatic && !phase);
  show_row(colour_form_, reference_, db);
  show_row(colour_form_, reference_v_, db && window_.decibels.reference == Decibels::Reference::volts);
  show_row(colour_form_, floor_, db && window_.limits.kind == LimitRule::Kind::automatic);
}

}  // namespace sarsim
