#include "gui/image/image_controls.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QStandardItemModel>
#include <QVBoxLayout>

#include "gui/common/problem_line.hpp"

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

void ImageControls::make_axes(QFormLayout* form) {
  numbers_ = rows_.add_mark(
      form, {tr("Rows and samples"), "image_numbers", tr("Axes count rows and samples instead of saying their places")},
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
    peak_->setChecked(look.peak);
    numbers_->setChecked(look.numbers);
    equal_scale_->setChecked(look.equal_scale);
  });
  const bool magnitudes =
      look.quantity == picture::DisplayQuantity::decibels || look.quantity == picture::DisplayQuantity::magnitude;
  show_row(form_, peak_, samples && magnitudes);
}

}  // namespace sarsim::gui
