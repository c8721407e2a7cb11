#include "gui/objects/function_editor.hpp"

#include <QAction>
#include <QButtonGroup>
#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QGridLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QRadioButton>
#include <QScreen>
#include <QScrollArea>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <span>
#include <utility>

#include "core/os/output_file.hpp"
#include "gui/common/field_editor.hpp"
#include "gui/common/help_button.hpp"
#include "gui/common/problem_line.hpp"
#include "gui/objects/function_plot.hpp"
#include "gui/objects/function_table.hpp"
#include "scene/edit/edit.hpp"
#include "scene/schema/function_table.hpp"
#include "scene/script/reader.hpp"
#include "scene/script/table_file.hpp"
#include "workflow/input/function_tables.hpp"

namespace sarsim::gui {

namespace fs = std::filesystem;

namespace {

constexpr qsizetype max_problems_shown = 5;

// "Trajectory of Ship": "trajectory_of_ship.dat".
std::string file_name_for(const std::string& title) {
  std::string name;
  for (const char c : title) {
    const auto byte = static_cast<unsigned char>(c);
    name += std::isalnum(byte) != 0 ? static_cast<char>(std::tolower(byte)) : '_';
  }
  return name + ".dat";
}

bool same_points(const scene::FunctionDraft& a, const scene::FunctionDraft& b) {
  return std::ranges::equal(a.parts, b.parts, {}, &core::SampledFunction::knots, &core::SampledFunction::knots);
}

// Where a point may be added: between the two that are farthest apart.
std::size_t widest_gap(const core::SampledFunction& function) {
  std::size_t widest = 0;
  for (std::size_t i = 0; i + 1 < function.knots.size(); ++i)
    if (function.knots[i + 1].x - function.knots[i].x > function.knots[widest + 1].x - function.knots[widest].x)
      widest = i;
  return widest;
}

void append_sample(core::SampledFunction& function, const scene::FunctionInfo& info) {
  auto& knots = function.knots;
  const double x = knots.empty() ? 0.0 : knots.back().x + 1.0;
  if (!info.per_pulse && x > info.x_limits[1] && knots.size() > 1) {
    scene::insert_knot(function, widest_gap(function));
    return;
  }
  const double y = info.per_pulse && !knots.empty() ? knots.back().y : 0.0;
  knots.push_back({std::min(x, std::max(info.x_limits[1], knots.empty() ? x : knots.back().x)),
                   std::clamp(y, info.y_limits[0], info.y_limits[1])});
}

QString within(const QString& name, const std::array<double, 2>& limits, const AxisUnit& axis) {
  const auto text = [&](double value) {
    return axis_text(value, axis) + (axis.unit.empty() ? QString() : ' ' + QString::fromStdString(axis.unit));
  };
  if (std::isfinite(limits[0]) && std::isfinite(limits[1]))
    return FunctionEditor::tr("%1 must lie between %2 and %3.").arg(name, text(limits[0]), text(limits[1]));
  return std::isfinite(limits[0]) ? FunctionEditor::tr("%1 must be at least %2.").arg(name, text(limits[0]))
                                  : FunctionEditor::tr("%1 must be at most %2.").arg(name, text(limits[1]));
}

}  // namespace

FunctionEditor::FunctionEditor(Session& session, scene::ObjectId object, const std::string& field, QWidget* parent)
    : QDialog(parent),
      session_(session),
      id_(object),
      field_(field),
      object_(scene::object_of(session.scene(), object)),
      info_(scene::function_info(object_, field)),
      draft_(scene::function_of(object_, field)) {
  const core::Problems unread = take_points_of_file();
  // The editor's rule: at least one sample, in order. A function without any is 0, and so is this one.
  for (core::SampledFunction& part : draft_.parts) {
    if (part.knots.empty())
      part.knots.push_back({std::max(0.0, info_.x_limits[0]), std::clamp(0.0, info_.y_limits[0], info_.y_limits[1])});
    if (!info_.per_pulse) std::ranges::stable_sort(part.knots, {}, &core::Knot::x);
  }
  states_ = {draft_};
  make_questions();
  make_layout();
  make_undo();
  connect_points();
  show_part(0);
  if (!unread.empty()) say(core::Severity::error, {problem_text(unread.front())});
}

// A scene has the points of text files; those of HDF5 come with the other files that a run reads.
core::Problems FunctionEditor::take_points_of_file() {
  if (draft_.file.empty()) return {};
  const scene::DataFileText file = scene::disk_loader(script_folder())(draft_.file);
  if (file.failure.empty() && !scene::is_hdf5(file.text)) own_file_ = draft_.file;
  if (!file.failure.empty() || !scene::is_hdf5(file.text)) return {};
  scene::FunctionReading reading = read(file, draft_.file);
  if (core::has_errors(reading.problems)) return std::move(reading.problems);
  for (std::size_t i = 0; i < draft_.parts.size(); ++i) draft_.parts[i].knots = std::move(reading.draft.parts[i].knots);
  return {};
}

scene::FunctionReading FunctionEditor::read(const scene::DataFileText& file, const std::string& name) const {
  const scene::FunctionBlock& block = scene::function_tables::function_kind(object_, field_).block;
  return scene::read_function_file(object_, field_, workflow::read_function_data(file, block), name);
}

// A field that goes while it has the keyboard says once more that it is finished.
FunctionEditor::~FunctionEditor() {
  for (const QObject* child : findChildren<QObject*>()) child->disconnect(this);
}

void FunctionEditor::make_questions() {
  ask_unsaved = [this](const QString& file) {
    QMessageBox box(QMessageBox::Question, windowTitle(), tr("The samples are not in the file '%1'.").arg(file),
                    QMessageBox::Cancel, this);
    const QAbstractButton* save = box.addButton(tr("&Save them there"), QMessageBox::AcceptRole);
    const QAbstractButton* keep = box.addButton(tr("Keep them &inline"), QMessageBox::DestructiveRole);
    box.exec();
    if (box.clickedButton() == save) return Unsaved::save;
    return box.clickedButton() == keep ? Unsaved::keep_inline : Unsaved::cancel;
  };
  ask_replace = [this](const QString& file) {
    return QMessageBox::question(this, windowTitle(), tr("'%1' exists. Replace it?").arg(file)) == QMessageBox::Yes;
  };
}

void FunctionEditor::connect_points() {
  connect(table_, &FunctionTable::entered, this, &FunctionEditor::take_knot);
  connect(table_, &FunctionTable::refused, this, [this](const QString& why) { say(core::Severity::error, {why}); });
  connect(table_, &FunctionTable::insert_wanted, this, &FunctionEditor::insert_sample);
  connect(table_, &FunctionTable::delete_wanted, this, &FunctionEditor::delete_sample);
  connect(table_, &FunctionTable::count_wanted, this, &FunctionEditor::take_count);
  connect(table_, &FunctionTable::current_changed, this, [this] { plot_->set_current(table_->current()); });
  connect(plot_, &FunctionPlot::knot_clicked, table_, &FunctionTable::set_current);
  connect(plot_, &FunctionPlot::window_changed, this, &FunctionEditor::show_window);
  connect(plot_, &FunctionPlot::drag_began, this, [this] {
    before_drag_ = draft_;
    dragging_ = true;
  });
  connect(plot_, &FunctionPlot::dragged, this, [this](std::size_t knot, core::Knot to) {
    if (!dragging_) return;
    const std::size_t at = scene::move_knot(shown(draft_), knot, to, info_);
    plot_->set_function(shown(draft_));
    table_->show_knot(at, shown(draft_).knots[at]);
  });
  connect(plot_, &FunctionPlot::drag_ended, this, [this](std::size_t knot, core::Knot to) {
    if (!dragging_) return;
    scene::FunctionDraft next = before_drag_;
    scene::move_knot(shown(next), knot, to, info_);
    draft_ = before_drag_;
    change(std::move(next));
    table_->set_current(knot);
  });
  connect(plot_, &FunctionPlot::drag_cancelled, this, &FunctionEditor::take_drag_back);
}

// False where nothing is dragged.
bool FunctionEditor::take_drag_back() {
  if (!std::exchange(dragging_, false)) return false;
  draft_ = before_drag_;
  show_draft();
  return true;
}

void FunctionEditor::change(scene::FunctionDraft next) {
  dragging_ = false;  // What is held may be gone.
  problems_->clear();
  if (next == draft_) {
    show_draft();
    return;
  }
  states_.resize(state_ + 1);
  states_.push_back(next);
  ++state_;
  draft_ = std::move(next);
  show_draft();
}

void FunctionEditor::undo() {
  if (take_drag_back() || state_ == 0) return;
  problems_->clear();
  draft_ = states_[--state_];
  show_draft();
}

void FunctionEditor::redo() {
  if (take_drag_back() || state_ + 1 >= states_.size()) return;
  problems_->clear();
  draft_ = states_[++state_];
  show_draft();
}

void FunctionEditor::show_part(std::size_t part) {
  part_ = std::min(part, info_.parts.size() - 1);
  parts_->button(static_cast<int>(part_))->setChecked(true);
  plot_->set_info(info_, part_);
  show_draft();
  plot_->fit();
}

void FunctionEditor::show_draft() {
  const core::SampledFunction& function = draft_.parts[part_];
  table_->show_function(info_, part_, function);
  methods_->button(static_cast<int>(function.method))->setChecked(true);
  plot_->set_function(function);
  plot_->set_current(table_->current());
  show_source();
  undo_->setEnabled(state_ > 0);
  redo_->setEnabled(state_ + 1 < states_.size());
}

void FunctionEditor::show_source() {
  const bool file = !draft_.file.empty();
  (file ? in_file_ : inline_)->setChecked(true);
  if (file) file_->setText(QString::fromStdString(draft_.file));
}

void FunctionEditor::say(core::Severity severity, const QStringList& texts) {
  QStringList shown = texts.mid(0, max_problems_shown);
  if (texts.size() > shown.size()) shown += tr("and %1 more").arg(texts.size() - shown.size());
  problems_->show_texts(severity, shown);
}

// A typed point goes where its x belongs.
void FunctionEditor::take_knot(std::size_t row, core::Knot knot) {
  scene::FunctionDraft next = draft_;
  auto& knots = shown(next).knots;
  if (row >= knots.size()) return;
  const auto outside = [](double value, const std::array<double, 2>& limits) {
    return value < limits[0] || value > limits[1];
  };
  if (!info_.per_pulse && knot.x != knots[row].x && outside(knot.x, info_.x_limits))
    return say(core::Severity::error,
               {within(QString::fromStdString(info_.x_name), info_.x_limits, axis_unit(info_.x_unit))});
  if (knot.y != knots[row].y && outside(knot.y, info_.y_limits)) {
    const scene::FunctionInfo::Part& part = info_.parts[part_];
    return say(core::Severity::error,
               {within(QString::fromStdString(part.name), info_.y_limits, axis_unit(part.y_unit))});
  }
  if (info_.per_pulse) {
    knots[row].y = knot.y;
    return change(std::move(next));
  }
  knots.erase(knots.begin() + static_cast<std::ptrdiff_t>(row));
  if (std::ranges::find(knots, knot.x, &core::Knot::x) != knots.end())
    return say(core::Severity::error,
               {tr("Another sample is already at this %1.").arg(QString::fromStdString(info_.x_name).toLower())});
  const auto place = std::ranges::upper_bound(knots, knot.x, {}, &core::Knot::x);
  const auto at = static_cast<std::size_t>(place - knots.begin());
  knots.insert(place, knot);
  change(std::move(next));
  table_->set_current(at);
}

void FunctionEditor::insert_sample() {
  scene::FunctionDraft next = draft_;
  const std::size_t at = scene::insert_knot(shown(next), table_->current().value_or(0));
  if (shown(next).knots[at].x > info_.x_limits[1] && !info_.per_pulse)
    return say(core::Severity::error,
               {within(QString::fromStdString(info_.x_name), info_.x_limits, axis_unit(info_.x_unit))});
  if (shown(next).knots.size() == draft_.parts[part_].knots.size())
    return say(core::Severity::error, {tr("There is no number between this sample and the next.")});
  change(std::move(next));
  table_->set_current(at);
}

void FunctionEditor::delete_sample() {
  scene::FunctionDraft next = draft_;
  scene::remove_knot(shown(next), table_->current().value_or(0));
  change(std::move(next));
}

void FunctionEditor::take_count(int count) {
  scene::FunctionDraft next = draft_;
  auto& knots = shown(next).knots;
  const auto wanted = static_cast<std::size_t>(std::max(1, count));
  if (knots.size() > wanted) knots.resize(wanted);
  while (knots.size() < wanted) {
    const std::size_t before = knots.size();
    append_sample(shown(next), info_);
    if (knots.size() == before) break;
  }
  change(std::move(next));
}

void FunctionEditor::take_source() {
  scene::FunctionDraft next = draft_;
  if (inline_->isChecked()) {
    next.file.clear();
  } else {
    if (file_->text().trimmed().isEmpty()) file_->setText(QString::fromStdString(file_name_for(info_.title)));
    next.file = file_->text().trimmed().toStdString();
  }
  change(std::move(next));
}

void FunctionEditor::show_window() {
  const FunctionPlot::Window window = plot_->window();
  const std::array ends{window.x[0], window.x[1], window.y[0], window.y[1]};
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const double range = i < 2 ? window.x[1] - window.x[0] : window.y[1] - window.y[0];
    window_[i]->show_value(QString::fromStdString(
        scene::quantity_text(scene::rounded_to_range(ends[i], range), window_[i]->field().quantity)));
  }
}

void FunctionEditor::take_window(FieldEditor& editor, std::size_t end, const QString& text) {
  const scene::QuantityReading reading = scene::read_quantity(text.toStdString(), editor.field().quantity);
  if (!reading.value) return editor.show_failure(QString::fromStdString(reading.failure));
  FunctionPlot::Window window = plot_->window();
  (end < 2 ? window.x : window.y)[end % 2] = *reading.value;
  plot_->set_window(window);
}

fs::path FunctionEditor::script_folder() const { return session_.document().path().parent_path(); }

fs::path FunctionEditor::path_of(const QString& name) const {
  const fs::path path(name.toStdString());
  return path.is_absolute() ? path : script_folder() / path;
}

// A file beside the script is named without its folder, so that both can go elsewhere together.
void FunctionEditor::browse() {
  const QString chosen =
      QFileDialog::getSaveFileName(this, tr("Data file"), QString::fromStdString(path_of(file_->text()).string()),
                                   tr("Data files (*.dat);;All files (*)"), nullptr, QFileDialog::DontConfirmOverwrite);
  if (chosen.isEmpty()) return;
  const fs::path path(chosen.toStdString());
  const fs::path folder = fs::absolute(script_folder() / ".").parent_path();
  const bool beside = !session_.document().path().empty() && path.parent_path() == folder.lexically_normal();
  file_->setText(QString::fromStdString((beside ? path.filename() : path).string()));
  in_file_->setChecked(true);
  std::error_code failure;
  if (fs::exists(path, failure))
    load_file(file_->text());
  else
    take_source();
}

bool FunctionEditor::take_reading(scene::FunctionReading reading) {
  QStringList texts;
  for (const core::Problem& problem : core::ranked(reading.problems)) {
    QString text = problem_text(problem);
    if (problem.place.line > 0) text = tr("Line %1: %2").arg(problem.place.line).arg(text);
    texts += text;
  }
  const bool failed = core::has_errors(reading.problems);
  if (!failed) {
    for (std::size_t i = 0; i < draft_.parts.size(); ++i) reading.draft.parts[i].method = draft_.parts[i].method;
    change(std::move(reading.draft));
    plot_->fit();
  }
  if (!texts.isEmpty()) say(failed ? core::Severity::error : core::Severity::warning, texts);
  return !failed;
}

bool FunctionEditor::load_file(const QString& name) {
  const scene::DataFileText file = scene::disk_loader(script_folder())(name.toStdString());
  if (!file.failure.empty()) {
    say(core::Severity::error, {QString::fromStdString(file.failure)});
    return false;
  }
  if (!take_reading(read(file, name.toStdString()))) return false;
  own_file_ = scene::is_hdf5(file.text) ? std::string() : name.toStdString();
  return true;
}

bool FunctionEditor::import_csv(const QString& path) {
  const scene::DataFileText file = scene::disk_loader(script_folder())(path.toStdString());
  if (!file.failure.empty()) {
    say(core::Severity::error, {QString::fromStdString(file.failure)});
    return false;
  }
  return take_reading(scene::import_function_csv(object_, field_, file.text, path.toStdString()));
}

bool FunctionEditor::save_file(const QString& name) {
  if (name.trimmed().isEmpty()) {
    say(core::Severity::error, {tr("The file needs a name.")});
    return false;
  }
  const fs::path path = path_of(name.trimmed());
  std::error_code failure;
  if (name.trimmed().toStdString() != own_file_ && fs::exists(path, failure) &&
      !ask_replace(QString::fromStdString(path.string())))
    return false;
  try {
    core::OutputFile file(path, true);
    const std::string text = scene::function_file_text(object_, field_, draft_);
    file.write(std::as_bytes(std::span(text)));
    file.commit();
  } catch (const std::exception& error) {
    say(core::Severity::error, {QString::fromStdString(error.what())});
    return false;
  }
  scene::FunctionDraft next = draft_;
  next.file = own_file_ = name.trimmed().toStdString();
  change(std::move(next));
  say(core::Severity::note, {tr("Saved %1.").arg(QString::fromStdString(path.string()))});
  return true;
}

// Whether the file holds exactly these points.
bool FunctionEditor::stands_in_file() const {
  const scene::DataFileText file = scene::disk_loader(script_folder())(draft_.file);
  if (!file.failure.empty()) return false;
  const scene::FunctionReading reading = read(file, draft_.file);
  return !core::has_errors(reading.problems) && same_points(reading.draft, draft_);
}

// Enter applies what is being typed; it ends the dialog only on a button.
void FunctionEditor::keyPressEvent(QKeyEvent* event) {
  const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (enter && qobject_cast<QPushButton*>(focusWidget()) == nullptr) return event->accept();
  QDialog::keyPressEvent(event);
}

void FunctionEditor::accept() {
  scene::AnyObject changed = object_;
  scene::set_function(changed, field_, draft_);
  if (state_ == 0 || changed == object_) return QDialog::accept();
  if (!draft_.file.empty() && !stands_in_file()) {
    const Unsaved wish = ask_unsaved(QString::fromStdString(draft_.file));
    if (wish == Unsaved::cancel) return;
    if (wish == Unsaved::save && !save_file(QString::fromStdString(draft_.file))) return;
    if (wish == Unsaved::keep_inline) {
      scene::FunctionDraft next = draft_;
      next.file.clear();
      change(std::move(next));
    }
    scene::set_function(changed, field_, draft_);
  }
  if (!scene::has_object(session_.scene(), id_) || scene::object_of(session_.scene(), id_) != object_)
    return say(core::Severity::error,
               {tr("The object was changed elsewhere meanwhile. Copy what you need and cancel.")});
  session_.end_run();
  session_.perform(scene::replace_object(session_.scene(), id_, std::move(changed),
                                         tr("Change %1").arg(QString::fromStdString(info_.title)).toStdString()));
  session_.end_run();
  QDialog::accept();
}

namespace {

QToolButton* tool(const QString& text, const char* name, const QString& tip, QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setText(text);
  button->setObjectName(name);
  button->setToolTip(tip);
  button->setAccessibleName(tip);
  return button;
}

QPushButton* push(const QString& text, const char* name, const QString& tip, QWidget* parent) {
  auto* button = new QPushButton(text, parent);
  button->setObjectName(name);
  button->setToolTip(tip);
  button->setAutoDefault(false);
  return button;
}

}  // namespace

void FunctionEditor::make_layout() {
  setObjectName("function_editor");
  setWindowTitle(QString::fromStdString(info_.title));
  setAccessibleName(tr("Function editor"));
  setSizeGripEnabled(true);

  auto* controls = new QWidget(this);
  auto* column = new QVBoxLayout(controls);
  column->addWidget(make_source());
  column->addWidget(make_display());
  column->addWidget(make_interpolation());
  auto* samples = new QGroupBox(tr("Samples"), controls);
  table_ = new FunctionTable(samples);
  auto* samples_layout = new QVBoxLayout(samples);
  samples_layout->addWidget(table_);
  column->addWidget(samples, 1);
  auto* area = new QScrollArea(this);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setFocusPolicy(Qt::NoFocus);  // What is in it takes the keys.
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setWidget(controls);
  area->setMinimumWidth(controls->sizeHint().width() + fontMetrics().height() * 2);

  problems_ = new ProblemLine(this);
  problems_->setObjectName("function_problems");
  auto* split = new QSplitter(this);
  split->addWidget(area);
  split->addWidget(make_graph());
  split->setStretchFactor(1, 1);
  split->setChildrenCollapsible(false);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  buttons->setObjectName("function_buttons");
  add_help_button(*buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &FunctionEditor::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &FunctionEditor::reject);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(split, 1);
  layout->addWidget(problems_);
  layout->addWidget(buttons);
  const int letter = fontMetrics().height();
  resize(QSize(letter * 64, letter * 50).boundedTo(screen()->availableSize()));
}

QWidget* FunctionEditor::make_source() {
  auto* group = new QGroupBox(tr("Source"), this);
  inline_ = new QRadioButton(tr("In&line, in the script"), group);
  inline_->setObjectName("function_inline");
  in_file_ = new QRadioButton(tr("&File"), group);
  in_file_->setObjectName("function_in_file");
  file_ = new QLineEdit(group);
  file_->setObjectName("function_file");
  file_->setAccessibleName(tr("Name of the data file"));
  file_->setPlaceholderText(tr("Name of a .dat file"));
  auto* browse_button = push(tr("&Browse …"), "function_browse", tr("Choose the data file"), group);
  auto* load = push(tr("L&oad"), "function_load", tr("Read the samples from the file"), group);
  auto* save = push(tr("&Save"), "function_save", tr("Write the samples of all variables to the file"), group);
  auto* import =
      push(tr("Import &CSV …"), "function_import", tr("Take samples from a table: x first, then each variable"), group);
  auto* layout = new QGridLayout(group);
  layout->addWidget(inline_, 0, 0, 1, 3);
  layout->addWidget(in_file_, 1, 0);
  layout->addWidget(file_, 1, 1, 1, 2);
  layout->addWidget(browse_button, 2, 0);
  layout->addWidget(load, 2, 1);
  layout->addWidget(save, 2, 2);
  layout->addWidget(import, 3, 0, 1, 3, Qt::AlignLeft);
  connect(inline_, &QRadioButton::clicked, this, &FunctionEditor::take_source);
  connect(in_file_, &QRadioButton::clicked, this, &FunctionEditor::take_source);
  connect(file_, &QLineEdit::editingFinished, this, [this] {
    if (in_file_->isChecked() && file_->text().trimmed().toStdString() != draft_.file) take_source();
  });
  connect(file_, &QLineEdit::textEdited, this, [this] { in_file_->setChecked(true); });
  connect(browse_button, &QPushButton::clicked, this, &FunctionEditor::browse);
  connect(load, &QPushButton::clicked, this, [this] { load_file(file_->text().trimmed()); });
  connect(save, &QPushButton::clicked, this, [this] { save_file(file_->text()); });
  connect(import, &QPushButton::clicked, this, [this] {
    const QString path =
        QFileDialog::getOpenFileName(this, tr("Import CSV"), QString::fromStdString(script_folder().string()),
                                     tr("Tables (*.csv *.txt);;All files (*)"));
    if (!path.isEmpty()) import_csv(path);
  });
  return group;
}

QWidget* FunctionEditor::make_display() {
  auto* group = new QGroupBox(tr("Display"), this);
  auto* layout = new QHBoxLayout(group);
  parts_ = new QButtonGroup(this);
  for (std::size_t i = 0; i < info_.parts.size(); ++i) {
    auto* radio = new QRadioButton(QString::fromStdString(info_.parts[i].name), group);
    radio->setObjectName(QStringLiteral("function_part_%1").arg(i));
    parts_->addButton(radio, static_cast<int>(i));
    layout->addWidget(radio);
  }
  layout->addStretch(1);
  group->setVisible(info_.parts.size() > 1);
  connect(parts_, &QButtonGroup::idClicked, this, [this](int part) { show_part(static_cast<std::size_t>(part)); });
  return group;
}

QWidget* FunctionEditor::make_interpolation() {
  auto* group = new QGroupBox(tr("Interpolation"), this);
  auto* layout = new QGridLayout(group);
  methods_ = new QButtonGroup(this);
  const auto add = [&](core::Interpolation method, const QString& text, const char* name, const QString& tip) {
    const int place = layout->count();
    auto* radio = new QRadioButton(text, group);
    radio->setObjectName(name);
    radio->setToolTip(tip);
    methods_->addButton(radio, static_cast<int>(method));
    layout->addWidget(radio, place / 2, place % 2);
  };
  add(core::Interpolation::cubic, tr("C&ubic splines"), "function_cubic", tr("A smooth curve through all samples"));
  add(core::Interpolation::low_pass, tr("Low-&pass filter"), "function_low_pass",
      tr("Samples taken as impulses through a filter; may miss samples that are not evenly spaced"));
  add(core::Interpolation::linear, tr("Lin&ear"), "function_linear", tr("Straight lines between samples"));
  compare_ = new QCheckBox(tr("Co&mpare"), group);
  compare_->setObjectName("function_compare");
  compare_->setToolTip(tr("Draws the two other interpolations faintly"));
  layout->addWidget(compare_, 1, 1);
  group->setVisible(!info_.per_pulse);
  connect(methods_, &QButtonGroup::idClicked, this, [this](int method) {
    scene::FunctionDraft next = draft_;
    shown(next).method = static_cast<core::Interpolation>(method);
    change(std::move(next));
  });
  connect(compare_, &QCheckBox::toggled, this, [this](bool on) { plot_->set_compare(on); });
  return group;
}

QWidget* FunctionEditor::make_graph() {
  auto* page = new QWidget(this);
  plot_ = new FunctionPlot(page);
  struct Zoom {
    QString text;
    const char* name;
    QString tip;
    double x;
    double y;
  };
  // In: the middle half; out: double.
  const std::array<Zoom, 6> zooms{{{tr("Zoom in"), "function_zoom_in", tr("Show the middle half (+)"), 0.5, 0.5},
                                   {tr("Zoom out"), "function_zoom_out", tr("Show twice as much (-)"), 2.0, 2.0},
                                   {tr("X in"), "function_x_in", tr("Show the middle half of x"), 0.5, 1.0},
                                   {tr("X out"), "function_x_out", tr("Show twice as much of x"), 2.0, 1.0},
                                   {tr("Y in"), "function_y_in", tr("Show the middle half of y"), 1.0, 0.5},
                                   {tr("Y out"), "function_y_out", tr("Show twice as much of y"), 1.0, 2.0}}};
  auto* row = new QHBoxLayout;
  for (const Zoom& zoom : zooms) {
    QToolButton* button = tool(zoom.text, zoom.name, zoom.tip, page);
    row->addWidget(button);
    connect(button, &QToolButton::clicked, this, [this, x = zoom.x, y = zoom.y] { plot_->zoom(x, y); });
  }
  QToolButton* fit = tool(tr("Fit"), "function_fit", tr("Show all samples (Home)"), page);
  connect(fit, &QToolButton::clicked, plot_, &FunctionPlot::fit);
  row->addWidget(fit);
  row->addStretch(1);
  for (QAction** action : {&undo_, &redo_}) {
    *action = new QAction(this);
    auto* button = new QToolButton(page);
    button->setDefaultAction(*action);
    button->setObjectName(action == &undo_ ? "function_undo_button" : "function_redo_button");
    button->setAccessibleName(action == &undo_ ? tr("Undo") : tr("Redo"));
    row->addWidget(button);
  }
  auto* layout = new QVBoxLayout(page);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addLayout(row);
  layout->addWidget(plot_, 1);
  layout->addWidget(make_window_fields());
  return page;
}

QWidget* FunctionEditor::make_window_fields() {
  auto* group = new QGroupBox(tr("Window"), this);
  auto* layout = new QGridLayout(group);
  const std::array<std::string, 4> ids{"x_from", "x_to", "y_from", "y_to"};
  const std::array<QString, 4> labels{tr("X from"), tr("X to"), tr("Y from"), tr("Y to")};
  for (std::size_t i = 0; i < window_.size(); ++i) {
    scene::Field field;
    field.id = ids[i];
    field.label = labels[i].toStdString();
    field.tooltip = tr("Limits of the graph").toStdString();
    field.quantity = axis_unit(i < 2 ? info_.x_unit : info_.parts.front().y_unit).quantity;
    window_[i] = make_field_editor(field, group);
    const int row = i < 2 ? 0 : 2;
    const int column = i % 2 == 0 ? 0 : 2;
    layout->addWidget(window_[i]->label(), row, column);
    layout->addWidget(window_[i]->widget(), row, column + 1);
    layout->addWidget(window_[i]->problem_line(), row + 1, column, 1, 2);
    const auto take = [this, i](const QString& text) { take_window(*window_[i], i, text); };
    connect(window_[i], &FieldEditor::entered, this, take);
    connect(window_[i], &FieldEditor::stepped, this, take);
  }
  return group;
}

void FunctionEditor::make_undo() {
  const auto set = [this](QAction* action, const QString& text, const char* name, QKeySequence::StandardKey key,
                          void (FunctionEditor::*slot)()) {
    action->setText(text);
    action->setObjectName(name);
    action->setShortcut(key);
    action->setShortcutContext(Qt::WindowShortcut);
    addAction(action);
    connect(action, &QAction::triggered, this, slot);
  };
  set(undo_, tr("Undo"), "function_undo", QKeySequence::Undo, &FunctionEditor::undo);
  set(redo_, tr("Redo"), "function_redo", QKeySequence::Redo, &FunctionEditor::redo);
}

}  // namespace sarsim::gui
