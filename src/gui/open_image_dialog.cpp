#include "gui/open_image_dialog.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

#include "data/recording_hints.hpp"
#include "gui/image_part.hpp"
#include "gui/problem_line.hpp"

namespace sarsim {

namespace {

constexpr int preview_side = 256;
constexpr int preview_after_ms = 150;

void show_row(QFormLayout* form, QWidget* field, bool shown) {
  field->setVisible(shown);
  if (QWidget* label = form->labelForField(field)) label->setVisible(shown);
}

std::size_t whole_number(const QLineEdit* edit) { return edit->text().trimmed().toULongLong(); }

constexpr ImageValue raw_values[] = {ImageValue::complex, ImageValue::real, ImageValue::magnitude, ImageValue::power};

}  // namespace

OpenImageDialog::OpenImageDialog(QWidget* parent) : QDialog(parent) {
  setObjectName("open_image_dialog");
  setWindowTitle(tr("Open simulation output"));
  auto* const layout = new QVBoxLayout(this);
  auto* const halves = new QHBoxLayout;
  form_ = new QFormLayout;
  form_->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
  halves->addLayout(form_, 1);
  preview_ = new QLabel(this);
  preview_->setObjectName("open_image_preview");
  preview_->setAccessibleName(tr("Preview"));
  preview_->setFixedSize(preview_side + 4, preview_side + 4);
  preview_->setFrameShape(QFrame::StyledPanel);
  preview_->setAlignment(Qt::AlignCenter);
  preview_->setWordWrap(true);
  halves->addWidget(preview_, 0, Qt::AlignTop);
  layout->addLayout(halves);
  make_file_row(form_);
  make_sample_rows(form_);
  make_raw_rows(form_);
  problems_ = new ProblemLine(this);
  problems_->setObjectName("open_image_problems");
  layout->addWidget(problems_);
  auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel, this);
  open_ = buttons->button(QDialogButtonBox::Open);
  layout->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  soon_.setSingleShot(true);
  connect(&soon_, &QTimer::timeout, this, &OpenImageDialog::show_preview);
  show_layout({});
  show_rows();
  show_preview();
  setMinimumWidth(fontMetrics().averageCharWidth() * 110);
}

void OpenImageDialog::make_file_row(QFormLayout* form) {
  auto* const row = new QHBoxLayout;
  path_ = new QLineEdit(this);
  path_->setObjectName("open_image_path");
  path_->setAccessibleName(tr("File"));
  path_->setToolTip(tr("A file of samples or a picture"));
  auto* const find = new QPushButton(tr("Find..."), this);
  find->setObjectName("open_image_find");
  find->setAutoDefault(false);
  row->addWidget(path_, 1);
  row->addWidget(find);
  form->addRow(tr("File"), row);
  connect(find, &QPushButton::clicked, this, &OpenImageDialog::find_file);
  connect(path_, &QLineEdit::editingFinished, this, [this] {
    if (path_->isModified()) take_file();
    path_->setModified(false);
  });
  kind_ = new QComboBox(this);
  kind_->setObjectName("open_image_kind");
  kind_->setAccessibleName(tr("Format"));
  kind_->setToolTip(tr("HDF5, NumPy arrays and Sun rasters describe themselves; so do most texts"));
  kind_->addItems({tr("Found from its content"), tr("Sarsim BINARY"), tr("Sarsim ASCII"), tr("Sarsim BRACKET"),
                   tr("CSV"), tr("Custom: described below")});
  form->addRow(tr("Format"), kind_);
  connect(kind_, &QComboBox::activated, this, &OpenImageDialog::changed);
}

QLineEdit* OpenImageDialog::add_number(QFormLayout* form, const QString& label, const char* name, const QString& tip) {
  auto* const edit = new QLineEdit(this);
  edit->setObjectName(name);
  edit->setAccessibleName(label);
  edit->setToolTip(tip);
  form->addRow(label, edit);
  connect(edit, &QLineEdit::textEdited, this, &OpenImageDialog::changed);
  return edit;
}

void OpenImageDialog::make_sample_rows(QFormLayout* form) {
  columns_ = add_number(form, tr("Samples of a row"), "open_image_columns", tr("Empty: as the file says"));
  bits_ = add_number(form, tr("Bits"), "open_image_bits", tr("Of the A/D converter; needed for BINARY"));
}

void OpenImageDialog::make_raw_rows(QFormLayout* form) {
  const auto choice = [&](const QString& label, const char* name, const QString& tip) {
    auto* const box = new QComboBox(this);
    box->setObjectName(name);
    box->setAccessibleName(label);
    box->setToolTip(tip);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(16);
    box->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    form->addRow(label, box);
    return box;
  };
  guess_ = choice(tr("Guesses"), "open_image_guess", tr("What the file looks like, likeliest first"));
  connect(guess_, &QComboBox::activated, this, &OpenImageDialog::take_guess);
  header_ = add_number(form, tr("Header, bytes"), "open_image_header", tr("Bytes before the first sample"));
  width_ = add_number(form, tr("Width"), "open_image_width", tr("Samples of a row"));
  height_ = add_number(form, tr("Height"), "open_image_height", tr("Rows; 0: as many as the file holds"));
  number_ = choice(tr("Numbers"), "open_image_number", tr("How a component of a sample is stored"));
  for (const RawNumber number : {RawNumber::int8, RawNumber::uint8, RawNumber::int16, RawNumber::uint16,
                                 RawNumber::int32, RawNumber::uint32, RawNumber::float32, RawNumber::float64})
    number_->addItem(QString::fromUtf8(name_of(number).data(), static_cast<qsizetype>(name_of(number).size())));
  value_ = choice(tr("Samples are"), "open_image_value", tr("Complex samples are two numbers, others one"));
  value_->addItems({tr("Complex (I, Q)"), tr("Real"), tr("Magnitudes"), tr("Powers")});
  offset_ = add_number(form, tr("Offset"), "open_image_offset", tr("Subtracted from every number"));
  big_endian_ = new QCheckBox(tr("Most significant byte first"), this);
  big_endian_->setObjectName("open_image_big_endian");
  q_first_ = new QCheckBox(tr("Q before I"), this);
  q_first_->setObjectName("open_image_q_first");
  form->addRow(big_endian_);
  form->addRow(q_first_);
  for (QComboBox* box : {number_, value_}) connect(box, &QComboBox::activated, this, &OpenImageDialog::changed);
  for (QCheckBox* box : {big_endian_, q_first_}) connect(box, &QCheckBox::toggled, this, &OpenImageDialog::changed);
}

void OpenImageDialog::find_file() {
  const QString found = QFileDialog::getOpenFileName(this, tr("Open simulation output"), path_->text());
  if (!found.isEmpty()) show_file(found, {});
}

void OpenImageDialog::show_file(const QString& path, const ImageHints& hints) {
  path_->setText(path);
  take_file();
  if (hints.raw) {
    kind_->setCurrentIndex(custom);
    show_layout(*hints.raw);
  } else if (hints.samples.columns > 0 || hints.samples.bits > 0) {
    if (hints.samples.columns > 0) columns_->setText(QString::number(hints.samples.columns));
    if (hints.samples.bits > 0) bits_->setText(QString::number(hints.samples.bits));
  }
  changed();
}

// Everything that the file itself and the scene say.
void OpenImageDialog::take_file() {
  guesses_.clear();
  guess_->clear();
  const std::filesystem::path file = path_->text().toStdString();
  try {
    auto found = guess_raw_layout(file);
    if (auto* const guesses = std::get_if<std::vector<RawGuess>>(&found)) guesses_ = std::move(*guesses);
  } catch (const std::exception& error) {
    problems_->show_texts(Severity::error, {QString::fromUtf8(error.what())});
  }
  for (const RawGuess& guess : guesses_)
    guess_->addItem(QString::fromStdString(to_string(guess.layout)) + " (" + QString::fromStdString(guess.reason) +
                    ")");
  if (!guesses_.empty()) show_layout(guesses_.front().layout);
  if (const auto known = hints_from_scene(scene_, file)) {
    columns_->setText(QString::number(known->columns));
    bits_->setText(QString::number(known->bits));
  }
  // What does not describe itself begins with the best guess.
  kind_->setCurrentIndex(by_content);
  std::error_code ignored;
  if (std::filesystem::is_regular_file(file, ignored) && !ImageSource::open(file, hints()).source && !guesses_.empty())
    kind_->setCurrentIndex(custom);
  changed();
}

void OpenImageDialog::take_guess(int index) {
  if (index < 0 || static_cast<std::size_t>(index) >= guesses_.size()) return;
  show_layout(guesses_[static_cast<std::size_t>(index)].layout);
  changed();
}

void OpenImageDialog::show_layout(const RawLayout& layout) {
  showing_ = true;
  header_->setText(QString::number(layout.header_bytes));
  width_->setText(QString::number(layout.width));
  height_->setText(QString::number(layout.height));
  number_->setCurrentIndex(static_cast<int>(layout.number));
  value_->setCurrentIndex(static_cast<int>(std::ranges::find(raw_values, layout.value) - std::begin(raw_values)));
  offset_->setText(QString::number(layout.offset));
  big_endian_->setChecked(layout.big_endian);
  q_first_->setChecked(layout.q_first);
  showing_ = false;
}

RawLayout OpenImageDialog::layout() const {
  RawLayout layout;
  layout.header_bytes = whole_number(header_);
  layout.width = whole_number(width_);
  layout.height = whole_number(height_);
  layout.offset = offset_->text().toDouble();
  layout.number = static_cast<RawNumber>(number_->currentIndex());
  layout.value = raw_values[std::clamp(value_->currentIndex(), 0, 3)];
  layout.big_endian = big_endian_->isChecked();
  layout.q_first = q_first_->isChecked();
  return layout;
}

QString OpenImageDialog::path() const { return path_->text(); }

ImageHints OpenImageDialog::hints() const {
  ImageHints hints;
  switch (kind_->currentIndex()) {
    case binary: hints.samples.format = FileFormat::binary; break;
    case ascii: hints.samples.format = FileFormat::ascii; break;
    case bracket: hints.samples.format = FileFormat::bracket; break;
    case csv: hints.samples.format = FileFormat::csv; break;
    case custom: hints.raw = layout(); return hints;
    default: break;
  }
  hints.samples.columns = whole_number(columns_);
  hints.samples.bits = static_cast<int>(std::min<std::size_t>(whole_number(bits_), 64));
  return hints;
}

bool OpenImageDialog::has_preview() const { return !preview_->pixmap(Qt::ReturnByValue).isNull(); }

void OpenImageDialog::changed() {
  if (showing_) return;
  show_rows();
  soon_.start(preview_after_ms);
}

void OpenImageDialog::show_rows() {
  const bool raw = kind_->currentIndex() == custom;
  for (QWidget* field : {columns_, bits_}) show_row(form_, field, !raw);
  for (QWidget* field :
       {static_cast<QWidget*>(guess_), static_cast<QWidget*>(header_), static_cast<QWidget*>(width_),
        static_cast<QWidget*>(height_), static_cast<QWidget*>(number_), static_cast<QWidget*>(value_),
        static_cast<QWidget*>(offset_), static_cast<QWidget*>(big_endian_), static_cast<QWidget*>(q_first_)})
    show_row(form_, field, raw);
  const RawNumber number = static_cast<RawNumber>(number_->currentIndex());
  big_endian_->setEnabled(bytes_of(number) > 1);
  q_first_->setEnabled(value_->currentIndex() == 0);
}

void OpenImageDialog::show_preview() {
  preview_->setPixmap({});
  open_->setEnabled(!path_->text().isEmpty());
  if (path_->text().isEmpty()) {
    preview_->setText(tr("Preview"));
    return;
  }
  try {
    OpenedImage opened = ImageSource::open(path_->text().toStdString(), hints());
    QStringList texts;
    for (const Problem& problem : opened.problems) texts << problem_text(problem);
    if (texts.isEmpty())
      problems_->clear();
    else
      problems_->show_texts(opened.source ? Severity::warning : Severity::error, texts.mid(0, 4));
    open_->setEnabled(opened.source != nullptr);
    preview_->setText(opened.source ? tr("Nothing to show yet") : tr("No preview"));
    if (!opened.source) return;
    const ImageSource& source = *opened.source;
    const ImageView all = whole_view(source.rows(), source.columns());
    ImagePart part;
    part.window = window_for(all, preview_side, preview_side, source.rows(), source.columns());
    part.value = source.info().value;
    if (part.window.samples() == 0) return;
    std::vector<std::complex<float>> samples(part.window.samples());
    source.read_window(part.window, samples);
    part.samples.assign(samples.begin(), samples.end());
    if (part.value == ImageValue::rgb) {
      part.colours.resize(part.window.samples());
      source.read_rgb(part.window, part.colours);
    }
    PartLook look = look_for(part.value, source.info().format == ImageFormat::sun_raster);
    look.limits.percentile = 99.0;
    const QImage picture = paint(part, look, all).image;
    preview_->setPixmap(QPixmap::fromImage(picture.scaled(preview_side, preview_side)));
  } catch (const std::exception& error) {
    open_->setEnabled(false);
    problems_->show_texts(Severity::error, {QString::fromUtf8(error.what())});
  }
}

}  // namespace sarsim
