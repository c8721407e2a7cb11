#include "gui/scene/geometry_window.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSplitter>
#include <QVBoxLayout>

#include <algorithm>
#include <span>
#include <stdexcept>

#include "core/os/output_file.hpp"
#include "gui/common/field_editor.hpp"
#include "gui/common/problem_line.hpp"
#include "gui/common/text.hpp"
#include "gui/scene/geometry_model.hpp"
#include "gui/scene/geometry_view.hpp"
#include "scene/edit/edit.hpp"
#include "scene/schema/fields.hpp"

namespace sarsim::gui {

namespace {

constexpr int recompute_ms = 80;
constexpr std::size_t targets_at_first = 50;

scene::GeometryTable table_at_first(const Session& session) {
  scene::GeometryTable table;
  const scene::Scene& scene = session.scene();
  if (scene.radars.empty()) return table;
  const auto current = session.current();
  const bool on_radar = current && current->kind == scene::ObjectKind::radar && scene::has_object(scene, *current);
  table.radar = scene.radars[on_radar ? current->index : 0].name;
  return table;
}

QPushButton* named_button(const QString& label, const char* name, const QString& tip, QWidget* parent) {
  auto* button = new QPushButton(label, parent);
  button->setObjectName(name);
  button->setToolTip(tip);
  button->setAccessibleName(tip);
  return button;
}

}  // namespace

GeometryWindow::GeometryWindow(Session& session, QWidget* parent)
    : QWidget(parent), session_(session), model_(new GeometryModel(this)), view_(new GeometryView(model_, this)) {
  setObjectName("geometry_window");
  setAccessibleName(tr("Geometry"));
  setWindowTitle(tr("Geometry"));
  choice_.table = table_at_first(session_);

  auto* area = new QScrollArea(this);
  area->setWidgetResizable(true);
  area->setFocusPolicy(Qt::NoFocus);  // What is in it takes the keys.
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setWidget(make_controls());
  area->setMinimumWidth(area->widget()->sizeHint().width() + fontMetrics().height() * 2);
  state_ = new QLabel(this);
  state_->setObjectName("geometry_state");
  problems_ = new ProblemLine(this);
  problems_->setObjectName("geometry_problems");
  auto* right = new QWidget(this);
  auto* right_layout = new QVBoxLayout(right);
  right_layout->setContentsMargins(0, 0, 0, 0);
  right_layout->addWidget(view_, 1);
  right_layout->addWidget(problems_);
  right_layout->addWidget(make_save_row());
  auto* split = new QSplitter(this);
  split->addWidget(area);
  split->addWidget(right);
  split->setStretchFactor(1, 1);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(split, 1);

  connect_all();
  follow_scene();
  resize(fontMetrics().averageCharWidth() * 180, fontMetrics().height() * 46);
}

// A field that goes while it has the keyboard says once more that it is finished.
GeometryWindow::~GeometryWindow() {
  for (const QObject* child : findChildren<QObject*>()) child->disconnect(this);
}

void GeometryWindow::connect_all() {
  debounce_.setSingleShot(true);
  debounce_.setInterval(recompute_ms);
  connect(&debounce_, &QTimer::timeout, this, &GeometryWindow::compute);
  connect(model_, &GeometryModel::ready, this, &GeometryWindow::show_ready);
  connect(model_, &GeometryModel::failed, this, [this](const QString& text) {
    save_->setEnabled(false);
    state_->setText(tr("No table"));
    problems_->show_texts(core::Severity::error, text.split('\n'));
  });
  connect(&job_, &BackgroundJob::progressed, this, [this](double fraction, double left_s) {
    bar_->setValue(static_cast<int>(fraction * bar_steps));
    state_->setText(with_time_left(tr("Saving"), left_s));
  });
  connect(&job_, &BackgroundJob::ended, this, &GeometryWindow::show_saved);
  connect(&session_, &Session::scene_changed, this, [this](const scene::SceneChange& change) {
    if (!change.empty()) follow_scene();
  });
  connect(&session_, &Session::document_replaced, this, [this] {
    choice_.table = table_at_first(session_);
    targets_typed_ = false;
  });
}

QWidget* GeometryWindow::make_controls() {
  auto* page = new QWidget(this);
  auto* layout = new QVBoxLayout(page);
  layout->addWidget(make_stored_row());
  add_fields(page);
  layout->addStretch(1);
  return page;
}

QWidget* GeometryWindow::make_stored_row() {
  auto* group = new QGroupBox(tr("Stored in the script"), this);
  stored_ = new QComboBox(group);
  stored_->setObjectName("geometry_stored");
  stored_->setAccessibleName(tr("Stored geometry tables"));
  stored_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  show_stored_ = named_button(tr("S&how"), "geometry_show_stored", tr("Show the stored table"), group);
  delete_stored_ =
      named_button(tr("De&lete"), "geometry_delete_stored", tr("Take the stored table out of the script"), group);
  auto* layout = new QVBoxLayout(group);
  auto* row = new QHBoxLayout;
  layout->addWidget(stored_);
  row->addWidget(show_stored_);
  row->addWidget(delete_stored_);
  row->addStretch(1);
  layout->addLayout(row);
  connect(show_stored_, &QPushButton::clicked, this, &GeometryWindow::show_stored);
  connect(delete_stored_, &QPushButton::clicked, this, &GeometryWindow::delete_stored);
  return group;
}

// The fields of a geometry table, group by group, then what only this window knows: the targets to look at.
void GeometryWindow::add_fields(QWidget* page) {
  QFormLayout* form = nullptr;
  QString group_name;
  for (const scene::Field& field : scene::fields_of(scene::ObjectKind::geometry)) {
    const QString name = QString::fromStdString(field.group);
    if (form == nullptr || name != group_name) {
      group_name = name;
      auto* group = new QGroupBox(name, page);
      form = new QFormLayout(group);
      page->layout()->addWidget(group);
    }
    FieldEditor* editor = make_field_editor(field, form->parentWidget());
    if (editor->label() != nullptr)
      form->addRow(editor->label(), editor->widget());
    else
      form->addRow(editor->widget());
    form->addRow(editor->problem_line());
    fields_.push_back(editor);
    const auto take = [this, editor](const QString& text) { take_entry(*editor, text); };
    connect(editor, &FieldEditor::entered, this, take);
    connect(editor, &FieldEditor::stepped, this, take);
  }
  auto* group = new QGroupBox(tr("Targets"), page);
  form = new QFormLayout(group);
  page->layout()->addWidget(group);
  distance_ = new QCheckBox(tr("Target distance (m)"), group);
  distance_->setObjectName("geometry_distance");
  distance_->setToolTip(tr("One-way distance; on screen and in CSV files, not a column of the script's tables"));
  targets_ = new QLineEdit(group);
  targets_->setObjectName("geometry_targets");
  targets_->setAccessibleName(tr("Numbers of the targets shown"));
  targets_->setToolTip(tr("Numbers and ranges of targets, such as 1-20, 35; saved files hold all of them"));
  targets_problem_ = new ProblemLine(group);
  auto* label = new QLabel(tr("Show &targets"), group);
  label->setBuddy(targets_);
  form->addRow(distance_);
  form->addRow(label, targets_);
  form->addRow(targets_problem_);
  connect(distance_, &QCheckBox::toggled, this, [this](bool on) {
    choice_.distance = on;
    debounce_.start();
  });
  connect(targets_, &QLineEdit::editingFinished, this, &GeometryWindow::take_targets);
}

QWidget* GeometryWindow::make_save_row() {
  auto* row = new QWidget(this);
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* label = new QLabel(tr("&Go to pulse"), row);
  pulse_ = new QLineEdit(row);
  pulse_->setObjectName("geometry_pulse");
  pulse_->setAccessibleName(tr("Number of the pulse to show"));
  label->setBuddy(pulse_);
  bar_ = new QProgressBar(row);
  bar_->setObjectName("geometry_progress");
  bar_->setAccessibleName(tr("Progress of saving"));
  bar_->setRange(0, bar_steps);
  bar_->setVisible(false);
  cancel_ = named_button(tr("Cancel"), "geometry_cancel", tr("Stop saving"), row);
  cancel_->setVisible(false);
  save_ = named_button(tr("&Save …"), "geometry_save", tr("Save the table as text or CSV"), row);
  QPushButton* store = named_button(tr("To s&cript"), "geometry_to_script", tr("Store this table in the script"), row);
  layout->addWidget(label);
  layout->addWidget(pulse_);
  layout->addWidget(state_, 1);
  layout->addWidget(bar_);
  layout->addWidget(cancel_);
  layout->addWidget(save_);
  layout->addWidget(store);
  connect(pulse_, &QLineEdit::returnPressed, this, &GeometryWindow::go_to_pulse);
  connect(cancel_, &QPushButton::clicked, &job_, &BackgroundJob::cancel);
  connect(save_, &QPushButton::clicked, this, &GeometryWindow::save_as);
  connect(store, &QPushButton::clicked, this, &GeometryWindow::to_script);
  return row;
}

void GeometryWindow::take_entry(FieldEditor& editor, const QString& text) {
  scene::AnyObject object = choice_.table;
  const std::string failure = scene::set_field(object, editor.field().id, text.toStdString());
  if (!failure.empty()) {
    editor.show_failure(QString::fromStdString(failure));
    return;
  }
  choice_.table = std::get<scene::GeometryTable>(object);
  editor.show_value(QString::fromStdString(scene::field_text(object, editor.field().id)));
  debounce_.start();
}

void GeometryWindow::take_targets() {
  const NumberChoice read = read_numbers(targets_->text().toStdString(), session_.scene().targets.size());
  if (!read.failure.empty()) {
    targets_problem_->show_texts(core::Severity::error, {QString::fromStdString(read.failure)});
    return;
  }
  targets_problem_->clear();
  if (targets_->isModified()) targets_typed_ = true;
  if (choice_.targets == read.indices) return;
  choice_.targets = read.indices;
  debounce_.start();
}

void GeometryWindow::show_fields() {
  const scene::AnyObject object = choice_.table;
  QStringList radars;
  for (const scene::Radar& radar : session_.scene().radars) radars += QString::fromStdString(radar.name);
  for (FieldEditor* editor : fields_) {
    if (editor->field().kind == scene::FieldKind::radar) editor->set_choices(radars);
    editor->show_value(QString::fromStdString(scene::field_text(object, editor->field().id)));
  }
}

void GeometryWindow::show_table(const scene::GeometryTable& table) {
  choice_.table = table;
  show_fields();
  compute();
}

void GeometryWindow::refresh_stored() {
  const int row = stored_->currentIndex();
  const std::vector<scene::GeometryTable>& tables = session_.scene().geometries;
  stored_->clear();
  for (const scene::GeometryTable& table : tables)
    stored_->addItem(tr("%1: %2").arg(QString::fromStdString(table.file), QString::fromStdString(table.radar)));
  if (!tables.empty()) stored_->setCurrentIndex(std::clamp(row, 0, stored_->count() - 1));
  for (QWidget* widget :
       {static_cast<QWidget*>(stored_), static_cast<QWidget*>(show_stored_), static_cast<QWidget*>(delete_stored_)})
    widget->setEnabled(!tables.empty());
}

void GeometryWindow::follow_scene() {
  if (scene::find_radar(session_.scene(), choice_.table.radar) == scene::not_found)
    choice_.table.radar = table_at_first(session_).radar;
  const std::size_t count = session_.scene().targets.size();
  if (!targets_typed_) {
    const std::size_t shown = std::min(count, targets_at_first);
    choice_.targets.resize(shown);
    for (std::size_t i = 0; i < shown; ++i) choice_.targets[i] = i;
    targets_->setText(shown == 0 ? QString() : QStringLiteral("1-%1").arg(shown));
    targets_->setModified(false);
  }
  std::erase_if(choice_.targets, [&](std::size_t target) { return target >= count; });
  show_fields();
  refresh_stored();
  stale_ = true;
  if (isVisible()) debounce_.start();
}

void GeometryWindow::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (stale_) compute();
}

void GeometryWindow::compute() {
  debounce_.stop();
  stale_ = false;
  state_->setText(tr("Calculating …"));
  problems_->clear();
  model_->set_table(session_.scene(), choice_);
}

void GeometryWindow::show_ready() {
  const std::int64_t pulses = model_->pulses().count();
  save_->setEnabled(!job_.running());
  state_->setText(pulses == 0 ? tr("No pulse is sent in this window") : tr("%1 pulses").arg(pulses));
  if (pulses > model_->rowCount())
    problems_->show_texts(core::Severity::note,
                          {tr("The first %1 pulses are shown; a saved file holds all.").arg(model_->rowCount())});
  const std::size_t hidden = session_.scene().targets.size() - choice_.targets.size();
  if (hidden > 0 && pulses > 0) state_->setText(state_->text() + tr(", %1 targets not shown").arg(hidden));
}

void GeometryWindow::go_to_pulse() {
  bool understood = false;
  const qint64 pulse = pulse_->text().toLongLong(&understood);
  if (!understood || model_->rowCount() == 0) return;
  const std::int64_t first = model_->pulses().first;
  view_->scroll_to(static_cast<int>(std::clamp<std::int64_t>(pulse, first, first + model_->rowCount() - 1) - first));
}

void GeometryWindow::show_stored() {
  const auto row = static_cast<std::size_t>(std::max(0, stored_->currentIndex()));
  const std::vector<scene::GeometryTable>& tables = session_.scene().geometries;
  if (row < tables.size()) show_table(tables[row]);
}

void GeometryWindow::delete_stored() {
  const scene::ObjectId id{scene::ObjectKind::geometry, static_cast<std::size_t>(std::max(0, stored_->currentIndex()))};
  if (!scene::has_object(session_.scene(), id)) return;
  session_.end_run();
  session_.perform(scene::remove_objects(session_.scene(), {id}));
}

void GeometryWindow::to_script() {
  session_.end_run();
  session_.perform(scene::add_object(session_.scene(), choice_.table));
  stored_->setCurrentIndex(stored_->count() - 1);
}

void GeometryWindow::save_as() {
  const QString text = tr("Text table (*.txt)");
  const QString csv = tr("CSV, all columns and targets (*.csv)");
  const std::filesystem::path folder = session_.document().path().parent_path();
  const std::filesystem::path name = folder / std::filesystem::path(choice_.table.file).filename();
  QString filter = text;
  const QString chosen = QFileDialog::getSaveFileName(
      this, tr("Save geometry table"), QString::fromStdString(name.string()), text + ";;" + csv, &filter);
  if (chosen.isEmpty()) return;
  save_to(chosen.toStdString(), filter == csv || chosen.endsWith(QStringLiteral(".csv"), Qt::CaseInsensitive));
}

void GeometryWindow::save_to(const std::filesystem::path& path, bool csv) {
  if (job_.running()) return;
  saving_to_ = path;
  save_->setEnabled(false);
  bar_->setValue(0);
  bar_->setVisible(true);
  cancel_->setVisible(true);
  problems_->clear();
  state_->setText(tr("Saving …"));
  const auto lines = static_cast<double>(std::max<std::int64_t>(1, model_->pulses().count()));
  job_.start([scene = session_.scene(), table = choice_.table, path, csv, lines](const core::StopFlag& stop,
                                                                                 const BackgroundJob::Report& report) {
    for (const core::Problem& error : geometry_errors(scene, table))
      throw std::runtime_error(problem_text(error).toStdString());
    core::OutputFile file(path, true);
    double written = 0.0;
    const auto write = [&](std::string_view piece) {
      if (stop.requested()) throw core::Interrupted();
      file.write(std::as_bytes(std::span(piece)));
      written += static_cast<double>(std::ranges::count(piece, '\n'));
      report(std::min(1.0, written / lines));
    };
    csv ? simulate::write_geometry_csv(scene, table, write, &stop)
        : simulate::write_geometry_text(scene, table, write, &stop);
    file.commit();
  });
}

void GeometryWindow::show_saved(JobEnd end, const QString& failure) {
  save_->setEnabled(true);
  bar_->setVisible(false);
  cancel_->setVisible(false);
  const QString name = QString::fromStdString(saving_to_.string());
  if (end == JobEnd::done) state_->setText(tr("Saved %1").arg(name));
  if (end == JobEnd::cancelled) state_->setText(tr("Saving was cancelled; no file was written"));
  if (end == JobEnd::failed) {
    state_->clear();
    problems_->show_texts(core::Severity::error, {failure});
  }
  emit saved(end);
}

}  // namespace sarsim::gui
