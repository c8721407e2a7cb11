#include "gui/common/form_rows.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QLineEdit>
#include <QSlider>
#include <QVBoxLayout>

#include <utility>

#include "gui/common/named.hpp"
#include "gui/common/problem_line.hpp"
#include "gui/common/text.hpp"

namespace sarsim::gui {

void FormRows::take(const std::function<void()>& taken) {
  if (showing_ > 0) return;
  problem_.clear();
  taken();
}

void FormRows::while_showing(const std::function<void()>& show) {
  ++showing_;
  show();
  --showing_;
}

QComboBox* FormRows::add_choice(QFormLayout* form, const Words& words, std::function<void(int)> chosen) {
  auto* const box = named(new QComboBox(&owner_), words.name, words.label, words.tip);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(12);
  form->addRow(words.label, box);
  QObject::connect(box, &QComboBox::activated, &owner_,
                   [this, chosen = std::move(chosen)](int index) { take([&] { chosen(index); }); });
  return box;
}

QLineEdit* FormRows::add_number(QFormLayout* form, const Words& words, Number number,
                                std::function<void(double)> typed) {
  auto* const edit = named(new QLineEdit(&owner_), words.name, words.label, words.tip);
  form->addRow(words.label, edit);
  const auto read = [this, edit, number = std::move(number), typed = std::move(typed)] {
    if (!edit->isModified()) return;
    const scene::QuantityReading reading = scene::read_quantity(edit->text().toStdString(), number.kind());
    QString failure = QString::fromStdString(reading.failure);
    if (reading.value && !(*reading.value > number.above && *reading.value <= number.most)) failure = number.otherwise;
    if (failure.isEmpty())
      take([&] { typed(*reading.value); });
    else
      problem_.show_texts(core::Severity::error, {failure});
    edit->setModified(!failure.isEmpty());
  };
  QObject::connect(edit, &QLineEdit::editingFinished, &owner_, read);
  return edit;
}

QSlider* FormRows::add_slider(QFormLayout* form, const QString& label, const QString& name,
                              std::function<void(int)> moved) {
  auto* const slider = named(new QSlider(Qt::Horizontal, &owner_), name, label,
                             QObject::tr("0 to 255; the middle is the original's default"));
  slider->setRange(0, 255);
  form->addRow(label, slider);
  QObject::connect(slider, &QSlider::valueChanged, &owner_,
                   [this, moved = std::move(moved)](int value) { take([&] { moved(value); }); });
  return slider;
}

QCheckBox* FormRows::add_mark(QFormLayout* form, const Words& words, std::function<void(bool)> set) {
  auto* const box = named(new QCheckBox(words.label, &owner_), words.name, words.label, words.tip);
  form->addRow(box);
  QObject::connect(box, &QCheckBox::toggled, &owner_,
                   [this, set = std::move(set)](bool on) { take([&] { set(on); }); });
  return box;
}

QFormLayout* add_form_group(QVBoxLayout* layout, const QString& title) {
  auto* const box = new QGroupBox(title, layout->parentWidget());
  auto* const form = new QFormLayout(box);
  form->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
  layout->addWidget(box);
  return form;
}

void show_row(QFormLayout* form, QWidget* field, bool shown) {
  field->setVisible(shown);
  if (QWidget* label = form->labelForField(field)) label->setVisible(shown);
}

void show_number(QLineEdit* field, double value, scene::Quantity kind) {
  if (field->isModified() && field->hasFocus()) return;
  field->setText(display_of(scene::quantity_text(value, kind)));
  field->setCursorPosition(0);
  field->setModified(false);
}

}  // namespace sarsim::gui
