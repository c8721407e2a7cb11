#pragma once

#include <QTimer>
#include <QWidget>

#include <filesystem>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/os/file_identity.hpp"
#include "gui/common/background_job.hpp"
#include "gui/image/image_frame.hpp"
#include "gui/image/image_part.hpp"
#include "gui/image/image_plot.hpp"
#include "gui/image/image_reader.hpp"
#include "gui/image/image_words.hpp"
#include "picture/echo/echo_window.hpp"
#include "picture/echo/view_history.hpp"
#include "picture/figure/figure.hpp"
#include "picture/image/overview.hpp"
#include "picture/image/point_reading.hpp"
#include "picture/image/selection_statistics.hpp"
#include "raster/format/open_raster.hpp"

namespace sarsim::gui {

class FigurePlot;
class ImageControls;
class TargetList;

/// Looks into a file of samples of any size: only what is seen is read. What is wrong with the file is told in the
/// window, which stays.
class ImageViewer : public QWidget {
  Q_OBJECT

 public:
  explicit ImageViewer(QWidget* parent = nullptr);
  ~ImageViewer() override;

  /// Opens a file in the background; `opened` or `open_failed` follows.
  void open(const std::filesystem::path& path, const raster::RasterHints& hints = {});
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// What the title calls the image instead of its file; empty: the file.
  void set_name(const QString& name);
  /// Whether the user wants to keep this image: a newer one of its kind goes to another viewer.
  [[nodiscard]] bool kept() const;
  [[nodiscard]] const raster::RasterHints& hints() const { return hints_; }
  [[nodiscard]] const std::shared_ptr<raster::Raster>& source() const { return source_; }
  [[nodiscard]] ImagePlot& plot() { return *frame_.plot; }
  [[nodiscard]] ImageControls& controls() { return *frame_.controls; }
  [[nodiscard]] TargetList& targets() { return *frame_.targets; }
  [[nodiscard]] const PartLook& look() const { return look_; }
  /// Whether all samples of the present view are shown.
  [[nodiscard]] bool complete() const { return complete_; }
  /// The selection, or all that is seen.
  [[nodiscard]] raster::ImageWindow chosen() const;
  [[nodiscard]] const std::optional<picture::SelectionStatistics>& statistics() const { return statistics_; }
  [[nodiscard]] const std::optional<picture::PointReading>& reading() const { return reading_; }
  /// What is seen, with axes, to be written to a file.
  [[nodiscard]] picture::Figure figure() const;
  /// Whether samples are being written to a file.
  [[nodiscard]] bool exporting() const { return exporting_.running(); }
  /// What is wrong, as the window says it; empty where nothing is.
  [[nodiscard]] QString problem_words() const;

 public slots:
  /// Draws what is seen in another way.
  void set_look(const sarsim::gui::PartLook& look);
  /// Another view; the present one is kept to go back to.
  void go_to(const sarsim::gui::ImageView& view);
  /// The view that was left last.
  void go_back();
  /// The view that was left by going back.
  void go_forward();
  /// The whole image.
  void show_whole();
  /// Follows another viewer along the axes that both have linked.
  void follow(const sarsim::gui::ImageView& view, sarsim::picture::AxisLink link);
  /// Opens the file anew, as it is now.
  void refresh();
  /// Measures the response of the point next to a sample.
  void read_point_at(std::size_t row, std::size_t column);
  /// Puts the picture onto the clipboard, without axes.
  void copy_picture();
  /// Asks for a name and writes the picture with its axes.
  void save_picture();
  /// Asks for a name and a format, and whether an existing file may be replaced.
  void export_chosen();
  void cancel_export() { exporting_.cancel(); }
  /// Writes what is chosen in the background; `exported` follows. An existing file is replaced.
  void export_to(const QString& path, sarsim::scene::FileFormat format);

 signals:
  void opened();       ///< The file can be read; an image of rows that are still looked for grows.
  void open_failed();  ///< The window says why.
  /// With the axes along which others may follow.
  void view_changed(const sarsim::gui::ImageView& view, sarsim::picture::AxisLink link);
  void describe_wanted();    ///< The user wants to say how the file is stored.
  void exported(bool good);  ///< The copy is written, or the window says why not.
  void shown();              ///< All samples of the view are shown.

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void connect_all();
  void take_source(raster::OpenedRaster& result);
  void take_places();
  void show_title();
  void forget_readings();
  void begin_overview();
  void look_at_file();
  void take_rows(std::size_t rows);
  /// @param tell  other viewers, by `view_changed`
  void change_view(const ImageView& view, bool tell = true);
  void read_soon();
  void read_part();
  void take_part(const PartResult& result);
  void show_overview();
  void show_info();
  void show_problems();
  void show_read_out();
  void show_cuts();
  void press_cut(const FigurePlot* cut, double place);
  void show_targets(bool on);
  void show_rings();
  void frame_target(std::size_t row);
  void measure_soon();
  void measure();
  void show_statistics();
  void show_reading(const QString& failure);
  [[nodiscard]] ImageWords words() const;

  std::filesystem::path path_;
  QString name_;
  QString algorithm_;
  bool envi_ = false;
  raster::RasterHints hints_;
  std::shared_ptr<raster::Raster> source_;
  core::Problems open_problems_;
  QString read_failure_;
  std::optional<raster::RasterAxes> axes_;
  std::size_t rows_ = 0;
  std::uintmax_t file_bytes_ = 0;
  std::filesystem::file_time_type file_time_;
  std::optional<core::FileIdentity> file_number_;  // of what is open
  PartLook look_;
  ImageView wanted_view_;  // as asked for; equal scales may show more
  bool look_set_ = false;
  picture::ViewHistory<ImageView> history_;
  std::uint64_t request_ = 0;
  bool complete_ = false;
  std::shared_ptr<picture::Overview> overview_;
  std::size_t overview_rows_ = 0;
  bool overview_shown_ = false;
  std::optional<picture::SelectionStatistics> statistics_;
  std::optional<picture::PointReading> reading_;

  ImageFrame frame_;
  std::vector<std::size_t> rows_of_rings_;
  QTimer debounce_;
  QTimer watch_;
  QTimer overview_timer_;
  QTimer measure_soon_;
  ImageReader reader_;
  BackgroundJob opening_;
  bool open_again_ = false;
  BackgroundJob measuring_;
  bool measure_again_ = false;
  BackgroundJob pointing_;
  BackgroundJob exporting_;
};

}  // namespace sarsim::gui
