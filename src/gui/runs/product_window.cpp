#include "gui/runs/product_window.hpp"

#include <QComboBox>
#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QFontDatabase>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalBlocker>
#include <QTemporaryDir>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "gui/common/named.hpp"
#include "gui/common/problem_line.hpp"
#include "gui/image/image_viewer.hpp"
#include "gui/image/image_viewers.hpp"
#include "scene/edit/document_data.hpp"

namespace sarsim::gui {

namespace {

// A command of sarsim that makes something to look at, and its most important choice.
struct ProductKind {
  const char* command;
  const char* title;
  const char* option;
  const char* option_title;
  std::array<const char*, 4> values;
};

constexpr std::array products{ProductKind{"focus",
                                          QT_TRANSLATE_NOOP("ProductKind", "Focused image (synthetic aperture)"),
                                          "--algorithm",
                                          QT_TRANSLATE_NOOP("ProductKind", "Algorithm"),
                                          {"omega-k", "range-doppler", "chirp-scaling", "back-projection"}},
                              ProductKind{"profiles",
                                          QT_TRANSLATE_NOOP("ProductKind", "Range profiles of stepped frequencies"),
                                          "--set",
                                          QT_TRANSLATE_NOOP("ProductKind", "A profile for"),
                                          {"bursts", "scans", "encounter", nullptr}},
                              ProductKind{"isar",
                                          QT_TRANSLATE_NOOP("ProductKind", "Image of a turning target"),
                                          "--algorithm",
                                          QT_TRANSLATE_NOOP("ProductKind", "Algorithm"),
                                          {"range-doppler", "back-projection", nullptr, nullptr}},
                              ProductKind{"doppler",
                                          QT_TRANSLATE_NOOP("ProductKind", "Range-Doppler maps"),
                                          "--canceller",
                                          QT_TRANSLATE_NOOP("ProductKind", "Canceller"),
                                          {"none", "two", "three", nullptr}},
                              ProductKind{"search",
                                          QT_TRANSLATE_NOOP("ProductKind", "Search picture (PPI)"),
                                          "--canceller",
                                          QT_TRANSLATE_NOOP("ProductKind", "Canceller"),
                                          {"none", "two", "three", nullptr}}};
constexpr std::array weightings{"rectangular", "hamming", "hann", "kaiser", "taylor"};
constexpr int patience_ms = 3000;

// The command-line program: the one beside this, or the one that the system finds.
QString program() {
  const QString beside = QCoreApplication::applicationDirPath() + "/sarsim";
  return QFileInfo(beside).isExecutable() ? beside : QStringLiteral("sarsim");
}

QString quoted(const QString& word) {
  static const QRegularExpression plain("^[A-Za-z0-9_./:=,+-]+$");
  return plain.match(word).hasMatch() ? word : "'" + QString(word).replace("'", "'\\''") + "'";
}

}  // namespace

ProductWindow::ProductWindow(Session& session, ImageViewers& viewers, QWidget* owner)
    : QWidget(owner, Qt::Window), session_(session), viewers_(viewers), process_(this) {
  setObjectName("products");
  setWindowTitle(tr("Make an image from echoes"));
  auto* const column = new QVBoxLayout(this);
  auto* const form = new QFormLayout;
  make_controls(form);
  column->addLayout(form);
  problems_ = new ProblemLine(this);
  problems_->setObjectName("products_problems");
  column->addWidget(problems_);
  report_ = named(new QPlainTextEdit(this), "products_report", tr("Report"), tr("What the command says of its result"));
  report_->setReadOnly(true);
  report_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  report_->setLineWrapMode(QPlainTextEdit::NoWrap);
  report_->setPlaceholderText(tr("The report appears here, the picture in a viewer of its own."));
  column->addWidget(report_, 1);
  make_foot();
  connect(&process_, &QProcess::readyReadStandardError, this, &ProductWindow::take_errors);
  connect(&process_, &QProcess::finished, this, &ProductWindow::take_end);
  connect(&process_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error == QProcess::FailedToStart)
      fail({tr("Error: the program 'sarsim' could not be started; expected it beside this one or in the search path")});
  });
  connect(&session_, &Session::scene_changed, this, &ProductWindow::show_simulations);
  connect(&session_, &Session::document_changed, this, &ProductWindow::show_command);
  show_choices();
  show_simulations();
  resize(760, 560);
}

ProductWindow::~ProductWindow() {
  process_.disconnect(this);
  if (!busy()) return;
  process_.terminate();
  if (!process_.waitForFinished(patience_ms)) process_.kill();
  process_.waitForFinished(patience_ms);
}

void ProductWindow::make_controls(QFormLayout* form) {
  product_ = named(new QComboBox(this), "products_kind", tr("ProductKind"), tr("What is made from the echoes"));
  for (const ProductKind& product : products)
    product_->addItem(QCoreApplication::translate("ProductKind", product.title));
  simulation_ = named(new QComboBox(this), "products_simulation", tr("Simulation"), tr("Whose echoes are used"));
  choice_ = named(new QComboBox(this), "products_choice", tr("Choice"), {});
  choice_title_ = new QLabel(this);
  choice_title_->setBuddy(choice_);
  weighting_ = named(new QComboBox(this), "products_window", tr("Window"),
                     tr("Weighting of range and azimuth, or of the pulses: lower sidelobes for wider peaks"));
  for (const char* name : weightings) weighting_->addItem(name);
  more_ = named(new QLineEdit(this), "products_more", tr("More options"),
                tr("As on the command line, for instance: --memory 2G; double quotes around words with spaces"));
  more_->setPlaceholderText(tr("as on the command line"));
  command_ =
      named(new QLineEdit(this), "products_command", tr("Command"), tr("Does the same from a terminal or a script"));
  command_->setReadOnly(true);
  form->addRow(tr("&ProductKind"), product_);
  form->addRow(tr("&Simulation"), simulation_);
  form->addRow(choice_title_, choice_);
  form->addRow(tr("&Window"), weighting_);
  form->addRow(tr("More &options"), more_);
  form->addRow(tr("&Command"), command_);
  connect(product_, &QComboBox::currentIndexChanged, this, &ProductWindow::show_choices);
  for (QComboBox* box : {simulation_, choice_, weighting_})
    connect(box, &QComboBox::currentIndexChanged, this, &ProductWindow::show_command);
  connect(more_, &QLineEdit::textChanged, this, &ProductWindow::show_command);
}

void ProductWindow::make_foot() {
  auto* const foot = new QHBoxLayout;
  state_ = new QLabel(this);
  state_->setObjectName("products_state");
  make_ = named(new QPushButton(tr("&Make"), this), "products_make", tr("Make"), tr("Compute and open the result"));
  stop_ = named(new QPushButton(tr("S&top"), this), "products_stop", tr("Stop"), tr("End the command at once"));
  stop_->setEnabled(false);
  foot->addWidget(state_, 1);
  foot->addWidget(make_);
  foot->addWidget(stop_);
  static_cast<QVBoxLayout*>(layout())->addLayout(foot);
  connect(make_, &QPushButton::clicked, this, &ProductWindow::make);
  connect(stop_, &QPushButton::clicked, this, &ProductWindow::stop);
}

// The simulations of the scene, by number and radar; the chosen number stays.
void ProductWindow::show_simulations() {
  const int chosen = std::max(0, simulation_->currentIndex());
  const QSignalBlocker quiet(simulation_);
  simulation_->clear();
  for (std::size_t i = 0; i < session_.scene().simulations.size(); ++i)
    simulation_->addItem(tr("%1: %2").arg(i + 1).arg(QString::fromStdString(session_.scene().simulations[i].radar)));
  simulation_->setCurrentIndex(std::min(chosen, simulation_->count() - 1));
  show_command();
}

void ProductWindow::show_choices() {
  const ProductKind& product = products[static_cast<std::size_t>(product_->currentIndex())];
  choice_title_->setText(QCoreApplication::translate("ProductKind", product.option_title));
  {
    const QSignalBlocker quiet(choice_);
    choice_->clear();
    for (const char* value : product.values)
      if (value != nullptr) choice_->addItem(value);
  }
  choice_->setAccessibleName(choice_title_->text());
  show_command();
}

QStringList ProductWindow::arguments(const QString& script, const QString& out) const {
  const ProductKind& product = products[static_cast<std::size_t>(product_->currentIndex())];
  QStringList words{product.command, script};
  if (simulation_->currentIndex() > 0) words << "--simulation" << QString::number(simulation_->currentIndex() + 1);
  words << product.option << choice_->currentText() << "--window" << weighting_->currentText();
  words << QProcess::splitCommand(more_->text());
  return words << "--out" << out;
}

QString ProductWindow::command() const {
  const std::filesystem::path path = session_.document().path();
  const QString script = path.empty() ? QStringLiteral("scene.scr") : QString::fromStdString(path.filename().string());
  QStringList words{"sarsim"};
  const QString kind = products[static_cast<std::size_t>(product_->currentIndex())].command;
  for (const QString& word : arguments(script, QFileInfo(script).completeBaseName() + "_" + kind + ".npy"))
    words << quoted(word);
  return words.join(' ');
}

void ProductWindow::show_command() {
  command_->setText(command());
  command_->setCursorPosition(0);
  make_->setEnabled(!busy() && simulation_->count() > 0);
  if (!busy()) state_->setText(simulation_->count() > 0 ? QString() : tr("The scene has no stored simulation yet"));
}

void ProductWindow::make() {
  if (busy()) return;
  problems_->clear();
  report_->clear();
  errors_.clear();
  stopped_ = false;
  folder_ = std::make_shared<QTemporaryDir>();
  const QString script = folder_->filePath("scene.scr");
  made_ = folder_->filePath(QString(products[static_cast<std::size_t>(product_->currentIndex())].command) + ".npy");
  try {
    // Names of data files may lead out of the folder, to files of others.
    const std::string text = scene::self_contained_script(session_.document());
    QFile file(script);
    if (!file.open(QIODevice::WriteOnly) || file.write(text.data(), static_cast<qint64>(text.size())) < 0)
      throw std::runtime_error(file.errorString().toStdString());
    file.close();
  } catch (const std::exception& failure) {
    fail({tr("Error: the scene could not be written for the command: %1").arg(failure.what())});
    return;
  }
  make_->setEnabled(false);
  stop_->setEnabled(true);
  state_->setText(tr("Working…"));
  process_.start(program(), arguments(script, made_));
}

void ProductWindow::stop() {
  if (!busy()) return;
  stopped_ = true;
  process_.terminate();
}

// Progress comes as lines; the last one counts.
void ProductWindow::take_errors() {
  const QString more = QString::fromUtf8(process_.readAllStandardError());
  errors_ += more;
  const QStringList lines = errors_.split(QRegularExpression("[\r\n]"), Qt::SkipEmptyParts);
  if (!lines.isEmpty() && !stopped_) state_->setText(lines.back().trimmed());
}

void ProductWindow::take_end(int status, QProcess::ExitStatus how) {
  take_errors();
  stop_->setEnabled(false);
  make_->setEnabled(simulation_->count() > 0);
  report_->setPlainText(QString::fromUtf8(process_.readAllStandardOutput()));
  if (stopped_) {
    state_->setText(tr("Stopped; nothing was kept"));
    emit ended(false);
    return;
  }
  if (how != QProcess::NormalExit || status != 0 || !QFileInfo::exists(made_)) {
    QStringList words = errors_.trimmed().split('\n', Qt::SkipEmptyParts);
    if (words.isEmpty()) words << tr("Error: the command ended with status %1 and said nothing").arg(status);
    fail(words);
    return;
  }
  if (report_->toPlainText().trimmed().isEmpty()) report_->setPlainText(errors_.trimmed());
  state_->setText(tr("Done"));
  ImageViewer* const viewer = viewers_.open_file(made_.toStdString());
  viewer->setWindowTitle(product_->currentText());
  // The files go when the viewer does.
  connect(viewer, &QObject::destroyed, this, [folder = std::move(folder_)] {});
  emit ended(true);
}

void ProductWindow::fail(const QStringList& words) {
  problems_->show_texts(core::Severity::error, words);
  state_->setText(tr("Nothing was made"));
  stop_->setEnabled(false);
  make_->setEnabled(simulation_->count() > 0);
  emit ended(false);
}

}  // namespace sarsim::gui
