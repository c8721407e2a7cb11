#include "gui/image/image_controls.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QStandardItemModel>
#include <QVBoxLayout>

#include <cmath>
#include <utility>

#include "core/maths/rounding.hpp"
#include "gui/common/problem_line.hpp"
#include "picture/figure/ticks.hpp"

namespace sarsim::gui {

ImageControls::ImageControls(QWidget* parent)
    : QWidget(parent),
      problem_(new ProblemLine(this)),
      rows_(*this, *problem_),
      colours_(rows_, QStringLiteral("image_"), this) {
  setObjectName("image_controls");
  problem_->setObjectName("image_problem");
  auto* const layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  form_ = add_form_group(layout, tr("Colours"));
  quantity_ = colours_.add_quantity(form_);
  draw_as_ = rows_.add_choice(
      form_,
      {tr("Draw as"), "image_draw_as",
       tr("Colours, or curves through the samples: one for each row (slices in Y) or column (slices in X), at least 20 "
          "pixels apart")},
      [this](int index) { change([index](PartLook& look) { look.draw_as = static_cast<picture::DrawAs>(index); }); });
  draw_as_->addItems({tr("Colour pixels"), tr("Row curves"), tr("Column curves")});
  peak_ = rows_.add_mark(form_,
                         {tr("Peak of each pixel"), "image_peak",
                          tr("Where a pixel has many samples: the largest magnitude of them instead of one. Takes all "
                             "of them to read.")},
                         [this](bool on) { change([on](PartLook& look) { look.peak = on; }); });
  colours_.add_palette(form_);
  colours_.add_limits(form_);
  colours_.add_span(form_);
  connect(&colours_, &ColourRows::chosen, this, [this](const picture::ColourLook& chosen) {
    change([&](PartLook& look) { static_cast<picture::ColourLook&>(look) = chosen; });
  });
  make_axes(add_form_group(layout, tr("Axes")));
  make_links(add_form_group(layout, tr("Other viewers")));
  layout->addWidget(problem_);
  show_look({}, raster::ImageValue::complex, {});
}

void ImageControls::change(const std::function<void(PartLook&)>& apply) {
  PartLook changed = look_;
  apply(changed);
  if (changed == look_) return;
  show_look(changed, value_, unit_);
  emit edited(look_);
}

namespace {

// What is counted in a unit as axes have it; a number where that is not known.
scene::Quantity quantity_of(const std::string& unit) {
  using scene::Quantity;
  for (const Quantity quantity :
       {Quantity::length, Quantity::time, Quantity::frequency, Quantity::angle, Quantity::speed})
    if (scene::units_of(quantity).front() == unit) return quantity;
  return Quantity::number;
}

}  // namespace

// What is seen, as numbers that can be typed.
void ImageControls::make_limits(QFormLayout* form) {
  using raster::FocusedPlaces;
  const auto add = [&](const FormRows::Words& words, double ImageView::*end, raster::ImagePlaces FocusedPlaces::*axis) {
    const Limit limit{end, axis};
    limits_.push_back(limit);
    limits_.back().field = rows_.add_number(form, words, {[this, axis] { return quantity_of((places_.*axis).unit); }},
                                            [this, limit](double place) { take_limit(limit, place); });
  };
  add({tr("Across from"), "image_column_from", tr("Where the picture begins at the left")}, &ImageView::column_first,
      &FocusedPlaces::range);
  add({tr("to"), "image_column_to", tr("Where it ends at the right")}, &ImageView::column_last, &FocusedPlaces::range);
  add({tr("Down from"), "image_row_from", tr("Where the picture begins at the top")}, &ImageView::row_first,
      &FocusedPlaces::azimuth);
  add({tr("to"), "image_row_to", tr("Where it ends at the bottom")}, &ImageView::row_last, &FocusedPlaces::azimuth);
}

// Where scales are equal the other axis grows and shrinks with it, about its middle.
void ImageControls::take_limit(const Limit& limit, double place) {
  const raster::ImagePlaces& axis = places_.*limit.axis;
  ImageView view = view_;
  view.*limit.end = (place - axis.first) / axis.step;
  if (view.column_first > view.column_last) std::swap(view.column_first, view.column_last);
  if (view.row_first > view.row_last) std::swap(view.row_first, view.row_last);
  if (!(view.columns() > 0.0) || !(view.rows() > 0.0)) return show_view(view_, places_);
  if (look_.equal_scale && places_.range.unit == "m" && places_.azimuth.unit == "m") {
    const double row = 0.5 * (view.row_first + view.row_last);
    const double column = 0.5 * (view.column_first + view.column_last);
    const double rows = 0.5 * view_.rows() * view.columns() / view_.columns();
    const double columns = 0.5 * view_.columns() * view.rows() / view_.rows();
    if (view.columns() != view_.columns())
      view.row_first = row - rows, view.row_last = row + rows;
    else
      view.column_first = column - columns, view.column_last = column + columns;
  }
  emit view_typed(view);
}

void ImageControls::show_view(const ImageView& view, const raster::FocusedPlaces& places) {
  constexpr double shown_parts = 1e4;  // of what is seen
  view_ = view;
  places_ = places;
  for (const Limit& limit : limits_) {
    const raster::ImagePlaces& axis = places_.*limit.axis;
    const double span = axis.step * (limit.axis == &raster::FocusedPlaces::range ? view.columns() : view.rows());
    const double place = axis.first + axis.step * (view.*limit.end);
    show_number(limit.field, core::rounded_to(place, picture::round_below(std::abs(span) / shown_parts)),
                quantity_of(axis.unit));
  }
}

void ImageControls::make_axes(QFormLayout* form) {
  make_limits(form);
  numbers_ = rows_.add_mark(
      form, {tr("Rows and samples"), "image_numbers", tr("Axes count rows and samples instead of showing positions")},
      [this](bool on) { change([on](PartLook& look) { look.numbers = on; }); });
  equal_scale_ =
      rows_.add_mark(form,
                     {tr("Equal scale"), "image_equal_scale",
                      tr("Of images in metres: a metre is as long across as downwards. Long strips are shown "
                         "as they fit.")},
                     [this](bool on) { change([on](PartLook& look) { look.equal_scale = on; }); });
}

void ImageControls::make_links(QFormLayout* form) {
  const auto mark = [&](const QString& label, const char* name) {
    return rows_.add_mark(form, {label, name, tr("Viewers with this mark move and zoom together along this axis")},
                          [this](bool) { emit link_changed(); });
  };
  link_columns_ = mark(tr("Samples follow"), "image_link_columns");
  link_rows_ = mark(tr("Rows follow"), "image_link_rows");
}

picture::AxisLink ImageControls::link() const { return {link_columns_->isChecked(), link_rows_->isChecked()}; }

void ImageControls::show_look(const PartLook& look, raster::ImageValue value, const QString& unit) {
  look_ = look;
  value_ = value;
  unit_ = unit;
  const bool samples = value != raster::ImageValue::rgb;
  colours_.show(look, unit == "V" ? scene::Quantity::voltage : scene::Quantity::number, samples);
  if (auto* const items = qobject_cast<QStandardItemModel*>(quantity_->model()))
    for (int i = 0; i < quantity_->count(); ++i)
      items->item(i)->setEnabled(has_quantity(value, static_cast<picture::DisplayQuantity>(i)));
  rows_.while_showing([&] {
    draw_as_->setCurrentIndex(static_cast<int>(look.draw_as));
    peak_->setChecked(look.peak);
    numbers_->setChecked(look.numbers);
    equal_scale_->setChecked(look.equal_scale);
  });
  const bool magnitudes =
      look.quantity == picture::DisplayQuantity::decibels || look.quantity == picture::DisplayQuantity::magnitude;
  show_row(form_, draw_as_, samples);
  show_row(form_, peak_, samples && magnitudes && look.draw_as == picture::DrawAs::pixels);
}

}  // namespace sarsim::gui
