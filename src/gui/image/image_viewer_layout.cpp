// The widgets of an image viewer.

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/common/figure_plot.hpp"
#include "gui/common/problem_line.hpp"
#include "gui/common/reserved_label.hpp"
#include "gui/image/image_controls.hpp"
#include "gui/image/image_thumbnail.hpp"
#include "gui/image/image_viewer.hpp"
#include "gui/image/target_list.hpp"

namespace sarsim::gui {

namespace {

QLabel* label(QWidget* parent, const char* name) {
  auto* const made = new QLabel(parent);
  made->setObjectName(name);
  made->setTextInteractionFlags(Qt::TextSelectableByMouse);
  made->setTextFormat(Qt::PlainText);
  made->setWordWrap(true);
  return made;
}

FigurePlot* figure_plot(QWidget* parent, const char* name, const QString& spoken) {
  auto* const plot = new FigurePlot(parent);
  plot->setObjectName(name);
  plot->setAccessibleName(spoken);
  plot->setMinimumHeight(180);
  plot->hide();
  return plot;
}

}  // namespace

ImageViewer::ImageViewer(QWidget* parent) : QWidget(parent) {
  setObjectName("image_viewer");
  setWindowTitle(tr("Simulation output"));
  plot_ = new ImagePlot(this);
  row_cut_ = figure_plot(this, "image_row_cut", tr("Cut along the row"));
  column_cut_ = figure_plot(this, "image_column_cut", tr("Cut along the column"));
  histogram_ = figure_plot(this, "image_histogram", tr("Histogram"));
  problems_ = new ProblemLine(this);
  problems_->setObjectName("image_problems");
  auto* const right = new QWidget(this);
  auto* const column = new QVBoxLayout(right);
  column->setContentsMargins(0, 0, 0, 0);
  auto* const pictures = new QSplitter(Qt::Vertical, right);
  auto* const below = new QSplitter(Qt::Horizontal, pictures);
  for (FigurePlot* plot : {row_cut_, column_cut_, histogram_}) below->addWidget(plot);
  targets_ = new TargetList(pictures);
  targets_->hide();
  pictures->addWidget(plot_);
  pictures->addWidget(below);
  pictures->addWidget(targets_);
  pictures->setStretchFactor(0, 5);
  pictures->setStretchFactor(1, 3);
  column->addWidget(make_tool_row());
  column->addWidget(problems_);
  column->addWidget(pictures, 1);
  column->addWidget(make_foot());
  auto* const split = new QSplitter(this);
  split->addWidget(make_left());
  split->addWidget(right);
  split->setStretchFactor(1, 1);
  auto* const layout = new QVBoxLayout(this);
  layout->addWidget(split);
  connect_all();
  show_info();
}

QWidget* ImageViewer::make_left() {
  auto* const left = new QWidget(this);
  auto* const column = new QVBoxLayout(left);
  info_ = label(left, "image_info");
  thumbnail_ = new ImageThumbnail(left);
  controls_ = new ImageControls(left);
  follow_file_ = new QCheckBox(tr("Follow a growing file"), left);
  follow_file_->setObjectName("image_follow");
  follow_file_->setChecked(true);
  follow_file_->setToolTip(tr("Look twice a second whether another program has written more"));
  describe_ = new QPushButton(tr("Describe the File..."), left);
  describe_->setObjectName("image_describe");
  describe_->setToolTip(tr("Say how the file is stored, with a preview"));
  describe_->setAutoDefault(false);
  for (QWidget* widget :
       {static_cast<QWidget*>(info_), static_cast<QWidget*>(describe_), static_cast<QWidget*>(thumbnail_),
        static_cast<QWidget*>(controls_), static_cast<QWidget*>(follow_file_)})
    column->addWidget(widget);
  column->addStretch(1);
  auto* const area = new QScrollArea(this);
  area->setWidgetResizable(true);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setFrameShape(QFrame::NoFrame);
  area->setFocusPolicy(Qt::NoFocus);
  area->setObjectName("image_controls_area");
  area->setWidget(left);
  area->setMinimumWidth(left->sizeHint().width() + area->verticalScrollBar()->sizeHint().width());
  return area;
}

QToolButton* ImageViewer::add_tool(QHBoxLayout* row, const QString& text, const char* name, const QString& tip) {
  auto* const button = new QToolButton(this);
  button->setText(text);
  button->setObjectName(name);
  button->setToolTip(tip);
  button->setAccessibleName(tip);
  button->setToolButtonStyle(Qt::ToolButtonTextOnly);
  row->addWidget(button);
  return button;
}

QPushButton* ImageViewer::add_button(QHBoxLayout* row, const QString& text, const char* name, const QString& tip) {
  auto* const button = new QPushButton(text, this);
  button->setObjectName(name);
  button->setToolTip(tip);
  button->setAccessibleName(tip);
  button->setAutoDefault(false);
  row->addWidget(button);
  return button;
}

QWidget* ImageViewer::make_tool_row() {
  auto* const row = new QWidget(this);
  auto* const layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  back_ = add_tool(layout, tr("Back"), "image_back", tr("The view before (Backspace)"));
  forward_ = add_tool(layout, tr("Forward"), "image_forward", tr("The view that was left by going back"));
  for (QToolButton* button : {back_, forward_}) button->setEnabled(false);
  connect(add_tool(layout, tr("Full Image"), "image_whole", tr("Show everything (Home)")), &QToolButton::clicked, this,
          &ImageViewer::show_whole);
  connect(add_tool(layout, tr("Refresh"), "image_refresh", tr("Open the file anew, as it is now")),
          &QToolButton::clicked, this, &ImageViewer::refresh);
  show_cuts_ =
      add_tool(layout, tr("Cuts"), "image_show_cuts", tr("Graphs along samples and rows through the first cursor"));
  show_statistics_ = add_tool(layout, tr("Statistics"), "image_show_statistics",
                              tr("Figures and histogram of the selection (Shift and drag), or of what is seen"));
  reading_tool_ = add_tool(layout, tr("Read Point"), "image_reading_tool",
                           tr("Then click on a point target: resolution and sidelobes of its response"));
  show_targets_ = add_tool(layout, tr("Targets"), "image_show_targets",
                           tr("The targets of the scene as rings, with a table of their offsets, widths, sidelobes and "
                              "SNR; of images that sarsim focused"));
  keep_ = add_tool(layout, tr("Keep"), "image_keep",
                   tr("Keep this image when a newer one of its kind is made, which then has a viewer of its own"));
  for (QToolButton* button : {show_cuts_, show_statistics_, reading_tool_, show_targets_, keep_})
    button->setCheckable(true);
  layout->addStretch(1);
  state_ = label(row, "image_state");
  state_->setWordWrap(false);
  layout->addWidget(state_);
  return row;
}

QWidget* ImageViewer::make_foot() {
  auto* const foot = new QWidget(this);
  auto* const layout = new QVBoxLayout(foot);
  layout->setContentsMargins(0, 0, 0, 0);
  const auto reserved = [&](const char* name, int lines) {
    auto* const made = new ReservedLabel(lines, foot);
    made->setObjectName(name);
    layout->addWidget(made);
    return made;
  };
  read_out_ = reserved("image_read_out", 2);
  difference_ = reserved("image_difference", 1);
  figures_ = reserved("image_statistics", 2);
  point_ = reserved("image_reading", 4);
  for (QLabel* line : {figures_, point_}) line->hide();
  auto* const row = new QHBoxLayout;
  row->addStretch(1);
  connect(add_button(row, tr("Copy Picture"), "image_copy_picture", tr("The picture to the clipboard")),
          &QPushButton::clicked, this, &ImageViewer::copy_picture);
  connect(
      add_button(row, tr("Save Picture..."), "image_save_picture", tr("The picture with its axes as PNG, SVG or PDF")),
      &QPushButton::clicked, this, &ImageViewer::save_picture);
  export_ = add_button(row, tr("Export Samples..."), "image_export",
                       tr("The selected samples, or those in view, to a file of any format"));
  layout->addLayout(row);
  return foot;
}

void ImageViewer::connect_all() {
  for (QTimer* timer : {&debounce_, &measure_soon_}) timer->setSingleShot(true);
  connect(&debounce_, &QTimer::timeout, this, &ImageViewer::read_part);
  connect(&measure_soon_, &QTimer::timeout, this, &ImageViewer::measure);
  connect(&watch_, &QTimer::timeout, this, &ImageViewer::look_at_file);
  connect(&overview_timer_, &QTimer::timeout, this, &ImageViewer::show_overview);
  connect(&reader_, &ImageReader::ready, this, &ImageViewer::take_part);
  connect(&reader_, &ImageReader::failed, this, [this](const QString& words) {
    read_failure_ = words;
    show_problems();
  });
  connect(back_, &QToolButton::clicked, this, &ImageViewer::go_back);
  connect(forward_, &QToolButton::clicked, this, &ImageViewer::go_forward);
  connect(show_cuts_, &QToolButton::toggled, this, &ImageViewer::show_cuts);
  for (FigurePlot* cut : {row_cut_, column_cut_}) {
    cut->setToolTip(tr("Click or drag to move the first cursor along the line"));
    connect(cut, &FigurePlot::pressed_at, this, [this, cut](std::size_t, double x, double) { press_cut(cut, x); });
  }
  connect(show_targets_, &QToolButton::toggled, this, &ImageViewer::show_targets);
  connect(targets_, &TargetList::measured, this, &ImageViewer::show_rings);
  connect(targets_, &TargetList::target_chosen, this, &ImageViewer::frame_target);
  connect(plot_, &ImagePlot::ring_clicked, this,
          [this](std::size_t ring) { targets_->choose(rows_of_rings_.at(ring)); });
  connect(show_statistics_, &QToolButton::toggled, this, [this] {
    show_statistics();
    measure_soon();
  });
  connect(reading_tool_, &QToolButton::toggled, plot_, &ImagePlot::set_reading_tool);
  connect(reading_tool_, &QToolButton::toggled, this, [this](bool on) { point_->setVisible(on || reading_); });
  connect(describe_, &QPushButton::clicked, this, &ImageViewer::describe_wanted);
  connect(export_, &QPushButton::clicked, this, &ImageViewer::export_chosen);
  connect(controls_, &ImageControls::edited, this, &ImageViewer::set_look);
  connect(controls_, &ImageControls::view_typed, this, [this](const ImageView& view) {
    go_to(view);
    controls_->show_view(plot_->view(), plot_->shown_places());  // Also where it cannot be as it was typed.
  });
  connect(controls_, &ImageControls::link_changed, this,
          [this] { emit view_changed(plot_->view(), controls_->link()); });
  const auto about = [this](double column, double row) -> ImageView {
    const ImageView& v = plot_->view();
    return {column - v.columns() / 2.0, column + v.columns() / 2.0, row - v.rows() / 2.0, row + v.rows() / 2.0};
  };
  connect(thumbnail_, &ImageThumbnail::centre_wanted, this,
          [this, about](double column, double row) { go_to(about(column, row)); });
  connect(thumbnail_, &ImageThumbnail::centre_dragged, this,
          [this, about](double column, double row) { change_view(about(column, row)); });
  connect(plot_, &ImagePlot::view_wanted, this, &ImageViewer::go_to);
  connect(plot_, &ImagePlot::drag_began, this, [this] { history_.leave(plot_->view()); });
  connect(plot_, &ImagePlot::view_dragged, this, [this](const ImageView& view) { change_view(view); });
  connect(plot_, &ImagePlot::back_wanted, this, &ImageViewer::go_back);
  connect(plot_, &ImagePlot::whole_wanted, this, &ImageViewer::show_whole);
  connect(plot_, &ImagePlot::resized, this, [this] {
    if (source_)
      change_view(wanted_view_, false);
    else
      read_soon();
  });
  connect(plot_, &ImagePlot::hovered, this, &ImageViewer::show_read_out);
  connect(plot_, &ImagePlot::cursors_changed, this, [this] {
    show_read_out();
    show_cuts();
  });
  connect(plot_, &ImagePlot::selection_changed, this, [this] {
    if (plot_->selection()) show_statistics_->setChecked(true);
    measure_soon();
  });
  connect(plot_, &ImagePlot::reading_wanted, this, &ImageViewer::read_point_at);
}

}  // namespace sarsim::gui
