#include "gui/objects/import_dialog.hpp"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QFontDatabase>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QStringDecoder>
#include <QVBoxLayout>

#include "gui/common/help_button.hpp"
#include "gui/common/problem_line.hpp"
#include "gui/common/text.hpp"
#include "scene/edit/edit.hpp"
#include "scene/script/reader.hpp"

namespace sarsim::gui {

namespace {

constexpr qsizetype preview_lines = 20;
constexpr qsizetype preview_characters = 20000;
constexpr qint64 read_at_once_bytes = 300'000;

// The first lines, with their numbers as the list of bad lines gives them.
QString first_lines(const QString& text) {
  QStringList lines = text.left(preview_characters).split('\n');
  if (lines.back().isEmpty()) lines.removeLast();
  const bool more = lines.size() > preview_lines || text.size() > preview_characters;
  lines = lines.mid(0, preview_lines);
  for (qsizetype i = 0; i < lines.size(); ++i) {
    if (lines[i].endsWith('\r')) lines[i].chop(1);
    lines[i] = QStringLiteral("%1  %2").arg(i + 1, 4).arg(lines[i]);
  }
  if (more) lines += QStringLiteral("      ...");
  return lines.join('\n');
}

}  // namespace

/// A file of targets, or why it could not be read.
struct ImportDialog::Table {
  QString path;
  QString text;
  QString failure;
  scene::TargetImport import;
};

QString text_of_bytes(const QByteArray& bytes) {
  QStringDecoder decode(QStringConverter::encodingForData(bytes).value_or(QStringConverter::Utf8));
  return decode(bytes);
}

namespace {

// The text of a file; nothing, and why, where there is none.
QString text_of_file(const QString& path, QString& failure) {
  if (path.isEmpty()) return {};
  QFile file(path);
  if (QFileInfo(path).isDir())
    failure = ImportDialog::tr("%1 is a folder.").arg(path);
  else if (file.size() > static_cast<qint64>(scene::largest_script_bytes))
    failure = ImportDialog::tr("%1 is too large to be a table of targets.").arg(path);
  else if (!file.open(QIODevice::ReadOnly))
    failure = ImportDialog::tr("%1 cannot be read: %2.").arg(path, file.errorString());
  else
    return text_of_bytes(file.readAll());
  return {};
}

}  // namespace

void ImportDialog::read_into(Table& table, const std::string& platform, const scene::World& world,
                             const core::StopFlag& stop, const BackgroundJob::Report& report) {
  table.text = text_of_file(table.path, table.failure);
  table.import = scene::import_targets(table.text.toStdString(), platform, world, &stop, [&](const core::Progress& p) {
    if (report) report(static_cast<double>(p.done) / static_cast<double>(p.total));
  });
  table.text.truncate(preview_characters + 1);
}

ImportDialog::ImportDialog(Session& session, QWidget* parent) : QDialog(parent), session_(session) {
  setObjectName("import_dialog");
  setWindowTitle(tr("Import targets"));
  make_widgets();
  read_file();
}

// A field that goes while it has the keyboard says once more that it is finished.
ImportDialog::~ImportDialog() { file_->disconnect(this); }

void ImportDialog::make_widgets() {
  file_ = new QLineEdit(this);
  file_->setObjectName("import_file");
  file_->setAccessibleName(tr("File of targets"));
  auto* browse_button = new QPushButton(tr("&Browse..."), this);
  browse_button->setObjectName("import_browse");
  browse_button->setAutoDefault(false);
  auto* file_row = new QHBoxLayout;
  file_row->addWidget(file_, 1);
  file_row->addWidget(browse_button);
  platform_ = new QComboBox(this);
  platform_->setObjectName("import_platform");
  platform_->setAccessibleName(tr("Platform of the targets"));
  for (const scene::Platform& platform : session_.scene().platforms)
    platform_->addItem(QString::fromStdString(platform.name));
  if (platform_->count() == 0) platform_->addItem(QStringLiteral("Earth"));
  preview_ = new QPlainTextEdit(this);
  preview_->setObjectName("import_preview");
  preview_->setAccessibleName(tr("First lines of the file"));
  preview_->setReadOnly(true);
  preview_->setTabChangesFocus(true);
  preview_->setLineWrapMode(QPlainTextEdit::NoWrap);
  preview_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  summary_ = new QLabel(this);
  summary_->setObjectName("import_summary");
  summary_->setWordWrap(true);
  bad_lines_ = new QListWidget(this);
  bad_lines_->setObjectName("import_bad_lines");
  bad_lines_->setAccessibleName(tr("Lines that cannot be read"));
  bad_lines_->setWordWrap(true);
  buttons_ = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);

  auto* form = new QFormLayout;
  auto* file_label = new QLabel(tr("&File:"), this);
  file_label->setBuddy(file_);
  form->addRow(file_label, file_row);
  form->addRow(tr("&Platform:"), platform_);
  auto* hint =
      new QLabel(tr("Columns x, y, z in metres and, if there is one, the radar cross section in square metres, "
                    "separated by blanks, tabs, commas or semicolons. A first line may name them."),
                 this);
  hint->setWordWrap(true);
  auto* preview_label = new QLabel(tr("First &lines:"), this);
  preview_label->setBuddy(preview_);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(form);
  for (QWidget* widget : std::initializer_list<QWidget*>{hint, preview_label}) layout->addWidget(widget);
  layout->addWidget(preview_, 2);
  layout->addWidget(summary_);
  layout->addWidget(bad_lines_, 1);
  layout->addWidget(buttons_);
  resize(fontMetrics().averageCharWidth() * 80, fontMetrics().height() * 32);

  connect(browse_button, &QPushButton::clicked, this, &ImportDialog::browse);
  connect(file_, &QLineEdit::editingFinished, this, [this] {
    // A field that was only looked at is no reason to begin anew.
    if (file_->text().trimmed() != wanted_->path || read_ != nullptr) read_file();
  });
  connect(&reading_, &LatestOnlyWork::progressed, this, [this](double fraction, double seconds_left) {
    summary_->setText(tr("Reading: %1").arg(share_with_time_left(fraction, seconds_left)));
  });
  connect(&reading_, &LatestOnlyWork::ended, this, [this](bool good, const QString& failure) {
    read_ = wanted_;
    if (!good) read_->failure = failure;
    show_table();
  });
  connect(platform_, &QComboBox::currentIndexChanged, this, &ImportDialog::read_file);
  add_help_button(*buttons_);
  connect(buttons_, &QDialogButtonBox::accepted, this, &ImportDialog::accept);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void ImportDialog::set_file(const QString& path) {
  file_->setText(path);
  read_file();
}

void ImportDialog::set_platform(const std::string& platform) {
  const QString name = QString::fromStdString(platform);
  if (platform_->findText(name) < 0) platform_->addItem(name);
  platform_->setCurrentIndex(platform_->findText(name));
}

void ImportDialog::browse() {
  const QString path = QFileDialog::getOpenFileName(this, tr("Import targets"), QFileInfo(file_->text()).path(),
                                                    tr("Tables (*.txt *.csv *.tsv *.xyz *.dat *.asc);;All files (*)"));
  if (!path.isEmpty()) set_file(path);
}

// A short table at once, a long one while windows are painted.
void ImportDialog::read_file() {
  reading_.cancel();
  read_ = nullptr;
  wanted_ = std::make_shared<Table>();
  wanted_->path = file_->text().trimmed();
  const auto work = [table = wanted_, platform = platform_->currentText().toStdString(),
                     world = session_.scene().world](const core::StopFlag& stop, const BackgroundJob::Report& report) {
    read_into(*table, platform, world, stop, report);
  };
  if (QFileInfo(wanted_->path).size() <= read_at_once_bytes) {
    work(core::StopFlag(), {});
    read_ = wanted_;
  } else {
    reading_.run(work);
  }
  show_table();
}

void ImportDialog::show_table() {
  const bool reading = read_ == nullptr;
  const Table none;
  const Table& table = reading ? none : *read_;
  preview_->setPlainText(first_lines(table.text));
  bad_lines_->clear();
  for (const core::Problem& problem : table.import.problems)
    bad_lines_->addItem(tr("Line %1: %2").arg(problem.place.line).arg(problem_text(problem)));
  bad_lines_->setVisible(bad_lines_->count() > 0);
  const std::size_t count = table.import.targets.size();
  if (reading)
    summary_->setText(tr("Reading …"));
  else if (!table.failure.isEmpty())
    summary_->setText(tr("Error: %1").arg(table.failure));
  else if (table.path.isEmpty())
    summary_->setText(tr("Choose a file."));
  else if (bad_lines_->count() == 0)
    summary_->setText(count == 1 ? tr("1 target.") : tr("%1 targets.").arg(count));
  else
    summary_->setText((count == 1 ? tr("1 target") : tr("%1 targets").arg(count)) +
                      (bad_lines_->count() == 1 ? tr("; 1 line is left out:")
                                                : tr("; %1 lines are left out:").arg(bad_lines_->count())));
  QPushButton* add = buttons_->button(QDialogButtonBox::Ok);
  add->setText(reading ? tr("&Add") : count == 1 ? tr("&Add 1 target") : tr("&Add %1 targets").arg(count));
  add->setEnabled(count > 0);
}

void ImportDialog::accept() {
  // Return in the field of the file name reads the file; only what was seen is added.
  if (read_ == nullptr || read_->import.targets.empty()) return;
  session_.perform(scene::add_targets(session_.scene(), std::move(read_->import.targets)));
  QDialog::accept();
}

}  // namespace sarsim::gui
