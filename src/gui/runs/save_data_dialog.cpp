#include "gui/runs/save_data_dialog.hpp"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

#include <utility>
#include <vector>

#include "core/maths/rounding.hpp"
#include "core/task/parallel.hpp"
#include "core/text/number_text.hpp"
#include "gui/common/help_button.hpp"
#include "gui/common/problem_line.hpp"
#include "gui/common/text.hpp"
#include "raster/table/formats.hpp"
#include "scene/schema/quantity.hpp"

namespace sarsim::gui {

namespace fs = std::filesystem;

namespace {

std::vector<const raster::Format*> kinds() { return raster::offered_formats(&raster::FormatPlaces::saved); }

QStringList choices() {
  QStringList texts;
  for (const raster::Format* kind : kinds()) texts << text_of(kind->choice);
  return texts;
}

// For people, who do not count nanometres; what is saved is exact.
QString span_text(double from, double to, const char* unit) {
  constexpr int digits = 8;
  return SaveDataDialog::tr("%1 to %2")
      .arg(text_of(core::with_prefix(from, unit, digits)), text_of(core::with_prefix(to, unit, digits)));
}

QFormLayout* add_group(QVBoxLayout* column, const QString& title, QWidget* parent) {
  auto* const group = new QGroupBox(title, parent);
  auto* const form = new QFormLayout(group);
  column->addWidget(group);
  return form;
}

}  // namespace

SaveDataDialog::SaveDataDialog(Session& session, const scene::Simulation& recording, double bandwidth_hz,
                               double largest_v, fs::path folder, QWidget* parent)
    : QDialog(parent),
      session_(session),
      bandwidth_hz_(bandwidth_hz),
      largest_v_(largest_v),
      folder_(std::move(folder)) {
  setObjectName("save_data_dialog");
  setWindowTitle(tr("Save Data"));
  choice_.recording = recording;
  choice_.lsb = recording.lsb_v > 0.0 ? workflow::LsbChoice::given : workflow::LsbChoice::estimated;
  choice_.file = workflow::free_file(session_.scene(), folder_, recording.format);
  make_questions();
  auto* const column = new QVBoxLayout(this);
  make_window_group(add_group(column, tr("Simulation window"), this));
  make_converter_group(add_group(column, tr("A/D converter"), this));
  make_file_group(add_group(column, tr("File"), this));
  estimate_ = new QLabel(this);
  estimate_->setObjectName("save_estimate");
  estimate_->setWordWrap(true);
  estimate_->setMinimumHeight(2 * fontMetrics().lineSpacing());
  estimate_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  estimate_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  problems_ = new ProblemLine(this);
  problems_->setObjectName("save_problems");
  buttons_ = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel, this);
  column->addWidget(estimate_);
  column->addWidget(problems_);
  column->addStretch(1);
  column->addWidget(buttons_);
  add_help_button(*buttons_);
  connect(buttons_, &QDialogButtonBox::accepted, this, &SaveDataDialog::accept);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(&planning_, &LatestOnlyWork::ended, this, &SaveDataDialog::show_forecast);
  show_lsb();
  refresh();
  resize(fontMetrics().averageCharWidth() * 72, sizeHint().height());
}

QLineEdit* SaveDataDialog::add_line(QFormLayout* form, const QString& label, const char* name, const QString& tip) {
  auto* const line = new QLineEdit(this);
  line->setObjectName(name);
  line->setAccessibleName(label);
  line->setToolTip(tip);
  form->addRow(label, line);
  return line;
}

QComboBox* SaveDataDialog::add_choice(QFormLayout* form, const QString& label, const char* name,
                                      const QStringList& entries, const QString& tip) {
  auto* const box = new QComboBox(this);
  box->setObjectName(name);
  box->setAccessibleName(label);
  box->setToolTip(tip);
  box->addItems(entries);
  form->addRow(label, box);
  return box;
}

void SaveDataDialog::make_window_group(QFormLayout* form) {
  const scene::Simulation& s = choice_.recording;
  const auto add_text = [&](const QString& label, const QString& text, const char* name) {
    auto* const shown = new QLabel(text, this);
    shown->setObjectName(name);
    shown->setTextInteractionFlags(Qt::TextSelectableByMouse);
    form->addRow(label, shown);
  };
  add_text(tr("Radar"), text_of(s.radar), "save_radar");
  add_text(tr("Slant range"), span_text(s.range_start_m, s.range_end_m, "m"), "save_range");
  add_text(tr("Azimuth"), span_text(s.time_start_s, s.time_end_s, "s"), "save_time");
  multiple_ = add_line(form, tr("Sampling x bandwidth"), "save_multiple",
                       tr("Sampling frequency over the bandwidth of the pulse; below 1 is accepted"));
  rate_ = add_line(form, tr("Sampling frequency"), "save_rate", tr("Of complex samples, as 60 MHz"));
  rate_->setText(text_of(scene::quantity_text(s.sample_rate_hz, scene::Quantity::frequency)));
  multiple_->setEnabled(bandwidth_hz_ > 0.0);
  if (bandwidth_hz_ > 0.0) multiple_->setText(QString::number(s.sample_rate_hz / bandwidth_hz_, 'g', 10));
  connect(multiple_, &QLineEdit::textEdited, this, &SaveDataDialog::take_multiple);
  connect(rate_, &QLineEdit::textEdited, this, &SaveDataDialog::take_rate);
}

void SaveDataDialog::make_converter_group(QFormLayout* form) {
  bits_ = new QSpinBox(this);
  bits_->setObjectName("save_bits");
  bits_->setAccessibleName(tr("Bits"));
  bits_->setToolTip(tr("Bits per I and Q channel; a binary file stores each in whole bytes"));
  bits_->setRange(1, 64);
  bits_->setValue(choice_.recording.bits);
  form->addRow(tr("Bits"), bits_);
  lsb_from_ = add_choice(form, tr("LSB"), "save_lsb_from",
                         {tr("Estimated from the picture"), tr("From the whole recording"), tr("Set by user")},
                         tr("From the picture with 3 % to spare; from the recording, which is then computed twice; or "
                            "a value of your own"));
  lsb_from_->setCurrentIndex(static_cast<int>(choice_.lsb));
  lsb_ = add_line(form, tr("LSB value"), "save_lsb", tr("Voltage of one step; a number without unit is in mV"));
  connect(bits_, &QSpinBox::valueChanged, this, &SaveDataDialog::take_rest);
  if (choice_.recording.lsb_v > 0.0)
    lsb_->setText(text_of(scene::quantity_text(choice_.recording.lsb_v, scene::Quantity::voltage)));
  connect(lsb_from_, &QComboBox::currentIndexChanged, this, &SaveDataDialog::take_lsb_choice);
  connect(lsb_, &QLineEdit::textEdited, this, &SaveDataDialog::take_rest);
}

void SaveDataDialog::make_file_group(QFormLayout* form) {
  format_ = add_choice(form, tr("Type"), "save_format", choices(), tr("The extension of the file follows"));
  show_format(choice_.recording.format);
  samples_ =
      add_choice(form, tr("Samples"), "save_samples",
                 {tr("Volts, not quantised"), tr("Counts of the A/D converter"), tr("Volts in double precision")},
                 tr("HDF5 and NPY hold what is chosen; the other types hold counts. Single precision keeps "
                    "6e-8 of a sample."));
  show_samples();
  file_ = new QLineEdit(text_of(choice_.file.string()), this);
  file_->setObjectName("save_file");
  file_->setAccessibleName(tr("Name of the file"));
  file_->setToolTip(tr("Without a folder, the file goes to %1").arg(text_of(folder_.string())));
  auto* const select = new QPushButton(tr("Se&lect..."), this);
  select->setObjectName("save_select");
  select->setAccessibleName(tr("Select the file"));
  select->setAutoDefault(false);
  auto* const row = new QHBoxLayout;
  row->addWidget(file_, 1);
  row->addWidget(select);
  form->addRow(tr("Name"), row);
  target_ = add_choice(form, tr("Save"), "save_target",
                       {tr("Data to disk only"), tr("Settings to script only"), tr("To both")},
                       tr("The settings in the script can be shown and run again"));
  connect(format_, &QComboBox::currentIndexChanged, this, &SaveDataDialog::follow_format);
  connect(samples_, &QComboBox::currentIndexChanged, this, [this](int index) {
    choice_.samples = static_cast<workflow::SampleChoice>(index);
    refresh();
  });
  connect(file_, &QLineEdit::textChanged, this, &SaveDataDialog::take_rest);
  connect(target_, &QComboBox::currentIndexChanged, this, &SaveDataDialog::take_rest);
  connect(select, &QPushButton::clicked, this, &SaveDataDialog::select_file);
}

void SaveDataDialog::make_questions() {
  is_taken = [](const fs::path&) { return false; };
  ask_replace = [this](const fs::path& file) {
    return QMessageBox::question(this, tr("Save Data"), tr("Replace the file %1?").arg(text_of(file.string())),
                                 QMessageBox::Yes | QMessageBox::No, QMessageBox::No) == QMessageBox::Yes;
  };
  ask_file = [this](const QString& present) {
    return QFileDialog::getSaveFileName(this, tr("Save Data"), present, {}, nullptr, QFileDialog::DontConfirmOverwrite);
  };
}

// The field that is typed into leads, the other one follows.
void SaveDataDialog::take_rate() {
  const scene::QuantityReading read = scene::read_quantity(rate_->text().toStdString(), scene::Quantity::frequency);
  rate_failure_ = text_of(read.failure);
  if (read.value && !(*read.value > 0.0)) rate_failure_ = tr("the sampling frequency must be above 0");
  if (rate_failure_.isEmpty()) {
    choice_.recording.sample_rate_hz = *read.value;
    if (bandwidth_hz_ > 0.0) multiple_->setText(QString::number(*read.value / bandwidth_hz_, 'g', 10));
  }
  refresh();
}

void SaveDataDialog::take_multiple() {
  const scene::QuantityReading read = scene::read_quantity(multiple_->text().toStdString(), scene::Quantity::number);
  rate_failure_ = text_of(read.failure);
  if (read.value && !(*read.value > 0.0)) rate_failure_ = tr("the multiple of the bandwidth must be above 0");
  if (rate_failure_.isEmpty()) {
    choice_.recording.sample_rate_hz = core::tidy(*read.value * bandwidth_hz_);
    rate_->setText(text_of(scene::quantity_text(choice_.recording.sample_rate_hz, scene::Quantity::frequency)));
  }
  refresh();
}

// Back to a value of one's own: the field has shown others meanwhile.
void SaveDataDialog::take_lsb_choice() {
  const bool given = static_cast<workflow::LsbChoice>(lsb_from_->currentIndex()) == workflow::LsbChoice::given;
  if (given && choice_.recording.lsb_v > 0.0)
    lsb_->setText(text_of(scene::quantity_text(choice_.recording.lsb_v, scene::Quantity::voltage)));
  take_rest();
}

void SaveDataDialog::take_rest() {
  choice_.recording.bits = bits_->value();
  choice_.lsb = static_cast<workflow::LsbChoice>(lsb_from_->currentIndex());
  choice_.target = static_cast<workflow::SaveTarget>(target_->currentIndex());
  choice_.file = file_->text().trimmed().toStdString();
  if (!choice_.file.empty() && choice_.file.is_relative()) choice_.file = folder_ / choice_.file;
  lsb_failure_.clear();
  if (choice_.lsb == workflow::LsbChoice::given) {
    const scene::QuantityReading read =
        scene::read_quantity(lsb_->text().toStdString(), scene::Quantity::voltage, "mV");
    lsb_failure_ = text_of(read.failure);
    if (read.value && !(*read.value > 0.0)) lsb_failure_ = tr("the LSB must be above 0");
    if (lsb_failure_.isEmpty()) choice_.recording.lsb_v = *read.value;
  }
  show_lsb();
  refresh();
}

// Where it is not typed, the field shows what it will be.
void SaveDataDialog::show_lsb() {
  const bool given = choice_.lsb == workflow::LsbChoice::given;
  lsb_->setReadOnly(!given);
  lsb_->setEnabled(given);
  const double lsb_v = simulation().lsb_v;
  if (given) return;
  lsb_->setText(lsb_v > 0.0 ? QStringLiteral("%1 mV").arg(1e3 * lsb_v, 0, 'g', 6) : QString());
  lsb_->setPlaceholderText(choice_.lsb == workflow::LsbChoice::estimated ? tr("unknown until the picture is complete")
                                                                         : tr("known when it has run"));
}

void SaveDataDialog::follow_format() {
  choice_.recording.format = kinds().at(static_cast<std::size_t>(format_->currentIndex()))->recording.value();
  show_samples();
  const fs::path typed = file_->text().trimmed().toStdString();
  const QString following = text_of(workflow::following_format(typed, choice_.recording.format).string());
  if (following == file_->text())
    refresh();
  else
    file_->setText(following);
}

// Where the format decides, the list shows what it holds.
void SaveDataDialog::show_samples() {
  const QSignalBlocker quiet(samples_);
  samples_->setCurrentIndex(static_cast<int>(workflow::chosen_samples(choice_)));
  samples_->setEnabled(!raster::holds_counts(choice_.recording.format));
}

void SaveDataDialog::show_format(scene::FileFormat format) {
  format_->setCurrentIndex(raster::format_of(format).places.saved - 1);
}

void SaveDataDialog::select_file() {
  const QString chosen = ask_file(text_of(choice_.file.string()));
  if (chosen.isEmpty()) return;
  file_->setText(chosen);
  if (const auto format = raster::format_from_path(chosen.toStdString())) show_format(*format);
  follow_format();
}

QStringList SaveDataDialog::objections() const {
  QStringList texts;
  for (const QString& failure : {rate_failure_, lsb_failure_})
    if (!failure.isEmpty()) texts << failure;
  if (choice_.file.filename().empty()) texts << tr("the file has no name");
  std::error_code unreadable;
  if (choice_.target != workflow::SaveTarget::script && !choice_.file.empty()) {
    if (!fs::is_directory(choice_.file.parent_path(), unreadable))
      texts << tr("there is no folder '%1'").arg(text_of(choice_.file.parent_path().string()));
    else if (fs::is_directory(choice_.file, unreadable))
      texts << tr("'%1' is a folder").arg(text_of(choice_.file.string()));
  }
  return texts;
}

std::optional<workflow::SaveChoice> SaveDataDialog::choice() const {
  return objections().isEmpty() ? std::optional(choice_) : std::nullopt;
}

void SaveDataDialog::refresh() {
  if (buttons_ == nullptr) return;  // still being made
  const QStringList texts = objections();
  sound_ = texts.isEmpty();
  if (sound_)
    problems_->clear();
  else
    show_objections(texts);
  buttons_->button(QDialogButtonBox::Save)->setEnabled(sound_);
  if (sound_)
    plan();
  else
    planning_.cancel();
  if (!sound_) estimate_->clear();
}

// Text that breaks into lines asks for no room by itself: the dialog would press its fields together.
void SaveDataDialog::show_objections(const QStringList& texts) {
  problems_->show_texts(core::Severity::error, texts);
  // From the inside outwards: each tells the next that it needs another height.
  problems_->layout()->activate();
  layout()->activate();
  const int needed = layout()->totalHeightForWidth(width());
  if (needed > height()) resize(width(), needed);
}

void SaveDataDialog::plan() {
  forecast_ = std::make_shared<workflow::SaveForecast>();
  planning_.run([scene = session_.scene(), choice = choice_, largest_v = largest_v_, into = forecast_](
                    const core::StopFlag& stop, const BackgroundJob::Report&) {
    *into = workflow::forecast(scene, choice, largest_v, core::thread_count(0), &stop);
  });
}

void SaveDataDialog::show_forecast(bool good, const QString& failure) {
  QStringList texts;
  if (!good) texts << (failure.isEmpty() ? tr("the recording could not be planned") : failure);
  if (good)
    for (const core::Problem& problem : forecast_->problems) texts << problem_text(problem);
  estimate_->setText(good && forecast_->estimate
                         ? QString::fromStdString(sarsim::workflow::text_of(*forecast_->estimate))
                         : QString());
  if (!texts.isEmpty()) show_objections(texts.mid(0, 5));
  sound_ = texts.isEmpty();
  // What cannot be run yet may still be kept in the script, to be mended there.
  buttons_->button(QDialogButtonBox::Save)->setEnabled(sound_ || choice_.target == workflow::SaveTarget::script);
  emit forecast_ready();
}

void SaveDataDialog::accept() {
  if (!objections().isEmpty()) return;
  if (!sound_ && choice_.target != workflow::SaveTarget::script) return;
  replace_ = false;
  if (choice_.target != workflow::SaveTarget::script) {
    std::error_code unreadable;
    const bool there = fs::exists(choice_.file, unreadable) || is_taken(choice_.file);
    if (there && !ask_replace(choice_.file)) return;
    replace_ = there;
  }
  planning_.cancel();
  QDialog::accept();
}

}  // namespace sarsim::gui
