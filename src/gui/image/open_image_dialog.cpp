#include "gui/image/open_image_dialog.hpp"

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
#include <chrono>
#include <cmath>
#include <complex>
#include <thread>

#include "gui/common/form_rows.hpp"
#include "gui/common/help_button.hpp"
#include "gui/common/problem_line.hpp"
#include "gui/common/text.hpp"
#include "gui/image/image_part.hpp"
#include "raster/format/custom_raw.hpp"
#include "workflow/input/recording_hints.hpp"

namespace sarsim::gui {

// What is to be found out of a file.
struct FoundOut {
  std::vector<raster::RawGuess> guesses;
  std::optional<raster::RasterHints> known;  // to the scene
  bool readable = true;                      // by its content
};

// What comes of a file, read as the fields say.
struct FilePreview {
  bool readable = false;
  core::Problems problems;
  QImage picture;
};

namespace {

constexpr int preview_side = 256;
constexpr int preview_after_ms = 150;
constexpr std::size_t max_bits = 64;

std::size_t whole_number(const QLineEdit* edit) { return edit->text().trimmed().toULongLong(); }

// Reads the file.
FoundOut find_out(const std::filesystem::path& file, const scene::Scene& scene) {
  FoundOut found;
  auto guessed = raster::guess_raw_layout(file);
  if (auto* const guesses = std::get_if<std::vector<raster::RawGuess>>(&guessed)) found.guesses = std::move(*guesses);
  if (const auto layout = raster::envi_layout(file)) {
    raster::RawGuess said;
    said.layout = *layout;
    said.reason = OpenImageDialog::tr("its header says so").toStdString();
    found.guesses.insert(found.guesses.begin(), said);
  }
  found.known = workflow::hints_from_scene(scene, file);
  raster::RasterHints hints;
  if (found.known) {
    hints.columns = found.known->columns;
    hints.bits = found.known->bits;
  }
  std::error_code ignored;
  found.readable = !std::filesystem::is_regular_file(file, ignored) ||
                   raster::open_raster(raster::Integrity::partial, file, hints).raster != nullptr;
  return found;
}

// Rows of a text come to be known little by little.
void wait_for_rows(const raster::Raster& source, const core::StopFlag& stop) {
  constexpr auto patience = std::chrono::seconds(2);
  constexpr auto step = std::chrono::milliseconds(10);
  for (auto waited = std::chrono::milliseconds(0); source.indexed() < 1.0; waited += step) {
    if (stop.requested()) throw core::Interrupted();
    if (waited >= patience && source.rows() > 0) return;
    std::this_thread::sleep_for(step);
  }
}

QImage picture_of(const raster::Raster& source) {
  const ImageView all = whole_view(source.rows(), source.columns());
  ImagePart part;
  part.window = window_for(all, preview_side, preview_side, source.rows(), source.columns());
  part.value = source.info().value;
  if (part.window.samples() == 0) return {};
  std::vector<std::complex<float>> samples(part.window.samples());
  source.read_window(part.window, samples);
  part.samples.assign(samples.begin(), samples.end());
  if (part.value == raster::ImageValue::rgb) {
    part.colours.resize(part.window.samples());
    source.read_rgb(part.window, part.colours);
  }
  PartLook look = look_for(part.value, source.info().format->picture);
  look.limits.percentile = 99.0;
  return paint(part, look, all).image.scaled(preview_side, preview_side);
}

FilePreview preview_of(const std::filesystem::path& file, const raster::RasterHints& hints,
                       const core::StopFlag& stop) {
  FilePreview preview;
  const raster::OpenedRaster opened = raster::open_raster(raster::Integrity::partial, file, hints);
  preview.problems = opened.problems;
  preview.readable = opened.raster != nullptr;
  if (!opened.raster) return preview;
  wait_for_rows(*opened.raster, stop);
  preview.picture = picture_of(*opened.raster);
  return preview;
}

constexpr raster::ImageValue raw_values[] = {raster::ImageValue::complex, raster::ImageValue::real,
                                             raster::ImageValue::magnitude, raster::ImageValue::power};

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
  add_help_button(*buttons);
  open_ = buttons->button(QDialogButtonBox::Open);
  layout->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  debounce_.setSingleShot(true);
  connect(&debounce_, &QTimer::timeout, this, &OpenImageDialog::begin_preview);
  connect(&finding_, &LatestOnlyWork::ended, this, &OpenImageDialog::show_found);
  connect(&previewing_, &LatestOnlyWork::ended, this, &OpenImageDialog::show_preview);
  show_layout({});
  show_rows();
  begin_preview();
  setMinimumWidth(fontMetrics().averageCharWidth() * 110);
}

// A field that goes while it has the keyboard says once more that it is finished.
OpenImageDialog::~OpenImageDialog() { path_->disconnect(this); }

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
  kind_->addItem(tr("Found from its content"));
  for (const raster::Format* format : described_) kind_->addItem(text_of(format->name));
  kind_->addItem(tr("Custom: described below"));
  form->addRow(tr("Format"), kind_);
  connect(kind_, &QComboBox::activated, this, &OpenImageDialog::choose);
}

QLineEdit* OpenImageDialog::add_number(QFormLayout* form, const QString& label, const char* name, const QString& tip) {
  auto* const edit = new QLineEdit(this);
  edit->setObjectName(name);
  edit->setAccessibleName(label);
  edit->setToolTip(tip);
  form->addRow(label, edit);
  connect(edit, &QLineEdit::textEdited, this, &OpenImageDialog::choose);
  return edit;
}

void OpenImageDialog::make_sample_rows(QFormLayout* form) {
  columns_ = add_number(form, tr("Samples per row"), "open_image_columns", tr("Empty: as the file says"));
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
  width_ = add_number(form, tr("Width"), "open_image_width", tr("Samples per row"));
  height_ = add_number(form, tr("Height"), "open_image_height", tr("Rows; 0: as many as the file holds"));
  number_ = choice(tr("Numbers"), "open_image_number", tr("How a component of a sample is stored"));
  for (const raster::RawNumber number :
       {raster::RawNumber::int8, raster::RawNumber::uint8, raster::RawNumber::int16, raster::RawNumber::uint16,
        raster::RawNumber::int32, raster::RawNumber::uint32, raster::RawNumber::float32, raster::RawNumber::float64})
    number_->addItem(
        QString::fromUtf8(raster::name_of(number).data(), static_cast<qsizetype>(raster::name_of(number).size())));
  value_ = choice(tr("Samples are"), "open_image_value", tr("Complex samples are two numbers, others one"));
  value_->addItems({tr("Complex (I, Q)"), tr("Real"), tr("Magnitudes"), tr("Powers")});
  offset_ = add_number(form, tr("Offset"), "open_image_offset", tr("Subtracted from every number"));
  big_endian_ = new QCheckBox(tr("Most significant byte first"), this);
  big_endian_->setObjectName("open_image_big_endian");
  q_first_ = new QCheckBox(tr("Q before I"), this);
  q_first_->setObjectName("open_image_q_first");
  form->addRow(big_endian_);
  form->addRow(q_first_);
  for (QComboBox* box : {number_, value_}) connect(box, &QComboBox::activated, this, &OpenImageDialog::choose);
  for (QCheckBox* box : {big_endian_, q_first_}) connect(box, &QCheckBox::clicked, this, &OpenImageDialog::choose);
}

void OpenImageDialog::find_file() {
  const QString found = QFileDialog::getOpenFileName(this, tr("Open simulation output"), path_->text());
  if (!found.isEmpty()) show_file(found, {});
}

void OpenImageDialog::show_file(const QString& path, const raster::RasterHints& hints) {
  path_->setText(path);
  take_file();
  if (hints.raw) show_layout(*hints.raw);
  if (const auto kind = kind_of(hints)) kind_->setCurrentIndex(*kind);
  if (hints.columns > 0) columns_->setText(QString::number(hints.columns));
  if (hints.bits > 0) bits_->setText(QString::number(hints.bits));
  chosen_ = kind_of(hints).has_value();
  changed();
}

// What a file says of itself and what the scene says of it; a damaged file may take long.
void OpenImageDialog::take_file() {
  found_ = std::make_shared<FoundOut>();
  guesses_.clear();
  guess_->clear();
  columns_->clear();
  bits_->clear();
  kind_->setCurrentIndex(by_content);
  chosen_ = false;
  preview_->setPixmap({});
  preview_->setText(tr("Looking..."));
  problems_->clear();
  open_->setEnabled(false);
  finding_.run([file = std::filesystem::path(path_->text().toStdString()), scene = scene_, into = found_](
                   const core::StopFlag&, const BackgroundJob::Report&) { *into = find_out(file, scene); });
  changed();
}

// What was chosen or typed meanwhile stays.
void OpenImageDialog::show_found(bool good, const QString& failure) {
  if (!good) problems_->show_texts(core::Severity::error, {failure});
  const FoundOut& found = *found_;
  guesses_ = found.guesses;
  for (const raster::RawGuess& guess : guesses_)
    guess_->addItem(QString::fromStdString(raster::to_string(guess.layout)) + " (" +
                    QString::fromStdString(guess.reason) + ")");
  if (found.known && columns_->text().isEmpty() && bits_->text().isEmpty()) {
    columns_->setText(QString::number(found.known->columns));
    bits_->setText(QString::number(found.known->bits));
  }
  if (!chosen_) {
    if (!guesses_.empty()) show_layout(guesses_.front().layout);
    // What does not describe itself begins with the best guess.
    kind_->setCurrentIndex(found.readable || guesses_.empty() ? by_content : custom_kind());
  }
  changed();
}

void OpenImageDialog::take_guess(int index) {
  if (index < 0 || static_cast<std::size_t>(index) >= guesses_.size()) return;
  show_layout(guesses_[static_cast<std::size_t>(index)].layout);
  choose();
}

void OpenImageDialog::show_layout(const raster::RawLayout& layout) {
  header_->setText(QString::number(layout.header_bytes));
  width_->setText(QString::number(layout.width));
  height_->setText(QString::number(layout.height));
  number_->setCurrentIndex(static_cast<int>(layout.number));
  value_->setCurrentIndex(static_cast<int>(std::ranges::find(raw_values, layout.value) - std::begin(raw_values)));
  offset_->setText(QString::number(layout.offset));
  big_endian_->setChecked(layout.big_endian);
  q_first_->setChecked(layout.q_first);
}

raster::RawLayout OpenImageDialog::layout() const {
  raster::RawLayout layout;
  layout.header_bytes = whole_number(header_);
  layout.width = whole_number(width_);
  layout.height = whole_number(height_);
  layout.offset = offset_->text().toDouble();
  layout.number = static_cast<raster::RawNumber>(number_->currentIndex());
  layout.value = raw_values[std::clamp(value_->currentIndex(), 0, 3)];
  layout.big_endian = big_endian_->isChecked();
  layout.q_first = q_first_->isChecked();
  return layout;
}

QString OpenImageDialog::path() const { return path_->text(); }

raster::RasterHints OpenImageDialog::hints() const {
  raster::RasterHints hints;
  if (kind_->currentIndex() == custom_kind()) {
    hints.raw = layout();
    return hints;
  }
  if (kind_->currentIndex() > by_content)
    hints.format = described_.at(static_cast<std::size_t>(kind_->currentIndex()) - 1)->recording;
  hints.columns = whole_number(columns_);
  hints.bits = static_cast<int>(std::min<std::size_t>(whole_number(bits_), max_bits));
  return hints;
}

bool OpenImageDialog::has_preview() const { return !preview_->pixmap(Qt::ReturnByValue).isNull(); }

std::optional<int> OpenImageDialog::kind_of(const raster::RasterHints& hints) const {
  if (hints.raw) return custom_kind();
  if (!hints.format) return std::nullopt;
  const auto found = std::ranges::find(described_, hints.format, &raster::Format::recording);
  return found == described_.end() ? by_content : static_cast<int>(found - described_.begin()) + 1;
}

// By the user.
void OpenImageDialog::choose() {
  chosen_ = true;
  changed();
}

void OpenImageDialog::changed() {
  show_rows();
  debounce_.start(preview_after_ms);
}

void OpenImageDialog::show_rows() {
  const bool raw = kind_->currentIndex() == custom_kind();
  for (QWidget* field : {columns_, bits_}) show_row(form_, field, !raw);
  for (QWidget* field :
       {static_cast<QWidget*>(guess_), static_cast<QWidget*>(header_), static_cast<QWidget*>(width_),
        static_cast<QWidget*>(height_), static_cast<QWidget*>(number_), static_cast<QWidget*>(value_),
        static_cast<QWidget*>(offset_), static_cast<QWidget*>(big_endian_), static_cast<QWidget*>(q_first_)})
    show_row(form_, field, raw);
  const raster::RawNumber number = static_cast<raster::RawNumber>(number_->currentIndex());
  big_endian_->setEnabled(raster::bytes_of(number) > 1);
  q_first_->setEnabled(value_->currentIndex() == 0);
}

QStringList OpenImageDialog::objections() const {
  QStringList texts;
  const auto object = [&](const QLineEdit* edit, bool understood) {
    if (edit->isVisibleTo(this) && !edit->text().trimmed().isEmpty() && !understood)
      texts << tr("%1: '%2' is not a valid number").arg(edit->accessibleName(), edit->text().trimmed());
  };
  for (const QLineEdit* edit : {columns_, bits_, header_, width_, height_}) {
    bool whole = false;
    const qulonglong number = edit->text().trimmed().toULongLong(&whole);
    object(edit, whole && (edit != bits_ || number <= max_bits));
  }
  bool number = false;
  const double offset = offset_->text().trimmed().toDouble(&number);
  object(offset_, number && std::isfinite(offset));
  return texts;
}

void OpenImageDialog::begin_preview() {
  const QStringList wrong = objections();
  open_->setEnabled(!path_->text().isEmpty() && wrong.isEmpty() && !finding_.busy());
  if (path_->text().isEmpty() || !wrong.isEmpty() || finding_.busy()) {
    previewing_.cancel();
    if (!wrong.isEmpty()) problems_->show_texts(core::Severity::error, wrong);
    if (!finding_.busy()) show_picture({}, path_->text().isEmpty() ? tr("Preview") : tr("No preview"));
    return;
  }
  problems_->clear();
  shown_ = std::make_shared<FilePreview>();
  previewing_.run(
      [file = std::filesystem::path(path_->text().toStdString()), hints = hints(), into = shown_](
          const core::StopFlag& stop, const BackgroundJob::Report&) { *into = preview_of(file, hints, stop); });
}

void OpenImageDialog::show_preview(bool good, const QString& failure) {
  QStringList texts;
  if (!good) texts << failure;
  for (const core::Problem& problem : shown_->problems) texts << problem_text(problem);
  const bool readable = good && shown_->readable;
  if (texts.isEmpty())
    problems_->clear();
  else
    problems_->show_texts(readable ? core::Severity::warning : core::Severity::error, texts.mid(0, 4));
  open_->setEnabled(readable);
  show_picture(shown_->picture, readable ? tr("The file holds no samples yet") : tr("No preview"));
}

void OpenImageDialog::show_picture(const QImage& picture, const QString& instead) {
  if (picture.isNull())
    preview_->setText(instead);
  else
    preview_->setPixmap(QPixmap::fromImage(picture));
}

}  // namespace sarsim::gui
