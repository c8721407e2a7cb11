#pragma once

#include <QCoreApplication>

class QCheckBox;
class QLabel;
class QPushButton;
class QToolButton;
class QWidget;

namespace sarsim::gui {

class FigurePlot;
class ImageControls;
class ImagePlot;
class ImageThumbnail;
class ProblemLine;
class ReservedLabel;
class TargetList;

/// The widgets of an image viewer, all below it: at the left what the image is and how it is shown, at the right tools,
/// the picture with its cuts and targets, and what is said of it.
struct ImageFrame {
  /// Makes them and lays them out.
  explicit ImageFrame(QWidget& viewer);

  ImageControls* controls = nullptr;
  ImageThumbnail* thumbnail = nullptr;
  ImagePlot* plot = nullptr;
  FigurePlot* row_cut = nullptr;
  FigurePlot* column_cut = nullptr;
  FigurePlot* histogram = nullptr;
  TargetList* targets = nullptr;
  ProblemLine* problems = nullptr;
  QLabel* info = nullptr;
  ReservedLabel* read_out = nullptr;
  ReservedLabel* difference = nullptr;
  ReservedLabel* figures = nullptr;
  ReservedLabel* point = nullptr;
  QLabel* state = nullptr;
  QToolButton* back = nullptr;
  QToolButton* forward = nullptr;
  QToolButton* whole = nullptr;
  QToolButton* refresh = nullptr;
  QToolButton* show_cuts = nullptr;
  QToolButton* show_statistics = nullptr;
  QToolButton* show_targets = nullptr;
  QToolButton* reading_tool = nullptr;
  QToolButton* keep = nullptr;
  QCheckBox* follow_file = nullptr;
  QPushButton* copy_picture = nullptr;
  QPushButton* save_picture = nullptr;
  QPushButton* export_samples = nullptr;
  QPushButton* describe = nullptr;

 private:
  Q_DECLARE_TR_FUNCTIONS(ImageFrame)

  [[nodiscard]] QWidget* make_left(QWidget& viewer);
  [[nodiscard]] QWidget* make_tool_row(QWidget& viewer);
  [[nodiscard]] QWidget* make_foot(QWidget& viewer);
};

}  // namespace sarsim::gui
