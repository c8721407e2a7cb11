#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "gui/common/background_job.hpp"
#include "gui/common/session.hpp"
#include "picture/live/live_image.hpp"
#include "picture/live/live_picture.hpp"

class QAction;
class QBoxLayout;
class QCheckBox;
class QComboBox;
class QGridLayout;
class QProgressBar;
class QSpinBox;
class QTemporaryDir;
class QToolButton;

namespace sarsim::gui {

class FigurePlot;
class ImageViewers;
class ReservedLabel;

/// The image of the scene as it is now: focused image, range-Doppler map, range profiles, image of a turning target or
/// search picture, computed again whenever the scene or a choice changes. One image can be kept, to compare with what
/// comes after it.
class LivePanel : public QWidget {
  Q_OBJECT

 public:
  /// How the image that was kept and the present one are shown.
  enum class Compare {
    off,           ///< The present one alone.
    side_by_side,  ///< In a narrow panel one below the other.
    blink,         ///< In turn, half a second each.
    difference,    ///< In decibels.
  };

  /// @param viewers  open what is made at full resolution; must live longer
  LivePanel(Session& session, ImageViewers& viewers, QWidget* parent = nullptr);
  ~LivePanel() override;

  /// The present image; null while there is none.
  [[nodiscard]] const std::shared_ptr<const picture::LiveImage>& image() const { return image_; }
  /// The image that was kept; null: none.
  [[nodiscard]] const std::shared_ptr<const picture::LiveImage>& kept() const { return kept_; }
  /// Whether the image, or why there is none, is that of the scene as it is.
  [[nodiscard]] bool complete() const { return complete_; }
  [[nodiscard]] FigurePlot& plot() { return *plot_; }
  /// What is wanted: scene, recording, choices and pixels.
  [[nodiscard]] picture::LiveRequest request() const;
  /// The command that makes the same from a terminal.
  [[nodiscard]] QString command() const;

 public slots:
  /// Keeps the present image as that before.
  void keep();
  /// Compares the image that was kept with the present one.
  void compare(sarsim::gui::LivePanel::Compare how);
  /// Asks for a name and writes what is seen.
  void save_picture();
  /// Puts what is seen onto the clipboard.
  void copy_picture();
  /// Puts the command onto the clipboard.
  void copy_command();
  /// Makes the image with all its samples and opens it in the image viewer.
  void open_in_viewer();

 signals:
  void finished();  ///< The image, or why there is none, is shown.
  void opened();    ///< The image viewer has the image, or it is said why not.

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void take_kept();
  void make_choices();
  void make_options();
  void make_pictures();
  void make_foot();
  void show_simulations();
  void show_choices();
  void compute_soon();
  void compute();
  void take_event(const picture::LiveEvent& event);
  void show_event();
  void show_image();
  void show_state();
  void show_problems(const core::Problems& problems);
  [[nodiscard]] Compare comparing() const;
  [[nodiscard]] picture::LiveLook look() const;
  void take_end(JobEnd end, const QString& failure);

  Session& session_;
  ImageViewers& viewers_;
  QComboBox* product_ = nullptr;
  QComboBox* simulation_ = nullptr;
  QToolButton* more_ = nullptr;
  QWidget* options_ = nullptr;
  QComboBox* algorithm_ = nullptr;
  QComboBox* window_ = nullptr;
  QCheckBox* compensation_ = nullptr;
  QCheckBox* targets_ = nullptr;
  QCheckBox* autofocus_ = nullptr;
  QComboBox* colours_ = nullptr;
  QSpinBox* span_ = nullptr;
  QBoxLayout* pictures_ = nullptr;
  FigurePlot* before_ = nullptr;
  FigurePlot* plot_ = nullptr;
  ReservedLabel* problems_ = nullptr;
  QToolButton* keep_ = nullptr;
  QComboBox* compare_ = nullptr;
  ReservedLabel* state_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QAction* open_ = nullptr;
  QTimer debounce_;
  QTimer blink_;
  bool before_is_seen_ = false;  // while blinking
  bool complete_ = false;
  std::shared_ptr<const picture::LiveImage> image_;
  std::vector<picture::LiveImage::TargetPlace> rings_;                // of the last whole image
  std::shared_ptr<const picture::LiveImage> kept_;                    // of the scene at hand
  std::map<int, std::shared_ptr<const picture::LiveImage>> kept_of_;  // by the number of the document
  std::shared_ptr<QTemporaryDir> folder_;                             // of what is made for a viewer
  QString made_file_;
  std::mutex lock_;                           // of `latest_`
  std::optional<picture::LiveEvent> latest_;  // from the thread that computes
  std::uint64_t request_ = 0;
  bool nothing_yet_ = false;  // has come of the request
  QElapsedTimer asked_;
  std::unique_ptr<picture::LivePicture> picture_;
  BackgroundJob job_;  // Last: ends before what it uses.
};

}  // namespace sarsim::gui
