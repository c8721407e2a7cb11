#include <QAction>
#include <QButtonGroup>
#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QGridLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QScreen>
#include <QScrollArea>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/common/field_editor.hpp"
#include "gui/common/help_button.hpp"
#include "gui/common/problem_line.hpp"
#include "gui/objects/function_editor.hpp"
#include "gui/objects/function_plot.hpp"
#include "gui/objects/function_table.hpp"

namespace sarsim::gui {

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
