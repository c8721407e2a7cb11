#pragma once

#include <QPointer>
#include <QWidget>

#include <map>
#include <memory>
#include <string>
#include <utility>

#include "gui/common/session.hpp"
#include "gui/runs/product_job.hpp"
#include "workflow/options/option.hpp"

class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QTemporaryDir;

namespace sarsim::gui {

class ImageViewer;
class ImageViewers;
class ProblemLine;
class ReportView;
class ReservedLabel;
struct ProductKind;

/// Makes images and profiles from the echoes of the scene (focused image, range profiles, turning target, range-Doppler
/// maps, PPI), opens them in the image viewer and shows the report as tables and figures. The command that does the
/// same from a terminal is shown, so that it can be repeated without a window. Closed, the window stops its work.
class ProductWindow : public QWidget {
  Q_OBJECT

 public:
  /// @param viewers  open what was made; must live longer
  ProductWindow(Session& session, ImageViewers& viewers, QWidget* owner);
  ~ProductWindow() override;

  [[nodiscard]] bool busy() const { return job_.running(); }
  /// The command as a user would type it.
  [[nodiscard]] QString command() const;
  /// Begins; the scene is taken as it is now.
  void make();
  /// Ends the work, which leaves nothing behind; `ended` follows.
  void stop();

 signals:
  /// @param made  false where it failed or was stopped
  void ended(bool made);

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  void make_controls(QFormLayout* form);
  void make_foot();
  void connect_all();
  void choose_suitable();
  void show_simulations();
  void show_choices();
  void show_command();
  [[nodiscard]] const ProductKind& kind() const;
  [[nodiscard]] QStringList chosen_words() const;
  [[nodiscard]] workflow::GivenWords given_words() const;
  [[nodiscard]] std::string write_scene();
  [[nodiscard]] QString within_folder(const QString& words) const;
  [[nodiscard]] QStringList texts_of(const core::Problems& problems) const;
  void show_progress(const QString& stage, double fraction, double seconds_left);
  void take_end(JobEnd end, const QString& failure);
  void show_result();
  void open_images(const std::vector<std::filesystem::path>& images);
  [[nodiscard]] ImageViewer* viewer_for(std::size_t number);
  [[nodiscard]] QString name_of_image() const;
  void forget_result();
  void fail(const QStringList& words);
  void end_with(const QString& state, bool made);

  Session& session_;
  ImageViewers& viewers_;
  std::shared_ptr<QTemporaryDir> folder_;  // of the scene and its product, as long as a viewer looks at it
  QString script_;                         // the scene's file in it
  QString title_;                          // of what is made
  // The viewers of the newest images, by command and number, and the folders of what viewers look at.
  std::map<std::pair<std::string, std::size_t>, QPointer<ImageViewer>> shown_;
  std::map<const QObject*, std::shared_ptr<QTemporaryDir>> files_of_;
  bool lines_are_known_ = false;  // its lines are those of the script that is edited
  bool stopped_ = false;
  QComboBox* product_ = nullptr;
  QComboBox* simulation_ = nullptr;
  QLabel* choice_title_ = nullptr;
  QComboBox* choice_ = nullptr;
  QComboBox* weighting_ = nullptr;
  QLineEdit* more_ = nullptr;
  QLineEdit* command_ = nullptr;
  ReservedLabel* state_ = nullptr;
  QProgressBar* bar_ = nullptr;
  ReportView* report_ = nullptr;
  ProblemLine* problems_ = nullptr;
  ProblemLine* remarks_ = nullptr;
  QPushButton* make_ = nullptr;
  QPushButton* stop_ = nullptr;
  ProductJob job_;  // Last: stops before anything that it works on goes.
};

}  // namespace sarsim::gui
