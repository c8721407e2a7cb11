#include "gui/common/colour_rows.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QSlider>

#include <utility>

#include "core/maths/rounding.hpp"
#include "gui/common/text.hpp"

namespace sarsim::gui {

namespace {

// Colours that do not mislead: a middle for signed numbers, no end for angles.
picture::ColourMap map_for(picture::ColourMapKind kind) {
  if (kind == picture::ColourMapKind::diverging) return picture::ColourMap::balance_dark;
  return kind == picture::ColourMapKind::cyclic ? picture::ColourMap::cycle : picture::ColourMap::ocean;
}

}  // namespace

ColourRows::ColourRows(FormRows& rows, QString prefix, QObject* parent)
    : QObject(parent), rows_(rows), prefix_(std::move(prefix)) {}

FormRows::Words ColourRows::words(const QString& label, const char* name, const QString& tip) const {
  return {label, prefix_ + name, tip};
}

void ColourRows::change(const std::function<void(picture::ColourLook&)>& apply) {
  picture::ColourLook changed = look_;
  apply(changed);
  if (changed == look_) return;
  look_ = changed;
  show_rows();
  emit chosen(look_);
}

QComboBox* ColourRows::add_quantity(QFormLayout* form) {
  quantity_ =
      rows_.add_choice(form, words(tr("Show"), "quantity", tr("What of the samples is shown")), [this](int index) {
        change([index](picture::ColourLook& look) {
          const picture::ColourMapKind before = picture::kind_for(look.quantity);
          look.quantity = static_cast<picture::DisplayQuantity>(index);
          // A map that misleads about the new quantity gives way; limits of another unit do so too.
          if (picture::kind_for(look.quantity) != before && !picture::info_of(look.map).classic)
            look.map = map_for(picture::kind_for(look.quantity));
          look.limits.kind = picture::LimitRule::Kind::automatic;
        });
      });
  for (const auto quantity :
       {picture::DisplayQuantity::real, picture::DisplayQuantity::imaginary, picture::DisplayQuantity::magnitude,
        picture::DisplayQuantity::phase, picture::DisplayQuantity::decibels})
    quantity_->addItem(text_of(picture::title_of(quantity)));
  return quantity_;
}

void ColourRows::add_palette(QFormLayout* form) {
  palette_form_ = form;
  map_ =
      rows_.add_choice(form, words(tr("Colours"), "map", tr("All but the classic palettes are perceptually uniform")),
                       [this](int index) {
                         change([index](picture::ColourLook& look) {
                           look.map = picture::colour_maps()[static_cast<std::size_t>(index)].map;
                         });
                       });
  for (const picture::ColourMapInfo& info : picture::colour_maps()) map_->addItem(text_of(info.title));
  inverted_ = rows_.add_mark(form, words(tr("Inverted"), "inverted", tr("The colours in the opposite order")),
                             [this](bool on) { change([on](picture::ColourLook& look) { look.inverted = on; }); });
  const auto slider = [&](const QString& label, const char* name, double picture::ClassicSliders::*place) {
    return rows_.add_slider(form, label, prefix_ + name, [this, place](int value) {
      change([&](picture::ColourLook& look) { look.sliders.*place = value; });
    });
  };
  brightness_ = slider(tr("Brightness"), "brightness", &picture::ClassicSliders::brightness);
  contrast_ = slider(tr("Contrast"), "contrast", &picture::ClassicSliders::contrast);
  saturation_ = slider(tr("Saturation"), "saturation", &picture::ClassicSliders::saturation);
}

QLineEdit* ColourRows::add_limit(QFormLayout* form, const Words& words, double picture::LimitRule::*end) {
  return rows_.add_number(form, words, {[this] { return shown_kind(); }}, [this, end](double value) {
    change([&](picture::ColourLook& look) { look.limits.*end = value; });
  });
}

void ColourRows::add_limits(QFormLayout* form) {
  limits_form_ = form;
  limits_ = rows_.add_choice(form, words(tr("Limits"), "limits", tr("Values of the first and the last colour")),
                             [this](int index) {
                               change([&](picture::ColourLook& look) {
                                 const auto kind = static_cast<picture::LimitRule::Kind>(index);
                                 if (kind == picture::LimitRule::Kind::manual && look.limits.kind != kind && present_) {
                                   look.limits.low = present_->low;
                                   look.limits.high = present_->high;
                                 }
                                 look.limits.kind = kind;
                               });
                             });
  limits_->addItems({tr("Automatic"), tr("Smallest to largest"), tr("Set by hand")});
  percentile_ = rows_.add_number(
      form,
      words(tr("Percentile"), "percentile",
            tr("Share of the samples within the limits; below 100 a few strong ones do not hide the rest")),
      {[] { return scene::Quantity::number; }, 0.0, 100.0, tr("enter a percentile above 0, at most 100")},
      [this](double value) { change([value](picture::ColourLook& look) { look.limits.percentile = value; }); });
  low_ = add_limit(form, words(tr("from"), "low", tr("Value of the first colour")), &picture::LimitRule::low);
  high_ = add_limit(form, words(tr("to"), "high", tr("Value of the last colour")), &picture::LimitRule::high);
}

void ColourRows::add_span(QFormLayout* form) {
  span_form_ = form;
  span_ = rows_.add_number(
      form, words(tr("Span"), "floor", tr("Decibels from the strongest to the weakest colour")),
      {[] { return scene::Quantity::ratio_db; }, 0.0, 400.0, tr("enter a span above 0 dB, at most 400 dB")},
      [this](double value) { change([value](picture::ColourLook& look) { look.decibels.range_db = value; }); });
}

void ColourRows::set_present_limits(const picture::ColourLimits& limits) {
  constexpr int digits = 6;
  present_ = {core::tidy(limits.low, digits), core::tidy(limits.high, digits)};
}

scene::Quantity ColourRows::shown_kind() const {
  return look_.quantity == picture::DisplayQuantity::decibels ? scene::Quantity::ratio_db : values_;
}

void ColourRows::show(const picture::ColourLook& look, scene::Quantity values, bool meaningful) {
  look_ = look;
  values_ = values;
  meaningful_ = meaningful;
  rows_.while_showing([&] {
    quantity_->setCurrentIndex(static_cast<int>(look.quantity));
    const auto maps = picture::colour_maps();
    for (std::size_t i = 0; i < maps.size(); ++i)
      if (maps[i].map == look.map) map_->setCurrentIndex(static_cast<int>(i));
    inverted_->setChecked(look.inverted);
    brightness_->setValue(static_cast<int>(look.sliders.brightness));
    contrast_->setValue(static_cast<int>(look.sliders.contrast));
    saturation_->setValue(static_cast<int>(look.sliders.saturation));
    limits_->setCurrentIndex(static_cast<int>(look.limits.kind));
    show_number(percentile_, look.limits.percentile, scene::Quantity::number);
    show_number(low_, look.limits.low, shown_kind());
    show_number(high_, look.limits.high, shown_kind());
    show_number(span_, look.decibels.range_db, scene::Quantity::ratio_db);
  });
  show_rows();
}

void ColourRows::show_rows() {
  const bool phase = look_.quantity == picture::DisplayQuantity::phase;
  const bool db = look_.quantity == picture::DisplayQuantity::decibels;
  const bool automatic = look_.limits.kind == picture::LimitRule::Kind::automatic;
  const bool limits = meaningful_ && !phase;
  const bool by_hand = limits && look_.limits.kind == picture::LimitRule::Kind::manual;
  for (QWidget* field : std::initializer_list<QWidget*>{quantity_, map_, inverted_}) field->setEnabled(meaningful_);
  for (QSlider* slider : {brightness_, contrast_, saturation_})
    show_row(palette_form_, slider, meaningful_ && picture::info_of(look_.map).classic);
  show_row(limits_form_, limits_, limits);
  show_row(limits_form_, low_, by_hand);
  show_row(limits_form_, high_, by_hand);
  show_row(limits_form_, percentile_, limits && automatic);
  show_row(span_form_, span_, meaningful_ && db && automatic);
}

}  // namespace sarsim::gui
