#include "gui/image_controls.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QLineEdit>
#include <QSlider>
#include <QStandardItemModel>
#include <QVBoxLayout>

#include "gui/problem_line.hpp"

namespace sarsim {

namespace {

QString text_of(std::string_view text) { return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size())); }

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

ImageControls::ImageControls(QWidget* parent) : QWidget(parent) {
  setObjectName("image_controls");
  auto* const layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  const auto group = [&](const QString& title) {
    auto* const box = new QGroupBox(title, this);
    auto* const form = new QFormLayout(box);
    form->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
    layout->addWidget(box);
    return form;
  };
  problem_ = new ProblemLine(this);
  problem_->setObjectName("image_problem");
  form_ = group(tr("Colours"));
  make_colours(form_);
  make_limits(form_);
  make_links(group(tr("Other viewers")));
  layout->addWidget(problem_);
  show_look({}, ImageValue::complex, {});
}

void ImageControls::change(const std::function<void(ImageLook&)>& apply) {
  if (showing_) return;
  ImageLook changed = look_;
  apply(changed);
  problem_->clear();
  if (changed == look_) return;
  show_look(changed, value_, unit_);
  emit edited(look_);
}

QComboBox* ImageControls::add_choice(QFormLayout* form, const QString& label, const char* name, const QString& tip,
                                     const std::function<void(ImageLook&, int)>& apply) {
  auto* const box = new QComboBox(this);
  box->setObjectName(name);
  box->setToolTip(tip);
  box->setAccessibleName(label);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(12);
  form->addRow(label, box);
  connect(box, &QComboBox::activated, this,
          [this, apply](int index) { change([&](ImageLook& look) { apply(look, index); }); });
  return box;
}

QLineEdit* ImageControls::add_number(QFormLayout* form, const QString& label, const char* name, const QString& tip,
                                     const std::function<QString(double)>& apply, std::function<Quantity()> kind) {
  auto* const edit = new QLineEdit(this);
  edit->setObjectName(name);
  edit->setToolTip(tip);
  edit->setAccessibleName(label);
  form->addRow(label, edit);
  connect(edit, &QLineEdit::editingFinished, this, [this, edit, apply, kind = std::move(kind)] {
    if (!edit->isModified()) return;
    const QuantityReading read = read_quantity(edit->text().toStdString(), kind());
    const QString failure = read.value ? apply(*read.value) : QString::fromStdString(read.failure);
    edit->setModified(!failure.isEmpty());
    if (failure.isEmpty())
      problem_->clear();
    else
      problem_->show_texts(Severity::error, {failure});
  });
  return edit;
}

QSlider* ImageControls::add_slider(QFormLayout* form, const QString& label, const char* name,
                                   double ClassicSliders::*slider) {
  auto* const made = new QSlider(Qt::Horizontal, this);
  made->setObjectName(name);
  made->setRange(0, 255);
  made->setAccessibleName(label);
  made->setToolTip(tr("0 to 255; the middle is how the original began"));
  form->addRow(label, made);
  connect(made, &QSlider::valueChanged, this,
          [this, slider](int value) { change([&](ImageLook& look) { look.sliders.*slider = value; }); });
  return made;
}

void ImageControls::make_colours(QFormLayout* form) {
  quantity_ = add_choice(form, tr("Show"), "image_quantity", tr("What of the samples is shown"),
                         [](ImageLook& look, int index) {
                           const auto before = kind_for(look.quantity);
                           look.quantity = static_cast<DisplayQuantity>(index);
                           // A map that misleads about the new quantity gives way; limits of another unit do so too.
                           if (kind_for(look.quantity) != before && !info_of(look.map).classic)
                             look.map = map_for(kind_for(look.quantity));
                           look.limits.kind = LimitRule::Kind::automatic;
                         });
  for (const auto quantity : {DisplayQuantity::real, DisplayQuantity::imaginary, DisplayQuantity::magnitude,
                              DisplayQuantity::phase, DisplayQuantity::decibels})
    quantity_->addItem(text_of(title_of(quantity)));
  peak_ = new QCheckBox(tr("Peak of each pixel"), this);
  peak_->setObjectName("image_peak");
  peak_->setToolTip(
      tr("Where a pixel has many samples: the largest magnitude of them instead of one. Takes all of them to read."));
  form->addRow(peak_);
  connect(peak_, &QCheckBox::toggled, this, [this](bool on) { change([&](ImageLook& look) { look.peak = on; }); });
  map_ = add_choice(form, tr("Colours"), "image_map", tr("All but the classic palettes are even steps for every eye"),
                    [](ImageLook& look, int index) { look.map = colour_maps()[static_cast<std::size_t>(index)].map; });
  for (const ColourMapInfo& info : colour_maps()) map_->addItem(text_of(info.title));
  inverted_ = new QCheckBox(tr("Inverted"), this);
  inverted_->setObjectName("image_inverted");
  inverted_->setToolTip(tr("The colours in the opposite order"));
  form->addRow(inverted_);
  connect(inverted_, &QCheckBox::toggled, this,
          [this](bool on) { change([&](ImageLook& look) { look.inverted = on; }); });
  brightness_ = add_slider(form, tr("Brightness"), "image_brightness", &ClassicSliders::brightness);
  contrast_ = add_slider(form, tr("Contrast"), "image_contrast", &ClassicSliders::contrast);
  saturation_ = add_slider(form, tr("Saturation"), "image_saturation", &ClassicSliders::saturation);
}

void ImageControls::make_limits(QFormLayout* form) {
  limits_ = add_choice(form, tr("Limits"), "image_limits",
                       tr("Values of the first and the last colour, from the samples in view"),
                       [this](ImageLook& look, int index) {
                         const auto kind = static_cast<LimitRule::Kind>(index);
                         if (kind == LimitRule::Kind::manual && look.limits.kind != kind) {
                           look.limits.low = present_.low;
                           look.limits.high = present_.high;
                         }
                         look.limits.kind = kind;
                       });
  limits_->addItems({tr("Automatic"), tr("Smallest to largest"), tr("Set by hand")});
  percentile_ = add_number(
      form, tr("Percentile"), "image_percentile",
      tr("Share of the samples within the limits; below 100 a few strong ones do not hide the rest"),
      [this](double value) {
        if (value <= 0.0 || value > 100.0) return tr("a percentile is above 0 and at most 100");
        change([&](ImageLook& look) { look.limits.percentile = value; });
        return QString();
      },
      [] { return Quantity::number; });
  const auto limit = [&](const QString& label, const char* name, const QString& tip, double LimitRule::*end) {
    return add_number(
        form, label, name, tip,
        [this, end](double value) {
          change([&](ImageLook& look) { look.limits.*end = value; });
          return QString();
        },
        [this] { return value_kind(); });
  };
  low_ = limit(tr("from"), "image_low", tr("Value of the first colour"), &LimitRule::low);
  high_ = limit(tr("to"), "image_high", tr("Value of the last colour"), &LimitRule::high);
  floor_ = add_number(
      form, tr("Span"), "image_floor", tr("Decibels from the strongest to the weakest colour"),
      [this](double value) {
        if (value <= 0.0 || value > 400.0) return tr("the span is above 0 dB and at most 400 dB");
        change([&](ImageLook& look) { look.decibels.range_db = value; });
        return QString();
      },
      [] { return Quantity::ratio_db; });
}

void ImageControls::make_links(QFormLayout* form) {
  link_columns_ = new QCheckBox(tr("Samples follow"), this);
  link_columns_->setObjectName("image_link_columns");
  link_rows_ = new QCheckBox(tr("Rows follow"), this);
  link_rows_->setObjectName("image_link_rows");
  for (QCheckBox* box : {link_columns_, link_rows_}) {
    box->setToolTip(tr("Viewers with this mark move and zoom together along this axis"));
    form->addRow(box);
    connect(box, &QCheckBox::toggled, this, &ImageControls::link_changed);
  }
}

AxisLink ImageControls::link() const { return {link_columns_->isChecked(), link_rows_->isChecked()}; }

Quantity ImageControls::value_kind() const {
  if (look_.quantity == DisplayQuantity::decibels) return Quantity::ratio_db;
  return unit_ == "V" ? Quantity::voltage : Quantity::number;
}

void ImageControls::show_look(const ImageLook& look, ImageValue value, const QString& unit) {
  showing_ = true;
  look_ = look;
  value_ = value;
  unit_ = unit;
  quantity_->setCurrentIndex(static_cast<int>(look.quantity));
  if (auto* const items = qobject_cast<QStandardItemModel*>(quantity_->model()))
    for (int i = 0; i < quantity_->count(); ++i)
      items->item(i)->setEnabled(has_quantity(value, static_cast<DisplayQuantity>(i)));
  peak_->setChecked(look.peak);
  const auto maps = colour_maps();
  for (std::size_t i = 0; i < maps.size(); ++i)
    if (maps[i].map == look.map) map_->setCurrentIndex(static_cast<int>(i));
  inverted_->setChecked(look.inverted);
  brightness_->setValue(static_cast<int>(look.sliders.brightness));
  contrast_->setValue(static_cast<int>(look.sliders.contrast));
  saturation_->setValue(static_cast<int>(look.sliders.saturation));
  limits_->setCurrentIndex(static_cast<int>(look.limits.kind));
  const auto text = [](double number, Quantity kind) { return QString::fromStdString(quantity_text(number, kind)); };
  set_number(percentile_, text(look.limits.percentile, Quantity::number));
  set_number(low_, text(look.limits.low, value_kind()));
  set_number(high_, text(look.limits.high, value_kind()));
  set_number(floor_, text(look.decibels.range_db, Quantity::ratio_db));
  show_rows();
  showing_ = false;
}

// Only what has a say now.
void ImageControls::show_rows() {
  const bool colours = value_ == ImageValue::rgb;
  const bool phase = look_.quantity == DisplayQuantity::phase;
  const bool db = look_.quantity == DisplayQuantity::decibels;
  const bool automatic = look_.limits.kind == LimitRule::Kind::automatic;
  const bool by_hand = look_.limits.kind == LimitRule::Kind::manual && !phase;
  for (QWidget* field :
       {static_cast<QWidget*>(quantity_), static_cast<QWidget*>(map_), static_cast<QWidget*>(inverted_)})
    field->setEnabled(!colours);
  show_row(form_, peak_, !colours && (db || look_.quantity == DisplayQuantity::magnitude));
  for (QSlider* slider : {brightness_, contrast_, saturation_})
    show_row(form_, slider, info_of(look_.map).classic && !colours);
  show_row(form_, limits_, !phase && !colours);
  show_row(form_, low_, by_hand && !colours);
  show_row(form_, high_, by_hand && !colours);
  show_row(form_, percentile_, automatic && !phase && !colours);
  show_row(form_, floor_, db && automatic && !colours);
}

}  // namespace sarsim
