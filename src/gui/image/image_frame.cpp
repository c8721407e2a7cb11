#include "gui/image/image_frame.hpp"

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
#include "gui/image/image_plot.hpp"
#include "gui/image/image_thumbnail.hpp"
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

QToolButton* add_tool(QWidget& viewer, QHBoxLayout* row, const QString& text, const char* name, const QString& tip) {
  auto* const button = new QToolButton(&viewer);
  button->setText(text);
  button->setObjectName(name);
  button->setToolTip(tip);
  button->setAccessibleName(tip);
  button->setToolButtonStyle(Qt::ToolButtonTextOnly);
  row->addWidget(button);
  return button;
}

QPushButton* add_button(QWidget& viewer, QHBoxLayout* row, const QString& text, const char* name, const QString& tip) {
  auto* const button = new QPushButton(text, &viewer);
  button->setObjectName(name);
  button->setToolTip(tip);
  button->setAccessibleName(tip);
  button->setAutoDefault(false);
  row->addWidget(button);
  return button;
}

}  // namespace

ImageFrame::ImageFrame(QWidget& viewer) {
  plot = new ImagePlot(&viewer);
  row_cut = figure_plot(&viewer, "image_row_cut", tr("Cut along the row"));
  column_cut = figure_plot(&viewer, "image_column_cut", tr("Cut along the column"));
  histogram = figure_plot(&viewer, "image_histogram", tr("Histogram"));
  problems = new ProblemLine(&viewer);
  problems->setObjectName("image_problems");
  auto* const right = new QWidget(&viewer);
  auto* const column = new QVBoxLayout(right);
  column->setContentsMargins(0, 0, 0, 0);
  auto* const pictures = new QSplitter(Qt::Vertical, right);
  auto* const below = new QSplitter(Qt::Horizontal, pictures);
  for (FigurePlot* shown : {row_cut, column_cut, histogram}) below->addWidget(shown);
  targets = new TargetList(pictures);
  targets->hide();
  pictures->addWidget(plot);
  pictures->addWidget(below);
  pictures->addWidget(targets);
  pictures->setStretchFactor(0, 5);
  pictures->setStretchFactor(1, 3);
  column->addWidget(make_tool_row(viewer));
  column->addWidget(problems);
  column->addWidget(pictures, 1);
  column->addWidget(make_foot(viewer));
  auto* const split = new QSplitter(&viewer);
  split->addWidget(make_left(viewer));
  split->addWidget(right);
  split->setStretchFactor(1, 1);
  auto* const layout = new QVBoxLayout(&viewer);
  layout->addWidget(split);
}

QWidget* ImageFrame::make_left(QWidget& viewer) {
  auto* const left = new QWidget(&viewer);
  auto* const column = new QVBoxLayout(left);
  info = label(left, "image_info");
  thumbnail = new ImageThumbnail(left);
  controls = new ImageControls(left);
  follow_file = new QCheckBox(tr("Follow a growing file"), left);
  follow_file->setObjectName("image_follow");
  follow_file->setChecked(true);
  follow_file->setToolTip(tr("Look twice a second whether another program has written more"));
  describe = new QPushButton(tr("Set File Layout..."), left);
  describe->setObjectName("image_describe");
  describe->setToolTip(tr("Set how the file is stored, with a preview"));
  describe->setAutoDefault(false);
  for (QWidget* widget :
       {static_cast<QWidget*>(info), static_cast<QWidget*>(describe), static_cast<QWidget*>(thumbnail),
        static_cast<QWidget*>(controls), static_cast<QWidget*>(follow_file)})
    column->addWidget(widget);
  column->addStretch(1);
  auto* const area = new QScrollArea(&viewer);
  area->setWidgetResizable(true);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setFrameShape(QFrame::NoFrame);
  area->setFocusPolicy(Qt::NoFocus);
  area->setObjectName("image_controls_area");
  area->setWidget(left);
  area->setMinimumWidth(left->sizeHint().width() + area->verticalScrollBar()->sizeHint().width());
  return area;
}

QWidget* ImageFrame::make_tool_row(QWidget& viewer) {
  auto* const row = new QWidget(&viewer);
  auto* const layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  back = add_tool(viewer, layout, tr("Back"), "image_back", tr("Previous View (Backspace)"));
  forward = add_tool(viewer, layout, tr("Forward"), "image_forward", tr("Next View (after going back)"));
  for (QToolButton* button : {back, forward}) button->setEnabled(false);
  whole = add_tool(viewer, layout, tr("Fit"), "image_whole", tr("Show everything (Home)"));
  refresh = add_tool(viewer, layout, tr("Refresh"), "image_refresh", tr("Open the file anew, as it is now"));
  show_cuts = add_tool(viewer, layout, tr("Cuts"), "image_show_cuts",
                       tr("Graphs along samples and rows through the first cursor"));
  show_statistics = add_tool(viewer, layout, tr("Statistics"), "image_show_statistics",
                             tr("Figures and histogram of the selection (Shift and drag), or of what is seen"));
  reading_tool = add_tool(viewer, layout, tr("Read Point"), "image_reading_tool",
                          tr("Then click on a point target: resolution and sidelobes of its response"));
  show_targets = add_tool(viewer, layout, tr("Targets"), "image_show_targets",
                          tr("Marks the scene's targets and lists their position errors, widths, sidelobes and SNR; "
                             "for images focused by Sarsim"));
  keep = add_tool(viewer, layout, tr("Keep"), "image_keep",
                  tr("Keep this image when a newer one of its kind is made, which then has a viewer of its own"));
  for (QToolButton* button : {show_cuts, show_statistics, reading_tool, show_targets, keep}) button->setCheckable(true);
  layout->addStretch(1);
  state = label(row, "image_state");
  state->setWordWrap(false);
  layout->addWidget(state);
  return row;
}

QWidget* ImageFrame::make_foot(QWidget& viewer) {
  auto* const foot = new QWidget(&viewer);
  auto* const layout = new QVBoxLayout(foot);
  layout->setContentsMargins(0, 0, 0, 0);
  const auto reserved = [&](const char* name, int lines) {
    auto* const made = new ReservedLabel(lines, foot);
    made->setObjectName(name);
    layout->addWidget(made);
    return made;
  };
  read_out = reserved("image_read_out", 2);
  difference = reserved("image_difference", 1);
  figures = reserved("image_statistics", 2);
  point = reserved("image_reading", 4);
  for (QLabel* line : {figures, point}) line->hide();
  auto* const row = new QHBoxLayout;
  row->addStretch(1);
  copy_picture = add_button(viewer, row, tr("Copy Picture"), "image_copy_picture", tr("The picture to the clipboard"));
  save_picture = add_button(viewer, row, tr("Save Picture..."), "image_save_picture",
                            tr("The picture with its axes as PNG, SVG or PDF"));
  export_samples = add_button(viewer, row, tr("Export Samples..."), "image_export",
                              tr("The selected samples, or those in view, to a file of any format"));
  layout->addLayout(row);
  return foot;
}

}  // namespace sarsim::gui
