#include "gui/runs/product_window.hpp"

#include <QCloseEvent>
#include <QComboBox>
#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTemporaryDir>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "core/report/invalid_request.hpp"
#include "core/text/shell_word.hpp"
#include "gui/common/named.hpp"
#include "gui/common/problem_line.hpp"
#include "gui/common/reserved_label.hpp"
#include "gui/common/screen_size.hpp"
#include "gui/common/text.hpp"
#include "gui/image/image_viewer.hpp"
#include "gui/image/image_viewers.hpp"
#include "gui/runs/product_kind.hpp"
#include "gui/runs/report_view.hpp"
#include "picture/live/live_request.hpp"
#include "scene/edit/document_data.hpp"
#include "scene/language/format_mark.hpp"
#include "scene/model/scene_index.hpp"
#include "scene/schema/quantity.hpp"
#include "workflow/focus/focus_options.hpp"
#include "workflow/options/option_words.hpp"

namespace sarsim::gui {

namespace {

constexpr int product_bar_steps = 1000;
constexpr std::size_t max_viewers = 8;  // that are opened for the images of one run
constexpr qsizetype max_problems = 20;  // that are shown at a time

QString quoted(const QString& word) { return QString::fromStdString(core::shell_word(word.toStdString())); }

// The words of the line, as far as they can be told apart.
QStringList words_of(const QString& line) {
  QStringList words;
  try {
    for (const std::string& word : workflow::words_of_line(line.toStdString())) words << QString::fromStdString(word);
  } catch (const core::InvalidRequest&) {
    words << line;
  }
  return words;
}

// An option and its word, unless the words behind say otherwise.
void add_unless_given(QStringList& words, const QString& option, const QString& word, const QStringList& behind) {
  const bool given = std::ranges::any_of(
      behind, [&](const QString& other) { return other == option || other.startsWith(option + '='); });
  if (!given) words << option << word;
}

}  // namespace

ProductWindow::ProductWindow(Session& session, ImageViewers& viewers, QWidget* owner)
    : QWidget(owner, Qt::Window), session_(session), viewers_(viewers) {
  setObjectName("products");
  setWindowTitle(tr("Make an image from echoes"));
  auto* const column = new QVBoxLayout(this);
  auto* const form = new QFormLayout;
  make_controls(form);
  column->addLayout(form);
  problems_ = new ProblemLine(this);
  problems_->setObjectName("products_problems");
  remarks_ = new ProblemLine(this);
  remarks_->setObjectName("products_remarks");
  column->addWidget(problems_);
  column->addWidget(remarks_);
  report_ = named(new ReportView(tr("The report appears here, the picture in a viewer of its own."), this),
                  "products_report", tr("Report"), {});
  column->addWidget(report_, 1);
  make_foot();
  connect_all();
  show_choices();
  show_simulations();
  choose_suitable();
  resize(size_on_screen(*this, {fontMetrics().averageCharWidth() * 120, fontMetrics().height() * 42}));
}

ProductWindow::~ProductWindow() { job_.disconnect(this); }

void ProductWindow::make_controls(QFormLayout* form) {
  product_ = named(new QComboBox(this), "products_kind", tr("Product"), tr("What to compute"));
  for (const ProductKind& product : product_kinds())
    product_->addItem(QCoreApplication::translate("ProductKind", product.title));
  simulation_ = named(new QComboBox(this), "products_simulation", tr("Simulation"), tr("Recording to Process"));
  choice_ = named(new QComboBox(this), "products_choice", tr("Choice"), {});
  choice_title_ = new QLabel(this);
  choice_title_->setBuddy(choice_);
  weighting_ = named(new QComboBox(this), "products_window", tr("Window"),
                     tr("Weighting of range and azimuth, or of the pulses: lower sidelobes for wider peaks"));
  for (const char* name : workflow::window_words) weighting_->addItem(name);
  more_ = named(new QLineEdit(this), "products_more", tr("More options"),
                tr("As on the command line, for instance: --memory 2G; quotes around words with spaces"));
  more_->setPlaceholderText(tr("as on the command line"));
  command_ =
      named(new QLineEdit(this), "products_command", tr("Command"), tr("Does the same from a terminal or a script"));
  command_->setReadOnly(true);
  form->addRow(tr("&Product"), product_);
  form->addRow(tr("&Simulation"), simulation_);
  form->addRow(choice_title_, choice_);
  form->addRow(tr("&Window"), weighting_);
  form->addRow(tr("More &options"), more_);
  form->addRow(tr("&Command"), command_);
}

void ProductWindow::make_foot() {
  auto* const foot = new QHBoxLayout;
  state_ = new ReservedLabel(2, this);
  state_->setObjectName("products_state");
  bar_ = named(new QProgressBar(this), "products_progress", tr("Progress"), {});
  bar_->setRange(0, product_bar_steps);
  bar_->hide();
  make_ = named(new QPushButton(tr("&Make"), this), "products_make", tr("Make"), tr("Compute and open the result"));
  stop_ = named(new QPushButton(tr("S&top"), this), "products_stop", tr("Stop"), tr("End the work at once"));
  stop_->setEnabled(false);
  foot->addWidget(state_, 2);
  foot->addWidget(bar_, 1);
  foot->addWidget(make_);
  foot->addWidget(stop_);
  static_cast<QVBoxLayout*>(layout())->addLayout(foot);
}

void ProductWindow::connect_all() {
  connect(product_, &QComboBox::currentIndexChanged, this, &ProductWindow::show_choices);
  for (QComboBox* box : {simulation_, choice_, weighting_})
    connect(box, &QComboBox::currentIndexChanged, this, &ProductWindow::show_command);
  connect(more_, &QLineEdit::textChanged, this, &ProductWindow::show_command);
  connect(make_, &QPushButton::clicked, this, &ProductWindow::make);
  connect(stop_, &QPushButton::clicked, this, &ProductWindow::stop);
  connect(&job_, &ProductJob::progressed, this, &ProductWindow::show_progress);
  connect(&job_, &ProductJob::announced, this, [this](const QString& line) {
    if (!stopped_) state_->say(within_folder(line));
  });
  connect(&job_, &ProductJob::ended, this, &ProductWindow::take_end);
  connect(&session_, &Session::scene_changed, this, &ProductWindow::show_simulations);
  connect(&session_, &Session::document_changed, this, &ProductWindow::show_command);
  connect(&session_, &Session::document_replaced, this, [this] {
    choose_suitable();
    forget_result();
  });
}

// What the first recording of another scene is for.
void ProductWindow::choose_suitable() {
  if (busy() || session_.scene().simulations.empty()) return;
  const std::string_view command = picture::command_of(picture::suitable_product(session_.scene(), 0));
  const auto kinds = product_kinds();
  const auto at = std::ranges::find(kinds, command, &ProductKind::command);
  if (at != kinds.end()) product_->setCurrentIndex(static_cast<int>(at - kinds.begin()));
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
  choice_title_->setText(QCoreApplication::translate("ProductKind", kind().option_title));
  {
    const QSignalBlocker quiet(choice_);
    choice_->clear();
    for (const char* value : kind().values) choice_->addItem(value);
  }
  choice_->setAccessibleName(choice_title_->text());
  show_command();
}

const ProductKind& ProductWindow::kind() const {
  return product_kinds()[static_cast<std::size_t>(product_->currentIndex())];
}

// The options that are chosen; those that are typed take the place of the others.
QStringList ProductWindow::chosen_words() const {
  const QStringList more = words_of(more_->text());
  QStringList words;
  if (simulation_->currentIndex() > 0)
    add_unless_given(words, "--simulation", QString::number(simulation_->currentIndex() + 1), more);
  add_unless_given(words, kind().option, choice_->currentText(), more);
  add_unless_given(words, "--window", weighting_->currentText(), more);
  return words + more;
}

QString ProductWindow::command() const {
  const std::filesystem::path path = session_.document().path();
  const std::string usual = "scene." + scene::usual_ending(session_.document().text());
  const QString script = QString::fromStdString(path.empty() ? usual : path.filename().string());
  QStringList words{"sarsim", kind().command, quoted(script)};
  for (const QString& word : chosen_words()) words << quoted(word);
  return (words << "--out" << quoted(QFileInfo(script).completeBaseName() + "_" + kind().command + ".npy")).join(' ');
}

void ProductWindow::show_command() {
  command_->setText(command());
  command_->setCursorPosition(0);
  make_->setEnabled(!busy() && simulation_->count() > 0);
  if (!busy()) state_->say(simulation_->count() > 0 ? QString() : tr("The scene has no stored simulation yet"));
}

// Throws core::InvalidRequest where an option is typed that there is not, or whose word it does not take.
workflow::GivenWords ProductWindow::given_words() const {
  static_cast<void>(workflow::words_of_line(more_->text().toStdString()));
  std::vector<std::string> words;
  for (const QString& word : chosen_words()) words.push_back(word.toStdString());
  workflow::GivenWords given = workflow::given_words(kind().options(), words);
  const std::string out = folder_->filePath(QString(kind().command) + ".npy").toStdString();
  if (given.contains("--out"))
    throw core::InvalidRequest("--out: the image goes to a viewer", "leave it out, and export the image there");
  given.emplace("--out", out);
  return given;
}

// Names of data files may lead out of the folder, to files of others: the scene is written without any.
std::string ProductWindow::write_scene() {
  const std::string text = scene::self_contained_script(session_.document());
  lines_are_known_ = text == session_.document().text();
  script_ = folder_->filePath(QString::fromStdString("scene." + scene::usual_ending(text)));
  QFile file(script_);
  if (!file.open(QIODevice::WriteOnly) || file.write(text.data(), static_cast<qint64>(text.size())) < 0 ||
      !file.flush())
    throw std::runtime_error(
        tr("the scene could not be written for the work: %1").arg(file.errorString()).toStdString());
  return script_.toStdString();
}

void ProductWindow::make() {
  if (busy()) return;
  problems_->clear();
  remarks_->clear();
  report_->clear();
  stopped_ = false;
  title_ = name_of_image();
  folder_ = std::make_shared<QTemporaryDir>();
  try {
    const workflow::GivenWords given = given_words();
    job_.start(kind().work(write_scene(), given));
  } catch (const core::InvalidRequest& refused) {
    fail(texts_of(refused.problems));
    return;
  } catch (const std::exception& failure) {
    fail({tr("Error: %1").arg(failure.what())});
    return;
  }
  make_->setEnabled(false);
  stop_->setEnabled(true);
  bar_->setValue(0);
  bar_->show();
  state_->say(tr("Working…"));
}

void ProductWindow::stop() {
  if (!busy()) return;
  stopped_ = true;
  state_->say(tr("Stopping…"));
  job_.stop();
}

void ProductWindow::closeEvent(QCloseEvent* event) {
  stop();
  QWidget::closeEvent(event);
}

// The folder is of no interest, and gone soon.
QString ProductWindow::within_folder(const QString& words) const {
  return folder_ ? QString(words).remove(folder_->path() + '/') : words;
}

QStringList ProductWindow::texts_of(const core::Problems& problems) const {
  QStringList texts;
  for (const core::Problem& problem : problems) {
    if (texts.size() == max_problems) {
      texts << tr("and %1 more").arg(static_cast<qsizetype>(problems.size()) - max_problems);
      break;
    }
    const QString text = lines_are_known_ ? placed_problem_text(problem, script_.toStdString()) : problem_text(problem);
    texts << within_folder(text);
  }
  return texts;
}

void ProductWindow::show_progress(const QString& stage, double fraction, double seconds_left) {
  if (stopped_) return;
  bar_->setValue(static_cast<int>(fraction * product_bar_steps));
  state_->say(with_time_left(within_folder(stage), seconds_left));
}

void ProductWindow::take_end(JobEnd end, const QString& failure) {
  if (end == JobEnd::done)
    show_result();
  else if (end == JobEnd::cancelled)
    end_with(tr("Stopped; nothing was kept"), false);
  else
    fail(job_.refusals().empty() ? QStringList{tr("Error: %1").arg(within_folder(failure))}
                                 : texts_of(job_.refusals()));
}

void ProductWindow::show_result() {
  const ProductResult& result = job_.result();
  report_->show_pages(result.pages);
  if (!result.problems.empty()) remarks_->show_texts(result.problems.front().severity, texts_of(result.problems));
  open_images(result.images);
  const std::size_t count = result.images.size();
  end_with(count > max_viewers ? tr("Done; the first %1 of %2 images are shown").arg(max_viewers).arg(count)
           : count == 0        ? tr("Done; no image was wanted")
                               : tr("Done"),
           true);
}

// "sar_r, Radar1, PRF 620 Hz": what tells two images of one kind apart.
QString ProductWindow::name_of_image() const {
  const std::filesystem::path path = session_.document().path();
  QStringList parts{path.empty() ? tr("New scene") : QString::fromStdString(path.stem().string())};
  const scene::Scene& scene = session_.scene();
  const auto number = static_cast<std::size_t>(std::max(0, simulation_->currentIndex()));
  if (number >= scene.simulations.size()) return parts.first();
  const std::size_t radar = scene::find_radar(scene, scene.simulations[number].radar);
  if (radar == scene::not_found) return parts.first();
  parts << QString::fromStdString(scene.radars[radar].name)
        << tr("PRF %1").arg(
               QString::fromStdString(scene::quantity_text(scene.radars[radar].prf_hz, scene::Quantity::frequency)));
  return parts.join(", ");
}

// The viewer that shows the image before of the same kind, unless the user keeps that; otherwise a new one.
ImageViewer* ProductWindow::viewer_for(std::size_t number) {
  QPointer<ImageViewer>& shown = shown_[{kind().command, number}];
  if (shown.isNull() || shown->kept()) shown = viewers_.open_empty();
  return shown;
}

// The files go when the last viewer of them does, or shows others.
void ProductWindow::open_images(const std::vector<std::filesystem::path>& images) {
  const std::size_t count = std::min(images.size(), max_viewers);
  for (std::size_t i = 0; i < count; ++i) {
    ImageViewer* const viewer = viewer_for(i);
    viewer->set_name(images.size() > 1 ? tr("%1, %2 of %3").arg(title_).arg(i + 1).arg(images.size()) : title_);
    viewers_.show_file(*viewer, images[i]);
    disconnect(viewer, &QObject::destroyed, this, nullptr);
    files_of_[viewer] = folder_;
    connect(viewer, &QObject::destroyed, this, [this, viewer] { files_of_.erase(viewer); });
  }
}

// What was said of another scene.
void ProductWindow::forget_result() {
  if (busy()) return;
  problems_->clear();
  remarks_->clear();
  report_->clear();
  shown_.clear();
  show_command();
}

void ProductWindow::fail(const QStringList& words) {
  problems_->show_texts(core::Severity::error, words);
  end_with(tr("Nothing was made"), false);
}

void ProductWindow::end_with(const QString& state, bool made) {
  folder_.reset();
  bar_->hide();
  stop_->setEnabled(false);
  make_->setEnabled(simulation_->count() > 0);
  state_->say(state);
  emit ended(made);
}

}  // namespace sarsim::gui
